//! The ideal world for every explorer but the book's: line robots stop at nodes, corners, dead ends, the
//! finish and the start; square robots stop at every lattice point, as in a walled maze of squares.

use super::NoLine;
use crate::event::{Finish, Home, Look, Sighting};
use crate::geometry::{Heading, Point, Turn, Ways};
use crate::maze::{Maze, Start};

/// Where a robot stops.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Halt {
    /// Where the line does anything but go straight on, at the finish, and at the start.
    Line,
    /// At every lattice point.
    Square,
}

/// A robot that drives without drift.
#[derive(Clone, Debug)]
pub struct Rover<'m> {
    maze: &'m Maze,
    start: Point,
    at: Point,
    heading: Heading,
    cell_ms: u32,
    halt: Halt,
}

impl<'m> Rover<'m> {
    /// A robot at `start`, facing along its heading; a cell takes `cell_ms` milliseconds.
    #[must_use]
    pub const fn new(maze: &'m Maze, start: Start, cell_ms: u32, halt: Halt) -> Self {
        Self { maze, start: start.at, at: start.at, heading: start.heading, cell_ms, halt }
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

    /// Stop 0: the robot looks once all round.
    #[must_use]
    pub fn look_round(&self) -> Look {
        Look { sighting: self.sighting(self.maze.ways(self.at), 0), home: Home::PutDown }
    }

    /// Turns, then drives to the next stop.
    ///
    /// # Errors
    /// Where there is no line in that direction; the robot then stays, turned.
    pub fn drive(&mut self, turn: Turn) -> Result<Look, NoLine> {
        self.heading = self.heading.turned(turn);
        if !self.maze.has_line(self.at, self.heading) {
            return Err(NoLine);
        }
        let straight = Ways::NONE.with(self.heading).with(self.heading.opposite());
        let mut cells = 0;
        loop {
            self.at = self.at.step(self.heading);
            cells += 1;
            let ways = self.maze.ways(self.at);
            let home = if self.at == self.start { Home::Back } else { Home::Away };
            let stops = match self.halt {
                Halt::Square => true,
                Halt::Line => ways != straight || home == Home::Back || self.maze.is_finish(self.at),
            };
            if stops {
                return Ok(Look { sighting: self.sighting(ways, cells), home });
            }
        }
    }

    fn sighting(&self, ways: Ways, cells: u32) -> Sighting {
        let finish = if self.maze.is_finish(self.at) { Finish::Yes } else { Finish::No };
        Sighting { ways: ways.in_frame_of(self.heading), finish, time_diff: cells * self.cell_ms }
    }
}
