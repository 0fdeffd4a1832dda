//! A run as transport, time line and projector need it, whoever drives: they name no explorer, so that what
//! belongs to the others stays in a part of the page that comes when it is chosen.

use crate::playback::{Mark, Timeline};
use crate::route::{Drive, TurnList};
use crate::web::run_view::Run;

/// A run that can be played.
pub trait Played: Send + Sync {
    /// Who drives.
    fn title(&self) -> &'static str;

    /// Round 1.
    fn line(&self) -> &dyn Timeline;

    /// Round 2, if a way to the finish was found.
    fn drive(&self) -> Option<&Drive>;

    /// The letters of round 2.
    fn list(&self) -> Option<&TurnList>;

    /// Cells driven when the robot arrives at a stop.
    fn cells(&self, stop: u32) -> u64;

    /// What a stop was, in a word or two.
    fn word(&self, stop: u32) -> String;

    /// The kinds of stops that can be searched for, with their names.
    fn kinds(&self) -> &[(Mark, &'static str)];
}

impl Played for Run {
    fn title(&self) -> &'static str {
        "The book’s explorer"
    }

    fn line(&self) -> &dyn Timeline {
        &self.trace
    }

    fn drive(&self) -> Option<&Drive> {
        self.drive.as_ref()
    }

    fn list(&self) -> Option<&TurnList> {
        self.list.as_ref()
    }

    fn cells(&self, stop: u32) -> u64 {
        Self::cells(self, stop)
    }

    fn word(&self, stop: u32) -> String {
        let what = name(self.trace.mark(stop), stop);
        match self.trace.step(stop).map_or(0, |step| step.node()) {
            0 => what.to_owned(),
            node => format!("{what} · node {node}"),
        }
    }

    fn kinds(&self) -> &[(Mark, &'static str)] {
        &Mark::NAMED
    }
}

/// A mark in the book's words.
#[must_use]
pub const fn name(mark: Mark, stop: u32) -> &'static str {
    match mark {
        Mark::Plain if stop == 0 => "start",
        Mark::Plain => "corner",
        Mark::Node => "node",
        Mark::DeadEnd => "dead end",
        Mark::Known => "RETURN-KNOWN",
        Mark::Unknown => "RETURN-UNKNOWN",
        Mark::End => "end",
    }
}
