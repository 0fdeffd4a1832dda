//! Full mapping of any line maze (Sakib, Chowdhury, Ahamed and Imam Hasan, *Maze solving algorithm for line following
//! robot*, 2014, §III and §IV): every point is recorded with its coordinates until no way is unexplored; the
//! columns then give an adjacency list, and that the shortest and the quickest way.
//!
//! | name | meaning |
//! |---|---|
//! | point | a turning point, junction, dead end, the start or the finish |
//! | `Point` | which point was visited, one column a visit; numbered from 0 as they were recorded |
//! | `Type` | the point's ways − 1 |
//! | `Explored` | its different neighbours that are known, after this visit |
//! | `CoOr_X`, `CoOr_Y` | its coordinates; directions are the robot's own, the start faces north |
//! | `Total_points` | how many points |

use alloc::string::{String, ToString};
use alloc::vec::Vec;

use super::book::errata::{Erratum, Kind, Place};
use super::mind::{Costs, Plan, Robot, Setup};
use super::places::{Places, Reckoning};
use super::tell::{Tell, many};
use crate::event::{Decision, Finish, Home, Look, Outcome};
use crate::geometry::{Heading, Point, Turn, Ways};
use crate::settings;

mod columns;
mod nearest;
pub mod search;

pub use columns::Column;
use nearest::Nearest;
use search::{Aim, Search};

listing! {
    ACT    "every stop:"
    FIND   "  point = the one with these coordinates, within the tolerance"
    NEW    "  if there is none: point = Total_points; Total_points = Total_points + 1"
    COLUMN "  one column more: Point, Type, CoOr_X, CoOr_Y"
    JOIN lab "  join it to the point before; Explored = its different neighbours"
    ROUTE  "  if it drives to a point: go on over known points"
    TAKE lab "  else if it has unexplored ways: take the first of east, north, west, south"
    NEAR lab "  else find the nearest point that has one: drive there over known points"
    NONE   "  if there is none: stop        # explored; make the adjacency list"
}

cases! {
    START "start" Info Plain "The robot stands at the start, which becomes point {point}, at {xy}. Its direction is north: it *{turn}*."
    NEW "new-point" Now Node "No point has these coordinates, {xy}, so this place becomes point {point}, of type {type}. The robot takes its first unexplored way, {way}: it *{turn}*."
    KNOWN "known-point" Now Unknown "By its coordinates this is point {point} again; of its neighbours, {explored} known now. The robot takes its first unexplored way, {way}: it *{turn}*."
    SEARCH "nearest" Now DeadEnd "This is point {point}, and all its ways are explored. The nearest point with an unexplored way is {target}, {left} away: the robot *{turn}*."
    ROUTE "on-route" Info Plain "The robot passes point {point} on its way to point {target}, and *{turn}*."
    BACK "at-target" Now Known "The robot is at point {point}, as planned. It takes its first unexplored way, {way}: it *{turn}*."
    DONE "explored" Go End "No point has an unexplored way: the exploration is *finished*, with {total}. The columns give the adjacency list."
}

/// Where the paper slips, and what it leaves open.
pub static ERRATA: &[Erratum] = &[
    Erratum {
        section: "Figure 3",
        title: "F lies in the south",
        text: "The table prints 18 for F's y, but E's southern path leads there. With figure 2's lengths it is 2.",
        printed: Some("CoOr_y of F: 18"),
        meant: Some("CoOr_Y of F: 2"),
        kind: Kind::Slip,
        places: &[Place::SakibFigure2 { stop: 11 }],
    },
    Erratum {
        section: "§III, figure 3",
        title: "Two counts of Explored",
        text: "A's printed 4 counts its neighbours, its 3s count one less, and dead ends show 1 where the definition gives 0. The lab counts neighbours, always.",
        printed: None,
        meant: None,
        kind: Kind::Slip,
        places: &[
            Place::SakibFigure2 { stop: 4 },
            Place::SakibFigure2 { stop: 8 },
            Place::SakibFigure2 { stop: 9 },
        ],
    },
    Erratum::open(
        "§III",
        "Which way first",
        "The paper speaks of a sequence of preference without giving it. Its example takes east, then north, so the lab follows the paper’s numbers: east, north, west, south.",
        &[Place::Told(case::START)],
    ),
    Erratum::open(
        "§III",
        "How far is near",
        "The paper goes to the closest point with something left. The lab measures what has to be driven; of equally near points it takes the one recorded first, and there the shortest way.",
        &[Place::Told(case::SEARCH)],
    ),
];

