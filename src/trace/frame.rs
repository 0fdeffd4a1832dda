//! A moment of a trace: the bot's variables as they are after a stop, or after any line in the middle of it.

use super::{Step, Trace, script};
use crate::event::{Outcome, Sighting};
use crate::explorer::book::code::Line;
use crate::explorer::book::{Case, Event};
use crate::geometry::{Heading, Turn};
use crate::settings::Pace;

/// The book's variables, and what the robot has done so far.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct State {
    /// `cur_x`, milliseconds of driving east of the start.
    pub cur_x: i32,
    /// `cur_y`, milliseconds of driving north of the start.
    pub cur_y: i32,
    /// `bot_dir`.
    pub bot_dir: Heading,
    /// `returning`.
    pub returning: bool,
    /// `ptr`.
    pub ptr: u32,
    /// `prev_time`: the clock when the bot last drove off, in milliseconds (turning does not count as
    /// distance, so it is taken again after a turn).
    pub prev_time: u64,
    /// `curr_time`: the clock at the last stop, in milliseconds.
    pub curr_time: u64,
    /// Milliseconds of driving in all.
    pub driven_ms: u64,
}

impl Default for State {
    fn default() -> Self {
        Self {
            cur_x: 0,
            cur_y: 0,
            bot_dir: Heading::North,
            returning: false,
            ptr: 1,
            prev_time: 0,
            curr_time: 0,
            driven_ms: 0,
        }
    }
}

impl State {
    /// `time_diff`: milliseconds of driving up to the last stop.
    #[must_use]
    pub const fn time_diff(&self) -> u64 {
        self.curr_time.saturating_sub(self.prev_time)
    }

    /// Line 2: the bot has driven.
    const fn drive(&mut self, time_diff: u32) {
        let (dx, dy) = self.bot_dir.vector();
        self.cur_x = self.cur_x.wrapping_add(dx.wrapping_mul(time_diff as i32));
        self.cur_y = self.cur_y.wrapping_add(dy.wrapping_mul(time_diff as i32));
        self.curr_time = self.prev_time + time_diff as u64;
        self.driven_ms += time_diff as u64;
    }

    /// What the bot does to its clock and heading when it turns.
    const fn turn(&mut self, turn: Turn) {
        self.bot_dir = self.bot_dir.turned(turn);
    }

    /// The clock when the bot drives off after a stop at `curr_time`.
    const fn depart(&mut self, turn: Turn, pauses: &Pauses) {
        self.prev_time = self.curr_time + pauses.0[turn as usize];
    }

    /// A whole stop.
    pub(super) fn advance(&mut self, step: Step, pauses: &Pauses) {
        self.drive(step.time_diff());
        match step.case() {
            Case::New | Case::Known => {
                self.ptr = step.node() + 1;
                self.returning = false;
            }
            Case::KnownBack | Case::UnknownBack => {
                self.ptr = step.node();
                self.returning = true;
            }
            Case::DeadEnd | Case::UnknownUturn => self.returning = true,
            Case::Finish | Case::Start | Case::Corner | Case::TableFull => {}
        }
        if let Some(turn) = step.turn() {
            self.turn(turn);
            self.depart(turn, pauses);
        }
    }

    /// One event of a stop.
    pub(super) const fn apply(&mut self, event: Event, step: Step) {
        match event {
            Event::Coordinates => self.drive(step.time_diff()),
            Event::Ptr(ptr) => self.ptr = ptr,
            Event::Returning(returning) => self.returning = returning,
            Event::Turned(turn) => self.turn(turn),
            Event::Ran(_) | Event::Matched(_) | Event::Recorded(_) | Event::Visited(..) | Event::Case(_) => {}
        }
    }
}

/// Whole milliseconds from a stop to driving off, for each [`Turn`].
#[derive(Clone, Copy, Debug)]
pub(super) struct Pauses([u64; 4]);

impl Pauses {
    pub(super) fn of(pace: &Pace) -> Self {
        Self(Turn::ALL.map(|turn| ((pace.seconds(turn) + pace.stop_s) * 1000.0 + 0.5) as u64))
    }
}

/// Where in a trace: a stop, and how many of its lines have run.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, PartialOrd, Ord)]
pub struct Moment {
    /// 0 is the start.
    pub stop: u32,
    /// From 1; at the start 0. More than the stop has means all.
    pub lines: u8,
}

impl Moment {
    /// A stop when all its lines have run.
    #[must_use]
    pub const fn after(stop: u32) -> Self {
        Self { stop, lines: u8::MAX }
    }
}

