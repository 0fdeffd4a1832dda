//! Numbers as options take them: blanks around them are no matter, and a message says what is possible.

use std::ops::RangeInclusive;

use clap::builder::{StringValueParser, TypedValueParser};
use line_maze_lab::settings::{PaceError, limits};

/// A whole number in a range.
pub(super) fn whole<N>(range: RangeInclusive<N>) -> impl TypedValueParser<Value = N>
where
    N: Copy + Ord + std::str::FromStr + std::fmt::Display + Send + Sync + 'static,
{
    StringValueParser::new().try_map(move |text| {
        let number = text.trim().parse().ok().filter(|number| range.contains(number));
        number.ok_or_else(|| format!("a whole number from {} to {} is wanted", range.start(), range.end()))
    })
}

/// What chance begins with.
pub(super) fn seed() -> impl TypedValueParser<Value = u64> {
    whole(0..=u64::MAX)
}

/// Millimetres a second.
pub(super) fn speed(text: &str) -> Result<f64, PaceError> {
    text.trim().parse().map_err(|_| PaceError::Speed).and_then(limits::speed)
}

/// Seconds.
pub(super) fn seconds(text: &str) -> Result<f64, PaceError> {
    text.trim().parse().map_err(|_| PaceError::Seconds).and_then(limits::seconds)
}
