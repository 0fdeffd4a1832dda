//! Each sample maze against its own claim: a file without a claim fails, and so does a claim without a file.
#![allow(clippy::unwrap_used, missing_docs)]

mod support;

use std::collections::BTreeSet;

use line_maze_lab::event::Outcome;
use line_maze_lab::explorer::name::Name;
use line_maze_lab::geometry::{Heading, Point};
use line_maze_lab::maze::samples::{self, SAMPLES};
use line_maze_lab::maze::{Kind, Maze, checks, file, json, text};
use line_maze_lab::playback::Timeline as _;
use line_maze_lab::route::{Route, TurnList, best};
use line_maze_lab::run::{AnyRun, explore, record};
use line_maze_lab::settings::{Order, Pace, Preference, Rule, Settings};
use line_maze_lab::trace::Trace;

type Claim = fn(&Maze);

/// What each file claims. Outcome and numbers are those of a run of the book's explorer with its defaults.
const CLAIMS: &[(&str, Claim)] = &[
    ("book-1-1", |maze| {
        assert_eq!((maze.loops(), maze.nodes()), (2, 4));
        let route = found(maze, "SSRL");
        assert_eq!((route, shortest(maze)), (17, Some(7)));
    }),
    ("book-2-2", |maze| {
        assert_eq!(maze.nodes(), 3);
        assert_eq!(points_with(maze, 4), [Point::new(4, 4)]);
        assert_eq!(points_with(maze, 1).len(), 4, "dead ends, start and finish among them");
        found(maze, "SSL");
    }),
    ("book-2-3", |maze| {
        let trace = run(maze);
        let first: Vec<_> =
            trace.steps()[..3].iter().map(|step| (step.sighting().seen().name(), step.node())).collect();
        assert_eq!(first, [("node", 1), ("dead-end", 0), ("node", 1)]);
        assert_eq!(found(maze, "L"), 5);
    }),
    ("book-2-4", |maze| {
        same_lines(maze, support::figure_2_4());
        assert_eq!((found(maze, "L"), run(maze).stops()), (4, 8));
    }),
    ("book-3-1", |maze| {
        same_lines(maze, support::figure_3_1());
        assert_eq!((found(maze, "SSR"), shortest(maze)), (9, Some(9)));
        assert_eq!((run(maze).stops(), maze.nodes()), (25, 6));
    }),
    ("tree", |maze| {
        assert_eq!((maze.loops(), maze.nodes()), (0, 3));
        for preference in Preference::ALL {
            let settings = Settings { order: Order::Fixed(preference), ..Settings::default() };
            let trace = explore(maze, &settings).unwrap();
            let list = TurnList::of(&trace).unwrap();
            assert_eq!(Some(Route::drive(maze, &list).unwrap().cells()), shortest(maze), "{preference}");
        }
    }),
    ("no-finish-reachable", |maze| {
        assert_eq!(shortest(maze), None);
        assert!(!maze.ways(maze.finish()[0]).is_empty(), "the finish is on a line");
        assert_eq!(run(maze).outcome(), Outcome::NoFinishReachable);
    }),
    ("long-way", |maze| {
        assert_eq!((found(maze, "S"), shortest(maze)), (54, Some(6)), "more than three times the shortest");
        let right_first = Settings { order: Order::Fixed(Preference::ALL[2]), ..Settings::default() };
        let list = TurnList::of(&explore(maze, &right_first).unwrap()).unwrap();
        assert_eq!(Route::drive(maze, &list).unwrap().cells(), 6);
    }),
    ("sixty-one-nodes", |maze| {
        assert_eq!(maze.nodes(), 61);
        assert_eq!(run(maze).outcome(), Outcome::TableFull { capacity: 50 });
        for (node_max, outcome) in [(60, Outcome::TableFull { capacity: 60 }), (61, Outcome::Finish)] {
            let trace = explore(maze, &Settings { node_max, ..Settings::default() }).unwrap();
            assert_eq!(trace.outcome(), outcome);
        }
        assert_eq!(shortest(maze), Some(15));
    }),
    ("turned", |maze| {
        assert_ne!(maze.start().unwrap().heading, Heading::North);
        assert_eq!((found(maze, "LS"), shortest(maze)), (12, Some(12)));
    }),
    ("hand-circles", |maze| {
        let round = Outcome::Circling { first: 1, again: 9 };
        for name in ["left-hand", "right-hand", "direction-sum-left", "direction-sum-right"] {
            assert_eq!(other(maze, name).outcome(), round, "{name}");
        }
        assert_eq!(run(maze).outcome(), Outcome::Finish);
    }),
    ("sakib-1", |maze| {
        for name in ["direction-sum-right", "direction-sum-left"] {
            assert_eq!(route_of(maze, name), ("LRR".to_owned(), 8));
        }
    }),
    ("sums-lap", |maze| {
        assert_eq!(route_of(maze, "direction-sum-right"), ("RRSRS".to_owned(), 14));
        assert_eq!(route_of(maze, "direction-sum-left"), ("L".to_owned(), 2));
    }),
    ("sakib-2", |maze| {
        let run = other(maze, "mapping");
        assert_eq!((run.outcome(), run.stops(), maze.scale.cell_mm()), (Outcome::Mapped, 11, 10.0));
        assert_eq!(route_of(maze, "mapping"), ("RR".to_owned(), 32));
    }),
    ("parex-1", |maze| {
        assert_eq!((maze.kind, maze.loops()), (Kind::Wall, 1));
        assert_eq!(route_of(maze, "parex-right").1, 7);
        let basic = Settings { rule: Rule::Basic, ..Settings::default() };
        let run = record(maze, &basic, Name::ParexRight).unwrap();
        assert_eq!(run.way(maze).unwrap().route.unwrap().cells(), 13, "14 squares are kept");
    }),
    ("parex-special-2", |maze| {
        assert_eq!((route_of(maze, "parex-right").1, route_of(maze, "parex-left").1), (15, 9));
    }),
    ("cornell-6x4", |maze| {
        assert_eq!(other(maze, "cornell-2").outcome(), Outcome::Circling { first: 20, again: 26 });
        let run = other(maze, "cornell-3");
        assert_eq!((run.outcome(), run.stops()), (Outcome::Mapped, 31));
    }),
    ("cornell-3x5", |maze| {
        assert_eq!(other(maze, "cornell-1").outcome(), Outcome::Circling { first: 1, again: 7 });
        for (name, moves) in [("cornell-2", 18), ("cornell-3", 16)] {
            assert_eq!((other(maze, name).outcome(), other(maze, name).stops()), (Outcome::Mapped, moves));
        }
    }),
    ("fast-or-short", |maze| {
        let (start, pace) = (maze.start().unwrap(), Pace::default());
        let (short, fast) =
            (best::shortest(maze, start, &pace).unwrap(), best::fastest(maze, start, &pace).unwrap());
        assert_eq!((short.cells, fast.cells), (8, 10));
        assert!(fast.seconds < short.seconds);
        // Turns that take no time make them the same.
        let nimble = Pace { turn_s: 0.0, ..pace };
        assert_eq!(best::fastest(maze, start, &nimble).unwrap().cells, 8);
        assert_eq!(route_of(maze, "flood-fill").1, 10, "the first way there is not the shortest");
    }),
];

