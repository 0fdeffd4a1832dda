//! Hand on the wall (book §1.2), with path simplification: always the way nearest to one hand, and a list of
//! letters from which every detour into a dead end is struck out.
//!
//! | name | meaning |
//! |---|---|
//! | `path` | the letters so far: `L`, `S`, `R` at nodes, `B` at dead ends; corners have none |
//! | `n` | how many letters |
//! | `xBy` | a way that led back: the three letters become one, their turns' sum modulo 360° |

use alloc::string::{String, ToString};
use alloc::vec::Vec;

use super::book::errata::{Erratum, Place};
use super::mind::{Plan, Robot};
use super::tell::{Tell, letters};
use crate::event::{Decision, Finish, Home, Look, Outcome};
use crate::geometry::Turn;

listing! {
    ACT    "every stop:"
    FINISH "  if finish:          stop          # path is the route"
    DEAD lab "  else if dead end:   turn round; add(B)"
    CORNER "  else if corner:     turn the only way there is"
    NODE lab "  else:               first way of: hand, ahead, other hand, back; add(its letter)"
    GAP    ""
    ADD lab "add(letter):"
    PUSH lab "  path[n] = letter; n = n + 1"
    IF_XBY lab "  if n >= 3 and path[n - 2] == B:"
    REDUCE lab "    x B y becomes one letter: the sum of its turns; n = n - 2"
}

cases! {
    START "start" Info Plain "The robot stands at the start and looks all round. Its `path` is {n}: it *{turn}*."
    CORNER "corner" Info Plain "There is only one way on, so there is nothing to decide: the robot *{turn}*. Only nodes and dead ends add a letter."
    NODE "node" Now Node "Of several ways the robot takes the one nearest to its {hand} hand: it *{turn}*, and adds that letter. Its `path` is {path}."
    REDUCED "reduced" Now Known "Of several ways the robot takes the one nearest to its {hand} hand: it *{turn}*. The way behind led to no finish, so three letters `xBy` become their sum. Its `path` is {path}."
    DEAD "dead-end" Now DeadEnd "The line ends: the robot *turns round* and adds the letter `B`. Its `path` is {path}."
    FINISH "finish" Go End "The robot stands on the *finish*. Its `path` is the route: {path}."
}

/// What the book leaves open.
pub static ERRATA: &[Erratum] = &[
    Erratum::open(
        "§1.2",
        "Only the name",
        "The book names LEFT-HAND-ON-THE-WALL and points to another page for it. The order of ways here, hand, ahead, other hand, back, is the lab’s reading, and so is the right hand.",
        &[Place::Told(case::NODE)],
    ),
    Erratum::open(
        "§1.2",
        "Letters are not in the book",
        "That the robot keeps a letter for each node and makes one of three where a way led back is common practice, not the book’s: there it only says that the path is optimal.",
        &[Place::Told(case::REDUCED), Place::Told(case::DEAD)],
    ),
];

/// Which hand stays on the wall.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Side {
    /// Left, ahead, right, back.
    Left,
    /// Right, ahead, left, back.
    Right,
}

impl Side {
    /// The ways, first choice first.
    #[must_use]
    pub const fn order(self) -> [Turn; 4] {
        match self {
            Self::Left => [Turn::Left, Turn::Straight, Turn::Right, Turn::Back],
            Self::Right => [Turn::Right, Turn::Straight, Turn::Left, Turn::Back],
        }
    }

    /// The hand's name.
    #[must_use]
    pub const fn word(self) -> &'static str {
        match self {
            Self::Left => "left",
            Self::Right => "right",
        }
    }
}

/// A robot with a hand on the wall.
///
/// ```
/// use line_maze_lab::explorer::hand;
/// use line_maze_lab::geometry::Turn::{Back, Left, Right, Straight};
/// let mut path = vec![Left, Back];
/// hand::add(&mut path, Straight);
/// assert_eq!(path, [Right]);
/// ```
#[derive(Clone, Debug)]
pub struct Hand {
    side: Side,
    path: Vec<Turn>,
    peak: u32,
}

/// Whether a letter was only added, or three became one.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Added {
    /// One letter more.
    One,
    /// `xBy` became one letter: two fewer than after adding.
    Reduced,
}

/// Adds a letter, and makes one of three where that closes an `xBy`.
pub fn add(path: &mut Vec<Turn>, letter: Turn) -> Added {
    path.push(letter);
    match closed(path) {
        Some(sum) => {
            reduce(path, sum);
            Added::Reduced
        }
        None => Added::One,
    }
}

/// The sum of the last three letters where they are an `xBy`.
const fn closed(path: &[Turn]) -> Option<Turn> {
    match path {
        [.., x, Turn::Back, y] => Some(Turn::from_index(*x as u8 + Turn::Back as u8 + *y as u8)),
        _ => None,
    }
}

fn reduce(path: &mut Vec<Turn>, sum: Turn) {
    path.truncate(path.len() - 3);
    path.push(sum);
}

impl Hand {
    /// A robot with this hand on the wall, and no letter yet.
    #[must_use]
    pub const fn new(side: Side) -> Self {
        Self { side, path: Vec::new(), peak: 0 }
    }

    /// The letters so far.
    #[must_use]
    pub fn path(&self) -> &[Turn] {
        &self.path
    }

    /// The hand on the wall.
    #[must_use]
    pub const fn side(&self) -> Side {
        self.side
    }

    fn add(&mut self, letter: Turn, tell: &mut impl Tell<Self>) -> Added {
        self.path.push(letter);
        // Before three letters become one, all are in the array.
        self.peak = self.peak.max(self.path.len() as u32);
        tell.did(line::PUSH, self);
        let Some(sum) = closed(&self.path) else {
            tell.no(line::IF_XBY, self);
            return Added::One;
        };
        tell.yes(line::IF_XBY, self);
        reduce(&mut self.path, sum);
        tell.did(line::REDUCE, self);
        Added::Reduced
    }
}

impl Robot for Hand {
    fn decide(&mut self, look: Look, tell: &mut impl Tell<Self>) -> Decision {
        if look.sighting.finish == Finish::Yes {
            tell.is(case::FINISH);
            tell.did(line::FINISH, self);
            return Decision::End(Outcome::Finish);
        }
        tell.no(line::FINISH, self);
        if look.is_dead_end() {
            tell.is(case::DEAD);
            tell.did(line::DEAD, self);
            self.add(Turn::Back, tell);
            return Decision::Go(Turn::Back);
        }
        tell.no(line::DEAD, self);
        if !look.is_choice() {
            tell.is(if look.home == Home::PutDown { case::START } else { case::CORNER });
            tell.did(line::CORNER, self);
            return Decision::Go(look.only_turn());
        }
        tell.no(line::CORNER, self);
        let turn = look.first_of(&self.side.order());
        tell.did(line::NODE, self);
        let added = self.add(turn, tell);
        tell.is(match added {
            Added::One => case::NODE,
            Added::Reduced => case::REDUCED,
        });
        Decision::Go(turn)
    }

    fn fact(&self, key: &str, out: &mut String) {
        match key {
            "hand" => out.push_str(self.side.word()),
            "n" if self.path.is_empty() => out.push_str("empty"),
            "n" => out.push_str(&self.path.len().to_string()),
            _ if self.path.is_empty() => out.push_str("empty"),
            _ => letters(&self.path, out),
        }
    }

    fn peak_bytes(&self) -> u32 {
        self.peak
    }

    fn host_bytes(&self) -> usize {
        self.path.len()
    }

    fn plan(&self) -> Option<Plan> {
        Some(Plan::Letters(self.path.clone()))
    }
}
