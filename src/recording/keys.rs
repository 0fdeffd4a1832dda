//! Copies of a mind along a run. They stand further apart the larger the mind is, so that copying costs little
//! against deciding; where they get too many or take too much memory, every other one is dropped, so a
//! recording of any length has a few dozen.

use alloc::vec::Vec;

use crate::explorer::mind::Mind;

/// Stops between two keyframes of a short run.
const CLOSEST: usize = 256;
/// Bytes of a mind that may be copied for each stop.
const BYTES_A_STOP: usize = 32;
/// The most copies.
const MOST: usize = 64;
/// The most bytes of all copies, as long as there is more than one.
const BUDGET: usize = 64 << 20;

/// A mind that is ready for a stop.
#[derive(Clone, Debug)]
struct Key {
    stop: usize,
    mind: Mind,
}

/// The copies: the first is the mind before stop 0.
#[derive(Clone, Debug)]
pub(super) struct Keys {
    keys: Vec<Key>,
    every: usize,
    next: usize,
    bytes: usize,
}

impl Keys {
    pub(super) const fn new() -> Self {
        Self { keys: Vec::new(), every: CLOSEST, next: 0, bytes: 0 }
    }

    /// The mind is ready for this stop: a copy is kept if it is due.
    pub(super) fn offer(&mut self, stop: usize, mind: &Mind) {
        if stop < self.next {
            return;
        }
        let bytes = mind.robot().host_bytes();
        let last = self.keys.last().map_or(0, |key| key.stop);
        // A mind may have grown since the last copy: then this one waits.
        let due = if stop == 0 { 0 } else { last + self.every.max(bytes / BYTES_A_STOP) };
        if stop < due {
            self.next = due;
            return;
        }
        self.keys.push(Key { stop, mind: mind.clone() });
        self.bytes += bytes;
        while self.keys.len() > MOST || self.bytes > BUDGET && self.keys.len() > 1 {
            let mut place = 0;
            self.keys.retain(|_| {
                place += 1;
                place % 2 == 1
            });
            self.every *= 2;
            self.bytes = self.keys.iter().map(|key| key.mind.robot().host_bytes()).sum();
        }
        self.next = self.keys.last().map_or(0, |key| key.stop) + self.every;
    }

    /// The last copy that is not past a stop, and the stop that it is ready for.
    pub(super) fn before(&self, stop: u32) -> (u32, &Mind) {
        let place = self.keys.partition_point(|key| key.stop <= stop as usize).saturating_sub(1);
        let key = &self.keys[place];
        (key.stop as u32, &key.mind)
    }

    pub(super) const fn bytes(&self) -> usize {
        self.bytes
    }
}
