//! What a sentence claims of the floor, the floor holds: over all samples, all explorers, random mazes, orders, and
//! tolerances that are too large or too small.

use std::collections::BTreeSet;

use line_maze_lab::event::Outcome;
use line_maze_lab::explorer::book::Case;
use line_maze_lab::explorer::book::narrate::{Narration, Span, narrate};
use line_maze_lab::explorer::name::{Name, Stops};
use line_maze_lab::geometry::{Heading, Point};
use line_maze_lab::ink::{CellState, Ink};
use line_maze_lab::maze::{Maze, samples::SAMPLES};
use line_maze_lab::playback::Timeline;
use line_maze_lab::route::best;
use line_maze_lab::run::{AnyRun, record};
use line_maze_lab::settings::{Order, Rule, Settings};
use line_maze_lab::trace::{Moment, Trace};
use proptest::prelude::*;

use crate::support::random::{orders, recipes};

/// A cell of line by its southern or western end.
type Cell = (Point, Heading);

const fn cell(at: Point, heading: Heading) -> Cell {
    match heading {
        Heading::North | Heading::East => (at, heading),
        Heading::South | Heading::West => (at.step(heading), heading.opposite()),
    }
}

/// Where each stop is.
fn places(maze: &Maze, run: &AnyRun) -> Vec<Point> {
    match run {
        AnyRun::Book(run) => {
            let ink = Ink::of(maze, run.trace(), run.cell_ms());
            (0..=run.trace().stops()).map(|stop| ink.place(stop)).collect()
        }
        AnyRun::Other(run) => run.places().collect(),
    }
}

/// The cells that are driven up to a stop.
fn driven(places: &[Point]) -> BTreeSet<Cell> {
    let mut cells = BTreeSet::new();
    for pair in places.windows(2) {
        let mut at = pair[0];
        while at != pair[1] {
            let nearer = |h: &Heading| at.step(*h).distance(pair[1]) < at.distance(pair[1]);
            let heading = Heading::ALL.into_iter().find(nearer).unwrap();
            cells.insert(cell(at, heading));
            at = at.step(heading);
        }
    }
    cells
}

/// The points and cells that lines join to the start.
fn reachable(maze: &Maze) -> (BTreeSet<Point>, BTreeSet<Cell>) {
    let start = maze.start().unwrap().at;
    let (mut points, mut cells, mut todo) = (BTreeSet::from([start]), BTreeSet::new(), vec![start]);
    while let Some(at) = todo.pop() {
        for heading in maze.ways(at).iter() {
            cells.insert(cell(at, heading));
            if points.insert(at.step(heading)) {
                todo.push(at.step(heading));
            }
        }
    }
    (points, cells)
}

fn told(run: &AnyRun, stop: u32) -> Narration {
    match run {
        AnyRun::Book(run) => narrate(run.trace(), &run.trace().frame(Moment::after(stop))),
        AnyRun::Other(run) => run.narrate(&run.at(stop)),
    }
}

/// Whether any of these words is said, in full or in short.
fn says(told: &Narration, words: &[&str]) -> bool {
    [told.text(), told.short_text()].iter().any(|text| words.iter().any(|word| text.contains(word)))
}

/// What the end of a run claims.
fn the_end_is_so(maze: &Maze, run: &AnyRun) {
    let name = run.name();
    let end = told(run, run.stops());
    let places = places(maze, run);
    let (points, cells) = reachable(maze);
    let context = || format!("{name}: {}\n{maze:?}", end.text());
    let every_line = ["every line", "exploration is finished"];
    if says(&end, &every_line) && name.about().stops == Stops::Line {
        assert_eq!(driven(&places), cells, "{}", context());
    }
    if says(&end, &["every square", "map is complete"]) {
        assert_eq!(places.iter().copied().collect::<BTreeSet<_>>(), points, "{}", context());
    }
    if says(&end, &["none led to a finish", "No way that could still be there", "no finish found"]) {
        let reached = maze.finish().iter().any(|at| points.contains(at));
        assert!(!reached, "there is a way to the finish. {}", context());
    }
    let is_the_way = ["is the way here", "is the route", "are the route", "is the way from the start"];
    if says(&end, &is_the_way) {
        let way = run.way(maze).unwrap();
        assert!(way.route.is_ok(), "{:?}. {}", way.route, context());
    }
    if let Outcome::Circling { first, again } = run.outcome() {
        assert_eq!(places[first as usize], places[again as usize]);
        assert!(says(&end, &[&format!("stop {first}.")]), "{}", context());
    }
}

