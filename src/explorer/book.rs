//! The book's explorer (Dhasade and Joshi, *Maze Solving Robot*, 2017, chapters 2 and 3).
//!
//! It remembers the nodes of its path in a table, meets them again either by the way that it left them
//! (RETURN-KNOWN) or by a new one (RETURN-UNKNOWN), and forgets a node when it leaves it by its `back_path`.
//! Comments give the line of the pseudo-code in [`code`]; where that departs from the book's letter, the
//! [`errata`] say so.
//!
//! | name | meaning |
//! |---|---|
//! | `ptr` | one more than the number of remembered nodes |
//! | `returning` | the way that the bot drives does not lead to the finish |
//! | `paths`, `vpaths` | the ways of a node, and those already taken |
//! | `back_path` | the way by which a node was first reached |
//! | `last_path` | ours, for §3.2: the way last chosen at a node |

use crate::event::{Decision, Finish, Outcome, Seen, Sighting};
use crate::explorer::Explorer;
use crate::explorer::taste::Taste;
use crate::geometry::{Heading, Turn, Ways};
use crate::settings::Order;

pub mod code;
pub mod errata;
pub mod glossary;
pub mod grid_store;
pub mod locals;
pub mod narrate;
pub mod store;

use code::Line;
use store::{Node, NodeStore};

/// Which case of the algorithm a stop was.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[repr(u8)]
pub enum Case {
    /// The finish: stay.
    Finish,
    /// Back at the start with nothing left to try.
    Start,
    /// A dead end: turn round.
    DeadEnd,
    /// A corner: no decision.
    Corner,
    /// A node for the first time.
    New,
    /// RETURN-KNOWN, with an unvisited path left.
    Known,
    /// RETURN-KNOWN, and nothing left: leave by `back_path`.
    KnownBack,
    /// RETURN-UNKNOWN, and the remembered loop has unvisited paths: turn round.
    UnknownUturn,
    /// RETURN-UNKNOWN, and the loop has none: forget it and leave by `back_path`.
    UnknownBack,
    /// A node for the first time, and no room for it in the table.
    TableFull,
}

impl Case {
    /// The case with this number; what a trace keeps in four bits.
    #[must_use]
    pub const fn from_index(index: u32) -> Self {
        match index {
            0 => Self::Finish,
            1 => Self::Start,
            2 => Self::DeadEnd,
            3 => Self::Corner,
            4 => Self::New,
            5 => Self::Known,
            6 => Self::KnownBack,
            7 => Self::UnknownUturn,
            8 => Self::UnknownBack,
            _ => Self::TableFull,
        }
    }

    /// As the trace report names it; corners and the finish have no case.
    #[must_use]
    pub const fn name(self) -> Option<&'static str> {
        match self {
            Self::Finish | Self::Corner | Self::TableFull => None,
            Self::Start => Some("start"),
            Self::DeadEnd => Some("dead-end"),
            Self::New => Some("new"),
            Self::Known => Some("known"),
            Self::KnownBack => Some("known-back"),
            Self::UnknownUturn => Some("unknown-uturn"),
            Self::UnknownBack => Some("unknown-back"),
        }
    }

    /// As people read it, in the book's terms.
    #[must_use]
    pub const fn shown(self) -> Option<&'static str> {
        match self {
            Self::Finish | Self::Corner | Self::TableFull => None,
            Self::Start => Some("start"),
            Self::DeadEnd => Some("dead end"),
            Self::New => Some("new node"),
            Self::Known => Some("RETURN-KNOWN"),
            Self::KnownBack => Some("RETURN-KNOWN, back"),
            Self::UnknownUturn => Some("RETURN-UNKNOWN, U-turn"),
            Self::UnknownBack => Some("RETURN-UNKNOWN, back"),
        }
    }
}

/// What the book's explorer tells of its work at a stop.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Event {
    /// This line of the pseudo-code ran.
    Ran(Line),
    /// `get_coords()` moved the coordinates along `bot_dir`.
    Coordinates,
    /// `match_cur_node()` answered: a place in the table, or 0.
    Matched(u32),
    /// A node was recorded at this place of the table.
    Recorded(u32),
    /// `ptr` was set.
    Ptr(u32),
    /// `nodes[m].vpaths[d]` was set.
    Visited(u32, Heading),
    /// `returning` was set.
    Returning(bool),
    /// The bot turned.
    Turned(Turn),
    /// What kind of stop it was, once that is known.
    Case(Case),
}

