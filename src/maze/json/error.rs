//! Why JSON is no maze: the reader's own errors with line and column, ours with the path of the value.

use alloc::string::String;
use core::fmt;

use super::{MAX_BYTES, model};
use crate::geometry::Point;
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
        /// What is wrong, in the words of the JSON reader.
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
                write!(f, "A maze in JSON has at most {MAX_BYTES} bytes (32 MiB); this one has {bytes}.")
            }
            Self::Syntax { line, column, message } => write!(f, "Line {line}, column {column}: {message}."),
            Self::Value { path, problem } => write!(f, "{path}: {problem}."),
        }
    }
}

impl core::error::Error for JsonError {}

impl fmt::Display for Problem {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match *self {
            Self::Format => write!(f, "“{}” was expected", model::FORMAT),
            Self::Scale(error) => error.fmt(f),
            Self::Bounds(error) => error.fmt(f),
            Self::NoSize => f.write_str("a maze without lines needs “bounds”"),
            Self::Off { at, bounds } => write!(
                f,
                "the point {at} is off the lattice, which goes from {} to {}; move it, or widen “bounds”",
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