/// A run of the book's explorer with its defaults.
fn run(maze: &Maze) -> Trace {
    explore(maze, &Settings::default()).unwrap()
}

/// A run of another explorer with its defaults.
fn other(maze: &Maze, name: &str) -> AnyRun {
    record(maze, &Settings::default(), name.parse().unwrap()).unwrap()
}

/// The letters and cells of the route that it leaves.
fn route_of(maze: &Maze, name: &str) -> (String, u32) {
    let way = other(maze, name).way(maze).unwrap();
    (way.list.to_string(), way.route.unwrap().cells())
}

/// The route that the run leaves has these letters and leads to the finish; its cells.
fn found(maze: &Maze, letters: &str) -> u32 {
    let trace = run(maze);
    assert_eq!(trace.outcome(), Outcome::Finish);
    let list = TurnList::of(&trace).unwrap();
    assert_eq!(list.to_string(), letters);
    Route::drive(maze, &list).unwrap().cells()
}

/// The maze is this one but for what is written about it.
fn same_lines(maze: &Maze, mut data: Maze) {
    data.about = maze.about.clone();
    assert_eq!(*maze, data);
}

fn shortest(maze: &Maze) -> Option<u32> {
    best::shortest(maze, maze.start().unwrap(), &Pace::default()).map(|best| best.cells)
}

