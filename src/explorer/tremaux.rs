//! Trémaux's rule (Édouard Lucas, *Récréations mathématiques*, 1882): chalk marks on the ways of each node, one for
//! every time that a way is used there. It drives as depth first does, without knowing more than the marks.
//!
//! | name | meaning |
//! |---|---|
//! | `marks[d]` | how often the way in direction `d` was used at this node: 0, 1 or 2 |
//! | one mark | the ways of the route, when the finish is found |
//! | two marks | never again |

use alloc::string::{String, ToString};

use super::book::errata::{Erratum, Place};
use super::mind::{Plan, Robot};
use super::node_search::{self, AtNodes, Heads, Searched, heads};
use super::tell::Tell;
use crate::event::{Decision, Home, Look};
use crate::geometry::{Heading, Turn, Ways};
use crate::settings::Order;

listing! {
    ACT    "every stop:"
    FINISH "  if finish:                          stop      # ways with one mark are the route"
    HOME lab "  else if the start, a dead end:      stop      # nothing is left"
    DEAD   "  else if dead end:                   turn round"
    CORNER "  else if corner:                     turn the only way there is"
    NODE   "  else: one mark more for the way behind"
    LOOP   "    if there were other marks, and it now has one:  turn round, one mark more"
    NONE lab "    else take the first way of the order without a mark, one mark more"
    ONE    "    if there is none: the way with one mark, one mark more"
    STOP lab "    if there is none (at the start): stop"
}

cases! {
    START "start" Info Plain "The robot stands at the start and looks all round: it *{turn}*."
    CORNER "corner" Info Plain "There is only one way on, so there is nothing to decide: the robot *{turn}*."
    NEW "new-node" Now Node "By its coordinates this node is new: no way here has a mark but the one behind, which gets its first. The robot *{turn}*, into a way without a mark: {marks}."
    LOOP "loop" Now Unknown "By its coordinates the robot was here before, but the way behind had no mark: a *loop*. The robot turns round, so that way has two marks: {marks}."
    NEXT "next-way" Now Known "The way behind has another mark now. The robot *{turn}*, into a way without a mark: {marks}."
    BACK "back" Now Known "No way here is without a mark. The robot takes the one with a *single mark*, which then has two: {marks}."
    DEAD "dead-end" Now DeadEnd "The line ends: the robot *turns round*."
    NONE "no-finish" Bad End "The robot is back at the start, and every way that it marked has two marks: it drove *every line*, and none led to a finish."
    FINISH "finish" Go End "The robot stands on the *finish*. At the nodes from the start to here, the ways with *one mark* are the route."
}

/// What the rule leaves open.
pub static ERRATA: &[Erratum] = &[
    Erratum::open(
        "Lucas 1882",
        "How a node is known again",
        "A wanderer sees the marks. A line robot cannot leave any, so the lab’s keeps them in a table and finds a node by its coordinates.",
        &[Place::Told(case::LOOP)],
    ),
    Erratum::open(
        "Lucas 1882",
        "Which way first",
        "The rule leaves the choice among unmarked ways to the wanderer. The lab’s robot takes the first of its preference order.",
        &[Place::Told(case::START)],
    ),
];

/// A node as the chalk shows it.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Node {
    /// Its ways, in the robot's own frame.
    pub ways: Ways,
    /// Marks on the ways N, E, S, W of the robot's own frame.
    pub marks: [u8; 4],
}

/// A robot with a piece of chalk. On its way, it keeps the nodes along the ways with one mark, and the heading with
/// which each is come to: what a walk along them would find.
#[derive(Clone, Debug)]
pub struct Tremaux(Searched<Node, (u32, Heading)>);

impl Tremaux {
    /// A robot that has marked nothing yet; `epsilon` in milliseconds.
    #[must_use]
    pub fn new(order: Order, epsilon: u32) -> Self {
        Self(Searched::new(order, epsilon))
    }

    /// What it remembers.
    #[must_use]
    pub const fn memory(&self) -> &Searched<Node, (u32, Heading)> {
        &self.0
    }

