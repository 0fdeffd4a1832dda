//! The report of an explorer that could not be put down at the start: all numbers are null.

use alloc::string::{String, ToString};

use serde::ser::SerializeMap;
use serde::{Serialize, Serializer};

use crate::explorer::name::Name;
use crate::world::CannotStart;

/// The outcome of a run that cannot begin, as tables and reports have it.
pub const CANNOT_START: &str = "cannot-start";

/// What every [`Report`](super::Report) has and says nothing here.
const NOTHING: [&str; 19] = [
    "stops",
    "decisions",
    "distance_cells",
    "distance_mm",
    "turns",
    "right_turns",
    "left_turns",
    "u_turns",
    "seconds",
    "memory_bytes",
    "ptr",
    "route_cells",
    "route_s",
    "shortest_cells",
    "shortest_s",
    "fastest_cells",
    "fastest_s",
    "ratio_shortest",
    "ratio_fastest",
];

/// Who could not start, and why; as JSON it has the keys of a [`Report`](super::Report).
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct NotStarted {
    /// Who.
    pub explorer: Name,
    /// Why, with a cure.
    pub reason: String,
}

impl NotStarted {
    /// Of an explorer in a maze.
    #[must_use]
    pub fn of(explorer: Name, why: CannotStart) -> Self {
        Self { explorer, reason: why.to_string() }
    }
}

impl Serialize for NotStarted {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        let mut report = serializer.serialize_map(Some(3 + NOTHING.len()))?;
        report.serialize_entry("explorer", self.explorer.text())?;
        report.serialize_entry("outcome", CANNOT_START)?;
        report.serialize_entry("reason", &self.reason)?;
        for key in NOTHING {
            report.serialize_entry(key, &None::<u32>)?;
        }
        report.end()
    }
}
