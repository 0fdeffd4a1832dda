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
    /// The search that met a square last.
    met: Vec<u32>,
    /// The heading with which it was met.
    by: Vec<Heading>,
    queue: Vec<(Point, u32)>,
    search: u32,
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
        let Self { field, bytes, spent, scratch } = self;
        let height = field.height as i32;
        let place = |at: Point| field.index(Point::new(at.x, height - 1 - at.y));
        if scratch.met.len() < bytes.len() {
            scratch.met.resize(bytes.len(), 0);
            scratch.by.resize(bytes.len(), Heading::North);
        }
        scratch.search += 1;
        scratch.queue.clear();
        let first = place(from)?;
        scratch.met[first] = scratch.search;
        scratch.by[first] = heading;
        let meant = |place: usize| match aim {
            Aim::Unvisited => bytes[place] & VISITED == 0,
            Aim::Any(places) => places.contains(&(place as u32)),
        };
        if meant(first) {
            return Some(Vec::new());
        }
        scratch.queue.push((from, first as u32));
        let mut next = 0;
        while let Some(&(at, here)) = scratch.queue.get(next) {
            next += 1;
            let here = here as usize;
            for turn in ORDER {
                let way = scratch.by[here].turned(turn);
                if bytes[here] & wall(way) != 0 {
                    continue;
                }
                let to = at.step(way);
                let Some(there) = place(to) else { continue };
                if scratch.met[there] == scratch.search {
                    continue;
                }
                scratch.met[there] = scratch.search;
                scratch.by[there] = way;
                let visited = bytes[there] & VISITED != 0;
                if meant(there) && (visited || aim == Aim::Unvisited) {
                    let mut ways = Vec::new();
                    let mut back = to;
                    while let Some(place) = place(back).filter(|_| back != from) {
                        ways.push(scratch.by[place]);
                        back = back.step(scratch.by[place].opposite());
                    }
                    ways.reverse();
                    return Some(ways);
                }
                if visited && (over == Over::All || !spent.is(there)) {
                    scratch.queue.push((to, there as u32));
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
