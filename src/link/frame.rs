//! Lines on the wire: cut out of a stream of bytes, checked, and sealed (`PROTOCOL.md`, “Lines”).
//!
//! A line is at most 80 bytes of printable ASCII, ended by LF, CR, or CR LF. Its last three bytes are `*` and a
//! CRC-8 of what stands before, in upper-case hex. No heap: a board reads with this very code.

use crc::{CRC_8_SMBUS, CRC_16_IBM_3740, Crc, NoTable};

/// The most bytes of a line, without its end.
pub const MAX_LINE: usize = 80;

// Without tables: a board has little room for them, and lines are short.
const CRC_8: Crc<u8, NoTable> = Crc::<u8, NoTable>::new(&CRC_8_SMBUS);
const CRC_16: Crc<u16, NoTable> = Crc::<u16, NoTable>::new(&CRC_16_IBM_3740);

/// A line's checksum: polynomial 07, start 00, not reflected.
///
/// ```
/// assert_eq!(line_maze_lab::link::frame::crc8(b"123456789"), 0xF4);
/// ```
#[must_use]
pub const fn crc8(bytes: &[u8]) -> u8 {
    CRC_8.checksum(bytes)
}

/// A turn list's checksum: CRC-16/CCITT-FALSE.
///
/// ```
/// use line_maze_lab::link::frame::crc16;
/// assert_eq!(crc16(*b"123456789"), 0x29B1);
/// assert_eq!(crc16(*b"SSR"), 0xEA59);
/// ```
#[must_use]
pub fn crc16(bytes: impl IntoIterator<Item = u8>) -> u16 {
    let mut digest = CRC_16.digest();
    for byte in bytes {
        digest.update(&[byte]);
    }
    digest.finalize()
}

/// A whole line, without its checksum.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Line<'a> {
    /// What stands before the `*`.
    pub body: &'a str,
    /// Whether a checksum stood behind it.
    pub sum: Sum,
}

/// A line's checksum; a wrong one is a [`LineError`].
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Sum {
    /// It fits.
    Right,
    /// There is none, as when a person types.
    Missing,
}

/// Why a line counts for nothing.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum LineError {
    /// More than [`MAX_LINE`] bytes; said at once, and the rest is dropped up to its end.
    TooLong,
    /// A byte outside 20 to 7E.
    Byte(u8),
    /// The checksum is wrong.
    Sum {
        /// What stood in the line.
        found: u8,
        /// What fits the line.
        right: u8,
    },
    /// A `*` that is not third from the end, or not followed by two digits of upper-case hex.
    Star,
}

/// What a byte brought about.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Heard<'a> {
    /// The line goes on.
    Nothing,
    /// A line.
    Line(Line<'a>),
    /// A line that counts for nothing.
    Bad(LineError),
}

#[derive(Clone, Copy, Debug)]
enum Going {
    /// Taking bytes.
    Taking,
    /// A byte was bad: waiting for the end of the line.
    Spoilt(LineError),
    /// Too long, and said: waiting for its end.
    Dropping,
}

/// Cuts lines out of bytes, in a fixed buffer.
///
/// ```
/// use line_maze_lab::link::frame::{Decoder, Heard, Line, Sum};
/// let mut decoder = Decoder::new();
/// for &byte in b"hi*45" {
///     assert_eq!(decoder.push(byte), Heard::Nothing);
/// }
/// assert_eq!(decoder.push(b'\n'), Heard::Line(Line { body: "hi", sum: Sum::Right }));
/// ```
#[derive(Clone, Debug)]
pub struct Decoder {
    bytes: [u8; MAX_LINE],
    len: usize,
    going: Going,
}

impl Default for Decoder {
    fn default() -> Self {
        Self::new()
    }
}

impl Decoder {
    /// Before the first byte.
    #[must_use]
    pub const fn new() -> Self {
        Self { bytes: [0; MAX_LINE], len: 0, going: Going::Taking }
    }

    /// Takes a byte.
    pub fn push(&mut self, byte: u8) -> Heard<'_> {
        if is_end(byte) {
            let len = core::mem::take(&mut self.len);
            let going = core::mem::replace(&mut self.going, Going::Taking);
            return match going {
                Going::Dropping => Heard::Nothing,
                Going::Spoilt(error) => Heard::Bad(error),
                // An empty line is nothing: so the LF of a CR LF is, and whoever reads need not remember the CR.
                Going::Taking if len == 0 => Heard::Nothing,
                Going::Taking => match check(&self.bytes[..len]) {
                    Ok(line) => Heard::Line(line),
                    Err(error) => Heard::Bad(error),
                },
            };
        }
        match (self.going, byte) {
            (Going::Dropping | Going::Spoilt(_), _) => Heard::Nothing,
            (Going::Taking, b' '..=b'~') if self.len < MAX_LINE => {
                self.bytes[self.len] = byte;
                self.len += 1;
                Heard::Nothing
            }
            (Going::Taking, b' '..=b'~') => {
                self.going = Going::Dropping;
                Heard::Bad(LineError::TooLong)
            }
            (Going::Taking, _) => {
                self.going = Going::Spoilt(LineError::Byte(byte));
                Heard::Nothing
            }
        }
    }
}

