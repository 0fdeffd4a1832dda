//! The notes on the book: each at its stop or line, and never more than two.

use line_maze_lab::explorer::book::code::Line;
use line_maze_lab::explorer::book::errata::{AT_ONCE, ERRATA, Erratum, Kind, Walk, at, at_stop};
use line_maze_lab::explorer::name::Name;
use line_maze_lab::geometry::Heading;
use line_maze_lab::maze::{Maze, samples, samples::SAMPLES};
use line_maze_lab::run::{AnyRun, explore, record};
use line_maze_lab::settings::{Rule, Settings};
use line_maze_lab::trace::{Moment, Trace};

use crate::support::{figure_2_4, figure_3_1, maze};

fn run(maze: &Maze, settings: &Settings) -> Trace {
    explore(maze, settings).unwrap()
}

fn titles(trace: &Trace, moment: Moment, walk: Walk) -> Vec<&'static str> {
    at(&trace.frame(moment), walk).map(|erratum| erratum.title).collect()
}

/// The notes of whole stops, and of every time that a line ran.
fn by_stop(trace: &Trace, walk: Walk) -> Vec<(u32, Vec<&'static str>)> {
    (0..=trace.stops())
        .map(|stop| (stop, titles(trace, Moment::after(stop), walk)))
        .filter(|(_, titles)| !titles.is_empty())
        .collect()
}

fn by_line(trace: &Trace, line: Line) -> Vec<&'static str> {
    for stop in 1..=trace.stops() {
        for lines in 1..=trace.lines(stop) {
            let moment = Moment { stop, lines };
            if trace.frame(moment).ran == Some(line) {
                return titles(trace, moment, Walk::Other);
            }
        }
    }
    panic!("the line never runs")
}

#[test]
fn figure_3_1_s_errata_stand_at_their_stops() {
    let trace = run(&figure_3_1(), &Settings::default());
    let told = by_stop(&trace, Walk::Figure31);
    let expected = [
        (1, vec!["The wrong node", "One thing, two names"]),
        (6, vec!["The third path is west"]),
        (8, vec!["Node 4, not node 2"]),
        (10, vec!["returning is asked, not set"]),
        (13, vec!["The path of arrival is visited"]),
        (22, vec!["One stop late"]),
        (25, vec!["ptr is one more"]),
    ];
    assert_eq!(told, expected);
    assert_eq!(by_stop(&trace, Walk::Other), [(25, vec!["ptr is one more"])]);
    // What is shown at the first stop is what the book prints there.
    let first = at(&trace.frame(Moment::after(1)), Walk::Figure31).next().unwrap();
    assert_eq!((first.printed, first.meant), (Some("node[2].vpath[0]"), Some("nodes[1].vpaths[0]")));
}

#[test]
fn figure_2_4_s_errata_stand_at_their_stops() {
    let trace = run(&figure_2_4(), &Settings::default());
    let expected = [
        (1, vec!["The wrong array", "One thing, two names"]),
        (2, vec!["Node 1 is set twice", "The wrong array, again"]),
        (6, vec!["A U-turn that is not needed", "ptr: the node, or one more?"]),
        (8, vec!["ptr is one more"]),
    ];
    assert_eq!(by_stop(&trace, Walk::Figure24), expected);
    let elsewhere = by_stop(&trace, Walk::Other);
    assert_eq!(elsewhere[0], (6, vec!["ptr: the node, or one more?", "Nothing is left to try"]));
}

#[test]
fn the_lines_have_theirs() {
    let (one, two) = (run(&figure_3_1(), &Settings::default()), run(&figure_2_4(), &Settings::default()));
    assert_eq!(by_line(&one, Line::GET), ["Turning is not driving", "An Uno's int is too short"]);
    assert_eq!(by_line(&one, Line::RECORD), ["Room for 49, not 50"]);
    assert_eq!(by_line(&one, Line::IF_RETURNING), ["returning is asked, not set"]);
    assert_eq!(by_line(&one, Line::MARK_ARRIVAL), ["The path of arrival is visited"]);
    assert_eq!(by_line(&two, Line::KNOWN_PTR), ["RETURN-KNOWN sets ptr too"]);
    assert_eq!(by_line(&two, Line::LOOP_PTR), ["ptr: the node, or one more?"]);
    assert_eq!(by_line(&two, Line::LOOP_CHOOSE), ["Nothing is left to try"]);
    assert!(by_line(&one, Line::FINISH).is_empty());
}

#[test]
fn other_ends_have_theirs() {
    let full = run(&figure_3_1(), &Settings { node_max: 3, ..Settings::default() });
    assert_eq!(titles(&full, full.end(), Walk::Other), ["Room for 49, not 50"]);
    let mut unreachable = figure_3_1();
    assert!(unreachable.set_finish(vec![]));
    let unreachable = run(&unreachable, &Settings::default());
    assert_eq!(titles(&unreachable, unreachable.end(), Walk::Other), ["No finish, no end"]);
}

