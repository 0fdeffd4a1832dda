//! The way to the finish: the turn list that a run leaves, driving it (round 2), and how good it is.

use alloc::string::String;
use alloc::vec::Vec;
use core::fmt;
use core::str::FromStr;

use crate::event::{Finish, Outcome, Seen};
use crate::geometry::{Heading, Point, Turn};
use crate::maze::Maze;
use crate::playback::{Mark, Timeline};
use crate::settings::Pace;
use crate::trace::{Moment, Trace};
use crate::world::{CannotStart, Ideal, World, line_start};

pub mod best;
pub mod tally;

use tally::Tally;

/// One turn for each node on the way; corners need none.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct TurnList(Vec<Turn>);

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
        // The title ends up in a comment: nothing in it may end the line.
        let title: String = title.chars().map(|c| if c.is_control() { ' ' } else { c }).collect();
        let comment = title.trim_matches(|c: char| c == '\\' || c.is_whitespace());
        alloc::format!("const char turns[] = \"{self}\"; // {comment}")
    }
}

fn turn_at(trace: &Trace, moment: Moment, m: u32) -> Option<Turn> {
    let node = trace.row(moment, m)?.node;
    Some(node.back_path.opposite().turn_to(node.last_path?))
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
        write!(f, "letter {} is “{}”: a turn list has the letters L, S, R and B", self.place, self.letter)
    }
}

impl core::error::Error for NotATurn {}

impl FromStr for TurnList {
    type Err = NotATurn;

    fn from_str(text: &str) -> Result<Self, NotATurn> {
        let turn = |(i, letter)| Turn::from_letter(letter).ok_or(NotATurn { place: i + 1, letter });
        text.chars().enumerate().map(turn).collect::<Result<_, _>>().map(Self)
    }
}

/// A stop of round 2.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Leg {
    /// Where the stop is.
    pub at: Point,
    /// The drawing's heading with which the bot arrived.
    pub heading: Heading,
    /// Cells driven since the stop before.
    pub cells: u32,
    /// The turn made here; none at the finish.
    pub turn: Option<Turn>,
    /// Which letter of the list it was, from 1; none at a corner.
    pub letter: Option<usize>,
}

/// Round 2: a drive by a turn list from the start to the finish.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Route {
    /// The start.
    pub start: Point,
    /// Every stop, corners included; the last is the finish.
    pub legs: Vec<Leg>,
}

/// Why a turn list does not lead to the finish.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Strayed {
    /// The robot cannot start at all.
    CannotStart(CannotStart),
    /// A turn where there is no line: which letter (from 1; 0 for a corner's) and where.
    NoLine {
        /// Which letter, from 1.
        letter: usize,
        /// Where.
        at: Point,
    },
    /// A dead end that is not the finish.
    DeadEnd {
        /// Where.
        at: Point,
    },
    /// A node after the last letter.
    ListTooShort {
        /// Where.
        at: Point,
    },
}

impl fmt::Display for Strayed {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::CannotStart(why) => why.fmt(f),
            Self::NoLine { letter: 0, at } => write!(f, "the turn list leads off the line at {at}"),
            Self::NoLine { letter, at } => {
                write!(f, "the turn list leads off the line after letter {letter}, at {at}")
            }
            Self::DeadEnd { at } => write!(f, "the turn list leads to the dead end {at}"),
            Self::ListTooShort { at } => write!(f, "the turn list has no letter for the node at {at}"),
        }
    }
}

impl core::error::Error for Strayed {}

impl Route {
    /// Drives a turn list in an ideal world.
    ///
    /// # Errors
    /// Where it does not lead to the finish.
    pub fn drive(maze: &Maze, list: &TurnList) -> Result<Self, Strayed> {
        let start = line_start(maze).map_err(Strayed::CannotStart)?;
        let mut world = Ideal::new(maze, start, 1);
        let mut letters = list.turns().iter().copied();
        let mut legs = Vec::new();
        let mut turn = Turn::Straight;
        loop {
            let letter = list.turns().len() - letters.len();
            let sighting = world.drive(turn).map_err(|_| Strayed::NoLine { letter, at: world.at() })?;
            let at = world.at();
            let next = match sighting.seen() {
                Seen::Finish => None,
                Seen::DeadEnd => return Err(Strayed::DeadEnd { at }),
                Seen::Corner | Seen::Straight => {
                    sighting.ways.without(Heading::South).only().map(|way| Heading::North.turn_to(way))
                }
                Seen::Node => Some(letters.next().ok_or(Strayed::ListTooShort { at })?),
            };
            let used = list.turns().len() - letters.len();
            let letter = (used > letter).then_some(used);
            legs.push(Leg { at, heading: world.heading(), cells: sighting.time_diff, turn: next, letter });
            match next {
                Some(next) => turn = next,
                None => {
                    debug_assert_eq!(sighting.finish, Finish::Yes);
                    return Ok(Self { start: start.at, legs });
                }
            }
        }
    }

    /// The drive to a stop, from 1.
    #[must_use]
    pub fn leg(&self, stop: u32) -> Option<Leg> {
        self.legs.get((stop as usize).checked_sub(1)?).copied()
    }

    /// What the drive is made of.
    #[must_use]
    pub fn tally(&self) -> Tally {
        self.legs.iter().fold(Tally::default(), |tally, leg| {
            let tally = tally.driven(leg.cells);
            leg.turn.map_or(tally, |turn| tally.turned(turn))
        })
    }

    /// Cells from start to finish.
    #[must_use]
    pub fn cells(&self) -> u32 {
        self.tally().cells
    }

    /// Seconds that the robot takes: driving, every turn and every stop.
    #[must_use]
    pub fn seconds(&self, cell_mm: f64, pace: &Pace) -> f64 {
        self.tally().seconds(cell_mm, pace)
    }
}

/// Round 2 can be played; its stops are the legs. A cell takes as long as `cell_ms` says.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Drive {
    /// What is driven.
    pub route: Route,
    /// Milliseconds for a cell.
    pub cell_ms: u32,
}

impl Timeline for Drive {
    fn stops(&self) -> u32 {
        self.route.legs.len() as u32
    }

    fn lines(&self, _: u32) -> u8 {
        1
    }

    fn drive_ms(&self, stop: u32) -> u32 {
        self.route.leg(stop).map_or(0, |leg| leg.cells * self.cell_ms)
    }

    fn mark(&self, stop: u32) -> Mark {
        match self.route.leg(stop) {
            Some(Leg { turn: None, .. }) => Mark::End,
            Some(Leg { letter: Some(_), .. }) => Mark::Node,
            _ => Mark::Plain,
        }
    }
}
