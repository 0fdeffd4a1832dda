//! Micromouse files: squares with walls between them, in the four forms that contest programs share.
//!
//! | form | from | says |
//! |---|---|---|
//! | [`Form::Online`] | micromouseonline's maze files, `.txt` | walls, start, goal |
//! | [`Form::Map`] | the mms simulator, `.map` | walls; the goal is the centre |
//! | [`Form::Num`] | the mms simulator, `.num` | walls, a square a line |
//! | [`Form::Binary`] | Windows-era simulators, `.maz` | walls of 16 × 16 squares, a byte each |
//!
//! Where a form doesn't say, the mouse starts in the south-west facing north, as the contests' rules have it.

mod binary;
mod drawing;
mod error;
mod export;
mod num;
mod squares;

pub use error::{Expected, MicromouseError, Problem, Spot};
pub use export::{CannotSay, write};

use super::{Bounds, Maze, Start};
use crate::geometry::{Heading, Point};

/// A form of micromouse file.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Form {
    /// A drawing of posts `o` and walls, with `S` and `G`.
    Online,
    /// A drawing of posts `+` and walls, without marks.
    Map,
    /// `X Y N E S W`, a square a line.
    Num,
    /// 256 bytes.
    Binary,
}

impl Form {
    /// All four.
    pub const ALL: [Self; 4] = [Self::Online, Self::Map, Self::Num, Self::Binary];

    /// What its files are usually called, without the dot.
    #[must_use]
    pub const fn extension(self) -> &'static str {
        match self {
            Self::Online => "txt",
            Self::Map => "map",
            Self::Num => "num",
            Self::Binary => "maz",
        }
    }
}

/// Reads a micromouse file of any form; none where the content looks like none of them.
///
/// ```
/// use line_maze_lab::maze::micromouse;
/// let maze = micromouse::read(b"o---o---o\n| S   G |\no---o---o\n").unwrap()?;
/// assert_eq!((maze.cells(), maze.finish().len()), (1, 1));
/// # Ok::<(), micromouse::MicromouseError>(())
/// ```
///
/// # Errors
/// At the first thing that is wrong: its line and column, or its byte and square.
#[must_use]
pub fn read(bytes: &[u8]) -> Option<Result<Maze, MicromouseError>> {
    if binary::looks_like(bytes) {
        return Some(binary::read(bytes));
    }
    let text = core::str::from_utf8(bytes).ok()?;
    let text = text.strip_prefix('\u{feff}').unwrap_or(text);
    let first = text.lines().find(|line| !line.trim().is_empty())?;
    if drawing::looks_like(first) {
        Some(drawing::read(text))
    } else if num::looks_like(first) {
        Some(num::read(text))
    } else {
        None
    }
}

/// The lattice of so many squares; the south-west one is 0,0.
fn squares(width: usize, height: usize) -> Result<Bounds, super::BoundsError> {
    let last = |count: usize| i32::try_from(count).unwrap_or(i32::MAX).saturating_sub(1);
    Bounds::new(Point::default(), Point::new(last(width), last(height)))
}

/// Where a mouse starts by the contests' rules.
const fn usual_start(bounds: Bounds) -> Start {
    Start { at: bounds.sw(), heading: Heading::North }
}
