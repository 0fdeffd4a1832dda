//! The shortest way: distances to the finish in one breadth-first pass, then down the slope from the start. Where
//! several ways go down, the quickest is kept for each heading on arrival.

use alloc::vec;
use alloc::vec::Vec;

use crate::geometry::{Heading, Turn, Ways};
use crate::maze::{Bounds, Maze, Start};
use crate::route::tally::Tally;
use crate::settings::Pace;

/// No way leads there, or it is out of reach.
pub(super) const FAR: u32 = u32::MAX;

/// The headings of a shortest way, a cell each.
pub(super) fn search(maze: &Maze, start: Start, pace: &Pace) -> Option<Vec<Heading>> {
    let from = maze.bounds().index(start.at)?;
    let far = distances(maze, &Reach::To(from));
    if far[from] == FAR {
        return None;
    }
    let mut slope = Slope::new(maze, pace, far);
    slope.descend(from, start.heading)
}

/// The index of the next point; the line keeps it on the lattice.
const fn next(index: usize, heading: Heading, width: usize) -> usize {
    match heading {
        Heading::North => index + width,
        Heading::East => index + 1,
        Heading::South => index - width,
        Heading::West => index - 1,
    }
}

fn width(bounds: Bounds) -> usize {
    bounds.width() as usize
}

/// How far distances are needed.
pub(super) enum Reach {
    /// Up to this point, by index.
    To(usize),
    /// Everywhere.
    All,
}

/// Cells to the nearest finish, for every point within reach; [`FAR`] elsewhere.
pub(super) fn distances(maze: &Maze, reach: &Reach) -> Vec<u32> {
    let (bounds, ways) = (maze.bounds(), maze.all_ways());
    let width = width(bounds) as isize;
    // Clockwise from north, as the bits of a set of ways.
    let steps = [width, 1, -width, -1];
    let last = match *reach {
        Reach::To(index) => index,
        Reach::All => usize::MAX,
    };
    let mut far = vec![FAR; bounds.len()];
    let mut todo: Vec<u32> = Vec::with_capacity(bounds.len());
    for index in maze.finish().iter().filter_map(|&at| bounds.index(at)) {
        far[index] = 0;
        todo.push(index as u32);
    }
    let mut done = 0;
    while let Some(&index) = todo.get(done) {
        let index = index as usize;
        if index == last {
            break;
        }
        done += 1;
        let one_more = far[index] + 1;
        let mut bits = ways[index].bits();
        while bits != 0 {
            let near = index.wrapping_add_signed(steps[(bits.trailing_zeros() & 3) as usize]);
            bits &= bits - 1;
            if far[near] == FAR {
                far[near] = one_more;
                todo.push(near as u32);
            }
        }
    }
    far
}

/// A point on a shortest way, and the quickest way to it for each heading on arrival.
struct Place {
    index: usize,
    /// What the way so far is made of, without its cells: those are equal for all.
    best: [Option<Tally>; 4],
}

struct Slope<'m> {
    maze: &'m Maze,
    pace: &'m Pace,
    width: usize,
    far: Vec<u32>,
    /// For each point two bits for each heading on arrival: the heading on arrival at the point before.
    before: Vec<u8>,
}

impl<'m> Slope<'m> {
    fn new(maze: &'m Maze, pace: &'m Pace, far: Vec<u32>) -> Self {
        Self { maze, pace, width: width(maze.bounds()), before: vec![0; far.len()], far }
    }

    /// The way down from the start.
    fn descend(&mut self, from: usize, facing: Heading) -> Option<Vec<Heading>> {
        let length = self.far[from];
        let mut best = [None; 4];
        best[facing as usize] = Some(Tally::default());
        let mut places = vec![Place { index: from, best }];
        for left in (0..length).rev() {
            places = self.step(&places, left);
        }
        let seconds = |tally: &Tally| tally.seconds(self.maze.scale.cell_mm(), self.pace);
        let ends = places.iter().flat_map(|place| {
            let arrivals = Heading::ALL.into_iter().zip(place.best);
            arrivals.filter_map(|(heading, tally)| Some((place.index, heading, seconds(&tally?))))
        });
        let (index, heading, _) = ends.min_by(|a, b| a.2.total_cmp(&b.2))?;
        Some(self.way_back(index, heading, length))
    }

    /// All points one cell further down, which are `left` cells from a finish.
    fn step(&mut self, places: &[Place], left: u32) -> Vec<Place> {
        let mut below: Vec<Place> = Vec::new();
        for place in places {
            for heading in self.maze.all_ways()[place.index].iter() {
                let index = next(place.index, heading, self.width);
                // Every point below is met from at most four above, which were added just now.
                if self.far[index] != left {
                    continue;
                }
                let Some((arrival, tally)) = self.quickest(place, heading, index) else { continue };
                self.before[index] |= (arrival as u8) << (2 * heading as u8);
                let nth = below.iter().rposition(|other| other.index == index);
                let nth = nth.unwrap_or_else(|| {
                    below.push(Place { index, best: [None; 4] });
                    below.len() - 1
                });
                below[nth].best[heading as usize] = Some(tally);
            }
        }
        below
    }

    /// The quickest way over `place` to the point below it, and the heading on arrival at `place`.
    fn quickest(&self, place: &Place, heading: Heading, below: usize) -> Option<(Heading, Tally)> {
        let straight = Ways::NONE.with(heading).with(heading.opposite());
        let stops = self.maze.all_ways()[below] != straight || self.far[below] == 0;
        let cell_mm = self.maze.scale.cell_mm();
        let arrivals = Heading::ALL.into_iter().zip(place.best);
        let ways = arrivals.filter_map(|(arrival, tally)| {
            let turned = tally?.turned(arrival.turn_to(heading));
            let tally = if stops { turned.driven(0) } else { turned };
            Some((arrival, tally, tally.seconds(cell_mm, self.pace)))
        });
        ways.min_by(|a, b| a.2.total_cmp(&b.2)).map(|(arrival, tally, _)| (arrival, tally))
    }

    /// The headings of the way that ends so, from the start on.
    fn way_back(&self, mut index: usize, mut heading: Heading, length: u32) -> Vec<Heading> {
        let mut headings = vec![heading; length as usize];
        for place in headings.iter_mut().rev() {
            *place = heading;
            let arrival = Heading::from_index(self.before[index] >> (2 * heading as u8));
            index = next(index, heading.turned(Turn::Back), self.width);
            heading = arrival;
        }
        headings
    }
}