/// No point.
const NONE: u32 = u32::MAX;

/// The paper's order of directions.
pub const PREFERENCE: [Heading; 4] = [Heading::East, Heading::North, Heading::West, Heading::South];

/// The paper's number of a direction.
#[must_use]
pub const fn direction(heading: Heading) -> u8 {
    match heading {
        Heading::East => 1,
        Heading::North => 2,
        Heading::West => 3,
        Heading::South => 4,
    }
}

/// A point of the maze as the robot knows it; headings in its own frame.
#[derive(Clone, Copy, Debug)]
struct Known {
    /// The neighbour in each direction.
    links: [u32; 4],
    ways: Ways,
    /// Ways whose neighbour is known.
    joined: Ways,
    finish: Finish,
}

/// A robot that maps the whole maze.
#[derive(Clone, Debug)]
pub struct Mapping {
    here: Reckoning,
    places: Places,
    points: Vec<Known>,
    /// The point of each visit, and in the highest three bits how many neighbours were known after it.
    visits: Vec<u32>,
    /// The ways that are left to drive to a point with an unexplored way, the next one last.
    route: Vec<Heading>,
    target: u32,
    nearest: Nearest,
    cell_ms: u32,
    costs: Costs,
    search: settings::Search,
}

const POINT_BITS: u32 = 29;
const POINT_MASK: u32 = (1 << POINT_BITS) - 1;

impl Mapping {
    /// A robot that knows nothing yet.
    #[must_use]
    pub fn new(setup: &Setup) -> Self {
        Self {
            here: Reckoning::default(),
            places: Places::new(setup.epsilon),
            points: Vec::new(),
            visits: Vec::new(),
            route: Vec::new(),
            target: NONE,
            nearest: Nearest::default(),
            cell_ms: setup.cell_ms.max(1),
            costs: setup.costs,
            search: setup.search,
        }
    }

    /// `Total_points`.
    #[must_use]
    pub const fn total_points(&self) -> u32 {
        self.points.len() as u32
    }

    /// The known neighbours of a point, clockwise from north.
    pub fn neighbours(&self, point: u32) -> impl Iterator<Item = u32> {
        self.points[point as usize].links.into_iter().filter(|&link| link != NONE)
    }

    /// A point's coordinates in cells.
    #[must_use]
    pub fn cell(&self, point: u32) -> Point {
        let (x, y) = self.places.coordinates(point);
        let cells = |ms: i32| {
            let half = self.cell_ms as i32 / 2;
            (ms + half).div_euclid(self.cell_ms as i32)
        };
        Point::new(cells(x), cells(y))
    }

    /// The ways of a point that lead nobody knows where.
    #[must_use]
    pub fn unexplored(&self, point: u32) -> Ways {
        let known = &self.points[point as usize];
        known.ways.minus(known.joined)
    }

    /// Whether a point is (part of) the finish.
    #[must_use]
    pub fn is_finish(&self, point: u32) -> bool {
        self.points[point as usize].finish == Finish::Yes
    }

    /// The point that the robot drives to over known points.
    #[must_use]
    pub fn target(&self) -> Option<u32> {
        (self.target != NONE).then_some(self.target)
    }

