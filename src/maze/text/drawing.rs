//! Lines as a drawing: points in every second row of text, at every fourth column (or second, see
//! [`Pitch`]), `---` and `|` between the points that are joined.
//!
//! ```text
//! +---+---F
//! |   |
//! ^   +   .
//! ```

use alloc::string::String;
use alloc::vec;
use alloc::vec::Vec;
use core::fmt::Write;

use super::error::{ParseError, Place, Problem};
use super::header::{Header, Pitch};
use super::{Lines, marks};
use crate::geometry::{Heading, Point};
use crate::maze::{Bounds, BoundsError, MAX_SIDE, Maze, Start};

/// A drawing's row of text and its number.
type Row<'a> = (u32, &'a str);

/// Reads a drawing that begins with the line `body`.
pub(super) fn read(
    first: u32,
    body: &str,
    lines: &mut Lines<'_>,
    header: &Header,
) -> Result<Maze, ParseError> {
    let mut rows: Vec<Row<'_>> = vec![(first, body)];
    for (number, line) in lines {
        // Blank lines after a drawing may be as many as they like; those inside must not be.
        if rows.len() > 2 * MAX_SIDE as usize {
            if line.is_empty() {
                continue;
            }
            return Err(Place { line: number, column: 1 }.error(Problem::Bounds(BoundsError::TooLarge)));
        }
        rows.push((number, line));
    }
    while rows.last().is_some_and(|(_, line)| line.is_empty()) {
        rows.pop();
    }
    let columns = header.pitch.0.columns();
    let widest = rows.iter().max_by_key(|(_, line)| line.len()).map_or((first, ""), |&row| row);
    let (width, height) = (widest.1.len().saturating_sub(1) / columns + 1, rows.len() / 2 + 1);
    let corner = header.origin.map(|(at, _)| at).or(header.bounds.map(Bounds::sw)).unwrap_or_default();
    let steps = |count: usize| i32::try_from(count - 1).unwrap_or(i32::MAX);
    let opposite = Point::new(corner.x.saturating_add(steps(width)), corner.y.saturating_add(steps(height)));
    let drawn = Bounds::new(corner, opposite).map_err(|error| {
        let place = match (error, header.origin) {
            (BoundsError::TooFar, Some((_, place))) => place,
            _ => Place { line: widest.0, column: 1 },
        };
        place.error(Problem::Bounds(error))
    })?;
    let mut reader = Reader {
        rows: &rows,
        columns,
        drawn,
        marked: header.start.map(|(_, place)| place),
        finish: Vec::new(),
        maze: Maze::new(header.bounds.unwrap_or(drawn)),
    };
    for row in 0..rows.len() {
        if row % 2 == 0 { reader.points(row)? } else { reader.verticals(row)? }
    }
    let Reader { mut maze, finish, .. } = reader;
    maze.set_finish(finish);
    Ok(maze)
}

struct Reader<'a> {
    rows: &'a [Row<'a>],
    columns: usize,
    /// The lattice that the drawing covers.
    drawn: Bounds,
    /// Where the start was given.
    marked: Option<Place>,
    finish: Vec<Point>,
    maze: Maze,
}

