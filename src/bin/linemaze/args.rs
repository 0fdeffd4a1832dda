//! What can be typed: commands, options, and what each of them accepts.

use std::path::PathBuf;

use clap::{ArgGroup, Args, Parser, Subcommand};
use line_maze_lab::compare::{LineupError, each_once};
use line_maze_lab::explorer::name::Name;

mod convert;
mod generate;
mod input;
mod names;
mod numbers;
mod options;
mod turns;

pub(crate) use convert::Convert;
pub(crate) use generate::Generate;
use input::MAZE_HELP;
pub(crate) use input::{Finish, Input, Marks, put_finish};
use names::names;
use numbers::{seed, whole};
pub(crate) use options::Options;
pub(crate) use turns::{Turns, TurnsForm};

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
  linemaze turns --reduce LBLLBSR                    what is left of a turn list: SRR
  linemaze compare mine.maze --explorers book,mapping,flood-fill
  linemaze league --generate 500 --size 16x16        who solves most, and how well
  linemaze robot --pty /tmp/robot --maze mine.maze   a robot without hardware, on a serial line
  linemaze link-check --pty /dev/ttyACM0             whether a robot keeps the rules of PROTOCOL.md

Exit status:
  0  the finish was reached, all is mapped, the maze has no errors, the file is written
  1  the run ended elsewhere, the maze has errors, or some of the input could not be used
  2  the arguments or the input make no sense, or the output could not be written; standard error says where:
      FILE:LINE:COLUMN: message";

#[derive(Subcommand)]
pub(crate) enum Command {
    /// Explore a maze and report the run, its route, and the best routes there are.
    #[command(after_help = RUN_STATUS)]
    Run(Explore),
    /// Explore a maze and tell every stop.
    #[command(after_help = RUN_STATUS, after_long_help = TRACE_COLUMNS)]
    Trace(Explore),
    /// Print the turn list that a run leaves, for a board or another program; or reduce and reverse letters.
    #[command(after_help = turns::HELP)]
    Turns(Turns),
    /// Put explorers side by side in one maze: a table, and where they part from the first that runs.
    #[command(
        after_help = "Exit status: 0 compared, also where an explorer fails or cannot start, 2 bad input or nobody can start.\n\nExamples:\n  linemaze compare mazes/book-3-1.maze --explorers book,mapping,cornell-3\n  linemaze compare mazes/long-way.maze --random-orders 1000"
    )]
    Compare(Compare),
    /// Run explorers over many mazes, on all cores: share solved, medians, CSV.
    #[command(
        after_help = "Exit status: 0 all of it was run, 1 without files that could not be read or folders that hold none, 2 nothing to run.\n\nExamples:\n  linemaze league --samples --generate 500 --size 16x16 --csv runs.csv\n  linemaze league my-mazes/ --explorers book,mapping"
    )]
    League(League),
    /// Say what is not in order in a maze, where, and what to do about it.
    #[command(after_help = CHECK_STATUS)]
    Check(Check),
    /// Make a maze from a seed and print it as a .maze file; the same options always give the same maze.
    #[command(
        after_help = "Example: linemaze generate --size 9x6 --loops 25% --dead-ends 80% --seed 1924 > mine.maze"
    )]
    Generate(Generate),
    /// Write a maze in another format; OUT's extension chooses.
    #[command(after_help = convert::HELP)]
    Convert(Convert),
    /// Be a robot that speaks the protocol of PROTOCOL.md, in an ideal world, until the end of input or a signal.
    #[command(
        after_help = "Whoever opens the pseudo-terminal resets the robot, as opening the port of an Uno does; it is ready a second later.\n\
        On standard input nothing is lost meanwhile; at its end everything is answered, and a run drives on to its end.\n\n\
        Examples:\n  linemaze robot --pty /tmp/robot --maze mazes/book-3-1.maze\n  echo help | linemaze robot --stdio --maze mazes/book-3-1.maze"
    )]
    Robot(Robot),
    /// Play the page's end against any robot, and say of each rule of PROTOCOL.md whether it is kept.
    #[command(
        after_help = "Exit status: 0 every rule that was tried is kept, 1 a rule is broken, 2 the port cannot be opened, another program has it, or it goes.\n\
        A remark is no broken rule: the robot could be made easier to use.\n\
        Settings and the turn list are changed and put back; a robot that had no list keeps one."
    )]
    LinkCheck(LinkCheck),
}

