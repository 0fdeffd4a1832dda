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
//! A drawing with posts `+` may come from the mms simulator, to which any character is a wall: it looks at the middle
//! of a wall's place. Squares may be as narrow as two columns of text. Walls that nobody knows (`.`, `:` or `?`) are
//! taken as walls.

mod rows;
mod top;
mod write;

use alloc::vec::Vec;

pub(super) use top::Top;
pub(super) use write::write;

use super::error::{Expected, MicromouseError, Problem};
use crate::geometry::{Heading, Point};
use crate::maze::text::Place;
use crate::maze::{Kind, Maze, Reading, Remark};
use rows::rows;
use top::{Style, UNKNOWN, USUAL};

/// Reads the drawing whose first line is the one with this index, and which looks like `top`.
pub(super) fn read(
    lines: &[(u32, &str)],
    from: usize,
    top: &Top<'_>,
    mut remarks: Vec<Remark>,
) -> Result<Reading, MicromouseError> {
    let line = lines[from].0;
    let margin = top.margin();
    let rows = rows(&lines[from..], top)?;
    let (columns, pitch) = (top.columns(), top.pitch);
    let width = columns.saturating_sub(1) / pitch;
    if columns % pitch != 1 || width == 0 {
        return Err(MicromouseError::text(line, margin + columns + 1, Problem::Width { columns }));
    }
    let bounds = super::squares(width, rows.len() / 2)
        .map_err(|error| MicromouseError::text(line, margin + 1, Problem::Bounds(error)))?;
    let mut maze = Maze::new(bounds);
    maze.kind = Kind::Wall;
    let none = || Counted { walls: 0, first: Place { line, column: 1 } };
    let mut reader = Reader {
        maze,
        top,
        chars: Vec::new(),
        start: None,
        finish: Vec::new(),
        unknown: none(),
        part: none(),
    };
    for (nth, &(line, row)) in rows.iter().enumerate() {
        // Squares north of the row of posts, or those of the row.
        let y = (rows.len() / 2).saturating_sub(nth.div_ceil(2)) as i32;
        if nth % 2 == 0 { reader.posts(line, row, y)? } else { reader.squares(line, row, y)? }
    }
    let Reader { mut maze, start, mut finish, unknown, part, .. } = reader;
    if margin > 0 {
        remarks.push(Remark::Indented { columns: margin as u32, line });
    }
    if !top.has_usual_posts() {
        let first = Place { line, column: margin as u32 + 1 };
        remarks.push(Remark::Posts { post: top.post, first });
    }
    if let Some((walls, first)) = unknown.some() {
        remarks.push(Remark::UnknownWalls { walls, first });
    }
    if let Some((walls, first)) = part.some() {
        remarks.push(Remark::PartWalls { walls, first });
    }
    remarks.extend(super::after(&lines[from + rows.len()..]));
    // What the simulator reads has neither.
    if top.style() == Style::Loose && pitch == USUAL && start.is_none() && finish.is_empty() {
        finish = bounds.centre();
        remarks.push(Remark::FinishInCentre);
    }
    maze.set_finish(finish);
    Ok(super::started(maze, start.map_or(bounds.sw(), |(at, _)| at), remarks))
}

/// Walls of a kind that is only counted.
struct Counted {
    walls: u32,
    first: Place,
}

impl Counted {
    fn add(&mut self, place: Place) {
        if self.walls == 0 {
            self.first = place;
        }
        self.walls += 1;
    }

    fn some(&self) -> Option<(u32, Place)> {
        (self.walls > 0).then_some((self.walls, self.first))
    }
}

/// What is at a wall's place.
enum Piece {
    Open,
    Wall,
    /// Nobody knows.
    Unknown,
    /// A wall, but not from post to post.
    PartOfWall,
    /// A beginning without its middle.
    PartOfNone,
    /// Nothing of these, because of this character.
    Odd(usize),
}

struct Reader<'t> {
    maze: Maze,
    top: &'t Top<'t>,
    /// The line that is read.
    chars: Vec<char>,
    start: Option<(Point, Place)>,
    finish: Vec<Point>,
    unknown: Counted,
    part: Counted,
}