impl Reader<'_> {
    fn place(&self, row: usize, column: usize) -> Place {
        Place { line: self.rows[row].0, column: u32::try_from(column + 1).unwrap_or(u32::MAX) }
    }

    fn char(&self, row: usize, column: usize) -> u8 {
        self.rows.get(row).and_then(|(_, line)| line.as_bytes().get(column)).copied().unwrap_or(b' ')
    }

    /// The character at a byte of a row that is ASCII up to there.
    fn expected(&self, row: usize, column: usize, what: &'static str) -> ParseError {
        let line = self.rows[row].1;
        let found = line.get(column..).and_then(|rest| rest.chars().next());
        let mut shown = String::new();
        shown.extend(found);
        self.place(row, column).expected(what, &shown)
    }

    /// The lattice point that a place of the drawing stands for.
    fn point(&self, row: usize, column: usize) -> Point {
        let (sw, ne) = (self.drawn.sw(), self.drawn.ne());
        Point::new(sw.x + (column / self.columns) as i32, ne.y - (row / 2) as i32)
    }

    fn points(&mut self, row: usize) -> Result<(), ParseError> {
        let length = self.rows[row].1.len();
        let mut column = 0;
        while column < length {
            if column % self.columns == 0 {
                self.mark(row, column)?;
                column += 1;
            } else {
                self.link(row, column)?;
                column += self.columns - 1;
            }
        }
        Ok(())
    }

    /// A lattice point, perhaps with start or finish on it.
    fn mark(&mut self, row: usize, column: usize) -> Result<(), ParseError> {
        let at = self.point(row, column);
        let start = |heading| Some(Start { at, heading });
        let mut finish = false;
        let start = match self.char(row, column) {
            b' ' | b'.' | b'+' => None,
            b'F' => {
                finish = true;
                None
            }
            b'^' => start(Heading::North),
            b'>' => start(Heading::East),
            b'v' => start(Heading::South),
            b'<' => start(Heading::West),
            _ => return Err(self.expected(row, column, "a point (“+”, “.”, “F”, “^”, “>”, “v” or “<”)")),
        };
        let place = self.place(row, column);
        let bounds = self.maze.bounds();
        if self.char(row, column) != b' ' && !bounds.contains(at) {
            return Err(place.error(Problem::Off { what: "the point", at, bounds }));
        }
        if finish {
            self.finish.push(at);
        }
        if start.is_some() {
            if let Some(first) = self.marked.replace(place) {
                return Err(place.error(Problem::SecondStart { first }));
            }
            self.maze.set_start(start);
        }
        Ok(())
    }

    /// What is between two points of a row: a line from end to end, or nothing.
    fn link(&mut self, row: usize, column: usize) -> Result<(), ParseError> {
        let joined = self.char(row, column) == b'-';
        let (want, what) = if joined {
            (b'-', "“-” (a line goes from point to point)")
        } else {
            (b' ', "“-” or a space")
        };
        let end = column + self.columns - 1;
        for at in column..end {
            if self.char(row, at) != want {
                let what = if self.char(row, at) == b'-' { "a line that begins at a point" } else { what };
                return Err(self.expected(row, at, what));
            }
        }
        if joined {
            for point in [column - 1, end] {
                if self.char(row, point) == b' ' {
                    return Err(self.place(row, column).error(Problem::LooseEnd));
                }
            }
            self.maze.draw(self.point(row, column - 1), Heading::East);
        }
        Ok(())
    }

    fn verticals(&mut self, row: usize) -> Result<(), ParseError> {
        for column in 0..self.rows[row].1.len() {
            match (self.char(row, column), column % self.columns) {
                (b' ', _) => {}
                (b'|', 0) => {
                    if self.char(row - 1, column) == b' ' || self.char(row + 1, column) == b' ' {
                        return Err(self.place(row, column).error(Problem::LooseEnd));
                    }
                    self.maze.draw(self.point(row + 1, column), Heading::North);
                }
                (_, 0) => return Err(self.expected(row, column, "“|” or a space")),
                _ => return Err(self.expected(row, column, "a space (no point is above this place)")),
            }
        }
        Ok(())
    }
}

/// What the header has to say for a drawing: what the drawing does not show.
pub(super) fn keys(maze: &Maze, pitch: Pitch) -> String {
    let mut text = String::new();
    // Writing to a string cannot fail.
    if pitch != Pitch::WIDE {
        let _ = writeln!(text, "columns: {}", pitch.columns());
    }
    if maze.bounds().sw() != Point::default() {
        let _ = writeln!(text, "origin: {}", maze.bounds().sw());
    }
    let under_the_start = maze.start().map(|start| start.at).filter(|&at| maze.is_finish(at));
    text + &marks(None, under_the_start.as_slice())
}

/// Writes a drawing of every lattice point.
pub(super) fn write(maze: &Maze, pitch: Pitch) -> String {
    let (bounds, columns) = (maze.bounds(), pitch.columns());
    let mut text = String::with_capacity(pitch.size(bounds));
    let mut below = String::new();
    for y in (bounds.sw().y..=bounds.ne().y).rev() {
        below.clear();
        for x in bounds.sw().x..=bounds.ne().x {
            let at = Point::new(x, y);
            let ways = maze.ways(at);
            text.push(match maze.start() {
                Some(start) if start.at == at => mark(start.heading),
                _ if maze.is_finish(at) => 'F',
                _ if ways.is_empty() => '.',
                _ => '+',
            });
            below.push(if ways.has(Heading::South) { '|' } else { ' ' });
            if x < bounds.ne().x {
                let between = if ways.has(Heading::East) { '-' } else { ' ' };
                text.extend(core::iter::repeat_n(between, columns - 1));
                below.extend(core::iter::repeat_n(' ', columns - 1));
            }
        }
        text.push('\n');
        if y > bounds.sw().y {
            text.push_str(below.trim_end());
            text.push('\n');
        }
    }
    text
}

const fn mark(heading: Heading) -> char {
    match heading {
        Heading::North => '^',
        Heading::East => '>',
        Heading::South => 'v',
        Heading::West => '<',
    }
}
