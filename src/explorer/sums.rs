//! Direction sums for “no-loop” and “short-loop” mazes (Sakib, Chowdhury, Ahamed and Imam Hasan, *Maze solving
//! algorithm for line following robot*, 2014, §II): a number for each junction of the way, to which every way
//! that is tried there adds its own.
//!
//! | name | meaning |
//! |---|---|
//! | `j` | the present junction's number; below 1 there is none left |
//! | `a[j]` | the sum of the directions taken there, modulo 4 |
//! | directions | 1 right, 2 front, 3 left, 0 down |

use alloc::string::{String, ToString};
use alloc::vec::Vec;

use super::book::errata::{Erratum, Place};
use super::hand::Side;
use super::mind::{Plan, Robot};
use super::tell::{Tell, tail};
use crate::event::{Decision, Finish, Home, Look, Outcome};
use crate::geometry::Turn;

listing! {
    INIT     "j = 0; a[] = 0"
    ACT      "every stop:"
    FINISH   "  if finish:                     stop      # a[1..j] is the route"
    HOME lab "  else if at the start, j <= 0:  stop      # nothing is left"
    DEAD     "  else if dead end:              turn round; j = j - 1"
    CORNER   "  else if corner:                turn the only way there is"
    ELSE     "  else:"
    NEXT     "    j = j + 1"
    TAKE     "    take the first way of the order, Down last"
    ADD lab "    a[j] = (a[j] + direction) mod 4   # right 1, front 2, left 3, down 0"
    IF_USED lab "    if a[j] == 0:                     # it leaves by the way it first came"
    CLEAR lab "      j = j - 2                       # one to forget it, one for turning back"
}

cases! {
    START "start" Info Plain "The robot stands at the start and looks all round. `j` is {j}: it *{turn}*."
    CORNER "corner" Info Plain "There is only one way on, so there is nothing to decide: the robot *{turn}*."
    JUNCTION "junction" Now Node "Junction `{j}`: of its order, {order}, the robot takes the first way there is and *{turn}*. That adds to `a[{j}]`, which is now {aj}. The array is {a}."
    USED "used-up" Now Known "The sum is 0: by its numbers the robot leaves this junction by the way it first came. So the junction is *used up* and forgotten, and `j` is {j}: it *{turn}*."
    DEAD "dead-end" Now DeadEnd "The line ends: the robot *turns round*. The way back leads to the junction before, if there was one, so `j` goes back to {j}."
    NONE "no-finish" Bad End "The robot is back at the start, and `j` is {j}: it drove *every line*, and none led to a finish."
    FINISH "finish" Go End "The robot stands on the *finish*. The array is the route, junction by junction: {a}."
}

/// What the paper leaves open, or has otherwise.
pub static ERRATA: &[Erratum] = &[
    Erratum {
        printed: Some("(4) for down"),
        meant: Some("0 for down"),
        ..Erratum::open(
            "§II",
            "Down counts 0, not 4",
            "The paper marks down with 4. The lab’s sums have no 4: a whole turn is none, so down adds nothing.",
            &[Place::Told(case::JUNCTION)],
        )
    },
    Erratum::open(
        "§II",
        "The paper takes no remainder",
        "It adds direction numbers as they are. Where several ways of a junction fail, its sum passes 4 and is no direction any more. The lab takes it modulo 4.",
        &[Place::Told(case::JUNCTION)],
    ),
    Erratum::open(
        "§II",
        "A junction that is used up",
        "The paper does not say what happens when every way of a junction was tried. The lab reads the sum 0 as leaving by the first way in: the number is cleared, and j goes back by two.",
        &[Place::Ran(line::CLEAR)],
    ),
    Erratum::open(
        "§II",
        "No finish, no end",
        "The paper always finds its end-point. The lab stops a robot that comes back to the start with no junction left.",
        &[Place::Told(case::NONE)],
    ),
];

/// A robot that sums directions.
#[derive(Clone, Debug)]
pub struct Sums {
    side: Side,
    j: i32,
    /// `a[1]` is the first; places past `j` keep their sums, as the junction is met again.
    a: Vec<u8>,
    peak: u32,
}

impl Sums {
    /// The order Left-Front-Right-Down or Right-Front-Left-Down, and an empty array.
    #[must_use]
    pub const fn new(side: Side) -> Self {
        Self { side, j: 0, a: Vec::new(), peak: 0 }
    }

