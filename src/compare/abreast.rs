//! Runs abreast: where each robot is after the same distance, or at the same time by the cost model. A place is
//! found by binary search, so any moment of the longest run costs the same.

use super::Path;
use crate::geometry::{Heading, Turn};
use crate::maze::Maze;
use crate::playback::Timeline;
use crate::run::AnyRun;
use crate::scene::Pose;
use crate::settings::Pace;

/// What runs are held equal by.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Clock {
    /// Cells driven.
    Cells(f64),
    /// Seconds since the start.
    Seconds(f64),
}

/// Where a robot is.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Position {
    /// The last stop that it came to.
    pub stop: u32,
    /// How much of the way to the next one it has driven, 0 to 1; 0 at the end.
    pub along: f64,
    /// On the floor.
    pub pose: Pose,
}

/// Where a robot is at a moment; at its end when that is past.
///
/// ```
/// use line_maze_lab::compare::abreast::{Clock, at};
/// use line_maze_lab::explorer::name::Name;
/// use line_maze_lab::{maze::samples, run::record, settings::Settings};
/// let (maze, settings) = (samples::figure_3_1(), Settings::default());
/// let run = record(&maze, &settings, Name::RightHand)?;
/// let here = at(&maze, &run, &settings.pace, Clock::Cells(2.5)).unwrap();
/// assert_eq!((here.stop, here.along), (1, 0.75));
/// assert_eq!((here.pose.x, here.pose.y), (1.5, 1.0));
/// # Ok::<(), line_maze_lab::world::CannotStart>(())
/// ```
#[must_use]
pub fn at(maze: &Maze, run: &AnyRun, pace: &Pace, clock: Clock) -> Option<Position> {
    let path = Path { run, start: maze.start()? };
    let cell_mm = maze.scale.cell_mm();
    Some(match clock {
        Clock::Cells(cells) => {
            // Up to where more than that is driven.
            let stop = last(run, |tally| f64::from(tally.cells) <= cells);
            let from = f64::from(run.tally(stop).cells);
            let leg = f64::from(run.tally(stop + 1).cells) - from;
            path.position(stop, 1.0, if leg > 0.0 { (cells - from) / leg } else { 0.0 })
        }
        Clock::Seconds(seconds) => {
            let stop = last(run, |tally| tally.seconds(cell_mm, pace) <= seconds);
            let passed = seconds - run.tally(stop).seconds(cell_mm, pace);
            let turning = turning(run, pace, stop);
            let leg = f64::from(run.tally(stop + 1).cells - run.tally(stop).cells);
            let driving = leg * cell_mm / pace.speed_mm_s;
            let turned = if turning > 0.0 { (passed / turning).min(1.0) } else { 1.0 };
            let along = if driving > 0.0 { (passed - turning) / driving } else { 0.0 };
            path.position(stop, turned, along)
        }
    })
}

/// The most that the clock can show: cells or seconds of the whole run.
#[must_use]
pub fn total(maze: &Maze, run: &AnyRun, pace: &Pace) -> (f64, f64) {
    let tally = run.tally(run.stops());
    (f64::from(tally.cells), tally.seconds(maze.scale.cell_mm(), pace))
}

/// The next moment at which any of the runs has come to a stop and turned there; none where all are at their ends.
///
/// ```
/// use line_maze_lab::compare::abreast::{Clock, before, next};
/// use line_maze_lab::explorer::name::Name;
/// use line_maze_lab::{maze::samples, run::record, settings::Settings};
/// let (maze, settings) = (samples::figure_3_1(), Settings::default());
/// let runs = [&record(&maze, &settings, Name::LeftHand)?, &record(&maze, &settings, Name::RightHand)?];
/// assert_eq!(next(&maze, runs, &settings.pace, Clock::Cells(0.5)), Some(Clock::Cells(1.0)));
/// assert_eq!(before(&maze, runs, &settings.pace, Clock::Cells(1.0)), Some(Clock::Cells(0.0)));
/// # Ok::<(), line_maze_lab::world::CannotStart>(())
/// ```
#[must_use]
pub fn next<'r>(
    maze: &Maze,
    runs: impl IntoIterator<Item = &'r AnyRun>,
    pace: &Pace,
    clock: Clock,
) -> Option<Clock> {
    let face = Face { clock, cell_mm: maze.scale.cell_mm(), pace };
    // The robot may still turn at the stop that it came to last.
    let after = |run: &AnyRun| {
        let here = last(run, |tally| face.read(tally) <= clock.value());
        let settled = face.of(run, here);
        if settled > clock.value() { settled } else { face.of(run, (here + 1).min(run.stops())) }
    };
    let times = runs.into_iter().map(after).filter(|&time| time > clock.value());
    times.min_by(f64::total_cmp).map(|time| clock.with(time))
}

