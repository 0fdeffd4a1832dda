//! The paper's arrays, column by column, and the adjacency list that neighbouring columns give.

use alloc::vec::Vec;

use super::{Mapping, POINT_BITS, POINT_MASK};

/// A column of the arrays.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Column {
    /// Which point.
    pub point: u32,
    /// Its ways − 1.
    pub kind: i32,
    /// Its different neighbours known after this visit.
    pub explored: u32,
    /// Milliseconds of driving to the east of the start.
    pub x: i32,
    /// Milliseconds of driving to the north of the start.
    pub y: i32,
}

impl Mapping {
    /// Visits so far, the start included.
    #[must_use]
    pub const fn visits(&self) -> usize {
        self.visits.len()
    }

    /// Which point a visit was of, from 0.
    pub fn visited(&self) -> impl ExactSizeIterator<Item = u32> {
        self.visits.iter().map(|packed| packed & POINT_MASK)
    }

    /// A column of the arrays, from 0.
    #[must_use]
    pub fn column(&self, visit: usize) -> Option<Column> {
        let packed = *self.visits.get(visit)?;
        let point = packed & POINT_MASK;
        let (x, y) = self.places.coordinates(point);
        let kind = self.points[point as usize].ways.count() as i32 - 1;
        Some(Column { point, kind, explored: packed >> POINT_BITS, x, y })
    }

    /// The neighbours of a point as neighbouring columns show them, from left to right.
    #[must_use]
    pub fn adjacency(&self, point: u32) -> Vec<u32> {
        let mut list = Vec::new();
        self.pairs(|a, b| {
            if a == point && !list.contains(&b) {
                list.push(b);
            }
        });
        list
    }

    /// The whole adjacency list, by point.
    #[must_use]
    pub fn adjacency_list(&self) -> Vec<Vec<u32>> {
        let mut lists = alloc::vec![Vec::new(); self.points.len()];
        self.pairs(|a, b| {
            let list: &mut Vec<u32> = &mut lists[a as usize];
            if !list.contains(&b) {
                list.push(b);
            }
        });
        lists
    }

    /// Points of neighbouring columns, each pair in both orders.
    fn pairs(&self, mut met: impl FnMut(u32, u32)) {
        for pair in self.visits.windows(2) {
            let (a, b) = (pair[0] & POINT_MASK, pair[1] & POINT_MASK);
            met(a, b);
            met(b, a);
        }
    }
}
