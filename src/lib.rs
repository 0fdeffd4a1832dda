//! Line Maze Lab: line mazes, the robot that explores them without a map, and what it thinks at every stop.
//!
//! In reading order: [`geometry`] and [`event`] are the words that everything speaks; [`maze`] is what is
//! drawn; [`world`] lets a robot drive in it; an [`explorer`] is a robot's mind; [`run`] brings them together
//! and writes a [`trace`]; [`ink`] and [`route`] say what that means on the floor, [`report`] in numbers;
//! [`playback`] moves through it in time.
// The page is written against std; the core and everything that a board runs is not.
#![cfg_attr(not(feature = "web"), no_std)]

extern crate alloc;
#[cfg(all(any(test, feature = "cli"), not(feature = "web")))]
extern crate std;

pub mod brief;
pub mod compare;
mod csv;
pub mod decimal;
pub mod event;
pub mod explorer;
pub mod geometry;
pub mod gesture;
mod grouped;
pub mod ink;
pub mod link;
pub mod maze;
pub mod playback;
pub mod recording;
pub mod report;
pub mod route;
pub mod run;
pub mod scene;
pub mod settings;
pub mod share;
pub mod trace;
#[cfg(feature = "web")]
pub mod web;
pub mod world;
