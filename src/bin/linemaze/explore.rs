//! `linemaze run` and `linemaze trace`: exploring a maze, for people and for programs.

use std::io::Write;

use line_maze_lab::brief::brief;
use line_maze_lab::compare::score::told;
use line_maze_lab::event::Outcome;
use line_maze_lab::geometry::{Heading, Turn};
use line_maze_lab::ink::Ink;
use line_maze_lab::maze::{Maze, Scale};
use line_maze_lab::playback::Timeline as _;
use line_maze_lab::recording::Cursor;
use line_maze_lab::report::{NODE_BYTES, Report, StopReport};
use line_maze_lab::run::AnyRun;
use line_maze_lab::settings::Settings;
use serde::Serialize;

use crate::args::Explore;
use crate::count::count;
use crate::{Failure, Status, files};

/// `linemaze run`
pub(crate) fn run(args: &Explore, out: &mut impl Write) -> Result<Status, Failure> {
    let (maze, settings, run) = explored(args)?;
    let report = Report::of_run(&maze, &settings, &run);
    if args.json {
        write_json(&report, out)?;
    } else {
        tell(&maze, &run, &report, out)?;
    }
    Ok(status(&run))
}

/// `linemaze trace`
pub(crate) fn trace(args: &Explore, out: &mut impl Write) -> Result<Status, Failure> {
    let (maze, settings, run) = explored(args)?;
    if !args.json {
        write_row(COLUMNS.map(|(head, _)| head.to_owned()), out)?;
    }
    match &run {
        AnyRun::Book(book) => {
            let ink = Ink::of(&maze, book.trace(), settings.pace.cell_ms(maze.scale));
            for stop in (1..=run.stops()).filter_map(|stop| StopReport::of(book.trace(), &ink, stop)) {
                write_stop(args, &stop, out)?;
            }
        }
        AnyRun::Other(recording) => {
            let mut cursor = Cursor::default();
            for stop in 0..=run.stops() {
                write_stop(args, &StopReport::of_recording(recording, &mut cursor, stop), out)?;
            }
        }
    }
    if !args.json {
        if let Some(start) = maze.start().filter(|start| start.heading != Heading::North) {
            writeln!(
                out,
                "N of the robot, where it faced at the start, is the drawing’s {}",
                start.heading.word()
            )?;
        }
        writeln!(out, "{}", told(&maze, run.outcome()))?;
    }
    Ok(status(&run))
}

fn write_stop(args: &Explore, stop: &StopReport, out: &mut impl Write) -> Result<(), Failure> {
    if args.json { write_json(stop, out) } else { write_row(cells(stop), out) }
}

fn explored(args: &Explore) -> Result<(Maze, Settings, AnyRun), Failure> {
    let maze = files::open(&args.maze)?;
    let settings = checked(&maze, args.settings.settings())?;
    let name = files::name(&args.maze.path);
    let run = line_maze_lab::run::record(&maze, &settings, args.explorer)
        .map_err(|error| Failure::Message(format!("{name}: {error}")))?;
    Ok((maze, settings, run))
}

/// The settings, if a robot can have them in this maze.
pub(crate) fn checked(maze: &Maze, settings: Settings) -> Result<Settings, Failure> {
    fits(maze.scale, &settings).map_err(Failure::Message)?;
    Ok(settings)
}

/// Whether a robot can drive so fast, or so slowly, where cells have this size.
pub(crate) fn fits(scale: Scale, settings: &Settings) -> Result<(), String> {
    let speed = settings.pace.speed_mm_s.to_string();
    settings.pace.checked(scale).map_err(|error| format!("--speed {}: {error}", brief(&speed)))?;
    Ok(())
}

const fn status(run: &AnyRun) -> Status {
    match run.outcome() {
        Outcome::Finish | Outcome::Mapped => Status::Good,
        Outcome::NoFinishReachable
        | Outcome::Circling { .. }
        | Outcome::Stuck
        | Outcome::PathFull { .. }
        | Outcome::TableFull { .. }
        | Outcome::NoLine { .. }
        | Outcome::TooManyStops { .. }
        | Outcome::Cut(_) => Status::Bad,
    }
}

