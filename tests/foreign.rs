//! Mazes as other people and other programs write them: each is read one way, and what was made of it is said.
#![allow(clippy::unwrap_used, missing_docs)]

use std::path::Path;

use line_maze_lab::geometry::{Heading, Point};
use line_maze_lab::maze::{Maze, Reading, Start, checks, file, text};
use line_maze_lab::{run, settings::Settings, world};

/// A file in `tests/fixtures/foreign`.
struct Case {
    name: &'static str,
    /// The same maze as the lab writes it, without the first line.
    own: &'static str,
    /// What is said about it: `line:column: ` where it has a place.
    remarks: &'static [&'static str],
}

#[rustfmt::skip]
const CASES: &[Case] = &[
    Case {
        name: "begins-late.txt",
        own: "\
kind: wall

>---F",
        remarks: &[
            "4:1: The maze begins in line 4; what stands before it was left out.",
            "The file gives no heading; at the start 0,0 the robot faces east, its only way.",
        ],
    },
    Case {
        name: "capital-posts.txt",
        own: "\
kind: wall

^---F
|
+---+",
        remarks: &[
            "1:1: “O” was taken for the posts, which usually are “o”.",
        ],
    },
    Case {
        name: "caption.txt",
        own: "\
kind: wall

>---F",
        remarks: &[
            "4:1: The maze ends before line 4; what stands there was left out.",
            "The file gives no heading; at the start 0,0 the robot faces east, its only way.",
        ],
    },
    Case {
        name: "columns-of-openings.json",
        own: "\
kind: wall

+   +---+
|       |
^---+---+",
        remarks: &[
            "It was read as a list of walls: columns from the west, each from the south; a bit is an opening.",
            "The file names no finish.",
        ],
    },
    Case {
        name: "cr-only.maze",
        own: "\
title: Old ends

+---F
|
^   .",
        remarks: &[],
    },
    Case {
        name: "cr-only.num",
        own: "\
kind: wall

>---+",
        remarks: &[
            "The file gives no heading; at the start 0,0 the robot faces east, its only way.",
            "The file names no finish.",
        ],
    },
    Case {
        name: "cr-only.txt",
        own: "\
kind: wall

^---+
|
+---F",
        remarks: &[],
    },
    Case {
        name: "crlf.map",
        own: "\
kind: wall

^---+---+
|   |
+---+   F
|       |
+---+---+",
        remarks: &[],
    },
    Case {
        name: "dots-for-posts.txt",
        own: "\
kind: wall

>---F",
        remarks: &[
            "1:1: “.” was taken for the posts, which usually are “o”.",
            "The file gives no heading; at the start 0,0 the robot faces east, its only way.",
        ],
    },
    Case {
        name: "five-by-five.maz",
        own: "\
kind: wall

+---+---+---+---+
|   |   |   |   |
+---+---+---+---+
|   |   |   |   |
+---+---+---+---+
|   |   |   |   |
+---+---+---+---+
|   |   |   |   |
^   +---+---+---+",
        remarks: &[
            "The file names no finish.",
        ],
    },
    Case {
        name: "goals-off-centre.txt",
        own: "\
kind: wall

+---+   F---F
    |   |   |
+   +   F---F
|   |   |
+   +---+---+
|           |
^   +---+---+",
        remarks: &[],
    },
    Case {
        name: "grid-of-squares.txt",
        own: "\
kind: wall

^---+---+---+
|   |   |   |
+---+---F---F
|   |   |   |
+---+---F---F",
        remarks: &[
            "It was read as a grid in which every open place is a square.",
        ],
    },
    Case {
        name: "grid-with-entrances.txt",
        own: "\
kind: wall

+---^   +---+
|   |   |   |
+   +---+   F",
        remarks: &[
            "1:4: The way through the outer wall was closed, and the square inside it taken instead.",
            "4:9: The way through the outer wall was closed, and the square inside it taken instead.",
            "It was read as a grid in which squares and the walls between them take turns.",
        ],
    },
    Case {
        name: "grid-without-marks.txt",
        own: "\
kind: wall

>---+   +---+",
        remarks: &[
            "It was read as a grid in which squares and the walls between them take turns.",
            "The file names no start; it was put in the south-west, 0,0.",
            "The file gives no heading; at the start 0,0 the robot faces east, its only way.",
            "The file names no finish.",
        ],
    },
    Case {
        name: "grid.json",
        own: "\
kind: wall

+---+
    |
>---+",
        remarks: &[
            "It was read as a grid in which squares and the walls between them take turns.",
            "The file names no start; it was put in the south-west, 0,0.",
            "The file gives no heading; at the start 0,0 the robot faces east, its only way.",
            "The file names no finish.",
        ],
    },
    Case {
        name: "grid.txt",
        own: "\
kind: wall

F---+   +---+
    |   |   |
+---+   +   ^
|       |   |
+---+---+   +",
        remarks: &[
            "It was read as a grid in which squares and the walls between them take turns.",
        ],
    },
    Case {
        name: "half-walls.map",
        own: "\
kind: wall

>---+   F
    |   |
+---+---+",
        remarks: &[
            "3:2: 2 walls are drawn in part; their middles say whether they are.",
            "The file gives no heading; at the start 0,1 the robot faces east, its only way.",
        ],
    },
    Case {
        name: "indented.txt",
        own: "\
kind: wall

>---F",
        remarks: &[
            "2:1: The maze is indented by 4 columns, which were left out.",
            "The file gives no heading; at the start 0,0 the robot faces east, its only way.",
        ],
    },
    Case {
        name: "no-finish.num",
        own: "\
kind: wall

>---+---+",
        remarks: &[
            "The file gives no heading; at the start 0,0 the robot faces east, its only way.",
            "The file names no finish.",
        ],
    },
    Case {
        name: "one-list-of-walls.json",
        own: "\
kind: wall

+   +
|   |
^---+",
        remarks: &[
            "It was read as a list of walls: columns from the west, each from the south; a bit is a wall.",
            "The file names no finish.",
        ],
    },
    Case {
        name: "own-in-a-page.maze",
        own: "\
title: From a page

+---F
|
^   .",
        remarks: &[
            "3:1: The maze begins in line 3; what stands before it was left out.",
            "3:1: The maze is indented by 4 columns, which were left out.",
        ],
    },
    Case {
        name: "rows-of-walls.json",
        own: "\
kind: wall

+   +---+
|       |
^---+---+",
        remarks: &[
            "It was read as a list of walls: rows from the north; a bit is a wall.",
            "The file names no finish.",
        ],
    },
    Case {
        name: "start-faces-a-wall.map",
        own: "\
kind: wall

+---F---+
    |
>---F---+",
        remarks: &[
            "The file names no finish; in a .map file that means the centre.",
            "The file gives no heading; at the start 0,0 the robot faces east, its only way.",
        ],
    },
    Case {
        name: "start-with-two-ways.txt",
        own: "\
kind: wall

+---+---F
|       |
^---+   +",
        remarks: &[],
    },
    Case {
        name: "tabbed.map",
        own: "\
kind: wall

>---F",
        remarks: &[
            "1:1: The maze is indented by 1 column, which was left out.",
            "The file gives no heading; at the start 0,0 the robot faces east, its only way.",
        ],
    },
    Case {
        name: "three-columns.txt",
        own: "\
kind: wall

^---+
|
+---F",
        remarks: &[],
    },
    Case {
        name: "two-columns.maze",
        own: "\
kind: wall

+---+   F
|   |   |
^   +---+",
        remarks: &[],
    },
    Case {
        name: "unknown-outside.txt",
        own: "\
kind: wall

>---F   .",
        remarks: &[
            "1:10: 3 unknown walls were taken as walls.",
            "The file gives no heading; at the start 0,0 the robot faces east, its only way.",
        ],
    },
    Case {
        name: "unknown-walls.maze",
        own: "\
kind: wall

+---+   F
|       |
^   .   +",
        remarks: &[
            "3:6: 3 unknown walls were taken as walls.",
        ],
    },
];

