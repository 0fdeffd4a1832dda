//! Explorers side by side: numbers, partings, places abreast, random orders and the league, over random mazes.
#![allow(clippy::unwrap_used, clippy::expect_used, missing_docs)]

mod support;

use line_maze_lab::compare::abreast::{self, Clock};
use line_maze_lab::compare::league::{
    Course, CourseResult, League, absences, results_csv, standings, standings_csv,
};
use line_maze_lab::compare::orders::{Draws, draw};
use line_maze_lab::compare::parting;
use line_maze_lab::compare::score::{Bests, Column, Score, solved};
use line_maze_lab::compare::{Entrant, Lineup, LineupError};
use line_maze_lab::event::Outcome;
use line_maze_lab::explorer::name::Name;
use line_maze_lab::geometry::{Heading, Point};
use line_maze_lab::ink::Ink;
use line_maze_lab::maze::generate::Recipe;
use line_maze_lab::maze::{Maze, samples};
use line_maze_lab::playback::Timeline;
use line_maze_lab::report::Report;
use line_maze_lab::run::{AnyRun, record};
use line_maze_lab::settings::Settings;
use line_maze_lab::world::CannotStart;
use proptest::prelude::*;
use support::random::{recipes, roomy};

/// Where each stop of a run is, the start first.
fn places(maze: &Maze, run: &AnyRun, settings: &Settings) -> Vec<Point> {
    match run {
        AnyRun::Book(run) => {
            let ink = Ink::of(maze, run.trace(), settings.pace.cell_ms(maze.scale));
            (0..=run.trace().stops()).map(|stop| ink.place(stop)).collect()
        }
        AnyRun::Other(run) => run.places().collect(),
    }
}

/// Every point that is driven over, in order, with the last stop up to there.
fn walked(places: &[Point]) -> Vec<(Point, u32)> {
    let mut walk = vec![(places[0], 0)];
    for (pair, stop) in places.windows(2).zip(1..) {
        let mut at = pair[0];
        while at != pair[1] {
            let nearer = |h: &Heading| at.step(*h).distance(pair[1]) < at.distance(pair[1]);
            at = at.step(Heading::ALL.into_iter().find(nearer).unwrap());
            walk.push((at, if at == pair[1] { stop } else { stop - 1 }));
        }
    }
    walk
}

