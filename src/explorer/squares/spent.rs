//! Dead ends of the known map, filled in: a visited square without an unvisited neighbour, and with at most one
//! neighbour that is not filled itself, cannot lie on the way to an unvisited square. It changes no decision; it
//! spares searches the part of the map where there is nothing left.

use alloc::vec;
use alloc::vec::Vec;

use super::VISITED;
use super::search::{BLANK, WALLED, side, strides};
use crate::explorer::mind::Field;
use crate::geometry::Heading;

/// A filled square, and no neighbour was left; otherwise one more than the heading of the way out.
const CLOSED: u8 = 5;

/// A byte a square; none at all where nobody asks.
#[derive(Clone, Debug, Default)]
pub(super) struct Spent {
    squares: Vec<u8>,
}

impl Spent {
    pub(super) fn new(squares: usize) -> Self {
        Self { squares: vec![BLANK; squares] }
    }

    /// The marks of so many squares: those that are filled have one.
    pub(super) fn marks(&mut self, squares: usize) -> &mut [u8] {
        self.squares.resize(squares, BLANK);
        &mut self.squares
    }

    /// Of a filled square the way out, if there is one left.
    pub(super) fn exit(&self, place: usize) -> Option<Option<Heading>> {
        match self.squares.get(place).copied().unwrap_or(BLANK) {
            BLANK => None,
            CLOSED => Some(None),
            exit => Some(Some(Heading::from_index(exit - 1))),
        }
    }

    /// A square was visited for the first time: it and its neighbours may be dead ends now.
    pub(super) fn visited(&mut self, field: Field, bytes: &[u8], place: usize) {
        if self.squares.is_empty() {
            return;
        }
        let strides = strides(field);
        for heading in Heading::ALL {
            let side = side(bytes[place], heading);
            if side < WALLED {
                self.fill(strides, bytes, place.wrapping_add(strides[side]));
            }
        }
        self.fill(strides, bytes, place);
    }

    /// Fills a square if it is a dead end, and what becomes one by that.
    fn fill(&mut self, strides: [usize; 8], bytes: &[u8], mut place: usize) {
        while self.squares.get(place) == Some(&BLANK) && bytes[place] & VISITED != 0 {
            let mut exit = None;
            for heading in Heading::ALL {
                let side = side(bytes[place], heading);
                let there = place.wrapping_add(strides[side]);
                let Some(byte) = bytes.get(there) else { continue };
                if byte & VISITED == 0 {
                    return;
                }
                if side < WALLED && self.squares[there] == BLANK && exit.replace((heading, there)).is_some() {
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
