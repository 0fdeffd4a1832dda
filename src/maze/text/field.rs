//! A piece of a line that knows its place: a value, or one of its words, and what it can be read as.

use super::error::{ParseError, Place, Problem};
use crate::geometry::{Heading, Point};
use crate::maze::{BoundsError, MAX_COORDINATE, millimetres};

/// Part of a line.
#[derive(Clone, Copy)]
pub(super) struct Field<'a> {
    line: &'a str,
    number: u32,
    at: usize,
    /// The part itself.
    pub(super) text: &'a str,
}

impl<'a> Field<'a> {
    /// The line from byte `at` to its end, without the blanks that it begins with.
    pub(super) fn new(line: &'a str, number: u32, at: usize) -> Self {
        let text = line[at..].trim_start_matches([' ', '\t']);
        Self { line, number, at: line.len() - text.len(), text }
    }

    /// Where it begins.
    pub(super) fn place(self) -> Place {
        let before = self.line[..self.at].chars().count();
        Place { line: self.number, column: u32::try_from(before).unwrap_or(u32::MAX).saturating_add(1) }
    }

    pub(super) fn expected(self, what: &'static str) -> ParseError {
        self.place().expected(what, self.text)
    }

    /// Its words, parted by blanks.
    pub(super) fn words(self) -> impl Iterator<Item = Self> {
        let mut rest = self;
        core::iter::from_fn(move || {
            let length = rest.text.find([' ', '\t']).unwrap_or(rest.text.len());
            let word = Self { text: &rest.text[..length], ..rest };
            rest = Self::new(rest.line, rest.number, rest.at + length);
            (length > 0).then_some(word)
        })
    }

    /// Its words, if there are exactly `N`.
    pub(super) fn exactly<const N: usize>(self, what: &'static str) -> Result<[Self; N], ParseError> {
        let mut found = [self; N];
        let mut words = self.words();
        for place in &mut found {
            *place = words.next().ok_or_else(|| self.expected(what))?;
        }
        match words.next() {
            None => Ok(found),
            Some(_) => Err(self.expected(what)),
        }
    }

    /// A point such as `3,-4`.
    pub(super) fn point(self) -> Result<Point, ParseError> {
        let (x, y) = self.text.split_once(',').ok_or_else(|| self.expected(POINT))?;
        Ok(Point::new(self.coordinate(x)?, self.coordinate(y)?))
    }

    fn coordinate(self, digits: &str) -> Result<i32, ParseError> {
        let (negative, digits) = match digits.strip_prefix('-') {
            Some(digits) => (true, digits),
            None => (false, digits),
        };
        if digits.is_empty() || !digits.bytes().all(|byte| byte.is_ascii_digit()) {
            return Err(self.expected(POINT));
        }
        let far = || self.place().error(Problem::Bounds(BoundsError::TooFar));
        let size: i32 = digits.parse().ok().filter(|&size| size <= MAX_COORDINATE).ok_or_else(far)?;
        Ok(if negative { -size } else { size })
    }

    /// `N`, `E`, `S` or `W`.
    pub(super) fn heading(self) -> Result<Heading, ParseError> {
        self.text.parse().map_err(|()| self.expected("a heading (N, E, S or W)"))
    }

    /// A length such as `19.5`.
    pub(super) fn millimetres(self) -> Result<f64, ParseError> {
        millimetres(self.text).ok_or_else(|| self.expected("a length in millimetres such as 180 or 19.5"))
    }
}

const POINT: &str = "a point such as 3,4";
