//! `.maz`: exactly 256 bytes for 16 × 16 squares, column by column from the south-west, one bit a wall.
//!
//! The content decides, not the name: old `.maz` files of the mms simulator are `.num` text.

use alloc::vec;
use alloc::vec::Vec;

use super::error::{MicromouseError, Problem, Spot};
use super::squares::{Squares, walls};
use super::usual_start;
use crate::geometry::{Point, Ways};
use crate::maze::{BoundsError, Maze};

/// Squares along a side.
pub(super) const SIDE: usize = 16;
const BYTES: usize = SIDE * SIDE;

/// Whether these bytes are rather walls than text: control characters that no text has, and nothing else, or
/// the right length.
pub(super) fn looks_like(bytes: &[u8]) -> bool {
    let control = |byte: &u8| *byte < 0x20 && !matches!(byte, b'\t' | b'\n' | b'\r');
    let wall = |byte: &u8| *byte < 0x10;
    bytes.iter().any(control) && (bytes.len() == BYTES || bytes.iter().all(wall))
}

pub(super) fn read(bytes: &[u8]) -> Result<Maze, MicromouseError> {
    if bytes.len() != BYTES {
        return Err(MicromouseError { spot: Spot::File, problem: Problem::Length { bytes: bytes.len() } });
    }
    let bounds = super::squares(SIDE, SIDE).map_err(too_large)?;
    let mut squares = Squares::new(bounds);
    for (index, &byte) in bytes.iter().enumerate() {
        if byte > 0b1111 {
            return Err(MicromouseError { spot: Spot::Byte(index), problem: Problem::Bits { byte } });
        }
        let square = Point::new((index / SIDE) as i32, (index % SIDE) as i32);
        // Bit 0 is north, then clockwise: as in a set of ways.
        squares.set(square, Ways::from_bits(byte));
    }
    let mut maze = squares
        .maze()
        .map_err(|(square, problem)| MicromouseError { spot: Spot::Byte(index(square)), problem })?;
    maze.set_start(Some(usual_start(bounds)));
    Ok(maze)
}

/// 16 × 16 squares that begin at 0,0 are never too many.
const fn too_large(error: BoundsError) -> MicromouseError {
    MicromouseError { spot: Spot::File, problem: Problem::Bounds(error) }
}

/// Where a square stands in the file.
const fn index(square: Point) -> usize {
    square.x.unsigned_abs() as usize * SIDE + square.y.unsigned_abs() as usize
}

/// The bytes of a maze of 16 × 16 squares.
pub(super) fn write(maze: &Maze) -> Vec<u8> {
    let sw = maze.bounds().sw();
    let mut bytes = vec![0; BYTES];
    for square in maze.bounds().points() {
        let place = index(Point::new(square.x - sw.x, square.y - sw.y));
        if let Some(byte) = bytes.get_mut(place) {
            *byte = walls(maze, square).bits();
        }
    }
    bytes
}
