//! Sending a turn list: begin, data, commit, read back; and which list the robot holds when that is cut off.

use alloc::string::{String, ToString};

use super::super::fields::{Letters, MAX_LETTERS};
use super::super::frame::crc16;
use super::super::report::{Code, Origin};
use super::super::request::{Request, Upload};
use crate::route::TurnList;

/// How often a broken upload begins anew.
const RESTARTS: u8 = 3;

/// The turn list on the robot, as it was read.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct KeptList {
    /// Its number, length and checksum.
    pub upload: Upload,
    /// Who made it.
    pub origin: Origin,
    /// Its letters.
    pub letters: String,
    /// When it was read, on the page's clock.
    pub read_ms: u64,
}

/// What is known of the robot's list.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub enum Kept {
    /// Not read yet.
    #[default]
    Unknown,
    /// It has none.
    Nothing,
    /// This one.
    List(KeptList),
}

/// How the last upload went.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Sent {
    /// There was none.
    #[default]
    Nothing,
    /// It goes on: so many steps of so many.
    Going {
        /// Steps that the robot acknowledged.
        done: u16,
        /// All steps: begin, data lines, commit, read.
        steps: u16,
    },
    /// The robot holds the new list: it was read back and is the same.
    New,
    /// The robot still holds the list that it held before.
    Old,
    /// Cut off while the robot may have kept it: reading its list will tell.
    Unsure,
    /// What was read back is neither: the robot's memory is faulty.
    Differs,
    /// The robot holds what was sent, and the page has another list by now.
    Past,
}

impl Sent {
    /// A plain sentence; nothing to say before the first upload.
    #[must_use]
    pub const fn says(self) -> &'static str {
        match self {
            Self::Nothing => "",
            Self::Going { .. } => "Sending. Until the end the robot keeps its old list.",
            Self::New => "The robot holds the new list: read back and compared.",
            Self::Old => "The robot still holds its old list.",
            Self::Unsure => "Cut off at the last moment: reading the robot’s list will tell which it holds.",
            Self::Differs => "What the robot holds is not what was sent. Send it again.",
            Self::Past => "The robot holds the list that was sent before, not the one of this maze.",
        }
    }

    /// The same, seen beside the list that the page has now.
    pub(super) fn beside(self, kept: &Kept, here: Option<&str>) -> Self {
        match (self, kept) {
            (Self::New, Kept::List(list)) if here != Some(&list.letters) => Self::Past,
            _ => self,
        }
    }
}

impl Kept {
    /// Whether both are one and the same list, whenever they were read.
    pub(super) fn is_still(&self, before: &Self) -> bool {
        match (self, before) {
            (Self::List(now), Self::List(before)) => {
                (now.upload, now.origin) == (before.upload, before.origin)
            }
            (Self::Nothing, Self::Nothing) => true,
            (Self::Unknown | Self::Nothing | Self::List(_), _) => false,
        }
    }
}

/// An upload that goes on.
#[derive(Clone, Debug)]
pub(super) struct Sending {
    letters: String,
    pub(super) upload: Upload,
    step: Step,
    restarts: u8,
    /// Once a commit is on its way, the robot may hold the new list.
    committed: bool,
}

#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Step {
    Begin,
    Data {
        offset: u16,
    },
    Commit,
    /// Reading it back is a request of its own.
    Read,
}

/// What follows an answer.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Next {
    /// Another request of the upload.
    Go,
    /// Reading the list back.
    Read,
    /// The upload has failed.
    Failed,
}

impl Sending {
    /// The upload of a list under a number that the robot does not use.
    pub(super) fn new(list: &TurnList, id: u16) -> Option<Self> {
        let letters = list.to_string();
        let len = u16::try_from(letters.len()).ok()?;
        let upload = Upload { id, len, crc: crc16(letters.bytes()) };
        Some(Self { letters, upload, step: Step::Begin, restarts: 0, committed: false })
    }

    /// The request that is due.
    pub(super) fn request(&mut self) -> Request<'_> {
        let id = self.upload.id;
        match self.step {
            Step::Begin => Request::TurnsBegin(self.upload),
            Step::Data { offset } => {
                let from = usize::from(offset);
                let to = (from + MAX_LETTERS).min(self.letters.len());
                match Letters::new(self.letters.get(from..to).unwrap_or_default()) {
                    Some(letters) => Request::TurnsData { id, offset, letters },
                    None => Request::TurnsRead,
                }
            }
            Step::Commit => {
                self.committed = true;
                Request::TurnsCommit { id }
            }
            Step::Read => Request::TurnsRead,
        }
    }

    /// The robot answered `ok`.
    pub(super) const fn acknowledged(&mut self) -> Next {
        let next = match self.step {
            Step::Begin => 0,
            Step::Data { offset } => offset + MAX_LETTERS as u16,
            Step::Commit | Step::Read => {
                self.step = Step::Read;
                return Next::Read;
            }
        };
        self.step = if next < self.upload.len { Step::Data { offset: next } } else { Step::Commit };
        Next::Go
    }

    /// The robot answered `err`.
    pub(super) fn refused(&mut self, code: Code) -> Next {
        match code {
            Code::NoUpload | Code::Crc | Code::Store | Code::Range if self.restarts < RESTARTS => {
                self.restart();
                Next::Go
            }
            // Its number is taken after all: by a list that the robot learned meanwhile.
            Code::Id if self.restarts < RESTARTS => {
                self.restart();
                self.upload.id = self.upload.id.wrapping_add(1).max(1);
                Next::Go
            }
            Code::Long
            | Code::Byte
            | Code::Sum
            | Code::Verb
            | Code::Args
            | Code::Name
            | Code::Range
            | Code::Busy
            | Code::Place
            | Code::NoList
            | Code::NoUpload
            | Code::Id
            | Code::Full
            | Code::Crc
            | Code::Store => Next::Failed,
        }
    }

    /// The robot has forgotten the upload: from the beginning.
    pub(super) const fn restart(&mut self) {
        if !matches!(self.step, Step::Read) {
            self.restarts += 1;
            self.step = Step::Begin;
        }
    }

    pub(super) fn progress(&self) -> Sent {
        let lines = self.upload.len.div_ceil(MAX_LETTERS as u16);
        let done = match self.step {
            Step::Begin => 0,
            Step::Data { offset } => 1 + offset / MAX_LETTERS as u16,
            Step::Commit => 1 + lines,
            Step::Read => 2 + lines,
        };
        Sent::Going { done, steps: 3 + lines }
    }

    /// What can be said when nothing more is heard.
    pub(super) const fn cut(&self) -> Sent {
        if self.committed { Sent::Unsure } else { Sent::Old }
    }

    /// What the robot's list says of this upload.
    pub(super) fn compare(&self, kept: &Kept) -> Sent {
        match kept {
            Kept::Unknown => self.cut(),
            Kept::Nothing => Sent::Old,
            Kept::List(list) if list.upload.id != self.upload.id => Sent::Old,
            Kept::List(list) if list.upload == self.upload && list.letters == self.letters => Sent::New,
            Kept::List(_) => Sent::Differs,
        }
    }
}
