//! A whole stop: where the bot is, what it does, and why.

use super::said::Said;
use super::{Narration, Tone};
use crate::event::Seen;
use crate::explorer::book::Case;
use crate::geometry::{Turn, Ways};
use crate::trace::{Frame, State, Step, Trace};

/// Ways that are named where many are unvisited.
const NAMED: usize = 4;

/// Rows that are looked through for them, so that a large table costs no more than a small one.
const SCANNED: u32 = 128;

/// The bot at the start.
pub(super) fn start() -> Narration {
    let said =
        Said::default().text("The bot stands at the start and faces its ").strong("north (0)").text(". ");
    let said = said.text("The node table is empty, so ").code("ptr").text(" is 1. ");
    let said = said.text("It will follow the line to the first node, corner or dead end.");
    let short =
        Said::default().text("At the start, facing ").strong("north (0)").text(". The node table is empty.");
    told_as("START", Tone::Info, said, short, "Book §2.2, §3.1")
}

/// A stop of a run.
pub(super) fn told(trace: &Trace, frame: &Frame, step: Step, before: &State) -> Narration {
    match step.case() {
        Case::Finish => finish(before.ptr - 1),
        Case::Start => exhausted(),
        Case::DeadEnd => dead_end(step),
        Case::Corner => corner(step, before),
        Case::New => new_node(trace, frame, step, before),
        Case::Known => known(trace, frame, step),
        Case::KnownBack => known_back(step),
        Case::UnknownUturn => unknown_uturn(trace, frame, step),
        Case::UnknownBack => unknown_back(step, before),
        Case::TableFull => super::end::table_full(before.ptr - 1),
    }
}

fn told_as(case: &'static str, tone: Tone, said: Said, short: Said, section: &'static str) -> Narration {
    Narration { case, tone, said: said.done(), short: short.done(), section }
}

fn finish(nodes: u32) -> Narration {
    let said = Said::default().text("The bot stands on the ").strong("finish").text(" and stops. ");
    let short = Said::default().strong("Finish reached").text(".");
    let (said, short) = match nodes {
        0 => (said.text("It remembers no node: the way here asks for no decision."), short),
        _ => {
            let said = said.text("What it remembers is the way here: ").nodes(1, nodes).text(", so ");
            let said = said.code("ptr").text(" is ").number(i64::from(nodes) + 1);
            let said = said.text(". Round 2 leaves ").text(if nodes == 1 { "it" } else { "each" });
            let said = said.text(" by the way last chosen.");
            (said, short.text(" The way here: ").nodes(1, nodes).text("."))
        }
    };
    told_as("FINISH", Tone::Go, said, short, "Book §3.1, §3.2")
}

fn exhausted() -> Narration {
    let said = Said::default().text("The bot is back at the start and remembers no node. It drove ");
    let said = said.strong("every line").text(" that it can reach, and none led to a finish. ");
    let said = said.text("Join a finish to these lines, then run again.");
    let short =
        Said::default().text("Back at the start: ").strong("every line").text(" driven, no finish found.");
    told_as("NO FINISH REACHABLE", Tone::Bad, said, short, "Not in the book")
}

fn dead_end(step: Step) -> Narration {
    let said = Said::default().text("The line ends here, so the bot ").turn(Turn::Back, step.departure());
    let said = said.text(". This way does not lead to the finish: ").code("returning").text(" is true, ");
    let said = said.text("and what it drives now is crossed out.");
    let short = Said::default().text("The line ends: the bot ").strong("turns round").text(", returning.");
    told_as("DEAD END", Tone::Now, said, short, "Book §2.5")
}

fn corner(step: Step, before: &State) -> Narration {
    let turn = step.turn().unwrap_or(Turn::Straight);
    let straight = step.sighting().seen() == Seen::Straight;
    let case = if straight { "STRAIGHT" } else { "CORNER" };
    let said = Said::default().text("There is only one way on, so there is nothing to decide: the bot ");
    let said = said.turn(turn, step.departure()).text(".");
    let said =
        if before.returning { said.text(" It is still returning and crosses this line out.") } else { said };
    let short = Said::default().text("Only one way on: the bot ").turn(turn, step.departure()).text(".");
    told_as(case, Tone::Info, said, short, "Book §2.2.2, §2.4.1")
}

fn new_node(trace: &Trace, frame: &Frame, step: Step, before: &State) -> Narration {
    let m = step.node();
    let said = if before.returning {
        let said = Said::default().text("The bot is returning, yet this place matches no remembered node: ");
        said.text("its coordinates must be off. It becomes ").node(m).text(". ")
    } else {
        let said = Said::default().text("This place matches no remembered node, so it becomes ").node(m);
        said.text(", with its back path to the ").heading(step.arrival().opposite()).text(". ")
    };
    let said = chosen(said, trace, frame, step);
    let short = Said::default().text("A new place becomes ").node(m).text(": the bot ");
    let short = short.turn(step.turn().unwrap_or(Turn::Straight), step.departure()).text(".");
    told_as("NEW NODE", Tone::Now, said, short, "Book §2.4.2, §3.1")
}

