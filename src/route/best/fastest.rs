//! The quickest way: A* over stops (nodes and the finish) and the headings on arrival; corners and straight line
//! between two stops leave no choice and are driven at once. What is left is at least the cells to the finish
//! without a turn.

use alloc::collections::BinaryHeap;
use alloc::vec;
use alloc::vec::Vec;
use core::cmp::{Ordering, Reverse};

use super::shortest::{FAR, Reach, distances};
use crate::geometry::{Heading, Point, Turn, Ways};
use crate::maze::{Maze, Start};
use crate::route::follow::Floor;
use crate::route::tally::Tally;
use crate::settings::Pace;

/// Seconds up to here and at least from here, and what decides between equals.
#[derive(Clone, Copy, Debug)]
struct Cost(f64, u32);

impl Ord for Cost {
    fn cmp(&self, other: &Self) -> Ordering {
        self.0.total_cmp(&other.0).then(self.1.cmp(&other.1))
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
    /// The settled drive before, and how it went on from there.
    before: u32,
    left: Heading,
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

/// A drive whose cost is known to be the least: from which one it came, and how that was left.
#[derive(Clone, Copy)]
struct Settled {
    before: u32,
    left: Heading,
}

/// The headings of a quickest way, a cell each. Turning round is only tried at the start: anywhere else it comes
/// back to where the drive has been already.
pub(super) fn search(maze: &Maze, start: Start, pace: &Pace) -> Option<Vec<Heading>> {
    let cell_mm = maze.scale.cell_mm();
    let bounds = maze.bounds();
    let far = distances(maze, &Reach::All);
    if far[bounds.index(start.at)?] == FAR {
        return None;
    }
    // Cells from a stop to the finish; the drive is in the same piece of line as the start, so there is a way.
    let left = |at: Point| bounds.index(at).map_or(0, |index| far[index]);
    let cost = |tally: Tally, at: Point| {
        let cells = tally.cells + left(at);
        Reverse(Cost(Tally { cells, ..tally }.seconds(cell_mm, pace), left(at)))
    };
    let floor = Floor::new(maze, start.at);
    let mut reached = vec![Ways::NONE; bounds.len()];
    let mut settled: Vec<Settled> = Vec::new();
    let first = Tally::default();
    let Start { at, heading } = start;
    let mut todo = BinaryHeap::from([Drive {
        cost: cost(first, at),
        tally: first,
        at,
        heading,
        before: 0,
        left: heading,
    }]);
    while let Some(Drive { tally, at, heading, before, left, .. }) = todo.pop() {
        let index = bounds.index(at)?;
        if far[index] == 0 {
            let starts = settled.is_empty();
            settled.push(Settled { before, left });
            return Some(if starts { Vec::new() } else { retrace(floor, start.at, &settled) });
        }
        if reached[index].has(heading) {
            continue;
        }
        reached[index] = reached[index].with(heading);
        let this = settled.len() as u32;
        settled.push(Settled { before, left });
        for turn in Turn::ALL {
            if turn != Turn::Back || this == 0 {
                let left = heading.turned(turn);
                let next = follow(floor, &far, tally.turned(turn), at, left);
                todo.extend(next.map(|(tally, at, heading)| Drive {
                    cost: cost(tally, at),
                    tally,
                    at,
                    heading,
                    before: this,
                    left,
                }));
            }
        }
    }
    None
}

/// Drives on to the next choice or finish; none where there is no line, or it ends, or comes back to where the
/// drive began.
fn follow(
    floor: Floor<'_>,
    far: &[u32],
    mut tally: Tally,
    from: Point,
    mut heading: Heading,
) -> Option<(Tally, Point, Heading)> {
    let maze = floor.maze;
    let (mut at, mut cells) = (from, 0);
    if !maze.has_line(at, heading) {
        return None;
    }
    loop {
        at = at.step(heading);
        cells += 1;
        if at == from {
            return None;
        }
        let ways = maze.ways(at);
        if floor.is_choice(at) || far[maze.bounds().index(at)?] == 0 {
            return Some((tally.driven(cells), at, heading));
        }
        let next = ways.without(heading.opposite()).only()?;
        if next != heading {
            tally = tally.driven(cells).turned(heading.turn_to(next));
            (cells, heading) = (0, next);
        }
    }
}

/// The cells of the way that the last settled drive ends.
fn retrace(floor: Floor<'_>, start: Point, settled: &[Settled]) -> Vec<Heading> {
    let mut lefts = Vec::new();
    let mut nth = settled.len() - 1;
    while nth > 0 {
        lefts.push(settled[nth].left);
        nth = settled[nth].before as usize;
    }
    let mut headings = Vec::new();
    let mut at = start;
    for left in lefts.into_iter().rev() {
        let mut heading = left;
        loop {
            headings.push(heading);
            at = at.step(heading);
            let onward = floor.maze.ways(at).without(heading.opposite());
            match onward.only() {
                Some(next) if !floor.is_choice(at) && !floor.maze.is_finish(at) => heading = next,
                _ => break,
            }
        }
    }
    headings
}