fn read(name: &str) -> Reading {
    let bytes = std::fs::read(Path::new("tests/fixtures/foreign").join(name)).unwrap();
    file::read(&bytes).unwrap_or_else(|error| panic!("{name}: {error}"))
}

fn said(reading: &Reading) -> Vec<String> {
    let said = reading.remarks.iter().map(|remark| match remark.place() {
        Some(place) => format!("{}:{}: {remark}", place.line, place.column),
        None => remark.to_string(),
    });
    said.collect()
}

#[test]
fn what_others_write_is_read_and_said() {
    for case in CASES {
        let reading = read(case.name);
        let own = text::parse(&format!("line-maze: 1\n{}", case.own)).unwrap();
        let drawn = text::write_drawing(&reading.maze);
        assert_eq!(reading.maze, own, "{} was read as\n{drawn}", case.name);
        assert_eq!(said(&reading), case.remarks, "{}", case.name);
    }
    for entry in std::fs::read_dir("tests/fixtures/foreign").unwrap() {
        let name = entry.unwrap().file_name().into_string().unwrap();
        assert!(
            CASES.iter().any(|case| case.name == name) || name == LARGE,
            "{name} has no entry in the table"
        );
    }
}

/// A byte for each of 32 × 32 squares, all open but for the outer wall and one east of the start.
const LARGE: &str = "half-size.maz";

