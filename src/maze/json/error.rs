//! Why JSON is no maze: the reader's own errors with line and column, ours with the path of the value.

use alloc::format;
use alloc::string::{String, ToString};
use core::fmt;

use serde_json::error::Category;

use super::{MAX_BYTES, model};
use crate::geometry::Point;
use crate::grouped::Grouped;
use crate::maze::text::Place;
use crate::maze::{Bounds, BoundsError, ScaleError, micromouse};

/// Why JSON is no maze.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum JsonError {
    /// More than [`MAX_BYTES`].
    TooLarge {
        /// The size that it has.
        bytes: usize,
    },
    /// No JSON, or a key or type that is not a maze's.
    Syntax {
        /// From 1.
        line: u32,
        /// In characters, from 1.
        column: u32,
        /// What is wrong.
        message: String,
    },
    /// A value that makes no sense.
    Value {
        /// Which one, such as `lines[3][1]`.
        path: String,
        /// What is wrong with it.
        problem: Problem,
    },
}

/// What is wrong with a value.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Problem {
    /// The format is not `line-maze/1`.
    Format,
    /// The sizes on the floor make no sense.
    Scale(ScaleError),
    /// The lattice cannot have these corners.
    Bounds(BoundsError),
    /// Neither lines nor bounds.
    NoSize,
    /// A point off the lattice.
    Off {
        /// The point.
        at: Point,
        /// The lattice.
        bounds: Bounds,
    },
    /// A polyline of fewer than two points.
    Short,
    /// The same point as the one before it.
    SamePoint,
    /// A segment that is not along an axis.
    Slanted {
        /// Where it begins.
        from: Point,
        /// Where it would end.
        to: Point,
    },
    /// A list of numbers that are not the squares of a square.
    NotSquares {
        /// How many there are.
        numbers: usize,
    },
    /// Among lists of walls, something that is no list.
    NoList,
    /// No number from 0 to 15.
    NoWalls,
    /// A list of walls that is not as long as the first one.
    Uneven {
        /// Its numbers.
        numbers: usize,
        /// The first one's.
        first: usize,
    },
    /// No order of the lists makes a maze; what is wrong in the usual one.
    NoOrder(micromouse::Problem),
    /// Two orders of the lists make different mazes.
    Ambiguous,
    /// What is wrong in a grid of 0 and 1.
    Grid(micromouse::Problem),
}

impl fmt::Display for JsonError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::TooLarge { bytes } => {
                let most = Grouped(MAX_BYTES);
                write!(
                    f,
                    "A maze in JSON has at most {most} bytes (32 MiB); this one has {}.",
                    Grouped(*bytes)
                )
            }
            Self::Syntax { line, column, message } => write!(f, "Line {line}, column {column}: {message}."),
            Self::Value { path, problem } if path.is_empty() => write!(f, "{problem}."),
            Self::Value { path, problem } => write!(f, "{path}: {problem}."),
        }
    }
}

impl core::error::Error for JsonError {}

pub(super) fn value(path: &str, problem: Problem) -> JsonError {
    JsonError::Value { path: path.to_string(), problem }
}

/// The JSON reader's error in our words, with the place in characters instead of bytes. To it, only LF ends a line.
pub(super) fn syntax(text: &str, error: &serde_json::Error) -> JsonError {
    let ends = text.match_indices('\n').map(|(at, _)| at + 1);
    let from = core::iter::once(0).chain(ends).nth(error.line().saturating_sub(1)).unwrap_or(text.len());
    let at = (from + error.column().saturating_sub(1)).min(text.len());
    let at = (at..=text.len()).find(|&at| text.is_char_boundary(at)).unwrap_or(text.len());
    let Place { line, column } = Place::after(&text[..at]);
    let mut message = error.to_string();
    if let Some(place) = message.rfind(" at line ") {
        message.truncate(place);
    }
    let message = match error.classify() {
        Category::Eof => String::from("the text ends in the middle of the maze"),
        Category::Syntax | Category::Io => format!("this is not JSON: {message}"),
        Category::Data => plain(message),
    };
    JsonError::Syntax { line, column, message }
}

/// Serde's sentence as ours; as it is, if it is none that we know.
fn plain(message: String) -> String {
    let sentence =
        [("missing field ", "the key ", " is missing"), ("duplicate field ", "the key ", " is there twice")];
    for (start, before, after) in sentence {
        if let Some(key) = message.strip_prefix(start) {
            return format!("{before}{key}{after}");
        }
    }
    let Some((found, expected)) = message.rsplit_once(", expected ") else { return message };
    if let Some(key) = found.strip_prefix("unknown field ") {
        return format!("{key} is not a key here; there is {expected}");
    }
    if let Some(length) = found.strip_prefix("invalid length ") {
        return format!("{expected} was expected, not a list of {length}");
    }
    let starts = ["invalid type: ", "invalid value: ", "unknown variant "];
    let found = starts.into_iter().find_map(|start| found.strip_prefix(start)).unwrap_or(found);
    format!("{expected} was expected, not {found}")
}

impl fmt::Display for Problem {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match *self {
            Self::Format => write!(f, "“{}” was expected", model::FORMAT),
            Self::Scale(error) => error.fmt(f),
            Self::Bounds(error) => error.fmt(f),
            Self::NoSize => f.write_str("a maze without lines needs “bounds”"),
            Self::Off { at, bounds } => write!(
                f,
                "the point {at} is off the lattice, which goes from {} to {}; move it, or set wider “bounds”",
                bounds.sw(),
                bounds.ne()
            ),
            Self::Short => f.write_str("a polyline has two points or more"),
            Self::SamePoint => f.write_str("this point is the same as the one before it"),
            Self::Slanted { from, to } => write!(
                f,
                "lines go along the axes, and {from} to {to} is slanted; add the corner between them"
            ),
            Self::NotSquares { numbers } => write!(
                f,
                "This seems to be a list of walls, but its {numbers} numbers make no square maze; write a list \
                 for each row, or a number for each square (256 for 16 × 16)"
            ),
            Self::NoList => f.write_str("a list of numbers was expected, as the others are"),
            Self::NoWalls => f.write_str(
                "in a list of walls a square is a number from 0 to 15 (north 1, east 2, south 4, west 8)",
            ),
            Self::Uneven { numbers, first } => {
                let s = if numbers == 1 { "" } else { "s" };
                write!(f, "this list has {numbers} number{s} and the first one {first}; make them equal")
            }
            Self::NoOrder(wrong) => write!(
                f,
                "the numbers (north 1, east 2, south 4, west 8) make no maze in any order; as rows from the north, \
                 {wrong}"
            ),
            Self::Ambiguous => f.write_str(
                "the numbers can be read as rows or as columns, and make different mazes; write a .num file instead",
            ),
            Self::Grid(wrong) => write!(f, "in a grid of 0 (open) and 1 (closed), {wrong}"),
        }
    }
}
