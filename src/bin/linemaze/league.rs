//! `linemaze league`: chosen explorers over many mazes, on all cores.

use std::fs;
use std::io::Write;
use std::path::Path;

use indicatif::ParallelProgressIterator;
use line_maze_lab::compare::league::{
    Course, CourseResult, League, Standing, absences, absent_runs, results_csv, standings, standings_csv,
};
use line_maze_lab::compare::score::Column;
use line_maze_lab::maze::{Reading, generate};
use rayon::prelude::*;

use crate::args::put_finish;
use crate::compare::decimals;
use crate::count;
use crate::explore;
use crate::folders::Files;
use crate::table::{self, number};
use crate::{Failure, Status, args, files, progress};

/// Mazes in which somebody could not start are named up to here: nobody reads more.
const MOST_ABSENCES: usize = 10;

/// `linemaze league`
pub(crate) fn league(args: &args::League, out: &mut impl Write) -> Result<Status, Failure> {
    let to_output =
        [&args.csv, &args.standings_csv].into_iter().flatten().filter(|path| is_output(path)).count();
    if to_output > 1 {
        return Err(Failure::Message(
            "--csv - and --standings-csv - would mix; write one of them into a file".to_owned(),
        ));
    }
    let names = args.explorers().map_err(|error| Failure::Message(format!("--explorers: {error}")))?;
    let (courses, unusable) = courses(args)?;
    if courses.is_empty() {
        return Err(Failure::Message(
            "no maze to run in; name files, or --samples, or --generate N".to_owned(),
        ));
    }
    let settings = args.settings.settings();
    for course in &courses {
        explore::fits(course.scale(), &settings)
            .map_err(|error| Failure::Message(format!("{}: {error}", course.name())))?;
    }
    let league = League { names, settings, courses };
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
        tell(&league, &results, &standings, out)?;
    }
    Ok(if unusable == 0 { Status::Good } else { Status::Bad })
}

/// Whether a path means standard output.
fn is_output(path: &Path) -> bool {
    path == Path::new("-")
}

fn write(path: &Path, text: &str, out: &mut impl Write) -> Result<(), Failure> {
    if is_output(path) {
        return Ok(out.write_all(text.as_bytes())?);
    }
    fs::write(path, text).map_err(|error| Failure::at(path, &error))
}

/// All the mazes, and how many files and folders gave none; those are named on standard error.
fn courses(args: &args::League) -> Result<(Vec<Course>, usize), Failure> {
    let mut courses = Vec::new();
    let Files { found, mut unusable, .. } = Files::of(&args.mazes);
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
                unusable += 1;
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
    Ok((courses, unusable))
}

/// The standings: how many of the courses that could be solved were, medians, and who could not start.
fn tell(
    league: &League,
    results: &[CourseResult],
    standings: &[Standing],
    out: &mut impl Write,
) -> Result<(), Failure> {
    let mut heads = vec!["explorer", "runs", "not started", "solved", "%"];
    heads.extend(Column::ALL.map(Column::title));
    let mut rows: Vec<Vec<String>> = vec![heads.into_iter().map(str::to_owned).collect()];
    for standing in standings {
        let median = |column| {
            let quartiles = standing.quartiles(column);
            number(quartiles.map(|quartiles| quartiles.median), decimals(column))
        };
        let start = [
            standing.name.short().to_owned(),
            standing.runs.to_string(),
            standing.absent.to_string(),
            format!("{} of {}", standing.solved, standing.solvable()),
            standing.percent_solved().map_or_else(|| "-".to_owned(), |percent| percent.to_string()),
        ];
        rows.push(start.into_iter().chain(Column::ALL.map(median)).collect());
    }
    let mazes = count::count(league.courses.len(), "maze");
    writeln!(out, "{mazes}. Solved: of those with a way to the finish. Columns after it: medians.")?;
    table::print(&rows, usize::MAX, out)?;
    let absences = absences(results);
    if !absences.is_empty() {
        writeln!(out, "{}:", absent_runs(&absences))?;
    }
    for absence in absences.iter().take(MOST_ABSENCES) {
        let maze = league.courses.get(absence.course).map(Course::title).unwrap_or_default();
        writeln!(out, "  {maze}: {}", absence.words(league))?;
    }
    if absences.len() > MOST_ABSENCES {
        writeln!(out, "  and {} more; --csv FILE has them all", absences.len() - MOST_ABSENCES)?;
    }
    Ok(())
}
