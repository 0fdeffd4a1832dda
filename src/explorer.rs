//! Robots' minds: each is fed with sightings and answers with decisions, and tells what it does as events.
//!
//! An explorer cannot see the maze: nothing here imports `maze`, `world` or `route`. The same sightings give
//! the same events; chance comes only from a seed.

use crate::event::{Decision, Sighting};

pub mod book;

/// A robot's mind.
pub trait Explorer {
    /// What it tells about its work at a stop.
    type Event;

    /// Decides at a stop, and emits what it does on the way, in order.
    fn decide(&mut self, sighting: Sighting, emit: impl FnMut(Self::Event)) -> Decision;
}
