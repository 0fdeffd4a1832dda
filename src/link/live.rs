//! A live run: the robot's `at` and `do` lines, folded into the trace that the stepper shows.
//!
//! The trace says what the robot thinks. The page's own explorer is fed with the same sightings; the first
//! stop at which it decides otherwise is kept.

use super::report::{Chose, End, Kind, Reached};
use crate::event::{Cut, Decision, Finish, Outcome, Sighting};
use crate::explorer::Explorer;
use crate::explorer::book::grid_store::GridStore;
use crate::explorer::book::{Book, Case, Event};
use crate::geometry::{Heading, Turn, Ways};
use crate::settings::{Order, Pace};
use crate::trace::{Recorder, Trace};

/// More stops than this are not followed.
pub const MAX_STOPS: u32 = 20_000;

/// How far a drive may lead aside of its heading, as a part of its length: real robots measure where they are.
const ASIDE: u32 = 8;
/// A drive may lead so far aside in any case: readings are rounded.
const ASIDE_MS: u32 = 20;

/// Whether a drive that led so far along its heading may have led so far aside (`PROTOCOL.md`, “What the robot
/// says unasked”).
#[must_use]
pub const fn is_along(along: i32, aside: i32) -> bool {
    let length = if along > 0 { along.unsigned_abs() } else { 0 };
    let most = if length / ASIDE > ASIDE_MS { length / ASIDE } else { ASIDE_MS };
    aside.unsigned_abs() <= most && along >= -(ASIDE_MS as i32)
}

/// Whether a stop may be a run's first: straight on from the start.
#[must_use]
pub const fn is_first(at: &Reached) -> bool {
    is_along(at.y, at.x)
}

/// What the robot was asked to do.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Errand {
    /// Learn the maze, and what the page's explorer would do it with.
    Explore(Mind),
    /// Drive by the turn list.
    Route,
    /// It was started without the page: nothing to compare with.
    Unasked,
}

/// What the page's explorer decides with.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Mind {
    /// The order that the robot was given.
    pub order: Order,
    /// Milliseconds, as the page has it set.
    pub epsilon_ms: u32,
    /// Nodes that the robot can remember.
    pub node_max: u32,
}

/// What one mind made of a stop.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Opinion {
    /// What kind of stop.
    pub case: Case,
    /// The node; 0 if none.
    pub node: u32,
    /// The turn; nothing where it stays.
    pub turn: Option<Turn>,
    /// `ptr` afterwards.
    pub ptr: u32,
    /// `returning` afterwards.
    pub returning: bool,
}

/// The first stop at which robot and page decided differently.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Difference {
    /// From 1.
    pub stop: u32,
    /// What the robot did.
    pub robot: Opinion,
    /// What the page's explorer would have done.
    pub page: Opinion,
    /// Where the robot thought that it was, in milliseconds east and north.
    pub at: (i32, i32),
}

/// A run of a robot, as far as it was told.
#[derive(Clone, Debug)]
pub struct LiveRun {
    errand: Errand,
    page: Option<Book<GridStore>>,
    recorder: Recorder,
    /// Where the robot was at the stop before, and how it left.
    before: (i32, i32),
    heading: Heading,
    ptr: u32,
    returning: bool,
    /// The highest place in the table that was told: the next new node has the next one at most.
    most_node: u32,
    at: Option<(Reached, Sighting)>,
    difference: Option<Difference>,
    end: Option<Outcome>,
    parted: Parted,
}

/// How robot and page came apart, where the run was cut by that.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Parted {
    Lost,
    Disconnected,
}

/// What a line did to the run.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Fold {
    /// Nothing to see yet, or no more.
    Nothing,
    /// Another stop is complete.
    Stop,
    /// Another stop is complete, and there the minds differ for the first time.
    Differs,
}

