//! The best routes that a maze has, for those who can see it: the shortest, and the quickest.
//!
//! Both are one search over the stops (nodes and the finish) with the headings on arrival, as a turn costs time; corners
//! and straight line between two stops leave no choice and are driven at once.

use alloc::collections::BinaryHeap;
use alloc::vec::Vec;
use core::cmp::{Ordering, Reverse};

use super::tally::Tally;
use crate::geometry::{Heading, Point, Turn, Ways};
use crate::maze::{Maze, Start};
use crate::settings::Pace;

/// A best way.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Best {
    /// Its length.
    pub cells: u32,
    /// Its time.
    pub seconds: f64,
}

/// The shortest way to the finish, and of several the quickest; none where no way leads there.
///
/// ```
/// use line_maze_lab::geometry::{Heading::North, Point};
/// use line_maze_lab::maze::{Bounds, Maze, Start};
/// use line_maze_lab::{route::best, settings::Pace};
/// let mut maze = Maze::new(Bounds::new(Point::new(0, 0), Point::new(0, 1))?);
/// maze.draw(Point::new(0, 0), North);
/// maze.set_finish(vec![Point::new(0, 1)]);
/// let start = Start { at: Point::new(0, 0), heading: North };
/// assert_eq!(best::shortest(&maze, start, &Pace::default()).map(|best| best.cells), Some(1));
/// # Ok::<(), line_maze_lab::maze::BoundsError>(())
/// ```
#[must_use]
pub fn shortest(maze: &Maze, start: Start, pace: &Pace) -> Option<Best> {
    search(maze, start, pace, |best| Cost(f64::from(best.cells), best.seconds))
}

/// The quickest way to the finish, and of several the shortest; none where no way leads there.
#[must_use]
pub fn fastest(maze: &Maze, start: Start, pace: &Pace) -> Option<Best> {
    search(maze, start, pace, |best| Cost(best.seconds, f64::from(best.cells)))
}

/// What is to be least, and what decides between equals.
#[derive(Clone, Copy, Debug)]
struct Cost(f64, f64);

impl Ord for Cost {
    fn cmp(&self, other: &Self) -> Ordering {
        self.0.total_cmp(&other.0).then(self.1.total_cmp(&other.1))
    }
}

impl PartialOrd for Cost {
    fn partial_cmp(&self, other: &Self) -> Option<Ordering> {
        Some(self.cmp(other))
    }
}

impl PartialEq for Cost {
    fn eq(&self, other: &Self) -> bool {
        self.cmp(other).is_eq()
    }
}

impl Eq for Cost {}

/// A drive up to a stop; the least costly is the greatest, as a heap wants it.
struct Drive {
    cost: Reverse<Cost>,
    tally: Tally,
    at: Point,
    heading: Heading,
}

impl Ord for Drive {
    fn cmp(&self, other: &Self) -> Ordering {
        self.cost.cmp(&other.cost)
    }
}

impl PartialOrd for Drive {
    fn partial_cmp(&self, other: &Self) -> Option<Ordering> {
        Some(self.cmp(other))
    }
}

impl PartialEq for Drive {
    fn eq(&self, other: &Self) -> bool {
        self.cost == other.cost
    }
}

impl Eq for Drive {}

/// Dijkstra's search. Turning round is only tried at the start: anywhere else it comes back to where the
/// drive has been already.
fn search(maze: &Maze, start: Start, pace: &Pace, cost: fn(Best) -> Cost) -> Option<Best> {
    let cell_mm = maze.scale.cell_mm();
    let best = |tally: Tally| Best { cells: tally.cells, seconds: tally.seconds(cell_mm, pace) };
    let drive = |tally, at, heading| Drive { cost: Reverse(cost(best(tally))), tally, at, heading };
    let bounds = maze.bounds();
    // The headings with which a point was reached at its least cost.
    let mut reached: Vec<Ways> = alloc::vec![Ways::NONE; bounds.len()];
    let mut todo = BinaryHeap::from([drive(Tally::default(), start.at, start.heading)]);
    while let Some(Drive { tally, at, heading, .. }) = todo.pop() {
        if maze.is_finish(at) {
            return Some(best(tally));
        }
        let index = bounds.index(at)?;
        if reached[index].has(heading) {
            continue;
        }
        reached[index] = reached[index].with(heading);
        for turn in Turn::ALL {
            if turn != Turn::Back || tally.stops == 0 {
                let turned = tally.turned(turn);
                todo.extend(follow(maze, turned, at, heading.turned(turn)).map(|(t, at, h)| drive(t, at, h)));
            }
        }
    }
    None
}

/// Drives on to the next node or finish; none where there is no line, or it ends, or comes back to where the
/// drive began.
fn follow(
    maze: &Maze,
    mut tally: Tally,
    from: Point,
    mut heading: Heading,
) -> Option<(Tally, Point, Heading)> {
    let (mut at, mut cells) = (from, 0);
    if !maze.has_line(at, heading) {
        return None;
    }
    loop {
        at = at.step(heading);
        cells += 1;
        let ways = maze.ways(at);
        if at == from {
            return None;
        }
        if maze.is_finish(at) || ways.count() > 2 {
            return Some((tally.driven(cells), at, heading));
        }
        let next = ways.without(heading.opposite()).only()?;
        if next != heading {
            tally = tally.driven(cells).turned(heading.turn_to(next));
            (cells, heading) = (0, next);
        }
    }
}
