//! The three traversals of a Cornell team (*Milestone 3: maze traversing*, 2018): each drives from square to
//! square; the second avoids visited squares, the third looks for the nearest unvisited one.
//!
//! | name | meaning |
//! |---|---|
//! | `maze[x][y]` | a byte a square: bit 4 visited, bits 3 to 0 walls N E S W |
//! | `xpos`, `ypos` | the square: 0,0 is the north-west corner, x to the right, y downwards |
//! | `orientation` | where the robot faces on the map |
//! | route | ours, for the third: the squares to the one that was looked for |
//!
//! The team's field had 9 × 9 squares. Here size, start and orientation are configured from the maze: the field
//! is its bounds.

use alloc::string::{String, ToString};
use alloc::vec::Vec;

use super::book::errata::{Erratum, Place};
use super::mind::{Field, Plan, Robot};
use super::squares::{ORDER, Squares, VISITED, wall};
use super::tell::{Tell, many};
use crate::event::{Decision, Finish, Home, Look, Outcome};
use crate::geometry::{Heading, Point, Turn};

listing! {
    ACT     "every square:"
    WRITE   "  maze[xpos][ypos] |= walls; visited = 1"
    ONE     "  1: first open of: ahead, left, right; else turn round"
    TWO lab "  2, 3: first open, unvisited neighbour of: ahead, left, right, back"
    REST    "  2: if there is none: first open of these"
    FOLLOW lab "  3: if there is a route: follow it"
    SEARCH lab "  3: else breadth first over visited squares to the first unvisited one"
    DONE lab "     if there is none: stop          # all is mapped"
    ROUTE lab "     route = the squares to it"
}

cases! {
    START "start" Info Plain "The robot stands on {xy} and looks all round. It writes `{byte}`: visited, and its walls. It *{turn}*."
    OPEN "first-open" Now Node "On {xy} the robot writes `{byte}`. It goes ahead, else left, else right, where there is no wall, else back, visited or not: it *{turn}*."
    FRESH "unvisited" Now Node "On {xy} the robot writes `{byte}`. Of its open neighbours it takes the first that was never visited: it *{turn}*."
    WORN "all-visited" Now Unknown "On {xy}, `{byte}`, every open neighbour was visited before. The robot takes the first open way all the same: it *{turn}*."
    PLAN "search" Now Known "On {xy}, `{byte}`, every open neighbour was visited before. The nearest unvisited square on its map is {target}, {left} away: the robot *{turn}*."
    ROUTE "on-route" Info Plain "The robot follows its route over visited squares to {target}, {left} away: it *{turn}*."
    DONE "mapped" Go End "No square that can be reached is unvisited: the map is *complete*."
}

/// What the page leaves open about the first.
pub static ERRATA_1: &[Erratum] = &[
    Erratum::open(
        "Design",
        "Place and size of the field",
        "The team’s robot begins at 0,0 of 9 by 9 squares. Here the maze’s bounds are the field, and start and orientation are as they are drawn.",
        &[Place::Told(case::START)],
    ),
    Erratum::open(
        "First algorithm",
        "The first keeps no map",
        "The page tells of the array only with the second algorithm. The lab writes it for the first too, so that one can see what the robot saw; it decides nothing.",
        &[Place::Told(case::START)],
    ),
];

/// What the page leaves open about the second.
pub static ERRATA_2: &[Erratum] = &[
    Erratum::open(
        "Design",
        "Place and size of the field",
        "The team’s robot begins at 0,0 of 9 by 9 squares. Here the maze’s bounds are the field, and start and orientation are as they are drawn.",
        &[Place::Told(case::START)],
    ),
    Erratum::open(
        "Second algorithm",
        "Which unvisited neighbour",
        "The robot goes to a neighbour that it has not visited; the page does not say to which of several. The lab keeps the page’s order for open ways: ahead, left, right, back.",
        &[Place::Told(case::START)],
    ),
];

/// What the page leaves open about the third.
pub static ERRATA_3: &[Erratum] = &[
    Erratum::open(
        "Design",
        "Place and size of the field",
        "The team’s robot begins at 0,0 of 9 by 9 squares. Here the maze’s bounds are the field, and start and orientation are as they are drawn.",
        &[Place::Told(case::START)],
    ),
    Erratum::open(
        "Second algorithm",
        "Which unvisited neighbour",
        "The robot goes to a neighbour that it has not visited; the page does not say to which of several. The lab keeps the page’s order for open ways: ahead, left, right, back.",
        &[Place::Told(case::START)],
    ),
    Erratum::open(
        "Third algorithm",
        "The third is described elsewhere",
        "The page only says that searching and path planning were added, and that one can read about it elsewhere. Breadth first to the nearest unvisited square, and driving there without looking again, is the lab’s reading.",
        &[Place::Told(case::PLAN), Place::Told(case::DONE)],
    ),
];

/// Which of the three.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Version {
    /// Turn by turn.
    One,
    /// With priority on unvisited neighbours.
    Two,
    /// With that, and path planning.
    Three,
}

