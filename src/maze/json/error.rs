//! Why JSON is no maze: the reader's own errors with line and column, ours with the path of the value.

use alloc::format;
use alloc::string::{String, ToString};
use core::fmt;

use serde_json::error::Category;

use super::{MAX_BYTES, model};
use crate::geometry::Point;
use crate::grouped::Grouped;
use crate::maze::{Bounds, BoundsError, ScaleError};

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
        line: usize,
        /// In characters, from 1.
        column: usize,
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
            Self::Value { path, problem } => write!(f, "{path}: {problem}."),
        }
    }
}

impl core::error::Error for JsonError {}

/// The JSON reader's error in our words, with the place in characters instead of bytes.
pub(super) fn syntax(text: &str, error: &serde_json::Error) -> JsonError {
    let line = error.line().max(1);
    let before = text.lines().nth(line - 1).unwrap_or_default();
    let bytes = before.len().min(error.column().saturating_sub(1));
    let column = before.char_indices().take_while(|&(at, _)| at < bytes).count() + 1;
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
        }
    }
}
