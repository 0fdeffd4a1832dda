//! Lines as polylines: how a list of corners becomes cells of line, and how cells become few long polylines.
//!
//! Laying a million overlapping segments costs no more than a pass over the lattice: each segment only
//! notes where it begins and ends, and one sweep then draws what is covered.

use alloc::vec;
use alloc::vec::Vec;

use super::{Bounds, Maze};
use crate::geometry::{Heading, Point, Ways};

/// A straight piece of line between two different points.
#[derive(Clone, Copy, Debug)]
pub(super) struct Segment {
    from: Point,
    to: Point,
}

/// Why two points make no segment.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum SegmentError {
    /// They are the same point.
    Empty,
    /// They are neither in one row nor in one column.
    Slanted,
}

impl Segment {
    pub(super) const fn new(from: Point, to: Point) -> Result<Self, SegmentError> {
        match (from.x == to.x, from.y == to.y) {
            (true, true) => Err(SegmentError::Empty),
            (false, false) => Err(SegmentError::Slanted),
            _ => Ok(Self { from, to }),
        }
    }
}

/// Draws all the segments, whose ends are on the lattice, in time that grows with their number, not with
/// their length.
pub(super) fn lay(maze: &mut Maze, segments: &[Segment]) {
    let bounds = maze.bounds();
    let mut east = vec![0_i32; bounds.len()];
    let mut north = vec![0_i32; bounds.len()];
    for segment in segments {
        let covers = if segment.from.y == segment.to.y { &mut east } else { &mut north };
        let (from, to) = (segment.from.min(segment.to), segment.from.max(segment.to));
        if let (Some(begin), Some(end)) = (bounds.index(from), bounds.index(to)) {
            covers[begin] += 1;
            covers[end] -= 1;
        }
    }
    sweep(maze, bounds, Heading::East, &mut east);
    sweep(maze, bounds, Heading::North, &mut north);
}

/// Adds up where segments begin and end along `heading`, and draws each cell that is inside one.
fn sweep(maze: &mut Maze, bounds: Bounds, heading: Heading, covers: &mut [i32]) {
    for (index, at) in bounds.points().enumerate() {
        if covers[index] > 0 {
            if let Some(next) = bounds.index(at.step(heading)) {
                covers[next] += covers[index];
            }
            maze.draw(at, heading);
        }
    }
}

/// All lines of the maze as polylines, each cell once. Only the corners are listed; where it can, a polyline
/// runs straight through crossings. The order is fixed: open ones from the south-west, then closed ones.
pub(super) fn trace(maze: &Maze) -> Vec<Vec<Point>> {
    let bounds = maze.bounds();
    let mut left: Vec<Ways> = bounds.points().map(|at| maze.ways(at)).collect();
    let mut polylines = Vec::new();
    // From a point with an odd number of ways, a walk ends at another such point.
    for index in 0..left.len() {
        if left[index].count() % 2 == 1 {
            polylines.push(walk(bounds, bounds.point(index), &mut left));
        }
    }
    for index in 0..left.len() {
        while !left[index].is_empty() {
            polylines.push(walk(bounds, bounds.point(index), &mut left));
        }
    }
    polylines
}

/// Follows lines from a point until none is left there, straight on where possible, and takes them away.
fn walk(bounds: Bounds, from: Point, left: &mut [Ways]) -> Vec<Point> {
    let mut corners = vec![from];
    let mut at = from;
    let mut along = None;
    while let Some(index) = bounds.index(at) {
        let straight = along.filter(|&heading| left[index].has(heading));
        let Some(heading) = straight.or_else(|| left[index].iter().next()) else { break };
        if along.is_some_and(|before| before != heading) {
            corners.push(at);
        }
        left[index] = left[index].without(heading);
        at = at.step(heading);
        if let Some(next) = bounds.index(at) {
            left[next] = left[next].without(heading.opposite());
        }
        along = Some(heading);
    }
    corners.push(at);
    corners
}

#[cfg(test)]
#[allow(clippy::unwrap_used)]
mod tests {
    use super::*;

    fn square(side: i32) -> Bounds {
        Bounds::new(Point::new(0, 0), Point::new(side - 1, side - 1)).unwrap()
    }

    fn segment(a: (i32, i32), b: (i32, i32)) -> Segment {
        Segment::new(Point::new(a.0, a.1), Point::new(b.0, b.1)).unwrap()
    }

    #[test]
    fn overlapping_segments_are_their_union() {
        let mut maze = Maze::new(square(5));
        lay(&mut maze, &[segment((0, 0), (3, 0)), segment((4, 0), (2, 0)), segment((1, 3), (1, 0))]);
        let mut by_hand = Maze::new(square(5));
        (0..4).for_each(|x| assert!(by_hand.draw(Point::new(x, 0), Heading::East)));
        (0..3).for_each(|y| assert!(by_hand.draw(Point::new(1, y), Heading::North)));
        assert_eq!(maze, by_hand);
    }

    #[test]
    fn a_million_overlapping_segments_are_quick() {
        let mut maze = Maze::new(square(1000));
        lay(&mut maze, &vec![segment((0, 7), (999, 7)); 1_000_000]);
        assert_eq!(maze.cells(), 999);
    }

    #[test]
    fn a_cross_is_two_polylines_and_a_square_is_one() {
        let mut maze = Maze::new(square(5));
        lay(&mut maze, &[segment((1, 0), (1, 2)), segment((0, 1), (2, 1))]);
        assert_eq!(trace(&maze).len(), 2);
        let mut maze = Maze::new(square(5));
        lay(&mut maze, &[segment((0, 0), (0, 4)), segment((4, 0), (4, 4))]);
        lay(&mut maze, &[segment((0, 0), (4, 0)), segment((0, 4), (4, 4))]);
        assert_eq!(trace(&maze).len(), 1);
        assert_eq!(trace(&maze)[0].len(), 5);
    }
}
