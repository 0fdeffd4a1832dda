//! Grids of `#` and blanks: walls as thick as ways, with `S` for the start and `G` or `@` for the goal.
//!
//! ```text
//! #######
//! #S   G#
//! # ### #
//! #     #
//! #######
//! ```
//!
//! Most programs draw squares at every second place and the walls between them on the others; such a grid is read as
//! just that. In any other, every open place is a square.

use alloc::vec::Vec;

use super::error::{Expected, MicromouseError, Problem};
use super::{after, indented, squares, started};
use crate::geometry::{Heading, Point};
use crate::maze::remark::Grid;
use crate::maze::text::Place;
use crate::maze::{BoundsError, Kind, MAX_SIDE, Maze, Reading, Remark, Start};

/// A place of a grid.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(in crate::maze) enum Cell {
    /// Closed.
    Wall,
    /// Open.
    Open,
    /// Open, and the start.
    Start,
    /// Open, and part of the finish.
    Finish,
}

/// The places of a grid, row by row from the north.
pub(in crate::maze) struct Cells {
    /// Places from west to east.
    pub(in crate::maze) width: usize,
    /// All of them.
    pub(in crate::maze) cells: Vec<Cell>,
}

impl Cell {
    const fn of(c: char) -> Option<Self> {
        match c {
            '#' => Some(Self::Wall),
            ' ' | '.' => Some(Self::Open),
            'S' => Some(Self::Start),
            'G' | '@' | 'E' => Some(Self::Finish),
            _ => None,
        }
    }
}

/// Whether this line can be the outer wall of a grid; a way in or out may be marked in it.
pub(super) fn begins(line: &str) -> bool {
    let wall = line.trim();
    let closed = wall.chars().filter(|&c| c == '#').count();
    closed >= 3
        && closed + 2 >= wall.chars().count()
        && wall.chars().all(|c| Cell::of(c).is_some_and(|cell| cell != Cell::Open))
}

/// Whether a grid begins here and nothing else does: the next line is as wide, and begins with a wall too.
pub(super) fn is_sure(line: &str, next: &str) -> bool {
    let (indent, wall) = indented(line);
    let below = next.strip_prefix(indent).map(str::trim_end);
    let is_row = |below: &str| {
        below.chars().count() == wall.trim_end().chars().count()
            && below.starts_with(['#', 'S', 'G', '@', 'E'])
    };
    begins(line) && below.is_some_and(is_row)
}

/// Reads the grid whose first line is the one with this index.
pub(super) fn read(
    lines: &[(u32, &str)],
    from: usize,
    mut remarks: Vec<Remark>,
) -> Result<Reading, MicromouseError> {
    let (line, first) = lines[from];
    let (indent, first) = indented(first);
    let (margin, width) = (indent.chars().count(), first.trim_end().chars().count());
    let mut cells = Cells { width, cells: Vec::new() };
    let mut end = from;
    for &(line, row) in &lines[from..] {
        let Some(row) = row.strip_prefix(indent).map(str::trim_end).filter(|row| is_row(row, width)) else {
            break;
        };
        if end - from > 2 * MAX_SIDE as usize {
            return Err(MicromouseError::text(line, 1, Problem::Bounds(BoundsError::TooLarge)));
        }
        for (column, c) in row.chars().enumerate() {
            let cell = Cell::of(c).ok_or_else(|| {
                MicromouseError::expected(line, margin + column + 1, Expected::GridPlace, Some(c))
            })?;
            cells.cells.push(cell);
        }
        let columns = row.chars().count();
        if columns != width {
            let column = margin + columns.min(width) + 1;
            return Err(MicromouseError::text(line, column, Problem::Ragged { columns, first: width }));
        }
        end += 1;
    }
    if margin > 0 {
        remarks.push(Remark::Indented { columns: margin as u32, line });
    }
    let place =
        |column: usize, row: usize| Place { line: lines[from + row].0, column: (margin + column) as u32 + 1 };
    for (column, row) in cells.entrances() {
        remarks.push(Remark::Entrance(place(column, row)));
    }
    remarks.extend(after(&lines[end..]));
    let reading = cells.reading().map_err(|(column, row, problem)| {
        let Place { line, column } = place(column, row);
        MicromouseError::text(line, column as usize, problem)
    })?;
    remarks.extend(reading.remarks);
    Ok(Reading { remarks, ..reading })
}

/// Whether a line belongs to a grid: it begins with the outer wall, or should.
fn is_row(row: &str, width: usize) -> bool {
    let is_wide = row.chars().count() == width;
    row.starts_with('#') || is_wide && row.ends_with('#') && row.chars().all(|c| Cell::of(c).is_some())
}

