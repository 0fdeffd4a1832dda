//! What a robot thought, stop by stop: small enough to keep a million stops, quick to enter at any of them.
//!
//! A [`Step`] is 8 bytes: the time driven, and what the explorer made of the place. Two indexes stand around
//! the steps. A keyframe every [`KEY_EVERY`] stops holds what adds up (coordinates, clock, `ptr`). The visits
//! to each place of the node table are listed in order, so that a row of the table at any moment is the few
//! visits to its place since a node was last recorded there. Entering any moment costs at most [`KEY_EVERY`]
//! additions, and a row besides a binary search in the visits, wherever in the trace it is. A stop takes 8
//! bytes, its visit to a node 4, its share of a keyframe less than 1 ([`Trace::bytes`] tells).

use alloc::vec::Vec;

use crate::event::{Finish, Outcome, Sighting};
use crate::explorer::book::{Case, Event};
use crate::geometry::{Heading, Turn, Ways};
use crate::playback::{Mark, Timeline};
use crate::settings::Pace;

mod frame;
mod row;
mod script;
mod visits;

use frame::Pauses;
pub use frame::{Frame, Moment, State};
pub use row::{Recognition, Row, WayState};
pub use script::events;
use visits::Visits;

/// Stops between two keyframes.
pub const KEY_EVERY: usize = 64;

/// The highest node number that a step can hold, and so the largest node table.
pub const MAX_NODES: u32 = (1 << 20) - 1;

/// One stop: what the bot saw, and what it made of it.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Step {
    time_diff: u32,
    /// From the lowest bit: node 20, case 4, turn 2, arrival heading 2, ways left-ahead-right 4.
    packed: u32,
}

impl Step {
    fn new(sighting: Sighting, arrival: Heading, case: Case, node: u32, turn: Turn) -> Self {
        let packed = node.min(MAX_NODES)
            | (case as u32) << 20
            | (turn as u32) << 24
            | (arrival as u32) << 26
            | u32::from(sighting.ways.bits()) << 28;
        Self { time_diff: sighting.time_diff, packed }
    }

    const fn bits(self, shift: u32, count: u32) -> u32 {
        self.packed >> shift & ((1 << count) - 1)
    }

    /// Milliseconds driven since the stop before.
    #[must_use]
    pub const fn time_diff(self) -> u32 {
        self.time_diff
    }

    /// The node's place in the table; 0 where the stop was none.
    #[must_use]
    pub const fn node(self) -> u32 {
        self.bits(0, 20)
    }

    /// What kind of stop it was.
    #[must_use]
    pub const fn case(self) -> Case {
        Case::from_index(self.bits(20, 4))
    }

    /// The turn that the bot made; none where it stayed.
    #[must_use]
    pub const fn turn(self) -> Option<Turn> {
        match self.case() {
            Case::Finish | Case::Start | Case::TableFull => None,
            _ => Some(Turn::from_index(self.bits(24, 2) as u8)),
        }
    }

    /// The heading with which the bot arrived, in its own frame.
    #[must_use]
    pub const fn arrival(self) -> Heading {
        Heading::from_index(self.bits(26, 2) as u8)
    }

    /// The heading with which it left, or arrived where it stayed.
    #[must_use]
    pub const fn departure(self) -> Heading {
        match self.turn() {
            Some(turn) => self.arrival().turned(turn),
            None => self.arrival(),
        }
    }

    /// What the bot knew at this stop.
    #[must_use]
    pub const fn sighting(self) -> Sighting {
        Sighting {
            ways: Ways::from_bits(self.bits(28, 4) as u8),
            finish: if matches!(self.case(), Case::Finish) { Finish::Yes } else { Finish::No },
            time_diff: self.time_diff,
        }
    }
}

/// A whole run of the book's explorer.
#[derive(Clone, Debug)]
pub struct Trace {
    pauses: Pauses,
    steps: Vec<Step>,
    keys: Vec<State>,
    visits: Visits,
    outcome: Outcome,
}

impl Trace {
    /// Stops after the start.
    #[must_use]
    pub const fn stops(&self) -> u32 {
        self.steps.len() as u32
    }

