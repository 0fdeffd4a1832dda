//! PAReX path mapping and the Cornell traversals: the articles' runs, square by square.

use line_maze_lab::event::Outcome;
use line_maze_lab::explorer::mind::Mind;
use line_maze_lab::explorer::name::Name;
use line_maze_lab::explorer::parex::Numbering;
use line_maze_lab::geometry::{Heading, Point};
use line_maze_lab::maze::{Bounds, Maze, Start};
use line_maze_lab::recording::Recording;
use line_maze_lab::run::{AnyRun, record};
use line_maze_lab::settings::{Rule, Settings};

use crate::hands::recording;
use crate::support::maze;

/// A field of so many squares with these openings between numbered ones; start 1 facing up, goal 4.
fn field(width: i32, height: i32, openings: &[(i32, i32)]) -> Maze {
    let at = |number: i32| Point::new((number - 1) % width, (number - 1) / width);
    let mut maze = Maze::new(Bounds::new(Point::new(0, 0), Point::new(width - 1, height - 1)).unwrap());
    for &(a, b) in openings {
        let heading = Heading::ALL.into_iter().find(|&heading| at(a).step(heading) == at(b));
        assert!(maze.draw(at(a), heading.unwrap()));
    }
    maze.set_start(Some(Start { at: at(1), heading: Heading::North }));
    maze.set_finish(vec![at(4)]);
    maze
}

const TREE: [(i32, i32); 11] =
    [(1, 5), (5, 6), (6, 2), (6, 7), (7, 3), (5, 9), (9, 10), (10, 11), (11, 12), (12, 8), (8, 4)];

fn ruled(maze: &Maze, name: Name, rule: Rule) -> Recording {
    match record(maze, &Settings { rule, ..Settings::default() }, name).unwrap() {
        AnyRun::Other(run) => run,
        AnyRun::Book(_) => unreachable!(),
    }
}

fn parex(run: &Recording) -> (Vec<i32>, Vec<i32>) {
    assert_eq!(run.outcome(), Outcome::Finish);
    let squares = (0..=run.stops()).map(|stop| match run.at(stop).mind {
        Mind::Parex(mind) => mind.square(),
        other => panic!("{other:?}"),
    });
    let Mind::Parex(last) = run.last() else { unreachable!() };
    (squares.collect(), last.path().to_vec())
}

#[test]
fn the_maze_of_the_article() {
    let squares = vec![1, 5, 6, 2, 6, 7, 3, 7, 6, 5, 9, 10, 11, 12, 8, 4];
    let path = vec![1, 5, 9, 10, 11, 12, 8, 4];
    for rule in [Rule::Basic, Rule::Special1] {
        let run = ruled(&field(4, 3, &TREE), Name::ParexRight, rule);
        assert_eq!(parex(&run), (squares.clone(), path.clone()), "{rule:?}");
    }
}

#[test]
fn special_case_1_needs_its_rule() {
    let mut openings = TREE.to_vec();
    openings.push((2, 3));
    let maze = field(4, 3, &openings);
    let squares = vec![1, 5, 6, 2, 3, 7, 6, 5, 9, 10, 11, 12, 8, 4];
    let path = vec![1, 5, 9, 10, 11, 12, 8, 4];
    assert_eq!(parex(&ruled(&maze, Name::ParexRight, Rule::Special1)), (squares.clone(), path));
    assert_eq!(parex(&ruled(&maze, Name::ParexRight, Rule::Basic)), (squares.clone(), squares));
}

#[test]
fn special_case_2_is_beyond_it() {
    let openings = [
        (1, 5),
        (5, 6),
        (6, 2),
        (2, 3),
        (3, 7),
        (7, 11),
        (11, 10),
        (10, 9),
        (9, 13),
        (13, 14),
        (14, 15),
        (15, 16),
        (16, 12),
        (12, 8),
        (8, 4),
        (5, 9),
    ];
    let maze = field(4, 4, &openings);
    let right = vec![1, 5, 6, 2, 3, 7, 11, 10, 9, 13, 14, 15, 16, 12, 8, 4];
    assert_eq!(parex(&ruled(&maze, Name::ParexRight, Rule::Special1)), (right.clone(), right));
    let left = vec![1, 5, 9, 13, 14, 15, 16, 12, 8, 4];
    assert_eq!(parex(&ruled(&maze, Name::ParexLeft, Rule::Special1)).1, left);
}

#[test]
fn the_path_can_be_too_long_for_its_array() {
    let maze = field(4, 3, &TREE);
    for (path_max, outcome) in [(7, Outcome::PathFull { capacity: 7 }), (8, Outcome::Finish)] {
        let settings = Settings { path_max: Some(path_max), ..Settings::default() };
        let run = record(&maze, &settings, Name::ParexRight).unwrap();
        assert_eq!(run.outcome(), outcome);
    }
}