impl Cells {
    fn height(&self) -> usize {
        self.cells.len() / self.width.max(1)
    }

    fn at(&self, column: usize, row: usize) -> Cell {
        self.cells.get(row * self.width + column).copied().unwrap_or(Cell::Wall)
    }

    /// The marks in the outer wall, row by row.
    fn entrances(&self) -> Vec<(usize, usize)> {
        let marked = |&nth: &usize| matches!(self.cells[nth], Cell::Start | Cell::Finish);
        let place = |nth: usize| (nth % self.width, nth / self.width);
        let outside = |&(column, row): &(usize, usize)| {
            column == 0 || row == 0 || column + 1 == self.width || row + 1 == self.height()
        };
        (0..self.cells.len()).filter(marked).map(place).filter(outside).collect()
    }

    /// The maze; else the place (column and row, from 0) where something is wrong.
    pub(in crate::maze) fn reading(mut self) -> Result<Reading, (usize, usize, Problem)> {
        self.close()?;
        let (width, height) = (self.width, self.height());
        let all = || (0..height).flat_map(move |row| (0..width).map(move |column| (column, row)));
        let between = width % 2 == 1
            && height % 2 == 1
            && all().all(|(column, row)| match (column % 2, row % 2, self.at(column, row)) {
                (0, 0, cell) => cell == Cell::Wall,
                (1, 1, cell) => cell != Cell::Wall,
                (_, _, cell) => matches!(cell, Cell::Wall | Cell::Open),
            });
        let (grid, step) = if between { (Grid::Between, 2) } else { (Grid::Squares, 1) };
        let (across, down) = ((width - 2).div_ceil(step), (height - 2).div_ceil(step));
        let bounds = squares(across, down).map_err(|error| (0, 0, Problem::Bounds(error)))?;
        let mut maze = Maze::new(bounds);
        maze.kind = Kind::Wall;
        let mut start: Option<(Point, usize, usize)> = None;
        let mut finish = Vec::new();
        for at in bounds.points() {
            let (column, row) = (at.x as usize * step + 1, (bounds.ne().y - at.y) as usize * step + 1);
            match self.at(column, row) {
                Cell::Wall => continue,
                Cell::Open => {}
                Cell::Finish => finish.push(at),
                Cell::Start => {
                    if let Some((_, column, row)) = start.replace((at, column, row)) {
                        return Err((column, row, Problem::AnotherStart));
                    }
                }
            }
            if self.at(column, row - 1) != Cell::Wall {
                maze.draw(at, Heading::North);
            }
            if self.at(column + 1, row) != Cell::Wall {
                maze.draw(at, Heading::East);
            }
        }
        maze.set_finish(finish);
        let remarks = alloc::vec![Remark::Grid(grid)];
        let Some((at, _, _)) = start else { return Ok(unstarted(maze, remarks)) };
        Ok(started(maze, at, remarks))
    }

    /// Closes marked ways through the outer wall; the mark goes to the place inside.
    fn close(&mut self) -> Result<(), (usize, usize, Problem)> {
        let (width, height) = (self.width, self.height());
        if width < 3 || height < 3 {
            return Err((0, 0, Problem::NoInside));
        }
        for row in 0..height {
            for column in 0..width {
                let inside = (column.clamp(1, width - 2), row.clamp(1, height - 2));
                let cell = self.at(column, row);
                if inside == (column, row) || cell == Cell::Wall {
                    continue;
                }
                let is_corner = inside.0 != column && inside.1 != row;
                if cell == Cell::Open || is_corner || self.at(inside.0, inside.1) == Cell::Wall {
                    return Err((column, row, Problem::Gap));
                }
                self.cells[row * width + column] = Cell::Wall;
                self.cells[inside.1 * width + inside.0] = cell;
            }
        }
        Ok(())
    }
}

/// A maze whose file names no start: it is put in the south-west, where contests have it, if that square is open.
fn unstarted(maze: Maze, mut remarks: Vec<Remark>) -> Reading {
    let at = maze.bounds().sw();
    if maze.ways(at).is_empty() {
        remarks.push(Remark::NoStart { put: None });
        if maze.finish().is_empty() {
            remarks.push(Remark::NoFinish);
        }
        return Reading { maze, remarks };
    }
    let put = Some(Start { at, heading: super::heading(&maze, at) });
    remarks.push(Remark::NoStart { put });
    started(maze, at, remarks)
}
