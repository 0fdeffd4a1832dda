//! What can be wrong with a maze file, and where: every message names line and column and what was expected.

use alloc::string::String;
use core::fmt;

use crate::geometry::Point;
use crate::grouped::Grouped;
use crate::maze::text::MAX_BYTES;
use crate::maze::{Bounds, BoundsError, Lines, ScaleError};

/// A place in a text; both numbers count from 1, columns in characters.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Place {
    /// From 1.
    pub line: u32,
    /// In characters, from 1.
    pub column: u32,
}

/// Why a maze file cannot be read.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct ParseError {
    /// Where.
    pub place: Place,
    /// What is wrong there.
    pub problem: Problem,
}

/// What is wrong at a place of a maze file.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Problem {
    /// The file is larger than [`MAX_BYTES`].
    TooLarge {
        /// The file's size.
        bytes: usize,
    },
    /// Something else was expected.
    Expected {
        /// What, as the beginning of a sentence.
        what: &'static str,
        /// What is there; empty where the line or the file ends.
        found: String,
    },
    /// The file is of a later version.
    Version(String),
    /// No key of a maze file.
    UnknownKey(String),
    /// A key for the second time.
    Repeated {
        /// The key.
        key: &'static str,
        /// The line where it was first.
        first: u32,
    },
    /// A backslash with something that it cannot stand before.
    Escape,
    /// A size on the floor that makes no sense.
    Scale(ScaleError),
    /// The lattice cannot have these corners.
    Bounds(BoundsError),
    /// The start is there twice.
    SecondStart {
        /// Where it was first.
        first: Place,
    },
    /// Off the lattice.
    Off {
        /// What: `the start`, `the finish point`, `this point`.
        what: &'static str,
        /// Where it would be.
        at: Point,
        /// The lattice.
        bounds: Bounds,
    },
    /// A line in a drawing without a point at an end.
    LooseEnd,
    /// A polyline of one point.
    OnePoint,
    /// A point that is the same as the one before it.
    SamePoint,
    /// A segment that is not along an axis.
    Slanted {
        /// Where it begins.
        from: Point,
        /// Where it would end.
        to: Point,
    },
    /// A key that is for drawings only.
    DrawingOnly(&'static str),
    /// Neither lines nor bounds: the lattice's size is unknown.
    NoSize,
}

impl Place {
    pub(super) const START: Self = Self { line: 1, column: 1 };

    /// The place after this text.
    ///
    /// ```
    /// use line_maze_lab::maze::text::Place;
    /// assert_eq!(Place::after("one\rtwo\r\nthr"), Place { line: 3, column: 4 });
    /// ```
    #[must_use]
    pub fn after(text: &str) -> Self {
        let (line, last) = Lines::of(text).last().unwrap_or((1, ""));
        Self { line, column: u32::try_from(last.chars().count()).unwrap_or(u32::MAX).saturating_add(1) }
    }

    /// The same place in a text that has so many more lines before it, and columns to the left.
    #[must_use]
    pub(in crate::maze) const fn moved(self, lines: u32, columns: u32) -> Self {
        Self { line: self.line.saturating_add(lines), column: self.column.saturating_add(columns) }
    }

    pub(super) const fn error(self, problem: Problem) -> ParseError {
        ParseError { place: self, problem }
    }

    /// `what` was expected here, but `found` (as much of it as helps) is there.
    pub(super) fn expected(self, what: &'static str, found: &str) -> ParseError {
        let mut shown: String = found.chars().take(SHOWN).collect();
        if found.chars().nth(SHOWN).is_some() {
            shown.push('…');
        }
        self.error(Problem::Expected { what, found: shown })
    }
}

impl ParseError {
    /// The same error in a text that has so many more lines before it, and columns to the left.
    #[must_use]
    pub(in crate::maze) fn moved(self, lines: u32, columns: u32) -> Self {
        let problem = match self.problem {
            Problem::SecondStart { first } => Problem::SecondStart { first: first.moved(lines, columns) },
            Problem::Repeated { key, first } => Problem::Repeated { key, first: first.saturating_add(lines) },
            other => other,
        };
        Self { place: self.place.moved(lines, columns), problem }
    }
}

/// Characters of what was found that a message repeats.
const SHOWN: usize = 24;

impl fmt::Display for ParseError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match &self.problem {
            Problem::TooLarge { .. } => write!(f, "{}.", self.problem),
            problem => write!(f, "Line {}, column {}: {problem}.", self.place.line, self.place.column),
        }
    }
}

impl core::error::Error for ParseError {}

impl fmt::Display for Problem {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::TooLarge { bytes } => {
                let most = Grouped(MAX_BYTES);
                write!(f, "A maze file has at most {most} bytes (4 MiB); this one has {}", Grouped(*bytes))
            }
            Self::Expected { what, found } => match found.chars().next() {
                None => write!(f, "{what} was expected, but there is nothing"),
                Some('\t') => write!(f, "{what} was expected, not a tab"),
                Some(' ') => write!(f, "{what} was expected, not a space"),
                Some(_) => write!(f, "{what} was expected, not “{}”", found.escape_debug()),
            },
            Self::Version(version) => {
                write!(f, "this file is of version “{}”; only version 1 can be read", version.escape_debug())
            }
            Self::UnknownKey(key) => write!(
                f,
                "“{}” is not a key of a maze file; those are title, source, note, kind, cell_mm, line_mm, \
                 columns, origin, bounds, start and finish",
                key.escape_debug()
            ),
            Self::Repeated { key, first } => write!(f, "“{key}” is given in line {first} already"),
            Self::Escape => {
                f.write_str("a backslash stands only in \\\\, \\n, \\r, \\t, \\s (a space) and \\u{…}")
            }
            Self::Scale(error) => error.fmt(f),
            Self::Bounds(error) => error.fmt(f),
            Self::SecondStart { first } => {
                write!(f, "the start is given in line {}, column {} already", first.line, first.column)
            }
            &Self::Off { what, at, bounds } => write!(
                f,
                "{what} {at} is off the lattice, which goes from {} to {}; move it, or set wider “bounds”",
                bounds.sw(),
                bounds.ne()
            ),
            Self::LooseEnd => f.write_str("this line has no point at its end; put a “+” there"),
            Self::OnePoint => f.write_str("a polyline needs a second point"),
            Self::SamePoint => f.write_str("this point is the same as the one before it"),
            Self::Slanted { from, to } => write!(
                f,
                "lines go along the axes, and {from} to {to} is slanted; add the corner between them"
            ),
            Self::DrawingOnly(key) => {
                write!(f, "“{key}” is for drawings; a list of polylines does without it")
            }
            Self::NoSize => f.write_str("a maze without lines needs “bounds” in its header"),
        }
    }
}
