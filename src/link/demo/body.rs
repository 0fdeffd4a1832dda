//! The virtual robot's wheels and eyes: an ideal world in real time, with plausible sensor readings.

use super::super::report::Ir;
use super::super::robot::{Body, Progress};
use super::super::tune::{Name, Tune};
use crate::event::Sighting;
use crate::geometry::{Heading, Point, Turn};
use crate::maze::{Maze, Start};
use crate::settings::MAX_CELL_MS;
use crate::world::{CannotStart, Ideal, World, line_start};

/// A full battery.
const FULL_MV: u32 = 7_400;

/// A line robot that never slips.
#[derive(Clone, Debug)]
pub struct IdealBody {
    maze: Maze,
    start: Start,
    at: Point,
    heading: Heading,
    tune: Tune,
    drive: Drive,
    chance: oorandom::Rand32,
}

#[derive(Clone, Copy, Debug)]
enum Drive {
    Standing,
    Driving { from_ms: u32, turn: Turn, turn_ms: u32, goal: Result<Sighting, ()> },
}

impl IdealBody {
    /// A robot at the start of a maze.
    ///
    /// # Errors
    /// Where it cannot be put down there.
    pub fn new(maze: &Maze) -> Result<Self, CannotStart> {
        let start = line_start(maze)?;
        Ok(Self {
            maze: maze.clone(),
            start,
            at: start.at,
            heading: start.heading,
            tune: Tune::default(),
            drive: Drive::Standing,
            chance: oorandom::Rand32::new(7),
        })
    }

    /// The stop that it stands at, or drives to.
    #[must_use]
    pub const fn at(&self) -> Point {
        self.at
    }

    /// Milliseconds that a cell takes at the speed that is set.
    #[must_use]
    pub fn cell_ms(&self) -> u32 {
        let speed = f64::from(self.tune.get(Name::Speed).max(1));
        ((self.maze.scale.cell_mm() * 1000.0 / speed + 0.5) as u32).clamp(2, MAX_CELL_MS)
    }

    fn turn_ms(&self, turn: Turn) -> u32 {
        match turn {
            Turn::Straight => 0,
            Turn::Right | Turn::Left => self.tune.get(Name::Turn).unsigned_abs(),
            Turn::Back => self.tune.get(Name::Uturn).unsigned_abs(),
        }
    }

    /// A reading near a value.
    fn near(&mut self, value: u16, spread: u32) -> u16 {
        (value + self.chance.rand_range(0..spread) as u16).min(1023)
    }
}

impl Body for IdealBody {
    const FIRMWARE: &'static str = "lab-1";
    const BOARD: &'static str = "demo";

    fn tuned(&mut self, tune: &Tune) {
        self.tune = *tune;
    }

    fn placed(&mut self) {
        (self.at, self.heading) = (self.start.at, self.start.heading);
        self.drive = Drive::Standing;
    }

    fn drive(&mut self, turn: Turn, now_ms: u32) {
        let here = Start { at: self.at, heading: self.heading };
        let mut world = Ideal::new(&self.maze, here, self.cell_ms());
        let goal = world.drive(turn).map_err(|_| ());
        let place = (world.at(), world.heading());
        let turn_ms = self.turn_ms(turn);
        self.drive = Drive::Driving { from_ms: now_ms, turn, turn_ms, goal };
        (self.at, self.heading) = place;
    }

    fn progress(&mut self, now_ms: u32) -> Progress {
        let Drive::Driving { from_ms, turn_ms, goal, .. } = self.drive else { return Progress::Driving };
        let driven_ms = goal.map_or(0, |sighting| sighting.time_diff);
        if now_ms.wrapping_sub(from_ms) < turn_ms.saturating_add(driven_ms) {
            return Progress::Driving;
        }
        self.drive = Drive::Standing;
        goal.map_or(Progress::NoLine, Progress::Stop)
    }

    fn halt(&mut self, _: u32) {
        self.drive = Drive::Standing;
    }

    fn senses(&mut self, now_ms: u32) -> Ir {
        let (mut sensors, mut error, mut motors) = ([0; 5], 0i16, (0, 0));
        let cruise = (self.tune.get(Name::Speed) / 4).clamp(40, 200) as i16;
        if let Drive::Driving { from_ms, turn, turn_ms, .. } = self.drive {
            if now_ms.wrapping_sub(from_ms) < turn_ms {
                motors = match turn {
                    Turn::Straight => (cruise, cruise),
                    Turn::Right | Turn::Back => (cruise, -cruise),
                    Turn::Left => (-cruise, cruise),
                };
            } else {
                // The line wanders a little under the middle sensor, and the controller answers.
                error = self.chance.rand_range(0..241) as i16 - 120;
                let correction = (i32::from(error) * self.tune.get(Name::Kp) / 10_000).clamp(-50, 50) as i16;
                motors = (cruise + correction, cruise - correction);
            }
        }
        let beside = error.unsigned_abs() / 2;
        let dark = [0, if error < 0 { beside } else { 0 }, 740, if error > 0 { beside } else { 0 }, 0];
        for (sensor, dark) in sensors.iter_mut().zip(dark) {
            *sensor = self.near(dark + 30, 12);
        }
        let line = (2000 + error) as u16;
        Ir { ms: now_ms, line, sensors, error, left: motors.0, right: motors.1 }
    }

    fn millivolts(&mut self, now_ms: u32) -> u16 {
        // A millivolt in four seconds, as two small cells do at this load.
        (FULL_MV - (now_ms / 4_000).min(1_400)) as u16
    }
}
