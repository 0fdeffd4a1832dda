//! What kind of other end this is, told by what arrives: it speaks the protocol, it talks as any sketch does, or
//! it is noise, as at a wrong rate.
//!
//! A sketch ends its lines with LF, CR LF, CR, or not at all: then 200 ms of silence end them.

use alloc::vec::Vec;

use super::frame::{Decoder, Heard, Sum, is_end};
use super::report::Report;

/// So much silence ends a line that has no end.
pub const PAUSE_MS: u64 = 200;
/// A line is judged after so many bytes, whether it goes on or not.
const MOST_LINE: usize = 160;
/// What was heard long ago counts for less: beyond so many bytes, both sums are halved.
const MEMORY: u32 = 4_096;

/// What the other end is.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Kind {
    /// Not a byte came, or not a whole line yet.
    #[default]
    Nothing,
    /// A line of the protocol came.
    Speaks,
    /// Printable text.
    Talks,
    /// Bytes that no text has.
    Noise,
}

/// Listens to the bytes of one connection.
///
/// ```
/// use line_maze_lab::link::ear::{Ear, Kind};
/// let mut ear = Ear::default();
/// for &byte in b"Left: 53 Right: 201\r" {
///     ear.hear(byte, 10);
/// }
/// assert_eq!(ear.kind(), Kind::Talks);
/// ```
#[derive(Clone, Debug, Default)]
pub struct Ear {
    line: Vec<u8>,
    heard_ms: u64,
    speaks: bool,
    /// Bytes in lines of text, and in lines that are none.
    text: u32,
    noise: u32,
    decoder: Decoder,
}

impl Ear {
    /// Takes a byte.
    pub fn hear(&mut self, byte: u8, now_ms: u64) {
        self.pause(now_ms);
        self.heard_ms = now_ms;
        if let Heard::Line(line) = self.decoder.push(byte) {
            self.speaks |= line.sum == Sum::Right && Report::parse(line.body).is_some();
        }
        if !is_end(byte) {
            self.line.push(byte);
        }
        if is_end(byte) || self.line.len() >= MOST_LINE {
            self.judge();
        }
    }

    /// Lets time pass: silence ends a line.
    pub fn pause(&mut self, now_ms: u64) {
        if now_ms >= self.heard_ms + PAUSE_MS {
            self.judge();
        }
    }

    /// What the other end is, by all that came so far.
    #[must_use]
    pub const fn kind(&self) -> Kind {
        match (self.text, self.noise) {
            _ if self.speaks => Kind::Speaks,
            (0, 0) => Kind::Nothing,
            // A reset, or the first half of a character, is a little noise before the text.
            (text, noise) if noise <= text / 4 => Kind::Talks,
            (_, _) => Kind::Noise,
        }
    }

    fn judge(&mut self) {
        let len = self.line.len() as u32;
        if is_text(&self.line) {
            self.text += len;
        } else {
            self.noise += len;
        }
        self.line.clear();
        if self.text + self.noise > MEMORY {
            self.text /= 2;
            self.noise /= 2;
        }
    }
}

/// What bytes are that came at once.
#[must_use]
pub fn kind(bytes: &[u8]) -> Kind {
    let mut ear = Ear::default();
    for &byte in bytes {
        ear.hear(byte, 0);
    }
    ear.pause(PAUSE_MS);
    ear.kind()
}

/// Whether a line is text: letters of any language, and the few controls that terminals know.
#[must_use]
pub fn is_text(line: &[u8]) -> bool {
    // A line that was cut after so many bytes may end, and so begin, in the middle of a letter.
    let is_middle = |byte: &u8| *byte & 0xC0 == 0x80;
    let begin = line.iter().take(3).take_while(|byte| is_middle(byte)).count();
    let rest = &line[begin..];
    let whole = match core::str::from_utf8(rest) {
        Ok(text) => Ok(text),
        Err(error) if error.error_len().is_none() => core::str::from_utf8(&rest[..error.valid_up_to()]),
        Err(error) => Err(error),
    };
    // Tab, bell, backspace, form feed, and the escape before a colour.
    let known =
        |letter: char| !letter.is_control() || matches!(letter, '\t' | '\x07' | '\x08' | '\x0C' | '\x1B');
    whole.is_ok_and(|text| (!text.is_empty() || line.is_empty()) && text.chars().all(known))
}
