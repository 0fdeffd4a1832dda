//! Hand rules and direction sums.

use line_maze_lab::event::Outcome;
use line_maze_lab::explorer::mind::{Mind, Plan};
use line_maze_lab::explorer::name::Name;
use line_maze_lab::geometry::{Heading, Turn};
use line_maze_lab::maze::Maze;
use line_maze_lab::recording::Recording;
use line_maze_lab::run::{AnyRun, record};
use line_maze_lab::settings::Settings;

use crate::support::maze;

pub(crate) fn recording(maze: &Maze, name: Name) -> Recording {
    match record(maze, &Settings::default(), name).unwrap() {
        AnyRun::Other(run) => run,
        AnyRun::Book(_) => panic!("{name} has a recording"),
    }
}

/// Figure 1 of the paper.
fn sakib_1() -> Maze {
    maze(
        &[
            &[(0, 0), (0, 2)],
            &[(-2, 2), (2, 2)],
            &[(-2, 2), (-2, 4), (0, 4)],
            &[(-2, 2), (-3, 2)],
            &[(-2, 4), (-2, 5)],
        ],
        (0, 0, Heading::North),
        &[(0, 4)],
    )
}

/// `(j, a)` after each stop but the start.
fn sums(run: &Recording) -> Vec<(i32, Vec<u8>)> {
    (1..=run.stops())
        .map(|stop| match run.at(stop).mind {
            Mind::Sums(sums) => (sums.j(), sums.a().to_vec()),
            other => panic!("{other:?}"),
        })
        .collect()
}

pub(crate) fn letters(run: &Recording) -> String {
    match run.last().robot().plan() {
        Some(Plan::Letters(letters)) => letters.into_iter().map(Turn::letter).collect(),
        other => panic!("{other:?}"),
    }
}

#[test]
fn figure_1_right_first() {
    let run = recording(&sakib_1(), Name::DirectionSumRight);
    let expected = [(1, vec![1]), (0, vec![1]), (1, vec![3]), (2, vec![3, 1]), (3, vec![3, 1, 1])];
    assert_eq!(sums(&run)[..5], expected);
    assert_eq!((run.outcome(), letters(&run).as_str()), (Outcome::Finish, "LRR"));
}

#[test]
fn figure_1_left_first() {
    let run = recording(&sakib_1(), Name::DirectionSumLeft);
    let arrays: Vec<Vec<u8>> = sums(&run).into_iter().map(|(_, a)| a).collect();
    let expected: [&[u8]; 7] = [&[3], &[3, 2], &[3, 2], &[3, 1], &[3, 1, 2], &[3, 1, 2], &[3, 1, 1]];
    assert_eq!(arrays[..7], expected);
    assert_eq!((run.stops(), letters(&run).as_str()), (8, "LRR"));
}

#[test]
fn even_a_small_loop_can_put_a_lap_into_the_array() {
    let lap = maze(
        &[
            &[(0, 0), (0, 1)],
            &[(-1, 1), (2, 1)],
            &[(2, 1), (2, 0), (4, 0), (4, 2), (2, 2), (2, 1)],
            &[(4, 1), (5, 1)],
        ],
        (0, 0, Heading::North),
        &[(-1, 1)],
    );
    let right = recording(&lap, Name::DirectionSumRight);
    assert_eq!(sums(&right).pop().unwrap().1, [1, 1, 2, 1, 2]);
    let left = recording(&lap, Name::DirectionSumLeft);
    assert_eq!(sums(&left).pop().unwrap().1, [3]);
}

#[test]
fn a_finish_inside_a_loop_makes_hands_and_sums_circle() {
    let inside = maze(
        &[&[(0, 0), (0, 1)], &[(0, 1), (2, 1), (2, 5), (-2, 5), (-2, 1), (0, 1)], &[(0, 5), (0, 3)]],
        (0, 0, Heading::North),
        &[(0, 3)],
    );
    for name in [Name::LeftHand, Name::RightHand, Name::DirectionSumLeft, Name::DirectionSumRight] {
        let run = recording(&inside, name);
        assert_eq!(run.outcome(), Outcome::Circling { first: 1, again: 9 }, "{name}");
    }
}
