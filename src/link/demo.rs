//! The virtual robot: the robot's end over an ideal world, with a memory, a boot, and a wire of finite speed.
//!
//! The page's *Demo robot*, the tests' robot and `linemaze robot` are this one.

use alloc::boxed::Box;
use alloc::collections::VecDeque;
use alloc::vec::Vec;

use super::robot::Robot;
use crate::maze::Maze;
use crate::settings::NODE_MAX;
use crate::world::CannotStart;

mod body;
mod eeprom;
mod faults;

pub use body::IdealBody;
pub use eeprom::{Eeprom, SIZE};
pub use faults::Faults;

/// From a reset to the first byte: an Uno's bootloader waits about so long.
pub const BOOT_MS: u64 = 1_000;

/// A tick does at most this much at once.
const STEP_MS: u64 = 5;
/// More than this is slept through.
const LONGEST_SLEEP_MS: u64 = 10_000;

/// A robot without hardware. Time is milliseconds on any clock that never goes back.
#[derive(Debug)]
pub struct DemoRobot {
    power: Power,
    /// When the last byte was spoken, in microseconds; a byte takes ten bits.
    wire_us: u64,
    baud: u32,
    faults: Option<Box<Faults>>,
    /// Bytes on their way to the page, and when they arrive.
    on_the_way: VecDeque<(u64, u8)>,
    ticked_ms: u64,
}

type Mind = Robot<IdealBody, Eeprom, { NODE_MAX as usize }>;

#[derive(Debug)]
enum Power {
    /// In the bootloader: deaf and mute until then.
    Booting { until_ms: u64, body: Box<IdealBody>, eeprom: Eeprom },
    /// Alive since then.
    On { since_ms: u64, robot: Box<Mind> },
    /// Between two states; never seen.
    Switching,
}

impl DemoRobot {
    /// A robot at the start of this maze, switched on now, with a fresh memory.
    ///
    /// # Errors
    /// Where it cannot be put down at the start.
    pub fn new(maze: &Maze, now_ms: u64) -> Result<Self, CannotStart> {
        Self::with_memory(maze, Eeprom::default(), now_ms)
    }

    /// The same with a memory that holds something.
    ///
    /// # Errors
    /// As [`DemoRobot::new`].
    pub fn with_memory(maze: &Maze, eeprom: Eeprom, now_ms: u64) -> Result<Self, CannotStart> {
        let body = Box::new(IdealBody::new(maze)?);
        let power = Power::Booting { until_ms: now_ms + BOOT_MS, body, eeprom };
        let wire_us = now_ms * 1000;
        let on_the_way = VecDeque::new();
        Ok(Self { power, wire_us, baud: 115_200, faults: None, on_the_way, ticked_ms: now_ms })
    }

    /// The same on a wire of this speed.
    #[must_use]
    pub const fn at_baud(mut self, baud: u32) -> Self {
        self.baud = if baud == 0 { 1 } else { baud };
        self
    }

    /// The same with faults, reproducible by their seed.
    #[must_use]
    pub fn with_faults(mut self, seed: u64) -> Self {
        self.faults = Some(Box::new(Faults::new(seed)));
        self
    }

    /// The reset line is pulled, as opening the port of an Uno does; what it keeps stays.
    pub fn reset(&mut self, now_ms: u64) {
        self.on_the_way.clear();
        let until_ms = now_ms + BOOT_MS;
        self.power = match core::mem::replace(&mut self.power, Power::Switching) {
            Power::Booting { body, eeprom, .. } => Power::Booting { until_ms, body, eeprom },
            Power::On { robot, .. } => {
                let (body, eeprom) = robot.power_off();
                Power::Booting { until_ms, body: Box::new(body), eeprom }
            }
            Power::Switching => Power::Switching,
        };
    }

    /// The robot is on at once, without a word until it is spoken to: as one behind a Bluetooth module.
    pub fn wake(&mut self, now_ms: u64) {
        self.boot(now_ms);
        if let Power::On { robot, .. } = &mut self.power {
            robot.hush();
            while robot.speak().is_some() {}
        }
    }

    /// Says nothing unasked from now on, if it is on.
    pub fn hush(&mut self) {
        if let Power::On { robot, .. } = &mut self.power {
            robot.hush();
        }
    }

    /// Whether it is on and has room for the answer to another request.
    #[must_use]
    pub fn takes_more(&self) -> bool {
        self.mind().is_some_and(Robot::has_room)
    }

    /// Whether it is on and does not drive.
    #[must_use]
    pub fn stands(&self) -> bool {
        self.mind().is_some_and(Robot::stands)
    }

