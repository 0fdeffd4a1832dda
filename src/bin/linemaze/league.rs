//! `linemaze league`: chosen explorers over many mazes, on all cores.

use std::fs;
use std::io::Write;
use std::path::Path;

use indicatif::ParallelProgressIterator;
use line_maze_lab::compare::league::{
    Course, CourseResult, League, Standing, results_csv, standings, standings_csv,
};
use line_maze_lab::compare::score::Column;
use line_maze_lab::maze::{Reading, generate};
use rayon::prelude::*;

use crate::args::put_finish;
use crate::compare::decimals;
use crate::count;
use crate::folders::Files;
use crate::table::{self, number};
use crate::{Failure, Status, args, files, progress};

/// `linemaze league`
pub(crate) fn league(args: &args::League, out: &mut impl Write) -> Result<Status, Failure> {
    let to_output =
        [&args.csv, &args.standings_csv].into_iter().flatten().filter(|path| is_output(path)).count();
    if to_output > 1 {
        return Err(Failure::Message(
            "--csv - and --standings-csv - would mix; write one of them into a file".to_owned(),
        ));
    }
    let (courses, unreadable) = courses(args)?;
    if courses.is_empty() {
        return Err(Failure::Message(
            "no maze to run in; name files, or --samples, or --generate N".to_owned(),
        ));
    }
    let settings = args.settings.settings();
    for course in &courses {
        let name = course.name();
        let pace = settings.pace.checked(course.scale());
        pace.map_err(|error| {
            Failure::Message(format!("{name}: --speed {}: {error}", settings.pace.speed_mm_s))
        })?;
    }
    let league = League { names: args.explorers(), settings, courses };
    let count = league.courses.len();
    let bar = progress::bar(count as u64);
    let results: Vec<CourseResult> =
        (0..count).into_par_iter().progress_with(bar).map(|course| league.run(course)).collect();
    let standings = standings(&league.names, &results);
    if let Some(path) = &args.csv {
        write(path, &results_csv(&league, &results), out)?;
    }
    if let Some(path) = &args.standings_csv {
        write(path, &standings_csv(&standings), out)?;
    }
    // A program that reads the CSV wants nothing else.
    if to_output == 0 {
        tell(&standings, count, out)?;
    }
    Ok(if unreadable == 0 { Status::Good } else { Status::Bad })
}

/// Whether a path means standard output.
fn is_output(path: &Path) -> bool {
    path == Path::new("-")
}

fn write(path: &Path, text: &str, out: &mut impl Write) -> Result<(), Failure> {
    if is_output(path) {
        return Ok(out.write_all(text.as_bytes())?);
    }
    fs::write(path, text).map_err(|error| Failure::Message(format!("{}: {error}", path.display())))
}

/// All the mazes, and how many files and folders could not be read; those are named on standard error.
fn courses(args: &args::League) -> Result<(Vec<Course>, usize), Failure> {
    let mut courses = Vec::new();
    let Files { found, mut unreadable, .. } = Files::of(&args.mazes);
    for path in &found {
        match files::read(path) {
            Ok(Reading { mut maze, .. }) => {
                let name = files::name(path);
                if maze.finish().is_empty() {
                    put_finish(&args.finish, &mut maze).map_err(|at| {
                        Failure::Message(format!("{name}: --finish {at} is off the lattice; choose centre"))
                    })?;
                }
                courses.push(Course::File { name, maze });
            }
            Err(Failure::Message(message)) => {
                unreadable += 1;
                crate::complain(&message);
            }
            Err(other) => return Err(other),
        }
    }
    if args.samples || args.mazes.is_empty() && args.generate.is_none() {
        courses.extend(Course::samples());
    }
    if let Some(count) = args.generate {
        let recipe = args.recipe.recipe();
        // What is wrong with one is wrong with all.
        generate::generate(&recipe).map_err(|error| Failure::Message(error.to_string()))?;
        courses.extend(Course::generated(recipe, count));
    }
    Ok((courses, unreadable))
}

/// The standings: how many courses were solved, and medians.
fn tell(standings: &[Standing], count: usize, out: &mut impl Write) -> Result<(), Failure> {
    let heads = ["explorer", "runs", "solved", "%"].map(str::to_owned);
    let mut rows: Vec<Vec<String>> =
        vec![heads.into_iter().chain(Column::ALL.map(|column| column.title().to_owned())).collect()];
    for standing in standings {
        let median = |column| {
            let quartiles = standing.quartiles(column);
            number(quartiles.map(|quartiles| quartiles.median), decimals(column))
        };
        let share = number(standing.share_solved().map(|share| share * 100.0), 0);
        let start =
            [standing.name.to_string(), standing.runs.to_string(), standing.solved.to_string(), share];
        rows.push(start.into_iter().chain(Column::ALL.map(median)).collect());
    }
    writeln!(out, "{}; medians", count::count(count, "maze"))?;
    table::print(&rows, usize::MAX, out)?;
    Ok(())
}
