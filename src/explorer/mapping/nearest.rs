//! The nearest point that has an unexplored way, by distance driven over known points: Dijkstra's search from
//! where the robot stands, which goes no further than it must.

use alloc::collections::BinaryHeap;
use alloc::vec::Vec;
use core::cmp::Reverse;
use core::fmt;

use super::{Mapping, NONE, PREFERENCE};
use crate::geometry::Heading;

/// What a search leaves behind; nothing of it is remembered, so a copy begins with none.
#[derive(Default)]
pub(super) struct Nearest {
    /// By point; what a search asks for together lies together.
    notes: Vec<Note>,
    heap: BinaryHeap<Reverse<(u64, u32)>>,
    search: u32,
}

/// What is noted about a point.
#[derive(Clone, Copy, Debug, Default)]
struct Note {
    distance: u64,
    /// The search that met it last.
    met: u32,
    /// The search that found it on a shortest way to its target.
    on_way: u32,
}

impl fmt::Debug for Nearest {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str("Nearest")
    }
}

impl Clone for Nearest {
    fn clone(&self) -> Self {
        Self::default()
    }
}

impl Nearest {
    /// The target and the ways to it, the first one last. Of points equally near, it is the one recorded
    /// first; of ways equally short, at each point the first of the paper's order.
    pub(super) fn find(&mut self, map: &Mapping, from: u32) -> Option<(u32, Vec<Heading>)> {
        if self.notes.len() < map.points.len() {
            // In doubling steps: this runs at every dead end.
            self.notes.resize((2 * map.points.len()).max(64), Note::default());
        }
        self.search += 1;
        self.heap.clear();
        self.meet(from, 0);
        let target = self.settle(map)?;
        self.mark(map, target);
        let mut ways = Vec::new();
        let mut at = from;
        while at != target {
            let way = PREFERENCE.into_iter().find(|&way| {
                let next = map.points[at as usize].links[usize::from(way.index())];
                next != NONE
                    && self.notes[next as usize].on_way == self.search
                    && self.notes[next as usize].distance
                        == self.notes[at as usize].distance + map.length(at, next)
            })?;
            ways.push(way);
            at = map.points[at as usize].links[usize::from(way.index())];
        }
        ways.reverse();
        Some((target, ways))
    }

    fn meet(&mut self, point: u32, distance: u64) {
        let note = &mut self.notes[point as usize];
        if note.met != self.search || distance < note.distance {
            (note.met, note.distance) = (self.search, distance);
            self.heap.push(Reverse((distance, point)));
        }
    }

    /// The heap gives equal distances in the order of their numbers, and lengths are above 0: the first
    /// point with an unexplored way is the one.
    fn settle(&mut self, map: &Mapping) -> Option<u32> {
        while let Some(Reverse((distance, point))) = self.heap.pop() {
            if distance > self.notes[point as usize].distance {
                continue;
            }
            if !map.unexplored(point).is_empty() {
                return Some(point);
            }
            for next in map.neighbours(point) {
                self.meet(next, distance + map.length(point, next));
            }
        }
        None
    }

    /// Marks all points on shortest ways to the target.
    fn mark(&mut self, map: &Mapping, target: u32) {
        let mut todo = alloc::vec![target];
        self.notes[target as usize].on_way = self.search;
        while let Some(point) = todo.pop() {
            let distance = self.notes[point as usize].distance;
            for before in map.neighbours(point) {
                let note = &mut self.notes[before as usize];
                if note.met == self.search
                    && note.on_way != self.search
                    && note.distance + map.length(before, point) == distance
                {
                    note.on_way = self.search;
                    todo.push(before);
                }
            }
        }
    }
}
