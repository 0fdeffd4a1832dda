//! Explorers side by side: what each comes to in the same maze ([`score`]), where two of them part
//! ([`parting`], several of them [`forks`]), where they all are at the same time ([`abreast`]), what they left on
//! the floor by then ([`floor`]), how much luck is in random orders ([`orders`]), the league over many mazes
//! ([`league`]), what the page draws and says of it ([`plot`], [`words`]), and what spreadsheets get ([`sheet`]).
//!
//! Everything is pure and comes in pieces of one run each, so that a worker can say how far it is and stop.

pub mod abreast;
pub mod floor;
pub mod forks;
pub mod league;
pub mod orders;
pub mod parting;
pub mod plot;
pub mod score;
pub mod sheet;
pub mod words;

use core::fmt;

use alloc::vec::Vec;

use crate::explorer::name::Name;
use crate::geometry::{Heading, Point};
use crate::maze::{Maze, Start};
use crate::playback::Timeline;
use crate::run::{AnyRun, record};
use crate::settings::Settings;
use crate::trace::Moment;
use crate::world::CannotStart;
use score::{Bests, Score};

/// Two to six different explorers.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Lineup(Vec<Name>);

/// Why explorers cannot be put side by side.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum LineupError {
    /// Fewer than [`Lineup::LEAST`] or more than [`Lineup::MOST`].
    Count(usize),
    /// One of them twice.
    Twice(Name),
}

impl fmt::Display for LineupError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Count(count) => {
                write!(f, "{} to {} explorers are compared, not {count}", Lineup::LEAST, Lineup::MOST)
            }
            Self::Twice(name) => write!(f, "“{name}” is there twice; name each once"),
        }
    }
}

impl core::error::Error for LineupError {}

impl Lineup {
    /// The fewest.
    pub const LEAST: usize = 2;
    /// The most: their pictures have to fit a screen.
    pub const MOST: usize = 6;

    /// These explorers in this order.
    ///
    /// # Errors
    /// Where they are too few, too many, or not all different.
    pub fn new(names: Vec<Name>) -> Result<Self, LineupError> {
        if !(Self::LEAST..=Self::MOST).contains(&names.len()) {
            return Err(LineupError::Count(names.len()));
        }
        each_once(&names)?;
        Ok(Self(names))
    }

    /// The explorers.
    #[must_use]
    pub fn names(&self) -> &[Name] {
        &self.0
    }
}

/// Whether no explorer is named twice: it would drive the same way again.
///
/// # Errors
/// Names the first that is.
pub fn each_once(names: &[Name]) -> Result<(), LineupError> {
    match names.iter().enumerate().find(|(nth, name)| names[..*nth].contains(name)) {
        Some((_, &name)) => Err(LineupError::Twice(name)),
        None => Ok(()),
    }
}

/// An explorer in a comparison: its whole run, and what it came to.
#[derive(Clone, Debug)]
pub struct Entrant {
    /// The run, to be played and stepped through.
    pub run: AnyRun,
    /// In numbers.
    pub score: Score,
}

impl Entrant {
    /// Lets an explorer run; one piece of a comparison's work.
    ///
    /// ```
    /// use line_maze_lab::compare::{Entrant, score::Bests};
    /// use line_maze_lab::explorer::name::Name;
    /// use line_maze_lab::{maze::samples, settings::Settings};
    /// let (maze, settings) = (samples::figure_3_1(), Settings::default());
    /// let book = Entrant::of(&maze, &settings, Name::Book, &Bests::of(&maze, &settings))?;
    /// assert_eq!(book.score.ratio_shortest(), Some(1.0));
    /// # Ok::<(), line_maze_lab::world::CannotStart>(())
    /// ```
    ///
    /// # Errors
    /// Where this explorer cannot be put down at the start.
    pub fn of(maze: &Maze, settings: &Settings, name: Name, bests: &Bests) -> Result<Self, CannotStart> {
        let run = record(maze, settings, name)?;
        let score = Score::of(maze, settings, &run, *bests);
        Ok(Self { run, score })
    }
}

/// A run and where it began: what the book's trace doesn't say.
#[derive(Clone, Copy)]
struct Path<'r> {
    run: &'r AnyRun,
    start: Start,
}

impl Path<'_> {
    /// Where a stop is.
    fn place(self, stop: u32) -> Point {
        match self.run {
            AnyRun::Other(run) => run.place(stop),
            AnyRun::Book(run) => {
                // Without drift the robot's coordinates are right, and every time is a number of whole cells.
                let state = run.trace().state(stop);
                let cells = |ms: i32| ms / run.cell_ms().max(1).cast_signed();
                let (right, ahead) = (cells(state.cur_x), cells(state.cur_y));
                let heading = self.start.heading;
                self.start.at.ahead(heading, ahead).ahead(heading.turned(crate::geometry::Turn::Right), right)
            }
        }
    }

    /// The drawing's heading of the drive to a stop; that of the start for the start.
    fn heading(self, stop: u32) -> Heading {
        if stop == 0 {
            return self.start.heading;
        }
        let (from, to) = (self.place(stop - 1), self.place(stop));
        let towards = |heading: &Heading| from.step(*heading).distance(to) < from.distance(to);
        Heading::ALL.into_iter().find(towards).unwrap_or(self.start.heading)
    }

    /// The drawing's heading that the robot faces when a stop is over.
    fn faces(self, stop: u32) -> Heading {
        match self.run {
            AnyRun::Book(run) => run.trace().bot_dir(Moment::after(stop)).out_of_frame_of(self.start.heading),
            AnyRun::Other(run) => run.step(stop).faces(),
        }
    }

    fn stops(self) -> u32 {
        self.run.stops()
    }
}
