//! `linemaze run` and `linemaze trace`: exploring a maze, for people and for programs.

use std::io::Write;

use line_maze_lab::event::Outcome;
use line_maze_lab::ink::Ink;
use line_maze_lab::maze::Maze;
use line_maze_lab::report::{NODE_BYTES, Report, StopReport};
use line_maze_lab::settings::{MAX_CELL_MS, Settings};
use line_maze_lab::trace::Trace;
use serde::Serialize;

use crate::args::Explore;
use crate::{Failure, Status, files};

/// `linemaze run`
pub(crate) fn run(args: &Explore, out: &mut impl Write) -> Result<Status, Failure> {
    let (maze, settings, trace) = explored(args)?;
    let report = Report::of(&maze, &settings, &trace);
    if args.json {
        write_json(&report, out)?;
    } else {
        tell(&maze, &trace, &report, out)?;
    }
    Ok(status(&trace))
}

/// `linemaze trace`
pub(crate) fn trace(args: &Explore, out: &mut impl Write) -> Result<Status, Failure> {
    let (maze, settings, trace) = explored(args)?;
    let ink = Ink::of(&maze, &trace, settings.pace.cell_ms(maze.scale));
    if !args.json {
        let heads =
            ["stop", "at", "seen", "case", "node", "leaves", "ptr", "returning", "cur_x", "cur_y", "crossed"];
        write_row(heads.map(str::to_owned), out)?;
    }
    for stop in (1..=trace.stops()).filter_map(|stop| StopReport::of(&trace, &ink, stop)) {
        if args.json {
            write_json(&stop, out)?;
        } else {
            write_row(cells(&stop), out)?;
        }
    }
    if !args.json {
        writeln!(out, "{}", trace.outcome())?;
    }
    Ok(status(&trace))
}

fn explored(args: &Explore) -> Result<(Maze, Settings, Trace), Failure> {
    let maze = files::read(&args.maze)?;
    let settings = args.settings();
    let (cell_mm, speed) = (maze.scale.cell_mm(), settings.pace.speed_mm_s);
    let most = f64::from(MAX_CELL_MS) / 1000.0;
    if cell_mm / speed > most {
        return Err(Failure::Message(format!(
            "--speed {speed}: a cell of {cell_mm} mm would take longer than {most} s; choose {} or more",
            cell_mm / most
        )));
    }
    let name = files::name(&args.maze);
    let trace = line_maze_lab::run::explore(&maze, &settings)
        .map_err(|error| Failure::Message(format!("{name}: {error}")))?;
    Ok((maze, settings, trace))
}

const fn status(trace: &Trace) -> Status {
    match trace.outcome() {
        Outcome::Finish => Status::Good,
        Outcome::NoFinishReachable
        | Outcome::TableFull { .. }
        | Outcome::NoLine { .. }
        | Outcome::TooManyStops { .. }
        | Outcome::Cut(_) => Status::Bad,
    }
}

/// One line of JSON.
fn write_json(report: &impl Serialize, out: &mut impl Write) -> Result<(), Failure> {
    let json = serde_json::to_string(report).map_err(|error| Failure::Message(error.to_string()))?;
    writeln!(out, "{json}")?;
    Ok(())
}

/// The report for people.
fn tell(maze: &Maze, trace: &Trace, report: &Report, out: &mut impl Write) -> Result<(), Failure> {
    if !maze.about.title.is_empty() {
        writeln!(out, "{}", maze.about.title)?;
    }
    writeln!(out, "outcome      {}", trace.outcome())?;
    let Report { stops, decisions, distance_cells, distance_mm, seconds, ptr, .. } = report;
    writeln!(out, "exploration  {distance_cells} cells ({distance_mm} mm) in {seconds:.1} s")?;
    writeln!(out, "             {stops} stops, {decisions} of them at nodes")?;
    let Report { right_turns, left_turns, u_turns, memory_bytes, .. } = report;
    writeln!(
        out,
        "             {right_turns} turns to the right, {left_turns} to the left, {u_turns} U-turns"
    )?;
    writeln!(
        out,
        "memory       {memory_bytes} bytes: {} nodes at once; ptr = {ptr} at the end",
        memory_bytes / NODE_BYTES
    )?;
    if let (Some(cells), Some(seconds)) = (report.route_cells, report.route_s) {
        let turns = shown(report.turns.as_deref().unwrap_or_default());
        writeln!(out, "route        {cells} cells in {seconds:.1} s: {turns}")?;
    } else if let Some(reason) = report.reason.as_ref().filter(|_| trace.outcome() == Outcome::Finish) {
        writeln!(out, "route        none: {reason}")?;
    }
    let bests = [
        ("shortest", report.shortest_cells.zip(report.shortest_s), report.ratio_shortest),
        ("fastest ", report.fastest_cells.zip(report.fastest_s), report.ratio_fastest),
    ];
    for (name, best, ratio) in bests {
        let Some((cells, seconds)) = best else { continue };
        let ratio = ratio.map_or(String::new(), |ratio| format!("; the route is {ratio:.2} times that"));
        writeln!(out, "{name}     {cells} cells in {seconds:.1} s{ratio}")?;
    }
    Ok(())
}

/// A turn list as far as it fits a line.
fn shown(turns: &str) -> String {
    const MOST: usize = 60;
    match turns.get(..MOST) {
        _ if turns.is_empty() => "no node on the way".to_owned(),
        Some(first) if turns.len() > MOST => {
            format!("{first}… ({} turns; --json prints them all)", turns.len())
        }
        _ => turns.to_owned(),
    }
}

/// A stop in words, a column each.
fn cells(stop: &StopReport) -> [String; 11] {
    let or_dash = |text: Option<String>| text.unwrap_or_else(|| "-".to_owned());
    [
        stop.stop.to_string(),
        format!("{},{}", stop.at[0], stop.at[1]),
        stop.seen.to_owned(),
        or_dash(stop.case.map(str::to_owned)),
        or_dash(stop.node.map(|node| node.to_string())),
        or_dash(stop.leaves.map(|way| way.to_string())),
        stop.ptr.to_string(),
        stop.returning.to_string(),
        stop.cur_x.to_string(),
        stop.cur_y.to_string(),
        stop.crossed_cells.to_string(),
    ]
}

fn write_row(cells: [String; 11], out: &mut impl Write) -> Result<(), Failure> {
    const WIDTHS: [usize; 11] = [5, 8, 9, 14, 5, 7, 5, 10, 8, 8, 0];
    let row: String = cells.iter().zip(WIDTHS).map(|(cell, width)| format!("{cell:width$}")).collect();
    writeln!(out, "{}", row.trim_end())?;
    Ok(())
}
