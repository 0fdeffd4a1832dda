//! `linemaze compare`: explorers side by side in one maze, and the luck in random orders.

use std::io::Write;

use indicatif::ParallelProgressIterator;
use line_maze_lab::compare::forks::letter;
use line_maze_lab::compare::orders::{Bar, Draws, draw};
use line_maze_lab::compare::score::{Bests, Column};
use line_maze_lab::compare::{Entrant, Lineup, parting};
use line_maze_lab::explorer::name::Name;
use line_maze_lab::maze::Maze;
use line_maze_lab::report::{NotStarted, Report};
use line_maze_lab::settings::Settings;
use line_maze_lab::world::CannotStart;
use rayon::prelude::*;

use crate::args::Compare;
use crate::count::count;
use crate::explore::{self, write_json};
use crate::table::{self, number};
use crate::{Failure, Status, files, progress};

/// `linemaze compare`
pub(crate) fn compare(args: &Compare, out: &mut impl Write) -> Result<Status, Failure> {
    let maze = files::open(&args.maze)?;
    let settings = explore::checked(&maze, args.settings.settings())?;
    let name = files::name(&args.maze.path);
    if let Some(draws) = args.random_orders {
        return random_orders(&maze, &settings, &name, draws, out);
    }
    let lineup = Lineup::new(args.explorers.clone())
        .map_err(|error| Failure::Message(format!("--explorers: {error}")))?;
    let bests = Bests::of(&maze, &settings);
    let run = |&explorer| (explorer, Entrant::of(&maze, &settings, explorer, &bests));
    let bar = progress::bar(lineup.names().len() as u64);
    let entrants: Vec<(Name, Result<Entrant, CannotStart>)> =
        lineup.names().par_iter().progress_with(bar).map(run).collect();
    if entrants.iter().all(|(_, entrant)| entrant.is_err()) {
        return Err(Failure::Message(format!("{name}: no explorer can start. {}", reasons(&entrants))));
    }
    if args.json {
        for (explorer, entrant) in &entrants {
            match entrant {
                Ok(entrant) => write_json(&Report::of_run(&maze, &settings, &entrant.run), out)?,
                Err(why) => write_json(&NotStarted::of(*explorer, *why), out)?,
            }
        }
        return Ok(Status::Good);
    }
    let mut rows = vec![head()];
    rows.extend(entrants.iter().enumerate().map(|(nth, (explorer, entrant))| row(nth, *explorer, entrant)));
    table::print(&rows, Column::ALL.len() + 1, out)?;
    for (what, best) in [("shortest", bests.shortest), ("fastest", bests.fastest)] {
        if let Some(best) = best {
            writeln!(out, "the {what} route: {} in {:.1} s", count(best.cells, "cell"), best.seconds)?;
        }
    }
    let mut started = entrants
        .iter()
        .enumerate()
        .filter_map(|(nth, (_, entrant))| Some((letter(nth), &entrant.as_ref().ok()?.run)));
    if let Some((one, first)) = started.next() {
        for (other, run) in started {
            match parting::first(&maze, first, run) {
                Some(parting) => writeln!(out, "{}", parting.words([one, other]))?,
                None => writeln!(out, "{one} and {other} drive the same way.")?,
            }
        }
    }
    Ok(Status::Good)
}

/// Why explorers cannot start, each reason once.
fn reasons(entrants: &[(Name, Result<Entrant, CannotStart>)]) -> String {
    let mut reasons: Vec<String> = Vec::new();
    for why in entrants.iter().filter_map(|(_, entrant)| entrant.as_ref().err()) {
        let reason = why.to_string();
        if !reasons.contains(&reason) {
            reasons.push(reason);
        }
    }
    reasons.join(" ")
}

fn head() -> Vec<String> {
    let columns = Column::ALL.iter().map(|column| column.title().to_owned());
    ["   explorer".to_owned()].into_iter().chain(columns).chain(["outcome".to_owned()]).collect()
}

/// The row of an explorer; of one that cannot start: no numbers, and why.
fn row(nth: usize, explorer: Name, entrant: &Result<Entrant, CannotStart>) -> Vec<String> {
    let score = entrant.as_ref().map(|entrant| &entrant.score);
    let columns = Column::ALL
        .iter()
        .map(|&column| number(score.ok().and_then(|score| score.number(column)), decimals(column)));
    let end = match score {
        Ok(score) => score.reason().unwrap_or_else(|| score.outcome.to_string()),
        Err(why) => format!("cannot start: {why}"),
    };
    let who = format!("{}  {}", letter(nth), explorer.short());
    [who].into_iter().chain(columns).chain([end]).collect()
}

/// Decimals that a column is shown with.
pub(crate) const fn decimals(column: Column) -> usize {
    match column {
        Column::Distance | Column::Stops | Column::Turns | Column::Memory | Column::Route => 0,
        Column::Seconds | Column::RouteSeconds => 1,
        Column::RatioShortest | Column::RatioFastest => 2,
    }
}

/// Many runs of the book's explorer, as a histogram of their routes' lengths.
fn random_orders(
    maze: &Maze,
    settings: &Settings,
    name: &str,
    draws: u32,
    out: &mut impl Write,
) -> Result<Status, Failure> {
    let drawn = (1..=draws).into_par_iter().progress_with(progress::bar(draws.into()));
    let draws: Result<Vec<_>, _> = drawn.map(|seed| draw(maze, settings, seed.into())).collect();
    let draws: Draws = draws.map_err(|why| Failure::Message(format!("{name}: {why}")))?.into_iter().collect();
    let shortest = Bests::of(maze, settings).shortest.map(|best| best.cells);
    let (solved, failed) = draws.counts();
    let bars = draws.bars(shortest, 20);
    let most = bars.iter().map(|bar| bar.count).max().unwrap_or(1).max(1);
    for Bar { from, to, count: routes } in bars {
        let cells = if from == to { from.to_string() } else { format!("{from}–{to}") };
        writeln!(
            out,
            "{:>17}  {routes:>6}  {}",
            count(cells, "cell"),
            "#".repeat((routes * 50).div_ceil(most))
        )?;
    }
    writeln!(out, "{}; {} left none", count(solved, "route"), count(failed, "run"))?;
    if let Some(shortest) = shortest {
        writeln!(
            out,
            "the shortest there is has {}: {} found one",
            count(shortest, "cell"),
            count(draws.at_most(shortest), "run")
        )?;
    }
    for (what, draw) in [("best ", draws.best()), ("worst", draws.worst())] {
        if let Some(draw) = draw {
            let cells = draw.route_cells.unwrap_or_default();
            writeln!(out, "{what}: {}, --order random:{}", count(cells, "cell"), draw.seed)?;
        }
    }
    Ok(if solved > 0 { Status::Good } else { Status::Bad })
}