/// What the book's stops claim of the paths.
fn the_book_s_stops_are_so(maze: &Maze, trace: &Trace, cell_ms: u32) {
    let ink = Ink::of(maze, trace, cell_ms);
    let north = ink.north();
    for stop in 1..=trace.stops() {
        let step = trace.step(stop).unwrap();
        let told = narrate(trace, &trace.frame(Moment::after(stop)));
        if told.text().contains("a path it had never taken") {
            let arrived = step.arrival().out_of_frame_of(north);
            let last = cell(ink.place(stop).step(arrived.opposite()), arrived);
            assert_eq!(ink.cell(last, stop - 1), CellState::Clean, "stop {stop}: {}\n{maze:?}", told.text());
        }
        if step.case() == Case::UnknownUturn && trace.knew_its_places(stop) {
            for span in &told.said {
                let Span::Way { node, heading } = *span else { continue };
                let at = ink.place(trace.row(Moment::after(stop), node).unwrap().met);
                let way = cell(at, heading.out_of_frame_of(north));
                assert_eq!(ink.cell(way, stop), CellState::Clean, "stop {stop}: {}", told.text());
            }
        }
        if says(&told, &["is back at", "Back at"]) && step.node() > 0 {
            let row = trace.row(Moment::after(stop - 1), step.node()).unwrap();
            assert_eq!(ink.place(row.met), ink.place(stop), "stop {stop}: {}\n{maze:?}", told.text());
        }
    }
}

fn all_is_so(maze: &Maze, settings: &Settings) {
    for &name in Name::ALL {
        let Ok(run) = record(maze, settings, name) else { continue };
        the_end_is_so(maze, &run);
        if let AnyRun::Book(run) = &run {
            the_book_s_stops_are_so(maze, run.trace(), run.cell_ms());
        }
    }
}

#[test]
fn every_sample_is_told_as_it_is() {
    for sample in SAMPLES {
        for rule in [Rule::Special1, Rule::Basic] {
            all_is_so(&sample.maze(), &Settings { rule, ..Settings::default() });
        }
    }
}

#[test]
fn a_wrong_tolerance_claims_nothing_of_the_floor() {
    // Two and a half cells: places are taken for each other.
    let settings = Settings { epsilon_ms: Some(1000), ..Settings::default() };
    let run = record(&crate::support::figure_3_1(), &settings, Name::Book).unwrap();
    let taken = (1..=run.stops()).map(|stop| told(&run, stop).text());
    assert!(taken.into_iter().any(|text| text.contains("takes this place for node 1")));
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 1000, failure_persistence: None, ..ProptestConfig::default() })]

    #[test]
    fn random_runs_are_told_as_they_are(
        recipe in recipes(6),
        order in orders(),
        basic in any::<bool>(),
    ) {
        let rule = if basic { Rule::Basic } else { Rule::Special1 };
        all_is_so(&recipe.maze(), &Settings { order, rule, node_max: 1000, ..Settings::default() });
    }

    #[test]
    fn also_where_places_are_mixed_up(recipe in recipes(6), epsilon in 0u32..2500, order in orders()) {
        let settings = Settings { epsilon_ms: Some(epsilon), order, node_max: 1000, ..Settings::default() };
        let maze = recipe.maze();
        let Ok(AnyRun::Book(run)) = record(&maze, &settings, Name::Book) else { return Ok(()) };
        the_book_s_stops_are_so(&maze, run.trace(), run.cell_ms());
        the_end_is_so(&maze, &AnyRun::Book(run));
    }
}

/// What an explorer is said not to be able to do, its sample shows.
#[test]
fn the_sample_of_each_explorer_shows_what_it_cannot_do() {
    for &name in Name::ALL {
        let about = name.about();
        let sample = SAMPLES.iter().find(|sample| sample.file == about.sample).unwrap();
        let (maze, settings) = (
            sample.maze(),
            Settings { order: Order::Fixed(line_maze_lab::settings::Preference::SRL), ..Settings::default() },
        );
        let run = record(&maze, &settings, name).unwrap();
        let shortest = best::shortest(&maze, maze.start().unwrap(), &settings.pace).map(|best| best.cells);
        let route = run.way(&maze).and_then(|way| way.route.ok()).map(|route| route.cells());
        let longer = route > shortest && shortest.is_some();
        let circles = matches!(run.outcome(), Outcome::Circling { .. });
        let (_, cells) = reachable(&maze);
        let drove_all = driven(&places(&maze, &run)).len() == cells.len();
        assert!(
            match name {
                // Its route need not be short.
                Name::Book | Name::Tremaux | Name::DepthFirst => longer && !drove_all,
                // It can go round for ever.
                Name::LeftHand | Name::RightHand | Name::Cornell1 | Name::Cornell2 => circles,
                // A lap in the numbers.
                Name::DirectionSumRight => longer,
                // The finish inside a loop.
                Name::DirectionSumLeft | Name::ParexLeft => circles,
                // It drives every line, though the finish is near.
                Name::Mapping => drove_all,
                Name::Cornell3 => run.outcome() == Outcome::Mapped,
                // A shorter side that it does not notice.
                Name::ParexRight => longer,
                // Its first way there is not the shortest.
                Name::FloodFill => run.tally(run.stops()).cells > shortest.unwrap(),
            },
            "{name} on {}: {:?}, route {route:?} of {shortest:?}, drove all {drove_all}",
            about.sample,
            run.outcome()
        );
    }
}
