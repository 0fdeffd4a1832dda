//! `linemaze turns`: the turn list of a run, for a board or for another program.

use std::io::Write;

use line_maze_lab::compare::score::solved;
use line_maze_lab::route::{Corners, forms};
use line_maze_lab::run::record;

use crate::args::{Turns, TurnsForm};
use crate::{Failure, Status, explore, files};

/// `linemaze turns`
pub(crate) fn turns(args: &Turns, out: &mut impl Write) -> Result<Status, Failure> {
    let maze = files::open(&args.maze)?;
    let settings = explore::checked(&maze, args.settings.settings())?;
    let name = files::name(&args.maze.path);
    let run = record(&maze, &settings, args.explorer)
        .map_err(|error| Failure::Message(format!("{name}: {error}")))?;
    let route = match solved(&maze, &run) {
        Ok(route) => route,
        Err(why) => {
            crate::complain(&format!("{name}: no turn list: {why}"));
            return Ok(Status::Bad);
        }
    };
    let corners = if args.corners { Corners::Listed } else { Corners::LeftOut };
    let form = match args.form {
        TurnsForm::Letters => forms::Form::Letters,
        TurnsForm::Json => forms::Form::Json,
        TurnsForm::Csv => forms::Form::Csv,
        TurnsForm::C => forms::Form::C,
    };
    let text = forms::write(&route.list(corners), form, corners, &maze.about.title);
    out.write_all(text.as_bytes())?;
    Ok(Status::Good)
}
