//! Everything that the views need of one run, worked out once: trace, ink, route, and how good it is.

use std::sync::Arc;

use crate::event::Outcome;
use crate::explorer::book::errata::Walk;
use crate::ink::Ink;
use crate::maze::{Maze, samples};
use crate::route::{Drive, Route, TurnList, best};
use crate::run::explore;
use crate::settings::{Order, Preference, Settings};
use crate::trace::Trace;
use crate::world::CannotStart;

/// A shared value that is equal to itself only: signals compare it without looking inside.
#[derive(Debug)]
pub struct Same<T>(Arc<T>);

impl<T> Same<T> {
    /// Shares a value.
    pub fn new(value: T) -> Self {
        Self(Arc::new(value))
    }
}

impl<T> Clone for Same<T> {
    fn clone(&self) -> Self {
        Self(Arc::clone(&self.0))
    }
}

impl<T> PartialEq for Same<T> {
    fn eq(&self, other: &Self) -> bool {
        Arc::ptr_eq(&self.0, &other.0)
    }
}

impl<T> std::ops::Deref for Same<T> {
    type Target = T;
    fn deref(&self) -> &T {
        &self.0
    }
}

/// A run of the book's explorer through a maze.
#[derive(Debug)]
pub struct Run {
    /// The maze.
    pub maze: Same<Maze>,
    /// What the bot thought.
    pub trace: Trace,
    /// What it left on the floor.
    pub ink: Ink,
    /// Milliseconds that a cell takes.
    pub cell_ms: u32,
    /// Round 2, if the finish was found.
    pub drive: Option<Drive>,
    /// Its turn list.
    pub list: Option<TurnList>,
    /// Cells of the shortest way to the finish, if there is one.
    pub shortest: Option<u32>,
    /// Which of the book's walks it is.
    pub walk: Walk,
}

/// A run that is not the page's own: a robot's, live or recorded.
#[derive(Debug)]
pub struct Guest {
    /// The run.
    pub run: Same<Run>,
    /// Whose it is, and how far.
    pub told: String,
    /// The first stop at which robot and page decided differently.
    pub differs: Option<u32>,
}

impl Run {
    /// A robot's run as it was told: nothing is worked out but what is seen.
    #[must_use]
    pub fn told(maze: Same<Maze>, trace: Trace, cell_ms: u32) -> Self {
        let ink = Ink::of(&maze, &trace, cell_ms);
        let list = TurnList::of(&trace);
        Self { maze, trace, ink, cell_ms, drive: None, list, shortest: None, walk: Walk::Other }
    }

    /// Runs the explorer.
    ///
    /// # Errors
    /// Where the bot cannot be put down.
    pub fn of(maze: Same<Maze>, settings: &Settings) -> Result<Self, CannotStart> {
        let trace = explore(&maze, settings)?;
        let cell_ms = settings.pace.cell_ms(maze.scale);
        let ink = Ink::of(&maze, &trace, cell_ms);
        let list = TurnList::of(&trace);
        let route = list.as_ref().and_then(|list| Route::drive(&maze, list).ok());
        let best = maze.start().and_then(|start| best::shortest(&maze, start, &settings.pace));
        let shortest = best.map(|best| best.cells);
        let drive = route.map(|route| Drive { route, cell_ms });
        let walk = walk(&maze, settings);
        Ok(Self { maze, trace, ink, cell_ms, drive, list, shortest, walk })
    }

    /// Whether the finish was found.
    #[must_use]
    pub fn solved(&self) -> bool {
        self.trace.outcome() == Outcome::Finish
    }

    /// Cells driven when a stop is over, counted each time.
    #[must_use]
    pub fn cells(&self, stop: u32) -> u64 {
        self.trace.state(stop).driven_ms / u64::from(self.cell_ms)
    }

    /// Cells of the route, if there is one.
    #[must_use]
    pub fn route_cells(&self) -> Option<u32> {
        self.drive.as_ref().map(|drive| drive.route.cells())
    }

    /// Route length by shortest length.
    #[must_use]
    pub fn ratio(&self) -> Option<f64> {
        Some(f64::from(self.route_cells()?) / f64::from(self.shortest?.max(1)))
    }
}

/// Whether a maze is drawn as a figure is, with start and finish.
#[must_use]
pub fn is_figure(maze: &Maze, figure: &Maze) -> bool {
    figure.start() == maze.start() && figure.finish() == maze.finish() && figure.lines().eq(maze.lines())
}

/// The book's figures, when they are walked as in the book.
fn walk(maze: &Maze, settings: &Settings) -> Walk {
    let same = |figure: &Maze| is_figure(maze, figure);
    if settings.order != Order::Fixed(Preference::SRL) || settings.epsilon_ms.is_some() {
        Walk::Other
    } else if same(&samples::figure_3_1()) {
        Walk::Figure31
    } else if same(&samples::figure_2_4()) {
        Walk::Figure24
    } else {
        Walk::Other
    }
}
