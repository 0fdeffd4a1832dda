//! The square lattice and its directions: where a point is, which way is which, and how turns add up.
//!
//! [`Heading`] is absolute in some frame (the drawing's, or the bot's own), [`Turn`] is relative to the
//! robot. Table 2.3 of the book is [`Heading::turned`].

use core::fmt;
use core::str::FromStr;

mod ways;

pub use ways::Ways;

/// A lattice point: `x` to the east, `y` to the north, in cells.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct Point {
    /// Cells east of the origin.
    pub x: i32,
    /// Cells north of the origin.
    pub y: i32,
}

impl Point {
    /// The point `x` cells east and `y` cells north of the origin.
    #[must_use]
    pub const fn new(x: i32, y: i32) -> Self {
        Self { x, y }
    }

    /// The neighbour one cell away.
    #[must_use]
    pub const fn step(self, heading: Heading) -> Self {
        self.ahead(heading, 1)
    }

    /// The point `cells` away.
    #[must_use]
    pub const fn ahead(self, heading: Heading, cells: i32) -> Self {
        let (dx, dy) = heading.vector();
        Self::new(self.x + dx * cells, self.y + dy * cells)
    }

    /// A place relative to the origin as the bot sees it, when `north` is the drawing's name of the bot's
    /// north.
    ///
    /// ```
    /// use line_maze_lab::geometry::{Heading, Point};
    /// assert_eq!(Point::new(3, 1).in_frame_of(Heading::East), Point::new(-1, 3));
    /// ```
    #[must_use]
    pub const fn in_frame_of(self, north: Heading) -> Self {
        let (dx, dy) = north.vector();
        Self::new(self.x * dy - self.y * dx, self.x * dx + self.y * dy)
    }

    /// The inverse of [`Point::in_frame_of`].
    #[must_use]
    pub const fn out_of_frame_of(self, north: Heading) -> Self {
        let (dx, dy) = north.vector();
        Self::new(self.x * dy + self.y * dx, self.y * dy - self.x * dx)
    }

    /// Cells between two points along the axes.
    #[must_use]
    pub const fn distance(self, other: Self) -> u32 {
        self.x.abs_diff(other.x) + self.y.abs_diff(other.y)
    }
}

impl fmt::Display for Point {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{},{}", self.x, self.y)
    }
}

/// An absolute direction. In the drawing's frame `North` is up; in the bot's frame `North` is where the
/// bot faced when it was put down (book §2.2), and the numbers 0 to 3 are the book's.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, PartialOrd, Ord, Hash)]
#[repr(u8)]
pub enum Heading {
    /// 0
    #[default]
    North = 0,
    /// 1
    East = 1,
    /// 2
    South = 2,
    /// 3
    West = 3,
}

impl Heading {
    /// All four, clockwise from north.
    pub const ALL: [Self; 4] = [Self::North, Self::East, Self::South, Self::West];

    /// The heading whose number is `index` modulo 4.
    #[must_use]
    pub const fn from_index(index: u8) -> Self {
        match index & 3 {
            0 => Self::North,
            1 => Self::East,
            2 => Self::South,
            _ => Self::West,
        }
    }

    /// The book's number of this direction, 0 to 3.
    #[must_use]
    pub const fn index(self) -> u8 {
        self as u8
    }

    /// Table 2.3: the heading after a turn.
    ///
    /// ```
    /// use line_maze_lab::geometry::{Heading, Turn};
    /// assert_eq!(Heading::West.turned(Turn::Right), Heading::North);
    /// ```
    #[must_use]
    pub const fn turned(self, turn: Turn) -> Self {
        Self::from_index(self as u8 + turn as u8)
    }

    /// The turn that leads from this heading to `to`.
    #[must_use]
    pub const fn turn_to(self, to: Self) -> Turn {
        Turn::from_index(to as u8 + 4 - self as u8)
    }

    /// The other way round.
    #[must_use]
    pub const fn opposite(self) -> Self {
        self.turned(Turn::Back)
    }

    /// A drawing's heading as the bot numbers it, when `north` is the drawing's name of the bot's north.
    ///
    /// ```
    /// use line_maze_lab::geometry::Heading;
    /// assert_eq!(Heading::South.in_frame_of(Heading::East), Heading::East);
    /// ```
    #[must_use]
    pub const fn in_frame_of(self, north: Self) -> Self {
        Self::from_index(self as u8 + 4 - north as u8)
    }

    /// The inverse of [`Heading::in_frame_of`].
    #[must_use]
    pub const fn out_of_frame_of(self, north: Self) -> Self {
        Self::from_index(self as u8 + north as u8)
    }

