//! Any explorer but the book's, as a recording holds it: fed with looks, asked for decisions, copied as a
//! keyframe, read by an inspector.

use alloc::string::String;
use alloc::vec::Vec;

use super::cornell::{Cornell, Version};
use super::depth_first::DepthFirst;
use super::flood_fill::FloodFill;
use super::hand::{Hand, Side};
use super::mapping::Mapping;
use super::name::Name;
use super::parex::{Numbering, Parex};
use super::sums::Sums;
use super::tell::{Said, Seen, Tell, Watch};
use super::tremaux::Tremaux;
use crate::event::{Decision, Look};
use crate::geometry::{Heading, Point, Turn};
use crate::settings::{Order, Rule, Search};

/// A robot's mind: sightings in, decisions out, and what it tells of itself.
pub trait Robot {
    /// Decides at a stop and tells, line by line, what it does. Where the drive has brought the robot is in the
    /// memory before the first line; all else is there when its line is told, and nothing is done after the last.
    fn decide(&mut self, look: Look, tell: &mut impl Tell<Self>) -> Decision
    where
        Self: Sized;

    /// Writes a fact that a template of [`super::tell`] asks for.
    fn fact(&self, key: &str, out: &mut String);

    /// The most bytes that its memory took on the robot so far, in the C types of the source.
    fn peak_bytes(&self) -> u32;

    /// About how many bytes a copy takes on the host.
    fn host_bytes(&self) -> usize;

    /// Its own number of the place that it stands on after this look, if it numbers such places.
    fn node(&self, _look: Look) -> Option<u32> {
        None
    }

    /// What it remembers of the way to the finish; nothing while it knows none.
    fn plan(&self) -> Option<Plan>;
}

/// A way to the finish, as a mind remembers it.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Plan {
    /// A turn for each node, and for a start with several ways.
    Letters(Vec<Turn>),
    /// Places one after the other in straight lines, in cells from the start, in the robot's own frame (its
    /// start heading is north).
    Places(Vec<Point>),
}

/// What is written into a robot before it is put down. None of it tells where lines are.
#[derive(Clone, Debug)]
pub struct Setup {
    /// Preference order: depth first and Trémaux.
    pub order: Order,
    /// Two places nearer than this on both axes are one, in milliseconds.
    pub epsilon: u32,
    /// Milliseconds for a cell.
    pub cell_ms: u32,
    /// Size of the field, and where and how the robot is put down: square explorers.
    pub field: Field,
    /// PAReX's rule.
    pub rule: Rule,
    /// PAReX's longest path.
    pub path_max: Option<u32>,
    /// How full mapping looks for its routes.
    pub search: Search,
    /// What driving costs: full mapping.
    pub costs: Costs,
    /// The squares of the finish, in field coordinates: flood fill alone is told.
    pub goal: Vec<Point>,
}

/// A field of squares, with x to the east and y to the north from 0,0 in its south-west corner.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Field {
    /// Squares from west to east.
    pub width: u32,
    /// Squares from south to north.
    pub height: u32,
    /// The square that the robot is put down on.
    pub start: Point,
    /// How it faces there.
    pub heading: Heading,
}

impl Field {
    /// A square's place in rows from the south-west; none off the field.
    #[must_use]
    pub const fn index(self, at: Point) -> Option<usize> {
        if at.x >= 0 && at.y >= 0 && (at.x as u32) < self.width && (at.y as u32) < self.height {
            Some(at.y as usize * self.width as usize + at.x as usize)
        } else {
            None
        }
    }

    /// How many squares.
    #[must_use]
    pub const fn squares(self) -> usize {
        self.width as usize * self.height as usize
    }

    /// A square as seen from the start, in the robot's own frame.
    #[must_use]
    pub const fn from_start(self, at: Point) -> Point {
        Point::new(at.x - self.start.x, at.y - self.start.y).in_frame_of(self.heading)
    }
}

/// What driving costs, in whole nanoseconds, so that sums are exact.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Costs {
    /// A cell.
    pub cell: u64,
    /// A turn of 90°.
    pub turn: u64,
    /// Turning round.
    pub uturn: u64,
    /// A stop.
    pub stop: u64,
}

impl Costs {
    /// A turn of this kind.
    #[must_use]
    pub const fn of(self, turn: Turn) -> u64 {
        match turn {
            Turn::Straight => 0,
            Turn::Right | Turn::Left => self.turn,
            Turn::Back => self.uturn,
        }
    }
}

