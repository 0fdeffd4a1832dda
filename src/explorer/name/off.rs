//! Settings that are off their defaults and change a run of this explorer, in a word or two each.

use alloc::format;
use alloc::string::{String, ToString};
use alloc::vec::Vec;

use super::{Name, Setting};
use crate::settings::{Order, Pace, Rule, Search, Settings};

impl Name {
    /// What is set otherwise than usual, of what this explorer heeds; the book's preference order is left out, as the
    /// page always shows it.
    ///
    /// ```
    /// use line_maze_lab::explorer::name::Name;
    /// use line_maze_lab::settings::Settings;
    /// let settings = Settings { epsilon_ms: Some(1000), node_max: 61, ..Settings::default() };
    /// assert_eq!(Name::Book.off_defaults(&settings), ["epsilon 1000", "NODE_MAX 61"]);
    /// assert!(Name::LeftHand.off_defaults(&settings).is_empty());
    /// ```
    #[must_use]
    pub fn off_defaults(self, settings: &Settings) -> Vec<String> {
        let usual = Settings::default();
        let heeded = |setting| self.heeds(setting);
        let order = match settings.order {
            order if order == usual.order || self == Self::Book => None,
            Order::Random(seed) => Some(format!("random {seed}")),
            fixed @ Order::Fixed(_) => Some(format!("order {fixed}")),
        };
        let off = [
            order.filter(|_| heeded(Setting::Order)),
            settings.epsilon_ms.filter(|_| heeded(Setting::Epsilon)).map(|ms| format!("epsilon {ms}")),
            (heeded(Setting::NodeMax) && settings.node_max != usual.node_max)
                .then(|| format!("NODE_MAX {}", settings.node_max)),
            (heeded(Setting::Rule) && settings.rule == Rule::Basic).then(|| "basic rule".to_string()),
            settings.path_max.filter(|_| heeded(Setting::PathMax)).map(|most| format!("path of {most}")),
            (heeded(Setting::Search) && settings.search == Search::AStar).then(|| "A*".to_string()),
            (settings.pace != Pace::default()).then(|| "own cost model".to_string()),
        ];
        off.into_iter().flatten().collect()
    }
}
