//! The way to the finish: the turn list that a run leaves, driving it (round 2), and how good it is.

use alloc::vec::Vec;

use crate::geometry::{Heading, Point, Turn};
use crate::maze::{Maze, Start};
use crate::playback::{Mark, Timeline};
use crate::settings::Pace;
use crate::world::line_start;

pub mod best;
pub mod follow;
pub mod forms;
pub mod lab;
pub mod letters;
pub mod tally;
mod turn_list;
pub mod words;

pub use follow::Strayed;
pub use turn_list::{Corners, NotATurn, TurnList};

use follow::{End, Floor, follow};
use tally::Tally;

/// A stop of round 2.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Leg {
    /// Where the stop is.
    pub at: Point,
    /// The drawing's heading with which the bot arrived.
    pub heading: Heading,
    /// Cells driven since the stop before.
    pub cells: u32,
    /// The turn made here; none at the finish.
    pub turn: Option<Turn>,
    /// Which letter of the list it was, from 1; none at a corner.
    pub letter: Option<usize>,
}

/// Round 2: a drive from the start, as a rule to the finish.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Route {
    /// The start.
    pub start: Point,
    /// The turn made there before the first drive.
    pub start_turn: Turn,
    /// Which letter of the list that was, from 1; none where the start has one way.
    pub start_letter: Option<usize>,
    /// Every stop, corners included; the last has no turn.
    pub legs: Vec<Leg>,
}

impl Route {
    /// Drives a turn list in an ideal world, as the book's robot does: from a line's end, facing along it.
    ///
    /// # Errors
    /// Where it does not lead to the finish.
    pub fn drive(maze: &Maze, list: &TurnList) -> Result<Self, Strayed> {
        let start = line_start(maze).map_err(Strayed::CannotStart)?;
        Self::drive_from(maze, start, list)
    }

    /// Drives a turn list from any start.
    ///
    /// # Errors
    /// Where it does not lead to the finish.
    pub fn drive_from(maze: &Maze, start: Start, list: &TurnList) -> Result<Self, Strayed> {
        let followed = follow(maze, start, list, Corners::LeftOut);
        match followed.end {
            End::Finish { .. } => Ok(followed.route),
            End::Strayed(strayed) => Err(strayed),
        }
    }

    /// The drive over these points in order, the start first; each is along an axis from the one before. None
    /// where there is no line between two of them.
    ///
    /// ```
    /// use line_maze_lab::geometry::Point;
    /// use line_maze_lab::maze::samples;
    /// use line_maze_lab::route::{Corners, Route};
    /// let maze = samples::figure_3_1();
    /// let way = [(0, 0), (0, 5), (3, 5), (3, 4)].map(|(x, y)| Point::new(x, y));
    /// let route = Route::through(&maze, maze.start().unwrap(), &way).unwrap();
    /// assert_eq!(route.list(Corners::LeftOut).to_string(), "SSR");
    /// assert_eq!(route.list(Corners::Listed).to_string(), "SSRR");
    /// ```
    #[must_use]
    pub fn through(maze: &Maze, start: Start, points: &[Point]) -> Option<Self> {
        let mut way = Way::new(maze, start);
        if points.first().is_some_and(|&first| first != start.at) {
            return None;
        }
        for pair in points.windows(2) {
            let mut at = pair[0];
            while at != pair[1] {
                let heading = Heading::ALL.into_iter().find(|&heading| leads(at, heading, pair[1]))?;
                way.cell(heading)?;
                at = at.step(heading);
            }
        }
        Some(way.end())
    }

    /// The letters of this drive.
    #[must_use]
    pub fn list(&self, corners: Corners) -> TurnList {
        let listed = |turn: Turn, letter: Option<usize>| match corners {
            Corners::LeftOut => letter.is_some(),
            Corners::Listed => letter.is_some() || turn != Turn::Straight,
        };
        let start = Some(self.start_turn).filter(|&turn| listed(turn, self.start_letter));
        let legs = self.legs.iter().filter_map(|leg| leg.turn.filter(|&turn| listed(turn, leg.letter)));
        start.into_iter().chain(legs).collect()
    }

