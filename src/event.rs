//! The narrow waist: what a robot senses at a stop, what it decides, and how a run can end.
//!
//! An explorer sees [`Sighting`]s and nothing else; whether they come from a simulated world or from a real
//! robot on a serial line makes no difference to it.

use core::fmt;

use crate::geometry::{Heading, Turn, Ways};

/// What a robot knows when it stops: the ways that it sees, whether this is the finish, and how long it drove.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Sighting {
    /// Relative to the robot: `North` of this set is ahead, `South` is the line that it came along.
    pub ways: Ways,
    /// Whether the robot stands on the finish.
    pub finish: Finish,
    /// Milliseconds of driving since the last stop (the book's `time_diff`).
    pub time_diff: u32,
}

/// Whether a place is (part of) the finish.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Finish {
    /// Some other place.
    No,
    /// The finish.
    Yes,
}

/// Whether a place is the start, which every robot but the book's knows by its mark.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Home {
    /// Some other place.
    Away,
    /// The start, come upon again.
    Back,
    /// The start, where the robot was put down: it has not driven yet, and looks all round.
    PutDown,
}

/// A stop as every explorer but the book's sees it.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Look {
    /// Ways, finish, and the drive. Where the robot was put down, `South` of the ways is just a way.
    pub sighting: Sighting,
    /// Whether this is the start.
    pub home: Home,
}

impl Look {
    /// Whether there is something to decide: a node, or a start with several ways, which gives the first
    /// letter of the turn list.
    #[must_use]
    pub const fn is_choice(self) -> bool {
        let ways = self.sighting.ways.count();
        match self.home {
            Home::Away => ways > 2,
            Home::Back | Home::PutDown => ways > 1,
        }
    }

    /// Whether the line ends here: no way but back.
    #[must_use]
    pub const fn is_dead_end(self) -> bool {
        !matches!(self.home, Home::PutDown) && self.sighting.ways.count() < 2
    }

    /// The turn where there is nothing to decide: the only way on, or back.
    #[must_use]
    pub const fn only_turn(self) -> Turn {
        let ways = self.sighting.ways;
        let onward = match self.home {
            Home::PutDown => ways,
            Home::Away | Home::Back => ways.without(Heading::South),
        };
        match onward.only() {
            Some(way) => Heading::North.turn_to(way),
            None => Turn::Back,
        }
    }

    /// The first of these turns that there is a way for; back if there is none.
    #[must_use]
    pub fn first_of(self, order: &[Turn]) -> Turn {
        order.iter().copied().find(|&turn| self.sighting.sees(turn)).unwrap_or(Turn::Back)
    }

    /// What the trace report calls the place.
    #[must_use]
    pub const fn seen_name(self) -> &'static str {
        match self.home {
            Home::PutDown => "start",
            Home::Away | Home::Back => self.sighting.seen().name(),
        }
    }

    /// What people call it.
    #[must_use]
    pub const fn shown(self) -> &'static str {
        match self.home {
            Home::PutDown => "start",
            Home::Away | Home::Back => self.sighting.seen().shown(),
        }
    }
}

/// What a stop looks like, seen from the line that the robot came along.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Seen {
    /// The finish, whatever its ways.
    Finish,
    /// No way but back.
    DeadEnd,
    /// One way to the left or right.
    Corner,
    /// One way ahead: no line robot stops here.
    Straight,
    /// Two or three ways on: a decision (book §2.4.1).
    Node,
}

impl Sighting {
    /// Whether there is a way in this direction.
    #[must_use]
    pub const fn sees(self, turn: Turn) -> bool {
        self.ways.has(Heading::North.turned(turn))
    }

    /// The kind of place.
    #[must_use]
    pub const fn seen(self) -> Seen {
        let onward = self.ways.without(Heading::South);
        match (self.finish, onward.count()) {
            (Finish::Yes, _) => Seen::Finish,
            (Finish::No, 0) => Seen::DeadEnd,
            (Finish::No, 1) if onward.has(Heading::North) => Seen::Straight,
            (Finish::No, 1) => Seen::Corner,
            (Finish::No, _) => Seen::Node,
        }
    }
}

impl Seen {
    /// As the trace report names it.
    #[must_use]
    pub const fn name(self) -> &'static str {
        match self {
            Self::Finish => "finish",
            Self::DeadEnd => "dead-end",
            Self::Corner => "corner",
            Self::Straight => "straight",
            Self::Node => "node",
        }
    }

    /// As people read it.
    #[must_use]
    pub const fn shown(self) -> &'static str {
        match self {
            Self::DeadEnd => "dead end",
            Self::Finish | Self::Corner | Self::Straight | Self::Node => self.name(),
        }
    }
}