    /// Change of `(x, y)` for one cell.
    #[must_use]
    pub const fn vector(self) -> (i32, i32) {
        match self {
            Self::North => (0, 1),
            Self::East => (1, 0),
            Self::South => (0, -1),
            Self::West => (-1, 0),
        }
    }

    /// `N`, `E`, `S` or `W`.
    #[must_use]
    pub const fn letter(self) -> char {
        match self {
            Self::North => 'N',
            Self::East => 'E',
            Self::South => 'S',
            Self::West => 'W',
        }
    }

    /// The word for it: `north`, `east`, `south`, `west`.
    #[must_use]
    pub const fn word(self) -> &'static str {
        match self {
            Self::North => "north",
            Self::East => "east",
            Self::South => "south",
            Self::West => "west",
        }
    }

    /// The heading that a letter names.
    #[must_use]
    pub const fn from_letter(letter: char) -> Option<Self> {
        match letter {
            'N' => Some(Self::North),
            'E' => Some(Self::East),
            'S' => Some(Self::South),
            'W' => Some(Self::West),
            _ => None,
        }
    }
}

/// A direction relative to the robot; the number is what it adds to the heading.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
#[repr(u8)]
pub enum Turn {
    /// `S`: go on ahead.
    Straight = 0,
    /// `R`: 90° clockwise.
    Right = 1,
    /// `B`: turn round.
    Back = 2,
    /// `L`: 90° anticlockwise.
    Left = 3,
}

impl Turn {
    /// All four, clockwise from straight.
    pub const ALL: [Self; 4] = [Self::Straight, Self::Right, Self::Back, Self::Left];

    /// The turn whose number is `index` modulo 4.
    #[must_use]
    pub const fn from_index(index: u8) -> Self {
        match index & 3 {
            0 => Self::Straight,
            1 => Self::Right,
            2 => Self::Back,
            _ => Self::Left,
        }
    }

    /// `S`, `R`, `B` or `L`, as in a turn list.
    #[must_use]
    pub const fn letter(self) -> char {
        match self {
            Self::Straight => 'S',
            Self::Right => 'R',
            Self::Back => 'B',
            Self::Left => 'L',
        }
    }

    /// The turn that a letter names.
    #[must_use]
    pub const fn from_letter(letter: char) -> Option<Self> {
        match letter {
            'S' => Some(Self::Straight),
            'R' => Some(Self::Right),
            'B' => Some(Self::Back),
            'L' => Some(Self::Left),
            _ => None,
        }
    }
}

impl fmt::Display for Heading {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{}", self.letter())
    }
}

impl FromStr for Heading {
    type Err = ();

    fn from_str(text: &str) -> Result<Self, ()> {
        let mut letters = text.chars();
        match (letters.next().and_then(Self::from_letter), letters.next()) {
            (Some(heading), None) => Ok(heading),
            _ => Err(()),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn table_2_3_of_the_book() {
        for heading in Heading::ALL {
            let d = heading.index();
            assert_eq!(heading.turned(Turn::Right).index(), (d + 1) % 4);
            assert_eq!(heading.turned(Turn::Left).index(), (d + 3) % 4);
            assert_eq!(heading.turned(Turn::Back).index(), (d + 2) % 4);
            assert_eq!(heading.turned(Turn::Straight), heading);
        }
    }

    #[test]
    fn a_turn_is_the_difference_of_two_headings() {
        for from in Heading::ALL {
            for to in Heading::ALL {
                assert_eq!(from.turned(from.turn_to(to)), to);
            }
        }
    }

    #[test]
    fn frames_are_rotations() {
        for north in Heading::ALL {
            assert_eq!(north.in_frame_of(north), Heading::North);
            for bits in 0..16 {
                let ways = Ways::from_bits(bits);
                assert_eq!(ways.in_frame_of(north).out_of_frame_of(north), ways);
                let one_by_one: Ways = ways.iter().map(|h| h.in_frame_of(north)).collect();
                assert_eq!(ways.in_frame_of(north), one_by_one);
            }
            let at = Point::new(3, -2);
            assert_eq!(at.in_frame_of(north).out_of_frame_of(north), at);
            for heading in Heading::ALL {
                let ahead = Point::default().step(heading);
                assert_eq!(ahead.in_frame_of(north), Point::default().step(heading.in_frame_of(north)));
                assert_eq!(heading.in_frame_of(north).out_of_frame_of(north), heading);
            }
        }
    }

    #[test]
    fn going_there_and_back_is_nothing() {
        let here = Point::new(3, -2);
        for heading in Heading::ALL {
            assert_eq!(here.ahead(heading, 5).ahead(heading.opposite(), 5), here);
        }
    }
}
