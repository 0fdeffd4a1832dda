//! What a recorded drive leaves to be seen on the floor: when each cell of line was driven for the first and for
//! the second time, and when each lattice point was first stood on or passed.

use alloc::vec;
use alloc::vec::Vec;

use super::Recording;
use crate::geometry::{Heading, Point};
use crate::ink::Cell;
use crate::maze::Bounds;
use crate::scene::cells_between;

/// Never, as a stop.
const NEVER: u32 = u32::MAX;

/// How often a cell was driven.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Times {
    /// Not yet.
    Never,
    /// Once, in whatever direction.
    Once,
    /// More often.
    Again,
}

/// The floor of a run.
#[derive(Clone, Debug)]
pub struct Driven {
    bounds: Bounds,
    cells: Vec<[u32; 2]>,
    points: Vec<u32>,
}

impl Driven {
    /// The floor that a recording leaves.
    ///
    /// ```
    /// use line_maze_lab::explorer::name::Name;
    /// use line_maze_lab::geometry::{Heading::North, Point};
    /// use line_maze_lab::recording::driven::{Driven, Times};
    /// use line_maze_lab::run::{self, AnyRun};
    /// use line_maze_lab::{maze::samples, settings::Settings};
    /// let run = run::record(&samples::figure_2_4(), &Settings::default(), Name::LeftHand)?;
    /// let AnyRun::Other(recording) = run else { panic!("not the book's") };
    /// let driven = Driven::of(&recording);
    /// let first = (recording.place(0), recording.step(1).heading());
    /// assert_eq!(driven.times(first, 0), Times::Never);
    /// assert_eq!(driven.times(first, 1), Times::Once);
    /// assert!(driven.passed(recording.place(0), 0) && !driven.passed(recording.place(1), 0));
    /// # Ok::<(), line_maze_lab::world::CannotStart>(())
    /// ```
    #[must_use]
    pub fn of(recording: &Recording) -> Self {
        let bounds = recording.bounds;
        let cells = vec![[NEVER; 2]; bounds.len() * 2];
        let mut driven = Self { bounds, cells, points: vec![NEVER; bounds.len()] };
        driven.pass(recording.place(0), 0);
        for stop in 1..=recording.stops() {
            let (from, to) = (recording.place(stop - 1), recording.place(stop));
            for cell in cells_between(from, to) {
                driven.drive(cell, stop);
            }
        }
        driven
    }

    fn pass(&mut self, at: Point, stop: u32) {
        if let Some(place) = self.bounds.index(at) {
            self.points[place] = self.points[place].min(stop);
        }
    }

    fn drive(&mut self, (at, heading): Cell, stop: u32) {
        self.pass(at, stop);
        self.pass(at.step(heading), stop);
        if let Some(place) = self.place((at, heading)) {
            let [first, second] = &mut self.cells[place];
            if *first == NEVER {
                *first = stop;
            } else if *second == NEVER {
                *second = stop;
            }
        }
    }

    fn place(&self, (at, heading): Cell) -> Option<usize> {
        let (at, east) = match heading {
            Heading::North => (at, 0),
            Heading::East => (at, 1),
            Heading::South => (at.step(heading), 0),
            Heading::West => (at.step(heading), 1),
        };
        self.bounds.index(at).map(|place| place * 2 + east)
    }

    /// How often a cell was driven when a stop is over; either heading names the cell.
    #[must_use]
    pub fn times(&self, cell: Cell, stop: u32) -> Times {
        match self.place(cell).map(|place| self.cells[place]) {
            Some([_, second]) if second <= stop => Times::Again,
            Some([first, _]) if first <= stop => Times::Once,
            Some(_) | None => Times::Never,
        }
    }

    /// Whether the robot had been at a point when a stop is over.
    #[must_use]
    pub fn passed(&self, at: Point, stop: u32) -> bool {
        self.bounds.index(at).is_some_and(|place| self.points[place] <= stop)
    }
}
