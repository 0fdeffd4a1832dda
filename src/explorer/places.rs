//! Places that a robot knows again by its coordinates, within a tolerance (book §2.4.3; Sakib and others, §III).
//!
//! They lie in buckets as wide as two tolerances, so that whatever matches a place lies in at most two by two
//! of them; on the lattice of an ideal world, in a single one.

use alloc::vec::Vec;

use hashbrown::HashMap;

/// No place.
const NONE: u32 = u32::MAX;

/// Places by number, in the order in which they were recorded.
#[derive(Clone, Debug)]
pub(super) struct Places {
    epsilon: u32,
    /// Coordinates, and the place below in the same bucket.
    places: Vec<(i32, i32, u32)>,
    heads: HashMap<(i32, i32), u32>,
}

impl Places {
    pub(super) fn new(epsilon: u32) -> Self {
        Self { epsilon, places: Vec::new(), heads: HashMap::new() }
    }

    pub(super) fn coordinates(&self, place: u32) -> (i32, i32) {
        let (x, y, _) = self.places[place as usize];
        (x, y)
    }

    /// The column of a coordinate, and those of the least and the greatest that match it. Buckets are
    /// centred on multiples of their width.
    fn along(&self, coordinate: i32) -> (i32, core::ops::RangeInclusive<i32>) {
        let epsilon = i64::from(self.epsilon.max(1));
        let from_edge = i64::from(coordinate) + epsilon;
        let (column, inside) = (from_edge.div_euclid(2 * epsilon) as i32, from_edge.rem_euclid(2 * epsilon));
        let least = if inside < epsilon - 1 { column - 1 } else { column };
        let greatest = if inside > epsilon { column + 1 } else { column };
        (column, least..=greatest)
    }

    /// The first place that was recorded nearer than the tolerance on both axes.
    pub(super) fn find(&self, x: i32, y: i32) -> Option<u32> {
        let (_, columns) = self.along(x);
        let (_, rows) = self.along(y);
        let mut first = NONE;
        for column in columns {
            for row in rows.clone() {
                let mut place = self.heads.get(&(column, row)).copied().unwrap_or(NONE);
                while let Some(&(px, py, below)) = self.places.get(place as usize) {
                    if px.abs_diff(x) < self.epsilon && py.abs_diff(y) < self.epsilon {
                        first = first.min(place);
                    }
                    place = below;
                }
            }
        }
        (first != NONE).then_some(first)
    }

    /// Records a place; its number.
    pub(super) fn push(&mut self, x: i32, y: i32) -> u32 {
        let bucket = (self.along(x).0, self.along(y).0);
        let place = self.places.len() as u32;
        let below = self.heads.insert(bucket, place).unwrap_or(NONE);
        self.places.push((x, y, below));
        place
    }

    /// About how many bytes a copy takes.
    pub(super) fn bytes(&self) -> usize {
        self.places.len() * 12 + self.heads.capacity() * 13
    }
}

/// Where a robot is by its own reckoning: milliseconds of driving from the start, in its own frame.
#[derive(Clone, Copy, Debug, Default)]
pub(super) struct Reckoning {
    pub(super) x: i32,
    pub(super) y: i32,
    pub(super) heading: crate::geometry::Heading,
}

impl Reckoning {
    /// It drove.
    pub(super) const fn drive(&mut self, time_diff: u32) {
        let (dx, dy) = self.heading.vector();
        self.x = self.x.wrapping_add(dx.wrapping_mul(time_diff as i32));
        self.y = self.y.wrapping_add(dy.wrapping_mul(time_diff as i32));
    }
}
