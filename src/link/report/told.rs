//! The robot's lines, field by field.

use super::{ABSOLUTE, Fields, Name, RELATIVE, Turn, Ways, Writer};
use super::{parse_turn, parse_ways, setting, write_turn, write_ways};
use crate::geometry::Heading;

/// Who the robot is and what it can hold.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Ready<'a> {
    /// Of the protocol; this is version 1.
    pub protocol: u16,
    /// The firmware's name and version, a word.
    pub firmware: &'a str,
    /// The board, a word.
    pub board: &'a str,
    /// Nodes that it can remember at once.
    pub nodes: u16,
    /// Letters of a turn list that it can keep.
    pub turns: u16,
}

/// The most letters of a firmware's or a board's name.
const MOST_NAME: usize = 16;

impl<'a> Ready<'a> {
    pub(super) fn parse(f: &mut Fields<'a>) -> Option<Self> {
        let short = |word: &&str| word.len() <= MOST_NAME;
        Some(Self {
            protocol: f.number()?,
            firmware: f.word().filter(short)?,
            board: f.word().filter(short)?,
            nodes: f.number()?,
            turns: f.number()?,
        })
    }

    pub(super) fn write(self, line: &mut Writer) {
        line.word("ready").number(self.protocol).word(self.firmware).word(self.board);
        line.number(self.nodes).number(self.turns);
    }
}

/// What an `ok` tells besides.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Said {
    /// Nothing, or what a later version of the protocol may add.
    Nothing,
    /// A setting's value.
    Setting(Name, i32),
    /// How many rows of the node table came before.
    Nodes(u16),
    /// What may be typed, for people.
    Typed,
}

/// The first word of the answer to `help`, and what a person may type without a checksum.
const TYPE: &str = "type";
/// As long as a line has room for.
pub const TYPED: &str = "hi, stop, get NAME, watch LEVEL, place, turns read, nodes read";

impl Said {
    pub(super) fn parse(rest: &str) -> Self {
        let mut f = Fields::new(rest);
        let Some(word) = f.word() else { return Self::Nothing };
        let said = match Name::from_word(word) {
            Some(name) => f.number().map(|value| setting(name, value)),
            None if word == "nodes" => f.number().map(Self::Nodes),
            None if word == TYPE => Some(Self::Typed),
            None => None,
        };
        said.unwrap_or(Self::Nothing)
    }

    pub(super) fn write(self, line: &mut Writer) {
        match self {
            Self::Nothing => {}
            Self::Setting(name, value) => {
                line.word(name.word()).number(value);
            }
            Self::Nodes(count) => {
                line.word("nodes").number(count);
            }
            Self::Typed => {
                line.word(TYPE).word(TYPED);
            }
        }
    }
}

/// What kind of stop was reached.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Kind {
    /// A node for the first time.
    New,
    /// A node met again while returning.
    Known,
    /// A node met again by a new way.
    Unknown,
    /// One way on.
    Corner,
    /// No way on.
    DeadEnd,
    /// The finish.
    Finish,
}

impl Kind {
    const NAMED: [(Self, &'static str); 6] = [
        (Self::New, "new"),
        (Self::Known, "known"),
        (Self::Unknown, "unknown"),
        (Self::Corner, "corner"),
        (Self::DeadEnd, "dead-end"),
        (Self::Finish, "finish"),
    ];

    /// As the wire names it.
    #[must_use]
    pub const fn word(self) -> &'static str {
        Self::NAMED[self as usize].1
    }

    fn from_word(word: &str) -> Option<Self> {
        Self::NAMED.into_iter().find(|&(_, name)| name == word).map(|(kind, _)| kind)
    }
}

/// A stop was reached.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Reached {
    /// Milliseconds since the robot's reset.
    pub ms: u32,
    /// What kind of stop.
    pub kind: Kind,
    /// The node's place in the table; 0 if none.
    pub node: u16,
    /// Relative to the robot, without the way back.
    pub ways: Ways,
    /// `cur_x`, in milliseconds of driving.
    pub x: i32,
    /// `cur_y`, in milliseconds of driving.
    pub y: i32,
}

impl Reached {
    pub(super) fn parse(f: &mut Fields<'_>) -> Option<Self> {
        Some(Self {
            ms: f.number()?,
            kind: Kind::from_word(f.word()?)?,
            node: f.number()?,
            ways: parse_ways(f.word()?, RELATIVE)?,
            x: f.number()?,
            y: f.number()?,
        })
    }

    pub(super) fn write(self, line: &mut Writer) {
        line.word("at").number(self.ms).word(self.kind.word()).number(self.node);
        write_ways(line, self.ways.without(Heading::South), RELATIVE);
        line.number(self.x).number(self.y);
    }
}

/// What the robot decided.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Chose {
    /// Milliseconds since the robot's reset.
    pub ms: u32,
    /// How it turns; nothing where it stays.
    pub turn: Option<Turn>,
    /// `ptr` now.
    pub ptr: u16,
    /// `returning` now.
    pub returning: bool,
}

