//! What can be typed: commands, options, and what each of them accepts.

use std::path::PathBuf;

use clap::builder::{PossibleValue, PossibleValuesParser, TypedValueParser};
use clap::{Args, Parser, Subcommand, ValueEnum};
use line_maze_lab::explorer::name::Name;
use line_maze_lab::maze::MAX_SIDE;
use line_maze_lab::settings::{self, NODE_MAX, Order, Pace, PaceError, Settings, limits};
use line_maze_lab::trace::MAX_NODES;

/// Explore line mazes as a robot does that cannot see them: stop by stop, by the algorithm of a book.
#[derive(Parser)]
#[command(name = "linemaze", version, arg_required_else_help = true, after_help = EXAMPLES)]
pub(crate) struct Cli {
    #[command(subcommand)]
    pub(crate) command: Command,
}

const EXAMPLES: &str = "\
Examples:
  linemaze run mazes/book-3-1.maze                   how the run ended, and how good its route is
  linemaze run mazes/book-3-1.maze --json            the same for a program
  linemaze trace mazes/book-3-1.maze                 what the robot did at every stop
  linemaze run mazes/book-3-1.maze --explorer mapping    the same maze with another algorithm
  linemaze generate --size 20x12 --seed 7 | linemaze run -
  linemaze check mine.maze                           what is not in order, where, and what to do
  linemaze convert mine.maze mine.svg                a picture in true size

Exit status:
  0  the finish was reached, all is mapped, the maze is clean, the file is written
  1  the run ended elsewhere, or there are findings
  2  the arguments or the input make no sense; standard error says where: FILE:LINE:COLUMN: message";

#[derive(Subcommand)]
pub(crate) enum Command {
    /// Explore a maze and report the run, its route, and the best routes there are.
    #[command(after_help = RUN_STATUS)]
    Run(Explore),
    /// Explore a maze and tell every stop.
    #[command(after_help = RUN_STATUS)]
    Trace(Explore),
    /// Say what is not in order in a maze, where, and what to do about it.
    #[command(after_help = "Exit status: 0 nothing found, 1 findings, 2 unreadable.")]
    Check {
        #[arg(value_name = "MAZE", help = MAZE_HELP)]
        maze: PathBuf,
    },
    /// Make a maze from a seed and print it as a .maze file; the same options always give the same maze.
    #[command(
        after_help = "Example: linemaze generate --size 9x6 --loops 25% --dead-ends 80% --seed 1924 > mine.maze"
    )]
    Generate(Generate),
    /// Write a maze in another format; OUT's extension chooses.
    #[command(after_help = "What IN is, its content tells. OUT is replaced if it exists.")]
    Convert {
        #[arg(value_name = "IN", help = MAZE_HELP)]
        from: PathBuf,
        /// The file to write: .maze (text), .json (for programs), .svg (a picture in true size); walls also as
        /// micromouse files: .txt (drawing), .map, .num (mms), .maz (256 bytes)
        #[arg(value_name = "OUT")]
        to: PathBuf,
    },
}

const RUN_STATUS: &str = "Exit status: 0 finish reached or all mapped, 1 any other outcome, 2 the input or the arguments make no sense.";

const MAZE_HELP: &str =
    "A maze file of any readable format (.maze, JSON, micromouse), or - for standard input";

