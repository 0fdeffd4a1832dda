//! A map of squares, a byte each as the Cornell team keeps it (*Milestone 3: maze traversing*, 2018): bit 4
//! says that the square was visited, bits 3 to 0 that there is a wall to the north, east, south, west.

use alloc::vec;
use alloc::vec::Vec;

use super::mind::{Field, Plan};

mod spent;

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

/// Which visited squares a search goes through.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Over {
    All,
    Unspent,
}

/// The map.
#[derive(Clone, Debug)]
pub struct Squares {
    field: Field,
    bytes: Vec<u8>,
    /// Which squares can lead to no unvisited one; kept where that is asked for.
    spent: Spent,
    scratch: Scratch,
}

/// What a search leaves behind; nothing of it is remembered, so a copy begins with none.
#[derive(Debug, Default)]
struct Scratch {
    /// The search that met a square last, and in the two lowest bits the heading with which it did.
    met: Vec<u32>,
    /// Squares to look at: place and column.
    queue: Vec<(u32, u32)>,
    search: u32,
}

/// A square as searches note it: one word, as they look at millions.
const fn met(search: u32, heading: Heading) -> u32 {
    search << 2 | heading.index() as u32
}

impl Clone for Scratch {
    fn clone(&self) -> Self {
        Self::default()
    }
}

impl Squares {
    /// A map without a visited square or a wall.
    #[must_use]
    pub fn new(field: Field) -> Self {
        Self { field, bytes: vec![0; field.squares()], spent: Spent::default(), scratch: Scratch::default() }
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
        let walls = Ways::ALL.minus(ways).iter().fold(0, |walls, heading| walls | wall(heading));
        self.bytes[place] = before | walls | VISITED;
        if before & VISITED == 0 {
            self.spent.visited(self.field, &self.bytes, place);
        }
        self.bytes[place] != before
    }

    /// What [`Squares::search`] finds for [`Aim::Unvisited`], without looking into squares that lead nowhere
    /// new: from those there is one way out, and nothing else on the map changes for leaving them aside.
    pub fn nearest_unvisited(&mut self, from: Point, heading: Heading) -> Option<Vec<Heading>> {
        let mut ways = Vec::new();
        let (mut at, mut by) = (from, heading);
        while let Some(exit) = self.spent.exit(self.place(at)?) {
            by = exit?;
            ways.push(by);
            at = at.step(by);
        }
        ways.extend(self.search_over(at, by, Aim::Unvisited, Over::Unspent)?);
        Some(ways)
    }

    /// Notes a wall of a square. Whether that was new.
    pub fn note(&mut self, at: Point, heading: Heading) -> bool {
        let Some(place) = self.place(at) else { return false };
        let before = self.bytes[place];
        self.bytes[place] = before | wall(heading);
        self.bytes[place] != before
    }

    /// The headings from a visited square to the nearest one that is meant, over what is known of visited
    /// squares; breadth first, neighbours as a robot driven there would see them.
    pub fn search(&mut self, from: Point, heading: Heading, aim: Aim<'_>) -> Option<Vec<Heading>> {
        self.search_over(from, heading, aim, Over::All)
    }

    fn search_over(
        &mut self,
        from: Point,
        heading: Heading,
        aim: Aim<'_>,
        over: Over,
    ) -> Option<Vec<Heading>> {
        let first = self.place(from)?;
        let Self { field, bytes, spent, scratch } = self;
        if scratch.met.len() < bytes.len() || scratch.search >> 30 != 0 {
            scratch.met.clear();
            scratch.met.resize(bytes.len(), 0);
            scratch.search = 0;
        }
        scratch.search += 1;
        let search = scratch.search;
        let meant = |place: usize| match aim {
            Aim::Unvisited => bytes[place] & VISITED == 0,
            Aim::Any(places) => places.contains(&(place as u32)),
        };
        if meant(first) {
            return Some(Vec::new());
        }
        scratch.met[first] = met(search, heading);
        scratch.queue.clear();
        scratch.queue.push((first as u32, from.x as u32));
        let mut next = 0;
        while let Some(&(here, x)) = scratch.queue.get(next) {
            next += 1;
            let here = here as usize;
            let by = Heading::from_index(scratch.met[here] as u8 & 0b11);
            for turn in ORDER {
                let way = by.turned(turn);
                if bytes[here] & wall(way) != 0 {
                    continue;
                }
                let Some((there, x)) = beside(*field, here, x, way) else { continue };
                if scratch.met[there] >> 2 == search {
                    continue;
                }
                scratch.met[there] = met(search, way);
                let visited = bytes[there] & VISITED != 0;
                if meant(there) && (visited || aim == Aim::Unvisited) {
                    return Some(ways_back(*field, &scratch.met, there, x, first));
                }
                if visited && (over == Over::All || !spent.is(there)) {
                    scratch.queue.push((there as u32, x));
                }
            }
        }
        None
    }

    /// The shortest known way from the start to one of these places in the map.
    #[must_use]
    pub fn plan(&self, finishes: &[u32]) -> Option<Plan> {
        let Field { start, heading, .. } = self.field;
        let ways = self.clone().search(start, heading, Aim::Any(finishes))?;
        let mut at = start;
        let mut places = vec![self.field.from_start(at)];
        for way in ways {
            at = at.step(way);
            places.push(self.field.from_start(at));
        }
        Some(Plan::Places(places))
    }
}

/// The square on one side of another, each as its place (in rows from the north) and its column.
const fn beside(field: Field, place: usize, x: u32, way: Heading) -> Option<(usize, u32)> {
    let width = field.width as usize;
    match way {
        Heading::North if place >= width => Some((place - width, x)),
        Heading::East if x + 1 < field.width => Some((place + 1, x + 1)),
        Heading::South if place + width < field.squares() => Some((place + width, x)),
        Heading::West if x > 0 => Some((place - 1, x - 1)),
        Heading::North | Heading::East | Heading::South | Heading::West => None,
    }
}

/// The headings along which a search came to a square.
fn ways_back(field: Field, met: &[u32], mut place: usize, mut x: u32, first: usize) -> Vec<Heading> {
    let mut ways = Vec::new();
    while place != first {
        let way = Heading::from_index(met[place] as u8 & 0b11);
        ways.push(way);
        let Some(before) = beside(field, place, x, way.opposite()) else { break };
        (place, x) = before;
    }
    ways.reverse();
    ways
}
