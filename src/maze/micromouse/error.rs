//! What can be wrong with a micromouse file, and where: a line and column, or a byte and its square.

use core::fmt;

use crate::geometry::{Heading, Point};
use crate::grouped::Grouped;
use crate::maze::BoundsError;
use crate::maze::text::Place;

/// Why a micromouse file cannot be read.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct MicromouseError {
    /// Where.
    pub spot: Spot,
    /// What is wrong there.
    pub problem: Problem,
}

/// A place in a file.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Spot {
    /// In a text.
    Text(Place),
    /// The byte, from 0, that holds a square.
    Byte(usize),
    /// The file as a whole.
    File,
}

/// What is wrong at a place of a micromouse file.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Problem {
    /// Something else was expected; nothing is there where the line or the file ends.
    Expected {
        /// What.
        what: Expected,
        /// What is there.
        found: Option<char>,
    },
    /// The first line is not as wide as whole squares are.
    Width {
        /// Its columns.
        columns: usize,
    },
    /// A line that is not as wide as the first.
    Ragged {
        /// Its columns.
        columns: usize,
        /// The first line's.
        first: usize,
    },
    /// More squares than a lattice has points.
    Bounds(BoundsError),
    /// A wall is missing on the outside.
    Open {
        /// The square inside.
        square: Point,
        /// The side without a wall.
        side: Heading,
    },
    /// Two neighbours say different things about the side that they share.
    Disagree {
        /// The square that has the wall.
        walled: Point,
        /// On which side; the neighbour there has none.
        side: Heading,
    },
    /// The start is there twice.
    SecondStart {
        /// Where it was first.
        first: Place,
    },
    /// The start is in two places.
    AnotherStart,
    /// A line that begins further to the left than the drawing.
    Margin {
        /// Blanks before the drawing's first line.
        columns: usize,
    },
    /// A way through the outer wall of a grid.
    Gap,
    /// A grid of walls only.
    NoInside,
    /// A square is there twice.
    SecondSquare {
        /// The square.
        square: Point,
        /// The line where it was first.
        first: u32,
    },
    /// A square is missing.
    MissingSquare {
        /// The square.
        square: Point,
    },
    /// A binary file whose bytes are not the squares of a square.
    Length {
        /// How many it has.
        bytes: usize,
    },
    /// A byte of which more than the lowest four bits are set.
    Bits {
        /// The byte.
        byte: u8,
    },
}

/// What a reader expects.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Expected {
    /// A post, so many columns after the one before it.
    Post {
        /// Columns from post to post.
        columns: usize,
    },
    /// So many dashes or spaces between posts.
    Dashes {
        /// Columns between them.
        columns: usize,
    },
    /// A wall's bar or a space.
    Bar,
    /// The outer wall that a line of squares begins with.
    FirstBar,
    /// The middle of a square.
    Mark,
    /// A blank beside the middle of a square.
    Space,
    /// A line of posts after every line of squares.
    PostLine,
    /// A line of squares after the first line of posts.
    SquareLine,
    /// A coordinate.
    Number,
    /// A wall's flag.
    Flag,
    /// The end of the line after six numbers.
    LineEnd,
    /// A place of a grid.
    GridPlace,
}

impl fmt::Display for Expected {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(match *self {
            Self::Post { columns } => {
                let every = match columns {
                    2 => "second",
                    3 => "third",
                    4 => "fourth",
                    5 => "fifth",
                    _ => "sixth",
                };
                return write!(f, "a post (“o” or “+”, at every {every} column)");
            }
            Self::Dashes { columns: 1 } => "a wall (“-”) or a space",
            Self::Dashes { columns } => {
                let many = match columns {
                    2 => "two",
                    3 => "three",
                    4 => "four",
                    _ => "five",
                };
                return write!(f, "a wall of {many} dashes or {many} spaces");
            }
            Self::Bar => "a wall (“|”) or a space",
            Self::FirstBar => "“|” (the outer wall)",
            Self::Mark => "“S”, “G” or a space (the middle of a square)",
            Self::Space => "a space",
            Self::PostLine => "a line of posts and walls",
            Self::SquareLine => "a line of squares, beginning with “|”,",
            Self::Number => "a whole number from 0 to 999 (a line is X Y N E S W)",
            Self::Flag => "0 (open) or 1 (wall)",
            Self::LineEnd => "the end of the line after X Y N E S W",
            Self::GridPlace => "“#” (a wall), a space, “S” or “G”",
        })
    }
}

impl MicromouseError {
    pub(super) const fn text(line: u32, column: usize, problem: Problem) -> Self {
        Self { spot: Spot::Text(Place { line, column: column as u32 }), problem }
    }

    pub(super) const fn expected(line: u32, column: usize, what: Expected, found: Option<char>) -> Self {
        Self::text(line, column, Problem::Expected { what, found })
    }
}

impl fmt::Display for MicromouseError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self.spot {
            Spot::Text(Place { line, column }) => {
                write!(f, "Line {line}, column {column}: {}.", self.problem)
            }
            Spot::Byte(at) => write!(f, "Byte {at}: {}.", self.problem),
            Spot::File => write!(f, "{}.", self.problem),
        }
    }
}

impl core::error::Error for MicromouseError {}

impl fmt::Display for Problem {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match *self {
            Self::Expected { what, found } => {
                write!(f, "{what} was expected, ")?;
                match found {
                    None => f.write_str("but there is nothing"),
                    Some('\t') => f.write_str("not a tab"),
                    Some(' ') => f.write_str("not a space"),
                    Some(other) => write!(f, "not “{}”", other.escape_debug()),
                }
            }
            Self::Width { columns } => write!(
                f,
                "a line has four columns for each square and one more (5, 9, 13, …); this one has {columns}"
            ),
            Self::Ragged { columns, first } => {
                write!(f, "this line has {columns} columns and the first one {first}; make them equal")
            }
            Self::Bounds(error) => error.fmt(f),
            Self::Open { square, side } => write!(
                f,
                "the outer wall {} of square {square} is open; close it, a maze has walls all round",
                side.word()
            ),
            Self::Disagree { walled, side } => write!(
                f,
                "square {walled} has a wall to the {}, but {} has none to the {}; make the two agree",
                side.word(),
                walled.step(side),
                side.opposite().word()
            ),
            Self::SecondStart { first } => write!(
                f,
                "the start is given in line {}, column {} already; leave one “S”",
                first.line, first.column
            ),
            Self::AnotherStart => f.write_str("there is another start besides; leave one “S”"),
            Self::Margin { columns } => write!(
                f,
                "the drawing begins after {columns} blanks and this line further to the left; begin all lines \
                 alike"
            ),
            Self::Gap => f.write_str("the outer wall is open here; close it, a maze has walls all round"),
            Self::NoInside => {
                f.write_str("there is no square between the walls; draw three places at least each way")
            }
            Self::SecondSquare { square, first } => {
                write!(f, "square {square} is given in line {first} already; leave one of them")
            }
            Self::MissingSquare { square } => {
                write!(
                    f,
                    "square {square} is missing; add a line for it, as in “{} {} 0 0 0 0”",
                    square.x, square.y
                )
            }
            Self::Length { bytes } => write!(
                f,
                "This looks like a binary .maz file, which has a byte for each square of a square maze (256 for \
                 16 × 16, 1,024 for 32 × 32); this one has {}",
                Grouped(bytes)
            ),
            Self::Bits { byte } => write!(
                f,
                "a square is a number from 0 to 15 (north 1, east 2, south 4, west 8), not {byte}; \
                 perhaps this is no .maz file"
            ),
        }
    }
}
