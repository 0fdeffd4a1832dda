//! When each place of the node table was visited: the stops at nodes, sorted by place, then by time.

use alloc::vec::Vec;

use super::Step;

/// Stop numbers, from 1. Which place a stop belongs to is read from its step, so nothing else is kept.
#[derive(Clone, Debug, Default)]
pub(super) struct Visits(Vec<u32>);

impl Visits {
    /// The visits of a whole run, sorted by counting.
    pub(super) fn of(steps: &[Step]) -> Self {
        let visits = || steps.iter().zip(1u32..).filter(|(step, _)| step.node() > 0);
        let places = steps.iter().map(|step| step.node() as usize).max().unwrap_or(0);
        // First how many visits each place has, then where its next one goes.
        let mut next = alloc::vec![0u32; places + 1];
        for (step, _) in visits() {
            next[step.node() as usize] += 1;
        }
        let mut all = 0;
        for place in &mut next {
            all += core::mem::replace(place, all);
        }
        let mut stops = alloc::vec![0u32; all as usize];
        for (step, stop) in visits() {
            let next = &mut next[step.node() as usize];
            stops[*next as usize] = stop;
            *next += 1;
        }
        Self(stops)
    }

    /// The visits to place `m` up to this stop, in order; `steps` are those that it was made of.
    pub(super) fn until(&self, steps: &[Step], m: u32, stop: u32) -> &[u32] {
        let place = |visit: u32| steps[visit as usize - 1].node();
        let from = self.0.partition_point(|&visit| place(visit) < m);
        let visits = &self.0[from..];
        &visits[..visits.partition_point(|&visit| place(visit) == m && visit <= stop)]
    }

    pub(super) const fn bytes(&self) -> usize {
        size_of_val(self.0.as_slice())
    }
}
