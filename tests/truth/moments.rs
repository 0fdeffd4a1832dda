//! What stands beside the sentence at a moment: the table's place when it is empty, the variables of running functions,
//! the ways that a sentence lists, round 2, and settings off their defaults.

use line_maze_lab::explorer::book::Case;
use line_maze_lab::explorer::book::code::Line;
use line_maze_lab::explorer::book::locals::{Locals, locals};
use line_maze_lab::explorer::book::narrate::empty::empty_table;
use line_maze_lab::explorer::name::{Name, Setting};
use line_maze_lab::geometry::{Heading, Point};
use line_maze_lab::ink::{CellState, Ink};
use line_maze_lab::maze::{Maze, samples::SAMPLES};
use line_maze_lab::playback::Timeline;
use line_maze_lab::route::words;
use line_maze_lab::run::{AnyRun, explore, record};
use line_maze_lab::scene;
use line_maze_lab::settings::{Order, Pace, Preference, Rule, Search, Settings};
use line_maze_lab::trace::{Moment, Trace};
use proptest::prelude::*;

use crate::support::figure_3_1;
use crate::support::random::{orders, recipes, roomy};

fn sample(file: &str) -> Maze {
    SAMPLES.iter().find(|sample| sample.file == file).unwrap().maze()
}

/// Every moment of a trace with an empty table: what is said is so.
fn empty_tables_are_told_as_they_are(trace: &Trace) {
    let records = |stop: u32| trace.step(stop).is_some_and(|step| step.case() == Case::New);
    for stop in 0..=trace.stops() {
        for lines in 0..=trace.lines(stop) {
            let frame = trace.frame(Moment { stop, lines });
            if frame.state.ptr != 1 {
                continue;
            }
            let whole = frame.moment.lines == frame.lines;
            let met = (1..=stop).filter(|&at| at < stop || whole).any(records);
            let more = (stop + 1..=trace.stops()).any(records);
            let empty = empty_table(trace, &frame);
            assert_eq!(empty.title == "No node left", met, "stop {stop}, {lines} lines");
            assert_eq!(empty.text.contains("forgotten"), met && (whole || !records(stop)));
            if empty.more {
                assert!(more, "stop {stop}: there is a node to go to");
            }
        }
    }
}

#[test]
fn an_empty_table_says_whether_a_node_was_met() {
    let trace = explore(&sample("no-finish-reachable"), &Settings::default()).unwrap();
    let end = empty_table(&trace, &trace.frame(trace.end()));
    assert_eq!((end.title, end.more), ("No node left", false));
    assert!(end.text.contains("forgotten every node"), "{}", end.text);
    let start = empty_table(&trace, &trace.frame(Moment::after(0)));
    assert_eq!((start.title, start.more), ("No node yet", true));
    // A line without a fork.
    let line = crate::support::maze(&[&[(0, 0), (0, 2), (2, 2)]], (0, 0, Heading::North), &[(2, 2)]);
    let trace = explore(&line, &Settings::default()).unwrap();
    let end = empty_table(&trace, &trace.frame(trace.end()));
    assert_eq!((end.title, end.text, end.more), ("No node yet", "The bot has met no node so far.", false));
}

#[test]
fn locals_are_there_while_their_functions_run() {
    let trace = explore(&figure_3_1(), &Settings::default()).unwrap();
    let at = |stop: u32, wanted: Line| {
        let step = trace.step(stop).unwrap();
        let frames = (1..=trace.lines(stop)).map(|lines| trace.frame(Moment { stop, lines }));
        let frame = frames.into_iter().find(|frame| frame.ran == Some(wanted)).unwrap();
        locals(&frame, step)
    };
    // Stop 13: node 1 is met again from the east, and turned round at.
    assert_eq!(at(13, Line::NODE), Locals::default(), "act() has none of them");
    let matched = at(13, Line::MATCH);
    assert_eq!((matched.m, matched.m_set, matched.d), (Some(1), true, None));
    assert_eq!(matched.arrival, Some(Heading::East));
    // Stop 10: node 4 again, left to the west by choose_path().
    assert_eq!(at(10, Line::KNOWN_CHOOSE).d, None);
    let first = at(10, Line::FIRST);
    assert_eq!((first.m, first.d, first.d_set), (Some(4), Some(Heading::West), true));
    assert_eq!(at(10, Line::TAKE).d, Some(Heading::West));
    // Stop 1 is new: 0 until line 11 has recorded it.
    assert_eq!((at(1, Line::MATCH).m, at(1, Line::RECORD).m), (Some(0), Some(1)));
    assert!(at(1, Line::RECORD).m_set);
    // Stop 18: nothing is left at node 6, so choose_path() picks none.
    assert_eq!((at(18, Line::FIRST).d, at(18, Line::NONE_LEFT).d, at(18, Line::BACK).d), (None, None, None));
    assert_eq!(at(18, Line::BACK).m, Some(6));
    assert_eq!(at(3, Line::CORNER), Locals::default());
}

