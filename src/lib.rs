//! Line Maze Lab: line mazes, the robot that explores them without a map, and what it thinks at every stop.
#![no_std]

extern crate alloc;
#[cfg(any(test, feature = "cli", feature = "web"))]
extern crate std;

pub mod geometry;
pub mod maze;
