//! What the robot says to the page: answers, and what it tells unasked.

use super::fields::{Fields, Letters, Tag};
use super::frame::Writer;
use super::tune::Name;
use crate::geometry::{Heading, Turn, Ways};

mod code;
mod told;

pub use code::Code;
pub use told::{Beat, Chose, End, Ended, Ir, Kind, NodeLine, Origin, Reached, Ready, Said, TYPED};

/// A line from the robot.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Report<'a> {
    /// It is there: after a reset, and before the `ok` to a `hi`.
    Ready(Ready<'a>),
    /// A request was carried out.
    Ok(Option<Tag>, Said),
    /// A request, or a line, was not.
    Err(Option<Tag>, Code),
    /// A stop was reached.
    At(Reached),
    /// What the robot decided there.
    Do(Chose),
    /// The run is over.
    End(Ended),
    /// Sensors and motors.
    Ir(Ir),
    /// Once a second.
    Beat(Beat),
    /// The turn list that is kept; its letters follow.
    TurnsHave {
        /// Its number.
        id: u16,
        /// In letters.
        len: u16,
        /// CRC-16 of all letters.
        crc: u16,
        /// Who made it.
        origin: Origin,
    },
    /// A piece of the turn list.
    TurnsData {
        /// The list's number.
        id: u16,
        /// In letters.
        offset: u16,
        /// The piece.
        letters: Letters<'a>,
    },
    /// A row of the node table.
    Node(NodeLine),
}

impl<'a> Report<'a> {
    /// Reads a line without its checksum; nothing where it is no report.
    #[must_use]
    pub fn parse(body: &'a str) -> Option<Self> {
        let mut f = Fields::new(body);
        let report = match f.word()? {
            "ready" => Self::Ready(Ready::parse(&mut f)?),
            "ok" => return Some(Self::Ok(f.tag()?, Said::parse(f.rest()))),
            "err" => {
                let (tag, code) = (f.tag()?, Code::from_word(f.word()?)?);
                // The words after it are for people.
                f.rest();
                return Some(Self::Err(tag, code));
            }
            "at" => Self::At(Reached::parse(&mut f)?),
            "do" => Self::Do(Chose::parse(&mut f)?),
            "end" => Self::End(Ended { ms: f.number()?, end: End::from_word(f.word()?)? }),
            "ir" => Self::Ir(Ir::parse(&mut f)?),
            "beat" => Self::Beat(Beat { ms: f.number()?, millivolts: f.number()? }),
            "turns" => match f.word()? {
                "have" => Self::TurnsHave {
                    id: f.number()?,
                    len: f.number()?,
                    crc: f.hex16()?,
                    origin: Origin::from_word(f.word()?)?,
                },
                "data" => Self::TurnsData { id: f.number()?, offset: f.number()?, letters: f.letters()? },
                _ => return None,
            },
            "node" => Self::Node(NodeLine::parse(&mut f)?),
            _ => return None,
        };
        f.end(report)
    }

    /// The line, to be sealed.
    #[must_use]
    pub fn write(&self) -> Writer {
        let mut line = Writer::new();
        match *self {
            Self::Ready(ready) => ready.write(&mut line),
            Self::Ok(tag, said) => {
                line.word("ok").tag(tag);
                said.write(&mut line);
            }
            Self::Err(tag, code) => {
                line.word("err").tag(tag).word(code.word()).word(code.text());
            }
            Self::At(reached) => reached.write(&mut line),
            Self::Do(chose) => chose.write(&mut line),
            Self::End(Ended { ms, end }) => {
                line.word("end").number(ms).word(end.word());
            }
            Self::Ir(ir) => ir.write(&mut line),
            Self::Beat(Beat { ms, millivolts }) => {
                line.word("beat").number(ms).number(millivolts);
            }
            Self::TurnsHave { id, len, crc, origin } => {
                line.word("turns").word("have").number(id).number(len).hex16(crc).word(origin.word());
            }
            Self::TurnsData { id, offset, letters } => {
                line.word("turns").word("data").number(id).number(offset).word(letters.as_str());
            }
            Self::Node(node) => node.write(&mut line),
        }
        line
    }
}

/// An alphabet of ways, in the order in which they are written.
type Alphabet = [(Heading, u8)];

/// The bot's own directions.
const ABSOLUTE: &Alphabet =
    &[(Heading::North, b'N'), (Heading::East, b'E'), (Heading::South, b'S'), (Heading::West, b'W')];
/// Relative to the robot; the way back is never told.
const RELATIVE: &Alphabet = &[(Heading::West, b'L'), (Heading::North, b'S'), (Heading::East, b'R')];

/// Ways as letters of an alphabet, or `-` for none.
fn write_ways(line: &mut Writer, ways: Ways, letters: &Alphabet) {
    if ways.is_empty() {
        line.word("-");
    } else {
        line.letters(letters.iter().filter(|&&(way, _)| ways.has(way)).map(|&(_, letter)| letter));
    }
}

fn parse_ways(word: &str, letters: &Alphabet) -> Option<Ways> {
    if word == "-" {
        return Some(Ways::NONE);
    }
    word.bytes().try_fold(Ways::NONE, |ways, byte| {
        let &(way, _) = letters.iter().find(|&&(way, letter)| letter == byte && !ways.has(way))?;
        Some(ways.with(way))
    })
}

/// `S`, `R`, `L`, `B`, or `-` where the robot stays.
fn write_turn(line: &mut Writer, turn: Option<Turn>) {
    line.letters([turn.map_or(b'-', |turn| turn.letter() as u8)]);
}

fn parse_turn(word: &str) -> Option<Option<Turn>> {
    let mut letters = word.chars();
    match (letters.next()?, letters.next()) {
        ('-', None) => Some(None),
        (letter, None) => Turn::from_letter(letter).map(Some),
        _ => None,
    }
}

const fn setting(name: Name, value: i32) -> Said {
    Said::Setting(name, value)
}
