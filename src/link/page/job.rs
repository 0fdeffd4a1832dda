//! Requests that wait or were sent, and what became of them.

use alloc::string::String;
use core::fmt::Write;

use super::super::fields::Tag;
use super::super::live::Errand;
use super::super::report::Code;
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
    pub(super) tries: u8,
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
            Self::Done(job) => write!(text, "{}: done.", job.name()),
            Self::Refused(job, code) => write!(text, "{}: the robot says “{}”.", job.name(), code.text()),
            Self::NoAnswer(job) => write!(text, "{}: no answer, asked three times.", job.name()),
            Self::Unanswered(job) => {
                write!(text, "{}: the connection ended before an answer came.", job.name())
            }
            Self::NotNow(job) => write!(text, "{}: not now.", job.name()),
            Self::Overtaken(job) => write!(text, "{}: dropped, because you stopped.", job.name()),
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
