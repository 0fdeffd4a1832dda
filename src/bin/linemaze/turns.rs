//! `linemaze turns`: the turn list of a run, for a board or for another program; and what can be done with letters.

use std::io::{self, Read, Write};
use std::path::Path;

use line_maze_lab::compare::score::solved;
use line_maze_lab::maze::json::MAX_BYTES;
use line_maze_lab::route::letters::{Misread, read};
use line_maze_lab::route::{Corners, TurnList, forms, lab};
use line_maze_lab::run::record;

use crate::args::{Turns, TurnsForm};
use crate::{Failure, Status, explore, files};

/// `linemaze turns`
pub(crate) fn turns(args: &Turns, out: &mut impl Write) -> Result<Status, Failure> {
    let (list, corners, title) = match (&args.path, &args.reduce, &args.reverse) {
        (Some(path), _, _) => match of_run(args, path)? {
            Some((list, title)) => (list, corners(args), title),
            None => return Ok(Status::Bad),
        },
        (None, Some(letters), _) => {
            let (_, left) = lab::reductions(&list("--reduce", letters)?);
            (left, Corners::LeftOut, String::new())
        }
        (None, None, letters) => {
            let letters = letters.as_deref().unwrap_or_default();
            (lab::reverse(&list("--reverse", letters)?), Corners::LeftOut, String::new())
        }
    };
    let form = match args.form {
        TurnsForm::Letters => forms::Form::Letters,
        TurnsForm::Json => forms::Form::Json,
        TurnsForm::Csv => forms::Form::Csv,
        TurnsForm::C => forms::Form::C,
    };
    out.write_all(forms::write(&list, form, corners, &title).as_bytes())?;
    Ok(Status::Good)
}

const fn corners(args: &Turns) -> Corners {
    if args.corners { Corners::Listed } else { Corners::LeftOut }
}

/// The list that a run leaves, and the maze's title; none where it leaves none, which is told.
fn of_run(args: &Turns, path: &Path) -> Result<Option<(TurnList, String)>, Failure> {
    let maze = files::marked(path, &args.marks)?;
    let settings = explore::checked(&maze, args.settings.settings())?;
    let name = files::name(path);
    let run = record(&maze, &settings, args.explorer)
        .map_err(|error| Failure::Message(format!("{name}: {error}")))?;
    match solved(&maze, &run) {
        Ok(route) => Ok(Some((route.list(corners(args)), maze.about.title))),
        Err(why) => {
            crate::complain(&format!("{name}: no turn list: {why}"));
            Ok(None)
        }
    }
}

/// The letters of an option, or of standard input where they are `-`.
fn list(option: &str, letters: &str) -> Result<TurnList, Failure> {
    if letters != "-" {
        return read(letters).map_err(|wrong| Failure::Message(format!("{option}: {wrong}")));
    }
    let name = files::name(Path::new(letters));
    let mut bytes = Vec::new();
    io::stdin()
        .lock()
        .take(MAX_BYTES as u64)
        .read_to_end(&mut bytes)
        .map_err(|error| Failure::at(Path::new(letters), &error))?;
    read(&String::from_utf8_lossy(&bytes)).map_err(|wrong| {
        let Misread { line, column, problem, .. } = wrong;
        Failure::Message(format!("{name}:{line}:{column}: {problem}"))
    })
}