fn names() -> impl Strategy<Value = Name> {
    proptest::sample::select(Name::ALL)
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 400, failure_persistence: None, ..ProptestConfig::default() })]

    #[test]
    fn runs_part_where_their_walks_differ_first(recipe in recipes(7), a in names(), b in names()) {
        let (maze, settings) = (recipe.maze(), roomy(Settings::default().order));
        let runs = [a, b].map(|name| record(&maze, &settings, name).unwrap());
        let [one, other] = [0, 1].map(|nth| walked(&places(&maze, &runs[nth], &settings)));
        let common = one.iter().zip(&other).take_while(|(a, b)| a.0 == b.0).count();
        match parting::first(&maze, &runs[0], &runs[1]) {
            None => prop_assert!(common == one.len() && common == other.len()),
            Some(parting) => {
                prop_assert_eq!(parting.cells as usize, common - 1);
                prop_assert_eq!(parting.at, one[common - 1].0);
                for (side, walk) in parting.sides.iter().zip([&one, &other]) {
                    prop_assert_eq!(side.stop, walk[common - 1].1);
                    let next = walk.get(common).map(|&(at, _)| at);
                    prop_assert_eq!(side.leaves.map(|heading| parting.at.step(heading)), next);
                }
                prop_assert!(parting.words(['A', 'B']).contains(&parting.at.to_string()));
            }
        }
    }

    #[test]
    fn the_same_distance_is_the_same_many_cells(recipe in recipes(7), name in names(), share in 0.0..1.2_f64) {
        let (maze, settings) = (recipe.maze(), roomy(Settings::default().order));
        let run = record(&maze, &settings, name).unwrap();
        let walk = walked(&places(&maze, &run, &settings));
        let (cells, _) = abreast::total(&maze, &run, &settings.pace);
        prop_assert_eq!(cells as usize, walk.len() - 1);
        let whole = ((cells * share) as usize).min(walk.len() - 1);
        for part in [0.0, 0.5] {
            let clock = Clock::Cells(whole as f64 + part);
            let here = abreast::at(&maze, &run, &settings.pace, clock).unwrap();
            let next = walk.get(whole + 1).map_or(walk[whole].0, |&(at, _)| at);
            let between = |a: i32, b: i32| f64::from(a) + f64::from(b - a) * part;
            prop_assert!((here.pose.x - between(walk[whole].0.x, next.x)).abs() < 1e-9);
            prop_assert!((here.pose.y - between(walk[whole].0.y, next.y)).abs() < 1e-9);
            prop_assert_eq!(here.stop, walk[whole].1);
        }
    }

    #[test]
    fn time_brings_every_robot_to_its_stops_in_order(recipe in recipes(7), name in names(), stop_s in 0.0..2.0_f64) {
        let mut settings = roomy(Settings::default().order);
        settings.pace.stop_s = stop_s;
        let maze = recipe.maze();
        let run = record(&maze, &settings, name).unwrap();
        let places = places(&maze, &run, &settings);
        let (_, seconds) = abreast::total(&maze, &run, &settings.pace);
        let at = |seconds| abreast::at(&maze, &run, &settings.pace, Clock::Seconds(seconds)).unwrap();
        for stop in 0..=run.stops() {
            let arrival = run.tally(stop).seconds(maze.scale.cell_mm(), &settings.pace);
            let here = at(arrival + 1e-9);
            prop_assert_eq!(here.stop, stop);
            prop_assert!((here.pose.x - f64::from(places[stop as usize].x)).abs() < 1e-4);
            prop_assert!((here.pose.y - f64::from(places[stop as usize].y)).abs() < 1e-4);
        }
        prop_assert_eq!(at(seconds * 2.0 + 1.0).stop, run.stops());
        let mut before = 0.0;
        for part in 0..=20 {
            let here = at(seconds * f64::from(part) / 20.0);
            let now = f64::from(here.stop) + here.along;
            prop_assert!(now >= before, "{now} after {before}");
            before = now;
        }
    }

    #[test]
    fn no_route_is_shorter_than_the_shortest(recipe in recipes(7), name in names()) {
        let (maze, settings) = (recipe.maze(), roomy(Settings::default().order));
        let bests = Bests::of(&maze, &settings);
        let entrant = Entrant::of(&maze, &settings, name, &bests).unwrap();
        let score = &entrant.score;
        match &score.route {
            Ok(route) => {
                prop_assert!(route.cells >= bests.shortest.unwrap().cells);
                prop_assert!(route.seconds >= bests.fastest.unwrap().seconds - 1e-9);
                prop_assert!(score.ratio_shortest() >= Some(1.0));
                let well = matches!(score.outcome, Outcome::Finish | Outcome::Mapped);
                prop_assert_eq!(score.reason().is_none(), well);
                let drive = solved(&maze, &entrant.run).unwrap();
                prop_assert!(maze.is_finish(drive.legs.last().unwrap().at));
            }
            Err(_) => {
                prop_assert!(score.reason().is_some());
                prop_assert!(score.outcome != Outcome::Finish, "{name}: {:?}", score.reason());
            }
        }
        let report = Report::of_run(&maze, &settings, &entrant.run);
        prop_assert_eq!(report.stops, score.tally.stops);
        prop_assert_eq!(report.distance_cells, score.tally.cells);
        prop_assert_eq!(report.memory_bytes, score.memory_bytes);
        prop_assert_eq!(report.route_cells, score.route.ok().map(|route| route.cells));
        prop_assert_eq!(report.u_turns, score.tally.u_turns);
        prop_assert!((report.seconds - score.seconds).abs() < 1e-5);
        prop_assert!(report.reason.is_none() || report.reason == score.reason());
    }
}

#[test]
fn two_to_six_different_explorers() {
    let all = |count: usize| Lineup::new(Name::ALL[..count].to_vec());
    assert_eq!(all(1), Err(LineupError::Count(1)));
    assert_eq!(all(7), Err(LineupError::Count(7)));
    assert_eq!(all(6).unwrap().names(), &Name::ALL[..6]);
    let twice = Lineup::new(vec![Name::Book, Name::LeftHand, Name::Book]);
    assert_eq!(twice.unwrap_err().to_string(), "“book” is there twice; name each once");
}

#[test]
fn columns_put_the_least_first_and_those_without_a_number_last() {
    let (maze, settings) = (samples::figure_3_1(), Settings::default());
    let bests = Bests::of(&maze, &settings);
    let score = |name| Entrant::of(&maze, &settings, name, &bests).unwrap().score;
    let mut scores: Vec<Score> = [Name::RightHand, Name::Book, Name::DepthFirst].map(score).to_vec();
    assert!(scores[0].route.is_err(), "the right hand circles here");
    scores.sort_by(|a, b| Column::RatioShortest.order(a, b));
    assert_eq!(scores[2].name, Name::RightHand);
    assert!(scores[0].ratio_shortest() <= scores[1].ratio_shortest());
    assert_eq!(scores[2].reason().unwrap(), scores[2].outcome.to_string());
}