fn cornell_6x4() -> Maze {
    maze(
        &[
            &[(0, 3), (3, 3)],
            &[(4, 3), (5, 3)],
            &[(0, 2), (1, 2)],
            &[(2, 2), (3, 2)],
            &[(4, 2), (5, 2)],
            &[(0, 1), (1, 1)],
            &[(3, 1), (5, 1)],
            &[(0, 0), (3, 0)],
            &[(4, 0), (5, 0)],
            &[(0, 0), (0, 2)],
            &[(1, 1), (1, 2)],
            &[(2, 0), (2, 2)],
            &[(3, 2), (3, 3)],
            &[(3, 0), (3, 1)],
            &[(4, 0), (4, 3)],
            &[(5, 0), (5, 2)],
        ],
        (0, 3, Heading::South),
        &[],
    )
}

fn cornell_3x5() -> Maze {
    maze(
        &[
            &[(0, 4), (2, 4)],
            &[(0, 3), (2, 3)],
            &[(1, 2), (2, 2)],
            &[(0, 1), (2, 1)],
            &[(0, 0), (2, 0)],
            &[(0, 3), (0, 4)],
            &[(0, 0), (0, 2)],
            &[(1, 1), (1, 2)],
            &[(2, 2), (2, 4)],
            &[(2, 0), (2, 1)],
        ],
        (0, 4, Heading::South),
        &[],
    )
}

/// The squares as `xy`, y downwards.
fn squares(run: &Recording) -> String {
    let xy = |stop| match run.at(stop).mind {
        Mind::Cornell(mind) => format!("{}{}", mind.position().0, mind.position().1),
        other => panic!("{other:?}"),
    };
    (0..=run.stops()).map(xy).collect::<Vec<_>>().join(" ")
}

fn bytes(run: &Recording) -> Vec<String> {
    let Mind::Cornell(mind) = run.last() else { unreachable!() };
    let width = mind.squares().field().width as usize;
    let row = |row: &[u8]| row.iter().map(|byte| format!("{byte:02X}")).collect::<Vec<_>>().join(" ");
    mind.squares().bytes().chunks(width).map(row).collect()
}

#[test]
fn cornell_6_by_4() {
    let run = |name| recording(&cornell_6x4(), name);
    let one = run(Name::Cornell1);
    assert_eq!(squares(&one), "00 10 20 30 31 21 22 23 33 32 42 52 51 41 42 43 53 52 51");
    assert_eq!(one.outcome(), Outcome::Circling { first: 12, again: 18 });
    let two = run(Name::Cornell2);
    let expected = "00 10 20 30 31 21 22 23 33 32 42 52 51 41 40 50 40 41 42 43 53 52 51 41 42 43 53";
    assert_eq!(squares(&two), expected);
    assert_eq!(two.outcome(), Outcome::Circling { first: 20, again: 26 });
    let three = run(Name::Cornell3);
    let expected =
        "00 10 20 30 31 21 22 23 33 32 42 52 51 41 40 50 40 41 42 43 53 52 42 32 33 23 13 03 02 01 11 12";
    assert_eq!(squares(&three), expected);
    assert_eq!((three.outcome(), three.stops()), (Outcome::Mapped, 31));
    let rows = ["1B 1A 1A 1C 19 1E", "19 1C 19 16 11 1C", "11 16 15 19 10 14", "13 1A 12 16 13 16"];
    assert_eq!(bytes(&three), rows);
}

#[test]
fn cornell_3_by_5() {
    let run = |name| recording(&cornell_3x5(), name);
    let one = run(Name::Cornell1);
    assert_eq!(squares(&one), "00 01 11 21 20 10 00 01");
    assert_eq!(one.outcome(), Outcome::Circling { first: 1, again: 7 });
    let two = run(Name::Cornell2);
    assert_eq!(squares(&two), "00 01 11 21 20 10 00 01 11 21 22 12 13 23 24 14 04 03 02");
    assert_eq!((two.outcome(), two.stops()), (Outcome::Mapped, 18));
    let three = run(Name::Cornell3);
    assert_eq!(squares(&three), "00 01 11 21 20 10 20 21 22 12 13 23 24 14 04 03 02");
    assert_eq!((three.outcome(), three.stops()), (Outcome::Mapped, 16));
    assert_eq!(bytes(&three), ["19 1A 1C", "13 1A 14", "1D 19 16", "11 12 1C", "13 1A 16"]);
}

#[test]
fn where_no_way_leaves_the_start_everyone_is_stuck() {
    let mut alone = field(4, 3, &[(6, 7)]);
    alone.set_finish(vec![Point::new(2, 1)]);
    for &name in &Name::ALL[1..] {
        assert_eq!(recording(&alone, name).outcome(), Outcome::Stuck, "{name}");
    }
}

#[test]
fn a_robot_that_knows_no_bounds_numbers_from_the_middle_of_24_by_24() {
    let number = |x, y| Numbering::UNKNOWN.number(Point::new(x, y));
    assert_eq!(
        [number(0, 0), number(1, 0), number(-1, 0), number(0, 1), number(0, -1)],
        [276, 277, 275, 300, 252]
    );
}
