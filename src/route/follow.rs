//! Following a turn list: where it leads in a maze, and where it leaves the line.
//!
//! At a start with several ways the first letter says which, and coming over it again takes a letter too, as at a
//! node; with one way the robot turns along it by itself, as it does at corners. At a dead end that is not the
//! finish only `B` leads on.

use alloc::vec::Vec;
use core::fmt;

use super::{Corners, Leg, Route, TurnList};
use crate::geometry::{Heading, Point, Turn, Ways};
use crate::maze::{Maze, Start};
use crate::world::CannotStart;

/// Where a turn list led.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Followed {
    /// Every stop that was reached; the last one has no turn.
    pub route: Route,
    /// How it ended.
    pub end: End,
}

/// How following a turn list ended.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum End {
    /// At the finish, with so many letters left over.
    Finish {
        /// Letters that were not used.
        left_over: usize,
    },
    /// Elsewhere.
    Strayed(Strayed),
}

/// Why a turn list does not lead to the finish.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Strayed {
    /// The robot cannot start at all.
    CannotStart(CannotStart),
    /// No line leads away from the start.
    NoWay {
        /// The start.
        at: Point,
    },
    /// A turn where there is no line: which letter (from 1; 0 for a corner's) and where.
    NoLine {
        /// Which letter, from 1.
        letter: usize,
        /// Where.
        at: Point,
    },
    /// A dead end that is not the finish.
    DeadEnd {
        /// Where.
        at: Point,
    },
    /// A node after the last letter.
    ListTooShort {
        /// Where.
        at: Point,
    },
}

impl fmt::Display for Strayed {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::CannotStart(why) => why.fmt(f),
            Self::NoWay { at } => write!(f, "no line leads away from the start {at}"),
            Self::NoLine { letter: 0, at } => write!(f, "the turn list leads off the line at {at}"),
            Self::NoLine { letter, at } => {
                write!(f, "the turn list leads off the line after letter {letter}, at {at}")
            }
            Self::DeadEnd { at } => write!(f, "the turn list leads to the dead end {at}"),
            Self::ListTooShort { at } => write!(f, "the turn list has no letter for the node at {at}"),
        }
    }
}

impl core::error::Error for Strayed {}

/// Follows a list from a start as far as it leads.
///
/// ```
/// use line_maze_lab::maze::samples;
/// use line_maze_lab::route::follow::{End, Strayed, follow};
/// use line_maze_lab::route::Corners;
/// let maze = samples::figure_3_1();
/// let led = |letters: &str| {
///     let list = letters.parse().unwrap_or_default();
///     follow(&maze, maze.start().unwrap(), &list, Corners::LeftOut).end
/// };
/// assert_eq!(led("SSRLL"), End::Finish { left_over: 2 });
/// assert!(matches!(led("SS"), End::Strayed(Strayed::ListTooShort { .. })));
/// ```
#[must_use]
pub fn follow(maze: &Maze, start: Start, list: &TurnList, corners: Corners) -> Followed {
    let floor = Floor::new(maze, start.at);
    let mut robot = Robot { floor, at: start.at, heading: start.heading, list, used: 0, corners };
    let mut route =
        Route { start: start.at, start_turn: Turn::Straight, start_letter: None, legs: Vec::new() };
    if maze.is_finish(start.at) {
        return Followed { route, end: End::Finish { left_over: list.turns().len() } };
    }
    let end = match robot.leave_start() {
        Ok((turn, letter)) => {
            (route.start_turn, route.start_letter) = (turn, letter);
            robot.drive(&mut route.legs, turn)
        }
        Err(strayed) => End::Strayed(strayed),
    };
    Followed { route, end }
}

struct Robot<'m> {
    floor: Floor<'m>,
    at: Point,
    heading: Heading,
    list: &'m TurnList,
    /// Letters that are used up.
    used: usize,
    corners: Corners,
}