#[test]
fn random_orders_show_how_much_is_luck() {
    let maze = samples::SAMPLES.iter().find(|sample| sample.file == "long-way").unwrap().maze();
    let settings = Settings::default();
    let draws: Draws = (1..=200).map(|seed| draw(&maze, &settings, seed).unwrap()).collect();
    let shortest = Bests::of(&maze, &settings).shortest.unwrap().cells;
    let (best, worst) = (draws.best().unwrap(), draws.worst().unwrap());
    assert!(best.route_cells.unwrap() >= shortest);
    assert!(worst.route_cells > best.route_cells, "the sample has a long way");
    for end in [best, worst] {
        assert_eq!(draw(&maze, &settings, end.seed), Ok(end), "opening a seed shows the same run");
    }
    let bars = draws.bars(Some(shortest), 5);
    assert!(bars.len() <= 5 && bars[0].from == shortest);
    assert_eq!(bars.iter().map(|bar| bar.count).sum::<usize>(), draws.counts().0);
    assert!(bars.windows(2).all(|pair| pair[0].to + 1 == pair[1].from));
    let last = bars.last().unwrap();
    assert!((last.from..=last.to).contains(&worst.route_cells.unwrap()) && last.count > 0);
    assert_eq!(draws.at_most(worst.route_cells.unwrap()), draws.counts().0);
    assert!(draws.median_cells() >= best.route_cells && draws.median_cells() <= worst.route_cells);
}

fn league() -> League {
    let recipe = Recipe { width: 8, height: 8, seed: 5, ..Recipe::default() };
    let mut walled_in = samples::figure_3_1();
    walled_in.set_start(None);
    let file = Course::File { name: "a, \"b\".maze".into(), maze: walled_in };
    let courses = Course::samples().chain(Course::generated(recipe, 5)).chain([file]).collect();
    League { names: Name::ALL.to_vec(), settings: Settings::default(), courses }
}

#[test]
fn the_league_counts_what_its_runs_come_to() {
    let league = league();
    let mut results: Vec<CourseResult> = (0..league.courses.len()).map(|course| league.run(course)).collect();
    let standings = standings(&league.names, &results);
    results.reverse();
    assert_eq!(line_maze_lab::compare::league::standings(&league.names, &results), standings);
    let file = &results[0];
    assert!(file.entries.iter().all(|entry| entry.score == Err(CannotStart::NoStart)));
    for standing in &standings {
        assert!(standing.runs < league.courses.len() && standing.solved <= standing.solvable());
        assert_eq!(standing.runs + standing.absent, league.courses.len());
        let ratio = standing.quartiles(Column::RatioShortest);
        assert_eq!(ratio.map_or(0, |ratio| ratio.count), standing.solved);
        assert!(ratio.is_none_or(|ratio| ratio.least >= 1.0 && ratio.lower <= ratio.median));
        assert_eq!(standing.quartiles(Column::Stops).map(|stops| stops.count), Some(standing.runs));
    }
    let absences = absences(&results);
    let runs: usize = absences.iter().map(|absence| absence.names.len()).sum();
    assert_eq!(runs, standings.iter().map(|standing| standing.absent).sum::<usize>());
    let everybody = absences.iter().find(|absence| absence.course == file.course).unwrap();
    assert_eq!((&everybody.names, everybody.why), (&league.names, CannotStart::NoStart));
    let share =
        |name| standings.iter().find(|standing| standing.name == name).unwrap().share_solved().unwrap();
    assert!(share(Name::DepthFirst) >= 1.0, "depth first always arrives");
    assert!(share(Name::RightHand) < 1.0, "some samples make it circle");
    assert_eq!(league.run(999), CourseResult { course: 999, entries: vec![] });
}

#[test]
fn csv_has_as_many_cells_in_every_line() {
    let league = league();
    let results: Vec<CourseResult> = (0..league.courses.len()).map(|course| league.run(course)).collect();
    let text = results_csv(&league, &results);
    assert_eq!(text.lines().count(), 1 + league.courses.len() * Name::ALL.len());
    for csv in [text.clone(), standings_csv(&standings(&league.names, &results))] {
        let width = cells(csv.lines().next().unwrap()).len();
        for line in csv.lines() {
            assert_eq!(cells(line).len(), width, "{line}");
        }
    }
    let last = cells(text.lines().last().unwrap());
    assert_eq!(last[0], "a, \"b\".maze");
    assert_eq!((last[2].as_str(), last[4].as_str()), ("cannot-start", ""));
}

/// The cells of a line of CSV.
fn cells(line: &str) -> Vec<String> {
    let mut cells = vec![String::new()];
    let mut quoted = false;
    for c in line.chars() {
        match c {
            '"' => {
                quoted = !quoted;
                // Two quotes in quotes are one.
                if quoted && line.contains("\"\"") && !cells.last().unwrap().is_empty() {
                    cells.last_mut().unwrap().push('"');
                }
            }
            ',' if !quoted => cells.push(String::new()),
            other => cells.last_mut().unwrap().push(other),
        }
    }
    cells
}
