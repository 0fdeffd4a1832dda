//! What the floor looks like at a moment of a run: which cells are remembered, driven or crossed out, where
//! the nodes are, where the bot is. Views draw it and decide nothing.

use alloc::vec::Vec;

use crate::explorer::book::narrate::{Span, narrate};
use crate::geometry::{Heading, Point, Turn, Ways};
use crate::ink::{Cell, CellState, Ink};
use crate::maze::Maze;
use crate::route::Route;
use crate::trace::{Moment, Row, Trace};

mod names;
pub mod recorded;

pub use names::{NamePlace, name_place};

/// How a cell of line is shown.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Trail {
    /// On the way of the remembered nodes, or driven just now.
    Remembered,
    /// Driven on from the newest node, and given up: the bot is on its way back over it.
    GivenUp,
    /// Crossed out.
    Crossed,
}

/// Every driven cell after a stop, and how it is shown.
pub fn trails(maze: &Maze, trace: &Trace, ink: &Ink, stop: u32) -> impl Iterator<Item = (Cell, Trail)> {
    let given_up = way_back(maze, trace, ink, stop);
    ink.cells(stop).map(move |(cell, state)| {
        let trail = match state {
            CellState::Crossed => Trail::Crossed,
            _ if given_up.binary_search(&cell).is_ok() => Trail::GivenUp,
            _ => Trail::Remembered,
        };
        (cell, trail)
    })
}

/// The driven cells between a returning bot and the newest remembered node, sorted.
fn way_back(maze: &Maze, trace: &Trace, ink: &Ink, stop: u32) -> Vec<Cell> {
    let mut cells = Vec::new();
    let Some(step) = trace.step(stop).filter(|_| trace.state(stop).returning) else { return cells };
    let (mut at, mut heading) = (ink.place(stop), step.departure().out_of_frame_of(ink.north()));
    while ink.cell((at, heading), stop) == CellState::Driven {
        cells.push(by_end(at, heading));
        at = at.step(heading);
        // Between two nodes there is only one way on.
        match maze.ways(at).without(heading.opposite()).only() {
            Some(way) => heading = way,
            None => break,
        }
        if cells.len() > maze.cells() {
            break;
        }
    }
    cells.sort_unstable();
    cells
}

/// A cell by its southern or western end.
const fn by_end(at: Point, heading: Heading) -> Cell {
    match heading {
        Heading::North | Heading::East => (at, heading),
        Heading::South | Heading::West => (at.step(heading), heading.opposite()),
    }
}

/// What the robot has seen of the floor after a stop: for each point that it drove to, the ways there.
pub fn seen_points(maze: &Maze, ink: &Ink, stop: u32) -> Vec<(Point, Ways)> {
    let mut points: Vec<Point> = ink.cells(stop).flat_map(|((at, h), _)| [at, at.step(h)]).collect();
    points.push(ink.place(0));
    points.sort_unstable();
    points.dedup();
    points.into_iter().map(|at| (at, maze.ways(at))).collect()
}

/// A remembered node on the floor.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct NodeMark {
    /// Its number in the table.
    pub number: u32,
    /// Where it was recorded, in the drawing's frame.
    pub at: Point,
}

/// The remembered nodes at a moment, in the order of their numbers.
pub fn nodes(trace: &Trace, ink: &Ink, moment: Moment) -> Vec<NodeMark> {
    let ptr = trace.frame(moment).state.ptr;
    let mark = |Row { number, met, .. }: Row| NodeMark { number, at: ink.place(met) };
    (1..ptr).filter_map(|m| trace.row(moment, m)).map(mark).collect()
}

/// The unvisited ways that the sentence of a moment lists, on the floor: the node's place, and the drawing's heading.
#[must_use]
pub fn listed_ways(trace: &Trace, ink: &Ink, moment: Moment) -> Vec<(Point, Heading)> {
    let told = narrate(trace, &trace.frame(moment));
    let place = |span: &Span| match *span {
        Span::Way { node, heading } => {
            let row = trace.row(moment, node)?;
            Some((ink.place(row.met), heading.out_of_frame_of(ink.north())))
        }
        Span::Text(_) | Span::Strong(_) | Span::Code(_) | Span::Node(_) => None,
    };
    told.said.iter().filter_map(place).collect()
}