impl LiveRun {
    /// At the start.
    #[must_use]
    pub fn new(errand: Errand, pace: Pace) -> Self {
        let page = match errand {
            Errand::Explore(Mind { order, epsilon_ms, node_max }) => {
                Some(Book::new(GridStore::new(node_max, epsilon_ms), order, epsilon_ms))
            }
            Errand::Route | Errand::Unasked => None,
        };
        Self {
            errand,
            page,
            recorder: Recorder::new(pace),
            before: (0, 0),
            heading: Heading::North,
            ptr: 1,
            returning: false,
            most_node: 0,
            at: None,
            difference: None,
            end: None,
            parted: Parted::Lost,
        }
    }

    /// What it was asked to do.
    #[must_use]
    pub const fn errand(&self) -> Errand {
        self.errand
    }

    /// Stops so far.
    #[must_use]
    pub const fn stops(&self) -> u32 {
        self.recorder.stops()
    }

    /// How it ended; nothing while it goes on.
    #[must_use]
    pub const fn end(&self) -> Option<Outcome> {
        self.end
    }

    /// Where the minds differed first.
    #[must_use]
    pub const fn difference(&self) -> Option<Difference> {
        self.difference
    }

    /// The run so far, for the stepper.
    #[must_use]
    pub fn trace(&self) -> Trace {
        self.recorder.clone().finish(self.end.unwrap_or(Outcome::Cut(Cut::Driving)))
    }

    /// The robot reached a stop.
    pub fn reached(&mut self, at: Reached) {
        if self.end.is_some() {
            return;
        }
        if self.stops() >= MAX_STOPS {
            self.end = Some(Outcome::TooManyStops { limit: MAX_STOPS });
            return;
        }
        // Two `at` lines in a row: the `do` between them is lost, and with it where the robot went.
        if self.at.is_some() || self.has_missed(&at) {
            return self.cut(Cut::Gap);
        }
        match self.sighting(&at) {
            Some(sighting) => {
                self.most_node = self.most_node.max(u32::from(at.node));
                self.at = Some((at, sighting));
            }
            None => self.cut(Cut::Misfit),
        }
    }

    /// Whether the nodes' count tells of a stop that was not heard of.
    fn has_missed(&self, at: &Reached) -> bool {
        let known = match (self.errand, at.kind) {
            // Who learns the maze has met it before.
            (Errand::Explore(_), Kind::Known | Kind::Unknown) => self.most_node,
            // In a run by the list a node is told for each letter.
            (Errand::Explore(_) | Errand::Route | Errand::Unasked, _) => self.most_node + 1,
        };
        u32::from(at.node) > known
    }

    /// What the robot must have seen: it drove straight on from the stop before, along its heading. Where it
    /// measures its way, it comes out a little aside; nothing where that is too much.
    fn sighting(&self, at: &Reached) -> Option<Sighting> {
        let (x, y) = (at.x.wrapping_sub(self.before.0), at.y.wrapping_sub(self.before.1));
        let (dx, dy) = self.heading.vector();
        let (along, aside) = if dx == 0 { (y.wrapping_mul(dy), x) } else { (x.wrapping_mul(dx), y) };
        let time_diff = is_along(along, aside).then(|| u32::try_from(along).unwrap_or(0))?;
        let onward = at.ways.count();
        let (finish, fits) = match at.kind {
            Kind::Finish => (Finish::Yes, true),
            Kind::DeadEnd => (Finish::No, onward == 0),
            Kind::Corner => (Finish::No, onward == 1),
            Kind::New | Kind::Known | Kind::Unknown => (Finish::No, onward > 1),
        };
        let ways: Ways = at.ways.with(Heading::South);
        fits.then_some(Sighting { ways, finish, time_diff })
    }