/// The state of the book's explorer, over any table of nodes.
///
/// ```
/// use line_maze_lab::event::{Decision, Finish, Sighting};
/// use line_maze_lab::explorer::{Explorer, book::{Book, store::FixedStore}};
/// use line_maze_lab::geometry::{Heading, Turn, Ways};
/// use line_maze_lab::settings::{Order, Preference};
///
/// let mut bot = Book::new(FixedStore::<50>::new(), Order::Fixed(Preference::SRL), 200);
/// // 400 ms of line, then ways ahead, to the right and back: node 1, left straight on.
/// let ways = Ways::ALL.without(Heading::West);
/// let decision = bot.decide(Sighting { ways, finish: Finish::No, time_diff: 400 }, |_| {});
/// assert_eq!(decision, Decision::Go(Turn::Straight));
/// assert_eq!(bot.ptr(), 2);
/// ```
#[derive(Clone, Debug)]
pub struct Book<S> {
    cur_x: i32,
    cur_y: i32,
    bot_dir: Heading,
    returning: bool,
    nodes: S,
    taste: Taste,
    epsilon: u32,
}

impl<S: NodeStore> Book<S> {
    /// A bot at the start, with an empty table; `epsilon` in milliseconds.
    #[must_use]
    pub fn new(nodes: S, order: Order, epsilon: u32) -> Self {
        let taste = Taste::new(order);
        Self { cur_x: 0, cur_y: 0, bot_dir: Heading::North, returning: false, nodes, taste, epsilon }
    }

    /// One more than the number of remembered nodes.
    #[must_use]
    pub fn ptr(&self) -> u32 {
        self.nodes.len() + 1
    }

    /// Where the bot thinks that it is: milliseconds of driving east and north of the start.
    #[must_use]
    pub const fn coordinates(&self) -> (i32, i32) {
        (self.cur_x, self.cur_y)
    }

    /// Where it faces, in its own frame.
    #[must_use]
    pub const fn bot_dir(&self) -> Heading {
        self.bot_dir
    }

    /// Whether the way that it drives does not lead to the finish.
    #[must_use]
    pub const fn returning(&self) -> bool {
        self.returning
    }

    /// The table of nodes.
    #[must_use]
    pub const fn nodes(&self) -> &S {
        &self.nodes
    }

    /// `act()`, lines 1 to 6.
    fn act(&mut self, sighting: Sighting, say: &mut impl FnMut(Event)) -> Decision {
        say(Event::Ran(Line::GET));
        self.get_coords(sighting.time_diff);
        say(Event::Coordinates);
        say(Event::Ran(Line::FINISH));
        match sighting.seen() {
            Seen::Finish => {
                say(Event::Case(Case::Finish));
                Decision::End(Outcome::Finish)
            }
            Seen::DeadEnd => {
                say(Event::Ran(Line::EXHAUSTED));
                if self.ptr() == 1 && self.at_start() {
                    say(Event::Case(Case::Start));
                    return Decision::End(Outcome::NoFinishReachable);
                }
                say(Event::Ran(Line::DEAD_END));
                say(Event::Case(Case::DeadEnd));
                self.uturn(say)
            }
            Seen::Corner | Seen::Straight => {
                for line in [Line::EXHAUSTED, Line::DEAD_END, Line::CORNER] {
                    say(Event::Ran(line));
                }
                say(Event::Case(Case::Corner));
                let onward = sighting.ways.without(Heading::South);
                let turn = onward.only().map_or(Turn::Back, |way| Heading::North.turn_to(way));
                self.turn(turn, say)
            }
            Seen::Node => {
                for line in [Line::EXHAUSTED, Line::DEAD_END, Line::CORNER, Line::NODE] {
                    say(Event::Ran(line));
                }
                self.node(sighting.ways.out_of_frame_of(self.bot_dir), say)
            }
        }
    }