/// What the views show at a moment.
#[derive(Clone, Debug, PartialEq)]
pub struct Frame {
    /// The moment, within the trace.
    pub moment: Moment,
    /// Lines that the stop has in all.
    pub lines: u8,
    /// The variables.
    pub state: State,
    /// The variables one stop earlier (or one line, in the middle of a stop): what differs has changed.
    pub before: State,
    /// What the bot saw; nothing at the start.
    pub sighting: Option<Sighting>,
    /// The case, once the lines that have run decide it.
    pub case: Option<Case>,
    /// The node where the bot stands, once it knows: a place in the table, or 0.
    pub node: u32,
    /// The turn, once it is made.
    pub turn: Option<Turn>,
    /// The line that ran last.
    pub ran: Option<Line>,
    /// The line that runs next; none when the run is over.
    pub next: Option<Line>,
    /// How the run ended, at its last moment.
    pub outcome: Option<Outcome>,
}

impl Trace {
    /// The last moment of the trace.
    #[must_use]
    pub fn end(&self) -> Moment {
        Moment::after(self.stops())
    }

    /// Lines of the pseudo-code that run at a stop.
    #[must_use]
    pub fn lines(&self, stop: u32) -> u8 {
        let before = self.state(stop.saturating_sub(1));
        self.step(stop).map_or(0, |step| script::lines(&script::events(step, &before)))
    }

    /// The moment that is meant, inside the trace: stop and line within their ranges.
    #[must_use]
    pub fn clamp(&self, moment: Moment) -> Moment {
        let stop = moment.stop.min(self.stops());
        Moment { stop, lines: moment.lines.max(1).min(self.lines(stop)) }
    }

    /// One line on; the same moment at the end.
    #[must_use]
    pub fn line_after(&self, moment: Moment) -> Moment {
        let here = self.clamp(moment);
        if here.lines < self.lines(here.stop) {
            Moment { lines: here.lines + 1, ..here }
        } else {
            self.clamp(Moment {
                stop: here.stop + 1,
                lines: if here.stop < self.stops() { 1 } else { u8::MAX },
            })
        }
    }

    /// One line back; the same moment at the start.
    #[must_use]
    pub fn line_before(&self, moment: Moment) -> Moment {
        let here = self.clamp(moment);
        if here.lines > 1 {
            Moment { lines: here.lines - 1, ..here }
        } else {
            self.clamp(Moment::after(here.stop.saturating_sub(1)))
        }
    }

    /// `bot_dir` at a moment: what a picture of the bot has to show.
    #[must_use]
    pub fn bot_dir(&self, moment: Moment) -> Heading {
        let here = self.clamp(moment);
        if here.lines < self.lines(here.stop) {
            return self.frame(here).state.bot_dir;
        }
        self.step(here.stop).map_or(Heading::North, Step::departure)
    }

    /// What the views show at a moment.
    #[must_use]
    pub fn frame(&self, moment: Moment) -> Frame {
        let moment = self.clamp(moment);
        let before = self.state(moment.stop.saturating_sub(1));
        let Some(step) = self.step(moment.stop) else {
            let next = self.step(1).map(|_| Line::GET);
            let (node, lines) = (0, 0);
            return Frame {
                moment,
                lines,
                state: before,
                before,
                sighting: None,
                case: None,
                node,
                turn: None,
                ran: None,
                next,
                outcome: self.outcome_at(moment),
            };
        };
        let events = script::events(step, &before);
        let lines = script::lines(&events);
        let whole = moment.lines == lines;
        let mut frame = Frame {
            moment,
            lines,
            state: before,
            before,
            sighting: Some(step.sighting()),
            case: whole.then_some(step.case()),
            node: if whole { step.node() } else { 0 },
            turn: None,
            ran: None,
            next: None,
            outcome: self.outcome_at(moment),
        };
        for event in script::until_line(&events, moment.lines) {
            if let Event::Ran(line) = *event {
                frame.ran = Some(line);
                if !whole {
                    frame.before = frame.state;
                }
            }
            frame.state.apply(*event, step);
            match *event {
                Event::Turned(turn) => frame.turn = Some(turn),
                Event::Matched(m) | Event::Recorded(m) => frame.node = m,
                _ => {}
            }
        }
        if whole {
            // The clock of the drive that follows: `prev_time` is taken again when the bot drives off.
            frame.next = self.step(moment.stop + 1).map(|_| Line::GET);
        } else {
            frame.next = script::line(&events, moment.lines + 1);
        }
        frame
    }

    fn outcome_at(&self, moment: Moment) -> Option<Outcome> {
        (moment == self.clamp(self.end())).then_some(self.outcome)
    }
}
