//! What just happened, in one or two plain sentences: a whole stop, or the line of the pseudo-code that ran.
//!
//! Directions are the bot's own and carry the book's numbers. The preference order is not told by a trace and
//! need not be: the way that was chosen came first in it, among those that were unvisited.

use alloc::borrow::Cow;
use alloc::string::{String, ToString};
use alloc::vec::Vec;

use crate::event::Outcome;
use crate::geometry::Heading;
use crate::trace::{Frame, Trace};

pub mod empty;
mod end;
mod line;
pub(in crate::explorer) mod said;
mod stop;

/// The ground on which the case is shown.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Tone {
    /// The bot decides.
    Now,
    /// It is done.
    Go,
    /// It failed.
    Bad,
    /// Nothing to decide.
    Info,
}

/// A piece of a sentence.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Span {
    /// Plain.
    Text(Cow<'static, str>),
    /// What matters: mostly what the bot does.
    Strong(Cow<'static, str>),
    /// A name or value of the pseudo-code.
    Code(Cow<'static, str>),
    /// A node, shown as “node 3”: a link to its row of the table.
    Node(u32),
    /// A way of a node, shown as “2·E”.
    Way {
        /// The node.
        node: u32,
        /// The way, in the bot's frame.
        heading: Heading,
    },
}

/// What is told of a moment.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Narration {
    /// The badge: the case of a whole stop, or the function that runs in the middle of one.
    pub case: &'static str,
    /// The badge's ground.
    pub tone: Tone,
    /// One or two sentences, at most 45 words.
    pub said: Vec<Span>,
    /// Shorter, for the projector.
    pub short: Vec<Span>,
    /// Where the book tells of it.
    pub section: &'static str,
}

impl Narration {
    /// The sentences as they are read aloud.
    #[must_use]
    pub fn text(&self) -> String {
        spoken(&self.said)
    }

    /// The projector's sentence as it is read aloud.
    #[must_use]
    pub fn short_text(&self) -> String {
        spoken(&self.short)
    }
}

/// Pieces of a sentence as they are read aloud: “2·E” is “2 east”.
#[must_use]
pub fn spoken(spans: &[Span]) -> String {
    let mut text = String::new();
    for span in spans {
        match span {
            Span::Text(piece) | Span::Strong(piece) | Span::Code(piece) => text.push_str(piece),
            Span::Node(node) => {
                text.push_str("node ");
                text.push_str(&node.to_string());
            }
            Span::Way { node, heading } => {
                text.push_str(&node.to_string());
                text.push(' ');
                text.push_str(heading.word());
            }
        }
    }
    text
}

/// Tells of a moment of a trace.
///
/// ```
/// use line_maze_lab::explorer::book::narrate::narrate;
/// use line_maze_lab::event::{Finish, Outcome, Sighting};
/// use line_maze_lab::explorer::book::{Case, Event};
/// use line_maze_lab::geometry::{Turn, Ways};
/// use line_maze_lab::settings::Pace;
/// use line_maze_lab::trace::{Moment, Recorder};
///
/// let mut recorder = Recorder::new(Pace::default());
/// recorder.hear(Event::Case(Case::DeadEnd));
/// let ways = Ways::from_bits(0b0100);
/// recorder.stop(Sighting { ways, finish: Finish::No, time_diff: 400 }, Some(Turn::Back));
/// let trace = recorder.finish(Outcome::TooManyStops { limit: 2 });
/// let told = narrate(&trace, &trace.frame(Moment::after(0)));
/// assert_eq!(told.case, "START");
/// ```
#[must_use]
pub fn narrate(trace: &Trace, frame: &Frame) -> Narration {
    let before = trace.state(frame.moment.stop.saturating_sub(1));
    match (frame.outcome, trace.step(frame.moment.stop)) {
        (Some(outcome @ (Outcome::NoLine { .. } | Outcome::TooManyStops { .. })), step) => {
            end::lost(outcome, step)
        }
        (_, None) => stop::start(),
        (_, Some(step)) if frame.moment.lines < frame.lines => line::told(frame, step, &before),
        (Some(Outcome::TableFull { capacity }), Some(_)) => end::table_full(capacity),
        (_, Some(step)) => stop::told(trace, frame, step, &before),
    }
}