impl Chose {
    pub(super) fn parse(f: &mut Fields<'_>) -> Option<Self> {
        Some(Self {
            ms: f.number()?,
            turn: parse_turn(f.word()?)?,
            ptr: f.number()?,
            returning: match f.word()? {
                "0" => false,
                "1" => true,
                _ => return None,
            },
        })
    }

    pub(super) fn write(self, line: &mut Writer) {
        line.word("do").number(self.ms);
        write_turn(line, self.turn);
        line.number(self.ptr).number(self.returning);
    }
}

/// The run is over.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Ended {
    /// Milliseconds since the robot's reset.
    pub ms: u32,
    /// How.
    pub end: End,
}

/// How a run ended, as far as the robot knows.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum End {
    /// On the finish.
    Finish,
    /// Back at the start, every line driven.
    NoFinishReachable,
    /// No room for another node.
    TableFull,
    /// No line where there should be one, or a node more than the turn list has letters.
    Lost,
    /// By `stop`, or by hand.
    Stopped,
}

impl End {
    const NAMED: [(Self, &'static str); 5] = [
        (Self::Finish, "finish"),
        (Self::NoFinishReachable, "no-finish-reachable"),
        (Self::TableFull, "table-full"),
        (Self::Lost, "lost"),
        (Self::Stopped, "stopped"),
    ];

    /// As the wire names it.
    #[must_use]
    pub const fn word(self) -> &'static str {
        Self::NAMED[self as usize].1
    }

    /// As people call it.
    #[must_use]
    pub const fn text(self) -> &'static str {
        match self {
            Self::Finish => "finish reached",
            Self::NoFinishReachable => "no finish reachable",
            Self::TableFull => "node table full",
            Self::Lost => "the line is lost",
            Self::Stopped => "stopped",
        }
    }

    pub(super) fn from_word(word: &str) -> Option<Self> {
        Self::NAMED.into_iter().find(|&(_, name)| name == word).map(|(end, _)| end)
    }
}

/// Sensors and motors.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Ir {
    /// Milliseconds since the robot's reset.
    pub ms: u32,
    /// Where the line is: 0 under the leftmost sensor, 4000 under the rightmost.
    pub line: u16,
    /// The five readings from left to right, 0 (white) to 1023 (black).
    pub sensors: [u16; 5],
    /// What the controller works against, −2000 to 2000.
    pub error: i16,
    /// Command of the left motor, −255 to 255.
    pub left: i16,
    /// Command of the right motor, −255 to 255.
    pub right: i16,
}

impl Ir {
    pub(super) fn parse(f: &mut Fields<'_>) -> Option<Self> {
        let (ms, line) = (f.number()?, f.number()?);
        let mut sensors = [0; 5];
        for sensor in &mut sensors {
            *sensor = f.number()?;
        }
        Some(Self { ms, line, sensors, error: f.number()?, left: f.number()?, right: f.number()? })
    }

    pub(super) fn write(self, line: &mut Writer) {
        line.word("ir").number(self.ms).number(self.line);
        for sensor in self.sensors {
            line.number(sensor);
        }
        line.number(self.error).number(self.left).number(self.right);
    }
}

/// The robot lives.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Beat {
    /// Milliseconds since its reset.
    pub ms: u32,
    /// Its battery.
    pub millivolts: u16,
}

/// Who made a turn list.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Origin {
    /// It was sent.
    Sent,
    /// The robot found it.
    Learned,
}

impl Origin {
    /// As the wire names it.
    #[must_use]
    pub const fn word(self) -> &'static str {
        match self {
            Self::Sent => "sent",
            Self::Learned => "learned",
        }
    }

    pub(super) fn from_word(word: &str) -> Option<Self> {
        [Self::Sent, Self::Learned].into_iter().find(|origin| origin.word() == word)
    }
}

/// A row of the node table.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct NodeLine {
    /// Its place in the table, from 1.
    pub node: u16,
    /// `x_cor`, in milliseconds of driving.
    pub x: i32,
    /// `y_cor`, in milliseconds of driving.
    pub y: i32,
    /// `paths`, in the bot's frame.
    pub paths: Ways,
    /// `vpaths`, in the bot's frame.
    pub vpaths: Ways,
    /// `back_path`.
    pub back_path: Heading,
    /// `last_path`; nothing if no way was chosen yet.
    pub last_path: Option<Heading>,
}

impl NodeLine {
    pub(super) fn parse(f: &mut Fields<'_>) -> Option<Self> {
        Some(Self {
            node: f.number()?,
            x: f.number()?,
            y: f.number()?,
            paths: parse_ways(f.word()?, ABSOLUTE)?,
            vpaths: parse_ways(f.word()?, ABSOLUTE)?,
            back_path: f.word()?.parse().ok()?,
            last_path: match f.word()? {
                "-" => None,
                word => Some(word.parse().ok()?),
            },
        })
    }

    pub(super) fn write(self, line: &mut Writer) {
        line.word("node").number(self.node).number(self.x).number(self.y);
        write_ways(line, self.paths, ABSOLUTE);
        write_ways(line, self.vpaths, ABSOLUTE);
        let last = self.last_path.map_or(b'-', |way| way.letter() as u8);
        line.letters([self.back_path.letter() as u8]).letters([last]);
    }
}
