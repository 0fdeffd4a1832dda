//! A line maze: which lattice points are joined by black line, where the robot starts and where it must go.
//!
//! A maze may be unfinished (no start, no finish, loose lines).

use alloc::string::String;
use alloc::vec;
use alloc::vec::Vec;
use core::fmt;

use crate::geometry::{Heading, Point, Ways};

/// The most lattice points along one side of a maze.
pub const MAX_SIDE: u32 = 1000;
/// Lattice coordinates stay within this distance of the origin.
pub const MAX_COORDINATE: i32 = 1_000_000;

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

/// The lattice's corners, both included.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Bounds {
    sw: Point,
    ne: Point,
}

/// Why a lattice cannot have these corners.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum BoundsError {
    /// The north-east corner is south or west of the south-west corner.
    Reversed,
    /// More than [`MAX_SIDE`] points along a side.
    TooLarge,
    /// A corner is further than [`MAX_COORDINATE`] from the origin.
    TooFar,
}

impl fmt::Display for BoundsError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Reversed => write!(f, "bounds go from the south-west to the north-east corner"),
            Self::TooLarge => write!(f, "a maze has at most {MAX_SIDE} × {MAX_SIDE} points"),
            Self::TooFar => write!(f, "coordinates go from −{MAX_COORDINATE} to {MAX_COORDINATE}"),
        }
    }
}

impl core::error::Error for BoundsError {}

impl Bounds {
    /// The lattice from its south-west to its north-east corner.
    ///
    /// # Errors
    /// Where the corners are swapped, too far from the origin, or more than [`MAX_SIDE`] points apart.
    pub const fn new(sw: Point, ne: Point) -> Result<Self, BoundsError> {
        const fn far(p: Point) -> bool {
            p.x.unsigned_abs() > MAX_COORDINATE as u32 || p.y.unsigned_abs() > MAX_COORDINATE as u32
        }
        if far(sw) || far(ne) {
            Err(BoundsError::TooFar)
        } else if ne.x < sw.x || ne.y < sw.y {
            Err(BoundsError::Reversed)
        } else if ne.x.abs_diff(sw.x) >= MAX_SIDE || ne.y.abs_diff(sw.y) >= MAX_SIDE {
            Err(BoundsError::TooLarge)
        } else {
            Ok(Self { sw, ne })
        }
    }

    /// The smallest lattice that holds all the points.
    ///
    /// # Errors
    /// As [`Bounds::new`]; `Reversed` where there is no point at all.
    pub fn around(points: impl IntoIterator<Item = Point>) -> Result<Self, BoundsError> {
        let mut points = points.into_iter();
        let first = points.next().ok_or(BoundsError::Reversed)?;
        let (sw, ne) = points.fold((first, first), |(sw, ne), p| {
            (Point::new(sw.x.min(p.x), sw.y.min(p.y)), Point::new(ne.x.max(p.x), ne.y.max(p.y)))
        });
        Self::new(sw, ne)
    }

    /// The south-west corner.
    #[must_use]
    pub const fn sw(self) -> Point {
        self.sw
    }

    /// The north-east corner.
    #[must_use]
    pub const fn ne(self) -> Point {
        self.ne
    }

    /// Points from west to east, at least 1.
    #[must_use]
    pub const fn width(self) -> u32 {
        self.ne.x.abs_diff(self.sw.x) + 1
    }

    /// Points from south to north, at least 1.
    #[must_use]
    pub const fn height(self) -> u32 {
        self.ne.y.abs_diff(self.sw.y) + 1
    }

    /// Whether the point is on this lattice.
    #[must_use]
    pub const fn contains(self, p: Point) -> bool {
        self.sw.x <= p.x && p.x <= self.ne.x && self.sw.y <= p.y && p.y <= self.ne.y
    }

    /// The nearest point of this lattice.
    #[must_use]
    pub fn clamp(self, p: Point) -> Point {
        Point::new(p.x.clamp(self.sw.x, self.ne.x), p.y.clamp(self.sw.y, self.ne.y))
    }

    /// How many points.
    #[must_use]
    pub const fn len(self) -> usize {
        self.width() as usize * self.height() as usize
    }

    /// Never: a lattice has at least one point.
    #[must_use]
    pub const fn is_empty(self) -> bool {
        false
    }

    /// The place of a point in row order from the south-west corner.
    #[must_use]
    pub const fn index(self, p: Point) -> Option<usize> {
        if self.contains(p) {
            Some(p.y.abs_diff(self.sw.y) as usize * self.width() as usize + p.x.abs_diff(self.sw.x) as usize)
        } else {
            None
        }
    }

    /// The inverse of [`Bounds::index`].
    #[must_use]
    pub const fn point(self, index: usize) -> Point {
        let width = self.width() as usize;
        Point::new(self.sw.x + (index % width) as i32, self.sw.y + (index / width) as i32)
    }

    /// Every point, row by row from the south-west corner.
    pub fn points(self) -> impl Iterator<Item = Point> {
        (0..self.len()).map(move |index| self.point(index))
    }
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

/// Sizes on the floor, in millimetres.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Scale {
    cell_mm: f64,
    line_mm: f64,
}

/// Why sizes on the floor make no sense.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum ScaleError {
    /// `cell_mm` is not between 1 and 10,000.
    Cell,
    /// `line_mm` is not between 0.1 and `cell_mm`.
    Line,
}

impl fmt::Display for ScaleError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Cell => write!(f, "a cell is 1 to 10000 mm long"),
            Self::Line => write!(f, "a line is at least 0.1 mm wide, and narrower than a cell is long"),
        }
    }
}

impl core::error::Error for ScaleError {}

impl Scale {
    /// A cell's length and a line's width.
    ///
    /// # Errors
    /// Where one of them is out of its range.
    pub fn new(cell_mm: f64, line_mm: f64) -> Result<Self, ScaleError> {
        if !(1.0..=10_000.0).contains(&cell_mm) {
            Err(ScaleError::Cell)
        } else if !(0.1..=cell_mm).contains(&line_mm) {
            Err(ScaleError::Line)
        } else {
            Ok(Self { cell_mm, line_mm })
        }
    }

    /// Length of one cell, 1 to 10,000 mm.
    #[must_use]
    pub const fn cell_mm(self) -> f64 {
        self.cell_mm
    }

    /// Width of the line, 0.1 mm to a cell.
    #[must_use]
    pub const fn line_mm(self) -> f64 {
        self.line_mm
    }
}

impl Default for Scale {
    fn default() -> Self {
        Self { cell_mm: 200.0, line_mm: 20.0 }
    }
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
#[derive(Clone, Debug, PartialEq)]
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