#[test]
fn a_binary_file_is_as_large_as_its_length_tells() {
    let reading = read(LARGE);
    let maze = &reading.maze;
    assert_eq!((maze.bounds().ne(), maze.cells()), (Point::new(31, 31), 2 * 32 * 31 - 1));
    assert!(
        !maze.has_line(Point::new(0, 0), Heading::East) && maze.has_line(Point::new(0, 0), Heading::North)
    );
    assert_eq!(said(&reading), ["The file names no finish."]);
    assert_eq!(maze.bounds().centre().len(), 4);
}

/// A walled maze with these openings out of its start.
fn facing(heading: Heading, openings: &[Heading]) -> Maze {
    let mut maze = text::parse("line-maze: 1\nkind: wall\nbounds: 0,0 2,2\nfinish: 2,2\nlines:\n").unwrap();
    let at = Point::new(1, 1);
    openings.iter().for_each(|&side| assert!(maze.draw(at, side)));
    assert!(maze.set_start(Some(Start { at, heading })));
    maze
}

/// What `check` calls an error keeps the book's explorer from starting, and nothing else does.
#[test]
fn check_and_run_judge_a_start_alike() {
    let all = Heading::ALL;
    let mut judged = [0, 0];
    for faces in all {
        for set in 0..16_u8 {
            let openings: Vec<Heading> =
                all.into_iter().filter(|heading| set & 1 << heading.index() != 0).collect();
            for kind in [line_maze_lab::maze::Kind::Line, line_maze_lab::maze::Kind::Wall] {
                for finish in [Point::new(2, 2), Point::new(1, 1)] {
                    let mut maze = facing(faces, &openings);
                    maze.kind = kind;
                    assert!(maze.set_finish(vec![finish]));
                    let errors = checks::check(&maze)
                        .iter()
                        .filter(|finding| finding.severity() == checks::Severity::Error)
                        .count();
                    let starts = run::explore(&maze, &Settings::default()).is_ok();
                    assert_eq!(errors == 0, starts, "{}", text::write_drawing(&maze));
                    assert_eq!(starts, world::line_start(&maze).is_ok());
                    judged[usize::from(starts)] += 1;
                }
            }
        }
    }
    assert_eq!(judged, [4 * 16 * 4 - 8, 8], "a run begins facing the only way, off the finish");
}
