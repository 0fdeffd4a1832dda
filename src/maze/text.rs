//! The laboratory's own maze files, `*.maze`: a header of `key: value` lines, a blank line, and a drawing or a
//! list of polylines. The grammar is in `docs/formats.md`.
//!
//! ```
//! use line_maze_lab::maze::text;
//! let maze = text::parse("line-maze: 1\ntitle: A hook\n\n+---+\n|   |\n^   F\n")?;
//! assert_eq!(maze.cells(), 3);
//! assert_eq!(text::parse(&text::write(&maze))?, maze);
//! # Ok::<(), text::ParseError>(())
//! ```

mod drawing;
mod error;
mod field;
mod free;
mod header;
mod list;

use alloc::string::String;
use core::fmt::Write;

pub use error::{ParseError, Place, Problem};
use header::Pitch;
pub(super) use header::is_field;

use super::{Kind, Maze, Start};
use crate::geometry::Point;

/// The most bytes of a maze file: enough for a drawing of 1,000 × 1,000 points and a long note.
pub const MAX_BYTES: usize = 4 << 20;

/// Reads a maze file. Byte order mark, the kind of line ends, trailing blanks and a missing last newline are no
/// matter.
///
/// # Errors
/// At the first thing that is wrong: its line and column, and what was expected there.
pub fn parse(text: &str) -> Result<Maze, ParseError> {
    if text.len() > MAX_BYTES {
        return Err(Place::START.error(Problem::TooLarge { bytes: text.len() }));
    }
    let text = text.strip_prefix('\u{feff}').unwrap_or(text);
    let mut lines = Lines(super::Lines::of(text));
    let header = header::read(&mut lines)?;
    let (first, body) = loop {
        match lines.next() {
            Some((_, "")) => {}
            Some((number, line)) => break (number, line),
            None => return Err(Place { line: lines.number(), column: 1 }.expected(BODY, "")),
        }
    };
    let mut maze = if body == list::TITLE {
        list::read(&mut lines, &header)?
    } else {
        drawing::read(first, body, &mut lines, &header)?
    };
    header.place_marks(&mut maze)?;
    maze.about = header.about;
    maze.kind = header.kind;
    maze.scale = header.scale;
    Ok(maze)
}

const BODY: &str = "a drawing or a list of polylines";

/// Writes a maze file with a drawing or with a list of polylines, whichever is smaller.
#[must_use]
pub fn write(maze: &Maze) -> String {
    let list = with_header(maze, &list::keys(maze), &list::write(maze));
    let wide = (maze.bounds().width() <= SCREEN).then_some(Pitch::WIDE);
    let drawings = wide.into_iter().chain([Pitch::NARROW]).map(|pitch| drawn(maze, pitch));
    drawings.into_iter().find(|drawing| drawing.len() < list.len()).unwrap_or(list)
}

/// Writes a maze file with a drawing, even where a list of polylines would be smaller: for people.
#[must_use]
pub fn write_drawing(maze: &Maze) -> String {
    drawn(maze, if maze.bounds().width() <= SCREEN { Pitch::WIDE } else { Pitch::NARROW })
}

/// Points side by side that a screen shows at four columns of text for a cell.
const SCREEN: u32 = 40;

fn drawn(maze: &Maze, pitch: Pitch) -> String {
    with_header(maze, &drawing::keys(maze, pitch), &drawing::write(maze, pitch))
}

fn with_header(maze: &Maze, form: &str, body: &str) -> String {
    let mut text = String::with_capacity(body.len() + 256);
    text.push_str("line-maze: 1\n");
    for (key, value) in
        [("title", &maze.about.title), ("source", &maze.about.source), ("note", &maze.about.note)]
    {
        free::write(&mut text, key, value);
    }
    let kind = match maze.kind {
        Kind::Line => "line",
        Kind::Wall => "wall",
    };
    let (cell_mm, line_mm) = (maze.scale.cell_mm(), maze.scale.line_mm());
    // Writing to a string cannot fail.
    let _ = write!(text, "kind: {kind}\ncell_mm: {cell_mm}\nline_mm: {line_mm}\n");
    text.push_str(form);
    text.push('\n');
    text.push_str(body);
    text
}

/// Header lines for a start and a finish that the body does not show.
fn marks(start: Option<Start>, finish: &[Point]) -> String {
    let mut text = String::new();
    if let Some(start) = start {
        let _ = writeln!(text, "start: {} {}", start.at, start.heading);
    }
    if !finish.is_empty() {
        text.push_str("finish:");
        for at in finish {
            let _ = write!(text, " {at}");
        }
        text.push('\n');
    }
    text
}

/// The lines of a file, also without the blanks at their ends.
#[derive(Clone, Copy)]
struct Lines<'a>(super::Lines<'a>);

impl Lines<'_> {
    const fn number(&self) -> u32 {
        self.0.number()
    }
}

impl<'a> Iterator for Lines<'a> {
    type Item = (u32, &'a str);

    fn next(&mut self) -> Option<Self::Item> {
        self.0.next().map(|(number, line)| (number, line.trim_end_matches(BLANKS)))
    }
}

/// What may stand at the end of a line unseen.
const BLANKS: [char; 2] = [' ', '\t'];