/// One line of JSON.
pub(crate) fn write_json(report: &impl Serialize, out: &mut impl Write) -> Result<(), Failure> {
    let json = serde_json::to_string(report).map_err(|error| Failure::Message(error.to_string()))?;
    writeln!(out, "{json}")?;
    Ok(())
}

/// The report for people.
fn tell(maze: &Maze, run: &AnyRun, report: &Report, out: &mut impl Write) -> Result<(), Failure> {
    if !maze.about.title.is_empty() {
        writeln!(out, "{}", maze.about.title)?;
    }
    writeln!(out, "outcome      {}", told(maze, run.outcome()))?;
    let Report { stops, decisions, distance_cells, distance_mm, seconds, .. } = report;
    let cells = count(distance_cells, "cell");
    writeln!(out, "exploration  {cells} ({distance_mm} mm) in {seconds:.1} s")?;
    writeln!(out, "             {}, {decisions} of them at nodes", count(stops, "stop"))?;
    let Report { right_turns, left_turns, u_turns, memory_bytes, .. } = report;
    writeln!(
        out,
        "             {} to the right, {left_turns} to the left, {}",
        count(right_turns, "turn"),
        count(u_turns, "U-turn")
    )?;
    let bytes = count(memory_bytes, "byte");
    match report.ptr {
        Some(ptr) => {
            let nodes = count(memory_bytes / NODE_BYTES, "node");
            writeln!(out, "memory       {bytes}: {nodes} at once; ptr = {ptr} at the end")?;
        }
        None => writeln!(out, "memory       {bytes}: {}", run.name().about().bytes)?,
    }
    if let (Some(cells), Some(seconds)) = (report.route_cells, report.route_s) {
        let turns = shown(report.turns.as_deref().unwrap_or_default());
        writeln!(out, "route        {} in {seconds:.1} s: {turns}", count(cells, "cell"))?;
    } else if let Some(reason) = report.reason.as_ref().filter(|_| status(run) == Status::Good) {
        writeln!(out, "route        none: {reason}")?;
    }
    let bests = [
        ("shortest", report.shortest_cells.zip(report.shortest_s), report.ratio_shortest),
        ("fastest ", report.fastest_cells.zip(report.fastest_s), report.ratio_fastest),
    ];
    for (name, best, ratio) in bests {
        let Some((cells, seconds)) = best else { continue };
        let ratio = ratio.map_or(String::new(), |ratio| format!("; the route is {ratio:.2} times that"));
        writeln!(out, "{name}     {} in {seconds:.1} s{ratio}", count(cells, "cell"))?;
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

/// The columns of the table of stops, each with its width.
const COLUMNS: [(&str, usize); 12] = [
    ("stop", 5),
    ("at", 8),
    ("seen", 9),
    ("case", 23),
    ("node", 5),
    ("turn", 5),
    ("leaves", 7),
    ("ptr", 5),
    ("returning", 10),
    ("cur_x", 8),
    ("cur_y", 8),
    ("crossed", 0),
];

/// A stop in words, a column each.
fn cells(stop: &StopReport) -> [String; 12] {
    fn or_dash<T: ToString>(value: Option<T>) -> String {
        value.map_or_else(|| "-".to_owned(), |value| value.to_string())
    }
    let shown = &stop.shown;
    [
        stop.stop.to_string(),
        format!("{},{}", stop.at[0], stop.at[1]),
        shown.seen.to_owned(),
        or_dash(shown.case),
        or_dash(stop.node),
        or_dash(shown.turn.map(Turn::letter)),
        or_dash(shown.leaves),
        or_dash(stop.ptr),
        or_dash(stop.returning),
        stop.cur_x.to_string(),
        stop.cur_y.to_string(),
        or_dash(stop.crossed_cells),
    ]
}

fn write_row(cells: [String; 12], out: &mut impl Write) -> Result<(), Failure> {
    let cells = cells.iter().zip(COLUMNS);
    let row: String = cells.map(|(cell, (_, width))| format!("{cell:width$}")).collect();
    writeln!(out, "{}", row.trim_end())?;
    Ok(())
}