/// The last moment before this one at which any of the runs had come to a stop and turned there; none at the start.
#[must_use]
pub fn before<'r>(
    maze: &Maze,
    runs: impl IntoIterator<Item = &'r AnyRun>,
    pace: &Pace,
    clock: Clock,
) -> Option<Clock> {
    let face = Face { clock, cell_mm: maze.scale.cell_mm(), pace };
    let earlier = |run: &AnyRun| {
        let here = last(run, |tally| face.read(tally) < clock.value());
        let settled = face.of(run, here);
        if settled < clock.value() { settled } else { face.of(run, here.saturating_sub(1)) }
    };
    let times = runs.into_iter().map(earlier).filter(|&time| time < clock.value());
    times.max_by(f64::total_cmp).map(|time| clock.with(time))
}

impl Clock {
    /// Cells or seconds.
    #[must_use]
    pub const fn value(self) -> f64 {
        match self {
            Self::Cells(value) | Self::Seconds(value) => value,
        }
    }

    /// The same kind of clock at another time.
    #[must_use]
    pub const fn with(self, value: f64) -> Self {
        match self {
            Self::Cells(_) => Self::Cells(value),
            Self::Seconds(_) => Self::Seconds(value),
        }
    }

    /// What it shows when a run has come to a stop and turned there.
    #[must_use]
    pub fn at_stop(self, maze: &Maze, run: &AnyRun, pace: &Pace, stop: u32) -> Self {
        self.with(Face { clock: self, cell_mm: maze.scale.cell_mm(), pace }.of(run, stop))
    }
}

/// How a drive reads on the clock.
struct Face<'p> {
    clock: Clock,
    cell_mm: f64,
    pace: &'p Pace,
}

impl Face<'_> {
    fn read(&self, tally: crate::route::tally::Tally) -> f64 {
        match self.clock {
            Clock::Cells(_) => f64::from(tally.cells),
            Clock::Seconds(_) => tally.seconds(self.cell_mm, self.pace),
        }
    }

    /// When the robot has settled at a stop: its turn is made.
    fn of(&self, run: &AnyRun, stop: u32) -> f64 {
        let arrived = self.read(run.tally(stop));
        match self.clock {
            Clock::Cells(_) => arrived,
            Clock::Seconds(_) => arrived + turning(run, self.pace, stop),
        }
    }
}

/// Seconds that a robot turns at a stop before it drives on.
fn turning(run: &AnyRun, pace: &Pace, stop: u32) -> f64 {
    let turn = if stop < run.stops() { run.turn(stop) } else { None };
    turn.map_or(0.0, |turn| pace.seconds(turn))
}

/// The last stop for which this holds, which holds up to some stop and then no more.
fn last(run: &AnyRun, holds: impl Fn(crate::route::tally::Tally) -> bool) -> u32 {
    let beyond = run.first(|tally| !holds(tally));
    if holds(run.tally(beyond)) { beyond } else { beyond.saturating_sub(1) }
}

impl Path<'_> {
    /// After a stop, with so much of its turn and then of its drive done.
    fn position(self, stop: u32, turned: f64, along: f64) -> Position {
        let over = stop >= self.stops();
        let along = if over { 0.0 } else { along.clamp(0.0, 1.0) };
        let (from, arrived) = (self.place(stop), self.heading(stop));
        let to = if over { from } else { self.place(stop + 1) };
        let between = |a: i32, b: i32| f64::from(a) + f64::from(b - a) * along;
        let degrees = degrees(arrived, arrived.turn_to(self.faces(stop)), if over { 1.0 } else { turned });
        Position { stop, along, pose: Pose { x: between(from.x, to.x), y: between(from.y, to.y), degrees } }
    }
}

/// Degrees clockwise from north with so much of a turn done; may leave 0 to 360 while turning.
fn degrees(arrived: Heading, turn: Turn, turned: f64) -> f64 {
    let quarters = match turn {
        Turn::Straight => 0.0,
        Turn::Right => 1.0,
        Turn::Back => 2.0,
        Turn::Left => -1.0,
    };
    (f64::from(arrived.index()) + quarters * turned) * 90.0
}
