//! What a drive is made of, and how long it takes: cells, turns, and stops.

use crate::geometry::Turn;
use crate::settings::Pace;

/// Counts of a drive. Seconds follow from the counts alone, so drives with equal counts are equal to the
/// last bit.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Tally {
    /// Cells of line driven over.
    pub cells: u32,
    /// Turns to the right, at nodes and corners.
    pub right_turns: u32,
    /// Turns to the left, at nodes and corners.
    pub left_turns: u32,
    /// Turns round.
    pub u_turns: u32,
    /// Stops after the start, the last one included.
    pub stops: u32,
}

impl Tally {
    /// Nothing driven yet.
    pub const NONE: Self = Self { cells: 0, right_turns: 0, left_turns: 0, u_turns: 0, stops: 0 };

    /// This much, and a turn.
    #[must_use]
    pub const fn turned(self, turn: Turn) -> Self {
        match turn {
            Turn::Straight => self,
            Turn::Right => Self { right_turns: self.right_turns + 1, ..self },
            Turn::Left => Self { left_turns: self.left_turns + 1, ..self },
            Turn::Back => Self { u_turns: self.u_turns + 1, ..self },
        }
    }

    /// This much, and a drive of so many cells to the next stop.
    #[must_use]
    pub const fn driven(self, cells: u32) -> Self {
        Self { cells: self.cells + cells, stops: self.stops + 1, ..self }
    }

    /// Turns of any kind.
    #[must_use]
    pub const fn turns(&self) -> u32 {
        self.right_turns + self.left_turns + self.u_turns
    }

    /// Seconds that it takes with cells of this length.
    ///
    /// ```
    /// use line_maze_lab::{geometry::Turn, route::tally::Tally, settings::Pace};
    /// let there = Tally::default().driven(5).turned(Turn::Right).driven(5);
    /// assert_eq!(there.seconds(200.0, &Pace::default()), 2000.0 / 500.0 + 0.4);
    /// ```
    #[must_use]
    pub fn seconds(&self, cell_mm: f64, pace: &Pace) -> f64 {
        let turns = self.right_turns + self.left_turns;
        f64::from(self.cells) * cell_mm / pace.speed_mm_s
            + f64::from(turns) * pace.turn_s
            + f64::from(self.u_turns) * pace.uturn_s
            + f64::from(self.stops) * pace.stop_s
    }
}