/// Any explorer but the book's.
#[derive(Clone, Debug)]
pub enum Mind {
    /// Hand on the wall.
    Hand(Hand),
    /// Direction sums.
    Sums(Sums),
    /// Full mapping.
    Mapping(Mapping),
    /// Path mapping.
    Parex(Parex),
    /// A traversal of squares.
    Cornell(Cornell),
    /// Trémaux's marks.
    Tremaux(Tremaux),
    /// Depth first.
    DepthFirst(DepthFirst),
    /// Flood fill.
    FloodFill(FloodFill),
}

impl Mind {
    /// A mind before its first stop; none for the book's, which has a trace of its own.
    #[must_use]
    pub fn new(name: Name, setup: &Setup) -> Option<Self> {
        let parex = |side| Parex::new(side, setup.rule, Numbering::of(setup.field), setup.path_max);
        let cornell = |version| Self::Cornell(Cornell::new(version, setup.field));
        Some(match name {
            Name::Book => return None,
            Name::LeftHand => Self::Hand(Hand::new(Side::Left)),
            Name::RightHand => Self::Hand(Hand::new(Side::Right)),
            Name::DirectionSumLeft => Self::Sums(Sums::new(Side::Left)),
            Name::DirectionSumRight => Self::Sums(Sums::new(Side::Right)),
            Name::Mapping => Self::Mapping(Mapping::new(setup)),
            Name::ParexLeft => Self::Parex(parex(Side::Left)),
            Name::ParexRight => Self::Parex(parex(Side::Right)),
            Name::Cornell1 => cornell(Version::One),
            Name::Cornell2 => cornell(Version::Two),
            Name::Cornell3 => cornell(Version::Three),
            Name::Tremaux => Self::Tremaux(Tremaux::new(setup.order, setup.epsilon)),
            Name::DepthFirst => Self::DepthFirst(DepthFirst::new(setup.order, setup.epsilon)),
            Name::FloodFill => Self::FloodFill(FloodFill::new(setup.field, &setup.goal)),
        })
    }

    /// The mind, whichever it is.
    #[must_use]
    pub fn robot(&self) -> &dyn Robot {
        match self {
            Self::Hand(mind) => mind,
            Self::Sums(mind) => mind,
            Self::Mapping(mind) => mind,
            Self::Parex(mind) => mind,
            Self::Cornell(mind) => mind,
            Self::Tremaux(mind) => mind,
            Self::DepthFirst(mind) => mind,
            Self::FloodFill(mind) => mind,
        }
    }

    /// Decides at a stop.
    pub fn decide(&mut self, look: Look, said: &mut Said) -> Decision {
        match self {
            Self::Hand(mind) => mind.decide(look, said),
            Self::Sums(mind) => mind.decide(look, said),
            Self::Mapping(mind) => mind.decide(look, said),
            Self::Parex(mind) => mind.decide(look, said),
            Self::Cornell(mind) => mind.decide(look, said),
            Self::Tremaux(mind) => mind.decide(look, said),
            Self::DepthFirst(mind) => mind.decide(look, said),
            Self::FloodFill(mind) => mind.decide(look, said),
        }
    }

    /// Decides at a stop, and looks at itself when so many lines have run; nothing where the stop has fewer.
    pub fn watched(&mut self, look: Look, lines: u8) -> (Said, Option<Seen<Self>>) {
        match self {
            Self::Hand(mind) => watched(mind, look, lines, Self::Hand),
            Self::Sums(mind) => watched(mind, look, lines, Self::Sums),
            Self::Mapping(mind) => watched(mind, look, lines, Self::Mapping),
            Self::Parex(mind) => watched(mind, look, lines, Self::Parex),
            Self::Cornell(mind) => watched(mind, look, lines, Self::Cornell),
            Self::Tremaux(mind) => watched(mind, look, lines, Self::Tremaux),
            Self::DepthFirst(mind) => watched(mind, look, lines, Self::DepthFirst),
            Self::FloodFill(mind) => watched(mind, look, lines, Self::FloodFill),
        }
    }
}

fn watched<M: Robot + Clone>(
    mind: &mut M,
    look: Look,
    lines: u8,
    any: fn(M) -> Mind,
) -> (Said, Option<Seen<Mind>>) {
    let mut watch = Watch::until(lines);
    mind.decide(look, &mut watch);
    let (said, seen) = watch.done();
    (said, seen.map(|Seen { ran, mind }| Seen { ran, mind: any(mind) }))
}
