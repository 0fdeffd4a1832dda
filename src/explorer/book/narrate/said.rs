//! A sentence in the making: pieces, one after the other, and the words for ways and turns.

use alloc::borrow::Cow;
use alloc::string::ToString;
use alloc::vec::Vec;

use super::Span;
use crate::geometry::{Heading, Turn, Ways};

/// A sentence in the making.
#[derive(Default)]
pub(in crate::explorer) struct Said(Vec<Span>);

/// A direction with the book's number.
pub(in crate::explorer) const fn numbered(heading: Heading) -> &'static str {
    match heading {
        Heading::North => "north (0)",
        Heading::East => "east (1)",
        Heading::South => "south (2)",
        Heading::West => "west (3)",
    }
}

/// What the bot does.
pub(in crate::explorer) const fn act(turn: Turn) -> &'static str {
    match turn {
        Turn::Straight => "drives straight on",
        Turn::Right => "turns right",
        Turn::Back => "turns round",
        Turn::Left => "turns left",
    }
}

/// The ways on that are seen at a stop; `ways` relative to the bot.
pub(in crate::explorer) const fn sight(ways: Ways) -> &'static str {
    match (ways.has(Heading::West), ways.has(Heading::North), ways.has(Heading::East)) {
        (false, false, false) => "no way on",
        (true, false, false) => "a way to the left",
        (false, true, false) => "a way ahead",
        (false, false, true) => "a way to the right",
        (true, true, false) => "ways to the left and ahead",
        (true, false, true) => "ways to the left and to the right",
        (false, true, true) => "ways ahead and to the right",
        (true, true, true) => "ways to the left, ahead and to the right",
    }
}

impl Said {
    pub(in crate::explorer) fn text(mut self, text: &'static str) -> Self {
        self.0.push(Span::Text(Cow::Borrowed(text)));
        self
    }

    pub(in crate::explorer) fn strong(mut self, text: &'static str) -> Self {
        self.0.push(Span::Strong(Cow::Borrowed(text)));
        self
    }

    pub(in crate::explorer) fn code(mut self, text: &'static str) -> Self {
        self.0.push(Span::Code(Cow::Borrowed(text)));
        self
    }

    pub(in crate::explorer) fn number(mut self, number: i64) -> Self {
        self.0.push(Span::Text(Cow::Owned(number.to_string())));
        self
    }

    pub(in crate::explorer) fn node(mut self, m: u32) -> Self {
        self.0.push(Span::Node(m));
        self
    }

    pub(in crate::explorer) fn way(mut self, node: u32, heading: Heading) -> Self {
        self.0.push(Span::Way { node, heading });
        self
    }

    pub(in crate::explorer) fn heading(self, heading: Heading) -> Self {
        self.text(numbered(heading))
    }

    /// “**turns left**, to the west (3)”
    pub(in crate::explorer) fn turn(self, turn: Turn, to: Heading) -> Self {
        self.strong(act(turn)).text(", to the ").heading(to)
    }

    /// “nodes 1 to 6”, or “node 3” where there is one only.
    pub(in crate::explorer) fn nodes(self, first: u32, last: u32) -> Self {
        if first == last {
            return self.node(first);
        }
        self.text("nodes ").number(i64::from(first)).text(" to ").number(i64::from(last))
    }

    pub(in crate::explorer) fn done(self) -> Vec<Span> {
        self.0
    }
}
