//! A row of the node table at any moment of a trace.

use alloc::vec::Vec;

use super::{Moment, State, Trace, script};
use crate::explorer::book::store::Node;
use crate::explorer::book::{Case, Event};
use crate::geometry::{Heading, Ways};

/// A remembered node, as the table shows it.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Row {
    /// Its number: the place in the table.
    pub number: u32,
    /// The stop at which it was recorded.
    pub met: u32,
    /// What is remembered.
    pub node: Node,
    /// The ways that were tried and given up.
    pub crossed: Ways,
}

/// How sure it is that a place is the node that the bot took it for.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Recognition {
    /// The coordinates agree.
    Exact,
    /// They are nearer than `epsilon`: it may be another place.
    Near,
}

/// What the bot knows of one way of a node.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum WayState {
    /// There is no line.
    None,
    /// Not taken yet.
    Unvisited,
    /// On the remembered path, or the way back.
    Visited,
    /// Visited, and found not to lead to the finish.
    Crossed,
}

impl Row {
    /// What is known of one way.
    #[must_use]
    pub const fn way(&self, heading: Heading) -> WayState {
        if !self.node.paths.has(heading) {
            WayState::None
        } else if self.crossed.has(heading) {
            WayState::Crossed
        } else if self.node.vpaths.has(heading) {
            WayState::Visited
        } else {
            WayState::Unvisited
        }
    }
}

impl Trace {
    /// Node `m` of the table at a moment; none where the table has no such node then.
    #[must_use]
    pub fn row(&self, moment: Moment, m: u32) -> Option<Row> {
        let frame = self.frame(moment);
        let moment = frame.moment;
        let whole = moment.lines == frame.lines;
        let settled = if whole { moment.stop } else { moment.stop - 1 };
        let mut kept = self.settled(settled, m);
        // In the middle of a stop, the lines that have run count on top of the stops before.
        if let Some(step) = self.step(moment.stop).filter(|_| !whole) {
            let events = script::events(step, &self.state(settled));
            for event in script::until_line(&events, moment.lines) {
                match *event {
                    Event::Recorded(at) if at == m => kept = self.recorded(moment.stop),
                    Event::Visited(at, way) if at == m => {
                        kept = kept.map(|(met, node)| {
                            // RETURN-UNKNOWN marks the arrival path, which is no choice.
                            let chosen = matches!(step.case(), Case::New | Case::Known);
                            let last_path = if chosen { Some(way) } else { node.last_path };
                            (met, Node { vpaths: node.vpaths.with(way), last_path, ..node })
                        });
                    }
                    _ => {}
                }
            }
        }
        let (met, node) = kept.filter(|_| m > 0 && m < frame.state.ptr)?;
        let top = m + 1 == frame.state.ptr;
        // While returning, the bot is on the way that it last took from the newest node.
        let on_path = node.last_path.filter(|_| !(top && frame.state.returning));
        let good: Ways = [node.back_path].into_iter().chain(on_path).collect();
        let crossed = if node.last_path.is_some() { node.vpaths.minus(good) } else { Ways::NONE };
        Some(Row { number: m, met, node, crossed: Ways::from_bits(crossed.bits() & node.paths.bits()) })
    }

    /// The nodes from `m` up that have unvisited ways at a moment, with those ways.
    pub fn unvisited(&self, moment: Moment, m: u32) -> impl Iterator<Item = (u32, Ways)> {
        let ptr = self.frame(moment).state.ptr;
        (m.max(1)..ptr).filter_map(move |m| {
            let unvisited = self.row(moment, m)?.node.unvisited();
            (!unvisited.is_empty()).then_some((m, unvisited))
        })
    }

    /// Whether a node was recorded by the end of a stop.
    #[must_use]
    pub fn recorded_by(&self, stop: u32) -> bool {
        // The first node of all is recorded at place 1.
        !self.visits.until(&self.steps, 1, stop).is_empty()
    }

    /// Whether a node is recorded at place 1 after a stop: where the table is empty, the next that is recorded at all.
    #[must_use]
    pub fn records_after(&self, stop: u32) -> bool {
        self.visits.until(&self.steps, 1, u32::MAX).last().is_some_and(|&visit| visit > stop)
    }

    /// How a node that was known at a stop came to be known there; none where the stop was no known node.
    #[must_use]
    pub fn recognition(&self, stop: u32) -> Option<Recognition> {
        let step = self.step(stop).filter(|step| step.node() > 0 && step.case() != Case::New)?;
        let (node, here) = (self.settled(stop - 1, step.node())?.1, self.state(stop));
        Some(if (node.x_cor, node.y_cor) == (here.cur_x, here.cur_y) {
            Recognition::Exact
        } else {
            Recognition::Near
        })
    }

    /// Whether up to a stop the bot took every known place for what it is: coordinates agreed to the millisecond, and
    /// none was new while the bot was returning. Looks at every stop once.
    #[must_use]
    pub fn knew_its_places(&self, stop: u32) -> bool {
        let mut nodes: Vec<(i32, i32)> = Vec::new();
        let mut state = State::default();
        for &step in self.steps().iter().take(stop as usize) {
            let returning = state.returning;
            state.advance(step, &self.pauses);
            let here = (state.cur_x, state.cur_y);
            let before = (step.node() as usize).checked_sub(1);
            let sound = match (step.case(), before) {
                (Case::New, Some(before)) => {
                    nodes.truncate(before);
                    nodes.push(here);
                    !returning
                }
                (Case::Start, _) => here == (0, 0),
                (_, Some(before)) => nodes.get(before) == Some(&here),
                (_, None) => true,
            };
            if !sound {
                return false;
            }
        }
        true
    }

    /// A stop, and the node as `record_node()` made it there.
    fn recorded(&self, stop: u32) -> Option<(u32, Node)> {
        let (step, state) = (self.step(stop)?, self.state(stop));
        let paths = step.sighting().ways.out_of_frame_of(step.arrival());
        Some((stop, Node::new(state.cur_x, state.cur_y, paths, step.arrival().opposite())))
    }

    /// What was last remembered at place `m` when a stop was over, forgotten or not, and since which stop.
    fn settled(&self, stop: u32, m: u32) -> Option<(u32, Node)> {
        let visits = self.visits.until(&self.steps, m, stop);
        let case = |visit: u32| self.step(visit).map(|step| step.case());
        let new = visits.iter().rposition(|&visit| case(visit) == Some(Case::New))?;
        let (met, mut node) = self.recorded(visits[new])?;
        for step in visits[new..].iter().filter_map(|&visit| self.step(visit)) {
            match step.case() {
                Case::New | Case::Known => {
                    node.vpaths = node.vpaths.with(step.departure());
                    node.last_path = Some(step.departure());
                }
                Case::UnknownUturn | Case::UnknownBack => {
                    node.vpaths = node.vpaths.with(step.arrival().opposite());
                }
                Case::Finish
                | Case::Start
                | Case::DeadEnd
                | Case::Corner
                | Case::KnownBack
                | Case::TableFull => {}
            }
        }
        Some((met, node))
    }
}
