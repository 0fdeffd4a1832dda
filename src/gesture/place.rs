//! Places between lattice points: which point, which cell, which line is the nearest.

use super::trail::{NEAR_POST, is_near};
use crate::geometry::{Heading, Point, Ways};
use crate::maze::Maze;

/// The lattice point nearest to a place.
#[must_use]
pub fn nearest_point((x, y): (f64, f64)) -> Point {
    Point::new(floor(x + 0.5), floor(y + 0.5))
}

/// The cell of lattice nearest to a place, by its southern or western end, and how far away it is in cells.
#[must_use]
pub fn nearest_cell((x, y): (f64, f64)) -> ((Point, Heading), f64) {
    let at = nearest_point((x, y));
    let (across, along) = ((x - f64::from(at.x)).abs(), (y - f64::from(at.y)).abs());
    if across < along {
        ((Point::new(at.x, floor(y)), Heading::North), across)
    } else {
        ((Point::new(floor(x), at.y), Heading::East), along)
    }
}

/// The post of a walled maze nearest to a place: half a cell south-west of the square with its name. Beyond the
/// outer wall the nearest post there counts.
#[must_use]
pub(super) fn nearest_post(maze: &Maze, (x, y): (f64, f64)) -> Point {
    let (sw, ne) = posts(maze);
    let at = nearest_point((x + 0.5, y + 0.5));
    Point::new(at.x.clamp(sw.x, ne.x), at.y.clamp(sw.y, ne.y))
}

/// Whether the place is near enough to the post.
pub(super) fn is_near_post(maze: &Maze, (x, y): (f64, f64), post: Point) -> bool {
    is_near((x + 0.5, y + 0.5), post, posts(maze), NEAR_POST)
}

/// The outermost posts.
fn posts(maze: &Maze) -> (Point, Point) {
    let (sw, ne) = (maze.bounds().sw(), maze.bounds().ne());
    (sw, ne.step(Heading::North).step(Heading::East))
}

/// Whether a place is on this side of a square, and not at one of its posts.
pub(super) fn is_on_side((x, y): (f64, f64), square: Point, side: Heading) -> bool {
    /// How far from the wall, and from the wall's middle, in cells.
    const NEAR: (f64, f64) = (0.22, 0.34);
    let (east, north) = ((x - f64::from(square.x)).abs(), (y - f64::from(square.y)).abs());
    let (out, along) = match side {
        Heading::East | Heading::West => (east, north),
        Heading::North | Heading::South => (north, east),
    };
    0.5 - out <= NEAR.0 && along <= NEAR.1
}

/// The cell nearest to a place among those that `ways` knows of, within a distance in cells; by its southern or
/// western end.
pub(super) fn nearest_among(
    ways: impl Fn(Point) -> Ways,
    place: (f64, f64),
    within: f64,
) -> Option<(Point, Heading)> {
    let at = nearest_point(place);
    let mut nearest = None;
    let mut least = within * within;
    for heading in ways(at).iter() {
        let far = from_cell(place, at, heading);
        if far <= least {
            least = far;
            nearest = Some(match heading {
                Heading::North | Heading::East => (at, heading),
                Heading::South | Heading::West => (at.step(heading), heading.opposite()),
            });
        }
    }
    nearest
}

/// Where a place lies from a point; none on the point itself.
pub(super) fn heading(from: Point, (x, y): (f64, f64)) -> Option<Heading> {
    let (dx, dy) = (x - f64::from(from.x), y - f64::from(from.y));
    if dx.abs() < 0.1 && dy.abs() < 0.1 {
        return None;
    }
    Some(match (dx.abs() > dy.abs(), dx > 0.0, dy > 0.0) {
        (true, true, _) => Heading::East,
        (true, false, _) => Heading::West,
        (false, _, true) => Heading::North,
        (false, _, false) => Heading::South,
    })
}

/// The distance of two places, squared.
pub(super) fn squared(a: (f64, f64), b: (f64, f64)) -> f64 {
    (a.0 - b.0) * (a.0 - b.0) + (a.1 - b.1) * (a.1 - b.1)
}

/// The distance of a place from the cell that leaves a point, squared.
fn from_cell(place: (f64, f64), at: Point, heading: Heading) -> f64 {
    let (dx, dy) = heading.vector();
    let (x, y) = (f64::from(at.x), f64::from(at.y));
    let along = ((place.0 - x) * f64::from(dx) + (place.1 - y) * f64::from(dy)).clamp(0.0, 1.0);
    squared(place, (x + f64::from(dx) * along, y + f64::from(dy) * along))
}

/// `f64::floor` is not in `core`.
fn floor(v: f64) -> i32 {
    let cut = v as i32;
    if f64::from(cut) > v { cut - 1 } else { cut }
}
