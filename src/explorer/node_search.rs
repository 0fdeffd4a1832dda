//! What depth first and Trémaux have in common: a line robot that knows its nodes again by their coordinates and
//! remembers the way to where it is, and the stops at which either has nothing to think about.

use alloc::vec::Vec;

use super::mind::Robot;
use super::places::{Places, Reckoning};
use super::taste::Taste;
use super::tell::Tell;
use crate::event::{Decision, Finish, Home, Look, Outcome};
use crate::geometry::{Heading, Turn};
use crate::settings::Order;

/// The memory; `N` is what is noted about a node, `W` a node on the way.
#[derive(Clone, Debug)]
pub struct Searched<N, W> {
    pub(super) here: Reckoning,
    pub(super) places: Places,
    pub(super) nodes: Vec<N>,
    /// The nodes from the start to here.
    pub(super) way: Vec<W>,
    pub(super) taste: Taste,
    /// The node that the robot came to last.
    pub(super) node: u32,
}

impl<N, W> Searched<N, W> {
    pub(super) fn new(order: Order, epsilon: u32) -> Self {
        Self {
            here: Reckoning::default(),
            places: Places::new(epsilon),
            nodes: Vec::new(),
            way: Vec::new(),
            taste: Taste::new(order),
            node: 0,
        }
    }

    /// The nodes, in the order in which they were met.
    #[must_use]
    pub fn nodes(&self) -> &[N] {
        &self.nodes
    }

    /// A node's coordinates, in milliseconds.
    #[must_use]
    pub fn coordinates(&self, node: u32) -> (i32, i32) {
        self.places.coordinates(node)
    }

    /// The way from the start to here.
    #[must_use]
    pub fn way(&self) -> &[W] {
        &self.way
    }

    /// The node that the robot came to last.
    #[must_use]
    pub const fn node(&self) -> u32 {
        self.node
    }

    /// The node that the robot stands on, if it knows it.
    pub(super) fn known(&self) -> Option<u32> {
        self.places.find(self.here.x, self.here.y)
    }

    /// Records the node that the robot stands on.
    pub(super) fn record(&mut self, node: N, on_way: impl FnOnce(u32) -> W) {
        self.nodes.push(node);
        self.node = self.places.push(self.here.x, self.here.y);
        self.way.push(on_way(self.node));
    }

    /// The next preference order: three ways on, then back.
    pub(super) fn order(&mut self) -> [Turn; 4] {
        let [a, b, c] = self.taste.order();
        [a, b, c, Turn::Back]
    }

    /// Turns.
    pub(super) const fn turn(&mut self, turn: Turn) -> Turn {
        self.here.heading = self.here.heading.turned(turn);
        turn
    }

    /// Turns to a way.
    pub(super) const fn face(&mut self, way: Heading) -> Turn {
        self.turn(self.here.heading.turn_to(way))
    }

    /// About how many bytes a copy takes.
    pub(super) fn bytes(&self) -> usize {
        self.places.bytes() + size_of::<N>() * self.nodes.len() + size_of::<W>() * self.way.len()
    }
}

/// A line of the listing, and the case that it decides.
#[derive(Clone, Copy)]
pub(super) struct Head {
    pub(super) line: u8,
    pub(super) case: u8,
}

/// The lines before those about a node, in their order.
#[derive(Clone, Copy)]
pub(super) struct Heads {
    pub(super) finish: Head,
    pub(super) home: Head,
    pub(super) dead_end: Head,
    pub(super) corner: Head,
    /// The case of a corner where the robot was put down.
    pub(super) start: u8,
}

/// The heads of a listing that has these names.
macro_rules! heads {
    () => {
        $crate::explorer::node_search::Heads {
            finish: $crate::explorer::node_search::Head { line: line::FINISH, case: case::FINISH },
            home: $crate::explorer::node_search::Head { line: line::HOME, case: case::NONE },
            dead_end: $crate::explorer::node_search::Head { line: line::DEAD, case: case::DEAD },
            corner: $crate::explorer::node_search::Head { line: line::CORNER, case: case::CORNER },
            start: case::START,
        }
    };
}
pub(super) use heads;

/// A robot that decides at nodes.
pub(super) trait AtNodes: Robot + Sized {
    /// Its lines and cases.
    const HEADS: Heads;

    /// What it notes about a node.
    type Node;
    /// What it keeps of a node on the way.
    type OnWay;

    /// Its memory.
    fn searched(&mut self) -> &mut Searched<Self::Node, Self::OnWay>;

    /// Decides at a node, and turns; nothing where no way is left.
    fn at_node(&mut self, look: Look, tell: &mut impl Tell<Self>) -> Option<Turn>;
}

/// Decides at a stop.
pub(super) fn decide<M: AtNodes>(mind: &mut M, look: Look, tell: &mut impl Tell<M>) -> Decision {
    let Heads { finish, home, dead_end, corner, start } = M::HEADS;
    mind.searched().here.drive(look.sighting.time_diff);
    if look.sighting.finish == Finish::Yes {
        tell.is(finish.case);
        tell.did(finish.line, mind);
        return Decision::End(Outcome::Finish);
    }
    tell.no(finish.line, mind);
    if look.home == Home::Back && look.is_dead_end() {
        tell.is(home.case);
        tell.did(home.line, mind);
        return Decision::End(Outcome::NoFinishReachable);
    }
    tell.no(home.line, mind);
    if look.is_dead_end() {
        mind.searched().turn(Turn::Back);
        tell.is(dead_end.case);
        tell.did(dead_end.line, mind);
        return Decision::Go(Turn::Back);
    }
    tell.no(dead_end.line, mind);
    if !look.is_choice() {
        let turn = mind.searched().turn(look.only_turn());
        tell.is(if look.home == Home::PutDown { start } else { corner.case });
        tell.did(corner.line, mind);
        return Decision::Go(turn);
    }
    tell.no(corner.line, mind);
    mind.at_node(look, tell).map_or(Decision::End(Outcome::NoFinishReachable), Decision::Go)
}
