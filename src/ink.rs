//! What a run leaves on the floor: when each cell of line was first driven, and when it was crossed out.
//!
//! A cell is crossed out as the bot drives over it while `returning` (the book's figures 3.7 to 3.10), and all
//! cells of a loop at once where line 20 forgets it. What was driven and is not crossed out is the way from
//! the start to the bot; it grows and shrinks at its end only.

use alloc::vec::Vec;

use crate::explorer::book::Case;
use crate::geometry::{Heading, Point};
use crate::maze::{Bounds, MAX_SIDE, Maze};
use crate::trace::Trace;

/// A cell of line, named by its southern or western end and `North` or `East`.
pub type Cell = (Point, Heading);

/// Whole cells of a drive: a real robot takes a little more or less than a multiple of a cell's time. Never
/// more than [`MAX_SIDE`], which leads off every maze.
#[must_use]
pub fn cells_driven(time_diff: u32, cell_ms: u32) -> u32 {
    let cell_ms = u64::from(cell_ms.max(1));
    ((u64::from(time_diff) + cell_ms / 2) / cell_ms).min(u64::from(MAX_SIDE)) as u32
}

/// Never.
const NEVER: u32 = u32::MAX;

/// The stops at which something happened to a cell; the drive towards a stop belongs to it.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
struct Times {
    driven: u32,
    crossed: u32,
}

/// A cell's state at a moment.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum CellState {
    /// Not driven yet.
    Clean,
    /// Driven, and part of the way from the start.
    Driven,
    /// Driven, and crossed out.
    Crossed,
}

/// The floor of a maze over the stops of a run.
#[derive(Clone, Debug)]
pub struct Ink {
    bounds: Bounds,
    /// Two cells for each point: to the north, to the east.
    times: Vec<Times>,
    /// For each crossed-out cell, in order, the stop at which it happened.
    crossings: Vec<u32>,
    /// For each driven cell, in order, the stop.
    drives: Vec<u32>,
    /// Where the bot stands after each stop, the start included.
    places: Vec<Point>,
    /// The drawing's name of the bot's north.
    north: Heading,
}

/// The way from the start to the bot while the floor is painted.
struct Painter {
    ink: Ink,
    way: Vec<usize>,
    /// How long the way was when the node at each place of the table was recorded.
    reach: Vec<usize>,
}

impl Painter {
    /// Paints a drive; while returning, it is crossed out as the bot goes.
    fn drive(&mut self, from: Point, heading: Heading, cells: u32, stop: u32, returning: bool) {
        for i in 0..cells {
            let Some(cell) = self.ink.index((from.ahead(heading, i as i32), heading)) else { continue };
            if self.ink.times[cell].driven == NEVER {
                self.ink.times[cell].driven = stop;
                self.ink.drives.push(stop);
            }
            if !returning {
                self.way.push(cell);
                continue;
            }
            self.cross(cell, stop);
            // A bot that is lost may return along a way that it did not come.
            self.way.pop_if(|last| *last == cell);
        }
    }

    fn forget_loop(&mut self, node: u32, stop: u32) {
        let reach = self.reach.get(node as usize).copied().unwrap_or(0);
        while self.way.len() > reach {
            if let Some(cell) = self.way.pop() {
                self.cross(cell, stop);
            }
        }
    }

    fn cross(&mut self, cell: usize, stop: u32) {
        if self.ink.times[cell].crossed == NEVER {
            self.ink.times[cell].crossed = stop;
            self.ink.crossings.push(stop);
        }
    }

    fn record(&mut self, node: u32) {
        self.reach.truncate(node as usize);
        self.reach.resize(node as usize, 0);
        self.reach.push(self.way.len());
    }
}

impl Ink {
    /// Paints the floor of the maze in which the trace was made; `cell_ms` as the run had it.
    #[must_use]
    pub fn of(maze: &Maze, trace: &Trace, cell_ms: u32) -> Self {
        let bounds = maze.bounds();
        let start = maze.start();
        let mut at = start.map_or(bounds.sw(), |start| start.at);
        let north = start.map_or(Heading::North, |start| start.heading);
        let times = alloc::vec![Times { driven: NEVER, crossed: NEVER }; bounds.len() * 2];
        let mut places = Vec::with_capacity(trace.stops() as usize + 1);
        places.push(at);
        let ink = Self { bounds, times, crossings: Vec::new(), drives: Vec::new(), places, north };
        let mut painter = Painter { ink, way: Vec::new(), reach: Vec::new() };
        let mut returning = false;
        for (step, stop) in trace.steps().iter().zip(1u32..) {
            let heading = step.arrival().out_of_frame_of(north);
            let cells = cells_driven(step.time_diff(), cell_ms);
            painter.drive(at, heading, cells, stop, returning);
            at = at.ahead(heading, cells as i32);
            painter.ink.places.push(at);
            match step.case() {
                Case::New => {
                    painter.record(step.node());
                    returning = false;
                }
                Case::Known => returning = false,
                Case::DeadEnd | Case::KnownBack | Case::UnknownUturn => returning = true,
                Case::UnknownBack => {
                    painter.forget_loop(step.node(), stop);
                    returning = true;
                }
                Case::Finish | Case::Start | Case::Corner | Case::TableFull => {}
            }
        }
        painter.ink
    }

    fn index(&self, (at, heading): Cell) -> Option<usize> {
        let (at, east) = match heading {
            Heading::North => (at, 0),
            Heading::East => (at, 1),
            Heading::South => (at.step(heading), 0),
            Heading::West => (at.step(heading), 1),
        };
        self.bounds.index(at).map(|index| index * 2 + east)
    }

    /// A cell when a stop is over; the heading may be any of the two that name the cell.
    #[must_use]
    pub fn cell(&self, cell: Cell, stop: u32) -> CellState {
        let Some(times) = self.index(cell).map(|index| self.times[index]) else { return CellState::Clean };
        if times.crossed <= stop {
            CellState::Crossed
        } else if times.driven <= stop {
            CellState::Driven
        } else {
            CellState::Clean
        }
    }

    /// Cells crossed out when a stop is over.
    #[must_use]
    pub fn crossed_cells(&self, stop: u32) -> u32 {
        self.crossings.partition_point(|&at| at <= stop) as u32
    }

    /// Different cells driven when a stop is over.
    #[must_use]
    pub fn driven_cells(&self, stop: u32) -> u32 {
        self.drives.partition_point(|&at| at <= stop) as u32
    }

    /// Where the bot stands after a stop, in the drawing's frame.
    #[must_use]
    pub fn place(&self, stop: u32) -> Point {
        self.places[(stop as usize).min(self.places.len() - 1)]
    }

    /// The drawing's name of the bot's north.
    #[must_use]
    pub const fn north(&self) -> Heading {
        self.north
    }

    /// Every driven cell with its state when a stop is over.
    pub fn cells(&self, stop: u32) -> impl Iterator<Item = (Cell, CellState)> {
        self.times.iter().enumerate().filter(move |(_, times)| times.driven <= stop).map(
            move |(index, times)| {
                let heading = if index % 2 == 0 { Heading::North } else { Heading::East };
                let state = if times.crossed <= stop { CellState::Crossed } else { CellState::Driven };
                ((self.bounds.point(index / 2), heading), state)
            },
        )
    }
}
