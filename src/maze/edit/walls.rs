//! Edits for walls: what a pointer on the posts and walls of a walled maze wants of the lattice underneath. A
//! wall that is built is a cell of line erased.

use alloc::vec;
use alloc::vec::Vec;

use super::{Edit, stroke};
use crate::geometry::{Heading, Point};
use crate::maze::Maze;

/// Opens the wall on this side of a square, or builds it where there is none; nothing at the outer wall and
/// off the lattice.
///
/// ```
/// use line_maze_lab::geometry::{Heading, Point};
/// use line_maze_lab::maze::edit::{Edit, walls};
/// use line_maze_lab::maze::{Bounds, Maze};
/// let two = Maze::new(Bounds::new(Point::new(0, 0), Point::new(1, 0))?);
/// let opened = walls::toggle(&two, Point::new(0, 0), Heading::East);
/// assert_eq!(opened, Some(Edit::Draw(vec![(Point::new(0, 0), Heading::East)])));
/// assert_eq!(walls::toggle(&two, Point::new(0, 0), Heading::North), None);
/// # Ok::<(), line_maze_lab::maze::BoundsError>(())
/// ```
#[must_use]
pub fn toggle(maze: &Maze, square: Point, side: Heading) -> Option<Edit> {
    let bounds = maze.bounds();
    if !bounds.contains(square) || !bounds.contains(square.step(side)) {
        return None;
    }
    let cells = vec![(square, side)];
    Some(if maze.has_line(square, side) { Edit::Erase(cells) } else { Edit::Draw(cells) })
}

/// Builds the walls between two posts, along the axes, the longer way first.
#[must_use]
pub fn build(from: Point, to: Point) -> Edit {
    Edit::Erase(sides(from, to))
}

/// Takes the walls between two posts away. The outer wall stays.
#[must_use]
pub fn open(from: Point, to: Point) -> Edit {
    Edit::Draw(sides(from, to))
}

/// The sides of squares that a pointer follows from post to post.
fn sides(from: Point, to: Point) -> Vec<(Point, Heading)> {
    stroke(from, to).into_iter().map(side).collect()
}

/// The side of a square that the wall from a post along a heading is.
#[must_use]
pub const fn side((post, along): (Point, Heading)) -> (Point, Heading) {
    match along {
        Heading::East => (post, Heading::South),
        Heading::West => (post.step(Heading::West), Heading::South),
        Heading::North => (post, Heading::West),
        Heading::South => (post.step(Heading::South), Heading::West),
    }
}

/// The wall nearest to a place, in lattice units: the side of the square that holds it.
///
/// ```
/// use line_maze_lab::geometry::{Heading, Point};
/// use line_maze_lab::maze::edit::walls;
/// assert_eq!(walls::nearest(1.4, -0.1), (Point::new(1, 0), Heading::East));
/// assert_eq!(walls::nearest(-1.1, 2.4), (Point::new(-1, 2), Heading::North));
/// ```
#[must_use]
pub fn nearest(x: f64, y: f64) -> (Point, Heading) {
    let (column, east) = parted(x);
    let (row, north) = parted(y);
    let side = match (east * east > north * north, east > 0.0, north > 0.0) {
        (true, true, _) => Heading::East,
        (true, false, _) => Heading::West,
        (false, _, true) => Heading::North,
        (false, _, false) => Heading::South,
    };
    (Point::new(column, row), side)
}

/// The nearest whole number, and what is left; `f64::round` is not in `core`.
fn parted(number: f64) -> (i32, f64) {
    let whole = (number + if number < 0.0 { -0.5 } else { 0.5 }) as i32;
    (whole, number - f64::from(whole))
}