/// Whether a byte ends a line: an LF as programs send it, a CR as terminals do, and each of a CR LF.
#[must_use]
pub const fn is_end(byte: u8) -> bool {
    matches!(byte, b'\n' | b'\r')
}

fn check(bytes: &[u8]) -> Result<Line<'_>, LineError> {
    let text = |bytes| core::str::from_utf8(bytes).map_err(|_| LineError::Star);
    let Some(star) = bytes.iter().position(|&byte| byte == b'*') else {
        return Ok(Line { body: text(bytes)?, sum: Sum::Missing });
    };
    let [high, low] = bytes[star + 1..] else { return Err(LineError::Star) };
    let found = hex(high).zip(hex(low)).map(|(high, low)| high << 4 | low).ok_or(LineError::Star)?;
    let right = crc8(&bytes[..star]);
    if found == right {
        Ok(Line { body: text(&bytes[..star])?, sum: Sum::Right })
    } else {
        Err(LineError::Sum { found, right })
    }
}

/// The value of a digit of upper-case hex.
pub(super) const fn hex(digit: u8) -> Option<u8> {
    match digit {
        b'0'..=b'9' => Some(digit - b'0'),
        b'A'..=b'F' => Some(digit - b'A' + 10),
        _ => None,
    }
}

/// A line being written: words with one space between, then the seal.
#[derive(Clone, Debug)]
pub struct Writer {
    bytes: [u8; MAX_LINE + 1],
    len: usize,
}

impl Default for Writer {
    fn default() -> Self {
        Self::new()
    }
}

impl Writer {
    /// An empty line.
    #[must_use]
    pub const fn new() -> Self {
        Self { bytes: [0; MAX_LINE + 1], len: 0 }
    }

    /// Three bytes are kept for the seal; what would not fit is cut off.
    fn push(&mut self, byte: u8) {
        if self.len < MAX_LINE - 3 {
            self.bytes[self.len] = byte;
            self.len += 1;
        }
    }

    /// A field's beginning: the space between it and the one before.
    fn begin(&mut self) {
        if self.len > 0 {
            self.push(b' ');
        }
    }

    /// A field of text. A byte that no line may hold becomes `?`.
    pub fn word(&mut self, word: &str) -> &mut Self {
        self.letters(word.bytes())
    }

    /// A field of single characters.
    pub fn letters(&mut self, letters: impl IntoIterator<Item = u8>) -> &mut Self {
        self.begin();
        for byte in letters {
            self.push(if matches!(byte, b' '..=b'~') && byte != b'*' { byte } else { b'?' });
        }
        self
    }

    /// A field that is a number.
    pub fn number(&mut self, number: impl Into<i64>) -> &mut Self {
        let number = number.into();
        self.begin();
        if number < 0 {
            self.push(b'-');
        }
        self.digits(number.unsigned_abs())
    }

    /// Digits that go on in the same field.
    pub(super) fn digits(&mut self, mut number: u64) -> &mut Self {
        let mut digits = [0; 20];
        let mut from = digits.len();
        loop {
            from -= 1;
            digits[from] = b'0' + (number % 10) as u8;
            number /= 10;
            if number == 0 {
                break;
            }
        }
        for &digit in &digits[from..] {
            self.push(digit);
        }
        self
    }

    /// A field of four digits of hex.
    pub fn hex16(&mut self, number: u16) -> &mut Self {
        self.begin();
        for shift in [12, 8, 4, 0] {
            self.push(digit(number >> shift));
        }
        self
    }

    /// A field `#N`, or `#-`.
    pub fn tag(&mut self, tag: Option<super::Tag>) -> &mut Self {
        self.begin();
        self.push(b'#');
        match tag {
            Some(tag) => return self.digits(u64::from(tag.number())),
            None => self.push(b'-'),
        }
        self
    }

    /// The line with its checksum and LF.
    #[must_use]
    pub fn seal(&mut self) -> &[u8] {
        let sum = crc8(&self.bytes[..self.len]);
        let seal = [b'*', digit(u16::from(sum) >> 4), digit(u16::from(sum)), b'\n'];
        let len = self.len + seal.len();
        self.bytes[self.len..len].copy_from_slice(&seal);
        &self.bytes[..len]
    }
}

const fn digit(number: u16) -> u8 {
    let number = (number & 15) as u8;
    if number < 10 { b'0' + number } else { b'A' + number - 10 }
}