impl Reader<'_> {
    /// The place of a character of a line.
    fn place(&self, line: u32, column: usize) -> Place {
        Place { line, column: (self.top.margin() + column) as u32 + 1 }
    }

    fn error<T>(&self, line: u32, column: usize, problem: Problem) -> Result<T, MicromouseError> {
        Err(MicromouseError::text(line, self.top.margin() + column + 1, problem))
    }

    fn wrong<T>(&self, line: u32, column: usize, what: Expected, found: char) -> Result<T, MicromouseError> {
        self.error(line, column, Problem::Expected { what, found: Some(found) })
    }

    /// A line as characters, as wide as the first.
    fn take(&mut self, line: u32, row: &str) -> Result<(), MicromouseError> {
        let first = self.top.columns();
        self.chars.clear();
        self.chars.extend(row.chars());
        // A tab hides how wide the line is.
        if let Some(column) = self.chars.iter().position(|&c| c == '\t') {
            return self.wrong(line, column, Expected::Space, '\t');
        }
        while self.chars.len() > first && self.chars.last() == Some(&' ') {
            self.chars.pop();
        }
        let columns = self.chars.len();
        if columns == first {
            return Ok(());
        }
        self.error(line, columns.min(first), Problem::Ragged { columns, first })
    }

    /// Posts, and the walls south of row `y`.
    fn posts(&mut self, line: u32, row: &str, y: i32) -> Result<(), MicromouseError> {
        self.take(line, row)?;
        let (pitch, height) = (self.top.pitch, self.maze.bounds().height().cast_signed());
        let mut posts = self.chars.iter().enumerate().step_by(pitch);
        if let Some((column, &found)) = posts.find(|(_, c)| !self.top.is_post(**c)) {
            return self.wrong(line, column, Expected::Post { columns: pitch }, found);
        }
        for x in 0..self.maze.bounds().width() as usize {
            let from = x * pitch + 1;
            let at = Point::new(x as i32, y);
            let place = self.place(line, from);
            match self.piece(&self.chars[from..from + pitch - 1]) {
                Piece::Odd(odd) => {
                    return self.wrong(
                        line,
                        from + odd,
                        Expected::Dashes { columns: pitch - 1 },
                        self.chars[from + odd],
                    );
                }
                Piece::Wall => continue,
                Piece::Unknown => {
                    self.unknown.add(place);
                    continue;
                }
                Piece::PartOfWall => {
                    self.part.add(place);
                    continue;
                }
                Piece::PartOfNone => self.part.add(place),
                Piece::Open => {}
            }
            if y == 0 {
                return self.error(line, from, Problem::Open { square: at, side: Heading::South });
            }
            if y == height {
                let square = at.step(Heading::South);
                return self.error(line, from, Problem::Open { square, side: Heading::North });
            }
            self.maze.draw(at, Heading::South);
        }
        Ok(())
    }

    /// What the characters between two posts are.
    fn piece(&self, piece: &[char]) -> Piece {
        let blank = |c: &char| c.is_whitespace();
        let unknown = |c: &char| UNKNOWN.contains(c);
        if piece.iter().all(blank) {
            return Piece::Open;
        }
        if piece.iter().all(|c| blank(c) || unknown(c)) {
            return Piece::Unknown;
        }
        match self.top.style() {
            Style::Strict => {
                match piece.iter().position(|c| Some(c) != piece.first() || !matches!(c, '-' | ' ')) {
                    Some(odd) => Piece::Odd(odd),
                    None => Piece::Wall,
                }
            }
            Style::Loose if !piece.iter().any(blank) => Piece::Wall,
            Style::Loose if blank(&piece[(piece.len() - 1) / 2]) => Piece::PartOfNone,
            Style::Loose => Piece::PartOfWall,
        }
    }

    /// Row `y`: walls and the middles of squares.
    fn squares(&mut self, line: u32, row: &str, y: i32) -> Result<(), MicromouseError> {
        self.take(line, row)?;
        let (pitch, last) = (self.top.pitch, self.chars.len() - 1);
        let middle = pitch / 2;
        for column in 0..=last {
            let found = self.chars[column];
            let at = Point::new((column / pitch) as i32, y);
            match (column % pitch, found) {
                (0, ' ') if column == last => {
                    let square = at.step(Heading::West);
                    return self.error(line, column, Problem::Open { square, side: Heading::East });
                }
                (0, ' ') => {
                    self.maze.draw(at, Heading::West);
                }
                (0, '|') | (_, ' ') => {}
                (0, _) if UNKNOWN.contains(&found) => {
                    let place = self.place(line, column);
                    self.unknown.add(place);
                }
                (0, _) => match self.top.style() {
                    Style::Loose if !found.is_whitespace() => {}
                    Style::Loose | Style::Strict => return self.wrong(line, column, Expected::Bar, found),
                },
                // Where there are two columns in the middle, either is.
                (of, _) if of == middle || of == pitch - middle => self.mark(line, column, at)?,
                _ => return self.wrong(line, column, Expected::Space, found),
            }
        }
        Ok(())
    }

    /// The middle of a square.
    fn mark(&mut self, line: u32, column: usize, at: Point) -> Result<(), MicromouseError> {
        match self.chars[column] {
            'S' => {
                let place = self.place(line, column);
                match self.start.replace((at, place)) {
                    Some((_, first)) => self.error(line, column, Problem::SecondStart { first }),
                    None => Ok(()),
                }
            }
            'G' | '@' => {
                self.finish.push(at);
                Ok(())
            }
            found => self.wrong(line, column, Expected::Mark, found),
        }
    }
}
