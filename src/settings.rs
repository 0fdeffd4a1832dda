//! What can be set before a run: how the robot prefers its ways, how sure it is of a place, how fast it is.

use core::fmt;
use core::str::FromStr;

use crate::geometry::Turn;
use crate::maze::Scale;

pub mod limits;

pub use limits::PaceError;

/// In which order a robot tries the ways out of a node.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Order {
    /// The same order at every node.
    Fixed(Preference),
    /// A fresh order at each choice, drawn from this seed (book §3.1 recommends it).
    Random(u64),
}

/// An order of straight, right and left.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Preference([Turn; 3]);

impl Preference {
    /// The book's own: straight, right, left.
    pub const SRL: Self = Self([Turn::Straight, Turn::Right, Turn::Left]);

    /// All six, the book's first.
    pub const ALL: [Self; 6] = {
        use Turn::{Left as L, Right as R, Straight as S};
        [Self([S, R, L]), Self([S, L, R]), Self([R, S, L]), Self([R, L, S]), Self([L, S, R]), Self([L, R, S])]
    };

    /// The turns, first choice first.
    #[must_use]
    pub const fn turns(self) -> [Turn; 3] {
        self.0
    }
}

impl fmt::Display for Preference {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let [a, b, c] = self.0.map(Turn::letter);
        write!(f, "{a}{b}{c}")
    }
}

impl fmt::Display for Order {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Fixed(preference) => write!(f, "{preference}"),
            Self::Random(seed) => write!(f, "random:{seed}"),
        }
    }
}

/// Why a text is not an order.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct OrderError;

impl fmt::Display for OrderError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(
            f,
            "an order is S, R and L once each, as in SRL, or random: and a whole number, as in random:7"
        )
    }
}

impl core::error::Error for OrderError {}

impl FromStr for Order {
    type Err = OrderError;

    fn from_str(text: &str) -> Result<Self, OrderError> {
        if let Some(seed) = text.strip_prefix("random:") {
            return seed.parse().map(Self::Random).map_err(|_| OrderError);
        }
        let named = |p: &&Preference| {
            text.chars().map(|c| c.to_ascii_uppercase()).eq(p.turns().into_iter().map(Turn::letter))
        };
        Preference::ALL.iter().find(named).map(|&p| Self::Fixed(p)).ok_or(OrderError)
    }
}

/// How fast the robot is; times do not count as distance.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Pace {
    /// Millimetres a second on a straight.
    pub speed_mm_s: f64,
    /// Seconds for a turn of 90°, at nodes and corners.
    pub turn_s: f64,
    /// Seconds for turning round.
    pub uturn_s: f64,
    /// Seconds that every stop costs besides.
    pub stop_s: f64,
}

impl Default for Pace {
    fn default() -> Self {
        Self { speed_mm_s: 500.0, turn_s: 0.4, uturn_s: 0.7, stop_s: 0.0 }
    }
}

impl Pace {
    /// Milliseconds that one cell takes: rounded once, at least 2, so that all times of a run are multiples
    /// of it and no error can add up; at most [`MAX_CELL_MS`].
    ///
    /// ```
    /// use line_maze_lab::{maze::Scale, settings::Pace};
    /// assert_eq!(Pace::default().cell_ms(Scale::default()), 400);
    /// ```
    #[must_use]
    pub fn cell_ms(&self, scale: Scale) -> u32 {
        ((scale.cell_mm() * 1000.0 / self.speed_mm_s + 0.5) as u32).clamp(2, MAX_CELL_MS)
    }

    /// Seconds that a turn takes.
    #[must_use]
    pub const fn seconds(&self, turn: Turn) -> f64 {
        match turn {
            Turn::Straight => 0.0,
            Turn::Right | Turn::Left => self.turn_s,
            Turn::Back => self.uturn_s,
        }
    }
}

/// The most milliseconds that a cell can take: the length of the longest line still fits 32-bit coordinates.
pub const MAX_CELL_MS: u32 = 2_000_000;

/// How PAReX path mapping cuts its path when it has been somewhere before.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Rule {
    /// Only where it was two steps ago: dead ends one square deep, one after the other.
    Basic,
    /// Wherever it was on the path (the article's special case 1).
    #[default]
    Special1,
}

/// How full mapping looks for its routes.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Search {
    /// By distance from the start alone.
    #[default]
    Dijkstra,
    /// With the finish in sight.
    AStar,
}

/// Everything that can be set for a run; each explorer uses what concerns it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Settings {
    /// Preference order at a node.
    pub order: Order,
    /// Two places nearer than this on both axes are one node, in milliseconds; half a cell if not set.
    pub epsilon_ms: Option<u32>,
    /// Nodes that the robot can remember at once: the book's `nodes[50]`.
    pub node_max: u32,
    /// Speed and turning times.
    pub pace: Pace,
    /// PAReX: how the path is cut.
    pub rule: Rule,
    /// PAReX: squares that the path can hold (the article's 48); no limit if not set.
    pub path_max: Option<u32>,
    /// Full mapping: how its routes are found.
    pub search: Search,
}

/// The book's own size of the node table.
pub const NODE_MAX: u32 = 50;

impl Default for Settings {
    fn default() -> Self {
        Self {
            order: Order::Fixed(Preference::SRL),
            epsilon_ms: None,
            node_max: NODE_MAX,
            pace: Pace::default(),
            rule: Rule::default(),
            path_max: None,
            search: Search::default(),
        }
    }
}

impl Settings {
    /// The `epsilon` of a run in a maze of this scale, in milliseconds.
    #[must_use]
    pub fn epsilon(&self, scale: Scale) -> u32 {
        self.epsilon_ms.unwrap_or_else(|| self.pace.cell_ms(scale) / 2)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn orders_read_and_write_themselves() {
        for preference in Preference::ALL {
            let order = Order::Fixed(preference);
            assert_eq!(std::format!("{order}").parse(), Ok(order));
        }
        assert_eq!("random:18446744073709551615".parse(), Ok(Order::Random(u64::MAX)));
        assert_eq!("srl".parse(), Ok(Order::Fixed(Preference::SRL)));
        for bad in ["", "SR", "SRLS", "SSR", "random:", "random:-1", "SRB"] {
            assert_eq!(bad.parse::<Order>(), Err(OrderError), "{bad}");
        }
    }

    #[test]
    fn a_cell_never_takes_less_than_two_milliseconds() {
        let pace = Pace { speed_mm_s: 1e9, ..Pace::default() };
        assert_eq!(pace.cell_ms(Scale::default()), 2);
    }

    #[test]
    fn the_longest_line_fits_the_coordinates() {
        let pace = Pace { speed_mm_s: 1e-9, ..Pace::default() };
        assert!((crate::maze::MAX_SIDE - 1).checked_mul(pace.cell_ms(Scale::default())) < Some(1 << 31));
    }
}
