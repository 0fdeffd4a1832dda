//! The fields of a line: one space between, whole numbers in decimal, and `#N` at the end of a request.

use super::frame::hex;
use crate::geometry::Turn;

/// A request's number, 0 to 99, which its answer repeats.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Tag(u8);

impl Tag {
    /// The number modulo 100.
    #[must_use]
    pub const fn new(number: u32) -> Self {
        Self((number % 100) as u8)
    }

    /// 0 to 99.
    #[must_use]
    pub const fn number(self) -> u8 {
        self.0
    }

    /// The tag that a field `#N` holds.
    #[must_use]
    pub(super) fn parse(field: &str) -> Option<Self> {
        let number = number(field.strip_prefix('#')?).filter(|number| (0..100).contains(number))?;
        Some(Self(number as u8))
    }
}

/// A decimal number: digits, with a minus sign in front of a negative one.
pub(super) fn number(field: &str) -> Option<i64> {
    let digits = field.strip_prefix('-').unwrap_or(field);
    if digits.is_empty() || digits.len() > 10 || !digits.bytes().all(|byte| byte.is_ascii_digit()) {
        return None;
    }
    let value = digits.bytes().fold(0, |value, digit| value * 10 + i64::from(digit - b'0'));
    Some(if digits.len() < field.len() { -value } else { value })
}

/// Reads the fields of a line one by one.
#[derive(Clone, Debug)]
pub(super) struct Fields<'a>(Option<&'a str>);

impl<'a> Fields<'a> {
    pub(super) const fn new(line: &'a str) -> Self {
        Self(Some(line))
    }

    /// The next field; nothing where there is none, or an empty one.
    pub(super) fn word(&mut self) -> Option<&'a str> {
        let line = self.0?;
        let (word, rest) = match line.split_once(' ') {
            Some((word, rest)) => (word, Some(rest)),
            None => (line, None),
        };
        self.0 = rest;
        (!word.is_empty()).then_some(word)
    }

    /// Everything that is left, which may be nothing.
    pub(super) fn rest(&mut self) -> &'a str {
        self.0.take().unwrap_or_default()
    }

    pub(super) fn number<T: TryFrom<i64>>(&mut self) -> Option<T> {
        T::try_from(number(self.word()?)?).ok()
    }

    /// Four digits of upper-case hex.
    pub(super) fn hex16(&mut self) -> Option<u16> {
        let word = self.word().filter(|word| word.len() == 4)?;
        word.bytes().try_fold(0, |value, digit| Some(value << 4 | u16::from(hex(digit)?)))
    }

    /// `#N` or `#-`.
    pub(super) fn tag(&mut self) -> Option<Option<Tag>> {
        match self.word()? {
            "#-" => Some(None),
            word => Tag::parse(word).map(Some),
        }
    }

    pub(super) fn letters(&mut self) -> Option<Letters<'a>> {
        Letters::new(self.word()?)
    }

    /// The value, if nothing is left over.
    pub(super) fn end<T>(&self, value: T) -> Option<T> {
        self.0.is_none().then_some(value)
    }
}

/// The most letters of a turn list in one line.
pub const MAX_LETTERS: usize = 40;

/// A piece of a turn list, 1 to [`MAX_LETTERS`] letters `S`, `R`, `L` or `B`.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Letters<'a>(&'a str);

impl<'a> Letters<'a> {
    /// The letters, if there are as many as fit a line and all of them name a turn.
    #[must_use]
    pub fn new(letters: &'a str) -> Option<Self> {
        let turns = letters.chars().all(|letter| Turn::from_letter(letter).is_some());
        ((1..=MAX_LETTERS).contains(&letters.len()) && turns).then_some(Self(letters))
    }

    /// As they stand in the line.
    #[must_use]
    pub const fn as_str(self) -> &'a str {
        self.0
    }
}
