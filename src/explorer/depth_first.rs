//! Depth first: the plain search of textbooks as a robot has to drive it, for comparison with the others.
//!
//! | name | meaning |
//! |---|---|
//! | node | known again by its coordinates |
//! | `first entry` | the way by which a node was reached first; the start has none |
//! | `used` | the ways of a node that were driven, in or out |
//! | `way` | the nodes from the start to here |

use alloc::string::{String, ToString};
use alloc::vec::Vec;

use super::mind::{Plan, Robot};
use super::places::{Places, Reckoning};
use super::taste::Taste;
use super::tell::{Said, many};
use crate::event::{Decision, Finish, Home, Look, Outcome};
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
pub struct DepthFirst {
    here: Reckoning,
    places: Places,
    nodes: Vec<Node>,
    way: Vec<u32>,
    taste: Taste,
    node: u32,
}

impl DepthFirst {
    /// A robot that knows nothing yet; `epsilon` in milliseconds.
    #[must_use]
    pub fn new(order: Order, epsilon: u32) -> Self {
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
    pub fn nodes(&self) -> &[Node] {
        &self.nodes
    }

    /// A node's coordinates, in milliseconds.
    #[must_use]
    pub fn coordinates(&self, node: u32) -> (i32, i32) {
        self.places.coordinates(node)
    }

    /// The nodes from the start to here.
    #[must_use]
    pub fn way(&self) -> &[u32] {
        &self.way
    }

    /// The node that the robot came to last.
    #[must_use]
    pub const fn node(&self) -> u32 {
        self.node
    }

    fn at_node(&mut self, look: Look, said: &mut Said) -> Option<Turn> {
        let ways = look.sighting.ways.out_of_frame_of(self.here.heading);
        let arrival = self.here.heading.opposite();
        said.ran(line::NEW);
        let Some(node) = self.places.find(self.here.x, self.here.y) else {
            self.node = self.places.push(self.here.x, self.here.y);
            let entry = (look.home != Home::PutDown).then_some(arrival);
            let used = entry.map_or(Ways::NONE, |way| Ways::NONE.with(way));
            self.nodes.push(Node { entry, ways, used, exit: arrival });
            self.way.push(self.node);
            said.is(if entry.is_some() { case::NEW } else { case::START });
            return self.explore(said);
        };
        self.node = node;
        said.ran(line::LOOP);
        let known = &mut self.nodes[node as usize];
        if !known.used.has(arrival) {
            known.used = known.used.with(arrival);
            said.is(case::LOOP);
            return Some(Turn::Back);
        }
        said.ran(line::ELSE);
        said.is(case::NEXT);
        self.explore(said)
    }

    fn explore(&mut self, said: &mut Said) -> Option<Turn> {
        said.ran(line::UNUSED);
        let heading = self.here.heading;
        let node = &mut self.nodes[self.node as usize];
        let unused = node.ways.minus(node.used);
        let [a, b, c] = self.taste.order();
        let first = [a, b, c, Turn::Back].into_iter().find(|&turn| unused.has(heading.turned(turn)));
        if let Some(turn) = first {
            node.exit = heading.turned(turn);
            node.used = node.used.with(node.exit);
            return Some(turn);
        }
        said.ran(line::BACK);
        let Some(entry) = node.entry else {
            said.ran(line::NONE);
            return None;
        };
        self.way.pop();
        said.is(case::BACK);
        Some(heading.turn_to(entry))
    }

    fn choose(&mut self, look: Look, said: &mut Said) -> Option<Turn> {
        said.ran(line::HOME);
        if look.home == Home::Back && look.is_dead_end() {
            return None;
        }
        said.ran(line::DEAD);
        if look.is_dead_end() {
            said.is(case::DEAD);
            return Some(Turn::Back);
        }
        said.ran(line::CORNER);
        if look.is_choice() {
            return self.at_node(look, said);
        }
        said.is(if look.home == Home::PutDown { case::START } else { case::CORNER });
        Some(look.only_turn())
    }
}

impl Robot for DepthFirst {
    fn decide(&mut self, look: Look, said: &mut Said) -> Decision {
        self.here.drive(look.sighting.time_diff);
        said.ran(line::FINISH);
        if look.sighting.finish == Finish::Yes {
            said.is(case::FINISH);
            return Decision::End(Outcome::Finish);
        }
        let Some(turn) = self.choose(look, said) else {
            said.is(case::NONE);
            return Decision::End(Outcome::NoFinishReachable);
        };
        self.here.heading = self.here.heading.turned(turn);
        Decision::Go(turn)
    }

    fn fact(&self, key: &str, out: &mut String) {
        out.push_str(&match key {
            "way" => many(self.way.len(), "node"),
            _ => (self.node + 1).to_string(),
        });
    }

    fn peak_bytes(&self) -> u32 {
        // Two ints of coordinates, a byte each of first entry and used ways.
        6 * self.nodes.len() as u32
    }

    fn host_bytes(&self) -> usize {
        self.places.bytes() + 4 * (self.nodes.len() + self.way.len())
    }

    fn node(&self, look: Look) -> Option<u32> {
        look.is_choice().then_some(self.node + 1)
    }

    fn plan(&self) -> Option<Plan> {
        let turn = |&node: &u32| {
            let Node { entry, exit, .. } = self.nodes[node as usize];
            entry.map_or(Heading::North, Heading::opposite).turn_to(exit)
        };
        Some(Plan::Letters(self.way.iter().map(turn).collect()))
    }
}