/// What `run` and `trace` take.
#[derive(Args)]
pub(crate) struct Explore {
    #[arg(value_name = "MAZE", help = MAZE_HELP)]
    pub(crate) maze: PathBuf,
    /// Whose algorithm drives
    #[arg(long, value_name = "NAME", default_value_t, value_parser = names())]
    pub(crate) explorer: Name,
    /// Print JSON: one object for `run`, one a line for each stop for `trace`
    #[arg(long)]
    pub(crate) json: bool,
    /// Which way is tried first at a node: S, R and L once each; random:SEED draws anew at each choice
    #[arg(long, value_name = "ORDER", default_value = "SRL")]
    order: Order,
    /// Two places nearer than this on both axes are one node [default: the time of half a cell]
    #[arg(long, value_name = "MS")]
    epsilon: Option<u32>,
    /// Nodes that the robot can remember at once
    #[arg(long, value_name = "N", default_value_t = NODE_MAX, value_parser = clap::value_parser!(u32).range(1..=i64::from(MAX_NODES)))]
    node_max: u32,
    /// PAReX: whether the path is cut only two steps back (basic), or anywhere (special case 1)
    #[arg(long, value_enum, default_value_t)]
    rule: Rule,
    /// PAReX: squares that the path can hold, 48 in the article [default: no limit]
    #[arg(long, value_name = "N", value_parser = clap::value_parser!(u32).range(1..))]
    path_max: Option<u32>,
    /// Mapping: how the routes are found on the map
    #[arg(long, value_enum, default_value_t)]
    search: Search,
    /// Millimetres a second on a straight
    #[arg(long, value_name = "MM_S", default_value_t = Pace::default().speed_mm_s, value_parser = speed)]
    speed: f64,
    /// Seconds for a turn of 90°
    #[arg(long, value_name = "S", default_value_t = Pace::default().turn_s, value_parser = seconds)]
    turn_s: f64,
    /// Seconds for turning round
    #[arg(long, value_name = "S", default_value_t = Pace::default().uturn_s, value_parser = seconds)]
    uturn_s: f64,
    /// Seconds that every stop costs besides
    #[arg(long, value_name = "S", default_value_t = Pace::default().stop_s, value_parser = seconds)]
    stop_s: f64,
}

impl Explore {
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

/// The explorers' names, each with its title in the help.
fn names() -> impl TypedValueParser<Value = Name> {
    let name = |name: &Name| PossibleValue::new(name.text()).help(name.about().title);
    PossibleValuesParser::new(Name::ALL.iter().map(name)).try_map(|text| text.parse::<Name>())
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

/// What `generate` takes.
#[derive(Args)]
pub(crate) struct Generate {
    /// Lattice points from west to east and from south to north, as in 20x12
    #[arg(long, value_name = "WxH", default_value = "9x6", value_parser = size)]
    pub(crate) size: Size,
    /// How many of the links that a tree leaves out become loops: 0 to 1, or 0% to 100%
    #[arg(long, value_name = "SHARE", default_value = "25%", value_parser = percent)]
    pub(crate) loops: u8,
    /// How many of the dead ends are cut back to the next node: 0 to 1, or 0% to 100%
    #[arg(long, value_name = "SHARE", default_value = "80%", value_parser = percent)]
    pub(crate) dead_ends: u8,
    /// Another seed, another maze
    #[arg(long, value_name = "N", default_value_t = 1)]
    pub(crate) seed: u64,
    /// Drawn as lines on the floor, or as walls between squares
    #[arg(long, value_name = "KIND", value_enum, default_value_t)]
    pub(crate) kind: Drawn,
}

/// Points along the sides.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Size {
    pub(crate) width: u32,
    pub(crate) height: u32,
}

/// How a maze is drawn.
#[derive(Clone, Copy, Debug, Default, ValueEnum)]
pub(crate) enum Drawn {
    #[default]
    Line,
    Wall,
}

fn size(text: &str) -> Result<Size, String> {
    let side = |text: &str| text.parse().ok().filter(|side| (1..=MAX_SIDE).contains(side));
    let sides =
        text.split_once(['x', 'X', '×']).and_then(|(width, height)| Some((side(width)?, side(height)?)));
    let (width, height) = sides
        .ok_or(format!("a size is two whole numbers from 1 to {MAX_SIDE} with an x between, as in 20x12"))?;
    Ok(Size { width, height })
}

/// A share in whole per cent.
fn percent(text: &str) -> Result<u8, String> {
    let (number, whole) = text.strip_suffix('%').map_or((text, 1.0), |number| (number, 100.0));
    match number.trim().parse::<f64>() {
        Ok(share) if (0.0..=whole).contains(&share) => Ok((share / whole * 100.0).round() as u8),
        _ => Err("a share is a number from 0 to 1, as in 0.25, or from 0% to 100%".to_owned()),
    }
}

fn speed(text: &str) -> Result<f64, PaceError> {
    text.parse().map_err(|_| PaceError::Speed).and_then(limits::speed)
}

fn seconds(text: &str) -> Result<f64, PaceError> {
    text.parse().map_err(|_| PaceError::Seconds).and_then(limits::seconds)
}
