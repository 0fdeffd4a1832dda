//! Cells of lattice as SVG path data, in picture units of [`UNIT`] a cell, y down. Cells in a row become one
//! stroke, so that large mazes stay quick to draw.

use std::fmt::Write;

use crate::geometry::{Heading, Point};
use crate::maze::{Bounds, Kind, Maze};

/// Picture units a cell.
pub const UNIT: i32 = 80;

/// A part of a lattice, for pictures that are drawn in pieces.
pub const TILE: i32 = 20;

/// The tiles that cover a lattice, each by its own corners.
#[must_use]
pub fn tiles(bounds: Bounds) -> Vec<(Point, Point)> {
    let corners =
        |from: i32, to: i32| (from..=to).step_by(TILE as usize).map(move |at| (at, (at + TILE - 1).min(to)));
    let (sw, ne) = (bounds.sw(), bounds.ne());
    let columns = || corners(sw.x, ne.x);
    corners(sw.y, ne.y)
        .flat_map(|(y0, y1)| columns().map(move |(x0, x1)| (Point::new(x0, y0), Point::new(x1, y1))))
        .collect()
}

/// Path data of all cells between two corners that `has` says yes to; a cell is named by its southern or
/// western end.
pub fn cells((sw, ne): (Point, Point), has: impl Fn(Point, Heading) -> bool) -> String {
    let mut data = String::new();
    for y in sw.y..=ne.y {
        runs(
            sw.x,
            ne.x,
            |x| has(Point::new(x, y), Heading::East),
            |from, to| {
                let _ = write!(data, "M{} {}H{}", from * UNIT, -y * UNIT, to * UNIT);
            },
        );
    }
    for x in sw.x..=ne.x {
        runs(
            sw.y,
            ne.y,
            |y| has(Point::new(x, y), Heading::North),
            |from, to| {
                let _ = write!(data, "M{} {}V{}", x * UNIT, -from * UNIT, -to * UNIT);
            },
        );
    }
    data
}

/// Path data of the walls on the squares' southern and western sides between two corners, and on the outer sides
/// where the lattice ends; `open` says where there is none. A post that no wall touches is a stroke of no length.
pub fn walls(bounds: Bounds, (sw, ne): (Point, Point), open: impl Fn(Point, Heading) -> bool) -> String {
    const HALF: i32 = UNIT / 2;
    let mut data = String::new();
    let end = |at: i32, last: i32| at + i32::from(at == last);
    for y in sw.y..=end(ne.y, bounds.ne().y) {
        runs(
            sw.x,
            ne.x,
            |x| !open(Point::new(x, y), Heading::South),
            |from, to| {
                let _ = write!(data, "M{} {}H{}", from * UNIT - HALF, HALF - y * UNIT, to * UNIT - HALF);
            },
        );
    }
    for x in sw.x..=end(ne.x, bounds.ne().x) {
        runs(
            sw.y,
            ne.y,
            |y| !open(Point::new(x, y), Heading::West),
            |from, to| {
                let _ = write!(data, "M{} {}V{}", x * UNIT - HALF, HALF - from * UNIT, HALF - to * UNIT);
            },
        );
    }
    for (x, y) in (sw.y..=ne.y).flat_map(|y| (sw.x..=ne.x).map(move |x| (x, y))) {
        let (at, across) = (Point::new(x, y), Point::new(x - 1, y - 1));
        let free = |at, sides: [Heading; 2]| sides.into_iter().all(|side| open(at, side));
        if free(at, [Heading::South, Heading::West]) && free(across, [Heading::North, Heading::East]) {
            let _ = write!(data, "M{} {}h0", x * UNIT - HALF, HALF - y * UNIT);
        }
    }
    data
}

/// Path data of all squares between two corners that `is` says yes to, a row of them as one piece.
pub fn squares((sw, ne): (Point, Point), is: impl Fn(Point) -> bool) -> String {
    const HALF: i32 = UNIT / 2;
    let mut data = String::new();
    for y in sw.y..=ne.y {
        runs(
            sw.x,
            ne.x,
            |x| is(Point::new(x, y)),
            |from, to| {
                let (left, right) = (from * UNIT - HALF, to * UNIT - HALF);
                let _ = write!(data, "M{left} {}H{right}v{UNIT}H{left}z", -y * UNIT - HALF);
            },
        );
    }
    data
}

/// Path data of what a maze is drawn with, between two corners: its line, or its walls.
#[must_use]
pub fn drawn(maze: &Maze, corners: (Point, Point)) -> String {
    let has = |at, heading| maze.has_line(at, heading);
    match maze.kind {
        Kind::Line => cells(corners, has),
        Kind::Wall => walls(maze.bounds(), corners, has),
    }
}

/// The longest runs of cells along a line.
fn runs(first: i32, last: i32, has: impl Fn(i32) -> bool, mut run: impl FnMut(i32, i32)) {
    let mut begin = None;
    for at in first..=last {
        match (has(at), begin) {
            (true, None) => begin = Some(at),
            (false, Some(from)) => {
                run(from, at);
                begin = None;
            }
            _ => {}
        }
    }
    if let Some(from) = begin {
        run(from, last + 1);
    }
}

/// Path data of a line through lattice points.
pub fn line(points: impl IntoIterator<Item = Point>) -> String {
    let mut data = String::new();
    for point in points {
        let _ =
            write!(data, "{}{} {}", if data.is_empty() { "M" } else { "L" }, point.x * UNIT, -point.y * UNIT);
    }
    data
}
