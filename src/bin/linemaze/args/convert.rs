//! What `convert` takes.

use std::path::PathBuf;

use clap::Args;
use clap::builder::{PossibleValuesParser, TypedValueParser};
use line_maze_lab::explorer::name::Name;
use line_maze_lab::maze::file::Format;

use super::{MAZE_HELP, Marks, Options, names};

/// What `convert` takes.
#[derive(Args)]
#[command(mut_group("Options", |settings| settings.requires("route")))]
pub(crate) struct Convert {
    #[arg(value_name = "IN", help = MAZE_HELP)]
    pub(crate) from: PathBuf,
    /// The file to write: .maze (text), .json (for programs), .svg (a picture in true size); walls also as
    /// micromouse files: .txt (drawing), .map, .num (mms), .maz (bytes); or - for standard output, with --to
    #[arg(value_name = "OUT")]
    pub(crate) out: PathBuf,
    /// The format, whatever OUT is called
    #[arg(long = "to", value_name = "FORMAT", value_parser = formats())]
    pub(crate) format: Option<Format>,
    #[command(flatten)]
    pub(crate) marks: Marks,
    /// Draw the way to the finish that a run leaves, into an .svg
    #[arg(long)]
    pub(crate) route: bool,
    /// With --route: whose run
    #[arg(long, value_name = "NAME", default_value_t, value_parser = names(), hide_possible_values = true,
        requires = "route")]
    pub(crate) explorer: Name,
    #[command(flatten)]
    pub(crate) settings: Options,
}

/// What there is to know besides.
pub(super) const HELP: &str = "\
What IN is, its content tells. OUT is replaced if it exists.

Exit status: 0 written, 1 the run left no route to draw, 2 bad input, or IN cannot be said in that format.

Examples:
  linemaze convert mine.maze mine.svg --route --explorer mapping
  linemaze generate --kind wall | linemaze convert - - --to map";

/// Formats, as their files end.
fn formats() -> impl TypedValueParser<Value = Format> {
    PossibleValuesParser::new(Format::ALL.map(Format::extension))
        .try_map(|extension| Format::of_extension(&extension).ok_or("there is no such format"))
}
