//! Robots' minds: each is fed with sightings and answers with decisions, and tells what it does.
//!
//! An explorer cannot see the maze: nothing here imports `maze`, `world` or `route`. The same sightings give
//! the same answers; chance comes only from a seed. [`book`] is the book's own and tells everything as
//! events; all others are [`mind::Robot`]s and tell line by line of their pseudo-code what they do
//! ([`tell::Tell`]), and which case it was. [`name::Name`] lists them all.

use crate::event::{Decision, Sighting};

#[macro_use]
mod tables;

pub mod book;
pub mod cornell;
pub mod depth_first;
pub mod flood_fill;
pub mod glossary;
pub mod hand;
pub mod mapping;
pub mod mind;
pub mod name;
pub mod node_search;
pub mod parex;
mod places;
pub mod squares;
pub mod sums;
mod taste;
pub mod tell;
pub mod tremaux;

/// A robot's mind that tells its work as events.
pub trait Explorer {
    /// What it tells about its work at a stop.
    type Event;

    /// Decides at a stop, and emits what it does on the way, in order.
    fn decide(&mut self, sighting: Sighting, emit: impl FnMut(Self::Event)) -> Decision;
}