fn known(trace: &Trace, frame: &Frame, step: Step) -> Narration {
    let m = step.node();
    let said = Said::default().text("The bot is back at ").node(m).text(", returning: the path to the ");
    let said = said.heading(step.arrival().opposite()).text(" is given up. ");
    let said = chosen(said, trace, frame, step);
    let short = Said::default().text("Back at ").node(m).text(": the bot ");
    let short =
        short.turn(step.turn().unwrap_or(Turn::Straight), step.departure()).text(", an unvisited path.");
    told_as("RETURN-KNOWN", Tone::Now, said, short, "Book §2.4.3, §2.5, §3.1")
}

/// What `choose_path()` did, and why.
fn chosen(said: Said, trace: &Trace, frame: &Frame, step: Step) -> Said {
    let turn = step.turn().unwrap_or(Turn::Straight);
    let said = said.text("The bot ").turn(turn, step.departure());
    let left = trace.row(frame.moment, step.node()).map_or(Ways::NONE, |row| row.node.unvisited());
    if left.is_empty() {
        said.text(": its only unvisited path, so ").code("returning").text(" is false again.")
    } else {
        said.text(": of the unvisited paths, the first in its preference order.")
    }
}

fn known_back(step: Step) -> Narration {
    let (m, turn) = (step.node(), step.turn().unwrap_or(Turn::Straight));
    let said = Said::default()
        .text("The bot is back at ")
        .node(m)
        .text(", returning, and all its paths are visited. ");
    let said = said.text("It ").turn(turn, step.departure()).text(", which is the back path, and ");
    let said =
        said.strong("forgets").text(" ").node(m).text(": ").code("ptr").text(" is ").number(i64::from(m));
    let said = said.text(".");
    let short =
        Said::default().text("Nothing left at ").node(m).text(": the bot takes the ").strong("back path");
    let short = short.text(", ").heading(step.departure()).text(".");
    told_as("RETURN-KNOWN", Tone::Now, said, short, "Book §2.4.3, §2.5, §3.1")
}

fn unknown_uturn(trace: &Trace, frame: &Frame, step: Step) -> Narration {
    let (m, last) = (step.node(), frame.state.ptr - 1);
    let said = Said::default().text("The bot met ").node(m).text(" again by a path it had never taken. ");
    let said = if m == last {
        said.text("It still has an unvisited path")
    } else {
        let said = said.text("Among nodes ").number(m.into()).text(" to ").number(last.into());
        said.text(", paths are still unvisited")
    };
    let said = unvisited(said, trace, frame, m);
    let said = said.text(", so it ").turn(Turn::Back, step.departure()).text(", and crosses this path out.");
    let short =
        Said::default().text("At ").node(m).text(" again, by a new path. Other paths are still unvisited, ");
    let short = short.text("so the bot ").strong("turns round").text(".");
    told_as("RETURN-UNKNOWN", Tone::Now, said, short, "Book §2.4.3, §2.5, §3.1")
}

/// “ (2·E, 3·S, 5·N, 6·N and more)”, as far as a short look finds them.
fn unvisited(mut said: Said, trace: &Trace, frame: &Frame, m: u32) -> Said {
    let rows = (m..frame.state.ptr).take(SCANNED as usize);
    let open = rows.filter_map(|m| Some((m, trace.row(frame.moment, m)?.node.unvisited())));
    let mut ways = open.flat_map(|(m, ways)| ways.iter().map(move |way| (m, way)));
    let Some((node, way)) = ways.next() else {
        return said;
    };
    said = said.text(" (").way(node, way);
    for (node, way) in ways.by_ref().take(NAMED - 1) {
        said = said.text(", ").way(node, way);
    }
    let whole = frame.state.ptr - m <= SCANNED;
    said.text(if whole && ways.next().is_none() { ")" } else { " and more)" })
}

fn unknown_back(step: Step, before: &State) -> Narration {
    let (m, last) = (step.node(), before.ptr - 1);
    let turn = step.turn().unwrap_or(Turn::Straight);
    let said =
        Said::default().text("The bot met ").node(m).text(" again by a path it had never taken. No path of ");
    let said = said.nodes(m, last).text(" is unvisited, so this loop is ").strong("forgotten");
    let said = said.text(". It ").turn(turn, step.departure()).text(": the back path, so ");
    let said = said.code("returning").text(" is true.");
    let short =
        Said::default().text("At ").node(m).text(" again, by a new path. Nothing is left in this loop: ");
    let short =
        short.text("the bot takes the ").strong("back path").text(", ").heading(step.departure()).text(".");
    told_as("RETURN-UNKNOWN", Tone::Now, said, short, "Book §2.4.3, §2.6, §3.1")
}
