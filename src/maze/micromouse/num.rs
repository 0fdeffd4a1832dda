//! `.num` of the mms simulator: a square a line, `X Y N E S W`, in any order; 1 where there is a wall.

use alloc::string::String;
use alloc::vec;
use alloc::vec::Vec;
use core::fmt::Write;

use super::error::{Expected, MicromouseError, Problem};
use super::squares::{Squares, walls};
use crate::geometry::{Heading, Point, Ways};
use crate::maze::{BoundsError, Lines, MAX_SIDE, Maze, Reading};

/// Whether this is a first line of numbers.
pub(super) fn looks_like(first: &str) -> bool {
    first.trim_start().starts_with(|c: char| c.is_ascii_digit())
}

/// A line of the file.
struct Square {
    line: u32,
    at: Point,
    walls: Ways,
}

pub(super) fn read(text: &str) -> Result<Reading, MicromouseError> {
    let mut squares = Vec::new();
    let mut end = 1;
    for (line, words) in Lines::of(text) {
        if !words.trim().is_empty() {
            squares.push(square(line, words)?);
            end = line + 1;
        }
    }
    let most = |of: fn(&Square) -> i32| squares.iter().map(of).max().unwrap_or(0).unsigned_abs() as usize + 1;
    let bounds = super::squares(most(|square| square.at.x), most(|square| square.at.y))
        .map_err(|error| MicromouseError::text(1, 1, Problem::Bounds(error)))?;
    // The line of every square, 0 where it is missing.
    let mut lines = vec![0; bounds.len()];
    let mut walled = Squares::new(bounds);
    for Square { line, at, walls } in squares {
        let Some(index) = bounds.index(at) else { continue };
        match core::mem::replace(&mut lines[index], line) {
            0 => walled.set(at, walls),
            first => {
                return Err(MicromouseError::text(line, 1, Problem::SecondSquare { square: at, first }));
            }
        }
    }
    if let Some(index) = lines.iter().position(|&line| line == 0) {
        return Err(MicromouseError::text(end, 1, Problem::MissingSquare { square: bounds.point(index) }));
    }
    let maze = walled.maze().map_err(|(at, problem)| {
        let line = bounds.index(at).map_or(1, |index| lines[index]);
        MicromouseError::text(line, 1, problem)
    })?;
    Ok(super::started(maze, bounds.sw(), Vec::new()))
}

/// One line: six numbers.
fn square(line: u32, words: &str) -> Result<Square, MicromouseError> {
    let mut fields = Fields { line, words, at: 0 };
    let at = Point::new(fields.coordinate()?, fields.coordinate()?);
    let mut walls = Ways::NONE;
    for side in Heading::ALL {
        if fields.flag()? {
            walls = walls.with(side);
        }
    }
    match fields.next() {
        (_, "") => Ok(Square { line, at, walls }),
        (column, word) => {
            Err(MicromouseError::expected(line, column, Expected::LineEnd, word.chars().next()))
        }
    }
}

/// The words of a line, one after another.
struct Fields<'t> {
    line: u32,
    words: &'t str,
    /// The byte to go on from.
    at: usize,
}

impl<'t> Fields<'t> {
    /// The next word and its column; an empty one past the last.
    fn next(&mut self) -> (usize, &'t str) {
        let rest = &self.words[self.at..];
        let word = rest.trim_start();
        let from = self.at + rest.len() - word.len();
        let word = word.split(char::is_whitespace).next().unwrap_or_default();
        self.at = from + word.len();
        (self.words[..from].chars().count() + 1, word)
    }

    fn coordinate(&mut self) -> Result<i32, MicromouseError> {
        let (column, word) = self.next();
        let digits = !word.is_empty() && word.bytes().all(|byte| byte.is_ascii_digit());
        if !digits {
            return Err(MicromouseError::expected(self.line, column, Expected::Number, strange(word)));
        }
        word.parse()
            .ok()
            .filter(|&number: &i32| number < MAX_SIDE.cast_signed())
            .ok_or_else(|| MicromouseError::text(self.line, column, Problem::Bounds(BoundsError::TooLarge)))
    }

    fn flag(&mut self) -> Result<bool, MicromouseError> {
        match self.next() {
            (_, "0") => Ok(false),
            (_, "1") => Ok(true),
            (column, word) => {
                Err(MicromouseError::expected(self.line, column, Expected::Flag, word.chars().next()))
            }
        }
    }
}

/// The first character that is no digit.
fn strange(word: &str) -> Option<char> {
    word.chars().find(|c| !c.is_ascii_digit())
}

/// Column by column from the south-west, as the simulator writes it.
pub(super) fn write(maze: &Maze) -> String {
    let bounds = maze.bounds();
    let (width, height) = (bounds.width().cast_signed(), bounds.height().cast_signed());
    let mut text = String::new();
    for x in 0..width {
        for y in 0..height {
            let walls = walls(maze, Point::new(bounds.sw().x + x, bounds.sw().y + y));
            let [n, e, s, w] = Heading::ALL.map(|side| u8::from(walls.has(side)));
            // Writing to a string cannot fail.
            let _ = writeln!(text, "{x} {y} {n} {e} {s} {w}");
        }
    }
    text
}