/// Where the bot is on the floor, in lattice units, and how it is turned.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Pose {
    /// East of the origin, in cells.
    pub x: f64,
    /// North of the origin, in cells.
    pub y: f64,
    /// Degrees clockwise from the drawing's north; may pass 360 while turning.
    pub degrees: f64,
}

/// The share of a drive, at its end, in which the bot turns to where it goes on, when it has a turn to make.
const TURNING: f64 = 0.25;

/// One drive, as a pose needs it.
struct Drive {
    from: Point,
    to: Point,
    /// How the bot faces while it drives.
    faces: Heading,
    /// How it faces once it has settled at the stop.
    settles: Heading,
}

impl Drive {
    /// Settled at a place.
    const fn none(at: Point, faces: Heading) -> Self {
        Self { from: at, to: at, faces, settles: faces }
    }

    fn pose(&self, along: f64) -> Pose {
        let quarters = match self.faces.turn_to(self.settles) {
            Turn::Straight => 0.0,
            Turn::Right => 1.0,
            Turn::Back => 2.0,
            Turn::Left => -1.0,
        };
        let turning = if quarters == 0.0 { 0.0 } else { TURNING };
        let driven = (along / (1.0 - turning)).min(1.0);
        let turned = if turning == 0.0 { 0.0 } else { ((along - 1.0 + turning) / turning).clamp(0.0, 1.0) };
        let between = |a: i32, b: i32| f64::from(a) + f64::from(b - a) * driven;
        Pose {
            x: between(self.from.x, self.to.x),
            y: between(self.from.y, self.to.y),
            degrees: (f64::from(self.faces.index()) + quarters * turned) * 90.0,
        }
    }
}

/// Where a run is shown: a settled moment, or some of the way from there to the next stop.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Shown {
    /// The moment that the words tell.
    pub moment: Moment,
    /// How much of the way to the next stop is driven, 0 to 1; at 0 the bot stands.
    pub along: f64,
    /// The moment at which the drive ends: with some lines of that stop, or with all.
    pub bound: Moment,
}

impl Shown {
    /// Settled at a moment.
    #[must_use]
    pub const fn settled(moment: Moment) -> Self {
        Self { moment, along: 0.0, bound: moment }
    }
}

/// The bot where a run is shown. At a moment it faces `bot_dir` as the lines so far have set it: after a whole stop,
/// where it goes on to.
#[must_use]
pub fn pose(trace: &Trace, ink: &Ink, shown: Shown) -> Pose {
    let faces = |moment: Moment| trace.bot_dir(moment).out_of_frame_of(ink.north());
    let stop = shown.moment.stop.min(trace.stops());
    if shown.along <= 0.0 || stop == trace.stops() {
        return Drive::none(ink.place(stop), faces(shown.moment)).pose(0.0);
    }
    let drive = Drive {
        from: ink.place(stop),
        to: ink.place(stop + 1),
        faces: faces(Moment::after(stop)),
        settles: faces(Moment { stop: stop + 1, ..shown.bound }),
    };
    drive.pose(shown.along)
}

/// The bot in round 2, after a stop of the route, `along` of the way (0 to 1) to the next.
#[must_use]
pub fn route_pose(route: &Route, north: Heading, stop: u32, along: f64) -> Pose {
    let (here, next) = (route.leg(stop), route.leg(stop + 1));
    let from = here.map_or(route.start, |leg| leg.at);
    let arrived = here.map_or(north, |leg| leg.heading);
    let faces = next.map_or(arrived, |leg| leg.heading);
    let Some(next) = next.filter(|_| along > 0.0) else { return Drive::none(from, faces).pose(0.0) };
    let settles = route.leg(stop + 2).map_or(faces, |leg| leg.heading);
    Drive { from, to: next.at, faces, settles }.pose(along)
}

/// The cells between two stops' places, from the first on: what the bot is driving over.
pub fn drive_cells(ink: &Ink, stop: u32) -> impl Iterator<Item = Cell> {
    cells_between(ink.place(stop), ink.place(stop + 1))
}

/// The cells of a straight drive, in order.
pub fn cells_between(from: Point, to: Point) -> impl Iterator<Item = Cell> {
    let heading = Heading::ALL.into_iter().find(|&h| from.step(h).distance(to) < from.distance(to));
    (0..from.distance(to) as i32).filter_map(move |i| heading.map(|h| by_end(from.ahead(h, i), h)))
}