/// A robot that maps squares.
#[derive(Clone, Debug)]
pub struct Cornell {
    version: Version,
    squares: Squares,
    at: Point,
    heading: Heading,
    /// The headings that are left to drive, the next one last.
    route: Vec<Heading>,
    finishes: Vec<u32>,
}

impl Cornell {
    /// A robot with an empty map.
    #[must_use]
    pub fn new(version: Version, field: Field) -> Self {
        let (at, heading) = (field.start, field.heading);
        let squares = match version {
            Version::One | Version::Two => Squares::new(field),
            Version::Three => Squares::for_searching(field),
        };
        Self { version, squares, at, heading, route: Vec::new(), finishes: Vec::new() }
    }

    /// The map.
    #[must_use]
    pub const fn squares(&self) -> &Squares {
        &self.squares
    }

    /// `xpos` and `ypos`.
    #[must_use]
    pub const fn position(&self) -> (i32, i32) {
        self.downwards(self.at)
    }

    /// Where the robot faces on the map, after the stop's turn.
    #[must_use]
    pub const fn orientation(&self) -> Heading {
        self.heading
    }

    /// The headings of the route that is followed, the next one last; empty where there is none.
    #[must_use]
    pub fn route(&self) -> &[Heading] {
        &self.route
    }

    /// Where the route that is followed ends.
    #[must_use]
    pub fn target(&self) -> (i32, i32) {
        let end = self.route.iter().rev().fold(self.at.step(self.heading), |at, &way| at.step(way));
        self.downwards(end)
    }

    const fn downwards(&self, at: Point) -> (i32, i32) {
        (at.x, self.squares.field().height as i32 - 1 - at.y)
    }

    fn choose(&mut self, look: Look, tell: &mut impl Tell<Self>) -> Option<Turn> {
        let start = look.home == Home::PutDown;
        let mut is = |case: u8| tell.is(if start { case::START } else { case });
        if self.version == Version::One {
            is(case::OPEN);
            return Some(self.turn(look.first_of(&ORDER), line::ONE, tell));
        }
        if let Some(way) = self.route.pop() {
            is(case::ROUTE);
            return Some(self.turn(self.heading.turn_to(way), line::FOLLOW, tell));
        }
        let open = ORDER.iter().copied().filter(|&turn| look.sighting.sees(turn));
        let fresh = |turn: &Turn| self.squares.byte(self.at.step(self.heading.turned(*turn))) & VISITED == 0;
        if let Some(turn) = open.clone().find(fresh) {
            is(case::FRESH);
            return Some(self.turn(turn, line::TWO, tell));
        }
        if self.version == Version::Two {
            is(case::WORN);
            tell.none(line::TWO, self);
            return Some(self.turn(look.first_of(&ORDER), line::REST, tell));
        }
        is(case::PLAN);
        tell.none(line::TWO, self);
        let Some(mut route) = self.squares.nearest_unvisited(self.at, self.heading) else {
            tell.none(line::SEARCH, self);
            tell.is(case::DONE);
            tell.did(line::DONE, self);
            return None;
        };
        tell.did(line::SEARCH, self);
        tell.no(line::DONE, self);
        let way = route.pop()?;
        self.route = route;
        Some(self.turn(self.heading.turn_to(way), line::ROUTE, tell))
    }

    /// Turns, as this line says.
    fn turn(&mut self, turn: Turn, line: u8, tell: &mut impl Tell<Self>) -> Turn {
        self.heading = self.heading.turned(turn);
        tell.did(line, self);
        turn
    }
}

impl Robot for Cornell {
    fn decide(&mut self, look: Look, tell: &mut impl Tell<Self>) -> Decision {
        if look.home != Home::PutDown {
            self.at = self.at.step(self.heading);
        }
        let new = self.squares.byte(self.at) & VISITED == 0;
        self.squares.write(self.at, look.sighting.ways.out_of_frame_of(self.heading));
        if look.sighting.finish == Finish::Yes
            && new
            && let Some(place) = self.squares.place(self.at)
        {
            self.finishes.push(place as u32);
        }
        tell.did(line::WRITE, self);
        self.choose(look, tell).map_or(Decision::End(Outcome::Mapped), Decision::Go)
    }

    fn fact(&self, key: &str, out: &mut String) {
        let mut xy = |(x, y): (i32, i32)| {
            out.push_str(&x.to_string());
            out.push(',');
            out.push_str(&y.to_string());
        };
        match key {
            "xy" => xy(self.position()),
            "target" => xy(self.target()),
            "left" => out.push_str(&many(self.route.len() + 1, "square")),
            _ => {
                let byte = self.squares.byte(self.at);
                out.push(if byte & VISITED == 0 { '0' } else { '1' });
                out.push(' ');
                for heading in Heading::ALL {
                    out.push(if byte & wall(heading) == 0 { '0' } else { '1' });
                }
            }
        }
    }

    fn peak_bytes(&self) -> u32 {
        self.squares.bytes().len() as u32
    }

    fn host_bytes(&self) -> usize {
        2 * self.squares.bytes().len() + self.route.len()
    }

    fn plan(&self) -> Option<Plan> {
        self.squares.plan(&self.finishes)
    }
}