/// What a robot does after a stop.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Decision {
    /// Turn, then follow the line to the next stop.
    Go(Turn),
    /// Stay: the run is over.
    End(Outcome),
}

/// How a run ended.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Outcome {
    /// The robot stands on the finish.
    Finish,
    /// As far as the robot knows every line was driven, and none led to the finish.
    NoFinishReachable,
    /// Everything that can be reached is mapped.
    Mapped,
    /// Same place, same arrival heading, and nothing in memory that could make the robot decide otherwise:
    /// it would go round for ever.
    Circling {
        /// The stop at which it stood so before; 0 is the start.
        first: u32,
        /// The stop at which it stands so again.
        again: u32,
    },
    /// There is no way out of the start.
    Stuck,
    /// One square more than the path can hold.
    PathFull {
        /// How many it can hold.
        capacity: u32,
    },
    /// One node more than the robot can remember at once.
    TableFull {
        /// How many it can remember.
        capacity: u32,
    },
    /// The robot turned where there is no line: its coordinates must be wrong.
    NoLine {
        /// The node that it took the place for; 0 if none.
        node: u32,
        /// Where it wanted to go, in its own frame.
        heading: Heading,
    },
    /// The driver gave up: no sound exploration of this maze takes so many stops.
    TooManyStops {
        /// How many stops were allowed.
        limit: u32,
    },
    /// A real robot's run, as far as it was told.
    Cut(Cut),
}

/// Why a real robot's run is not known to its end.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Cut {
    /// It still drives.
    Driving,
    /// Somebody stopped it.
    Stopped,
    /// The connection was lost, or the robot started anew.
    ConnectionLost,
    /// A line was lost on the way: what came after makes no sense without it.
    Gap,
    /// What it told of a stop does not fit the drive before, or itself.
    Misfit,
}

impl Outcome {
    /// As the reports name it.
    #[must_use]
    pub const fn name(self) -> &'static str {
        match self {
            Self::Finish => "finish",
            Self::NoFinishReachable => "no-finish-reachable",
            Self::Mapped => "mapped",
            Self::Circling { .. } => "circling",
            Self::Stuck => "stuck",
            Self::TableFull { .. } | Self::PathFull { .. } => "table-full",
            Self::NoLine { .. } | Self::TooManyStops { .. } => "lost",
            Self::Cut(Cut::Driving) => "driving",
            Self::Cut(Cut::Stopped) => "stopped",
            Self::Cut(Cut::ConnectionLost) => "connection-lost",
            Self::Cut(Cut::Gap) => "gap",
            Self::Cut(Cut::Misfit) => "misfit",
        }
    }

    /// As people read it, in a word or two.
    #[must_use]
    pub const fn shown(self) -> &'static str {
        match self {
            Self::NoFinishReachable => "no finish reachable",
            Self::TableFull { .. } => "table full",
            Self::PathFull { .. } => "path full",
            Self::Cut(Cut::ConnectionLost) => "connection lost",
            Self::Cut(Cut::Gap) => "a line was lost",
            Self::Cut(Cut::Misfit) => "it does not fit its drive",
            Self::Finish
            | Self::Mapped
            | Self::Circling { .. }
            | Self::Stuck
            | Self::NoLine { .. }
            | Self::TooManyStops { .. }
            | Self::Cut(Cut::Driving | Cut::Stopped) => self.name(),
        }
    }
}

impl fmt::Display for Outcome {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match *self {
            Self::Finish => write!(f, "finish reached"),
            Self::NoFinishReachable => {
                write!(f, "no finish reachable: the robot knows no way that is left")
            }
            Self::Mapped => write!(f, "everything that can be reached is mapped"),
            Self::Circling { first, again } => write!(
                f,
                "circling: stop {again} is stop {first} again, and nothing in memory could make it decide otherwise"
            ),
            Self::Stuck => write!(f, "stuck: no way leaves the start"),
            Self::PathFull { capacity } => write!(f, "path full ({capacity} squares)"),
            Self::TableFull { capacity } => write!(f, "node table full ({capacity})"),
            Self::NoLine { node: 0, heading } => {
                write!(f, "lost: there is no line {} ({})", heading.word(), heading.index())
            }
            Self::NoLine { node, heading } => {
                write!(f, "lost at node {node}: there is no line {} ({})", heading.word(), heading.index())
            }
            Self::TooManyStops { limit } => write!(f, "lost: still driving after {limit} stops"),
            Self::Cut(cut) => f.write_str(match cut {
                Cut::Driving => "still driving",
                Cut::Stopped => "stopped by hand",
                Cut::ConnectionLost => "connection lost",
                Cut::Gap => "a line of the robot was lost: the rest of its run is not known",
                Cut::Misfit => {
                    "what it told of its next stop does not fit where it drove: the rest of its run is not known"
                }
            }),
        }
    }
}
