//! The settings of a league as they go to a worker and back.

use alloc::string::{String, ToString};

use serde::{Deserialize, Serialize};

use crate::settings::{Pace, Rule, Search, Settings};

/// All settings, in plain values.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Terms {
    order: String,
    epsilon_ms: Option<u32>,
    node_max: u32,
    /// Speed, turn, U-turn, stop.
    pace: [f64; 4],
    basic_rule: bool,
    path_max: Option<u32>,
    a_star: bool,
}

impl Terms {
    /// Those of these settings.
    ///
    /// ```
    /// use line_maze_lab::compare::league::desk::Terms;
    /// use line_maze_lab::settings::{Order, Search, Settings};
    /// let settings = Settings { order: Order::Random(7), search: Search::AStar, path_max: Some(48), ..Settings::default() };
    /// assert_eq!(Terms::of(&settings).settings(), settings);
    /// ```
    #[must_use]
    pub fn of(settings: &Settings) -> Self {
        let Pace { speed_mm_s, turn_s, uturn_s, stop_s } = settings.pace;
        Self {
            order: settings.order.to_string(),
            epsilon_ms: settings.epsilon_ms,
            node_max: settings.node_max,
            pace: [speed_mm_s, turn_s, uturn_s, stop_s],
            basic_rule: settings.rule == Rule::Basic,
            path_max: settings.path_max,
            a_star: settings.search == Search::AStar,
        }
    }

    /// The settings.
    #[must_use]
    pub fn settings(&self) -> Settings {
        let [speed_mm_s, turn_s, uturn_s, stop_s] = self.pace;
        let usual = Settings::default();
        Settings {
            order: self.order.parse().unwrap_or(usual.order),
            epsilon_ms: self.epsilon_ms,
            node_max: self.node_max,
            pace: Pace { speed_mm_s, turn_s, uturn_s, stop_s },
            rule: if self.basic_rule { Rule::Basic } else { Rule::Special1 },
            path_max: self.path_max,
            search: if self.a_star { Search::AStar } else { Search::Dijkstra },
        }
    }
}

impl Default for Terms {
    fn default() -> Self {
        Self::of(&Settings::default())
    }
}
