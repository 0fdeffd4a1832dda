//! Dead ends of the known map, filled in: a visited square without an unvisited neighbour, and with at most one
//! neighbour that is not filled itself, cannot lie on the way to an unvisited square. It changes no decision; it
//! spares searches the part of the map where there is nothing left.

use alloc::vec;
use alloc::vec::Vec;

use super::{VISITED, wall};
use crate::explorer::mind::Field;
use crate::geometry::Heading;

/// Not filled.
const LIVE: u8 = 0;
/// Filled, and no neighbour was left; otherwise one more than the heading of the way out.
const CLOSED: u8 = 5;

/// A byte a square; none at all where nobody asks.
#[derive(Clone, Debug, Default)]
pub(super) struct Spent {
    squares: Vec<u8>,
}

impl Spent {
    pub(super) fn new(squares: usize) -> Self {
        Self { squares: vec![LIVE; squares] }
    }

    /// Whether a square is filled.
    pub(super) fn is(&self, place: usize) -> bool {
        self.squares.get(place).is_some_and(|&square| square != LIVE)
    }

    /// Of a filled square the way out, if there is one left.
    pub(super) fn exit(&self, place: usize) -> Option<Option<Heading>> {
        match self.squares.get(place).copied().unwrap_or(LIVE) {
            LIVE => None,
            CLOSED => Some(None),
            exit => Some(Some(Heading::from_index(exit - 1))),
        }
    }

    /// A square was visited for the first time: it and its neighbours may be dead ends now.
    pub(super) fn visited(&mut self, field: Field, bytes: &[u8], place: usize) {
        if self.squares.is_empty() {
            return;
        }
        for heading in Heading::ALL {
            if bytes[place] & wall(heading) == 0
                && let Some(there) = neighbour(field, place, heading)
            {
                self.fill(field, bytes, there);
            }
        }
        self.fill(field, bytes, place);
    }

    /// Fills a square if it is a dead end, and what becomes one by that.
    fn fill(&mut self, field: Field, bytes: &[u8], mut place: usize) {
        while self.squares[place] == LIVE && bytes[place] & VISITED != 0 {
            let mut exit = None;
            for heading in Heading::ALL {
                if bytes[place] & wall(heading) != 0 {
                    continue;
                }
                let Some(there) = neighbour(field, place, heading) else { continue };
                if bytes[there] & VISITED == 0 {
                    return;
                }
                if self.squares[there] == LIVE && exit.replace((heading, there)).is_some() {
                    return;
                }
            }
            let Some((heading, there)) = exit else {
                self.squares[place] = CLOSED;
                return;
            };
            self.squares[place] = heading.index() + 1;
            place = there;
        }
    }
}

/// The place over an open side of a visited square, in rows from the north. At the field's edge there are walls.
fn neighbour(field: Field, place: usize, heading: Heading) -> Option<usize> {
    let width = field.width as usize;
    match heading {
        Heading::North => place.checked_sub(width),
        Heading::East => Some(place + 1).filter(|&there| there < field.squares()),
        Heading::South => Some(place + width).filter(|&there| there < field.squares()),
        Heading::West => place.checked_sub(1),
    }
}
