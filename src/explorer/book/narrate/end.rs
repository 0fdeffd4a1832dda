//! Ends that are the bot's own failure: what went wrong, and one cure.

use super::said::Said;
use super::{Narration, Tone};
use crate::event::Outcome;
use crate::explorer::book::Case;
use crate::trace::Step;

/// The bot lost its way: it turned where there is no line, or drives on and on.
pub(super) fn lost(outcome: Outcome, step: Option<Step>) -> Narration {
    let (said, short) = match outcome {
        Outcome::NoLine { node, heading } => {
            let said = Said::default().text("The bot ");
            let said = if node == 0 {
                said.strong("turned").text(" to the ").heading(heading)
            } else {
                let way = match step.map(Step::case) {
                    Some(Case::KnownBack | Case::UnknownBack) => " for its back path, to the ",
                    _ => " for an unvisited path, to the ",
                };
                said.text("took this place for ")
                    .node(node)
                    .text(" and ")
                    .strong("turned")
                    .text(way)
                    .heading(heading)
            };
            let said =
                said.text(", but there is ").strong("no line").text(". Its coordinates mix up two places: ");
            let said = said.text("try an ").code("epsilon").text(" of half a cell.");
            let short = Said::default().strong("Lost");
            let short = if node == 0 { short } else { short.text(" at ").node(node) };
            (said, short.text(": there is no line ").heading(heading).text("."))
        }
        Outcome::Finish
        | Outcome::Mapped
        | Outcome::Circling { .. }
        | Outcome::Stuck
        | Outcome::PathFull { .. }
        | Outcome::NoFinishReachable
        | Outcome::TableFull { .. }
        | Outcome::TooManyStops { .. }
        | Outcome::Cut(_) => {
            let stops = if let Outcome::TooManyStops { limit } = outcome { i64::from(limit) } else { 0 };
            let said =
                Said::default().text("After ").number(stops).text(" stops the bot ").strong("still drives");
            let said = said
                .text(", longer than any exploration of this maze needs. It does not know its places again, or mixes them up: ");
            let said = said.text("try an ").code("epsilon").text(" of half a cell.");
            let short =
                Said::default().strong("Lost").text(": still driving after ").number(stops).text(" stops.");
            (said, short)
        }
    };
    Narration {
        case: "LOST",
        tone: Tone::Bad,
        said: said.done(),
        short: short.done(),
        section: "Book §2.4.3",
    }
}

/// One node more than the table holds.
pub(super) fn table_full(capacity: u32) -> Narration {
    let places = i64::from(capacity);
    let said = Said::default()
        .text("This node is new, but all ")
        .number(places)
        .text(" places of the node table are ");
    let said = said.strong("taken").text(": the bot gives up. Set ").code("NODE_MAX").text(" higher; ");
    let said = said.text("where the maze has fewer nodes than that, ").code("epsilon").text(" is too small.");
    let short =
        Said::default().text("A new node, but the table of ").number(places).text(" is full: the bot ");
    let short = short.strong("gives up").text(".");
    Narration {
        case: "TABLE FULL",
        tone: Tone::Bad,
        said: said.done(),
        short: short.done(),
        section: "Book §2.4.2",
    }
}
