//! `linemaze convert`: a maze in another format; a picture can hold the way that a run leaves.

use std::fs;
use std::io::Write;
use std::path::Path;

use line_maze_lab::compare::score::{NoRoute, solved};
use line_maze_lab::geometry::Point;
use line_maze_lab::maze::file::{self, Format};
use line_maze_lab::maze::micromouse::CannotSay;
use line_maze_lab::maze::svg::{self, Way};
use line_maze_lab::run::record;

use crate::args::Convert;
use crate::count::count;
use crate::{Failure, Status, explore, files};

/// `linemaze convert`
pub(crate) fn convert(args: &Convert, out: &mut impl Write) -> Result<Status, Failure> {
    let format = format(args)?;
    let from = files::name(&args.from);
    let maze = files::marked(&args.from, &args.marks)?;
    let bytes = if args.route {
        if format != Format::Picture {
            return Err(Failure::Message("--route: only a picture holds a route; write an .svg".to_owned()));
        }
        let settings = explore::checked(&maze, args.settings.settings())?;
        let run = record(&maze, &settings, args.explorer)
            .map_err(|error| Failure::Message(format!("{from}: {error}")))?;
        let route = match solved(&maze, &run) {
            Ok(route) => route,
            Err(why) => return Ok(no_route(&from, why)),
        };
        let points: Vec<Point> =
            [route.start].into_iter().chain(route.legs.iter().map(|leg| leg.at)).collect();
        let title = format!("{}: {}", args.explorer.about().title, count(route.cells(), "cell"));
        svg::write_way(&maze, &Way { points: &points, title: &title }).into_bytes()
    } else {
        file::write(&maze, format).map_err(|error| {
            Failure::Message(format!(
                "{from}: cannot become a .{}: {error}{}",
                format.extension(),
                if error == CannotSay::Finish { " (--finish none leaves it out)" } else { "" }
            ))
        })?
    };
    if is_output(&args.out) {
        out.write_all(&bytes)?;
    } else {
        fs::write(&args.out, bytes).map_err(|error| Failure::at(&args.out, &error))?;
    }
    Ok(Status::Good)
}

/// Nothing is written: who asked for a route wants no picture without one.
fn no_route(from: &str, why: NoRoute) -> Status {
    crate::complain(&format!("{from}: no route: {why}"));
    Status::Bad
}

/// Whether a path means standard output.
fn is_output(path: &Path) -> bool {
    path == Path::new("-")
}

/// The format that is asked for, or that of OUT's extension.
fn format(args: &Convert) -> Result<Format, Failure> {
    if let Some(format) = args.format {
        return Ok(format);
    }
    if is_output(&args.out) {
        return Err(Failure::Message(
            "standard output has no extension to tell the format; say --to maze, json or svg, or for walls txt, map, num \
             or maz"
                .to_owned(),
        ));
    }
    let extension = args.out.extension().map(|extension| extension.to_string_lossy());
    extension.as_deref().and_then(Format::of_extension).ok_or_else(|| {
        Failure::Message(format!(
            "{}: the extension chooses the format; it is .maze, .json or .svg, or for walls .txt, .map, .num or \
             .maz; or say --to FORMAT",
            args.out.display()
        ))
    })
}
