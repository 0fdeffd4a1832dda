//! Walls as a drawing: lines of posts and walls, and between them lines of squares, north first.
//!
//! ```text
//! o---o---o
//! |     G |
//! o   o---o
//! |S      |
//! o---o---o
//! ```
//!
//! A drawing with posts `+` may come from the mms simulator, to which any character is a wall.

use alloc::string::String;
use alloc::vec::Vec;

use super::error::{Expected, MicromouseError, Problem};
use super::{Form, usual_start};
use crate::geometry::{Heading, Point};
use crate::maze::text::Place;
use crate::maze::{BoundsError, Kind, MAX_SIDE, Maze, Start};

/// Columns of text for a square.
const PITCH: usize = 4;

/// Whether this is a first line of posts.
pub(super) fn looks_like(first: &str) -> bool {
    match first.strip_prefix('o') {
        // A word may begin with o too.
        Some(rest) => !rest.starts_with(char::is_alphanumeric),
        None => first.starts_with('+'),
    }
}

/// Who drew it, and so what a wall looks like.
#[derive(Clone, Copy)]
enum Style {
    /// `---` and `|`.
    Strict,
    /// Any character.
    Loose,
}

const fn is_post(c: char) -> bool {
    matches!(c, 'o' | '+')
}

pub(super) fn read(text: &str) -> Result<Maze, MicromouseError> {
    let rows = rows(text)?;
    let (first_line, first) = rows.first().copied().unwrap_or((1, ""));
    let columns = first.trim_end().chars().count();
    let width = columns.saturating_sub(1) / PITCH;
    if columns % PITCH != 1 || width == 0 {
        return Err(MicromouseError::text(first_line, columns + 1, Problem::Width { columns }));
    }
    let bounds = super::squares(width, rows.len() / 2)
        .map_err(|error| MicromouseError::text(first_line, 1, Problem::Bounds(error)))?;
    let mut maze = Maze::new(bounds);
    maze.kind = Kind::Wall;
    let style = if first.starts_with('+') { Style::Loose } else { Style::Strict };
    let mut reader = Reader { maze, style, columns, chars: Vec::new(), start: None, finish: Vec::new() };
    for (nth, &(line, row)) in rows.iter().enumerate() {
        // Squares north of the row of posts, or those of the row.
        let y = (rows.len() / 2).saturating_sub(nth.div_ceil(2)) as i32;
        if nth % 2 == 0 { reader.posts(line, row, y)? } else { reader.squares(line, row, y)? }
    }
    let Reader { mut maze, start, mut finish, .. } = reader;
    if matches!(style, Style::Loose) && start.is_none() && finish.is_empty() {
        finish = bounds.centre();
    }
    let start = start.map_or(usual_start(bounds), |(at, _)| Start { at, heading: Heading::North });
    maze.set_start(Some(start));
    maze.set_finish(finish);
    Ok(maze)
}

/// The lines of the drawing with their numbers: up to the first that begins with neither post nor wall.
fn rows(text: &str) -> Result<Vec<(u32, &str)>, MicromouseError> {
    let numbered = (1..).zip(text.split('\n').map(|line| line.strip_suffix('\r').unwrap_or(line)));
    let mut rows: Vec<(u32, &str)> = Vec::new();
    let mut end = 1;
    for (line, row) in numbered.skip_while(|(_, row)| row.trim().is_empty()) {
        end = line;
        let first = row.chars().next();
        let top = rows.first().map_or("", |(_, top)| top.trim_end());
        let squares = rows.len() % 2 == 1;
        let loose_wall = squares && is_loose_row(row, top);
        if !(loose_wall || first.is_some_and(|c| is_post(c) || c == '|')) {
            if open_to_the_west(row, top) {
                return Err(MicromouseError::expected(line, 1, Expected::FirstBar, first));
            }
            break;
        }
        if rows.len() > 2 * MAX_SIDE as usize {
            return Err(MicromouseError::text(line, 1, Problem::Bounds(BoundsError::TooLarge)));
        }
        let (sound, what) = if squares {
            (loose_wall || first == Some('|'), Expected::FirstBar)
        } else {
            (first.is_some_and(is_post), Expected::Post)
        };
        if !sound {
            return Err(MicromouseError::expected(line, 1, what, first));
        }
        rows.push((line, row));
        end = line + 1;
    }
    match rows.len() {
        1 => Err(MicromouseError::expected(end, 1, Expected::SquareLine, None)),
        even if even % 2 == 0 => Err(MicromouseError::expected(end, 1, Expected::PostLine, None)),
        _ => Ok(rows),
    }
}

/// Whether a line belongs to the drawing although its first wall is missing; it would end the maze too early.
fn open_to_the_west(row: &str, top: &str) -> bool {
    row.len() == top.len() && row.starts_with(' ') && row.ends_with('|')
}

/// Whether a line under a top of `+` begins with another character as its wall: it is as wide as the top.
fn is_loose_row(row: &str, top: &str) -> bool {
    let wall = row.chars().next().is_some_and(|c| !is_post(c) && !c.is_whitespace());
    wall && top.starts_with('+') && row.trim_end().chars().count() == top.chars().count()
}