    /// The present junction's number.
    #[must_use]
    pub const fn j(&self) -> i32 {
        self.j
    }

    /// The whole array, `a[1]` first; what is past `j` waits for its junction to be met again.
    #[must_use]
    pub fn a(&self) -> &[u8] {
        &self.a
    }

    /// `a[1..=j]`: the way from the start to here.
    #[must_use]
    pub fn sums(&self) -> &[u8] {
        &self.a[..usize::try_from(self.j).unwrap_or(0).min(self.a.len())]
    }

    /// The order.
    #[must_use]
    pub const fn side(&self) -> Side {
        self.side
    }

    fn junction(&mut self, look: Look, tell: &mut impl Tell<Self>) -> Turn {
        tell.yes(line::ELSE, self);
        // Below 1 there are no places; on the floor that cannot be.
        self.j = (self.j + 1).max(1);
        let place = self.j as usize - 1;
        if self.a.len() <= place {
            self.a.resize(place + 1, 0);
        }
        self.peak = self.peak.max(self.j as u32);
        tell.did(line::NEXT, self);
        let turn = look.first_of(&self.side.order());
        tell.did(line::TAKE, self);
        self.a[place] = (self.a[place] + code(turn)) % 4;
        // Whatever was tried behind this junction belongs to another way of it.
        self.a.truncate(place + 1);
        tell.did(line::ADD, self);
        // The start is no junction that the robot came to: down is a way like the others there.
        if self.a[place] != 0 || (look.home != Home::Away && self.j <= 1) {
            tell.is(case::JUNCTION);
            tell.no(line::IF_USED, self);
            return turn;
        }
        tell.is(case::USED);
        tell.yes(line::IF_USED, self);
        self.a.truncate(place);
        self.j -= 2;
        tell.did(line::CLEAR, self);
        turn
    }
}

/// The paper's number of a direction.
const fn code(turn: Turn) -> u8 {
    match turn {
        Turn::Right => 1,
        Turn::Straight => 2,
        Turn::Left => 3,
        Turn::Back => 0,
    }
}

/// The turn that a number of the array stands for.
#[must_use]
pub const fn turn(sum: u8) -> Turn {
    match sum % 4 {
        1 => Turn::Right,
        2 => Turn::Straight,
        3 => Turn::Left,
        _ => Turn::Back,
    }
}

impl Robot for Sums {
    fn decide(&mut self, look: Look, tell: &mut impl Tell<Self>) -> Decision {
        if look.sighting.finish == Finish::Yes {
            tell.is(case::FINISH);
            tell.did(line::FINISH, self);
            return Decision::End(Outcome::Finish);
        }
        tell.no(line::FINISH, self);
        if look.home == Home::Back && look.is_dead_end() && self.j <= 0 {
            tell.is(case::NONE);
            tell.did(line::HOME, self);
            return Decision::End(Outcome::NoFinishReachable);
        }
        tell.no(line::HOME, self);
        if look.is_dead_end() {
            self.j -= 1;
            tell.is(case::DEAD);
            tell.did(line::DEAD, self);
            return Decision::Go(Turn::Back);
        }
        tell.no(line::DEAD, self);
        if !look.is_choice() {
            tell.is(if look.home == Home::PutDown { case::START } else { case::CORNER });
            tell.did(line::CORNER, self);
            return Decision::Go(look.only_turn());
        }
        tell.no(line::CORNER, self);
        Decision::Go(self.junction(look, tell))
    }

    fn fact(&self, key: &str, out: &mut String) {
        match key {
            "j" => out.push_str(&self.j.to_string()),
            "aj" => out.push_str(&self.sums().last().copied().unwrap_or(0).to_string()),
            "order" => out.push_str(match self.side {
                Side::Left => "left, front, right, down",
                Side::Right => "right, front, left, down",
            }),
            _ => {
                out.push('[');
                tail(self.sums(), out, |sum, out| out.push((b'0' + sum) as char));
                out.push(']');
            }
        }
    }

    fn peak_bytes(&self) -> u32 {
        self.peak
    }

    fn host_bytes(&self) -> usize {
        self.a.len()
    }

    fn node(&self, look: Look) -> Option<u32> {
        u32::try_from(self.j).ok().filter(|&j| j > 0).filter(|_| look.is_choice())
    }

    fn plan(&self) -> Option<Plan> {
        Some(Plan::Letters(self.sums().iter().map(|&sum| turn(sum)).collect()))
    }
}
