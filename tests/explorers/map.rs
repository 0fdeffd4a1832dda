//! Full mapping: figure 2 of the paper with the table of figure 3, by the rules.

use line_maze_lab::event::Outcome;
use line_maze_lab::explorer::mapping::search::Aim;
use line_maze_lab::explorer::mapping::{Column, Mapping};
use line_maze_lab::explorer::mind::Mind;
use line_maze_lab::explorer::name::Name;
use line_maze_lab::geometry::Heading;
use line_maze_lab::maze::Maze;
use line_maze_lab::recording::Recording;
use line_maze_lab::settings::Search;

use crate::hands::recording;
use crate::support::maze;

/// Figure 2; a cell is a centimetre.
fn sakib_2() -> Maze {
    maze(
        &[
            &[(0, 0), (0, 10), (14, 10), (14, 13), (14, 16)],
            &[(0, 10), (-5, 10)],
            &[(0, 10), (0, 13), (14, 13)],
            &[(14, 10), (14, 2)],
        ],
        (0, 0, Heading::North),
        &[(14, 2)],
    )
}

pub(crate) fn mapped(run: &Recording) -> &Mapping {
    match run.last() {
        Mind::Mapping(map) => map,
        other => panic!("{other:?}"),
    }
}

/// The figure's letters in the order in which the points are recorded.
const LETTERS: &[u8] = b"SAEDGCBF";

#[test]
fn figures_2_and_3() {
    let run = recording(&sakib_2(), Name::Mapping);
    assert_eq!(run.outcome(), Outcome::Mapped);
    let map = mapped(&run);
    let columns: Vec<Column> = (0..map.visits()).filter_map(|visit| map.column(visit)).collect();
    let row = |of: fn(&Column) -> i32| columns.iter().map(of).collect::<Vec<_>>();
    let points: String = columns.iter().map(|column| LETTERS[column.point as usize] as char).collect();
    assert_eq!(points, "SAEDGDCABAEF");
    assert_eq!(row(|column| column.kind), [0, 3, 2, 2, 0, 2, 1, 3, 0, 3, 2, 0]);
    assert_eq!(row(|column| column.explored as i32), [0, 1, 1, 1, 1, 2, 1, 3, 1, 4, 2, 1]);
    let cells = |ms: i32| ms / 400;
    assert_eq!(
        row(|c| c.x).into_iter().map(cells).collect::<Vec<_>>(),
        [0, 0, 14, 14, 14, 14, 0, 0, -5, 0, 14, 14]
    );
    assert_eq!(
        row(|c| c.y).into_iter().map(cells).collect::<Vec<_>>(),
        [0, 10, 10, 13, 16, 13, 13, 10, 10, 10, 10, 2]
    );
    let degrees: Vec<usize> = (0..8).map(|point| map.neighbours(point).count()).collect();
    // S A E D G C B F
    assert_eq!(degrees, [1, 4, 3, 3, 1, 2, 1, 1]);
    assert_eq!(run.tally(run.stops()).cells, 82);
    let name = |points: Vec<u32>| -> String { points.iter().map(|&p| LETTERS[p as usize] as char).collect() };
    assert_eq!(name(map.adjacency(1)), "SECB");
    assert_eq!(name(map.route(Aim::Shortest).unwrap()), "SAEF");
}

#[test]
fn a_search_can_be_watched() {
    let run = recording(&sakib_2(), Name::Mapping);
    let map = mapped(&run);
    let mut search = map.search(Aim::Shortest);
    let mut settled = String::new();
    while let Some(step) = search.step() {
        settled.push(LETTERS[step.point as usize] as char);
        if step.point == 1 {
            let mut frontier: Vec<char> = search.frontier().map(|p| LETTERS[p as usize] as char).collect();
            frontier.sort_unstable();
            assert_eq!(frontier, ['B', 'C', 'E']);
        }
    }
    // By distance: S 0, A 10, C 13, B 15, E 24, D 27, G 30, F 32.
    assert_eq!(settled, "SACBEDGF");
    let straight = search::Search::new(map, Aim::Shortest, Search::AStar);
    assert_eq!(straight.finish(), map.route(Aim::Shortest));
}

use line_maze_lab::explorer::mapping::search;
