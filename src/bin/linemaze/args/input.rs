//! Which maze a command takes, and where its start and its finish are instead of where the file has them.

use std::path::PathBuf;
use std::str::FromStr;

use clap::Args;
use line_maze_lab::geometry::{Heading, Point};
use line_maze_lab::maze::{Maze, Remark, Start};

/// What is said of every maze file.
pub(crate) const MAZE_HELP: &str =
    "A maze file of any readable format (.maze, JSON, micromouse, grids of #), or - for standard input";

/// A maze file.
#[derive(Args)]
pub(crate) struct Input {
    #[arg(value_name = "MAZE", help = MAZE_HELP)]
    pub(crate) path: PathBuf,
    #[command(flatten)]
    pub(crate) marks: Marks,
}

/// Start and finish, where they are not to be those of the file.
#[derive(Args, Clone, Debug, Default)]
pub(crate) struct Marks {
    /// Where the finish is: centre (one, two or four squares in the middle), a point X,Y, or none; once for each
    /// point [default: as the file says]
    #[arg(long, value_name = "WHERE", allow_hyphen_values = true)]
    finish: Vec<Finish>,
    /// Where the robot is put down, and whether it faces N, E, S or W [default: as the file says]
    #[arg(long, value_name = "X,Y,N", allow_hyphen_values = true, value_parser = start)]
    start: Option<Start>,
}

/// What `--finish` takes.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Finish {
    /// The points around the middle.
    Centre,
    /// No point.
    None,
    /// One point.
    At(Point),
}

impl Marks {
    /// Whether a remark is about a mark that is set here.
    pub(crate) fn settle(&self, remark: &Remark) -> bool {
        match remark {
            Remark::NoFinish | Remark::FinishInCentre => !self.finish.is_empty(),
            Remark::Faces(_) | Remark::NoStart { .. } => self.start.is_some(),
            Remark::UnknownWalls { .. }
            | Remark::PartWalls { .. }
            | Remark::Posts { .. }
            | Remark::Before { .. }
            | Remark::After { .. }
            | Remark::Indented { .. }
            | Remark::Grid(_)
            | Remark::Entrance(_)
            | Remark::List(_) => false,
        }
    }

    /// Puts them on a maze.
    ///
    /// # Errors
    /// The option that leads off the lattice, in words.
    pub(crate) fn put_on(&self, maze: &mut Maze) -> Result<(), String> {
        let (sw, ne) = (maze.bounds().sw(), maze.bounds().ne());
        let off = |option, at| {
            format!("--{option} {at} is off the lattice, which goes from {sw} to {ne}; choose a point on it")
        };
        if let Some(start) = self.start
            && !maze.set_start(Some(start))
        {
            return Err(off("start", start.at));
        }
        put_finish(&self.finish, maze).map_err(|at| off("finish", at))
    }
}

/// Sets the finish, where one is given.
///
/// # Errors
/// The point that is off the lattice.
pub(crate) fn put_finish(finish: &[Finish], maze: &mut Maze) -> Result<(), Point> {
    if finish.is_empty() {
        return Ok(());
    }
    let bounds = maze.bounds();
    let mut points = Vec::new();
    for place in finish {
        match place {
            Finish::Centre => points.extend(bounds.centre()),
            Finish::None => {}
            &Finish::At(at) if bounds.contains(at) => points.push(at),
            &Finish::At(at) => return Err(at),
        }
    }
    maze.set_finish(points);
    Ok(())
}

impl FromStr for Finish {
    type Err = String;

    fn from_str(text: &str) -> Result<Self, String> {
        match text {
            "centre" | "center" => Ok(Self::Centre),
            "none" => Ok(Self::None),
            _ => point(text)
                .map(Self::At)
                .ok_or_else(|| "a finish is centre, none, or a point X,Y as in 7,8".to_owned()),
        }
    }
}

fn start(text: &str) -> Result<Start, String> {
    let parts = text.rsplit_once(',').and_then(|(at, heading)| {
        Some(Start { at: point(at)?, heading: heading.trim().parse::<Heading>().ok()? })
    });
    parts.ok_or_else(|| "a start is a point and where the robot faces, X,Y,N, as in 0,0,N".to_owned())
}

fn point(text: &str) -> Option<Point> {
    let (x, y) = text.split_once(',')?;
    Some(Point::new(x.trim().parse().ok()?, y.trim().parse().ok()?))
}