    /// The robot decided.
    pub fn chose(&mut self, chose: Chose) -> Fold {
        if self.end.is_some() {
            return Fold::Nothing;
        }
        let Some((at, sighting)) = self.at.take() else {
            // The `at` line before it is lost.
            self.cut(Cut::Gap);
            return Fold::Nothing;
        };
        let robot = self.opinion(&at, &chose);
        self.recorder.hear(Event::Case(robot.case));
        self.recorder.hear(Event::Matched(robot.node));
        self.recorder.stop(sighting, robot.turn);
        self.before = (at.x, at.y);
        self.heading = self.heading.turned(robot.turn.unwrap_or(Turn::Straight));
        (self.ptr, self.returning) = (robot.ptr, robot.returning);
        let Some(page) = self.page.as_mut().map(|page| opinion_of(page, sighting)) else { return Fold::Stop };
        if page == robot {
            return Fold::Stop;
        }
        // From here on the two are at different places: nothing more can be compared.
        self.page = None;
        self.difference = Some(Difference { stop: self.stops(), robot, page, at: (at.x, at.y) });
        Fold::Differs
    }

    /// The robot's two lines as a case of the algorithm.
    fn opinion(&self, at: &Reached, chose: &Chose) -> Opinion {
        let node = u32::from(at.node);
        // Leaving by the back path forgets the node.
        let forgets = u32::from(chose.ptr) == node && chose.returning;
        let case = match (at.kind, chose.turn) {
            (Kind::Finish, _) => Case::Finish,
            (Kind::DeadEnd, None) => Case::Start,
            (Kind::DeadEnd, Some(_)) => Case::DeadEnd,
            (Kind::Corner, _) => Case::Corner,
            (Kind::New, None) => Case::TableFull,
            (Kind::New, Some(_)) => Case::New,
            (Kind::Known, _) if forgets => Case::KnownBack,
            (Kind::Known, _) => Case::Known,
            (Kind::Unknown, _) if forgets => Case::UnknownBack,
            (Kind::Unknown, _) => Case::UnknownUturn,
        };
        let (ptr, returning) = (u32::from(chose.ptr), chose.returning);
        Opinion { case, node, turn: chose.turn, ptr, returning }
    }

    /// The robot says that the run is over. It says so more than once; the first counts.
    pub fn ended(&mut self, end: End) {
        if self.end.is_some() {
            return;
        }
        let last = self.recorder.last_node();
        self.end = Some(match end {
            End::Finish => Outcome::Finish,
            End::NoFinishReachable => Outcome::NoFinishReachable,
            End::TableFull => Outcome::TableFull { capacity: self.ptr.saturating_sub(1) },
            End::Lost => Outcome::NoLine { node: last, heading: self.heading },
            End::Stopped => Outcome::Cut(Cut::Stopped),
        });
    }

    /// The page has let the robot go while it drove.
    pub const fn disconnected(&mut self) {
        if self.end.is_none() {
            self.end = Some(Outcome::Cut(Cut::ConnectionLost));
            self.parted = Parted::Disconnected;
        }
    }

    /// Whether the page let the robot go while it drove.
    #[must_use]
    pub const fn was_disconnected(&self) -> bool {
        matches!(self.parted, Parted::Disconnected)
    }

    /// The run is not followed any further.
    pub fn cut(&mut self, cut: Cut) {
        self.end.get_or_insert(Outcome::Cut(cut));
    }
}

/// What the page's explorer makes of a stop.
fn opinion_of(page: &mut Book<GridStore>, sighting: Sighting) -> Opinion {
    let (mut case, mut node) = (Case::Corner, 0);
    let decision = page.decide(sighting, |event| match event {
        Event::Case(it) => case = it,
        Event::Matched(m) | Event::Recorded(m) => node = m,
        Event::Ran(_)
        | Event::Coordinates
        | Event::Ptr(_)
        | Event::Visited(..)
        | Event::Returning(_)
        | Event::Turned(_) => {}
    });
    let turn = match decision {
        Decision::Go(turn) => Some(turn),
        Decision::End(_) => None,
    };
    Opinion { case, node, turn, ptr: page.ptr(), returning: page.returning() }
}