    /// Whether it is on, stands, and has said everything.
    #[must_use]
    pub fn is_done(&self) -> bool {
        self.on_the_way.is_empty() && self.mind().is_some_and(|robot| robot.stands() && robot.is_silent())
    }

    /// Where it is in the maze.
    #[must_use]
    pub fn body(&mut self) -> Option<&mut IdealBody> {
        match &mut self.power {
            Power::Booting { body, .. } => Some(body),
            Power::On { robot, .. } => Some(robot.body()),
            Power::Switching => None,
        }
    }

    /// What it would keep if the power went now.
    #[must_use]
    pub fn eeprom(&self) -> Option<&Eeprom> {
        match &self.power {
            Power::Booting { eeprom, .. } => Some(eeprom),
            Power::On { robot, .. } => Some(robot.keep().memory()),
            Power::Switching => None,
        }
    }

    /// The robot's end, while it is on.
    #[must_use]
    pub fn mind(&self) -> Option<&Mind> {
        match &self.power {
            Power::On { robot, .. } => Some(robot),
            Power::Booting { .. } | Power::Switching => None,
        }
    }

    /// Bytes from the page.
    pub fn bytes_in(&mut self, bytes: &[u8], now_ms: u64) {
        self.boot_when_due(now_ms);
        for &byte in bytes {
            let heard = match &mut self.faults {
                None => [Some(byte), None],
                Some(faults) => faults.towards_robot(byte, now_ms),
            };
            if let Power::On { since_ms, robot } = &mut self.power {
                for byte in heard.into_iter().flatten() {
                    robot.hear(byte, (now_ms - *since_ms) as u32);
                }
            }
        }
    }

    /// Lets time pass up to now; the bytes that have arrived at the page meanwhile.
    pub fn tick(&mut self, now_ms: u64) -> Vec<u8> {
        // A page in the background is seldom woken: what happened meanwhile happens step by step.
        self.ticked_ms = self.ticked_ms.max(now_ms.saturating_sub(LONGEST_SLEEP_MS));
        while self.ticked_ms < now_ms {
            self.ticked_ms = now_ms.min(self.ticked_ms + STEP_MS);
            self.step(self.ticked_ms);
        }
        let mut arrived = Vec::new();
        while let Some(&(due_ms, byte)) = self.on_the_way.front() {
            if due_ms > now_ms {
                break;
            }
            self.on_the_way.pop_front();
            arrived.push(byte);
        }
        arrived
    }

    fn step(&mut self, now_ms: u64) {
        self.boot_when_due(now_ms);
        if self.faults.as_mut().is_some_and(|faults| faults.resets(now_ms)) {
            self.reset(now_ms);
        }
        let byte_us = 10_000_000 / u64::from(self.baud);
        if let Power::On { since_ms, robot } = &mut self.power {
            // Bytes that came first may have woken it later than this step.
            let robot_ms = now_ms.saturating_sub(*since_ms) as u32;
            robot.tick(robot_ms);
            // What the wire did not carry while nobody spoke is lost time.
            self.wire_us = self.wire_us.max((now_ms * 1000).saturating_sub(1000 * STEP_MS + byte_us));
            while self.wire_us + byte_us <= now_ms * 1000 {
                let Some(byte) = robot.speak() else { break };
                self.wire_us += byte_us;
                robot.tick(robot_ms);
                match &mut self.faults {
                    None => self.on_the_way.push_back((now_ms, byte)),
                    Some(faults) => faults.towards_page(byte, now_ms, &mut self.on_the_way),
                }
            }
        }
        if let Some(faults) = &mut self.faults {
            faults.flood(now_ms, &mut self.on_the_way);
        }
    }

    fn boot_when_due(&mut self, now_ms: u64) {
        if matches!(self.power, Power::Booting { until_ms, .. } if until_ms <= now_ms) {
            self.boot(now_ms);
        }
    }

    fn boot(&mut self, now_ms: u64) {
        self.power = match core::mem::replace(&mut self.power, Power::Switching) {
            Power::Booting { body, eeprom, .. } => {
                Power::On { since_ms: now_ms, robot: Box::new(Robot::boot(*body, eeprom, 0)) }
            }
            on @ (Power::On { .. } | Power::Switching) => on,
        };
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::maze::samples;

    #[test]
    fn bytes_may_wake_it_before_time_is_told() {
        let mut robot = DemoRobot::new(&samples::figure_3_1(), 0).unwrap();
        robot.tick(BOOT_MS - 20);
        robot.bytes_in(b"\nhi\n", BOOT_MS + 40);
        let said = (0..100).flat_map(|i| robot.tick(BOOT_MS + 41 + i)).collect::<Vec<u8>>();
        assert!(said.starts_with(b"ready 1 "));
    }
}
