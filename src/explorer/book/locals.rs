//! What the functions of the pseudo-code hold while they run: `m`, `d` and `arrival`. They are set by a line and gone
//! when their function returns, so they belong to moments in the middle of a stop, or to its last line.

use super::code::Line;
use crate::geometry::Heading;
use crate::trace::{Frame, Step};

/// Those that a moment has.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Locals {
    /// The node where the bot stands, of `node()` and what it calls; 0 while it is new.
    pub m: Option<u32>,
    /// What `choose_path()` picked.
    pub d: Option<Heading>,
    /// The way by which the bot came, seen from the node: of `node()`.
    pub arrival: Option<Heading>,
    /// The line that ran last set `m`.
    pub m_set: bool,
    /// The line that ran last set `d`.
    pub d_set: bool,
}

/// What the function that ran last holds.
#[must_use]
pub fn locals(frame: &Frame, step: Step) -> Locals {
    let Some(line) = frame.ran.filter(|&line| line >= Line::MATCH) else { return Locals::default() };
    let found = line == Line::TAKE || (line == Line::FIRST && frame.next != Some(Line::NONE_LEFT));
    Locals {
        m: Some(frame.node),
        d: found.then(|| step.departure()),
        arrival: Some(step.arrival().opposite()),
        m_set: line == Line::MATCH || line == Line::RECORD,
        d_set: line == Line::FIRST && found,
    }
}
