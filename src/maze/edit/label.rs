//! Edits in words, for “Undo …” and “Redo …”.

use alloc::format;
use alloc::string::{String, ToString};

use super::{Change, Whole};
use crate::geometry::Point;
use crate::maze::{About, Kind, Maze, Start};

/// What was done to the maze, when `change` would take it back.
pub(super) fn done(maze: &Maze, change: &Change) -> String {
    match change {
        Change::Erased(cells) => draw(maze.kind, cells.len()),
        Change::Drawn(cells) => erase(maze.kind, cells.len()),
        Change::Start(before) => start(*before, maze.start()).to_string(),
        Change::Finish(before) => finish(before, maze.finish()).to_string(),
        Change::About(before) => about(before, &maze.about).to_string(),
        Change::Scale(_) => SCALE.to_string(),
        Change::Kind(_) => kind(maze.kind).to_string(),
        Change::Maze(_, how) => whole(*how).to_string(),
    }
}

/// What `change` will do to the maze.
pub(super) fn to_do(maze: &Maze, change: &Change) -> String {
    match change {
        Change::Drawn(cells) => draw(maze.kind, cells.len()),
        Change::Erased(cells) => erase(maze.kind, cells.len()),
        Change::Start(after) => start(maze.start(), *after).to_string(),
        Change::Finish(after) => finish(maze.finish(), after).to_string(),
        Change::About(after) => about(&maze.about, after).to_string(),
        Change::Scale(_) => SCALE.to_string(),
        Change::Kind(after) => kind(*after).to_string(),
        Change::Maze(_, how) => whole(*how).to_string(),
    }
}

const SCALE: &str = "change the sizes";

fn draw(kind: Kind, cells: usize) -> String {
    match kind {
        Kind::Line => format!("draw {}", counted(cells, "cell")),
        Kind::Wall => format!("open {}", counted(cells, "wall")),
    }
}

fn erase(kind: Kind, cells: usize) -> String {
    match kind {
        Kind::Line => format!("erase {}", counted(cells, "cell")),
        Kind::Wall => format!("build {}", counted(cells, "wall")),
    }
}

fn counted(count: usize, what: &str) -> String {
    format!("{count} {what}{}", if count == 1 { "" } else { "s" })
}

fn start(before: Option<Start>, after: Option<Start>) -> &'static str {
    match (before, after) {
        (_, None) => "remove the start",
        (None, Some(_)) => "set the start",
        (Some(before), Some(after)) if before.at == after.at => "turn the start",
        (Some(_), Some(_)) => "move the start",
    }
}

fn finish(before: &[Point], after: &[Point]) -> &'static str {
    match (before.len(), after.len()) {
        (0, _) => "set the finish",
        (_, 0) => "remove the finish",
        (before, after) if before < after => "add a finish point",
        (before, after) if before > after => "remove a finish point",
        _ => "move the finish",
    }
}

fn about(before: &About, after: &About) -> &'static str {
    match (before.title != after.title, before.source != after.source, before.note != after.note) {
        (true, false, false) => "change the title",
        (false, true, false) => "change the source",
        (false, false, true) => "change the note",
        _ => "change the description",
    }
}

const fn kind(kind: Kind) -> &'static str {
    match kind {
        Kind::Line => "draw it as lines",
        Kind::Wall => "draw it as walls",
    }
}

const fn whole(how: Whole) -> &'static str {
    match how {
        Whole::Resized => "change the lattice",
        Whole::Replaced => "replace the maze",
    }
}
