//! What can be set on a robot and stays over a power loss: gains, speed, times, thresholds.

use super::fields::Fields;

/// A setting's name.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[repr(u8)]
pub enum Name {
    /// Proportional gain, × 1000.
    Kp,
    /// Integral gain, × 1000.
    Ki,
    /// Derivative gain, × 1000.
    Kd,
    /// Millimetres a second on a straight.
    Speed,
    /// Milliseconds of a turn by 90°.
    Turn,
    /// Milliseconds of turning round.
    Uturn,
    /// Milliseconds: two places nearer than this on both axes are one node.
    Epsilon,
    /// From this reading on, sensor 0 (the leftmost) sees the line.
    Line0,
    /// The same of sensor 1.
    Line1,
    /// The same of sensor 2.
    Line2,
    /// The same of sensor 3.
    Line3,
    /// The same of sensor 4 (the rightmost).
    Line4,
}

impl Name {
    /// How many there are.
    pub const COUNT: usize = 12;

    /// All, in the order in which they are kept.
    pub const ALL: [Self; Self::COUNT] = [
        Self::Kp,
        Self::Ki,
        Self::Kd,
        Self::Speed,
        Self::Turn,
        Self::Uturn,
        Self::Epsilon,
        Self::Line0,
        Self::Line1,
        Self::Line2,
        Self::Line3,
        Self::Line4,
    ];

    /// As the wire names it.
    #[must_use]
    pub const fn word(self) -> &'static str {
        match self {
            Self::Kp => "kp",
            Self::Ki => "ki",
            Self::Kd => "kd",
            Self::Speed => "speed",
            Self::Turn => "turn",
            Self::Uturn => "uturn",
            Self::Epsilon => "epsilon",
            Self::Line0 => "line0",
            Self::Line1 => "line1",
            Self::Line2 => "line2",
            Self::Line3 => "line3",
            Self::Line4 => "line4",
        }
    }

    /// The setting with this name.
    #[must_use]
    pub fn from_word(word: &str) -> Option<Self> {
        Self::ALL.into_iter().find(|name| name.word() == word)
    }

    /// The least and the greatest value that makes sense.
    #[must_use]
    pub const fn range(self) -> (i32, i32) {
        match self {
            Self::Kp | Self::Ki | Self::Kd => (0, 1_000_000),
            Self::Speed => (1, 5_000),
            Self::Turn | Self::Uturn => (1, 10_000),
            Self::Epsilon => (0, 60_000),
            Self::Line0 | Self::Line1 | Self::Line2 | Self::Line3 | Self::Line4 => (0, 1_023),
        }
    }

    /// The book's robot before anybody set anything: gains of 0.62, 0 and 3.1, the pace of the simulation.
    const fn first(self) -> i32 {
        match self {
            Self::Kp => 620,
            Self::Ki => 0,
            Self::Kd => 3_100,
            Self::Speed => 500,
            Self::Turn => 400,
            Self::Uturn => 700,
            Self::Epsilon => 200,
            Self::Line0 | Self::Line1 | Self::Line2 | Self::Line3 | Self::Line4 => 400,
        }
    }

    pub(super) fn parse(fields: &mut Fields<'_>) -> Option<Self> {
        Self::from_word(fields.word()?)
    }
}

/// A value outside its range.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct OutOfRange;

/// A robot's settings, each within its range.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Tune([i32; Name::COUNT]);

impl Default for Tune {
    fn default() -> Self {
        Self(Name::ALL.map(Name::first))
    }
}

impl Tune {
    /// A setting's value.
    #[must_use]
    pub const fn get(&self, name: Name) -> i32 {
        self.0[name as usize]
    }

    /// The same with another value.
    ///
    /// # Errors
    /// Where the value is out of the setting's range.
    pub fn with(mut self, name: Name, value: i32) -> Result<Self, OutOfRange> {
        let (least, most) = name.range();
        if (least..=most).contains(&value) {
            self.0[name as usize] = value;
            Ok(self)
        } else {
            Err(OutOfRange)
        }
    }
}
