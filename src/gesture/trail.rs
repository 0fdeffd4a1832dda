//! What a pointer leaves behind it: a path that grows from point to point, and what an eraser passes.

use alloc::vec::Vec;

use super::place::{nearest_among, nearest_point, squared};
use crate::geometry::{Heading, Point, Ways};
use crate::maze::edit::stroke;
use crate::maze::{Maze, walls};

/// A pointer counts for a lattice point within this distance, so that a slip between two rows draws nothing.
pub(super) const NEAR_POINT: f64 = 0.45;
/// And for a post: one may press the wall between two with a trembling hand.
pub(super) const NEAR_POST: f64 = 0.36;
/// And for a cell of line, or a wall.
const NEAR_CELL: f64 = 0.4;
/// So near to a lattice point a moving eraser waits: it may only cross the lines there.
const CROSSING: f64 = 0.22;

/// What an eraser works on. Walls stand between posts as lines lie between points, half a cell further to the
/// south-west.
pub(super) enum Paper<'a> {
    Lines(&'a Maze),
    Walls(&'a Maze),
}

impl Paper<'_> {
    fn ways(&self, at: Point) -> Ways {
        match self {
            Self::Lines(maze) => maze.ways(at),
            Self::Walls(maze) => walls::ways(maze, at),
        }
    }

    const fn shift(&self) -> f64 {
        match self {
            Self::Lines(_) => 0.0,
            Self::Walls(_) => 0.5,
        }
    }

    /// What is under a place.
    pub(super) fn touched(&self, (x, y): (f64, f64)) -> Vec<(Point, Heading)> {
        let place = (x + self.shift(), y + self.shift());
        nearest_among(|at| self.ways(at), place, NEAR_CELL).into_iter().collect()
    }

    /// Takes in what an eraser passes.
    pub(super) fn pass(&self, cells: &mut Vec<(Point, Heading)>, from: (f64, f64), to: (f64, f64)) {
        /// Steps a cell.
        const FINE: f64 = 8.0;
        let shift = self.shift();
        let (dx, dy) = (to.0 - from.0, to.1 - from.1);
        let far = if dx.abs() > dy.abs() { dx.abs() } else { dy.abs() };
        // Nobody passes thousands of cells between two moves: the picture does not hold so many.
        let steps = ((far * FINE) as u32 + 1).min(20_000);
        for step in 1..=steps {
            let part = f64::from(step) / f64::from(steps);
            let place = (from.0 + dx * part + shift, from.1 + dy * part + shift);
            let point = nearest_point(place);
            if squared(place, (f64::from(point.x), f64::from(point.y))) < CROSSING * CROSSING {
                continue;
            }
            if let Some(cell) = nearest_among(|at| self.ways(at), place, NEAR_CELL)
                && !cells.contains(&cell)
            {
                cells.push(cell);
            }
        }
    }
}

/// Whether the place is near enough to one of the points between two corners; beyond them the nearest counts.
pub(super) fn is_near((x, y): (f64, f64), at: Point, (sw, ne): (Point, Point), within: f64) -> bool {
    let inside = |v: f64, low: i32, high: i32| v.clamp(f64::from(low), f64::from(high));
    let place = (inside(x, sw.x, ne.x), inside(y, sw.y, ne.y));
    squared(place, (f64::from(at.x), f64::from(at.y))) <= within * within
}

/// Goes on to a point; going back over the last cell takes it back.
pub(super) fn extend(path: &mut Vec<Point>, to: Point) {
    let Some(&from) = path.last() else { return };
    for (at, heading) in stroke(from, to) {
        let next = at.step(heading);
        if path.len() > 1 && path[path.len() - 2] == next {
            path.pop();
        } else {
            path.push(next);
        }
    }
}
