//! What the comparison says: how a run ended in a word or two, and what a robot does at a stop.

use alloc::format;
use alloc::string::String;

use crate::event::Outcome;
use crate::explorer::book::narrate::narrate;
use crate::playback::Timeline;
use crate::run::AnyRun;
use crate::trace::Moment;

/// How a run ended, as a shape shows it.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum End {
    /// On the finish.
    Finish,
    /// All is mapped.
    Mapped,
    /// Round and round.
    Circling,
    /// In any other way that is no success.
    Failed,
}

impl End {
    /// That of an outcome.
    #[must_use]
    pub const fn of(outcome: Outcome) -> Self {
        match outcome {
            Outcome::Finish => Self::Finish,
            Outcome::Mapped => Self::Mapped,
            Outcome::Circling { .. } => Self::Circling,
            Outcome::NoFinishReachable
            | Outcome::Stuck
            | Outcome::PathFull { .. }
            | Outcome::TableFull { .. }
            | Outcome::NoLine { .. }
            | Outcome::TooManyStops { .. }
            | Outcome::Cut(_) => Self::Failed,
        }
    }

    /// Its name in the style sheet.
    #[must_use]
    pub const fn class(self) -> &'static str {
        match self {
            Self::Finish => "finish",
            Self::Mapped => "mapped",
            Self::Circling => "circling",
            Self::Failed => "failed",
        }
    }
}

/// How a run ended, in a word or two.
///
/// ```
/// use line_maze_lab::compare::words::ended;
/// use line_maze_lab::event::Outcome;
/// assert_eq!(ended(Outcome::Circling { first: 1, again: 34 }), "circling, stops 1 and 34");
/// ```
#[must_use]
pub fn ended(outcome: Outcome) -> String {
    String::from(match outcome {
        Outcome::Circling { first, again } => return format!("circling, stops {first} and {again}"),
        Outcome::NoFinishReachable => "no way there",
        Outcome::Finish
        | Outcome::Mapped
        | Outcome::Stuck
        | Outcome::PathFull { .. }
        | Outcome::TableFull { .. }
        | Outcome::NoLine { .. }
        | Outcome::TooManyStops { .. }
        | Outcome::Cut(_) => outcome.shown(),
    })
}

/// What a robot did at a stop, in a sentence; how the run ended at its last.
///
/// ```
/// use line_maze_lab::compare::words::said;
/// use line_maze_lab::explorer::name::Name;
/// use line_maze_lab::{maze::samples, run::record, settings::Settings};
/// let (maze, settings) = (samples::figure_3_1(), Settings::default());
/// for &name in Name::ALL {
///     let run = record(&maze, &settings, name)?;
///     assert!(said(&run, 1).ends_with(['.', '!', '?']), "{name}: {}", said(&run, 1));
/// }
/// # Ok::<(), line_maze_lab::world::CannotStart>(())
/// ```
#[must_use]
pub fn said(run: &AnyRun, stop: u32) -> String {
    let stop = stop.min(run.stops());
    match run {
        AnyRun::Book(book) => narrate(book.trace(), &book.trace().frame(Moment::after(stop))).short_text(),
        AnyRun::Other(run) => run.narrate(&run.at(stop)).short_text(),
    }
}

/// A text that may stand in markup.
#[must_use]
pub fn escaped(text: &str) -> String {
    let mut safe = String::with_capacity(text.len());
    for letter in text.chars() {
        match letter {
            '&' => safe.push_str("&amp;"),
            '<' => safe.push_str("&lt;"),
            '>' => safe.push_str("&gt;"),
            '"' => safe.push_str("&quot;"),
            '\'' => safe.push_str("&#39;"),
            other => safe.push(other),
        }
    }
    safe
}

/// A number for people: whole, or with so many digits.
#[must_use]
pub fn figure(number: Option<f64>, digits: usize) -> String {
    number.map_or_else(|| String::from("–"), |number| format!("{number:.digits$}"))
}
