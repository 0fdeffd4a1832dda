//! What a run has left on the floor by a stop: which cells it has driven, and which the book's has crossed out.

use alloc::vec;
use alloc::vec::Vec;

use super::Path;
use crate::geometry::{Heading, Point};
use crate::ink::{CellState, Ink};
use crate::maze::{Bounds, Maze};
use crate::playback::Timeline;
use crate::run::AnyRun;

/// The floor of a whole run.
#[derive(Clone, Debug)]
pub struct Floor {
    bounds: Bounds,
    /// For each cell, by its southern or western end: the stop to which it was driven first.
    first: Vec<u32>,
    places: Vec<Point>,
    ink: Option<Ink>,
}

/// How a cell is shown.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Shown {
    /// Not driven yet.
    Clean,
    /// Driven.
    Driven,
    /// Crossed out.
    Crossed,
}

impl Floor {
    /// Drives the run once.
    ///
    /// ```
    /// use line_maze_lab::compare::floor::{Floor, Shown};
    /// use line_maze_lab::explorer::name::Name;
    /// use line_maze_lab::geometry::{Heading, Point};
    /// use line_maze_lab::{maze::samples, run::record, settings::Settings};
    /// let (maze, settings) = (samples::figure_3_1(), Settings::default());
    /// let floor = Floor::of(&maze, &record(&maze, &settings, Name::RightHand)?);
    /// let cell = (Point::new(0, 0), Heading::North);
    /// assert_eq!((floor.cell(cell, 0), floor.cell(cell, 1)), (Shown::Clean, Shown::Driven));
    /// # Ok::<(), line_maze_lab::world::CannotStart>(())
    /// ```
    #[must_use]
    pub fn of(maze: &Maze, run: &AnyRun) -> Self {
        let bounds = maze.bounds();
        let ink = match run {
            AnyRun::Book(book) => Some(Ink::of(maze, book.trace(), book.cell_ms())),
            AnyRun::Other(_) => None,
        };
        let mut floor = Self { bounds, first: vec![u32::MAX; bounds.len() * 2], places: Vec::new(), ink };
        if let Some(start) = maze.start() {
            let path = Path { run, start };
            floor.places = (0..=run.stops()).map(|stop| path.place(stop)).collect();
            for stop in 1..=run.stops() {
                floor.drive(stop, path.heading(stop));
            }
        }
        floor
    }

    fn drive(&mut self, stop: u32, heading: Heading) {
        let (mut at, to) = (self.places[stop as usize - 1], self.places[stop as usize]);
        for _ in 0..at.distance(to) {
            if let Some(index) = self.index((at, heading)) {
                self.first[index] = self.first[index].min(stop);
            }
            at = at.step(heading);
        }
    }

    /// A cell by its southern or western end, after a stop.
    #[must_use]
    pub fn cell(&self, cell: (Point, Heading), stop: u32) -> Shown {
        let driven = self.index(cell).is_some_and(|index| self.first[index] <= stop);
        match &self.ink {
            _ if !driven => Shown::Clean,
            Some(ink) if ink.cell(cell, stop) == CellState::Crossed => Shown::Crossed,
            Some(_) | None => Shown::Driven,
        }
    }

    /// Where a stop is; the last one past the end.
    #[must_use]
    pub fn place(&self, stop: u32) -> Option<Point> {
        self.places.get(stop as usize).or(self.places.last()).copied()
    }

    fn index(&self, (at, heading): (Point, Heading)) -> Option<usize> {
        let (at, slot) = match heading {
            Heading::North => (at, 0),
            Heading::East => (at, 1),
            Heading::South => (at.step(heading), 0),
            Heading::West => (at.step(heading), 1),
        };
        self.bounds.index(at).map(|index| index * 2 + slot)
    }
}
