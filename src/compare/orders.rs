//! How much luck is in random orders: many runs of the book's explorer in one maze, each with its own seed (the
//! book's §3.1 advises to draw the order anew at each choice).

use alloc::vec::Vec;

use crate::maze::Maze;
use crate::route::{Route, TurnList};
use crate::run::explore;
use crate::settings::{Order, Settings};
use crate::world::CannotStart;

/// What one seed came to.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Draw {
    /// The seed: `random:SEED`.
    pub seed: u64,
    /// Cells of the route; none where the run left none.
    pub route_cells: Option<u32>,
}

/// Runs the book's explorer with one seed; one piece of the work.
///
/// # Errors
/// Where it cannot be put down at the start.
pub fn draw(maze: &Maze, settings: &Settings, seed: u64) -> Result<Draw, CannotStart> {
    let trace = explore(maze, &Settings { order: Order::Random(seed), ..*settings })?;
    let route = TurnList::of(&trace).and_then(|list| Route::drive(maze, &list).ok());
    Ok(Draw { seed, route_cells: route.map(|route| route.cells()) })
}

/// Many draws.
///
/// ```
/// use line_maze_lab::compare::orders::{Draws, draw};
/// use line_maze_lab::{maze::samples, settings::Settings};
/// let (maze, settings) = (samples::figure_3_1(), Settings::default());
/// let draws = (1..=50).map(|seed| draw(&maze, &settings, seed)).collect::<Result<Draws, _>>()?;
/// assert_eq!(draws.best().and_then(|draw| draw.route_cells), Some(9));
/// # Ok::<(), line_maze_lab::world::CannotStart>(())
/// ```
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Draws {
    /// Those with a route, the shortest first; of equals the lowest seed.
    solved: Vec<(u32, u64)>,
    /// Those without.
    failed: usize,
}

/// A bar of the histogram.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Bar {
    /// The least cells that count here.
    pub from: u32,
    /// The most.
    pub to: u32,
    /// How many routes.
    pub count: usize,
}

impl Draws {
    fn of(draws: impl IntoIterator<Item = Draw>) -> Self {
        let mut all = Self::default();
        for draw in draws {
            match draw.route_cells {
                Some(cells) => all.solved.push((cells, draw.seed)),
                None => all.failed += 1,
            }
        }
        all.solved.sort_unstable();
        all
    }

    /// The one with the shortest route, to be opened.
    #[must_use]
    pub fn best(&self) -> Option<Draw> {
        self.solved.first().map(|&(cells, seed)| Draw { seed, route_cells: Some(cells) })
    }

    /// The one with the longest.
    #[must_use]
    pub fn worst(&self) -> Option<Draw> {
        self.solved.last().map(|&(cells, seed)| Draw { seed, route_cells: Some(cells) })
    }

    /// The length that half of the routes do not pass.
    #[must_use]
    pub fn median_cells(&self) -> Option<u32> {
        self.solved.get(self.solved.len().saturating_sub(1) / 2).map(|&(cells, _)| cells)
    }

    /// How many are at most so long: with the shortest of the maze, how many are as short as any.
    #[must_use]
    pub fn at_most(&self, cells: u32) -> usize {
        self.solved.partition_point(|&(ours, _)| ours <= cells)
    }

    /// How many left a route, and how many did not.
    #[must_use]
    pub fn counts(&self) -> (usize, usize) {
        (self.solved.len(), self.failed)
    }

    /// At most so many bars of equal width from the shortest of the maze (or the shortest drawn) to the longest
    /// drawn.
    #[must_use]
    pub fn bars(&self, shortest: Option<u32>, most: u32) -> Vec<Bar> {
        let (Some(&(least, _)), Some(&(longest, _))) = (self.solved.first(), self.solved.last()) else {
            return Vec::new();
        };
        let from = shortest.map_or(least, |shortest| shortest.min(least));
        let width = (longest - from + 1).div_ceil(most.max(1));
        let count = (longest - from) / width + 1;
        let bar = |nth| Bar { from: from + nth * width, to: from + (nth + 1) * width - 1, count: 0 };
        let mut bars: Vec<Bar> = (0..count).map(bar).collect();
        for &(cells, _) in &self.solved {
            if let Some(bar) = bars.get_mut(((cells - from) / width) as usize) {
                bar.count += 1;
            }
        }
        bars
    }
}

impl FromIterator<Draw> for Draws {
    fn from_iter<I: IntoIterator<Item = Draw>>(draws: I) -> Self {
        Self::of(draws)
    }
}
