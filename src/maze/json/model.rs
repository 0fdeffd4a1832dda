//! What serde reads: the keys and types of a maze in JSON, and the words for what was expected.

use alloc::string::String;
use alloc::vec::Vec;
use core::fmt;
use core::marker::PhantomData;

use serde::Deserialize;
use serde::de::{Deserializer, Error, IgnoredAny, SeqAccess, Visitor};

use crate::geometry::Heading;
use crate::maze::Kind;

/// The value of `format`.
pub(super) const FORMAT: &str = "line-maze/1";

/// The whole object.
#[derive(Deserialize)]
#[serde(deny_unknown_fields, expecting = "a maze (an object in braces)")]
pub(super) struct Document {
    pub(super) format: String,
    #[serde(default)]
    pub(super) title: String,
    #[serde(default)]
    pub(super) source: String,
    #[serde(default)]
    pub(super) note: String,
    pub(super) kind: KindJson,
    pub(super) cell_mm: Number,
    pub(super) line_mm: Number,
    #[serde(default)]
    pub(super) bounds: Option<Corners>,
    /// Null where there is none, but it has to be said.
    #[serde(deserialize_with = "Option::deserialize")]
    pub(super) start: Option<StartJson>,
    pub(super) finish: Vec<PointJson>,
    pub(super) lines: Vec<Vec<PointJson>>,
}

/// Where the robot starts.
#[derive(Deserialize)]
#[serde(deny_unknown_fields, expecting = "a start such as {\"at\": [0, 0], \"heading\": \"N\"}, or null")]
pub(super) struct StartJson {
    pub(super) at: PointJson,
    pub(super) heading: HeadingJson,
}

#[derive(Clone, Copy, Deserialize)]
#[serde(rename_all = "lowercase", expecting = "\"line\" or \"wall\"")]
pub(super) enum KindJson {
    Line,
    Wall,
}

#[derive(Clone, Copy, Deserialize)]
#[serde(expecting = "\"N\", \"E\", \"S\" or \"W\"")]
pub(super) enum HeadingJson {
    N,
    E,
    S,
    W,
}

/// South-west and north-east corner.
pub(super) type Corners = Pair<PointJson>;

/// x to the east, y to the north.
pub(super) type PointJson = Pair<Whole>;

/// A list of exactly two.
#[derive(Clone, Copy)]
pub(super) struct Pair<T>(pub(super) T, pub(super) T);

/// What two of a kind are together.
pub(super) trait Paired {
    const EXPECTED: &'static str;
}

impl Paired for PointJson {
    const EXPECTED: &'static str = "a pair of points, the south-west and the north-east corner,";
}

impl Paired for Whole {
    const EXPECTED: &'static str = "a point (two whole numbers such as [3, 4])";
}

/// A whole number of any size.
#[derive(Clone, Copy)]
pub(super) struct Whole(pub(super) i64);

/// Any number.
#[derive(Clone, Copy)]
pub(super) struct Number(pub(super) f64);

impl From<KindJson> for Kind {
    fn from(kind: KindJson) -> Self {
        match kind {
            KindJson::Line => Self::Line,
            KindJson::Wall => Self::Wall,
        }
    }
}

impl From<HeadingJson> for Heading {
    fn from(heading: HeadingJson) -> Self {
        match heading {
            HeadingJson::N => Self::North,
            HeadingJson::E => Self::East,
            HeadingJson::S => Self::South,
            HeadingJson::W => Self::West,
        }
    }
}

impl<'de, T: Paired + Deserialize<'de>> Deserialize<'de> for Pair<T> {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        struct Wanted<T>(PhantomData<T>);
        impl<'de, T: Paired + Deserialize<'de>> Visitor<'de> for Wanted<T> {
            type Value = Pair<T>;

            fn expecting(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
                f.write_str(T::EXPECTED)
            }

            fn visit_seq<A: SeqAccess<'de>>(self, mut items: A) -> Result<Pair<T>, A::Error> {
                let first = items.next_element()?.ok_or_else(|| Error::invalid_length(0, &self))?;
                let second = items.next_element()?.ok_or_else(|| Error::invalid_length(1, &self))?;
                match items.next_element::<IgnoredAny>()? {
                    None => Ok(Pair(first, second)),
                    Some(_) => Err(Error::invalid_length(3, &self)),
                }
            }
        }
        deserializer.deserialize_seq(Wanted(PhantomData))
    }
}

impl<'de> Deserialize<'de> for Whole {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        struct Wanted;
        impl Visitor<'_> for Wanted {
            type Value = Whole;

            fn expecting(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
                f.write_str("a whole number")
            }

            fn visit_i64<E: Error>(self, value: i64) -> Result<Whole, E> {
                Ok(Whole(value))
            }

            fn visit_u64<E: Error>(self, value: u64) -> Result<Whole, E> {
                // Far beyond any lattice: the check of coordinates will say so.
                Ok(Whole(i64::try_from(value).unwrap_or(i64::MAX)))
            }
        }
        deserializer.deserialize_i64(Wanted)
    }
}

impl<'de> Deserialize<'de> for Number {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        struct Wanted;
        impl Visitor<'_> for Wanted {
            type Value = Number;

            fn expecting(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
                f.write_str("a number")
            }

            fn visit_i64<E: Error>(self, value: i64) -> Result<Number, E> {
                Ok(Number(value as f64))
            }

            fn visit_u64<E: Error>(self, value: u64) -> Result<Number, E> {
                Ok(Number(value as f64))
            }

            fn visit_f64<E: Error>(self, value: f64) -> Result<Number, E> {
                Ok(Number(value))
            }
        }
        deserializer.deserialize_f64(Wanted)
    }
}

/// A string as JSON writes it.
pub(super) fn quoted(text: &str) -> String {
    // Writing a string cannot fail.
    serde_json::to_string(text).unwrap_or_default()
}