struct Reader {
    maze: Maze,
    style: Style,
    columns: usize,
    /// The line that is read.
    chars: Vec<char>,
    start: Option<(Point, Place)>,
    finish: Vec<Point>,
}

impl Reader {
    /// A line as characters, as wide as the first.
    fn take(&mut self, line: u32, row: &str) -> Result<(), MicromouseError> {
        self.chars.clear();
        self.chars.extend(row.chars());
        // A tab hides how wide the line is.
        if let Some(column) = self.chars.iter().position(|&c| c == '\t') {
            return Err(MicromouseError::expected(line, column + 1, Expected::Space, Some('\t')));
        }
        while self.chars.len() > self.columns && self.chars.last() == Some(&' ') {
            self.chars.pop();
        }
        let (columns, first) = (self.chars.len(), self.columns);
        if columns == first {
            return Ok(());
        }
        let column = columns.min(first) + 1;
        Err(MicromouseError::text(line, column, Problem::Ragged { columns, first }))
    }

    /// Posts, and the walls south of row `y`.
    fn posts(&mut self, line: u32, row: &str, y: i32) -> Result<(), MicromouseError> {
        let wrong =
            |column: usize, what, found| Err(MicromouseError::expected(line, column + 1, what, Some(found)));
        self.take(line, row)?;
        for (column, &found) in self.chars.iter().enumerate() {
            if column % PITCH == 0 && !is_post(found) {
                return wrong(column, Expected::Post, found);
            }
        }
        let (columns, height) = (self.columns, self.maze.bounds().height().cast_signed());
        for (x, column) in (0..).zip((0..columns - 1).step_by(PITCH)) {
            let piece = [self.chars[column + 1], self.chars[column + 2], self.chars[column + 3]];
            if let (Style::Strict, Some(odd)) = (self.style, odd_one(piece)) {
                return wrong(column + 1 + odd, Expected::Dashes, piece[odd]);
            }
            let at = Point::new(x, y);
            if piece.iter().any(|c| !c.is_whitespace()) {
                continue;
            }
            if y == 0 {
                let problem = Problem::Open { square: at, side: Heading::South };
                return Err(MicromouseError::text(line, column + 2, problem));
            }
            if y == height {
                let problem = Problem::Open { square: at.step(Heading::South), side: Heading::North };
                return Err(MicromouseError::text(line, column + 2, problem));
            }
            self.maze.draw(at, Heading::South);
        }
        Ok(())
    }

    /// Row `y`: walls and the middles of squares.
    fn squares(&mut self, line: u32, row: &str, y: i32) -> Result<(), MicromouseError> {
        let wrong =
            |column: usize, what, found| Err(MicromouseError::expected(line, column + 1, what, Some(found)));
        self.take(line, row)?;
        let last = self.columns - 1;
        for (column, &found) in self.chars.iter().enumerate() {
            let at = Point::new((column / PITCH) as i32, y);
            match (column % PITCH, found) {
                (0, ' ') if column == last => {
                    let problem = Problem::Open { square: at.step(Heading::West), side: Heading::East };
                    return Err(MicromouseError::text(line, column + 1, problem));
                }
                (0, ' ') => {
                    self.maze.draw(at, Heading::West);
                }
                (0, '|') | (_, ' ') => {}
                (0, _) => match self.style {
                    Style::Loose if !found.is_whitespace() => {}
                    Style::Loose | Style::Strict => return wrong(column, Expected::Bar, found),
                },
                (2, 'S') => {
                    let place = Place { line, column: column as u32 + 1 };
                    if let Some((_, first)) = self.start.replace((at, place)) {
                        return Err(MicromouseError::text(line, column + 1, Problem::SecondStart { first }));
                    }
                }
                (2, 'G') => self.finish.push(at),
                (2, _) => return wrong(column, Expected::Mark, found),
                _ => return wrong(column, Expected::Space, found),
            }
        }
        Ok(())
    }
}

/// Which of three characters makes them neither a wall nor an opening.
fn odd_one(piece: [char; 3]) -> Option<usize> {
    match piece[0] {
        first @ ('-' | ' ') => piece.iter().position(|&c| c != first),
        _ => Some(0),
    }
}

/// The drawing of a maze.
pub(super) fn write(maze: &Maze, form: Form) -> String {
    let bounds = maze.bounds();
    let post = if form == Form::Online { 'o' } else { '+' };
    let (width, height) = (bounds.width().cast_signed(), bounds.height().cast_signed());
    let mut text = String::with_capacity((width as usize * PITCH + 2) * (height as usize * 2 + 1));
    let square = |x, y| Point::new(bounds.sw().x + x, bounds.sw().y + y);
    for y in (-1..height).rev() {
        for x in 0..width {
            text.push(post);
            text.push_str(if maze.has_line(square(x, y), Heading::North) { "   " } else { "---" });
        }
        text.push(post);
        text.push('\n');
        if y < 0 {
            break;
        }
        for x in 0..width {
            let at = square(x, y);
            text.push(if maze.has_line(at, Heading::West) { ' ' } else { '|' });
            text.push_str(match maze.start() {
                _ if form == Form::Map => "   ",
                Some(start) if start.at == at => " S ",
                _ if maze.is_finish(at) => " G ",
                _ => "   ",
            });
        }
        text.push_str("|\n");
    }
    text
}