    /// Marks a way of the node that the robot stands on; how many marks it has now.
    fn mark(&mut self, way: Heading) -> u8 {
        let marks = &mut self.0.nodes[self.0.node as usize].marks[usize::from(way.index())];
        *marks += 1;
        *marks
    }

    /// Turns into the first way of the order that has so many marks, and marks it.
    fn take(&mut self, order: [Turn; 4], marks: u8) -> Option<Turn> {
        let (node, heading) = (self.0.nodes[self.0.node as usize], self.0.here.heading);
        let turn = order.into_iter().find(|&turn| {
            let way = heading.turned(turn);
            node.ways.has(way) && node.marks[usize::from(way.index())] == marks
        })?;
        self.mark(heading.turned(turn));
        Some(self.0.turn(turn))
    }

    /// The turn at a node of the route that is entered with this heading: into its other way with one mark.
    fn turn(&self, node: u32, heading: Heading) -> Turn {
        let marks = self.0.nodes[node as usize].marks;
        let single = |turn: &Turn| marks[usize::from(heading.turned(*turn).index())] == 1;
        [Turn::Straight, Turn::Right, Turn::Left].into_iter().find(single).unwrap_or(Turn::Back)
    }
}

impl AtNodes for Tremaux {
    const HEADS: Heads = heads!();

    type Node = Node;
    type OnWay = (u32, Heading);

    fn searched(&mut self) -> &mut Searched<Node, (u32, Heading)> {
        &mut self.0
    }

    fn at_node(&mut self, look: Look, tell: &mut impl Tell<Self>) -> Option<Turn> {
        let heading = self.0.here.heading;
        let known = self.0.known();
        match known {
            Some(node) => self.0.node = node,
            None => {
                let ways = look.sighting.ways.out_of_frame_of(heading);
                self.0.record(Node { ways, marks: [0; 4] }, |node| (node, heading));
            }
        }
        if look.home == Home::PutDown {
            tell.is(case::START);
            tell.did(line::NODE, self);
        } else {
            let marks = self.mark(heading.opposite());
            tell.did(line::NODE, self);
            if known.is_some() && marks == 1 {
                self.mark(heading.opposite());
                self.0.turn(Turn::Back);
                tell.is(case::LOOP);
                tell.did(line::LOOP, self);
                return Some(Turn::Back);
            }
            tell.is(if known.is_some() { case::NEXT } else { case::NEW });
            tell.no(line::LOOP, self);
        }
        let order = self.0.order();
        if let Some(turn) = self.take(order, 0) {
            tell.did(line::NONE, self);
            return Some(turn);
        }
        tell.none(line::NONE, self);
        let Some(turn) = self.take(order, 1) else {
            tell.none(line::ONE, self);
            tell.is(case::NONE);
            tell.did(line::STOP, self);
            return None;
        };
        self.0.way.pop();
        tell.is(case::BACK);
        tell.did(line::ONE, self);
        Some(turn)
    }
}

impl Robot for Tremaux {
    fn decide(&mut self, look: Look, tell: &mut impl Tell<Self>) -> Decision {
        node_search::decide(self, look, tell)
    }

    fn fact(&self, _: &str, out: &mut String) {
        let Some(node) = self.0.nodes.get(self.0.node as usize) else { return };
        for (i, way) in node.ways.iter().enumerate() {
            out.push_str(if i > 0 { ", " } else { "" });
            out.push_str(way.word());
            out.push(' ');
            out.push_str(&node.marks[usize::from(way.index())].to_string());
        }
    }

    fn peak_bytes(&self) -> u32 {
        // Two ints of coordinates and four bytes of marks.
        8 * self.0.nodes.len() as u32
    }

    fn host_bytes(&self) -> usize {
        self.0.bytes()
    }

    fn node(&self, look: Look) -> Option<u32> {
        look.is_choice().then_some(self.0.node + 1)
    }

    fn plan(&self) -> Option<Plan> {
        Some(Plan::Letters(self.0.way.iter().map(|&(node, heading)| self.turn(node, heading)).collect()))
    }
}
