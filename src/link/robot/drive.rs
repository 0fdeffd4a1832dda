//! Runs: learning the maze with the book's explorer, and driving by the turn list.

use super::super::fields::Tag;
use super::super::keep::Memory;
use super::super::report::{Chose, Code, End, Ended, Kind, Reached, Report};
use super::super::request::Level;
use super::super::tune::Name;
use super::{Body, END_TIMES, Placed, Progress, Robot};
use crate::event::{Decision, Outcome, Seen, Sighting};
use crate::explorer::Explorer;
use crate::explorer::book::store::{FixedStore, NodeStore};
use crate::explorer::book::{Book, Case, Event};
use crate::geometry::{Heading, Turn};
use crate::settings::Order;

/// What the robot is doing.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Going {
    /// It stands.
    Idle,
    /// It learns the maze.
    Exploring,
    /// It drives by its list.
    Route(Place),
    /// It stands; the run's end is told when the answer is given.
    Ending(End),
}

/// Where a robot on its route thinks that it is.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) struct Place {
    /// Letters used.
    letters: u16,
    x: i32,
    y: i32,
    bot_dir: Heading,
}

impl<B: Body, M: Memory, const NODES: usize> Robot<B, M, NODES> {
    pub(super) fn explore(&mut self, order: Order, tag: Option<Tag>, now_ms: u32) -> Result<(), Code> {
        self.leave_start(tag)?;
        let epsilon = self.tune.get(Name::Epsilon).unsigned_abs();
        self.book = Book::new(FixedStore::new(), order, epsilon);
        self.going = Going::Exploring;
        self.body.drive(Turn::Straight, now_ms);
        Ok(())
    }

    pub(super) fn run_route(&mut self, tag: Option<Tag>, now_ms: u32) -> Result<(), Code> {
        self.keep.list().ok_or(Code::NoList)?;
        self.leave_start(tag)?;
        self.going = Going::Route(Place { letters: 0, x: 0, y: 0, bot_dir: Heading::North });
        self.body.drive(Turn::Straight, now_ms);
        Ok(())
    }

    fn leave_start(&mut self, tag: Option<Tag>) -> Result<(), Code> {
        match self.placed {
            Placed::Somewhere => Err(Code::Place),
            Placed::AtStart => {
                self.placed = Placed::Somewhere;
                self.run_tag = tag;
                self.ended = None;
                Ok(())
            }
        }
    }

    /// The run, if one goes on, a moment later.
    pub(super) fn go_on(&mut self, now_ms: u32) {
        let going = self.going;
        if matches!(going, Going::Idle | Going::Ending(_)) {
            return;
        }
        match (self.body.progress(now_ms), going) {
            (Progress::Driving, _) | (_, Going::Idle | Going::Ending(_)) => {}
            (Progress::NoLine, Going::Exploring | Going::Route(_)) => self.finish(End::Lost, now_ms),
            (Progress::Stop(sighting), Going::Exploring) => self.decide(sighting, now_ms),
            (Progress::Stop(sighting), Going::Route(place)) => self.follow(place, sighting, now_ms),
        }
    }

