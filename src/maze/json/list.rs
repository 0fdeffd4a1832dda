//! Lists of walls as other programs write them in JSON: a number from 0 to 15 for each square, north 1, east 2,
//! south 4, west 8, in lists of one length or in one list of a square maze. Which way the lists run, and whether a
//! bit means a wall or an opening, is seen from the numbers: two squares at a wall must agree, and the outside is
//! closed. Lists of 0 and 1 are a grid.

use alloc::format;
use alloc::string::String;
use alloc::vec::Vec;
use core::fmt;

use serde_json::Value;

use super::error::{self, JsonError, Problem};
use crate::geometry::{Point, Ways};
use crate::maze::micromouse::{self, Cell, Cells, Squares};
use crate::maze::{Maze, Reading, Remark};

/// How a list of walls was read.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Layout {
    /// What the inner lists are.
    pub lists: Lists,
    /// What a bit means.
    pub bits: Bits,
}

/// What the inner lists are, and in which order.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Lists {
    /// Rows, the northern one first.
    RowsFromNorth,
    /// Rows, the southern one first.
    RowsFromSouth,
    /// Columns from the west, each from south to north.
    ColumnsFromSouth,
    /// Columns from the west, each from north to south.
    ColumnsFromNorth,
}

/// What a bit of a square means.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Bits {
    /// A wall on that side.
    Walls,
    /// A way out on that side.
    Openings,
}

impl fmt::Display for Layout {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(match self.lists {
            Lists::RowsFromNorth => "rows from the north",
            Lists::RowsFromSouth => "rows from the south",
            Lists::ColumnsFromSouth => "columns from the west, each from the south",
            Lists::ColumnsFromNorth => "columns from the west, each from the north",
        })?;
        f.write_str(match self.bits {
            Bits::Walls => "; a bit is a wall",
            Bits::Openings => "; a bit is an opening",
        })
    }
}

/// Every layout that is tried.
const LAYOUTS: [Layout; 8] = {
    const fn layout(lists: Lists, bits: Bits) -> Layout {
        Layout { lists, bits }
    }
    [
        layout(Lists::RowsFromNorth, Bits::Walls),
        layout(Lists::RowsFromSouth, Bits::Walls),
        layout(Lists::ColumnsFromSouth, Bits::Walls),
        layout(Lists::ColumnsFromNorth, Bits::Walls),
        layout(Lists::RowsFromNorth, Bits::Openings),
        layout(Lists::RowsFromSouth, Bits::Openings),
        layout(Lists::ColumnsFromSouth, Bits::Openings),
        layout(Lists::ColumnsFromNorth, Bits::Openings),
    ]
};

/// Reads a list of walls.
///
/// # Errors
/// Where the text is no JSON, or no such list, or one that can be read in more than one way.
pub fn read(text: &str) -> Result<Reading, JsonError> {
    let lists: Vec<Value> = serde_json::from_str(text).map_err(|error| error::syntax(text, &error))?;
    let lists = numbers(&lists)?;
    // With these bits alone no square could have a wall to the south.
    if lists.iter().flatten().all(|&number| number < 2) {
        return grid(&lists);
    }
    let mut found: Option<(Maze, Layout)> = None;
    let mut wrong = None;
    for layout in LAYOUTS {
        match layout.maze(&lists) {
            Ok(maze) if found.as_ref().is_some_and(|(first, _)| *first != maze) => {
                return Err(error::value("[0]", Problem::Ambiguous));
            }
            Ok(maze) => found = found.or(Some((maze, layout))),
            Err(error) => wrong = wrong.or(Some(error)),
        }
    }
    match (found, wrong) {
        (Some((maze, layout)), _) => {
            let at = maze.bounds().sw();
            Ok(micromouse::started(maze, at, alloc::vec![Remark::List(layout)]))
        }
        (None, Some(error)) => Err(error),
        (None, None) => Err(error::value("", Problem::NotSquares { numbers: 0 })),
    }
}

