//! Edits that can be taken back: a maze, what was done to it, and what was undone.
//!
//! An edit keeps only what it changed, so a history of any length is small. What it keeps is turned round
//! when it is undone, and turned round again when it is redone.

mod label;
pub mod walls;

use alloc::boxed::Box;
use alloc::string::String;
use alloc::vec::Vec;

use super::{About, Bounds, Kind, Maze, Scale, Start};
use crate::geometry::{Heading, Point};

/// A change that someone wants.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Edit {
    /// Draws cells of line; what is off the lattice is left out.
    Draw(Vec<(Point, Heading)>),
    /// Erases cells of line.
    Erase(Vec<(Point, Heading)>),
    /// Puts the start somewhere, or takes it away; off the lattice nothing happens.
    Start(Option<Start>),
    /// Sets all finish points; those off the lattice are left out.
    Finish(Vec<Point>),
    /// Title, source and note.
    About(About),
    /// Sizes on the floor.
    Scale(Scale),
    /// Lines or walls.
    Kind(Kind),
    /// Another lattice; what does not fit is cut off.
    Bounds(Bounds),
    /// Another maze altogether.
    Replace(Box<Maze>),
}

/// What an edit changed: applied, it gives its own inverse.
#[derive(Clone, Debug)]
enum Change {
    Drawn(Vec<(Point, Heading)>),
    Erased(Vec<(Point, Heading)>),
    Start(Option<Start>),
    Finish(Vec<Point>),
    About(Box<About>),
    Scale(Scale),
    Kind(Kind),
    /// The whole maze before (or after) and what happened to it.
    Maze(Box<Maze>, Whole),
}

/// How a whole maze changed.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Whole {
    Resized,
    Replaced,
}

/// A maze and how it came to be.
///
/// ```
/// use line_maze_lab::geometry::Point;
/// use line_maze_lab::maze::edit::{Edit, History, stroke};
/// use line_maze_lab::maze::{Bounds, Maze};
/// let bounds = Bounds::new(Point::new(0, 0), Point::new(4, 4))?;
/// let mut history = History::new(Maze::new(bounds));
/// assert!(history.apply(Edit::Draw(stroke(Point::new(0, 0), Point::new(3, 1)))));
/// assert_eq!(history.undo_label().as_deref(), Some("draw 4 cells"));
/// assert!(history.undo());
/// assert_eq!(history.maze().cells(), 0);
/// # Ok::<(), line_maze_lab::maze::BoundsError>(())
/// ```
#[derive(Clone, Debug)]
pub struct History {
    maze: Maze,
    /// What would take back each edit, the last one at the end.
    undo: Vec<Change>,
    redo: Vec<Change>,
}

impl History {
    /// The history of a maze to which nothing was done yet.
    #[must_use]
    pub const fn new(maze: Maze) -> Self {
        Self { maze, undo: Vec::new(), redo: Vec::new() }
    }

    /// The maze as it is now.
    #[must_use]
    pub const fn maze(&self) -> &Maze {
        &self.maze
    }

    /// Does it. Returns whether that changed anything; if not, there is nothing to undo, and what was undone
    /// can still be done again.
    pub fn apply(&mut self, edit: Edit) -> bool {
        let inverse = match edit {
            Edit::Draw(mut cells) => {
                cells.retain(|&(at, heading)| self.maze.draw(at, heading));
                (!cells.is_empty()).then_some(Change::Erased(cells))
            }
            Edit::Erase(mut cells) => {
                cells.retain(|&(at, heading)| self.maze.erase(at, heading));
                (!cells.is_empty()).then_some(Change::Drawn(cells))
            }
            Edit::Start(start) => {
                let fits = start.is_none_or(|start| self.maze.bounds().contains(start.at));
                (fits && start != self.maze.start()).then(|| self.swap(Change::Start(start)))
            }
            Edit::Finish(mut finish) => {
                finish.retain(|&at| self.maze.bounds().contains(at));
                finish.sort_unstable();
                finish.dedup();
                (finish != self.maze.finish()).then(|| self.swap(Change::Finish(finish)))
            }
            Edit::About(about) => {
                (about != self.maze.about).then(|| self.swap(Change::About(Box::new(about))))
            }
            Edit::Scale(scale) => (scale != self.maze.scale).then(|| self.swap(Change::Scale(scale))),
            Edit::Kind(kind) => (kind != self.maze.kind).then(|| self.swap(Change::Kind(kind))),
            Edit::Bounds(bounds) => {
                let resized = (self.maze.bounds() != bounds).then(|| Box::new(self.maze.resized(bounds)));
                resized.map(|maze| self.swap(Change::Maze(maze, Whole::Resized)))
            }
            Edit::Replace(other) => {
                (*other != self.maze).then(|| self.swap(Change::Maze(other, Whole::Replaced)))
            }
        };
        let Some(inverse) = inverse else { return false };
        self.undo.push(inverse);
        self.redo.clear();
        true
    }

