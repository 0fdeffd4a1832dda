//! What the sensors saw lately: the samples behind the plot.

use alloc::collections::VecDeque;

use super::report::Ir;

/// Samples that are kept: more than six seconds at 100 a second.
pub const KEPT_SAMPLES: usize = 1_024;
/// Stops that are kept with them.
const KEPT_STOPS: usize = 64;
/// Without a sample for so long, the plot waits for data.
const STALE_MS: u64 = 1_000;

/// What there is to see.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Showing {
    /// Nothing: no sample came lately.
    #[default]
    Waiting,
    /// What the robot senses now.
    Live,
    /// What came last on a connection that is over.
    Over,
}

/// The last samples, and the stops among them.
#[derive(Debug, Default)]
pub struct Plot {
    samples: VecDeque<(u64, Ir)>,
    stops: VecDeque<u32>,
    life: Life,
}

/// Whether more can come.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
enum Life {
    #[default]
    Goes,
    Ended,
}

impl Plot {
    pub(super) fn push(&mut self, ir: Ir, now_ms: u64) {
        if self.samples.len() == KEPT_SAMPLES {
            self.samples.pop_front();
        }
        self.samples.push_back((now_ms, ir));
    }

    /// The connection has ended: what is here stays, and is of the past.
    pub(super) const fn end(&mut self) {
        self.life = Life::Ended;
    }

    /// The robot reached a stop at this moment of its clock.
    pub(super) fn stop(&mut self, robot_ms: u32) {
        if self.stops.len() == KEPT_STOPS {
            self.stops.pop_front();
        }
        self.stops.push_back(robot_ms);
    }

    /// The robot's clock begins anew.
    pub(super) fn clear(&mut self) {
        *self = Self::default();
    }

    /// The samples of the last `span_ms` of the robot's clock, oldest first.
    pub fn samples(&self, span_ms: u32) -> impl Iterator<Item = &Ir> {
        let newest_ms = self.samples.back().map_or(0, |(_, ir)| ir.ms);
        self.samples.iter().map(|(_, ir)| ir).filter(move |ir| newest_ms.wrapping_sub(ir.ms) <= span_ms)
    }

    /// When the robot reached stops, on its clock, oldest first.
    pub fn stops(&self) -> impl Iterator<Item = u32> {
        self.stops.iter().copied()
    }

    /// What there is to see.
    #[must_use]
    pub fn showing(&self, now_ms: u64) -> Showing {
        match (self.samples.back(), self.life) {
            (Some(_), Life::Ended) => Showing::Over,
            (Some(&(came_ms, _)), Life::Goes) if now_ms.saturating_sub(came_ms) <= STALE_MS => Showing::Live,
            (Some(_) | None, _) => Showing::Waiting,
        }
    }
}
