//! What a robot's cost model can be: the limits of [`Pace`], checked at the edge.

use core::fmt;

use super::{MAX_CELL_MS, Pace};
use crate::maze::Scale;

/// The most millimetres a second.
pub const MAX_SPEED_MM_S: f64 = 1_000_000.0;
/// The most seconds for a turn, a U-turn, or a stop.
pub const MAX_TURN_S: f64 = 60.0;

/// Why a pace makes no sense.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum PaceError {
    /// The speed is not above 0, or above [`MAX_SPEED_MM_S`].
    Speed,
    /// A time is not from 0 to [`MAX_TURN_S`].
    Seconds,
    /// At this speed a cell takes longer than [`MAX_CELL_MS`].
    TooSlow {
        /// The cell's length.
        cell_mm: f64,
        /// The least speed that will do.
        least_mm_s: f64,
    },
}

impl fmt::Display for PaceError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Speed => {
                f.write_str("a speed is a number above 0 and up to 1,000,000, in millimetres a second")
            }
            Self::Seconds => f.write_str("a time is a number of seconds from 0 to 60"),
            Self::TooSlow { cell_mm, least_mm_s } => write!(
                f,
                "a cell of {cell_mm} mm would take longer than {} s; choose {least_mm_s} or more",
                MAX_CELL_MS / 1000
            ),
        }
    }
}

impl core::error::Error for PaceError {}

/// A speed in millimetres a second, if it is one.
///
/// # Errors
/// [`PaceError::Speed`]
pub fn speed(mm_s: f64) -> Result<f64, PaceError> {
    if mm_s > 0.0 && mm_s <= MAX_SPEED_MM_S { Ok(mm_s) } else { Err(PaceError::Speed) }
}

/// The seconds of a turn, a U-turn or a stop, if that is what they are.
///
/// # Errors
/// [`PaceError::Seconds`]
pub fn seconds(seconds: f64) -> Result<f64, PaceError> {
    if (0.0..=MAX_TURN_S).contains(&seconds) { Ok(seconds) } else { Err(PaceError::Seconds) }
}

impl Pace {
    /// This pace, if a robot can have it in a maze of this scale.
    ///
    /// ```
    /// use line_maze_lab::maze::Scale;
    /// use line_maze_lab::settings::{Pace, PaceError};
    /// let pace = Pace { turn_s: -1.0, ..Pace::default() };
    /// assert_eq!(pace.checked(Scale::default()), Err(PaceError::Seconds));
    /// assert!(Pace::default().checked(Scale::default()).is_ok());
    /// ```
    ///
    /// # Errors
    /// Where one of the numbers is out of its range, or a cell would take too long.
    pub fn checked(self, scale: Scale) -> Result<Self, PaceError> {
        speed(self.speed_mm_s)?;
        for time in [self.turn_s, self.uturn_s, self.stop_s] {
            seconds(time)?;
        }
        let cell_mm = scale.cell_mm();
        let least_mm_s = cell_mm * 1000.0 / f64::from(MAX_CELL_MS);
        if self.speed_mm_s < least_mm_s {
            return Err(PaceError::TooSlow { cell_mm, least_mm_s });
        }
        Ok(self)
    }
}
