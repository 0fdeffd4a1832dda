//! Micromouse files: squares with walls between them, in the forms that contest programs share, and the drawings of
//! mazes that other programs make.
//!
//! | form | from | says |
//! |---|---|---|
//! | [`Form::Online`] | micromouseonline's maze files, `.txt` | walls, start, goal |
//! | [`Form::Map`] | the mms simulator, `.map` | walls; the goal is the centre |
//! | [`Form::Num`] | the mms simulator, `.num` | walls, a square a line |
//! | [`Form::Binary`] | Windows-era simulators, `.maz` | walls of a square maze, a byte each |
//! | | drawings of other widths, grids of `#` | walls, start, goal; only read |
//!
//! Where a form doesn't say, the mouse starts in the south-west, as the contests' rules have it. No form says where it
//! faces: along its only way, and to the north where there are several.

mod binary;
mod drawing;
mod error;
mod export;
mod grid;
mod num;
mod squares;

use alloc::vec::Vec;

pub use error::{Expected, MicromouseError, Problem, Spot};
pub use export::{CannotSay, Unsaid, has_unsaid_finish, write, write_with};
pub(super) use grid::{Cell, Cells};
pub(super) use squares::Squares;

use super::{Bounds, Lines, Maze, Reading, Remark, Start, text};
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
    /// A byte for each square of a square maze.
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
/// let reading = micromouse::read(b"o---o---o\n| S   G |\no---o---o\n").unwrap()?;
/// assert_eq!((reading.maze.cells(), reading.maze.finish().len()), (1, 1));
/// assert_eq!(reading.remarks[0].to_string(), "The file gives no heading; at the start 0,0 the robot faces east, its only way.");
/// # Ok::<(), micromouse::MicromouseError>(())
/// ```
///
/// # Errors
/// At the first thing that is wrong: its line and column, or its byte and square.
#[must_use]
pub fn read(bytes: &[u8]) -> Option<Result<Reading, MicromouseError>> {
    if binary::looks_like(bytes) {
        return Some(binary::read(bytes));
    }
    let text = core::str::from_utf8(bytes).ok()?;
    let text = text.strip_prefix('\u{feff}').unwrap_or(text);
    let lines: Vec<(u32, &str)> = Lines::of(text).collect();
    let mut full = (0..lines.len()).filter(|&nth| !lines[nth].1.trim().is_empty());
    let first = full.next()?;
    // What begins the file is taken for what it looks like; further down, only what can be nothing else.
    if let Some(top) = drawing::Top::of(lines[first].1).filter(drawing::Top::begins) {
        return Some(drawing::read(&lines, first, &top, Vec::new()));
    }
    if num::looks_like(lines[first].1) {
        return Some(num::read(text));
    }
    for nth in core::iter::once(first).chain(full) {
        let (line, words) = lines[nth];
        // The lab's own files hold drawings too.
        if text::is_field(words) {
            return None;
        }
        let before = || if nth == first { Vec::new() } else { alloc::vec![Remark::Before { line }] };
        let next = lines.get(nth + 1).map_or("", |(_, next)| next);
        if let Some(top) = drawing::Top::of(words).filter(|top| top.is_sure(next)) {
            return Some(drawing::read(&lines, nth, &top, before()));
        }
        if grid::is_sure(words, next) || nth == first && grid::begins(words) {
            return Some(grid::read(&lines, nth, before()));
        }
    }
    None
}

/// Whether a file whose first words are in this line is taken for a drawing, a grid or numbers.
pub(super) fn begins(line: &str) -> bool {
    drawing::Top::of(line).is_some_and(|top| top.begins()) || num::looks_like(line) || grid::begins(line)
}

/// The lattice of so many squares; the south-west one is 0,0.
pub(super) fn squares(width: usize, height: usize) -> Result<Bounds, super::BoundsError> {
    let last = |count: usize| i32::try_from(count).unwrap_or(i32::MAX).saturating_sub(1);
    Bounds::new(Point::default(), Point::new(last(width), last(height)))
}

/// Where a mouse faces of which only the square is known: along its only way, else north as the contests' rules
/// have it.
fn heading(maze: &Maze, at: Point) -> Heading {
    maze.ways(at).only().unwrap_or(Heading::North)
}

/// A maze with its start, whose heading no file says, and with what there is to say about start and finish.
pub(super) fn started(mut maze: Maze, at: Point, mut remarks: Vec<Remark>) -> Reading {
    let start = Start { at, heading: heading(&maze, at) };
    maze.set_start(Some(start));
    if start.heading != Heading::North {
        remarks.push(Remark::Faces(start));
    }
    if maze.finish().is_empty() {
        remarks.push(Remark::NoFinish);
    }
    Reading { maze, remarks }
}

/// What stands after the last line of a maze, which is left out.
fn after(lines: &[(u32, &str)]) -> Option<Remark> {
    lines.iter().find(|(_, words)| !words.trim().is_empty()).map(|&(line, _)| Remark::After { line })
}

/// The blanks that a line begins with, and the rest of it.
fn indented(line: &str) -> (&str, &str) {
    let rest = line.trim_start_matches([' ', '\t']);
    line.split_at(line.len() - rest.len())
}
