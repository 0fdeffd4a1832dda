//! A whole stop: where the bot is, what it does, and why.

use super::said::Said;
use super::{Narration, Tone};
use crate::event::Seen;
use crate::explorer::book::Case;
use crate::geometry::{Turn, Ways};
use crate::trace::{Frame, Recognition, State, Step, Trace};

/// Ways that are named where many are unvisited.
const NAMED: usize = 4;

/// Rows that are looked through for them, so that a large table costs no more than a small one.
const SCANNED: u32 = 128;

/// The bot at the start.
pub(super) fn start() -> Narration {
    let said =
        Said::default().text("The bot stands at the start and faces its ").strong("north (0)").text(". ");
    let said = said.text("The node table is empty, so ").code("ptr").text(" is 1. ");
    let said =
        said.text("It will follow the line to its first stop: a node, a corner, a dead end or the finish.");
    let short =
        Said::default().text("At the start, facing ").strong("north (0)").text(". The node table is empty.");
    told_as("START", Tone::Info, said, short, "Book §2.2, §3.1")
}

/// A stop of a run.
pub(super) fn told(trace: &Trace, frame: &Frame, step: Step, before: &State) -> Narration {
    match step.case() {
        Case::Finish => finish(trace, before.ptr - 1),
        Case::Start => exhausted(trace),
        Case::DeadEnd => dead_end(step),
        Case::Corner => corner(step, before),
        Case::New => new_node(trace, frame, step, before),
        Case::Known => known(trace, frame, step),
        Case::KnownBack => known_back(trace, frame, step),
        Case::UnknownUturn => unknown_uturn(trace, frame, step),
        Case::UnknownBack => unknown_back(trace, frame, step, before),
        Case::TableFull => super::end::table_full(before.ptr - 1),
    }
}

fn told_as(case: &'static str, tone: Tone, said: Said, short: Said, section: &'static str) -> Narration {
    Narration { case, tone, said: said.done(), short: short.done(), section }
}

/// “The bot is back at node 4”, or what it takes the place for.
fn back_at(trace: &Trace, frame: &Frame, m: u32) -> Said {
    match trace.recognition(frame.moment.stop) {
        Some(Recognition::Near) => Said::default().text("The bot takes this place for ").node(m),
        Some(Recognition::Exact) | None => Said::default().text("The bot is back at ").node(m),
    }
}

/// “The bot met node 1 again by a path it had never taken.”
fn met_again(trace: &Trace, frame: &Frame, m: u32) -> Said {
    let stop = frame.moment.stop;
    let said = match trace.recognition(stop) {
        Some(Recognition::Near) => Said::default().text("The bot takes this place for ").node(m),
        Some(Recognition::Exact) | None => Said::default().text("The bot met ").node(m).text(" again"),
    };
    said.text(if trace.knew_its_places(stop) {
        " by a path it had never taken. "
    } else {
        " and was not returning. "
    })
}

/// The same for the projector.
fn again(trace: &Trace, frame: &Frame, m: u32) -> Said {
    let said = match trace.recognition(frame.moment.stop) {
        Some(Recognition::Near) => Said::default().text("Taken for ").node(m),
        Some(Recognition::Exact) | None => Said::default().text("At ").node(m).text(" again"),
    };
    said.text(if trace.knew_its_places(frame.moment.stop) {
        ", by a new path. "
    } else {
        ", not returning. "
    })
}

