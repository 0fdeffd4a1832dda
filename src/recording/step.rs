//! A stop of a recording in 8 bytes.

use crate::event::{Decision, Finish, Home, Look, Sighting};
use crate::explorer::tell::Said;
use crate::geometry::{Heading, Point, Turn, Ways};

/// One stop: what the robot saw, where it was, and how it turned.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Step {
    /// From the lowest bit: ways 4, finish 1, home 2, turn 2, whether it drove on 1, heading 2, case 8,
    /// lines 5. The turn is kept also where the referee ended the run after it.
    packed: u32,
    /// Cells east and north of the lattice's south-west corner.
    east: u16,
    north: u16,
}

impl Step {
    const fn bits(self, shift: u32, count: u32) -> u32 {
        self.packed >> shift & ((1 << count) - 1)
    }

    pub(super) fn new(
        look: Look,
        at: Point,
        heading: Heading,
        [meant, done]: [Decision; 2],
        said: &Said,
    ) -> Self {
        let goes_on = matches!(done, Decision::Go(_));
        let turn = match meant {
            Decision::Go(turn) => u32::from(goes_on) << 2 | turn as u32,
            Decision::End(_) => 0,
        };
        let packed = u32::from(look.sighting.ways.bits())
            | u32::from(look.sighting.finish == Finish::Yes) << 4
            | (look.home as u32) << 5
            | turn << 7
            | u32::from(heading.index()) << 10
            | u32::from(said.case()) << 12
            | (said.lines().len() as u32) << 20;
        Self { packed, east: at.x as u16, north: at.y as u16 }
    }

    /// Cells east and north of the lattice's south-west corner.
    pub(super) const fn at(self) -> Point {
        Point::new(self.east as i32, self.north as i32)
    }

    /// The turn that the robot made; none where it stayed.
    #[must_use]
    pub const fn turn(self) -> Option<Turn> {
        if self.bits(9, 1) == 1 { Some(Turn::from_index(self.bits(7, 2) as u8)) } else { None }
    }

    /// The heading with which it arrived, in the drawing's frame.
    #[must_use]
    pub const fn heading(self) -> Heading {
        Heading::from_index(self.bits(10, 2) as u8)
    }

    /// The heading that it faces when the stop is over, in the drawing's frame: also where it made up its mind to turn
    /// and the referee ended the run.
    #[must_use]
    pub const fn faces(self) -> Heading {
        self.heading().turned(Turn::from_index(self.bits(7, 2) as u8))
    }

    /// The case's place in the explorer's table.
    #[must_use]
    pub const fn case(self) -> u8 {
        self.bits(12, 8) as u8
    }

    /// How many lines of the pseudo-code were noted.
    #[must_use]
    pub const fn lines(self) -> u8 {
        self.bits(20, 5) as u8
    }

    /// The ways, relative to the robot.
    #[must_use]
    pub const fn ways(self) -> Ways {
        Ways::from_bits(self.bits(0, 4) as u8)
    }

    pub(super) const fn look(self, time_diff: u32) -> Look {
        let finish = if self.bits(4, 1) == 1 { Finish::Yes } else { Finish::No };
        let home = match self.bits(5, 2) {
            0 => Home::Away,
            1 => Home::Back,
            _ => Home::PutDown,
        };
        Look { sighting: Sighting { ways: self.ways(), finish, time_diff }, home }
    }

    pub(super) const fn cells_from(self, before: Self) -> u32 {
        (self.east.abs_diff(before.east) + self.north.abs_diff(before.north)) as u32
    }
}