    /// Takes back the last edit. Returns whether there was one.
    pub fn undo(&mut self) -> bool {
        let Some(change) = self.undo.pop() else { return false };
        let inverse = self.swap(change);
        self.redo.push(inverse);
        true
    }

    /// Does again what was undone last. Returns whether there was something.
    pub fn redo(&mut self) -> bool {
        let Some(change) = self.redo.pop() else { return false };
        let inverse = self.swap(change);
        self.undo.push(inverse);
        true
    }

    /// Whether there is something to take back.
    #[must_use]
    pub const fn can_undo(&self) -> bool {
        !self.undo.is_empty()
    }

    /// Whether there is something to do again.
    #[must_use]
    pub const fn can_redo(&self) -> bool {
        !self.redo.is_empty()
    }

    /// What [`History::undo`] would take back, such as `draw 4 cells`.
    #[must_use]
    pub fn undo_label(&self) -> Option<String> {
        self.undo.last().map(|change| label::done(&self.maze, change))
    }

    /// What [`History::redo`] would do again.
    #[must_use]
    pub fn redo_label(&self) -> Option<String> {
        self.redo.last().map(|change| label::to_do(&self.maze, change))
    }

    /// Makes the change; returns what takes it back.
    fn swap(&mut self, change: Change) -> Change {
        let maze = &mut self.maze;
        match change {
            Change::Drawn(cells) => {
                for &(at, heading) in &cells {
                    maze.draw(at, heading);
                }
                Change::Erased(cells)
            }
            Change::Erased(cells) => {
                for &(at, heading) in &cells {
                    maze.erase(at, heading);
                }
                Change::Drawn(cells)
            }
            Change::Start(start) => {
                let before = maze.start();
                maze.set_start(start);
                Change::Start(before)
            }
            Change::Finish(finish) => {
                let before = maze.finish().to_vec();
                maze.set_finish(finish);
                Change::Finish(before)
            }
            Change::About(mut about) => {
                core::mem::swap(&mut maze.about, &mut about);
                Change::About(about)
            }
            Change::Scale(scale) => Change::Scale(core::mem::replace(&mut maze.scale, scale)),
            Change::Kind(kind) => Change::Kind(core::mem::replace(&mut maze.kind, kind)),
            Change::Maze(mut other, whole) => {
                core::mem::swap(maze, &mut other);
                Change::Maze(other, whole)
            }
        }
    }
}

/// The cells that a pointer follows from one lattice point to another: along the axes, the longer way
/// first (east or west, if both are as long). Each cell is named by where it begins and where it leads.
///
/// ```
/// use line_maze_lab::geometry::{Heading, Point};
/// use line_maze_lab::maze::edit::stroke;
/// let cells = stroke(Point::new(0, 0), Point::new(-1, 2));
/// assert_eq!(cells[0], (Point::new(0, 0), Heading::North));
/// assert_eq!(cells[2], (Point::new(0, 2), Heading::West));
/// ```
#[must_use]
pub fn stroke(from: Point, to: Point) -> Vec<(Point, Heading)> {
    let (dx, dy) = (from.x.abs_diff(to.x), from.y.abs_diff(to.y));
    let across = (if to.x > from.x { Heading::East } else { Heading::West }, dx);
    let along = (if to.y > from.y { Heading::North } else { Heading::South }, dy);
    let legs = if dy > dx { [along, across] } else { [across, along] };
    let mut at = from;
    let mut cells = Vec::new();
    for (heading, length) in legs {
        for _ in 0..length {
            cells.push((at, heading));
            at = at.step(heading);
        }
    }
    cells
}