const CHECK_STATUS: &str = "\
An error is what keeps the book's explorer from starting: no line, no start, a start that has several ways, faces none
of them, or is the finish. All else is a warning: no finish, one out of reach, squares that are closed off.
How a file was read that leaves something open is said on standard error.

Exit status: 0 in order, or only warnings; 1 errors (with --strict: or warnings); 2 unreadable.";

const RUN_STATUS: &str = "Exit status: 0 finish reached or all mapped, 1 any other outcome, 2 the input or the arguments make no sense.";

const TRACE_COLUMNS: &str = "\
Columns:
  stop       from 1; explorers other than the book's begin with their start, stop 0
  at         the place, x to the east and y to the north of the drawing
  seen       what the robot meets there: node, corner, dead end, straight, finish, start
  case       what that is to the explorer, in its source's words
  node       the node's number in its table
  turn       S straight, R right, B back (a U-turn), L left; - where the run ends
  leaves     the heading after the turn, in the robot's frame: N is where it faced at the start
  ptr        one more than the nodes that the book's explorer remembers
  returning  whether the book's explorer is on its way back
  cur_x      milliseconds driven to the east of the start, in the robot's frame; cur_y: to the north
  crossed    cells that the book's explorer has crossed out so far
With --json, leaves is a number: 0 N, 1 E, 2 S, 3 W.

Exit status: 0 finish reached or all mapped, 1 any other outcome, 2 the input or the arguments make no sense.";

/// What `run` and `trace` take.
#[derive(Args)]
pub(crate) struct Explore {
    #[command(flatten)]
    pub(crate) maze: Input,
    /// Whose algorithm drives
    #[arg(long, value_name = "NAME", default_value_t, value_parser = names())]
    pub(crate) explorer: Name,
    /// Print JSON: one object for `run`, one a line for each stop for `trace`
    #[arg(long)]
    pub(crate) json: bool,
    #[command(flatten)]
    pub(crate) settings: Options,
}

/// What `compare` takes.
#[derive(Args)]
pub(crate) struct Compare {
    #[command(flatten)]
    pub(crate) maze: Input,
    /// Two to six explorers, with commas between them
    #[arg(long, value_name = "NAMES", value_delimiter = ',', value_parser = names(), hide_possible_values = true,
        default_value = "book,left-hand,right-hand,mapping,tremaux,flood-fill")]
    pub(crate) explorers: Vec<Name>,
    /// Print JSON: one object an explorer, as `run --json` does
    #[arg(long)]
    pub(crate) json: bool,
    /// Instead: this many runs of the book's explorer, each with its own random order; how long are the routes?
    #[arg(long, value_name = "N", conflicts_with_all = ["explorers", "json", "order"],
        allow_negative_numbers = true, value_parser = whole(1..=1_000_000_u32))]
    pub(crate) random_orders: Option<u32>,
    #[command(flatten)]
    pub(crate) settings: Options,
}

