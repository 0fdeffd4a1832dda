//! Where a robot drives: it turns, follows the line to the next stop, and sees what is there.
//!
//! Explorers never see a world. [`Ideal`] is exact; a physical one with sensors and drift can take its place.

use core::fmt;

use crate::event::{Finish, Sighting};
use crate::geometry::{Heading, Point, Turn, Ways};
use crate::maze::{Kind, Maze, Start};

pub mod rover;

/// A place for a robot to drive in.
pub trait World {
    /// Turns, then drives to the next stop.
    ///
    /// # Errors
    /// Where there is no line in that direction; the robot then stays, turned.
    fn drive(&mut self, turn: Turn) -> Result<Sighting, NoLine>;
}

/// There is no line where the robot turned to.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct NoLine;

/// Why a line robot cannot be put down at the start of a maze.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum CannotStart {
    /// The maze has no start.
    NoStart,
    /// The start is not at the end of a line: it has this many ways.
    NotAtLineEnd {
        /// The start.
        at: Point,
        /// Its ways, other than one.
        ways: u32,
        /// How the maze is drawn.
        kind: Kind,
    },
    /// The start's only way does not lead where the bot faces.
    FacesAway {
        /// The start and how it faces.
        start: Start,
        /// Where its line leads.
        way: Heading,
    },
    /// The start is part of the finish.
    OnFinish {
        /// The start.
        at: Point,
    },
}

impl fmt::Display for CannotStart {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::NoStart => write!(f, "The maze has no start: put one at the end of a line."),
            Self::NotAtLineEnd { at, ways: 0, kind: Kind::Line } => {
                write!(f, "The start {at} is not on a line: put it at the end of one.")
            }
            Self::NotAtLineEnd { at, ways: 0, kind: Kind::Wall } => {
                write!(f, "The start {at} has walls all round: open one side of its square.")
            }
            Self::NotAtLineEnd { at, ways, kind } => write!(
                f,
                "The start {at} has {ways} ways: the bot could not know that it is back there. Put it {}, or choose \
                 another explorer.",
                match kind {
                    Kind::Line => "at the end of a line",
                    Kind::Wall => "into a square with one opening",
                }
            ),
            Self::FacesAway { start, way } => write!(
                f,
                "At the start {} the bot faces {}, but its only way leads {}: turn it.",
                start.at,
                start.heading.word(),
                way.word()
            ),
            Self::OnFinish { at } => write!(f, "The start {at} is the finish: move one of them."),
        }
    }
}

impl core::error::Error for CannotStart {}

/// The start of a maze, if a line robot that must know its way back can be put down there.
///
/// # Errors
/// Says what is wrong with the start.
pub fn line_start(maze: &Maze) -> Result<Start, CannotStart> {
    let start = maze.start().ok_or(CannotStart::NoStart)?;
    let ways = maze.ways(start.at);
    match ways.only() {
        None => Err(CannotStart::NotAtLineEnd { at: start.at, ways: ways.count(), kind: maze.kind }),
        Some(way) if way != start.heading => Err(CannotStart::FacesAway { start, way }),
        Some(_) if maze.is_finish(start.at) => Err(CannotStart::OnFinish { at: start.at }),
        Some(_) => Ok(start),
    }
}

/// The exact world: no drift, no missed line, every cell takes the same time.
#[derive(Clone, Debug)]
pub struct Ideal<'m> {
    maze: &'m Maze,
    at: Point,
    heading: Heading,
    cell_ms: u32,
}

impl<'m> Ideal<'m> {
    /// A robot at `start`, facing along its heading; a cell takes `cell_ms` milliseconds.
    #[must_use]
    pub const fn new(maze: &'m Maze, start: Start, cell_ms: u32) -> Self {
        Self { maze, at: start.at, heading: start.heading, cell_ms }
    }

    /// Where the robot stands.
    #[must_use]
    pub const fn at(&self) -> Point {
        self.at
    }

    /// Where it faces, in the drawing's frame.
    #[must_use]
    pub const fn heading(&self) -> Heading {
        self.heading
    }
}

impl World for Ideal<'_> {
    fn drive(&mut self, turn: Turn) -> Result<Sighting, NoLine> {
        self.heading = self.heading.turned(turn);
        if !self.maze.has_line(self.at, self.heading) {
            return Err(NoLine);
        }
        // Line ahead and behind and nothing else: drive on.
        let straight = Ways::NONE.with(self.heading).with(self.heading.opposite());
        let mut cells = 0;
        loop {
            self.at = self.at.step(self.heading);
            cells += 1;
            let ways = self.maze.ways(self.at);
            let finish = if self.maze.is_finish(self.at) { Finish::Yes } else { Finish::No };
            if ways != straight || finish == Finish::Yes {
                let ways = ways.in_frame_of(self.heading);
                return Ok(Sighting { ways, finish, time_diff: cells * self.cell_ms });
            }
        }
    }
}
