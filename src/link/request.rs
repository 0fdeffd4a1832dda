//! What the page says to the robot.

use super::fields::{Fields, Letters, Tag};
use super::frame::{Line, Sum, Writer};
use super::report::Code;
use super::tune::Name;
use crate::settings::{Order, Preference};

/// A request with its number; typed by hand it may have none.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Asked<'a> {
    /// Repeated in the answer.
    pub tag: Option<Tag>,
    /// What is asked.
    pub request: Request<'a>,
}

/// What can be asked of a robot.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Request<'a> {
    /// Who are you? Answered by a `ready` line, then `ok`.
    Hi,
    /// What may be typed?
    Help,
    /// A turn list follows.
    TurnsBegin(Upload),
    /// A piece of it.
    TurnsData {
        /// Of which upload.
        id: u16,
        /// In letters.
        offset: u16,
        /// The piece.
        letters: Letters<'a>,
    },
    /// That was all: check it and keep it.
    TurnsCommit {
        /// Of which upload.
        id: u16,
    },
    /// Tell the list that is kept.
    TurnsRead,
    /// Learn the maze.
    Explore(Order),
    /// Drive by the list that is kept.
    RunRoute,
    /// Stop at once.
    Stop,
    /// The robot was put back at the start.
    Place,
    /// Tell the node table.
    NodesRead,
    /// Tell a setting.
    Get(Name),
    /// Change a setting.
    Set(Name, i32),
    /// How much to tell unasked.
    Watch(Level),
}

/// What an upload announces.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Upload {
    /// Chosen by the page, 1 or more; not that of the list that is kept.
    pub id: u16,
    /// In letters.
    pub len: u16,
    /// CRC-16 of all letters.
    pub crc: u16,
}

/// How much a robot tells unasked.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Level {
    /// Nothing but `ready`.
    Off,
    /// `at`, `do`, `end` and `beat`: what a robot tells after a reset.
    #[default]
    Events,
    /// `ir` lines too.
    All,
}

impl Level {
    const NAMED: [(Self, &'static str); 3] =
        [(Self::Off, "off"), (Self::Events, "events"), (Self::All, "all")];

    /// As the wire names it.
    #[must_use]
    pub const fn word(self) -> &'static str {
        match self {
            Self::Off => "off",
            Self::Events => "events",
            Self::All => "all",
        }
    }
}

/// Why a line is no request that may be carried out; its number is told where it could be read.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct NotAsked {
    /// Repeated in the answer.
    pub tag: Option<Tag>,
    /// Why.
    pub code: Code,
}

impl<'a> Asked<'a> {
    /// Reads a line.
    ///
    /// # Errors
    /// Where the verb, a setting's name or an argument is not understood, and where a request that changes
    /// something has no checksum.
    pub fn parse(line: Line<'a>) -> Result<Self, NotAsked> {
        let (body, tag) = match line.body.rsplit_once(' ') {
            Some((body, last)) if last.starts_with('#') => match Tag::parse(last) {
                Some(tag) => (body, Some(tag)),
                None => return Err(NotAsked { tag: None, code: Code::Args }),
            },
            _ => (line.body, None),
        };
        let request = Request::parse(body).map_err(|code| NotAsked { tag, code })?;
        match line.sum {
            Sum::Missing if !request.may_be_typed() => Err(NotAsked { tag, code: Code::Sum }),
            Sum::Missing | Sum::Right => Ok(Self { tag, request }),
        }
    }

    /// The line, sealed.
    #[must_use]
    pub fn write(&self) -> Writer {
        let mut line = self.request.write();
        if self.tag.is_some() {
            line.tag(self.tag);
        }
        line
    }
}

impl<'a> Request<'a> {
    /// Whether it is taken without a checksum: only what changes nothing that is kept.
    #[must_use]
    pub const fn may_be_typed(self) -> bool {
        match self {
            Self::Hi
            | Self::Help
            | Self::Stop
            | Self::Get(_)
            | Self::Watch(_)
            | Self::Place
            | Self::TurnsRead
            | Self::NodesRead => true,
            Self::TurnsBegin(_)
            | Self::TurnsData { .. }
            | Self::TurnsCommit { .. }
            | Self::Explore(_)
            | Self::RunRoute
            | Self::Set(..) => false,
        }
    }

