//! Flood fill, with the goal told: a robot of the micromouse kind, which the paper on mapping (Sakib and others,
//! 2014, §I) names as one that needs to know where the goal is. It is told the field's size and the finish,
//! counts every side that it has not seen as open, and goes downhill in numbers of squares to the goal.
//!
//! | name | meaning |
//! |---|---|
//! | number | squares to the goal as far as the robot knows; infinite where no way leads |
//! | walls | a byte a square, as in the Cornell map |

use alloc::string::String;
use alloc::vec;
use alloc::vec::Vec;

use super::mind::{Field, Plan, Robot};
use super::squares::{ORDER, Squares, wall};
use super::tell::{Tell, many};
use crate::event::{Decision, Finish, Home, Look, Outcome};
use crate::geometry::{Heading, Point, Ways};

listing! {
    ACT    "every square:"
    WRITE  "  note its walls"
    FINISH "  if finish:                  stop"
    FILL   "  number[goal] = 0; from there, 1 more over each side that is not known as a wall"
    NONE   "  if its own is infinite:     stop      # no way leads there"
    DOWN   "  go to the open neighbour with the lowest; of equals: ahead, left, right, back"
}

cases! {
    START "start" Info Plain "The robot knows where the goal is, but no walls except those that it sees here. By its numbers the goal is {number} away: the robot *{turn}*."
    DOWN "downhill" Info Plain "No wall here is new. The robot is {number} from the goal, as far as it knows, and *{turn}*, downhill."
    FILL "refill" Now Node "New walls: the numbers are *filled in again*. The robot is now {number} from the goal, as far as it knows, and *{turn}*."
    NONE "no-finish" Bad End "No way that could still be there leads to the goal: its number is *infinite*."
    FINISH "finish" Go End "The robot stands on the *finish*, number 0."
    NO_GOAL "no-goal" Bad End "The robot was told *no goal*, as this maze has no finish. Without one it has nothing to go by."
}

/// Infinite.
pub const INFINITE: u32 = u32::MAX;

/// A robot that goes downhill.
#[derive(Clone, Debug)]
pub struct FloodFill {
    squares: Squares,
    goal: Vec<u32>,
    numbers: Vec<u32>,
    at: Point,
    heading: Heading,
}

impl FloodFill {
    /// A robot that knows the field and the goal.
    #[must_use]
    pub fn new(field: Field, goal: &[Point]) -> Self {
        let squares = Squares::new(field);
        let goal = goal.iter().filter_map(|&at| squares.place(at)).map(|place| place as u32).collect();
        let numbers = vec![INFINITE; field.squares()];
        Self { squares, goal, numbers, at: field.start, heading: field.heading }
    }

    /// The map of walls.
    #[must_use]
    pub const fn squares(&self) -> &Squares {
        &self.squares
    }

    /// The numbers, row by row from the north; [`INFINITE`] where no way leads.
    #[must_use]
    pub fn numbers(&self) -> &[u32] {
        &self.numbers
    }

    /// The number of the square that the robot stands on.
    #[must_use]
    pub fn number(&self) -> u32 {
        self.at_place(self.at)
    }

    fn at_place(&self, at: Point) -> u32 {
        self.squares.place(at).map_or(INFINITE, |place| self.numbers[place])
    }

    /// Notes walls on both of their sides; whether one was new.
    fn note(&mut self, ways: Ways) -> bool {
        let mut new = false;
        for way in Ways::ALL.minus(ways).iter() {
            // A wall at the edge of the field tells nothing: it was told.
            let seen = self.squares.byte(self.at) & wall(way) != 0;
            new |= !seen && self.squares.place(self.at.step(way)).is_some();
            self.squares.note(self.at.step(way), way.opposite());
        }
        self.squares.write(self.at, ways);
        new
    }

    fn fill(&mut self) {
        self.numbers.fill(INFINITE);
        let width = self.squares.field().width as usize;
        let bytes = self.squares.bytes();
        let mut queue: Vec<u32> = Vec::with_capacity(self.goal.len());
        for &goal in &self.goal {
            self.numbers[goal as usize] = 0;
            queue.push(goal);
        }
        let mut next = 0;
        while let Some(&here) = queue.get(next) {
            next += 1;
            let here = here as usize;
            let (x, number) = (here % width, self.numbers[here] + 1);
            for heading in Heading::ALL {
                let there = match heading {
                    Heading::North => here.checked_sub(width),
                    Heading::East => (x + 1 < width).then_some(here + 1),
                    Heading::South => Some(here + width).filter(|&there| there < bytes.len()),
                    Heading::West => (x > 0).then(|| here - 1),
                };
                if let Some(there) = there
                    && bytes[here] & wall(heading) == 0
                    && self.numbers[there] == INFINITE
                {
                    self.numbers[there] = number;
                    queue.push(there as u32);
                }
            }
        }
    }
}

impl Robot for FloodFill {
    fn decide(&mut self, look: Look, tell: &mut impl Tell<Self>) -> Decision {
        if look.home != Home::PutDown {
            self.at = self.at.step(self.heading);
        }
        let new = self.note(look.sighting.ways.out_of_frame_of(self.heading));
        tell.did(line::WRITE, self);
        if look.sighting.finish == Finish::Yes {
            tell.is(case::FINISH);
            tell.did(line::FINISH, self);
            return Decision::End(Outcome::Finish);
        }
        tell.no(line::FINISH, self);
        // Without a new wall the numbers would come out as they are.
        if new || look.home == Home::PutDown {
            self.fill();
        }
        tell.did(line::FILL, self);
        let ways = ORDER.iter().copied().filter(|&turn| look.sighting.sees(turn));
        let lowest = ways.min_by_key(|&turn| self.at_place(self.at.step(self.heading.turned(turn))));
        let Some(turn) = lowest.filter(|_| self.number() != INFINITE) else {
            tell.is(if self.goal.is_empty() { case::NO_GOAL } else { case::NONE });
            tell.did(line::NONE, self);
            return Decision::End(Outcome::NoFinishReachable);
        };
        tell.no(line::NONE, self);
        tell.is(match (look.home, new) {
            (Home::PutDown, _) => case::START,
            (_, true) => case::FILL,
            (_, false) => case::DOWN,
        });
        self.heading = self.heading.turned(turn);
        tell.did(line::DOWN, self);
        Decision::Go(turn)
    }

    fn fact(&self, _: &str, out: &mut String) {
        match self.number() {
            INFINITE => out.push_str("infinitely many squares"),
            number => out.push_str(&many(number as usize, "square")),
        }
    }

    fn peak_bytes(&self) -> u32 {
        // An int and a byte a square.
        3 * self.numbers.len() as u32
    }

    fn host_bytes(&self) -> usize {
        5 * self.numbers.len()
    }

    fn plan(&self) -> Option<Plan> {
        let here = self.squares.place(self.at)? as u32;
        if self.goal.contains(&here) { self.squares.plan(&[here]) } else { None }
    }
}
