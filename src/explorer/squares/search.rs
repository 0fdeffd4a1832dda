//! Breadth first over the known map. A robot in a large maze with loops looks at three squares for each that it
//! drives, so a look has to be cheap: it takes two bytes, the square's own and its mark, and no branch depends on
//! where walls are, which no processor can foresee.
//!
//! Marks bar the way whatever they mean, so the same search goes over the whole map, or only over what
//! [`super::spent`] has left of it; those that it makes itself it wipes away.

use alloc::vec;
use alloc::vec::Vec;
use core::fmt;

use super::{Aim, ORDER, VISITED};
use crate::explorer::mind::Field;
use crate::geometry::Heading;

/// A square that nothing is noted about.
pub(super) const BLANK: u8 = 0;
/// A square that the search has met, with the heading in the two lowest bits.
const MET: u8 = 1 << 3;

/// Squares to look at. Nothing of it is remembered, so a copy begins with none.
#[derive(Default)]
pub(super) struct Queue(Vec<u32>);

impl fmt::Debug for Queue {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str("Queue")
    }
}

impl Clone for Queue {
    fn clone(&self) -> Self {
        Self::default()
    }
}

/// How far it is to the square on each side of another, by [`side`] and in rows from the north; to be added with
/// wrapping. Behind a wall there is the square itself. The field's edge is walled.
pub(super) const fn strides(field: Field) -> [usize; 8] {
    let width = field.width as usize;
    [width.wrapping_neg(), 1, width, usize::MAX, 0, 0, 0, 0]
}

/// From here on, places in [`strides`] are of sides with a wall.
pub(super) const WALLED: usize = 4;

/// A side of a visited square with this byte, as a place in [`strides`]: the heading, and whether there is a wall.
pub(super) const fn side(byte: u8, heading: Heading) -> usize {
    let wall = byte << heading.index() & 0b1000;
    (wall >> 1 | heading.index()) as usize
}

/// The headings from one visited square to the nearest one that is meant, the last one first. All marks are
/// afterwards as they were.
pub(super) fn nearest(
    field: Field,
    bytes: &[u8],
    marks: &mut [u8],
    queue: &mut Queue,
    (first, heading): (usize, Heading),
    aim: Aim<'_>,
) -> Option<Vec<Heading>> {
    let Queue(queue) = queue;
    if queue.len() <= bytes.len() {
        *queue = vec![0; bytes.len() + 1];
    }
    let strides = strides(field);
    let meant = |place: usize, byte: u8| match aim {
        Aim::Unvisited => byte & VISITED == 0,
        Aim::Any(places) => byte & VISITED != 0 && places.contains(&(place as u32)),
    };
    if meant(first, bytes[first]) {
        return Some(Vec::new());
    }
    marks[first] = MET | heading.index();
    queue[0] = first as u32;
    let (mut next, mut end) = (0, 1);
    let mut found = None;
    // What lies back was met before, but for the first square.
    let mut turns = ORDER.as_slice();
    'search: while next < end {
        let here = queue[next] as usize;
        next += 1;
        let (byte, by) = (bytes[here], Heading::from_index(marks[here] & 0b11));
        for &turn in turns {
            let way = by.turned(turn);
            // Behind a wall that is the square itself, which is marked.
            let there = here.wrapping_add(strides[side(byte, way)]);
            let (Some(&beyond), Some(mark)) = (bytes.get(there), marks.get_mut(there)) else { continue };
            if meant(there, beyond) {
                found = Some((here, way));
                break 'search;
            }
            let new = u8::from(*mark == BLANK) & (beyond / VISITED);
            *mark |= (MET | way.index()) * new;
            queue[end] = there as u32;
            end += usize::from(new);
        }
        turns = &ORDER[..3];
    }
    let ways = found.map(|(last, way)| ways_back(strides, marks, first, last, way));
    for &met in &queue[..end] {
        marks[met as usize] = BLANK;
    }
    ways
}

/// From the last way to the first one, by the marks.
fn ways_back(strides: [usize; 8], marks: &[u8], first: usize, last: usize, way: Heading) -> Vec<Heading> {
    let mut ways = vec![way];
    let mut at = last;
    while at != first {
        let way = Heading::from_index(marks[at] & 0b11);
        ways.push(way);
        at = at.wrapping_sub(strides[usize::from(way.index())]);
    }
    ways
}
