//! Mazes of walls in the pictures of a run: what is solid, and the walls that a robot has seen.

use leptos::prelude::*;

use crate::geometry::{Heading, Point, Ways};
use crate::maze::{Kind, Maze};
use crate::web::paths::{self, UNIT};
use crate::web::state::Lab;

/// Whether the maze is one of walls.
pub fn is(lab: Lab) -> bool {
    lab.stage.with(|maze| maze.kind == Kind::Wall)
}

/// Squares that are closed all round, or that the robot has not seen; `seen` in order, none where all is shown.
pub fn solid(maze: &Maze, seen: Option<&[(Point, Ways)]>) -> String {
    if maze.kind == Kind::Line {
        return String::new();
    }
    let bounds = maze.bounds();
    paths::squares((bounds.sw(), bounds.ne()), |at| match seen {
        None => maze.ways(at).is_empty(),
        Some(seen) => seen.binary_search_by_key(&at, |square| square.0).is_err(),
    })
}

/// The walls of the squares that the robot has seen.
pub fn seen_walls(seen: &[(Point, Ways)]) -> String {
    let mut data = String::new();
    for (at, ways) in seen {
        for heading in Heading::ALL.into_iter().filter(|&heading| !ways.has(heading)) {
            let ((dx, dy), half) = (heading.vector(), UNIT / 2);
            let (x, y) = (at.x * UNIT + (dx - dy) * half, -at.y * UNIT - (dx + dy) * half);
            data.push_str(&format!("M{x} {y}l{} {}", dy * UNIT, dx * UNIT));
        }
    }
    data
}
