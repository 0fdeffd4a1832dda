//! Trémaux's rule (Édouard Lucas, *Récréations mathématiques*, 1882): chalk marks on the ways of each node, one for
//! every time that a way is used there. It drives as depth first does, without knowing more than the marks.
//!
//! | name | meaning |
//! |---|---|
//! | `marks[d]` | how often the way in direction `d` was used at this node: 0, 1 or 2 |
//! | one mark | the ways of the route, when the finish is found |
//! | two marks | never again |

use alloc::string::{String, ToString};
use alloc::vec::Vec;

use super::book::errata::{Erratum, Place};
use super::mind::{Plan, Robot};
use super::places::{Places, Reckoning};
use super::taste::Taste;
use super::tell::Said;
use crate::event::{Decision, Finish, Home, Look, Outcome};
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

/// A robot with a piece of chalk.
#[derive(Clone, Debug)]
pub struct Tremaux {
    here: Reckoning,
    places: Places,
    nodes: Vec<Node>,
    /// The nodes along the ways with one mark, and the heading with which each is come to: what a walk along
    /// them would find.
    way: Vec<(u32, Heading)>,
    taste: Taste,
    node: u32,
}

impl Tremaux {
    /// A robot that has marked nothing yet; `epsilon` in milliseconds.
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

    /// The node that the robot came to last.
    #[must_use]
    pub const fn node(&self) -> u32 {
        self.node
    }

    fn at_node(&mut self, look: Look, said: &mut Said) -> Option<Turn> {
        said.ran(line::NODE);
        let heading = self.here.heading;
        let known = self.places.find(self.here.x, self.here.y);
        self.node = known.unwrap_or_else(|| {
            let ways = look.sighting.ways.out_of_frame_of(heading);
            self.nodes.push(Node { ways, marks: [0; 4] });
            let node = self.places.push(self.here.x, self.here.y);
            self.way.push((node, heading));
            node
        });
        let node = &mut self.nodes[self.node as usize];
        if look.home == Home::PutDown {
            said.is(case::START);
        } else {
            let behind = &mut node.marks[usize::from(heading.opposite().index())];
            *behind += 1;
            said.ran(line::LOOP);
            if known.is_some() && *behind == 1 {
                *behind += 1;
                said.is(case::LOOP);
                return Some(Turn::Back);
            }
            said.is(if known.is_some() { case::NEXT } else { case::NEW });
        }
        said.ran(line::NONE);
        let [a, b, c] = self.taste.order();
        let order = [a, b, c, Turn::Back];
        let mut take = |marks: u8| {
            let turn = order.into_iter().find(|&turn| {
                let way = heading.turned(turn);
                node.ways.has(way) && node.marks[usize::from(way.index())] == marks
            })?;
            node.marks[usize::from(heading.turned(turn).index())] += 1;
            Some(turn)
        };
        if let Some(turn) = take(0) {
            return Some(turn);
        }
        said.ran(line::ONE);
        let Some(turn) = take(1) else {
            said.ran(line::STOP);
            return None;
        };
        self.way.pop();
        said.is(case::BACK);
        Some(turn)
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

    /// The turn at a node of the route that is entered with this heading: into its other way with one mark.
    fn turn(&self, node: u32, heading: Heading) -> Turn {
        let marks = self.nodes[node as usize].marks;
        let single = |turn: &Turn| marks[usize::from(heading.turned(*turn).index())] == 1;
        [Turn::Straight, Turn::Right, Turn::Left].into_iter().find(single).unwrap_or(Turn::Back)
    }
}

impl Robot for Tremaux {
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

    fn fact(&self, _: &str, out: &mut String) {
        let Some(node) = self.nodes.get(self.node as usize) else { return };
        for (i, way) in node.ways.iter().enumerate() {
            out.push_str(if i > 0 { ", " } else { "" });
            out.push_str(way.word());
            out.push(' ');
            out.push_str(&node.marks[usize::from(way.index())].to_string());
        }
    }

    fn peak_bytes(&self) -> u32 {
        // Two ints of coordinates and four bytes of marks.
        8 * self.nodes.len() as u32
    }

    fn host_bytes(&self) -> usize {
        self.places.bytes() + 5 * self.nodes.len() + 8 * self.way.len()
    }

    fn node(&self, look: Look) -> Option<u32> {
        look.is_choice().then_some(self.node + 1)
    }

    fn plan(&self) -> Option<Plan> {
        Some(Plan::Letters(self.way.iter().map(|&(node, heading)| self.turn(node, heading)).collect()))
    }
}