    /// The drive to a stop, from 1.
    #[must_use]
    pub fn leg(&self, stop: u32) -> Option<Leg> {
        self.legs.get((stop as usize).checked_sub(1)?).copied()
    }

    /// What the drive is made of.
    #[must_use]
    pub fn tally(&self) -> Tally {
        self.legs.iter().fold(Tally::default().turned(self.start_turn), |tally, leg| {
            let tally = tally.driven(leg.cells);
            leg.turn.map_or(tally, |turn| tally.turned(turn))
        })
    }

    /// Cells from start to finish.
    #[must_use]
    pub fn cells(&self) -> u32 {
        self.tally().cells
    }

    /// Seconds that the robot takes: driving, every turn and every stop.
    #[must_use]
    pub fn seconds(&self, cell_mm: f64, pace: &Pace) -> f64 {
        self.tally().seconds(cell_mm, pace)
    }
}

/// Whether a point lies straight ahead.
const fn leads(at: Point, heading: Heading, to: Point) -> bool {
    match heading {
        Heading::North => at.x == to.x && at.y < to.y,
        Heading::East => at.y == to.y && at.x < to.x,
        Heading::South => at.x == to.x && at.y > to.y,
        Heading::West => at.y == to.y && at.x > to.x,
    }
}

/// A drive that grows cell by cell.
struct Way<'m> {
    floor: Floor<'m>,
    route: Route,
    at: Point,
    heading: Heading,
    /// Cells since the last stop.
    cells: u32,
    letters: usize,
}

impl<'m> Way<'m> {
    const fn new(maze: &'m Maze, start: Start) -> Self {
        let floor = Floor::new(maze, start.at);
        let route =
            Route { start: start.at, start_turn: Turn::Straight, start_letter: None, legs: Vec::new() };
        Self { floor, route, at: start.at, heading: start.heading, cells: 0, letters: 0 }
    }

    /// Drives one cell on; none where there is no line.
    fn cell(&mut self, heading: Heading) -> Option<()> {
        if !self.floor.maze.has_line(self.at, heading) {
            return None;
        }
        let turn = self.heading.turn_to(heading);
        let choice = self.floor.is_choice(self.at);
        if self.cells == 0 && self.route.legs.is_empty() {
            self.route.start_turn = turn;
            self.route.start_letter = choice.then(|| self.next_letter());
        } else if turn != Turn::Straight || self.floor.is_stop(self.at, self.heading) {
            let letter = (choice || turn == Turn::Back).then(|| self.next_letter());
            self.stop(Some(turn), letter);
        }
        (self.at, self.heading, self.cells) = (self.at.step(heading), heading, self.cells + 1);
        Some(())
    }

    const fn next_letter(&mut self) -> usize {
        self.letters += 1;
        self.letters
    }

    fn stop(&mut self, turn: Option<Turn>, letter: Option<usize>) {
        self.route.legs.push(Leg { at: self.at, heading: self.heading, cells: self.cells, turn, letter });
        self.cells = 0;
    }

    fn end(mut self) -> Route {
        if self.cells > 0 {
            self.stop(None, None);
        }
        self.route
    }
}

/// Round 2 can be played; its stops are the legs. A cell takes as long as `cell_ms` says.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Drive {
    /// What is driven.
    pub route: Route,
    /// Milliseconds for a cell.
    pub cell_ms: u32,
}

impl Timeline for Drive {
    fn stops(&self) -> u32 {
        self.route.legs.len() as u32
    }

    fn lines(&self, _: u32) -> u8 {
        1
    }

    fn drive_ms(&self, stop: u32) -> u32 {
        self.route.leg(stop).map_or(0, |leg| leg.cells * self.cell_ms)
    }

    fn mark(&self, stop: u32) -> Mark {
        match self.route.leg(stop) {
            Some(Leg { turn: None, .. }) => Mark::End,
            Some(Leg { letter: Some(_), .. }) => Mark::Node,
            _ => Mark::Plain,
        }
    }
}
