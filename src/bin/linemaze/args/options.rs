//! What explorers and their robots can be set to.

use clap::{Args, ValueEnum};
use line_maze_lab::settings::{self, NODE_MAX, Order, Pace, Settings};
use line_maze_lab::trace::MAX_NODES;

use super::numbers::{seconds, speed, whole};

/// What explorers and their robots can be set to.
#[derive(Args)]
pub(crate) struct Options {
    /// Which way is tried first at a node: S, R and L once each; random:SEED draws anew at each choice
    #[arg(long, value_name = "ORDER", default_value = "SRL")]
    order: Order,
    /// Two places nearer than this on both axes are one node [default: the time of half a cell]
    #[arg(long, value_name = "MS", allow_negative_numbers = true, value_parser = whole(0..=u32::MAX))]
    epsilon: Option<u32>,
    /// Nodes that the robot can remember at once
    #[arg(long, value_name = "N", default_value_t = NODE_MAX, allow_negative_numbers = true,
        value_parser = whole(1..=MAX_NODES))]
    node_max: u32,
    /// PAReX: whether the path is cut only two steps back (basic), or anywhere (special case 1)
    #[arg(long, value_enum, default_value_t)]
    rule: Rule,
    /// PAReX: squares that the path can hold, 48 in the article [default: no limit]
    #[arg(long, value_name = "N", allow_negative_numbers = true, value_parser = whole(1..=u32::MAX))]
    path_max: Option<u32>,
    /// Mapping: how the routes are found on the map
    #[arg(long, value_enum, default_value_t)]
    search: Search,
    /// Millimetres a second on a straight
    #[arg(long, value_name = "MM_S", default_value_t = Pace::default().speed_mm_s,
        allow_negative_numbers = true, value_parser = speed)]
    speed: f64,
    /// Seconds for a turn of 90°
    #[arg(long, value_name = "S", default_value_t = Pace::default().turn_s,
        allow_negative_numbers = true, value_parser = seconds)]
    turn_s: f64,
    /// Seconds for turning round
    #[arg(long, value_name = "S", default_value_t = Pace::default().uturn_s,
        allow_negative_numbers = true, value_parser = seconds)]
    uturn_s: f64,
    /// Seconds that every stop costs besides
    #[arg(long, value_name = "S", default_value_t = Pace::default().stop_s,
        allow_negative_numbers = true, value_parser = seconds)]
    stop_s: f64,
}

impl Options {
    /// The settings that the options make.
    pub(crate) const fn settings(&self) -> Settings {
        Settings {
            order: self.order,
            epsilon_ms: self.epsilon,
            node_max: self.node_max,
            pace: Pace {
                speed_mm_s: self.speed,
                turn_s: self.turn_s,
                uturn_s: self.uturn_s,
                stop_s: self.stop_s,
            },
            rule: match self.rule {
                Rule::Basic => settings::Rule::Basic,
                Rule::Special1 => settings::Rule::Special1,
            },
            path_max: self.path_max,
            search: match self.search {
                Search::Dijkstra => settings::Search::Dijkstra,
                Search::Astar => settings::Search::AStar,
            },
        }
    }
}

#[derive(Clone, Copy, Debug, Default, ValueEnum)]
enum Rule {
    Basic,
    #[default]
    #[value(name = "special-1")]
    Special1,
}

#[derive(Clone, Copy, Debug, Default, ValueEnum)]
enum Search {
    #[default]
    Dijkstra,
    Astar,
}