impl Robot<'_> {
    /// The next letter, and which one it is.
    fn letter(&mut self) -> Result<(Turn, Option<usize>), Strayed> {
        let turn = self.list.turns().get(self.used).copied();
        let turn = turn.ok_or(Strayed::ListTooShort { at: self.at })?;
        self.used += 1;
        Ok((turn, Some(self.used)))
    }

    /// A turn that the line leaves no choice about; it is in the list only where that has all stops.
    fn forced(&mut self, turn: Turn) -> Result<(Turn, Option<usize>), Strayed> {
        match self.corners {
            Corners::Listed if turn != Turn::Straight => self.letter(),
            Corners::Listed | Corners::LeftOut => Ok((turn, None)),
        }
    }

    fn leave_start(&mut self) -> Result<(Turn, Option<usize>), Strayed> {
        let ways = self.floor.maze.ways(self.at);
        match (ways, ways.only()) {
            (Ways::NONE, _) => Err(Strayed::NoWay { at: self.at }),
            (_, Some(way)) => self.forced(self.heading.turn_to(way)),
            (_, None) => self.letter(),
        }
    }

    /// What to do at a stop that is not the finish.
    fn turn(&mut self) -> Result<(Turn, Option<usize>), Strayed> {
        let onward = self.floor.maze.ways(self.at).without(self.heading.opposite());
        match (onward.count(), onward.only()) {
            _ if self.floor.is_choice(self.at) => self.letter(),
            (0, _) => match self.letter() {
                Ok(back @ (Turn::Back, _)) => Ok(back),
                _ => Err(Strayed::DeadEnd { at: self.at }),
            },
            (_, Some(way)) => self.forced(self.heading.turn_to(way)),
            (_, None) => self.letter(),
        }
    }

    fn drive(&mut self, legs: &mut Vec<Leg>, mut turn: Turn) -> End {
        loop {
            let heading = self.heading.turned(turn);
            let Some((at, cells)) = self.floor.to_stop(self.at, heading) else {
                return End::Strayed(Strayed::NoLine { letter: self.used, at: self.at });
            };
            (self.at, self.heading) = (at, heading);
            legs.push(Leg { at, heading, cells, turn: None, letter: None });
            if self.floor.maze.is_finish(at) {
                return End::Finish { left_over: self.list.turns().len() - self.used };
            }
            let letter;
            (turn, letter) = match self.turn() {
                Ok(next) => next,
                Err(strayed) => return End::Strayed(strayed),
            };
            if let Some(leg) = legs.last_mut() {
                (leg.turn, leg.letter) = (Some(turn), letter);
            }
        }
    }
}

/// A maze as a line robot that was put down at `start` finds it.
#[derive(Clone, Copy)]
pub(super) struct Floor<'m> {
    pub(super) maze: &'m Maze,
    start: Point,
}

impl<'m> Floor<'m> {
    pub(super) const fn new(maze: &'m Maze, start: Point) -> Self {
        Self { maze, start }
    }

    /// Whether there is something to decide: at nodes, and at a start with several ways.
    pub(super) fn is_choice(self, at: Point) -> bool {
        self.maze.ways(at).count() > if at == self.start { 1 } else { 2 }
    }

    /// Whether the robot stops here on its way straight on.
    pub(super) fn is_stop(self, at: Point, heading: Heading) -> bool {
        let straight = Ways::NONE.with(heading).with(heading.opposite());
        self.maze.ways(at) != straight || at == self.start || self.maze.is_finish(at)
    }

    /// Drives on to the next stop (node, corner, dead end, finish, or the start again) and counts the cells;
    /// none where there is no line.
    fn to_stop(self, from: Point, heading: Heading) -> Option<(Point, u32)> {
        if !self.maze.has_line(from, heading) {
            return None;
        }
        let mut at = from.step(heading);
        let mut cells = 1;
        while !self.is_stop(at, heading) {
            at = at.step(heading);
            cells += 1;
        }
        Some((at, cells))
    }
}
