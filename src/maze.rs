//! A line maze: which lattice points are joined by black line, where the robot starts and where it must go.
//!
//! A maze may be unfinished (no start, no finish, loose lines).

use alloc::string::String;
use alloc::vec;
use alloc::vec::Vec;

use crate::geometry::{Heading, Point, Ways};

mod bounds;
pub mod checks;
pub mod edit;
pub mod file;
pub mod generate;
pub mod json;
mod lines;
pub mod micromouse;
mod polyline;
pub mod remark;
pub mod samples;
mod scale;
pub mod svg;
pub mod text;
pub mod walls;

pub use bounds::{Bounds, BoundsError, MAX_COORDINATE, MAX_SIDE};
pub use lines::Lines;
pub use remark::{Reading, Remark};
pub use scale::{Scale, ScaleError, millimetres};

/// How a maze is drawn. The lattice underneath is the same: an open side between two squares of a walled
/// maze is a line between two points.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Kind {
    /// Black line on a white floor.
    #[default]
    Line,
    /// Squares with walls between them.
    Wall,
}

/// Where the robot is put down, and the drawing's heading that it faces.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Start {
    /// The lattice point.
    pub at: Point,
    /// In the drawing's frame; it becomes the bot's north.
    pub heading: Heading,
}

/// What is written about a maze.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct About {
    /// A short name.
    pub title: String,
    /// Where it is from.
    pub source: String,
    /// What it teaches.
    pub note: String,
}

/// A line maze on a lattice. Lines never leave the bounds; start and finish points are on the lattice.
///
/// ```
/// use line_maze_lab::geometry::{Heading, Point};
/// use line_maze_lab::maze::{Bounds, Maze};
/// let mut maze = Maze::new(Bounds::new(Point::new(0, 0), Point::new(2, 2))?);
/// assert!(maze.draw(Point::new(0, 0), Heading::North));
/// assert!(maze.has_line(Point::new(0, 1), Heading::South));
/// assert_eq!(maze.cells(), 1);
/// # Ok::<(), line_maze_lab::maze::BoundsError>(())
/// ```
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Maze {
    /// Title, source and teaching note.
    pub about: About,
    /// Drawn as lines or as walls.
    pub kind: Kind,
    /// Sizes on the floor.
    pub scale: Scale,
    bounds: Bounds,
    ways: Vec<Ways>,
    start: Option<Start>,
    finish: Vec<Point>,
}

impl Maze {
    /// An empty maze.
    #[must_use]
    pub fn new(bounds: Bounds) -> Self {
        Self {
            about: About::default(),
            kind: Kind::default(),
            scale: Scale::default(),
            bounds,
            ways: vec![Ways::NONE; bounds.len()],
            start: None,
            finish: Vec::new(),
        }
    }

    /// The lattice's corners.
    #[must_use]
    pub const fn bounds(&self) -> Bounds {
        self.bounds
    }

    /// The ways out of a point, in the drawing's frame; none off the lattice.
    #[must_use]
    pub fn ways(&self, at: Point) -> Ways {
        self.bounds.index(at).map_or(Ways::NONE, |index| self.ways[index])
    }

    /// The ways out of every point, row by row from the south-west.
    pub(crate) fn all_ways(&self) -> &[Ways] {
        &self.ways
    }

    /// Whether a line leaves the point in this direction.
    #[must_use]
    pub fn has_line(&self, at: Point, heading: Heading) -> bool {
        self.ways(at).has(heading)
    }

    /// Draws one cell of line. Returns whether that changed anything: not where it is there already, or
    /// would leave the lattice.
    pub fn draw(&mut self, at: Point, heading: Heading) -> bool {
        self.set(at, heading, Ways::with)
    }

    /// Erases one cell of line. Returns whether there was one.
    pub fn erase(&mut self, at: Point, heading: Heading) -> bool {
        self.set(at, heading, Ways::without)
    }

    fn set(&mut self, at: Point, heading: Heading, change: fn(Ways, Heading) -> Ways) -> bool {
        let (Some(a), Some(b)) = (self.bounds.index(at), self.bounds.index(at.step(heading))) else {
            return false;
        };
        let before = self.ways[a];
        self.ways[a] = change(before, heading);
        self.ways[b] = change(self.ways[b], heading.opposite());
        self.ways[a] != before
    }

    /// Where the robot is put down, if that is known.
    #[must_use]
    pub const fn start(&self) -> Option<Start> {
        self.start
    }

