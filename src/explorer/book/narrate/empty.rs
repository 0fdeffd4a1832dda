//! What stands in the place of an empty node table: whether no node was met yet, or all were forgotten.

use crate::explorer::book::Case;
use crate::trace::{Frame, Trace};

/// Words for an empty table.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Empty {
    /// In a few words.
    pub title: &'static str,
    /// In a sentence or two.
    pub text: &'static str,
    /// Whether a stop that records a node follows.
    pub more: bool,
}

/// Tells why the table of a moment is empty.
#[must_use]
pub fn empty_table(trace: &Trace, frame: &Frame) -> Empty {
    let stop = frame.moment.stop;
    let whole = frame.moment.lines == frame.lines;
    let settled = if whole { stop } else { stop.saturating_sub(1) };
    let (met, more) = (trace.recorded_by(settled), trace.records_after(stop));
    let here = !whole && trace.step(stop).is_some_and(|step| step.case() == Case::New);
    let title = if met { "No node left" } else { "No node yet" };
    let text = match (met, more) {
        _ if here => "The bot stands on a place that has no row yet. Step on line by line.",
        (false, true) => "The bot has met no node. Step on to the first one.",
        (false, false) => "The bot has met no node so far.",
        (true, true) => "The bot has forgotten every node that it met. The next one gets place 1 again.",
        (true, false) => "The bot has forgotten every node that it met, so ptr is 1.",
    };
    Empty { title, text, more: more && !here }
}
