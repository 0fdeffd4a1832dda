//! The line of the pseudo-code that just ran, in the middle of a stop: what it did, or how its test came out.

use super::said::{Said, act, sight};
use super::{Narration, Tone};
use crate::explorer::book::code::Line;
use crate::geometry::{Heading, Turn};
use crate::trace::{Frame, State, Step};

/// Tells of the line; `before` is the bot's state when it drove to this stop.
pub(super) fn told(frame: &Frame, step: Step, before: &State) -> Narration {
    let line = frame.ran.unwrap_or(Line::GET);
    let (said, section) = match line {
        Line::MATCH | Line::IF_NEW | Line::IF_RETURNING | Line::ELSE_UNKNOWN => {
            (known(line, frame), "Book §2.4.3")
        }
        Line::RECORD | Line::CHOOSE_NEW => (new(line, frame, step), "Book §2.4.2, §3.1"),
        Line::KNOWN_PTR | Line::KNOWN_CHOOSE => (returning(line, frame), "Book §2.5, §3.1"),
        Line::MARK_ARRIVAL | Line::IF_UNVISITED | Line::ELSE_LOOP | Line::LOOP_PTR | Line::LOOP_CHOOSE => {
            (closed_loop(line, frame, step, before), "Book §2.6, §3.1")
        }
        Line::FIRST | Line::NONE_LEFT | Line::BACK => (way_out(line, frame, step), "Book §3.1"),
        Line::EXHAUSTED => (place(line, frame, step), "Not in the book"),
        _ => (place(line, frame, step), "Book §2.3, §2.4.1"),
    };
    let said = said.done();
    Narration { case: function(line), tone: Tone::Info, short: said.clone(), said, section }
}

/// The function that a line belongs to.
fn function(line: Line) -> &'static str {
    if line < Line::NODE_FN {
        "act()"
    } else if line < Line::CHOOSE_FN {
        "node()"
    } else if line < Line::RETURN_FN {
        "choose_path()"
    } else {
        "take_return_path()"
    }
}

/// Lines 2 to 6: what kind of place this is.
fn place(line: Line, frame: &Frame, step: Step) -> Said {
    let said = Said::default();
    match line {
        Line::GET => {
            let state = &frame.state;
            let (name, value) = match step.arrival() {
                Heading::North | Heading::South => ("cur_y", state.cur_y),
                Heading::East | Heading::West => ("cur_x", state.cur_x),
            };
            let said = said.text("The bot drove ").number(step.time_diff().into()).text(" ms to the ");
            let said =
                said.heading(step.arrival()).text(", so ").code("get_coords()").text(" sets ").code(name);
            let said = said.text(" to ").number(value.into()).text(". ").code("get_paths()").text(" sees ");
            said.text(sight(step.sighting().ways)).text(".")
        }
        Line::FINISH => said.text("Not the finish."),
        Line::EXHAUSTED => {
            said.text("A node is remembered, or this place does not match the start, so the search goes on.")
        }
        Line::DEAD_END => said.text("There is a way on, so this is no dead end."),
        Line::CORNER => said.text("More than one way leads on, so this is no corner."),
        _ => {
            let ways = step.sighting().ways.count();
            let said = said.number(ways.into()).text(" ways meet here, so this is a node, and ");
            said.code("node()").text(" decides.")
        }
    }
}

/// Lines 9, 10, 13 and 16: which node this is, and which case.
fn known(line: Line, frame: &Frame) -> Said {
    let (said, m) = (Said::default(), frame.node);
    match line {
        Line::MATCH if m == 0 => {
            let said = said.code("match_cur_node()").text(" finds no remembered node near ");
            let said = said.number(frame.state.cur_x.into()).text(", ").number(frame.state.cur_y.into());
            said.text(", so ").code("m").text(" is 0.")
        }
        Line::MATCH => {
            let said = said
                .code("match_cur_node()")
                .text(" finds ")
                .node(m)
                .text(" nearer than ")
                .code("epsilon")
                .text(", so ");
            said.code("m").text(" is ").number(m.into()).text(".")
        }
        Line::IF_NEW if m == 0 => said.code("m").text(" is 0, so this node is new."),
        Line::IF_NEW => {
            said.code("m").text(" is ").number(m.into()).text(", so the bot knows this node already.")
        }
        Line::IF_RETURNING if frame.state.returning => {
            said.code("returning").text(" is true, so this is the ").strong("RETURN-KNOWN").text(" case.")
        }
        Line::IF_RETURNING => {
            said.code("returning").text(" is false, so this is the ").strong("RETURN-UNKNOWN").text(" case.")
        }
        _ => {
            said.text("The bot is not returning, so the path that led it to ").node(m).text(" counts as new.")
        }
    }
}

