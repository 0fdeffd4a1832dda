//! Turn lists: what a robot has to remember to drive its way again, one letter a node (`S` straight, `R` right,
//! `B` back, `L` left).

use alloc::string::String;
use alloc::vec::Vec;
use core::fmt;
use core::str::FromStr;

use crate::event::Outcome;
use crate::geometry::Turn;
use crate::trace::{Moment, Trace};

/// One turn for each node on the way; corners need none, unless the list says otherwise.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct TurnList(Vec<Turn>);

/// Whether a turn list has a letter for each corner.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Corners {
    /// A letter for each node only: the robot follows the line round corners by itself.
    #[default]
    LeftOut,
    /// A letter for each stop.
    Listed,
}

impl TurnList {
    /// What the remembered nodes say at the end of a run that found the finish: node `i` is reached from its
    /// `back_path` and left by its `last_path` (the book's §3.2, which is unwritten).
    #[must_use]
    pub fn of(trace: &Trace) -> Option<Self> {
        if trace.outcome() != Outcome::Finish {
            return None;
        }
        let end = trace.end();
        let ptr = trace.state(trace.stops()).ptr;
        (1..ptr).map(|m| turn_at(trace, end, m)).collect::<Option<Vec<Turn>>>().map(Self)
    }

    /// The turns, in order.
    #[must_use]
    pub fn turns(&self) -> &[Turn] {
        &self.0
    }

    /// As a C array for an Arduino sketch, with a comment.
    #[must_use]
    pub fn c_array(&self, title: &str) -> String {
        super::forms::c_array(self, title)
    }
}

fn turn_at(trace: &Trace, moment: Moment, m: u32) -> Option<Turn> {
    let node = trace.row(moment, m)?.node;
    Some(node.back_path.opposite().turn_to(node.last_path?))
}

impl FromIterator<Turn> for TurnList {
    fn from_iter<I: IntoIterator<Item = Turn>>(turns: I) -> Self {
        Self(turns.into_iter().collect())
    }
}

impl fmt::Display for TurnList {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        self.0.iter().try_for_each(|turn| write!(f, "{}", turn.letter()))
    }
}

/// A letter that names no turn.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct NotATurn {
    /// Which letter, from 1.
    pub place: usize,
    /// The letter.
    pub letter: char,
}

impl fmt::Display for NotATurn {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(
            f,
            "letter {} is “{}”: a turn list has the letters L, S, R and B",
            self.place,
            self.letter.escape_debug()
        )
    }
}

impl core::error::Error for NotATurn {}

impl FromStr for TurnList {
    type Err = NotATurn;

    /// Reads letters as they are; see [`super::letters::read`] for what people type.
    fn from_str(text: &str) -> Result<Self, NotATurn> {
        let turn = |(i, letter)| Turn::from_letter(letter).ok_or(NotATurn { place: i + 1, letter });
        text.chars().enumerate().map(turn).collect::<Result<_, _>>().map(Self)
    }
}