fn finish(trace: &Trace, nodes: u32) -> Narration {
    let said = Said::default().text("The bot stands on the ").strong("finish").text(" and stops. ");
    let short = Said::default().strong("Finish reached").text(".");
    let (said, short) = match nodes {
        0 => (said.text("It remembers no node: the way here asks for no decision."), short),
        _ => {
            let sure = trace.knew_its_places(trace.stops());
            let said =
                said.text(if sure { "What it remembers is" } else { "By its coordinates it remembers" });
            let said = said.text(" the way here: ").nodes(1, nodes).text(", so ");
            let said = said.code("ptr").text(" is ").number(i64::from(nodes) + 1);
            if sure {
                let said = said.text(". Round 2 leaves ").text(if nodes == 1 { "it" } else { "each" });
                let said = said.text(" by the way last chosen.");
                (said, short.text(" The way here: ").nodes(1, nodes).text("."))
            } else {
                let said = said.text(". They are not exact, so round 2 may go astray.");
                (said, short.text(" Remembered: ").nodes(1, nodes).text("."))
            }
        }
    };
    told_as("FINISH", Tone::Go, said, short, "Book §3.1, §3.2")
}

fn exhausted(trace: &Trace) -> Narration {
    if !trace.knew_its_places(trace.stops()) {
        return gave_up();
    }
    let said = Said::default().text("The bot is back at the start and remembers no node. It drove ");
    let said = said.strong("every line").text(" that it can reach, and none led to a finish. ");
    let said = said.text("Join a finish to these lines, then run again.");
    let short =
        Said::default().text("Back at the start: ").strong("every line").text(" driven, no finish found.");
    told_as("NO FINISH REACHABLE", Tone::Bad, said, short, "Not in the book")
}

/// It takes a place for the start, and may be wrong.
fn gave_up() -> Narration {
    let said = Said::default().text("The bot takes this place for the start, remembers no node, and ");
    let said =
        said.strong("gives up").text(". Its coordinates are not exact, so lines may be left that it never ");
    let said = said.text("drove: try an ").code("epsilon").text(" of half a cell.");
    let short =
        Said::default().text("Taken for the start, with no node left: the bot ").strong("gives up").text(".");
    told_as("GAVE UP", Tone::Bad, said, short, "Not in the book")
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
        said.text("its coordinates are off, or ")
            .code("epsilon")
            .text(" is too small. It becomes ")
            .node(m)
            .text(". ")
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
    let said = back_at(trace, frame, m).text(", returning: the path to the ");
    let said = said.heading(step.arrival().opposite()).text(" is given up. ");
    let said = chosen(said, trace, frame, step);
    let short = match trace.recognition(frame.moment.stop) {
        Some(Recognition::Near) => Said::default().text("Taken for ").node(m),
        Some(Recognition::Exact) | None => Said::default().text("Back at ").node(m),
    };
    let short = short.text(": the bot ");
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

fn known_back(trace: &Trace, frame: &Frame, step: Step) -> Narration {
    let (m, turn) = (step.node(), step.turn().unwrap_or(Turn::Straight));
    let said = back_at(trace, frame, m).text(", returning, and all its paths are visited. ");
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
    let said = met_again(trace, frame, m);
    let said = if m == last {
        said.text("It still has an unvisited path")
    } else {
        let said = said.text("Among nodes ").number(m.into()).text(" to ").number(last.into());
        said.text(", paths are still unvisited")
    };
    let said = unvisited(said, trace, frame, m);
    let said = said.text(", so it ").turn(Turn::Back, step.departure()).text(", and crosses this path out.");
    let short = again(trace, frame, m).text("Other paths are still unvisited, ");
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

fn unknown_back(trace: &Trace, frame: &Frame, step: Step, before: &State) -> Narration {
    let (m, last) = (step.node(), before.ptr - 1);
    let turn = step.turn().unwrap_or(Turn::Straight);
    let said = met_again(trace, frame, m)
        .text("No path of ")
        .nodes(m, last)
        .text(" is unvisited, so this loop is ")
        .strong("forgotten");
    let said = said.text(". It ").turn(turn, step.departure()).text(": the back path, so ");
    let said = said.code("returning").text(" is true.");
    let short = again(trace, frame, m).text("Nothing is left in this loop: ");
    let short =
        short.text("the bot takes the ").strong("back path").text(", ").heading(step.departure()).text(".");
    told_as("RETURN-UNKNOWN", Tone::Now, said, short, "Book §2.4.3, §2.6, §3.1")
}
