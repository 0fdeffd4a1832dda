//! Copies of a mind at even distances. Where they get too many or take too much memory, every other one is
//! dropped and the distance doubles, so a recording of any length has a few dozen.

use alloc::vec::Vec;

use crate::explorer::mind::Mind;

/// Stops between two keyframes of a short run.
const CLOSEST: usize = 256;
/// The most copies.
const MOST: usize = 64;
/// The most bytes of all copies, as long as there is more than one.
const BUDGET: usize = 64 << 20;

/// The copies: the first is the mind before stop 0.
#[derive(Clone, Debug)]
pub(super) struct Keys {
    minds: Vec<Mind>,
    every: usize,
    bytes: usize,
}

impl Keys {
    pub(super) const fn new() -> Self {
        Self { minds: Vec::new(), every: CLOSEST, bytes: 0 }
    }

    /// The mind is ready for this stop: a copy is kept if it is due.
    pub(super) fn offer(&mut self, stop: usize, mind: &Mind) {
        if !stop.is_multiple_of(self.every) {
            return;
        }
        self.minds.push(mind.clone());
        self.bytes += mind.robot().host_bytes();
        while self.minds.len() > MOST || self.bytes > BUDGET && self.minds.len() > 1 {
            let mut place = 0;
            self.minds.retain(|_| {
                place += 1;
                place % 2 == 1
            });
            self.every *= 2;
            self.bytes = self.minds.iter().map(|mind| mind.robot().host_bytes()).sum();
        }
    }

    /// The last copy that is not past a stop, and the stop that it is ready for.
    pub(super) fn before(&self, stop: u32) -> (u32, &Mind) {
        let place = (stop as usize / self.every).min(self.minds.len() - 1);
        ((place * self.every) as u32, &self.minds[place])
    }

    pub(super) const fn bytes(&self) -> usize {
        self.bytes
    }
}
