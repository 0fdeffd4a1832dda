//! `.maz`: a byte for each square of a square maze (256 for the contests' 16 × 16, 1,024 for 32 × 32), column by
//! column from the south-west, one bit a wall.
//!
//! The content decides, not the name: old `.maz` files of the mms simulator are `.num` text.

use alloc::vec;
use alloc::vec::Vec;

use super::error::{MicromouseError, Problem, Spot};
use super::squares::{Squares, walls};
use crate::geometry::{Point, Ways};
use crate::maze::{BoundsError, Maze, Reading};

/// Whether these bytes are rather walls than text: control characters that no text has, and nothing else, or for
/// the most part and the right length.
pub(super) fn looks_like(bytes: &[u8]) -> bool {
    let control = |byte: &u8| *byte < 0x20 && !matches!(byte, b'\t' | b'\n' | b'\r');
    let walls = bytes.iter().filter(|&&byte| byte < 0x10).count();
    bytes.iter().any(control)
        && (walls == bytes.len() || walls > bytes.len() / 2 && side(bytes.len()).is_some())
}

/// The side of a square of so many squares.
const fn side(squares: usize) -> Option<usize> {
    let side = squares.isqrt();
    if side * side == squares { Some(side) } else { None }
}

pub(super) fn read(bytes: &[u8]) -> Result<Reading, MicromouseError> {
    let whole = |problem| MicromouseError { spot: Spot::File, problem };
    let side = side(bytes.len()).ok_or_else(|| whole(Problem::Length { bytes: bytes.len() }))?;
    let bounds = super::squares(side, side).map_err(|error: BoundsError| whole(Problem::Bounds(error)))?;
    let mut squares = Squares::new(bounds);
    for (index, &byte) in bytes.iter().enumerate() {
        if byte > 0b1111 {
            return Err(MicromouseError { spot: Spot::Byte(index), problem: Problem::Bits { byte } });
        }
        let square = Point::new((index / side) as i32, (index % side) as i32);
        // Bit 0 is north, then clockwise: as in a set of ways.
        squares.set(square, Ways::from_bits(byte));
    }
    let maze = squares
        .maze()
        .map_err(|(square, problem)| MicromouseError { spot: Spot::Byte(index(square, side)), problem })?;
    Ok(super::started(maze, bounds.sw(), Vec::new()))
}

/// Where a square stands in the file.
const fn index(square: Point, side: usize) -> usize {
    square.x.unsigned_abs() as usize * side + square.y.unsigned_abs() as usize
}

/// The bytes of a maze that is as high as it is wide.
pub(super) fn write(maze: &Maze) -> Vec<u8> {
    let (sw, side) = (maze.bounds().sw(), maze.bounds().height() as usize);
    let mut bytes = vec![0; maze.bounds().len()];
    for square in maze.bounds().points() {
        let place = index(Point::new(square.x - sw.x, square.y - sw.y), side);
        if let Some(byte) = bytes.get_mut(place) {
            *byte = walls(maze, square).bits();
        }
    }
    bytes
}