    fn parse(body: &'a str) -> Result<Self, Code> {
        let mut f = Fields::new(body);
        let verb = f.word().ok_or(Code::Verb)?;
        match verb {
            "hi" => f.end(Self::Hi).ok_or(Code::Args),
            "help" => f.end(Self::Help).ok_or(Code::Args),
            "stop" => f.end(Self::Stop).ok_or(Code::Args),
            "place" => f.end(Self::Place).ok_or(Code::Args),
            "nodes" => Self::nodes(&mut f).ok_or(Code::Args),
            "turns" => Self::turns(&mut f),
            "run" => Self::run(&mut f).ok_or(Code::Args),
            "watch" => Self::watch(&mut f).ok_or(Code::Args),
            "get" => {
                let name = Name::parse(&mut f).ok_or(Code::Name)?;
                f.end(Self::Get(name)).ok_or(Code::Args)
            }
            "set" => {
                let name = Name::parse(&mut f).ok_or(Code::Name)?;
                let value: i64 = f.number().ok_or(Code::Args)?;
                let value = i32::try_from(value).map_err(|_| Code::Range)?;
                f.end(Self::Set(name, value)).ok_or(Code::Args)
            }
            _ => Err(Code::Verb),
        }
    }

    fn nodes(f: &mut Fields<'a>) -> Option<Self> {
        if f.word()? == "read" { f.end(Self::NodesRead) } else { None }
    }

    fn turns(f: &mut Fields<'a>) -> Result<Self, Code> {
        let asked = match f.word().ok_or(Code::Args)? {
            "begin" => {
                let (id, len) = (within(f, 1)?, within(f, 0)?);
                Self::TurnsBegin(Upload { id, len, crc: f.hex16().ok_or(Code::Args)? })
            }
            "data" => {
                let (id, offset) = (within(f, 1)?, within(f, 0)?);
                Self::TurnsData { id, offset, letters: f.letters().ok_or(Code::Args)? }
            }
            "commit" => Self::TurnsCommit { id: within(f, 1)? },
            "read" => Self::TurnsRead,
            _ => return Err(Code::Args),
        };
        f.end(asked).ok_or(Code::Args)
    }

    fn run(f: &mut Fields<'a>) -> Option<Self> {
        let asked = match f.word()? {
            "route" => Self::RunRoute,
            "explore" => Self::Explore(order(f.word()?)?),
            _ => return None,
        };
        f.end(asked)
    }

    fn watch(f: &mut Fields<'a>) -> Option<Self> {
        let word = f.word()?;
        let (level, _) = Level::NAMED.into_iter().find(|&(_, name)| name == word)?;
        f.end(Self::Watch(level))
    }

    fn write(self) -> Writer {
        let mut line = Writer::new();
        match self {
            Self::Hi => line.word("hi"),
            Self::Help => line.word("help"),
            Self::TurnsBegin(Upload { id, len, crc }) => {
                line.word("turns").word("begin").number(id).number(len).hex16(crc)
            }
            Self::TurnsData { id, offset, letters } => {
                line.word("turns").word("data").number(id).number(offset).word(letters.as_str())
            }
            Self::TurnsCommit { id } => line.word("turns").word("commit").number(id),
            Self::TurnsRead => line.word("turns").word("read"),
            Self::Explore(Order::Fixed(preference)) => {
                let turns = preference.turns().map(|turn| turn.letter() as u8);
                line.word("run").word("explore").letters(turns)
            }
            Self::Explore(Order::Random(seed)) => {
                line.word("run").word("explore").word("random:").digits(seed)
            }
            Self::RunRoute => line.word("run").word("route"),
            Self::Stop => line.word("stop"),
            Self::Place => line.word("place"),
            Self::NodesRead => line.word("nodes").word("read"),
            Self::Get(name) => line.word("get").word(name.word()),
            Self::Set(name, value) => line.word("set").word(name.word()).number(value),
            Self::Watch(level) => line.word("watch").word(level.word()),
        };
        line
    }
}

/// A number from `least` to 65,535.
fn within(f: &mut Fields<'_>, least: u16) -> Result<u16, Code> {
    let number: i64 = f.number().ok_or(Code::Args)?;
    u16::try_from(number).ok().filter(|&number| number >= least).ok_or(Code::Range)
}

/// `SRL` and the like, or `random:` and a seed of up to 20 digits.
fn order(word: &str) -> Option<Order> {
    if let Some(seed) = word.strip_prefix("random:") {
        let digits = !seed.is_empty() && seed.len() <= 20 && seed.bytes().all(|byte| byte.is_ascii_digit());
        let add = |sum: u64, digit: u8| sum.checked_mul(10)?.checked_add(u64::from(digit - b'0'));
        return digits.then(|| seed.bytes().try_fold(0, add)).flatten().map(Order::Random);
    }
    let named =
        |preference: &Preference| word.chars().eq(preference.turns().into_iter().map(|turn| turn.letter()));
    Preference::ALL.into_iter().find(named).map(Order::Fixed)
}
