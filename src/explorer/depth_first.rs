//! Depth first: the plain search of textbooks as a robot has to drive it, for comparison with the others.
//!
//! | name | meaning |
//! |---|---|
//! | node | known again by its coordinates |
//! | `first entry` | the way by which a node was reached first; the start has none |
//! | `used` | the ways of a node that were driven, in or out |
//! | `way` | the nodes from the start to here |

use alloc::string::{String, ToString};

use super::mind::{Plan, Robot};
use super::node_search::{self, AtNodes, Heads, Searched, heads};
use super::tell::{Tell, many};
use crate::event::{Decision, Home, Look};
use crate::geometry::{Heading, Turn, Ways};
use crate::settings::Order;

listing! {
    ACT    "every stop:"
    FINISH "  if finish:                          stop"
    HOME   "  else if the start, a dead end:      stop      # nothing is left"
    DEAD   "  else if dead end:                   turn round"
    CORNER "  else if corner:                     turn the only way there is"
    NEW    "  else if the node is new:            note its first entry as used; explore()"
    LOOP   "  else if it came by an unused way:   note it as used; turn round"
    ELSE   "  else:                               explore()"
    GAP    ""
    FN     "explore():"
    UNUSED "  take the first unused way of the order and note it as used"
    BACK   "  if there is none: back by the first entry"
    NONE   "  if there is none (at the start): stop"
}

cases! {
    START "start" Info Plain "The robot stands at the start and looks all round: it *{turn}*."
    CORNER "corner" Info Plain "There is only one way on, so there is nothing to decide: the robot *{turn}*."
    NEW "new-node" Now Node "No node has these coordinates, so this place becomes node {node}, and the way behind is its first entry. The robot *{turn}*, the first unused way of its order."
    LOOP "loop" Now Unknown "By its coordinates this is node {node}, but the robot came by a way that it had never used: a *loop*. It notes that way as used and turns round."
    NEXT "next-way" Now Known "By its coordinates the robot is back at node {node}. It *{turn}*, the first way of its order that is still unused."
    BACK "back" Now Known "By its coordinates the robot is back at node {node}, and every way is used: it leaves by its *first entry*."
    DEAD "dead-end" Now DeadEnd "The line ends: the robot *turns round*."
    NONE "no-finish" Bad End "The robot is back at the start, and every way that it knows is used: it drove *every line*, and none led to a finish."
    FINISH "finish" Go End "The robot stands on the *finish*. The way here leads over {way}."
}

/// A node as depth first knows it; headings in the robot's own frame.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Node {
    /// The way by which it was reached first; none for the start.
    pub entry: Option<Heading>,
    /// Its ways.
    pub ways: Ways,
    /// Those that were driven, in or out.
    pub used: Ways,
    /// The way that it was left by last.
    pub exit: Heading,
}

/// A robot that searches depth first.
#[derive(Clone, Debug)]
pub struct DepthFirst(Searched<Node, u32>);

impl DepthFirst {
    /// A robot that knows nothing yet; `epsilon` in milliseconds.
    #[must_use]
    pub fn new(order: Order, epsilon: u32) -> Self {
        Self(Searched::new(order, epsilon))
    }

    /// What it remembers.
    #[must_use]
    pub const fn memory(&self) -> &Searched<Node, u32> {
        &self.0
    }

    fn explore(&mut self, tell: &mut impl Tell<Self>) -> Option<Turn> {
        let (order, heading) = (self.0.order(), self.0.here.heading);
        let node = &mut self.0.nodes[self.0.node as usize];
        let unused = node.ways.minus(node.used);
        if let Some(turn) = order.into_iter().find(|&turn| unused.has(heading.turned(turn))) {
            node.exit = heading.turned(turn);
            node.used = node.used.with(node.exit);
            self.0.turn(turn);
            tell.did(line::UNUSED, self);
            return Some(turn);
        }
        let entry = node.entry;
        tell.none(line::UNUSED, self);
        let Some(entry) = entry else {
            tell.none(line::BACK, self);
            tell.is(case::NONE);
            tell.did(line::NONE, self);
            return None;
        };
        self.0.way.pop();
        let turn = self.0.face(entry);
        tell.is(case::BACK);
        tell.did(line::BACK, self);
        Some(turn)
    }
}

impl AtNodes for DepthFirst {
    const HEADS: Heads = heads!();

    type Node = Node;
    type OnWay = u32;

    fn searched(&mut self) -> &mut Searched<Node, u32> {
        &mut self.0
    }

    fn at_node(&mut self, look: Look, tell: &mut impl Tell<Self>) -> Option<Turn> {
        let arrival = self.0.here.heading.opposite();
        let Some(node) = self.0.known() else {
            let ways = look.sighting.ways.out_of_frame_of(self.0.here.heading);
            let entry = (look.home != Home::PutDown).then_some(arrival);
            let used = entry.map_or(Ways::NONE, |way| Ways::NONE.with(way));
            self.0.record(Node { entry, ways, used, exit: arrival }, |node| node);
            tell.is(if entry.is_some() { case::NEW } else { case::START });
            tell.did(line::NEW, self);
            return self.explore(tell);
        };
        tell.no(line::NEW, self);
        let known = &mut self.0.nodes[node as usize];
        if !known.used.has(arrival) {
            known.used = known.used.with(arrival);
            self.0.node = node;
            self.0.turn(Turn::Back);
            tell.is(case::LOOP);
            tell.did(line::LOOP, self);
            return Some(Turn::Back);
        }
        tell.no(line::LOOP, self);
        self.0.node = node;
        tell.is(case::NEXT);
        tell.did(line::ELSE, self);
        self.explore(tell)
    }
}

impl Robot for DepthFirst {
    fn decide(&mut self, look: Look, tell: &mut impl Tell<Self>) -> Decision {
        node_search::decide(self, look, tell)
    }

    fn fact(&self, key: &str, out: &mut String) {
        out.push_str(&match key {
            "way" => many(self.0.way.len(), "node"),
            _ => (self.0.node + 1).to_string(),
        });
    }

    fn peak_bytes(&self) -> u32 {
        // Two ints of coordinates, a byte each of first entry and used ways.
        6 * self.0.nodes.len() as u32
    }

    fn host_bytes(&self) -> usize {
        self.0.bytes()
    }

    fn node(&self, look: Look) -> Option<u32> {
        look.is_choice().then_some(self.0.node + 1)
    }

    fn plan(&self) -> Option<Plan> {
        let turn = |&node: &u32| {
            let Node { entry, exit, .. } = self.0.nodes[node as usize];
            entry.map_or(Heading::North, Heading::opposite).turn_to(exit)
        };
        Some(Plan::Letters(self.0.way.iter().map(turn).collect()))
    }
}
