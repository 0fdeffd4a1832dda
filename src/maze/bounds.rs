//! The lattice that a maze lies on: its corners, and how its points are numbered.

use alloc::vec::Vec;
use core::fmt;

use crate::geometry::Point;

/// The most lattice points along one side of a maze.
pub const MAX_SIDE: u32 = 1000;
/// Lattice coordinates stay within this distance of the origin.
pub const MAX_COORDINATE: i32 = 1_000_000;

/// The lattice's corners, both included; by default both are the origin.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
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
            Self::Reversed => {
                f.write_str("the first corner is the south-west one, the second the north-east one")
            }
            Self::TooLarge => f.write_str("a maze has at most 1,000 × 1,000 points"),
            Self::TooFar => f.write_str("coordinates go from −1,000,000 to 1,000,000"),
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

    /// The points around the middle, where micromouse contests have the finish: one, two or four.
    ///
    /// ```
    /// use line_maze_lab::geometry::Point;
    /// use line_maze_lab::maze::Bounds;
    /// let field = Bounds::new(Point::new(0, 0), Point::new(15, 14))?;
    /// assert_eq!(field.centre(), [Point::new(7, 7), Point::new(8, 7)]);
    /// # Ok::<(), line_maze_lab::maze::BoundsError>(())
    /// ```
    #[must_use]
    pub fn centre(self) -> Vec<Point> {
        let middle = |from: i32, count: u32| {
            let (low, high) = ((count - 1) / 2, count / 2);
            [from + low.cast_signed(), from + high.cast_signed()]
        };
        let (xs, ys) = (middle(self.sw.x, self.width()), middle(self.sw.y, self.height()));
        let mut points: Vec<Point> = xs.into_iter().flat_map(|x| ys.map(|y| Point::new(x, y))).collect();
        points.sort_unstable();
        points.dedup();
        points
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
