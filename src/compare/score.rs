//! What a run comes to, in numbers: a row of the comparison's table.

use alloc::string::{String, ToString};

use core::cmp::Ordering;

use super::words::ended;
use crate::event::Outcome;
use crate::explorer::name::Name;
use crate::maze::Maze;
use crate::report::book_memory_bytes;
use crate::route::best::{self, Best};
use crate::route::tally::Tally;
use crate::route::{Route, Strayed};
use crate::run::AnyRun;
use crate::settings::Settings;

/// The best routes of a maze, which every run in it is measured by.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Bests {
    /// The shortest; none where no way leads to the finish.
    pub shortest: Option<Best>,
    /// The quickest.
    pub fastest: Option<Best>,
}

impl Bests {
    /// Looks for both.
    #[must_use]
    pub fn of(maze: &Maze, settings: &Settings) -> Self {
        let start = maze.start();
        Self {
            shortest: start.and_then(|start| best::shortest(maze, start, &settings.pace)),
            fastest: start.and_then(|start| best::fastest(maze, start, &settings.pace)),
        }
    }
}

/// A run in numbers.
#[derive(Clone, Debug, PartialEq)]
pub struct Score {
    /// Who drove.
    pub name: Name,
    /// How it ended.
    pub outcome: Outcome,
    /// What the exploration is made of.
    pub tally: Tally,
    /// Seconds that it took.
    pub seconds: f64,
    /// The robot's peak memory, in the C types of the source.
    pub memory_bytes: u32,
    /// Length and time of the route, if it leads to the finish; else why not.
    pub route: Result<Best, NoRoute>,
    /// What the maze has at best.
    pub bests: Bests,
}

/// Why a run left no route.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum NoRoute {
    /// It did not get that far.
    Ended(Outcome),
    /// There is none to be found.
    NoFinish,
    /// It saw everything, and no finish.
    NotSeen,
    /// What it remembers does not lead there.
    Strayed(Strayed),
}

impl Score {
    /// What a run came to.
    #[must_use]
    pub fn of(maze: &Maze, settings: &Settings, run: &AnyRun, bests: Bests) -> Self {
        let cell_mm = maze.scale.cell_mm();
        let tally = run.total();
        let best = |route: Route| {
            let tally = route.tally();
            Best { cells: tally.cells, seconds: tally.seconds(cell_mm, &settings.pace) }
        };
        Self {
            name: run.name(),
            outcome: run.outcome(),
            tally,
            seconds: tally.seconds(cell_mm, &settings.pace),
            memory_bytes: match run {
                AnyRun::Book(run) => book_memory_bytes(run.trace()),
                AnyRun::Other(run) => run.last().robot().peak_bytes(),
            },
            route: solved(maze, run).map(best),
            bests,
        }
    }

    /// Whether it left a route to the finish.
    #[must_use]
    pub const fn is_solved(&self) -> bool {
        self.route.is_ok()
    }

    /// Why it failed: how the run ended, if not well, or why it left no route. A run that fails can still know a
    /// way to the finish.
    #[must_use]
    pub fn reason(&self) -> Option<String> {
        why_failed(self.outcome, self.route.err())
    }

    /// How it ended, in a word or two.
    #[must_use]
    pub fn ended(&self) -> String {
        match (self.outcome, self.route) {
            (Outcome::NoFinishReachable, Err(NoRoute::NoFinish)) => String::from("no finish"),
            (outcome, _) => ended(outcome),
        }
    }

    /// The route's cells over the shortest's.
    #[must_use]
    pub fn ratio_shortest(&self) -> Option<f64> {
        let (ours, best) = (self.route.ok()?, self.bests.shortest?);
        (best.cells > 0).then(|| f64::from(ours.cells) / f64::from(best.cells))
    }

    /// The route's seconds over the quickest's.
    #[must_use]
    pub fn ratio_fastest(&self) -> Option<f64> {
        let (ours, best) = (self.route.ok()?, self.bests.fastest?);
        (best.seconds > 0.0).then(|| ours.seconds / best.seconds)
    }

    /// The number in a column; none where there is nothing to say.
    #[must_use]
    pub fn number(&self, column: Column) -> Option<f64> {
        match column {
            Column::Distance => Some(f64::from(self.tally.cells)),
            Column::Stops => Some(f64::from(self.tally.stops)),
            Column::Turns => Some(f64::from(self.tally.turns())),
            Column::Seconds => Some(self.seconds),
            Column::Memory => Some(f64::from(self.memory_bytes)),
            Column::Route => self.route.ok().map(|route| f64::from(route.cells)),
            Column::RouteSeconds => self.route.ok().map(|route| route.seconds),
            Column::RatioShortest => self.ratio_shortest(),
            Column::RatioFastest => self.ratio_fastest(),
        }
    }
}