#[test]
fn stop_13_lights_the_ways_that_its_sentence_lists() {
    let maze = figure_3_1();
    let trace = explore(&maze, &Settings::default()).unwrap();
    let ink = Ink::of(&maze, &trace, 400);
    let lit = scene::listed_ways(&trace, &ink, Moment::after(13));
    let at = |x, y| Point::new(x, y);
    use Heading::{East, North, South};
    assert_eq!(lit, [(at(0, 3), East), (at(3, 5), South), (at(4, 1), North), (at(2, 1), North)]);
    for stop in (0..=25).filter(|stop| ![13, 16].contains(stop)) {
        assert!(scene::listed_ways(&trace, &ink, Moment::after(stop)).is_empty(), "stop {stop}");
    }
}

#[test]
fn round_2_is_told_as_it_is_driven() {
    let told = |maze: &Maze, name: Name, stop: u32| {
        let way = record(maze, &Settings::default(), name).unwrap().way(maze).unwrap();
        let told = words::told(&way.route.unwrap(), way.list.turns().len(), stop);
        format!("{}: {}", told.case, told.text)
    };
    let figure = figure_3_1();
    assert_eq!(
        told(&figure, Name::Book, 0),
        "ROUND 2: The bot is back at the start and knows its turn list of 3 letters. It explores nothing now."
    );
    assert_eq!(told(&figure, Name::Book, 1), "TURN LIST: Letter 1 of 3 is S, so the bot goes straight on.");
    assert_eq!(told(&figure, Name::Book, 3), "CORNER: A corner needs no letter: the bot turns right.");
    assert_eq!(told(&figure, Name::Book, 5), "FINISH: There: 9 cells, and no U-turn.");
    // A start with two ways has the first letter: it is counted, and told at the start.
    let two = crate::support::maze(
        &[&[(0, 0), (0, 1), (1, 1)], &[(0, 0), (2, 0)]],
        (0, 0, Heading::North),
        &[(2, 0)],
    );
    assert_eq!(
        told(&two, Name::RightHand, 0),
        "ROUND 2: The bot is back at the start and knows its turn list of 1 letter. It explores nothing now. Letter 1 is R: it turns right."
    );
}

#[test]
fn whatever_is_off_its_default_and_changes_the_run_is_named() {
    let all = Settings {
        order: Order::Fixed(Preference::ALL[2]),
        epsilon_ms: Some(900),
        node_max: 61,
        pace: Pace { turn_s: 1.0, ..Pace::default() },
        rule: Rule::Basic,
        path_max: Some(48),
        search: Search::AStar,
    };
    let named = |name: Name| name.off_defaults(&all).join(" · ");
    assert_eq!(named(Name::Book), "epsilon 900 · NODE_MAX 61 · own cost model");
    assert_eq!(named(Name::DepthFirst), "order RSL · epsilon 900 · own cost model");
    assert_eq!(named(Name::Mapping), "epsilon 900 · A* · own cost model");
    assert_eq!(named(Name::ParexLeft), "basic rule · path of 48 · own cost model");
    assert_eq!(named(Name::Cornell3), "own cost model");
    for &name in Name::ALL {
        assert!(name.off_defaults(&Settings::default()).is_empty(), "{name}");
        // The order and the tolerance go together: who knows places again by coordinates heeds epsilon.
        assert!(!name.heeds(Setting::Order) || name.heeds(Setting::Epsilon), "{name}");
    }
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 200, failure_persistence: None, ..ProptestConfig::default() })]

    #[test]
    fn empty_tables_of_random_runs(recipe in recipes(5), order in orders()) {
        empty_tables_are_told_as_they_are(&explore(&recipe.maze(), &roomy(order)).unwrap());
    }

    #[test]
    fn listed_ways_were_never_driven(recipe in recipes(7), order in orders()) {
        let maze = recipe.maze();
        let AnyRun::Book(run) = record(&maze, &roomy(order), Name::Book).unwrap() else { panic!() };
        let ink = Ink::of(&maze, run.trace(), run.cell_ms());
        for stop in 1..=run.trace().stops() {
            for (at, heading) in scene::listed_ways(run.trace(), &ink, Moment::after(stop)) {
                prop_assert!(maze.has_line(at, heading));
                prop_assert_eq!(ink.cell((at, heading), stop), CellState::Clean);
            }
        }
    }

    /// A setting that an explorer does not heed changes nothing of its run.
    #[test]
    fn what_is_not_heeded_changes_nothing(recipe in recipes(5)) {
        let maze = recipe.maze();
        let usual = Settings::default();
        let changes = [
            (Setting::Order, Settings { order: Order::Fixed(Preference::ALL[5]), ..usual }),
            (Setting::Epsilon, Settings { epsilon_ms: Some(1000), ..usual }),
            (Setting::NodeMax, Settings { node_max: 1, ..usual }),
            (Setting::Rule, Settings { rule: Rule::Basic, ..usual }),
            (Setting::PathMax, Settings { path_max: Some(3), ..usual }),
            (Setting::Search, Settings { search: Search::AStar, ..usual }),
        ];
        for &name in Name::ALL {
            for (setting, other) in changes.iter().filter(|(setting, _)| !name.heeds(*setting)) {
                let run = |settings: &Settings| {
                    let run = record(&maze, settings, name).unwrap();
                    (run.outcome(), run.stops(), run.way(&maze))
                };
                prop_assert_eq!(run(&usual), run(other), "{} heeds {:?}", name, setting);
            }
        }
    }
}
