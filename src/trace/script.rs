//! A stop's events, told again from its step: what the explorer emitted when it ran. A test holds the two
//! equal over random mazes, so a trace needs to keep no event.

use alloc::vec::Vec;

use super::{State, Step};
use crate::explorer::book::code::Line;
use crate::explorer::book::{Case, Event};
use crate::geometry::Turn;

/// Everything that the explorer did at a stop, in order; `before` is its state when it drove off there.
#[must_use]
pub fn events(step: Step, before: &State) -> Vec<Event> {
    let mut told = Vec::with_capacity(24);
    told.extend([Event::Ran(Line::GET), Event::Coordinates, Event::Ran(Line::FINISH)]);
    let case = step.case();
    if case == Case::Finish {
        told.push(Event::Case(case));
        return told;
    }
    told.push(Event::Ran(Line::EXHAUSTED));
    if case == Case::Start {
        told.push(Event::Case(case));
        return told;
    }
    told.push(Event::Ran(Line::DEAD_END));
    if case == Case::DeadEnd {
        told.push(Event::Case(case));
        uturn(&mut told);
        return told;
    }
    told.push(Event::Ran(Line::CORNER));
    if case == Case::Corner {
        told.push(Event::Case(case));
        told.extend(step.turn().map(Event::Turned));
        return told;
    }
    told.push(Event::Ran(Line::NODE));
    node(step, before, &mut told);
    told
}

fn node(step: Step, before: &State, told: &mut Vec<Event>) {
    let (m, case) = (step.node(), step.case());
    told.push(Event::Ran(Line::MATCH));
    let new = matches!(case, Case::New | Case::TableFull);
    told.extend([Event::Matched(if new { 0 } else { m }), Event::Ran(Line::IF_NEW)]);
    if new {
        told.push(Event::Ran(Line::RECORD));
        if case == Case::TableFull {
            told.push(Event::Case(case));
            return;
        }
        told.extend([Event::Recorded(m), Event::Ptr(m + 1), Event::Ran(Line::CHOOSE_NEW), Event::Case(case)]);
        return choose(step, told);
    }
    told.push(Event::Ran(Line::IF_RETURNING));
    if before.returning {
        told.extend([Event::Ran(Line::KNOWN_PTR), Event::Ptr(m + 1), Event::Ran(Line::KNOWN_CHOOSE)]);
        if case == Case::Known {
            choose(step, told);
            told.push(Event::Case(case));
        } else {
            told.extend([Event::Ran(Line::FIRST), Event::Ran(Line::NONE_LEFT), Event::Case(case)]);
            take_return_path(step, told);
        }
        return;
    }
    told.extend([Event::Ran(Line::ELSE_UNKNOWN), Event::Ran(Line::MARK_ARRIVAL)]);
    told.extend([Event::Visited(m, step.arrival().opposite()), Event::Ran(Line::IF_UNVISITED)]);
    if case == Case::UnknownUturn {
        told.push(Event::Case(case));
        return uturn(told);
    }
    told.extend([Event::Ran(Line::ELSE_LOOP), Event::Ran(Line::LOOP_PTR), Event::Ptr(m + 1)]);
    told.extend([Event::Ran(Line::LOOP_CHOOSE), Event::Case(case)]);
    told.extend([Event::Ran(Line::FIRST), Event::Ran(Line::NONE_LEFT)]);
    take_return_path(step, told);
}

fn uturn(told: &mut Vec<Event>) {
    told.extend([Event::Turned(Turn::Back), Event::Returning(true)]);
}

fn choose(step: Step, told: &mut Vec<Event>) {
    told.extend([Event::Ran(Line::FIRST), Event::Ran(Line::TAKE)]);
    told.extend([Event::Visited(step.node(), step.departure()), Event::Returning(false)]);
    told.extend(step.turn().map(Event::Turned));
}

fn take_return_path(step: Step, told: &mut Vec<Event>) {
    told.push(Event::Ran(Line::BACK));
    told.extend(step.turn().map(Event::Turned));
    told.extend([Event::Returning(true), Event::Ran(Line::FORGET), Event::Ptr(step.node())]);
}

/// How many lines run.
pub(super) fn lines(events: &[Event]) -> u8 {
    events.iter().filter(|event| matches!(event, Event::Ran(_))).count() as u8
}

/// The `nth` line that runs, from 1.
pub(super) fn line(events: &[Event], nth: u8) -> Option<Line> {
    let ran = |event: &Event| if let Event::Ran(line) = event { Some(*line) } else { None };
    events.iter().filter_map(ran).nth((nth as usize).checked_sub(1)?)
}

/// The events of the first `count` lines.
pub(super) fn until_line(events: &[Event], count: u8) -> &[Event] {
    let next = events.iter().enumerate().filter(|(_, event)| matches!(event, Event::Ran(_)));
    let end = next.map(|(index, _)| index).nth(count as usize).unwrap_or(events.len());
    &events[..end]
}