/// A column of numbers, all of them better when they are small.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Column {
    /// Cells of the exploration.
    Distance,
    /// Its stops.
    Stops,
    /// Its turns of any kind.
    Turns,
    /// Its seconds.
    Seconds,
    /// Bytes on the robot.
    Memory,
    /// Cells of the route.
    Route,
    /// Its seconds.
    RouteSeconds,
    /// Its cells over the shortest's.
    RatioShortest,
    /// Its seconds over the quickest's.
    RatioFastest,
}

impl Column {
    /// All of them, in the table's order.
    pub const ALL: [Self; 9] = [
        Self::Distance,
        Self::Stops,
        Self::Turns,
        Self::Seconds,
        Self::Memory,
        Self::Route,
        Self::RouteSeconds,
        Self::RatioShortest,
        Self::RatioFastest,
    ];

    /// Its head.
    #[must_use]
    pub const fn title(self) -> &'static str {
        match self {
            Self::Distance => "cells",
            Self::Stops => "stops",
            Self::Turns => "turns",
            Self::Seconds => "seconds",
            Self::Memory => "bytes",
            Self::Route => "route",
            Self::RouteSeconds => "route s",
            Self::RatioShortest => "× shortest",
            Self::RatioFastest => "× fastest",
        }
    }

    /// Orders two scores by this column, the least first; those without a number come last.
    #[must_use]
    pub fn order(self, a: &Score, b: &Score) -> Ordering {
        let or_last = |score: &Score| score.number(self).unwrap_or(f64::INFINITY);
        or_last(a).total_cmp(&or_last(b))
    }
}

/// The drive that a run's memory makes, if it leads to the finish: round 2 of any explorer.
///
/// # Errors
/// Why there is none.
pub fn solved(maze: &Maze, run: &AnyRun) -> Result<Route, NoRoute> {
    judged(maze, run.way(maze).map(|way| way.route), run.outcome())
}

/// The drive of a run that ended so, if it leads to the finish.
pub(crate) fn judged(
    maze: &Maze,
    drive: Option<Result<Route, Strayed>>,
    outcome: Outcome,
) -> Result<Route, NoRoute> {
    if maze.finish().is_empty() {
        return Err(NoRoute::NoFinish);
    }
    match (drive, outcome) {
        (Some(Ok(route)), _) => {
            let end = route.legs.last().map_or(route.start, |leg| leg.at);
            if maze.is_finish(end) { Ok(route) } else { Err(NoRoute::NotSeen) }
        }
        (Some(Err(strayed)), _) => Err(NoRoute::Strayed(strayed)),
        (None, Outcome::Finish | Outcome::Mapped) => Err(NoRoute::NotSeen),
        (
            None,
            other @ (Outcome::NoFinishReachable
            | Outcome::Circling { .. }
            | Outcome::Stuck
            | Outcome::PathFull { .. }
            | Outcome::TableFull { .. }
            | Outcome::NoLine { .. }
            | Outcome::TooManyStops { .. }
            | Outcome::Cut(_)),
        ) => Err(NoRoute::Ended(other)),
    }
}

/// Why a run that ended so failed: table and report say the same.
pub(crate) fn why_failed(outcome: Outcome, no_route: Option<NoRoute>) -> Option<String> {
    match (outcome, no_route) {
        (Outcome::Finish | Outcome::Mapped, why) => why.map(|why| why.to_string()),
        (Outcome::NoFinishReachable, Some(why @ NoRoute::NoFinish)) => Some(why.to_string()),
        (other, _) => Some(other.to_string()),
    }
}

/// How a run through this maze ended: a finish that there is none of is not called out of reach.
#[must_use]
pub fn told(maze: &Maze, outcome: Outcome) -> String {
    match outcome {
        Outcome::NoFinishReachable if maze.finish().is_empty() => NoRoute::NoFinish.to_string(),
        other => other.to_string(),
    }
}

impl core::fmt::Display for NoRoute {
    fn fmt(&self, f: &mut core::fmt::Formatter<'_>) -> core::fmt::Result {
        match self {
            Self::Ended(outcome) => outcome.fmt(f),
            Self::NoFinish => f.write_str("the file names no finish"),
            Self::NotSeen => f.write_str("everything is mapped, and no finish was seen"),
            Self::Strayed(strayed) => strayed.fmt(f),
        }
    }
}
