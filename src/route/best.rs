//! The best routes that a maze has, for those who can see it: fewest cells, and least time.

use alloc::collections::{BinaryHeap, VecDeque};
use alloc::vec::Vec;
use core::cmp::Reverse;

use crate::geometry::{Heading, Point, Turn};
use crate::maze::{Bounds, Maze, Start};
use crate::settings::Pace;

/// Cells of the shortest way from a point to the finish; none where no way leads there.
#[must_use]
pub fn shortest_cells(maze: &Maze, from: Point) -> Option<u32> {
    let bounds = maze.bounds();
    let mut far: Vec<u32> = alloc::vec![u32::MAX; bounds.len()];
    let mut todo = VecDeque::from([from]);
    far[bounds.index(from)?] = 0;
    while let Some(at) = todo.pop_front() {
        let cells = far[bounds.index(at)?];
        if maze.is_finish(at) {
            return Some(cells);
        }
        for next in maze.ways(at).iter().map(|heading| at.step(heading)) {
            if let Some(index) = bounds.index(next)
                && far[index] == u32::MAX
            {
                far[index] = cells + 1;
                todo.push_back(next);
            }
        }
    }
    None
}

/// The quickest way.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Fastest {
    /// Its length.
    pub cells: u32,
    /// Its time.
    pub seconds: f64,
}

/// A place in the search: point and heading.
const fn place(bounds: Bounds, at: Point, heading: Heading) -> Option<usize> {
    match bounds.index(at) {
        Some(index) => Some(index * 4 + heading as usize),
        None => None,
    }
}

/// The quickest way to the finish for a robot of this pace; none where no way leads there. Costs are whole
/// microseconds, so equal routes are equal everywhere.
#[must_use]
pub fn fastest(maze: &Maze, start: Start, pace: &Pace) -> Option<Fastest> {
    let micros = |seconds: f64| (seconds * 1e6 + 0.5) as u64;
    let cell = micros(maze.scale.cell_mm() / pace.speed_mm_s);
    let bounds = maze.bounds();
    let mut best: Vec<u64> = alloc::vec![u64::MAX; bounds.len() * 4];
    let mut todo = BinaryHeap::new();
    best[place(bounds, start.at, start.heading)?] = 0;
    todo.push(Reverse((0u64, 0u32, start.at, start.heading)));
    while let Some(Reverse((cost, cells, at, heading))) = todo.pop() {
        if maze.is_finish(at) {
            return Some(Fastest { cells, seconds: cost as f64 / 1e6 });
        }
        if best[place(bounds, at, heading)?] < cost {
            continue;
        }
        let ways = maze.ways(at);
        // At the start the robot drives off; straight line is no stop.
        let stop = cells > 0 && ways != crate::geometry::Ways::NONE.with(heading).with(heading.opposite());
        for turn in Turn::ALL {
            let next = heading.turned(turn);
            if !ways.has(next) || (turn == Turn::Back && cells == 0 && ways.count() > 1) {
                continue;
            }
            let pause = if stop { micros(pace.stop_s) } else { 0 };
            let cost = cost + cell + micros(pace.seconds(turn)) + pause;
            let index = place(bounds, at.step(next), next)?;
            if cost < best[index] {
                best[index] = cost;
                todo.push(Reverse((cost, cells + 1, at.step(next), next)));
            }
        }
    }
    None
}
