//! The shortest and the quickest way over the adjacency list (Sakib and others, 2014, §IV), by Dijkstra's search
//! or A\*, one point at a time, so that the frontier can be watched.
//!
//! A state is a point, and for the quickest way also the heading on arrival, as turns take time.

use alloc::collections::BinaryHeap;
use alloc::vec;
use alloc::vec::Vec;
use core::cmp::Reverse;

use super::{Mapping, NONE};
use crate::geometry::Heading;
use crate::settings;

/// What is to be least.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Aim {
    /// The distance.
    Shortest,
    /// The time, by the robot's costs.
    Quickest,
}

/// A search that goes on.
#[derive(Clone, Debug)]
pub struct Search<'m> {
    map: &'m Mapping,
    aim: Aim,
    /// The smallest rectangle around the finishes that are known, in milliseconds, for A*.
    goal: Option<[i32; 4]>,
    cost: Vec<u64>,
    before: Vec<u32>,
    heap: BinaryHeap<Reverse<(u64, u32)>>,
    settled: Vec<bool>,
    end: Option<u32>,
}

/// A point that a step has settled: its least cost is known.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Settled {
    /// The point.
    pub point: u32,
    /// Milliseconds of driving for the shortest way, nanoseconds for the quickest.
    pub cost: u64,
}

impl<'m> Search<'m> {
    /// A search from the start; Dijkstra or A*.
    #[must_use]
    pub fn new(map: &'m Mapping, aim: Aim, search: settings::Search) -> Self {
        let states = match aim {
            Aim::Shortest => map.points.len(),
            Aim::Quickest => 4 * map.points.len(),
        };
        let mut begun = Self {
            map,
            aim,
            goal: match search {
                settings::Search::Dijkstra => None,
                settings::Search::AStar => around_finishes(map),
            },
            cost: vec![u64::MAX; states],
            before: vec![NONE; states],
            heap: BinaryHeap::new(),
            settled: vec![false; states],
            end: None,
        };
        if !map.points.is_empty() {
            begun.meet(begun.state(0, Heading::North), 0, NONE);
        }
        begun
    }

    const fn state(&self, point: u32, heading: Heading) -> u32 {
        match self.aim {
            Aim::Shortest => point,
            Aim::Quickest => point << 2 | heading.index() as u32,
        }
    }

    const fn point(&self, state: u32) -> u32 {
        match self.aim {
            Aim::Shortest => state,
            Aim::Quickest => state >> 2,
        }
    }

    fn meet(&mut self, state: u32, cost: u64, before: u32) {
        let place = state as usize;
        if cost < self.cost[place] {
            self.cost[place] = cost;
            self.before[place] = before;
            let estimate = cost + self.at_least(self.point(state));
            self.heap.push(Reverse((estimate, state)));
        }
    }

    /// What the way from a point to a finish costs at the very least.
    fn at_least(&self, point: u32) -> u64 {
        let Some([west, south, east, north]) = self.goal else { return 0 };
        let (x, y) = self.map.places.coordinates(point);
        let off = |at: i32, low: i32, high: i32| u64::from(at.abs_diff(at.clamp(low, high)));
        self.driven(off(x, west, east) + off(y, south, north))
    }

    /// What so many milliseconds of driving cost.
    fn driven(&self, ms: u64) -> u64 {
        match self.aim {
            Aim::Shortest => ms,
            Aim::Quickest => {
                (u128::from(ms) * u128::from(self.map.costs.cell) / u128::from(self.map.cell_ms)) as u64
            }
        }
    }

    /// Settles one more point; nothing when a finish was settled, or none can be reached.
    pub fn step(&mut self) -> Option<Settled> {
        if self.end.is_some() {
            return None;
        }
        loop {
            let Reverse((_, state)) = self.heap.pop()?;
            if core::mem::replace(&mut self.settled[state as usize], true) {
                continue;
            }
            let (point, cost) = (self.point(state), self.cost[state as usize]);
            if self.map.is_finish(point) {
                self.end = Some(state);
            } else {
                self.relax(state, point, cost);
            }
            return Some(Settled { point, cost });
        }
    }

    fn relax(&mut self, state: u32, point: u32, cost: u64) {
        for way in super::PREFERENCE {
            let next = self.map.points[point as usize].links[usize::from(way.index())];
            if next == NONE {
                continue;
            }
            let drive = self.driven(self.map.length(point, next));
            let more = match self.aim {
                Aim::Shortest => drive,
                Aim::Quickest => {
                    let turn = Heading::from_index(state as u8).turn_to(way);
                    drive + self.map.costs.of(turn) + self.map.costs.stop
                }
            };
            self.meet(self.state(next, way), cost + more, state);
        }
    }

    /// The points that were met but are not settled: the frontier.
    pub fn frontier(&self) -> impl Iterator<Item = u32> {
        let open = self.heap.iter().filter(|Reverse((_, state))| !self.settled[*state as usize]);
        open.map(|Reverse((_, state))| self.point(*state))
    }

    /// The points from the start to the finish, once one is settled.
    #[must_use]
    pub fn path(&self) -> Option<Vec<u32>> {
        let mut state = self.end?;
        let mut points = vec![self.point(state)];
        while self.before[state as usize] != NONE {
            state = self.before[state as usize];
            points.push(self.point(state));
        }
        points.reverse();
        Some(points)
    }

    /// Searches on to the end, and gives the path.
    #[must_use]
    pub fn finish(mut self) -> Option<Vec<u32>> {
        while self.step().is_some() {}
        self.path()
    }
}

fn around_finishes(map: &Mapping) -> Option<[i32; 4]> {
    let finishes = (0..map.total_points()).filter(|&point| map.is_finish(point));
    finishes
        .map(|point| map.places.coordinates(point))
        .map(|(x, y)| [x, y, x, y])
        .reduce(|a, b| [a[0].min(b[0]), a[1].min(b[1]), a[2].max(b[2]), a[3].max(b[3])])
}