/// What `league` takes.
#[derive(Args)]
pub(crate) struct League {
    /// Maze files of any readable format, and folders: every file in them and in their folders, but for names that
    /// begin with a dot
    #[arg(value_name = "MAZE")]
    pub(crate) mazes: Vec<PathBuf>,
    /// The lab's own samples too; alone, they are the default
    #[arg(long)]
    pub(crate) samples: bool,
    /// This many generated mazes, with seeds from --seed on
    #[arg(long, value_name = "N", allow_negative_numbers = true,
        value_parser = whole(1..=100_000_u32))]
    pub(crate) generate: Option<u32>,
    #[command(flatten)]
    pub(crate) recipe: Generate,
    /// The finish of files that name none: centre (one, two or four squares in the middle), or a point X,Y
    #[arg(long, value_name = "WHERE", allow_hyphen_values = true)]
    pub(crate) finish: Vec<Finish>,
    /// Explorers, with commas between them [default: all]
    #[arg(long, value_name = "NAMES", value_delimiter = ',', value_parser = names(), hide_possible_values = true)]
    explorers: Vec<Name>,
    /// Write a line for each run into this file; with - to standard output, instead of the table
    #[arg(long, value_name = "FILE")]
    pub(crate) csv: Option<PathBuf>,
    /// Write a line for each explorer into this file, or with - to standard output: medians, quartiles, share solved
    #[arg(long, value_name = "FILE")]
    pub(crate) standings_csv: Option<PathBuf>,
    #[command(flatten)]
    pub(crate) settings: Options,
}

impl League {
    /// Who runs, in the order of the help.
    ///
    /// # Errors
    /// Who is named twice.
    pub(crate) fn explorers(&self) -> Result<Vec<Name>, LineupError> {
        if self.explorers.is_empty() {
            return Ok(Name::ALL.to_vec());
        }
        each_once(&self.explorers)?;
        let mut chosen = self.explorers.clone();
        chosen.sort_unstable();
        Ok(chosen)
    }
}

/// What `check` takes.
#[derive(Args)]
pub(crate) struct Check {
    #[command(flatten)]
    pub(crate) maze: Input,
    /// Let warnings count too: status 1 for anything that is not in order
    #[arg(long)]
    pub(crate) strict: bool,
}

/// What `robot` takes.
#[derive(Args)]
#[command(group = ArgGroup::new("line").args(["pty", "stdio"]).required(true))]
pub(crate) struct Robot {
    /// Make a pseudo-terminal and a link to it at PATH, which goes when the robot ends (not on Windows)
    #[arg(long, value_name = "PATH")]
    pub(crate) pty: Option<PathBuf>,
    /// Speak on standard input and output instead
    #[arg(long)]
    pub(crate) stdio: bool,
    /// The maze that it stands in: a file of any readable format, or - for standard input
    #[arg(long, value_name = "FILE")]
    pub(crate) maze: PathBuf,
    #[command(flatten)]
    pub(crate) marks: Marks,
    /// Lose, flip, double and delay bytes, reset, fall silent and flood, the same way for the same seed
    #[arg(long, value_name = "SEED", allow_negative_numbers = true, value_parser = seed())]
    pub(crate) faults: Option<u64>,
    /// Speak at this rate; on a pseudo-terminal, rubbish comes over unless the other end has set it too
    #[arg(long, value_name = "BITS_S", allow_negative_numbers = true,
        value_parser = whole(300..=4_000_000_u32))]
    pub(crate) baud: Option<u32>,
    /// As behind a Bluetooth module: opening does not reset it, and it is silent until it is spoken to
    #[arg(long)]
    pub(crate) quiet: bool,
    /// Let its time run so many times faster
    #[arg(long, value_name = "TIMES", default_value_t = 1, allow_negative_numbers = true,
        value_parser = whole(1..=100_u32))]
    pub(crate) hurry: u32,
}

/// What `link-check` takes.
#[derive(Args)]
pub(crate) struct LinkCheck {
    /// The robot's port: /dev/ttyACM0, /dev/cu.usbmodem…, or the link that `linemaze robot --pty` made
    #[arg(long, value_name = "PATH")]
    pub(crate) pty: PathBuf,
    /// The rate
    #[arg(long, value_name = "BITS_S", default_value_t = 115_200, allow_negative_numbers = true,
        value_parser = whole(300..=4_000_000_u32))]
    pub(crate) baud: u32,
    /// The robot may drive: it stands at the start of a line maze, and there is room
    #[arg(long)]
    pub(crate) drive: bool,
}
