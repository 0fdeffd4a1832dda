//! What `turns` takes: a maze whose run leaves a list, or letters to work on.

use std::path::PathBuf;

use clap::{ArgGroup, Args, ValueEnum};
use line_maze_lab::explorer::name::Name;

use super::{MAZE_HELP, Marks, Options, names};

/// What `turns` takes.
#[derive(Args)]
#[command(group = ArgGroup::new("list").args(["path", "reduce", "reverse"]).required(true))]
pub(crate) struct Turns {
    #[arg(value_name = "MAZE", help = MAZE_HELP)]
    pub(crate) path: Option<PathBuf>,
    #[command(flatten)]
    pub(crate) marks: Marks,
    /// Reduce these letters instead: LBL becomes S, and so on, until no B is left between two turns
    #[arg(long, value_name = "LETTERS", allow_hyphen_values = true, conflicts_with_all = OF_A_RUN)]
    pub(crate) reduce: Option<String>,
    /// Turn these letters round instead, for the way back
    #[arg(long, value_name = "LETTERS", allow_hyphen_values = true, conflicts_with_all = OF_A_RUN)]
    pub(crate) reverse: Option<String>,
    /// Whose algorithm drives
    #[arg(long, value_name = "NAME", default_value_t, value_parser = names())]
    pub(crate) explorer: Name,
    /// How the list is written
    #[arg(long, value_enum, default_value_t)]
    pub(crate) form: TurnsForm,
    /// A letter for each corner too, not only for nodes
    #[arg(long)]
    pub(crate) corners: bool,
    #[command(flatten)]
    pub(crate) settings: Options,
}

/// What is said of runs only.
const OF_A_RUN: [&str; 5] = ["finish", "start", "explorer", "corners", "Options"];

/// What there is to know besides.
pub(super) const HELP: &str = "\
LETTERS are L (left), S or F (straight), R (right), B or U (back), in capitals or not, with blanks, commas, quotes or
braces between them; arrows; or a list as --form writes it. With - they come from standard input.

Exit status: 0 printed, 1 the run left no way to the finish, 2 bad input.

Examples:
  linemaze turns mazes/book-3-1.maze --form c
  linemaze turns --reduce LBLLBSR
  linemaze turns mazes/book-3-1.maze | linemaze turns --reverse -";

/// How a turn list is written.
#[derive(Clone, Copy, Debug, Default, ValueEnum)]
pub(crate) enum TurnsForm {
    /// SSR
    #[default]
    Letters,
    /// One object
    Json,
    /// A line a turn
    Csv,
    /// An array for an Arduino sketch
    C,
}