    /// A stop of a learning run.
    fn decide(&mut self, sighting: Sighting, now_ms: u32) {
        let (mut case, mut node) = (Case::Corner, 0);
        let returning = self.book.returning();
        let decision = self.book.decide(sighting, |event| match event {
            Event::Case(it) => case = it,
            Event::Matched(m) | Event::Recorded(m) => node = m,
            Event::Ran(_)
            | Event::Coordinates
            | Event::Ptr(_)
            | Event::Visited(..)
            | Event::Returning(_)
            | Event::Turned(_) => {}
        });
        let kind = match case {
            Case::Finish => Kind::Finish,
            Case::Start | Case::DeadEnd => Kind::DeadEnd,
            Case::Corner => Kind::Corner,
            Case::New | Case::TableFull => Kind::New,
            Case::Known | Case::KnownBack => Kind::Known,
            Case::UnknownUturn | Case::UnknownBack => Kind::Unknown,
        };
        debug_assert_eq!(kind == Kind::Known, kind == Kind::Known && returning);
        let (x, y) = self.book.coordinates();
        let ways = sighting.ways.without(Heading::South);
        let at = Reached { ms: now_ms, kind, node: node as u16, ways, x, y };
        self.tell(Level::Events, &Report::At(at));
        let (turn, outcome) = match decision {
            Decision::Go(turn) => (Some(turn), None),
            Decision::End(outcome) => (None, Some(outcome)),
        };
        let (ptr, returning) = (self.book.ptr() as u16, self.book.returning());
        self.tell(Level::Events, &Report::Do(Chose { ms: now_ms, turn, ptr, returning }));
        if let Some(turn) = turn {
            self.body.drive(turn, now_ms);
        }
        let end = match outcome {
            None => return,
            Some(Outcome::Finish) => {
                // A list that does not fit is not kept; the node table can still be read.
                let _ = self.learn();
                End::Finish
            }
            Some(Outcome::NoFinishReachable) => End::NoFinishReachable,
            Some(Outcome::TableFull { .. }) => End::TableFull,
            // The book's explorer ends in none of the rest.
            Some(
                Outcome::NoLine { .. }
                | Outcome::TooManyStops { .. }
                | Outcome::Mapped
                | Outcome::Circling { .. }
                | Outcome::Stuck
                | Outcome::PathFull { .. }
                | Outcome::Cut(_),
            ) => End::Lost,
        };
        self.finish(end, now_ms);
    }

    /// Keeps the way along the remembered nodes (§3.2).
    fn learn(&mut self) -> Result<(), Code> {
        let nodes = self.book.nodes();
        let turns = (1..=nodes.len()).map(|m| {
            let node = nodes.node(m);
            let last_path = node.last_path.unwrap_or(node.back_path);
            node.back_path.opposite().turn_to(last_path)
        });
        self.keep.learn(turns)
    }

    /// A stop of a drive by the list.
    fn follow(&mut self, mut place: Place, sighting: Sighting, now_ms: u32) {
        let (dx, dy) = place.bot_dir.vector();
        place.x = place.x.wrapping_add(dx.wrapping_mul(sighting.time_diff as i32));
        place.y = place.y.wrapping_add(dy.wrapping_mul(sighting.time_diff as i32));
        let ways = sighting.ways.without(Heading::South);
        let (kind, turn) = match sighting.seen() {
            Seen::Finish => (Kind::Finish, Err(End::Finish)),
            Seen::DeadEnd => (Kind::DeadEnd, Err(End::Lost)),
            Seen::Corner | Seen::Straight => {
                (Kind::Corner, ways.only().map(|way| Heading::North.turn_to(way)).ok_or(End::Lost))
            }
            Seen::Node => {
                let letter = self.keep.letter(place.letters);
                place.letters = place.letters.saturating_add(1);
                (Kind::Known, letter.ok_or(End::Lost))
            }
        };
        let node = if kind == Kind::Known { place.letters } else { 0 };
        let (x, y) = (place.x, place.y);
        self.tell(Level::Events, &Report::At(Reached { ms: now_ms, kind, node, ways, x, y }));
        let ptr = place.letters.saturating_add(1);
        self.tell(Level::Events, &Report::Do(Chose { ms: now_ms, turn: turn.ok(), ptr, returning: false }));
        match turn {
            Ok(turn) => {
                place.bot_dir = place.bot_dir.turned(turn);
                self.going = Going::Route(place);
                self.body.drive(turn, now_ms);
            }
            Err(end) => self.finish(end, now_ms),
        }
    }

    /// The run is over, and that is told.
    pub(super) fn finish(&mut self, end: End, now_ms: u32) {
        self.body.halt(now_ms);
        self.going = Going::Idle;
        let ended = Ended { ms: now_ms, end };
        self.tell(Level::Events, &Report::End(ended));
        self.ended = Some((ended, END_TIMES - 1));
    }

    /// Tells the end once more, if it was not told often enough.
    pub(super) fn end_again(&mut self) {
        if let Some((ended, times)) = self.ended {
            self.tell(Level::Events, &Report::End(ended));
            self.ended = times.checked_sub(1).filter(|&left| left > 0).map(|left| (ended, left));
        }
    }
}