fn points_with(maze: &Maze, ways: u32) -> Vec<Point> {
    maze.joined_points().filter(|(_, w)| w.count() == ways).map(|(at, _)| at).collect()
}

#[test]
fn every_sample_keeps_its_claim() {
    for (file, claim) in CLAIMS {
        let sample = SAMPLES.iter().find(|sample| sample.file == *file);
        claim(&sample.unwrap_or_else(|| panic!("{file} is not on the shelf")).maze());
    }
}

#[test]
fn every_explorer_has_a_sample_that_shows_what_it_cannot_do() {
    for name in Name::ALL {
        let file = name.about().sample;
        assert!(SAMPLES.iter().any(|sample| sample.file == file), "{name}: {file}");
    }
    // Those that map drive every line, though the finish is near: 6 cells away.
    let long_way = SAMPLES.iter().find(|sample| sample.file == "long-way").unwrap().maze();
    for name in ["mapping", "cornell-3"] {
        let run = other(&long_way, name);
        assert!(run.total().cells > 54, "{name}");
        assert_eq!(route_of(&long_way, name).1, 6);
    }
    for name in ["tremaux", "depth-first"] {
        assert_eq!(route_of(&long_way, name).1, 54, "{name}");
    }
}

#[test]
fn files_shelf_and_claims_are_the_same() {
    let files: BTreeSet<String> = std::fs::read_dir("mazes")
        .unwrap()
        .map(|entry| entry.unwrap().file_name().into_string().unwrap())
        .collect();
    let names = |names: Vec<&str>| names.iter().map(|name| format!("{name}.maze")).collect::<BTreeSet<_>>();
    assert_eq!(files, names(SAMPLES.iter().map(|sample| sample.file).collect()), "the shelf");
    assert_eq!(files, names(CLAIMS.iter().map(|claim| claim.0).collect()), "the claims");
}

#[test]
fn every_sample_can_be_read_and_says_what_it_is() {
    for sample in SAMPLES {
        let reading =
            file::read(sample.text.as_bytes()).unwrap_or_else(|error| panic!("{}: {error}", sample.file));
        assert_eq!(reading.remarks, [], "{}", sample.file);
        let maze = reading.maze;
        assert_eq!(maze, sample.maze());
        for text in [&maze.about.title, &maze.about.source, &maze.about.note] {
            assert!(!text.is_empty(), "{}", sample.file);
        }
        let sentences = maze.about.note.matches(['.', '?']).count();
        assert!((2..=6).contains(&sentences), "{}: {sentences} sentences", sample.file);
        assert_eq!(text::parse(&text::write(&maze)).unwrap(), maze, "{}", sample.file);
        assert_eq!(json::parse(&json::write(&maze)).unwrap(), maze, "{}", sample.file);
    }
    assert_eq!(samples::figure_3_1().about.title, "The run of the book");
}

#[test]
fn files_are_as_the_program_would_write_them() {
    for sample in SAMPLES {
        let (maze, text) = (sample.maze(), sample.text);
        let list = text.contains("\nlines:\n");
        let written = if list { text::write(&maze) } else { text::write_drawing(&maze) };
        assert_eq!(written, text, "{}", sample.file);
    }
}

#[test]
fn no_sample_has_a_finding_that_it_does_not_teach() {
    for sample in SAMPLES {
        let maze = sample.maze();
        let titles: Vec<_> = checks::check(&maze).iter().map(|finding| finding.title_in(maze.kind)).collect();
        match sample.file {
            "no-finish-reachable" => {
                assert_eq!(titles, ["Finish can’t be reached", "Lines apart from the rest"])
            }
            // They are about mapping, to which a finish is no matter, nor where it starts: it is not the book's.
            "cornell-6x4" => assert_eq!(titles, ["Start faces a wall", "No finish"]),
            "cornell-3x5" => assert_eq!(titles, ["Start has several ways out", "No finish"]),
            file => assert!(titles.is_empty(), "{file}: {titles:?}"),
        }
    }
}
