//! Runs that fail, and sentences of any run: short enough, and whole.

use expect_test::expect;
use line_maze_lab::event::{Finish, Outcome, Sighting};
use line_maze_lab::explorer::book::narrate::{Span, Tone, narrate};
use line_maze_lab::explorer::book::{Case, Event};
use line_maze_lab::geometry::{Heading, Point, Turn, Ways};
use line_maze_lab::maze::{Bounds, Maze, Start};
use line_maze_lab::run::explore;
use line_maze_lab::settings::{Order, Settings};
use line_maze_lab::trace::{Moment, Recorder};

use crate::support::figure_3_1;
use crate::told;

#[test]
fn a_failed_run_says_what_failed_and_names_a_cure() {
    let last = |maze: &Maze, settings: &Settings| {
        let trace = explore(maze, settings).unwrap();
        let told = told(&trace, trace.stops());
        assert_eq!(told.tone, Tone::Bad);
        format!("{}: {}\n   {}\n", told.case, told.text(), told.short_text())
    };
    let maze = figure_3_1();
    let mut unreachable = maze.clone();
    assert!(unreachable.set_finish(vec![]));
    let endings = [
        last(&maze, &Settings { epsilon_ms: Some(1000), ..Settings::default() }),
        last(&maze, &Settings { node_max: 3, ..Settings::default() }),
        last(&unreachable, &Settings::default()),
    ];
    expect![[r#"
        LOST: The bot took this place for node 1 and turned for its back path, to the south (2), but there is no line. Its coordinates mix up two places: try an epsilon of half a cell.
           Lost at node 1: there is no line south (2).
        TABLE FULL: This node is new, but all 3 places of the node table are taken: the bot gives up. Set NODE_MAX higher; where the maze has fewer nodes than that, epsilon is too small.
           A new node, but the table of 3 is full: the bot gives up.
        NO FINISH REACHABLE: The bot is back at the start and remembers no node. It drove every line that it can reach, and none led to a finish. Join a finish to these lines, then run again.
           Back at the start: every line driven, no finish found.
    "#]].assert_eq(&endings.concat());
}

#[test]
fn a_run_without_end_is_told() {
    let mut recorder = Recorder::new(Settings::default().pace);
    recorder.hear(Event::Case(Case::DeadEnd));
    let ways = Ways::NONE.with(Heading::South);
    let finish = Finish::No;
    recorder.stop(Sighting { ways, finish, time_diff: 400 }, Some(Turn::Back));
    let trace = recorder.finish(Outcome::TooManyStops { limit: 96 });
    let told = told(&trace, 1);
    assert_eq!((told.case, told.tone), ("LOST", Tone::Bad));
    assert!(told.text().contains("After 96 stops"), "{}", told.text());
}

/// A maze of random lines over a lattice, with a start at the end of its first line.
fn random_maze(chance: &mut oorandom::Rand32, size: i32) -> Maze {
    let mut maze = Maze::new(Bounds::around([Point::new(0, -1), Point::new(size, size)]).unwrap());
    for x in 0..=size {
        for y in 0..=size {
            for heading in [Heading::North, Heading::East] {
                if chance.rand_range(0..10) < 7 {
                    maze.draw(Point::new(x, y), heading);
                }
            }
        }
    }
    maze.draw(Point::new(0, -1), Heading::North);
    assert!(maze.set_start(Some(Start { at: Point::new(0, -1), heading: Heading::North })));
    let mut anywhere = || chance.rand_range(0..size as u32 + 1) as i32;
    let finish = Point::new(anywhere(), anywhere());
    assert!(maze.set_finish(vec![finish]));
    maze
}

#[test]
fn no_sentence_is_too_long_or_empty() {
    let mut chance = oorandom::Rand32::new(31);
    let mut more = false;
    let mut cases = std::collections::BTreeSet::new();
    for round in 0..150u32 {
        let maze = random_maze(&mut chance, 2 + (round % 6) as i32);
        let settings = Settings {
            order: Order::Random(round.into()),
            epsilon_ms: [None, None, Some(0), Some(900)][round as usize % 4],
            node_max: [50, 1000, 3][round as usize % 3],
            ..Settings::default()
        };
        let trace = explore(&maze, &settings).unwrap();
        for stop in 0..=trace.stops() {
            for lines in 1..=trace.lines(stop).max(1) {
                let told = narrate(&trace, &trace.frame(Moment { stop, lines }));
                cases.insert(told.case);
                for text in [told.text(), told.short_text()] {
                    let words = text.split_whitespace().count();
                    assert!((2..=45).contains(&words), "{words} words: {text}");
                    assert!(text.starts_with(|c: char| !c.is_whitespace()), "{text}");
                    assert!(text.ends_with('.') && !text.contains("  ") && !text.contains(" ."), "{text}");
                }
                more |= told.text().contains(" and more)");
                let named = told.said.iter().filter(|span| matches!(span, Span::Way { .. })).count();
                assert!(named <= 4);
            }
        }
    }
    assert!(more, "a run with many unvisited paths");
    expect![[r#"{"CORNER", "DEAD END", "FINISH", "GAVE UP", "LOST", "NEW NODE", "NO FINISH REACHABLE", "RETURN-KNOWN", "RETURN-UNKNOWN", "START", "TABLE FULL", "act()", "choose_path()", "node()", "take_return_path()"}"#]].assert_eq(&format!("{cases:?}"));
}