    /// `node()`, lines 8 to 21; `paths` in the bot's frame.
    fn node(&mut self, paths: Ways, say: &mut impl FnMut(Event)) -> Decision {
        let arrival = self.bot_dir.opposite();
        say(Event::Ran(Line::MATCH));
        let m = self.nodes.find(self.cur_x, self.cur_y, self.epsilon).unwrap_or(0);
        say(Event::Matched(m));
        say(Event::Ran(Line::IF_NEW));
        if m == 0 {
            say(Event::Ran(Line::RECORD));
            let node = Node::new(self.cur_x, self.cur_y, paths, arrival);
            let Some(m) = self.nodes.push(node) else {
                say(Event::Case(Case::TableFull));
                return Decision::End(Outcome::TableFull { capacity: self.nodes.capacity() });
            };
            say(Event::Recorded(m));
            say(Event::Ptr(m + 1));
            say(Event::Ran(Line::CHOOSE_NEW));
            say(Event::Case(Case::New));
            return self.choose_path(m, say).unwrap_or_else(|| self.take_return_path(m, say));
        }
        say(Event::Ran(Line::IF_RETURNING));
        if self.returning {
            say(Event::Ran(Line::KNOWN_PTR));
            self.set_ptr(m + 1, say);
            say(Event::Ran(Line::KNOWN_CHOOSE));
            let known = self.choose_path(m, say);
            say(Event::Case(if known.is_some() { Case::Known } else { Case::KnownBack }));
            return known.unwrap_or_else(|| self.take_return_path(m, say));
        }
        say(Event::Ran(Line::ELSE_UNKNOWN));
        say(Event::Ran(Line::MARK_ARRIVAL));
        self.nodes.visit(m, arrival);
        say(Event::Visited(m, arrival));
        say(Event::Ran(Line::IF_UNVISITED));
        if self.nodes.any_unvisited_from(m) {
            say(Event::Case(Case::UnknownUturn));
            return self.uturn(say);
        }
        say(Event::Ran(Line::ELSE_LOOP));
        say(Event::Ran(Line::LOOP_PTR));
        self.set_ptr(m + 1, say);
        say(Event::Ran(Line::LOOP_CHOOSE));
        say(Event::Case(Case::UnknownBack));
        // Line 18 has just covered node m, so there is nothing to choose; the line is the book's.
        self.choose_path(m, say).unwrap_or_else(|| self.take_return_path(m, say))
    }

    /// `choose_path(m)`, lines 23 to 26.
    fn choose_path(&mut self, m: u32, say: &mut impl FnMut(Event)) -> Option<Decision> {
        say(Event::Ran(Line::FIRST));
        let unvisited = self.nodes.node(m).unvisited();
        let bot_dir = self.bot_dir;
        let first = self.taste.order().into_iter().find(|&turn| unvisited.has(bot_dir.turned(turn)));
        let Some(turn) = first else {
            say(Event::Ran(Line::NONE_LEFT));
            return None;
        };
        say(Event::Ran(Line::TAKE));
        let d = bot_dir.turned(turn);
        self.nodes.visit(m, d);
        self.nodes.leave(m, d);
        say(Event::Visited(m, d));
        self.set_returning(false, say);
        Some(self.turn(turn, say))
    }

    /// `take_return_path(m)`, lines 28 to 30: node m, the last of the table, is forgotten.
    fn take_return_path(&mut self, m: u32, say: &mut impl FnMut(Event)) -> Decision {
        say(Event::Ran(Line::BACK));
        let turn = self.bot_dir.turn_to(self.nodes.node(m).back_path);
        let decision = self.turn(turn, say);
        self.set_returning(true, say);
        say(Event::Ran(Line::FORGET));
        self.set_ptr(m, say);
        decision
    }

    /// Table 2.4: the time since the last stop, added along `bot_dir`.
    const fn get_coords(&mut self, time_diff: u32) {
        let (dx, dy) = self.bot_dir.vector();
        self.cur_x = self.cur_x.wrapping_add(dx.wrapping_mul(time_diff as i32));
        self.cur_y = self.cur_y.wrapping_add(dy.wrapping_mul(time_diff as i32));
    }

    const fn at_start(&self) -> bool {
        // With an epsilon of 0 nothing ever matches, not even the start.
        self.cur_x.unsigned_abs() < self.epsilon && self.cur_y.unsigned_abs() < self.epsilon
    }

    fn uturn(&mut self, say: &mut impl FnMut(Event)) -> Decision {
        let decision = self.turn(Turn::Back, say);
        self.set_returning(true, say);
        decision
    }

    fn turn(&mut self, turn: Turn, say: &mut impl FnMut(Event)) -> Decision {
        self.bot_dir = self.bot_dir.turned(turn);
        say(Event::Turned(turn));
        Decision::Go(turn)
    }

    fn set_ptr(&mut self, ptr: u32, say: &mut impl FnMut(Event)) {
        self.nodes.truncate(ptr - 1);
        say(Event::Ptr(ptr));
    }

    fn set_returning(&mut self, returning: bool, say: &mut impl FnMut(Event)) {
        self.returning = returning;
        say(Event::Returning(returning));
    }
}

impl<S: NodeStore> Explorer for Book<S> {
    type Event = Event;

    fn decide(&mut self, sighting: Sighting, mut emit: impl FnMut(Event)) -> Decision {
        debug_assert!(sighting.finish == Finish::Yes || sighting.ways.has(Heading::South));
        self.act(sighting, &mut emit)
    }
}