/// The numbers of the lists; one list of a square maze is cut into as many as it has numbers.
fn numbers(lists: &[Value]) -> Result<Vec<Vec<u8>>, JsonError> {
    if lists.first().is_none_or(|first| !first.is_array()) {
        let squares = row(lists, |nth| format!("[{nth}]"))?;
        let side = squares.len().isqrt();
        if side == 0 || side * side != squares.len() {
            return Err(error::value("", Problem::NotSquares { numbers: squares.len() }));
        }
        return Ok(squares.chunks(side).map(<[u8]>::to_vec).collect());
    }
    let mut rows: Vec<Vec<u8>> = Vec::new();
    for (nth, list) in lists.iter().enumerate() {
        let list = list.as_array().ok_or_else(|| error::value(&format!("[{nth}]"), Problem::NoList))?;
        let row = row(list, |mth| format!("[{nth}][{mth}]"))?;
        let first = rows.first().map_or(row.len(), Vec::len);
        if row.len() != first || row.is_empty() {
            return Err(error::value(&format!("[{nth}]"), Problem::Uneven { numbers: row.len(), first }));
        }
        rows.push(row);
    }
    Ok(rows)
}

fn row(list: &[Value], path: impl Fn(usize) -> String) -> Result<Vec<u8>, JsonError> {
    let number = |(nth, value): (usize, &Value)| {
        let walls = value.as_u64().and_then(|number| u8::try_from(number).ok()).filter(|&number| number < 16);
        walls.ok_or_else(|| error::value(&path(nth), Problem::NoWalls))
    };
    list.iter().enumerate().map(number).collect()
}

/// Lists of 0 for open places and 1 for closed ones.
fn grid(lists: &[Vec<u8>]) -> Result<Reading, JsonError> {
    let cell = |&number: &u8| if number == 0 { Cell::Open } else { Cell::Wall };
    let cells =
        Cells { width: lists.first().map_or(0, Vec::len), cells: lists.iter().flatten().map(cell).collect() };
    cells
        .reading()
        .map_err(|(column, row, wrong)| error::value(&format!("[{row}][{column}]"), Problem::Grid(wrong)))
}

impl Layout {
    fn maze(self, lists: &[Vec<u8>]) -> Result<Maze, JsonError> {
        let (outer, inner) = (lists.len(), lists.first().map_or(0, Vec::len));
        let (width, height) = match self.lists {
            Lists::RowsFromNorth | Lists::RowsFromSouth => (inner, outer),
            Lists::ColumnsFromSouth | Lists::ColumnsFromNorth => (outer, inner),
        };
        let bounds = micromouse::squares(width, height)
            .map_err(|error| error::value("[0]", Problem::Bounds(error)))?;
        let mut squares = Squares::new(bounds);
        let from_top = |y: usize| bounds.ne().y - y as i32;
        let place = |nth: usize, mth: usize| match self.lists {
            Lists::RowsFromNorth => Point::new(mth as i32, from_top(nth)),
            Lists::RowsFromSouth => Point::new(mth as i32, nth as i32),
            Lists::ColumnsFromSouth => Point::new(nth as i32, mth as i32),
            Lists::ColumnsFromNorth => Point::new(nth as i32, from_top(mth)),
        };
        for (nth, list) in lists.iter().enumerate() {
            for (mth, &bits) in list.iter().enumerate() {
                let walls = match self.bits {
                    Bits::Walls => Ways::from_bits(bits),
                    Bits::Openings => Ways::ALL.minus(Ways::from_bits(bits)),
                };
                squares.set(place(nth, mth), walls);
            }
        }
        squares.maze().map_err(|(at, wrong)| {
            let (x, y) = (at.x as usize, at.y as usize);
            let down = bounds.ne().y as usize - y;
            let (nth, mth) = match self.lists {
                Lists::RowsFromNorth => (down, x),
                Lists::RowsFromSouth => (y, x),
                Lists::ColumnsFromSouth => (x, y),
                Lists::ColumnsFromNorth => (x, down),
            };
            error::value(&format!("[{nth}][{mth}]"), Problem::NoOrder(wrong))
        })
    }
}
