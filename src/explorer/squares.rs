//! A map of squares, a byte each as the Cornell team keeps it (*Milestone 3: maze traversing*, 2018): bit 4
//! says that the square was visited, bits 3 to 0 that there is a wall to the north, east, south, west.

use alloc::vec;
use alloc::vec::Vec;

use super::mind::{Field, Plan};

mod search;
mod spent;

use search::{BLANK, Queue, nearest};
use spent::Spent;

use crate::geometry::{Heading, Point, Turn, Ways};

/// The bit of a visited square.
pub const VISITED: u8 = 1 << 4;

/// The bit of a wall.
#[must_use]
pub const fn wall(heading: Heading) -> u8 {
    0b1000 >> heading.index()
}

/// In which order neighbours are looked at.
pub const ORDER: [Turn; 4] = [Turn::Straight, Turn::Left, Turn::Right, Turn::Back];

/// What a search over the known squares is after.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Aim<'a> {
    /// The nearest square that was never visited.
    Unvisited,
    /// The nearest of these places in the map.
    Any(&'a [u32]),
}

/// The map.
#[derive(Clone, Debug)]
pub struct Squares {
    field: Field,
    bytes: Vec<u8>,
    /// Which squares can lead to no unvisited one; kept where that is asked for.
    spent: Spent,
    queue: Queue,
}

impl Squares {
    /// A map without a visited square or a wall.
    #[must_use]
    pub fn new(field: Field) -> Self {
        Self { field, bytes: vec![0; field.squares()], spent: Spent::default(), queue: Queue::default() }
    }

    /// The same, for a robot that looks for the nearest unvisited square again and again
    /// ([`Squares::nearest_unvisited`]).
    #[must_use]
    pub fn for_searching(field: Field) -> Self {
        Self { spent: Spent::new(field.squares()), ..Self::new(field) }
    }

    /// The field.
    #[must_use]
    pub const fn field(&self) -> Field {
        self.field
    }

    /// The bytes, row by row from the north.
    #[must_use]
    pub fn bytes(&self) -> &[u8] {
        &self.bytes
    }

    /// A square's place in the bytes; none off the field.
    #[must_use]
    pub const fn place(&self, at: Point) -> Option<usize> {
        self.field.index(Point::new(at.x, self.field.height as i32 - 1 - at.y))
    }

    /// A square's byte; off the field, visited and walled.
    #[must_use]
    pub fn byte(&self, at: Point) -> u8 {
        self.place(at).map_or(VISITED | 0b1111, |place| self.bytes[place])
    }

    /// Writes the byte of the square that the robot stands on; `ways` on the map. Whether that was new.
    pub fn write(&mut self, at: Point, ways: Ways) -> bool {
        let Some(place) = self.place(at) else { return false };
        let before = self.bytes[place];
        // Ways have north in the lowest bit, walls in the highest.
        let walls = Ways::ALL.minus(ways).bits().reverse_bits() >> 4;
        self.bytes[place] = before | walls | self.edge(at) | VISITED;
        if before & VISITED == 0 {
            self.spent.visited(self.field, &self.bytes, place);
        }
        self.bytes[place] != before
    }

    /// The walls at the field's edge; searches rely on them.
    const fn edge(&self, at: Point) -> u8 {
        let Field { width, height, .. } = self.field;
        let (north, east) = (at.y + 1 == height as i32, at.x + 1 == width as i32);
        (north as u8) << 3 | (east as u8) << 2 | ((at.y == 0) as u8) << 1 | (at.x == 0) as u8
    }

    /// What [`Squares::search`] finds for [`Aim::Unvisited`], the next heading last, without looking into
    /// squares that lead nowhere new: from those there is one way out, and nothing else on the map changes for
    /// leaving them aside.
    pub fn nearest_unvisited(&mut self, from: Point, heading: Heading) -> Option<Vec<Heading>> {
        let mut ways = Vec::new();
        let (mut at, mut by) = (from, heading);
        let place = loop {
            let place = self.place(at)?;
            let Some(exit) = self.spent.exit(place) else { break place };
            by = exit?;
            ways.push(by);
            at = at.step(by);
        };
        let Self { field, bytes, spent, queue } = self;
        let mut route = nearest(*field, bytes, spent.marks(bytes.len()), queue, (place, by), Aim::Unvisited)?;
        route.extend(ways.into_iter().rev());
        Some(route)
    }

    /// Notes a wall of a square. Whether that was new.
    pub fn note(&mut self, at: Point, heading: Heading) -> bool {
        let Some(place) = self.place(at) else { return false };
        let before = self.bytes[place];
        self.bytes[place] = before | wall(heading);
        self.bytes[place] != before
    }

    /// The headings from a visited square to the nearest one that is meant, over what is known of visited
    /// squares; breadth first, neighbours as a robot driven there would see them. No heading at all
    /// where that square is meant itself.
    #[must_use]
    pub fn search(&self, from: Point, heading: Heading, aim: Aim<'_>) -> Option<Vec<Heading>> {
        let first = (self.place(from)?, heading);
        let mut marks = vec![BLANK; self.bytes.len()];
        let mut ways = nearest(self.field, &self.bytes, &mut marks, &mut Queue::default(), first, aim)?;
        ways.reverse();
        Some(ways)
    }

    /// The shortest known way from the start to one of these places in the map.
    #[must_use]
    pub fn plan(&self, finishes: &[u32]) -> Option<Plan> {
        let Field { start, heading, .. } = self.field;
        let ways = self.search(start, heading, Aim::Any(finishes))?;
        let mut at = start;
        let mut places = vec![self.field.from_start(at)];
        for way in ways {
            at = at.step(way);
            places.push(self.field.from_start(at));
        }
        Some(Plan::Places(places))
    }
}
