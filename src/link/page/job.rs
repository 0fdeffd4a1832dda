//! Requests that wait or were sent, and what became of them.

use alloc::string::String;
use core::fmt::Write;

use super::super::fields::Tag;
use super::super::live::Errand;
use super::super::report::{Code, End};
use super::super::request::{Asked, Level, Request};
use super::super::tune::Name;

/// A request's answer is waited for so long.
pub const DEADLINE_MS: u64 = 500;
/// A request is sent so often before it is given up.
pub const TRIES: u8 = 3;

/// Something to ask the robot.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Job {
    /// Are you still there?
    Hi,
    /// Tell so much.
    Watch(Level),
    /// Which turn list do you keep?
    ReadTurns,
    /// The node table.
    ReadNodes,
    /// A setting.
    Get(Name),
    /// Change a setting.
    Set(Name, i32),
    /// The next step of the upload.
    Send,
    /// Drive.
    Run(Errand),
    /// Stop.
    Stop,
    /// You are at the start.
    Place,
}

impl Job {
    /// The request; none for an upload, which has its own.
    pub(super) const fn request(self) -> Option<Request<'static>> {
        Some(match self {
            Self::Hi => Request::Hi,
            Self::Watch(level) => Request::Watch(level),
            Self::ReadTurns => Request::TurnsRead,
            Self::ReadNodes => Request::NodesRead,
            Self::Get(name) => Request::Get(name),
            Self::Set(name, value) => Request::Set(name, value),
            Self::Run(Errand::Explore(mind)) => Request::Explore(mind.order),
            Self::Run(Errand::Route | Errand::Unasked) => Request::RunRoute,
            Self::Stop => Request::Stop,
            Self::Place => Request::Place,
            Self::Send => return None,
        })
    }

    /// Whether `stop` lets it stand: it only asks.
    pub(super) const fn only_asks(self) -> bool {
        match self {
            Self::Hi | Self::Watch(_) | Self::ReadTurns | Self::ReadNodes | Self::Get(_) => true,
            Self::Set(..) | Self::Send | Self::Run(_) | Self::Stop | Self::Place => false,
        }
    }

    /// Whether a person asked for it and wants to know that it was done.
    pub(super) const fn is_told(self) -> bool {
        match self {
            Self::Hi | Self::Watch(_) | Self::ReadTurns | Self::ReadNodes | Self::Get(_) => false,
            Self::Set(..) | Self::Send | Self::Run(_) | Self::Stop | Self::Place => true,
        }
    }

    /// As people call it.
    #[must_use]
    pub fn name(self) -> String {
        match self {
            Self::Hi => "hi".into(),
            Self::Watch(level) => alloc::format!("watch {}", level.word()),
            Self::ReadTurns => "reading the turn list".into(),
            Self::ReadNodes => "reading the node table".into(),
            Self::Get(name) => alloc::format!("reading {}", name.word()),
            Self::Set(name, value) => alloc::format!("{} = {value}", name.word()),
            Self::Send => "sending the turn list".into(),
            Self::Run(Errand::Explore(mind)) => alloc::format!("explore {}", mind.order),
            Self::Run(Errand::Route | Errand::Unasked) => "run the route".into(),
            Self::Stop => "stop".into(),
            Self::Place => "back at the start".into(),
        }
    }
}

/// A request that was sent.
#[derive(Clone, Copy, Debug)]
pub(super) struct Pending {
    pub(super) job: Job,
    pub(super) tag: Tag,
    /// None while it waits for a write before it.
    pub(super) tries: u8,
    pub(super) asked_ms: u64,
    pub(super) deadline_ms: u64,
}

/// The bytes of a request.
pub(super) fn sealed(request: Request<'_>, tag: Tag) -> alloc::vec::Vec<u8> {
    Asked { tag: Some(tag), request }.write().seal().to_vec()
}

/// What became of something, for the user to see.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Note {
    /// When, on the page's clock.
    pub ms: u64,
    /// What.
    pub news: News,
}

/// What there is to tell.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum News {
    /// It was done.
    Done(Job),
    /// The robot will do it: a run.
    Accepted(Job),
    /// The first stop was reached.
    Driving(Job),
    /// The run is over.
    Ended(Job, End),
    /// The robot refused.
    Refused(Job, Code),
    /// No answer, three times.
    NoAnswer(Job),
    /// The connection ended before the answer came.
    Unanswered(Job),
    /// It cannot be asked in this state.
    NotNow(Job),
    /// `stop` came before it.
    Overtaken(Job),
    /// It waited behind a line that did not leave the computer, or a stop that was not confirmed.
    ThrownAway(Job),
    /// It waited too long.
    TooLate(Job),
    /// A line did not leave the computer.
    LostWrite,
    /// A typed line: the one before it has not left yet.
    LineNotNow,
    /// The connection ended while the robot drove, or before it confirmed its stop.
    MayDrive,
    /// The robot started anew by itself.
    Restarted,
    /// Nobody answered at the last rate; the next is tried.
    NextRate {
        /// The rate that is given up.
        from: u32,
        /// The rate that is tried now.
        to: u32,
    },
    /// Nothing was chosen in the browser's list.
    NothingChosen,
    /// The robot is back after the connection was lost.
    Reconnected,
}

impl News {
    /// A plain sentence.
    #[must_use]
    pub fn text(self) -> String {
        let mut text = String::new();
        // Writing to a string cannot fail.
        let _ = match self {
            Self::Done(Job::Stop) => write!(text, "stop: the robot says that it stands."),
            Self::Done(Job::Place) => write!(text, "back at the start: the robot knows."),
            Self::Done(Job::Send) => write!(text, "sending the turn list: the robot has kept it."),
            Self::Done(job) => write!(text, "{}: done.", job.name()),
            Self::Accepted(job) => write!(text, "{}: accepted.", job.name()),
            Self::Driving(job) => write!(text, "{}: driving.", job.name()),
            Self::Ended(job, end) => write!(text, "{}: ended, {}.", job.name(), end.text()),
            Self::Refused(job, code) => write!(text, "{}: the robot says “{}”.", job.name(), code.text()),
            Self::NoAnswer(job) => write!(text, "{}: no answer, asked three times.", job.name()),
            Self::Unanswered(job) => {
                write!(text, "{}: the connection ended before an answer came.", job.name())
            }
            Self::NotNow(job) => write!(text, "{}: not now.", job.name()),
            Self::Overtaken(job) => write!(text, "{}: dropped, because you stopped.", job.name()),
            Self::ThrownAway(job) => write!(text, "{}: thrown away, it was not sent.", job.name()),
            Self::TooLate(job) => write!(text, "{}: not sent, it waited too long. Ask again.", job.name()),
            Self::LostWrite => {
                write!(text, "A line did not leave the computer within a second and was thrown away.")
            }
            Self::LineNotNow => write!(text, "Not sent: the line before has not left the computer yet."),
            Self::MayDrive => {
                write!(text, "The connection ended while the robot drove: take it by hand, it may drive on.")
            }
            Self::Restarted => write!(text, "The robot started anew. Put it back at the start."),
            Self::NextRate { from, to } => write!(text, "Silent at {from} baud: trying {to}."),
            Self::NothingChosen => write!(
                text,
                "No port was chosen. If the list was empty, try another cable: some only charge."
            ),
            Self::Reconnected => write!(text, "The robot is back. Put it back at the start."),
        };
        text
    }
}