    /// Sets or removes the start. Returns whether it is on the lattice; if not, nothing changes.
    pub fn set_start(&mut self, start: Option<Start>) -> bool {
        let fits = start.is_none_or(|start| self.bounds.contains(start.at));
        if fits {
            self.start = start;
        }
        fits
    }

    /// The finish: no point, one, or several; sorted, without doubles.
    #[must_use]
    pub fn finish(&self) -> &[Point] {
        &self.finish
    }

    /// Whether the point is (part of) the finish.
    #[must_use]
    pub fn is_finish(&self, at: Point) -> bool {
        self.finish.binary_search(&at).is_ok()
    }

    /// Sets the finish points. Returns whether all are on the lattice; if not, nothing changes.
    pub fn set_finish(&mut self, mut finish: Vec<Point>) -> bool {
        let fits = finish.iter().all(|&at| self.bounds.contains(at));
        if fits {
            finish.sort_unstable();
            finish.dedup();
            self.finish = finish;
        }
        fits
    }

    /// A maze to begin with: no lines yet, or, of walls, only the outer ones, and a mouse in the south-west corner
    /// as the contests have it.
    #[must_use]
    pub fn blank(bounds: Bounds, kind: Kind) -> Self {
        let mut maze = Self::new(bounds);
        maze.kind = kind;
        if kind == Kind::Wall {
            for (at, heading) in bounds.points().flat_map(|at| [(at, Heading::North), (at, Heading::East)]) {
                maze.draw(at, heading);
            }
            maze.set_start(Some(Start { at: bounds.sw(), heading: Heading::North }));
        }
        maze
    }

    /// The same maze on another lattice: what does not fit is cut off.
    #[must_use]
    pub fn resized(&self, bounds: Bounds) -> Self {
        let mut resized = Self::new(bounds);
        resized.about = self.about.clone();
        resized.kind = self.kind;
        resized.scale = self.scale;
        for (at, heading) in self.lines() {
            resized.draw(at, heading);
        }
        resized.set_start(self.start.filter(|start| bounds.contains(start.at)));
        resized.set_finish(self.finish.iter().copied().filter(|&at| bounds.contains(at)).collect());
        resized
    }

    /// Every cell of line once, named by its southern or western end (so the heading is north or east).
    pub fn lines(&self) -> impl Iterator<Item = (Point, Heading)> {
        self.joined_points().flat_map(|(at, ways)| {
            [Heading::North, Heading::East].into_iter().filter(move |&h| ways.has(h)).map(move |h| (at, h))
        })
    }

    /// The points that have line on them, with their ways.
    pub fn joined_points(&self) -> impl Iterator<Item = (Point, Ways)> {
        self.ways
            .iter()
            .enumerate()
            .filter(|(_, ways)| !ways.is_empty())
            .map(|(index, &ways)| (self.bounds.point(index), ways))
    }

    /// Cells of line.
    #[must_use]
    pub fn cells(&self) -> usize {
        self.ways.iter().map(|ways| ways.count() as usize).sum::<usize>() / 2
    }

    /// Nodes in the book's sense (§2.4.1): points with three or four ways.
    #[must_use]
    pub fn nodes(&self) -> usize {
        self.ways.iter().filter(|ways| ways.count() > 2).count()
    }

    /// Independent loops: cells − joined points + separate pieces.
    #[must_use]
    pub fn loops(&self) -> usize {
        let points = self.ways.iter().filter(|ways| !ways.is_empty()).count();
        self.cells() + self.pieces() - points
    }

    /// Pieces of line that do not touch each other.
    fn pieces(&self) -> usize {
        let mut seen = vec![false; self.ways.len()];
        let mut pieces = 0;
        for (at, _) in self.joined_points() {
            if self.flood(at, &mut seen) {
                pieces += 1;
            }
        }
        pieces
    }

    /// Marks everything that can be reached along lines; false where `from` was marked already.
    pub(crate) fn flood(&self, from: Point, seen: &mut [bool]) -> bool {
        let Some(first) = self.bounds.index(from) else { return false };
        if core::mem::replace(&mut seen[first], true) {
            return false;
        }
        let mut todo = vec![from];
        while let Some(at) = todo.pop() {
            for next in self.ways(at).iter().map(|heading| at.step(heading)) {
                if let Some(index) = self.bounds.index(next)
                    && !core::mem::replace(&mut seen[index], true)
                {
                    todo.push(next);
                }
            }
        }
        true
    }
}
