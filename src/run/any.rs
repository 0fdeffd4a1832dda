//! A run, whoever drove: the book's explorer leaves a [`Trace`], every other one a [`Recording`].

use crate::event::Outcome;
use crate::explorer::mind::Plan;
use crate::explorer::name::{Name, Seeks};
use crate::geometry::{Point, Turn};
use crate::maze::Maze;
use crate::playback::{Mark, Timeline};
use crate::recording::Recording;
use crate::route::tally::Tally;
use crate::route::{Corners, Route, Strayed, TurnList};
use crate::trace::Trace;

/// A run.
// There are few, and they are seldom moved: a box would only be in the way.
#[allow(clippy::large_enum_variant)]
#[derive(Clone, Debug)]
pub enum AnyRun {
    /// Of the book's explorer.
    Book(BookRun),
    /// Of any other.
    Other(Recording),
}

/// A run of the book's explorer, with the counts of its drive.
#[derive(Clone, Debug)]
pub struct BookRun {
    trace: Trace,
    cell_ms: u32,
    tallies: alloc::vec::Vec<Tally>,
}

/// What a run leaves for round 2.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Way {
    /// The letters.
    pub list: TurnList,
    /// The drive, or where the letters lead instead of the finish.
    pub route: Result<Route, Strayed>,
}

/// Stops between two counts of the drive.
const TALLY_EVERY: usize = 64;

impl BookRun {
    pub(super) fn new(trace: Trace, cell_ms: u32) -> Self {
        let mut run = Self { trace, cell_ms: cell_ms.max(1), tallies: alloc::vec![Tally::NONE] };
        for key in 1..=run.trace.steps().len() / TALLY_EVERY {
            let tally = run.tally((key * TALLY_EVERY) as u32);
            run.tallies.push(tally);
        }
        run
    }

    /// The whole trace.
    #[must_use]
    pub const fn trace(&self) -> &Trace {
        &self.trace
    }

    /// Milliseconds that a cell takes, at least 1.
    #[must_use]
    pub const fn cell_ms(&self) -> u32 {
        self.cell_ms
    }

    /// What was driven up to the arrival at a stop.
    fn tally(&self, stop: u32) -> Tally {
        let steps = self.trace.steps();
        let stop = (stop as usize).min(steps.len());
        let key = (stop / TALLY_EVERY).min(self.tallies.len() - 1);
        let mut tally = self.tallies[key];
        for at in key * TALLY_EVERY..stop {
            if let Some(turn) = at.checked_sub(1).and_then(|before| steps[before].turn()) {
                tally = tally.turned(turn);
            }
            tally = tally.driven(steps[at].time_diff() / self.cell_ms);
        }
        tally
    }
}

impl AnyRun {
    /// Who drove.
    #[must_use]
    pub const fn name(&self) -> Name {
        match self {
            Self::Book(_) => Name::Book,
            Self::Other(run) => run.name(),
        }
    }

    /// How the run ended.
    #[must_use]
    pub const fn outcome(&self) -> Outcome {
        match self {
            Self::Book(run) => run.trace.outcome(),
            Self::Other(run) => run.outcome(),
        }
    }

    /// What was driven up to the arrival at a stop: the turns of the stops before it are in it, its own is
    /// not. Costs the same at any stop.
    #[must_use]
    pub fn tally(&self, stop: u32) -> Tally {
        match self {
            Self::Book(run) => run.tally(stop),
            Self::Other(run) => run.tally(stop),
        }
    }

    /// What was driven in all.
    #[must_use]
    pub fn total(&self) -> Tally {
        let tally = self.tally(self.stops());
        self.turn(self.stops()).map_or(tally, |turn| tally.turned(turn))
    }

    /// The turn made at a stop; none where the robot stayed, and at the book's start.
    #[must_use]
    pub fn turn(&self, stop: u32) -> Option<Turn> {
        match self {
            Self::Book(run) => run.trace.step(stop)?.turn(),
            Self::Other(run) => run.step(stop).turn(),
        }
    }

    /// What the run leaves for round 2; none where it found no finish.
    #[must_use]
    pub fn way(&self, maze: &Maze) -> Option<Way> {
        let run = match self {
            Self::Book(run) => {
                let list = TurnList::of(&run.trace)?;
                return Some(Way { route: Route::drive(maze, &list), list });
            }
            Self::Other(run) => run,
        };
        match (run.name().about().seeks, run.outcome()) {
            (Seeks::Map, _) | (Seeks::Finish, Outcome::Finish) => {}
            (Seeks::Finish, _) => return None,
        }
        let start = run.start();
        Some(match run.last().robot().plan()? {
            Plan::Letters(letters) => {
                let list = letters.into_iter().collect();
                Way { route: Route::drive_from(maze, start, &list), list }
            }
            Plan::Places(places) => {
                let on_floor = |place: Point| {
                    let off = place.out_of_frame_of(start.heading);
                    Point::new(start.at.x + off.x, start.at.y + off.y)
                };
                let points: alloc::vec::Vec<Point> = places.into_iter().map(on_floor).collect();
                let route = Route::through(maze, start, &points);
                let list = route.as_ref().map(|route| route.list(Corners::LeftOut)).unwrap_or_default();
                Way { list, route: route.ok_or(Strayed::NoLine { letter: 0, at: start.at }) }
            }
        })
    }

    /// The first stop at which the robot has driven so many cells; the last stop if it never does.
    #[must_use]
    pub fn stop_at_cells(&self, cells: u32) -> u32 {
        self.first(|tally| tally.cells >= cells)
    }

    /// The first stop whose arrival makes this true, which then must stay true; the last stop if none does.
    #[must_use]
    pub fn first(&self, reached: impl Fn(Tally) -> bool) -> u32 {
        let (mut least, mut most) = (0, self.stops());
        while least < most {
            let middle = least + (most - least) / 2;
            if reached(self.tally(middle)) { most = middle } else { least = middle + 1 }
        }
        least
    }
}

impl Timeline for AnyRun {
    fn stops(&self) -> u32 {
        match self {
            Self::Book(run) => run.trace.stops(),
            Self::Other(run) => run.stops(),
        }
    }

    fn lines(&self, stop: u32) -> u8 {
        match self {
            Self::Book(run) => run.trace.lines(stop),
            Self::Other(run) => run.lines(stop),
        }
    }

    fn drive_ms(&self, stop: u32) -> u32 {
        match self {
            Self::Book(run) => run.trace.drive_ms(stop),
            Self::Other(run) => run.drive_ms(stop),
        }
    }

    fn mark(&self, stop: u32) -> Mark {
        match self {
            Self::Book(run) => run.trace.mark(stop),
            Self::Other(run) => run.mark(stop),
        }
    }
}