#[test]
fn an_int_overflows_once_after_32_767_seconds() {
    // 90 cells of 400 ms: 36 s to the east.
    let long =
        maze(&[&[(0, 0), (0, 1), (81, 1), (81, 0)], &[(90, 1), (81, 1)]], (0, 0, Heading::North), &[(90, 1)]);
    let trace = run(&long, &Settings::default());
    let at_32_400 = titles(&trace, Moment::after(2), Walk::Other);
    assert!(at_32_400.is_empty(), "{at_32_400:?}");
    let overflows = by_stop(&trace, Walk::Other)
        .into_iter()
        .filter(|(_, told)| told.contains(&"An Uno's int is too short"));
    assert!(overflows.map(|(stop, _)| stop).eq([trace.stops()]));
}

#[test]
fn every_note_is_short_and_at_most_two_stand_together() {
    for Erratum { title, text, section, printed, meant, places, .. } in ERRATA {
        let words = text.split_whitespace().count();
        assert!((8..=40).contains(&words) && text.ends_with('.'), "{title}: {words} words");
        assert!(section.contains('§') || section.starts_with("Table"), "{title}");
        assert_eq!(printed.is_some(), meant.is_some(), "{title}");
        assert!(!places.is_empty(), "{title} is shown nowhere");
    }
    assert!(ERRATA.iter().any(|erratum| erratum.kind == Kind::Open));
    for (maze, walk) in [(figure_3_1(), Walk::Figure31), (figure_2_4(), Walk::Figure24)] {
        let trace = run(&maze, &Settings::default());
        for stop in 0..=trace.stops() {
            for lines in 0..=trace.lines(stop) {
                assert!(titles(&trace, Moment { stop, lines }, walk).len() <= AT_ONCE);
            }
        }
    }
}

/// The notes of another explorer's run, by stop.
fn others(maze: &Maze, name: Name, rule: Rule, walk: Walk) -> Vec<(u32, Vec<&'static str>)> {
    let settings = Settings { rule, ..Settings::default() };
    let AnyRun::Other(run) = record(maze, &settings, name).unwrap() else { panic!("not the book's") };
    let at = |stop| at_stop(name.about().errata, walk, stop, &run.at(stop).said).map(|note| note.title);
    let stops = (0..=run.stops()).map(|stop| (stop, at(stop).collect::<Vec<_>>()));
    stops.filter(|(_, titles)| !titles.is_empty()).collect()
}

#[test]
fn the_mapping_papers_notes_stand_where_figure_3_errs() {
    let counts = vec!["Two counts of Explored"];
    let both = vec![counts[0], "How far is near"];
    let expected = [
        (0, vec!["Which way first"]),
        (4, both.clone()),
        (8, both),
        (9, counts),
        (11, vec!["F lies in the south"]),
    ];
    let maze = samples::SAKIB_2.maze();
    assert_eq!(others(&maze, Name::Mapping, Rule::Special1, Walk::SakibFigure2), expected);
    let elsewhere = others(&maze, Name::Mapping, Rule::Special1, Walk::Other);
    assert!(elsewhere.iter().all(|(_, titles)| !titles.contains(&"F lies in the south")));
}

#[test]
fn the_path_mapping_articles_notes_stand_where_its_loop_runs_and_cuts() {
    let sample = SAMPLES.iter().find(|sample| sample.file == "parex-1").unwrap();
    // Squares 1 5 6 2 3 7 6: the last leads back, so the loop finds it and clears what came between.
    let notes = others(&sample.maze(), Name::ParexRight, Rule::Special1, Walk::Other);
    assert_eq!(notes.iter().find(|(stop, _)| *stop == 5).unwrap().1, ["Path(0)"]);
    let cut = ["The loop has to count down", "Path(0)", "The wrong variable"];
    assert_eq!(notes.iter().find(|(stop, _)| *stop == 6).unwrap().1, cut);
    let basic = others(&sample.maze(), Name::ParexRight, Rule::Basic, Walk::Other);
    assert_eq!(basic, [(0, vec!["What wall following is"])], "the listing is that of special case 1");
}

#[test]
fn every_note_on_another_source_is_shown_somewhere() {
    for name in Name::ALL.iter().copied().filter(|&name| name != Name::Book) {
        for Erratum { title, places, .. } in name.about().errata {
            assert!(!places.is_empty(), "{name}: {title} is shown at no stop");
        }
    }
}

#[test]
fn what_cornell_leaves_open_is_told_where_the_third_searches() {
    let sample = SAMPLES.iter().find(|sample| sample.file == "cornell-6x4").unwrap();
    let notes = others(&sample.maze(), Name::Cornell3, Rule::Special1, Walk::Other);
    // The spec: as the second up to stop 20, then a route to 1,3... and all is mapped after 31 moves.
    let told = |stop| notes.iter().find(|(at, _)| *at == stop).map(|(_, titles)| titles.clone());
    assert_eq!(told(31), Some(vec!["The third is described elsewhere"]));
    let searches = notes.iter().filter(|(_, titles)| titles.contains(&"The third is described elsewhere"));
    assert!(searches.count() >= 2, "where it searches and where it ends: {notes:?}");
    let second = others(&sample.maze(), Name::Cornell2, Rule::Special1, Walk::Other);
    assert!(second.iter().all(|(stop, _)| *stop == 0));
}