    /// The steps in order; stop 1 is the first.
    #[must_use]
    pub fn steps(&self) -> &[Step] {
        &self.steps
    }

    /// How the run ended.
    #[must_use]
    pub const fn outcome(&self) -> Outcome {
        self.outcome
    }

    /// The step of a stop; none for the start (0) and past the end.
    #[must_use]
    pub fn step(&self, stop: u32) -> Option<Step> {
        self.steps.get((stop as usize).checked_sub(1)?).copied()
    }

    /// The bot's variables when a stop is over; past the end, those of the last stop.
    #[must_use]
    pub fn state(&self, stop: u32) -> State {
        let stop = stop.min(self.stops()) as usize;
        let key = stop / KEY_EVERY;
        let mut state = self.keys[key];
        for step in &self.steps[key * KEY_EVERY..stop] {
            state.advance(*step, &self.pauses);
        }
        state
    }

    /// Bytes that the trace takes in memory.
    #[must_use]
    pub fn bytes(&self) -> usize {
        size_of_val(self.steps.as_slice()) + size_of_val(self.keys.as_slice()) + self.visits.bytes()
    }
}

impl Timeline for Trace {
    fn stops(&self) -> u32 {
        self.stops()
    }

    fn lines(&self, stop: u32) -> u8 {
        self.lines(stop)
    }

    fn drive_ms(&self, stop: u32) -> u32 {
        self.step(stop).map_or(0, Step::time_diff)
    }

    fn mark(&self, stop: u32) -> Mark {
        match self.step(stop).map(Step::case) {
            _ if stop > 0 && stop == self.stops() => Mark::End,
            None | Some(Case::Corner) => Mark::Plain,
            Some(Case::New) => Mark::Node,
            Some(Case::DeadEnd) => Mark::DeadEnd,
            Some(Case::Known | Case::KnownBack) => Mark::Known,
            Some(Case::UnknownUturn | Case::UnknownBack) => Mark::Unknown,
            Some(Case::Finish | Case::Start | Case::TableFull) => Mark::End,
        }
    }
}

/// Writes a trace while a run goes on: it listens to the explorer's events and keeps what a step needs.
#[derive(Clone, Debug)]
pub struct Recorder {
    pauses: Pauses,
    state: State,
    steps: Vec<Step>,
    keys: Vec<State>,
    case: Case,
    node: u32,
}

impl Recorder {
    /// A trace with nothing but the start.
    #[must_use]
    pub fn new(pace: Pace) -> Self {
        let state = State::default();
        Self {
            pauses: Pauses::of(&pace),
            state,
            steps: Vec::new(),
            keys: alloc::vec![state],
            case: Case::Corner,
            node: 0,
        }
    }

    /// Takes an event of the stop that goes on.
    pub const fn hear(&mut self, event: Event) {
        match event {
            Event::Case(case) => self.case = case,
            Event::Matched(m) | Event::Recorded(m) => self.node = m,
            _ => {}
        }
    }

    /// Ends the stop: this is what the bot saw, and how it turned (nothing, if it stayed).
    pub fn stop(&mut self, sighting: Sighting, turn: Option<Turn>) {
        let turn = turn.unwrap_or(Turn::Straight);
        let step = Step::new(sighting, self.state.bot_dir, self.case, self.node, turn);
        self.node = 0;
        self.steps.push(step);
        self.state.advance(step, &self.pauses);
        if self.steps.len().is_multiple_of(KEY_EVERY) {
            self.keys.push(self.state);
        }
    }

    /// Stops so far.
    #[must_use]
    pub const fn stops(&self) -> u32 {
        self.steps.len() as u32
    }

    /// The node of the last stop; 0 if it was none.
    #[must_use]
    pub fn last_node(&self) -> u32 {
        self.steps.last().map_or(0, |step| step.node())
    }

    /// The bot's variables now.
    #[must_use]
    pub const fn state(&self) -> &State {
        &self.state
    }

    /// The whole trace.
    #[must_use]
    pub fn finish(mut self, outcome: Outcome) -> Trace {
        self.steps.shrink_to_fit();
        let visits = Visits::of(&self.steps);
        Trace { pauses: self.pauses, steps: self.steps, keys: self.keys, visits, outcome }
    }
}