    /// A search for a way from the start to a finish that is known, to be stepped through.
    #[must_use]
    pub fn search(&self, aim: Aim) -> Search<'_> {
        Search::new(self, aim, self.search)
    }

    /// The points of the shortest or quickest known way to a finish.
    #[must_use]
    pub fn route(&self, aim: Aim) -> Option<Vec<u32>> {
        self.search(aim).finish()
    }

    /// Milliseconds between two points along an axis.
    fn length(&self, a: u32, b: u32) -> u64 {
        let ((ax, ay), (bx, by)) = (self.places.coordinates(a), self.places.coordinates(b));
        u64::from(ax.abs_diff(bx)) + u64::from(ay.abs_diff(by))
    }

    /// The point before, if there was a visit before.
    fn point(&self) -> Option<u32> {
        self.visits.last().map(|packed| packed & POINT_MASK)
    }

    fn join(&mut self, from: u32, to: u32) {
        let way = self.here.heading;
        let a = &mut self.points[from as usize];
        (a.links[usize::from(way.index())], a.joined) = (to, a.joined.with(way));
        let (b, back) = (&mut self.points[to as usize], way.opposite());
        (b.links[usize::from(back.index())], b.joined) = (from, b.joined.with(back));
    }

    /// Notes the visit; the point, and whether it is new.
    fn visit(&mut self, look: Look, tell: &mut impl Tell<Self>) -> (u32, bool) {
        let known = self.places.find(self.here.x, self.here.y);
        let before = self.point();
        let point = match known {
            Some(point) => {
                tell.did(line::FIND, self);
                point
            }
            None => {
                tell.none(line::FIND, self);
                let ways = look.sighting.ways.out_of_frame_of(self.here.heading);
                let finish = look.sighting.finish;
                self.points.push(Known { links: [NONE; 4], ways, joined: Ways::NONE, finish });
                let point = self.places.push(self.here.x, self.here.y);
                tell.did(line::NEW, self);
                point
            }
        };
        self.visits.push(point);
        tell.did(line::COLUMN, self);
        if let Some(before) = before {
            self.join(before, point);
        }
        let explored = self.points[point as usize].joined.count();
        if let Some(column) = self.visits.last_mut() {
            *column |= explored << POINT_BITS;
        }
        tell.did(line::JOIN, self);
        (point, known.is_none())
    }

    /// Turns to a heading.
    fn face(&mut self, way: Heading) -> Turn {
        let turn = self.here.heading.turn_to(way);
        self.here.heading = way;
        turn
    }

    fn choose(&mut self, look: Look, tell: &mut impl Tell<Self>) -> Option<Turn> {
        let (point, new) = self.visit(look, tell);
        if let Some(way) = self.route.pop() {
            let turn = self.face(way);
            tell.is(case::ROUTE);
            tell.did(line::ROUTE, self);
            return Some(turn);
        }
        tell.no(line::ROUTE, self);
        let unexplored = self.unexplored(point);
        if let Some(way) = PREFERENCE.into_iter().find(|&way| unexplored.has(way)) {
            tell.is(match (look.home, new) {
                (Home::PutDown, _) => case::START,
                (_, true) => case::NEW,
                _ if self.target == point => case::BACK,
                _ => case::KNOWN,
            });
            self.target = NONE;
            let turn = self.face(way);
            tell.did(line::TAKE, self);
            return Some(turn);
        }
        tell.no(line::TAKE, self);
        let mut nearest = core::mem::take(&mut self.nearest);
        let found = nearest.find(self, point);
        self.nearest = nearest;
        let Some((target, mut route)) = found else {
            tell.none(line::NEAR, self);
            self.target = NONE;
            tell.is(case::DONE);
            tell.did(line::NONE, self);
            return None;
        };
        let turn = route.pop().map(|way| self.face(way));
        (self.target, self.route) = (target, route);
        tell.is(case::SEARCH);
        tell.did(line::NEAR, self);
        turn
    }
}

impl Robot for Mapping {
    fn decide(&mut self, look: Look, tell: &mut impl Tell<Self>) -> Decision {
        self.here.drive(look.sighting.time_diff);
        self.choose(look, tell).map_or(Decision::End(Outcome::Mapped), Decision::Go)
    }

    fn fact(&self, key: &str, out: &mut String) {
        let Some(column) = self.visits.len().checked_sub(1).and_then(|last| self.column(last)) else {
            return;
        };
        let cell = self.cell(column.point);
        out.push_str(&match key {
            "point" => column.point.to_string(),
            "type" => column.kind.to_string(),
            "explored" => match column.explored {
                1 => "1 is".to_string(),
                many => alloc::format!("{many} are"),
            },
            "way" => self.here.heading.word().to_string(),
            "target" => self.target.to_string(),
            "left" => many(self.route.len() + 1, "point"),
            "total" => many(self.points.len(), "point"),
            _ => alloc::format!("{},{}", cell.x, cell.y),
        });
    }

    fn peak_bytes(&self) -> u32 {
        // Five ints a column.
        10 * self.visits.len() as u32
    }

    fn host_bytes(&self) -> usize {
        self.places.bytes()
            + size_of::<Known>() * self.points.len()
            + 4 * self.visits.len()
            + self.route.len()
    }

    fn node(&self, _: Look) -> Option<u32> {
        self.point()
    }

    fn plan(&self) -> Option<Plan> {
        let route = self.route(Aim::Shortest)?;
        Some(Plan::Places(route.into_iter().map(|point| self.cell(point)).collect()))
    }
}