/// Lines 11 and 12: a new node.
fn new(line: Line, frame: &Frame, step: Step) -> Said {
    let said = Said::default();
    if line == Line::RECORD {
        let said =
            said.code("record_node()").text(" writes ").node(frame.node).text(" into the table: back path ");
        let said = said.heading(step.arrival().opposite()).text(", which counts as visited. ");
        return said.code("ptr").text(" becomes ").number(frame.state.ptr.into()).text(".");
    }
    said.text("Now ").code("choose_path()").text(" looks for the way out of ").node(frame.node).text(".")
}

/// Lines 14 and 15: RETURN-KNOWN.
fn returning(line: Line, frame: &Frame) -> Said {
    let m = frame.node;
    if line == Line::KNOWN_PTR {
        return pointer(frame);
    }
    let said = Said::default().code("choose_path()").text(" looks for an unvisited path of ").node(m);
    said.text("; if there is none, the bot takes its back path.")
}

/// `ptr = m + 1`: what it forgets.
fn pointer(frame: &Frame) -> Said {
    let (said, m, ptr) = (Said::default(), frame.node, frame.state.ptr);
    let said = said.code("ptr");
    if frame.before.ptr == ptr {
        let said = said.text(" is ").number(ptr.into()).text(" already: ").node(m);
        return said.text(" is the newest, and nothing is forgotten.");
    }
    let said = said.text(" drops to ").number(ptr.into()).text(": the nodes after ").node(m);
    said.text(" are ").strong("forgotten").text(".")
}

/// Lines 17 to 21: RETURN-UNKNOWN.
fn closed_loop(line: Line, frame: &Frame, step: Step, before: &State) -> Said {
    let (said, m) = (Said::default(), frame.node);
    match line {
        Line::MARK_ARRIVAL => {
            let said = said.text("The bot came along the path to the ").heading(step.arrival().opposite());
            said.text(" of ").node(m).text(", so that path is visited now.")
        }
        Line::IF_UNVISITED => {
            let said = said.text("No path of ").nodes(m, before.ptr - 1).text(" is unvisited, so there is ");
            said.text("nothing to turn round for.")
        }
        Line::ELSE_LOOP => said.text("The loop that was just closed can be forgotten."),
        Line::LOOP_PTR => pointer(frame),
        _ => {
            let said = said.text("The check covered ").node(m).text(" too, so ").code("choose_path()");
            said.text(" finds nothing here, and the bot takes the back path.")
        }
    }
}

/// Lines 24, 25 and 29: the way out.
fn way_out(line: Line, frame: &Frame, step: Step) -> Said {
    let (said, m) = (Said::default(), frame.node);
    match line {
        Line::FIRST if frame.next == Some(Line::NONE_LEFT) => {
            said.text("Every path of ").node(m).text(" is visited: there is none to choose.")
        }
        Line::FIRST => {
            let way = match step.turn().unwrap_or(Turn::Straight) {
                Turn::Straight => "Straight on",
                Turn::Right => "To the right",
                Turn::Back => "Back",
                Turn::Left => "To the left",
            };
            let said = said
                .text(way)
                .text(" is the first of the preference order that exists and is unvisited, so ");
            said.code("d").text(" is ").heading(step.departure()).text(".")
        }
        Line::NONE_LEFT => said.text("There is none, so ").code("choose_path()").text(" returns false."),
        _ => {
            let turn = step.turn().unwrap_or(Turn::Straight);
            let said =
                said.text("The bot ").strong(act(turn)).text(" for the back path of ").node(m).text(", ");
            said.heading(step.departure()).text(", and ").code("returning").text(" is true.")
        }
    }
}
