//! The book's walk-throughs, stop by stop: every column of the golden tables.
#![allow(clippy::unwrap_used, clippy::expect_used)]

mod support;

use expect_test::expect;
use line_maze_lab::event::Outcome;
use line_maze_lab::geometry::Heading;
use line_maze_lab::ink::Ink;
use line_maze_lab::maze::Maze;
use line_maze_lab::route::{Route, TurnList, best};
use line_maze_lab::run::explore;
use line_maze_lab::settings::{Pace, Settings};
use line_maze_lab::trace::{Moment, Trace};
use support::{figure_2_4, figure_3_1};

const CELL_MS: u32 = 400;

/// One line a stop: number, what is seen, node, place, case, way out, ptr, returning.
fn table(maze: &Maze, trace: &Trace) -> String {
    let ink = Ink::of(maze, trace, CELL_MS);
    let line = |stop: u32| {
        let frame = trace.frame(Moment::after(stop));
        let (step, state) = (trace.step(stop).unwrap(), frame.state);
        let node = if step.node() > 0 { format!(" {}", step.node()) } else { String::new() };
        let leaves = step.turn().map_or("-".to_owned(), |_| step.departure().index().to_string());
        format!(
            "{stop} {}{node} | {} | {} | {leaves} | {} | {}\n",
            step.sighting().seen().name(),
            ink.place(stop),
            step.case().name().unwrap_or(""),
            state.ptr,
            state.returning
        )
    };
    (1..=trace.stops()).map(line).collect()
}

#[test]
fn figure_3_1_is_walked_as_the_book_tells() {
    let maze = figure_3_1();
    let trace = explore(&maze, &Settings::default()).unwrap();
    expect![[r#"
        1 node 1 | 0,1 | new | 0 | 2 | false
        2 node 2 | 0,3 | new | 0 | 3 | false
        3 corner | 0,5 |  | 1 | 3 | false
        4 node 3 | 3,5 | new | 1 | 4 | false
        5 corner | 6,5 |  | 2 | 4 | false
        6 node 4 | 6,1 | new | 2 | 5 | false
        7 corner | 6,0 |  | 1 | 5 | false
        8 dead-end | 7,0 | dead-end | 3 | 5 | true
        9 corner | 6,0 |  | 0 | 5 | true
        10 node 4 | 6,1 | known | 3 | 5 | false
        11 node 5 | 4,1 | new | 3 | 6 | false
        12 node 6 | 2,1 | new | 3 | 7 | false
        13 node 1 | 0,1 | unknown-uturn | 1 | 7 | true
        14 node 6 | 2,1 | known | 0 | 7 | false
        15 corner | 2,3 |  | 3 | 7 | false
        16 node 2 | 0,3 | unknown-uturn | 1 | 7 | true
        17 corner | 2,3 |  | 2 | 7 | true
        18 node 6 | 2,1 | known-back | 1 | 6 | true
        19 node 5 | 4,1 | known | 0 | 6 | false
        20 dead-end | 4,2 | dead-end | 2 | 6 | true
        21 node 5 | 4,1 | known-back | 1 | 5 | true
        22 node 4 | 6,1 | known-back | 0 | 4 | true
        23 corner | 6,5 |  | 3 | 4 | true
        24 node 3 | 3,5 | known | 2 | 4 | false
        25 finish | 3,4 |  | - | 4 | false
    "#]]
    .assert_eq(&table(&maze, &trace));
    assert_eq!(trace.outcome(), Outcome::Finish);
    assert_eq!(trace.state(25).driven_ms, 49 * u64::from(CELL_MS));
}

#[test]
fn figure_3_1_crosses_out_the_cells_that_the_book_crosses_out() {
    let maze = figure_3_1();
    let trace = explore(&maze, &Settings::default()).unwrap();
    let ink = Ink::of(&maze, &trace, CELL_MS);
    let crossed: Vec<u32> = (0..=25).map(|stop| ink.crossed_cells(stop)).collect();
    let told = [0, 0, 0, 0, 0, 0, 0, 0, 0, 1, 2, 2, 2, 2, 4, 4, 4, 6, 8, 10, 10, 11, 13, 17, 20, 20];
    assert_eq!(crossed, told);
    assert_eq!(ink.driven_cells(25), 29);
}

#[test]
fn figure_3_1_ends_with_the_shortest_route() {
    let maze = figure_3_1();
    let trace = explore(&maze, &Settings::default()).unwrap();
    let list = TurnList::of(&trace).unwrap();
    assert_eq!(list.to_string(), "SSR");
    assert_eq!(list.c_array("Book, figure 3.1"), "const char turns[] = \"SSR\"; // Book, figure 3.1");
    let route = Route::drive(&maze, &list).unwrap();
    assert_eq!(route.cells(), 9);
    let shortest = best::shortest(&maze, maze.start().unwrap(), &Pace::default());
    assert_eq!(shortest.map(|best| best.cells), Some(9));
}

#[test]
fn figure_2_4_forgets_its_loop_without_a_u_turn() {
    let maze = figure_2_4();
    let trace = explore(&maze, &Settings::default()).unwrap();
    expect![[r#"
        1 node 1 | 0,2 | new | 1 | 2 | false
        2 node 2 | 3,2 | new | 1 | 3 | false
        3 corner | 5,2 |  | 2 | 3 | false
        4 corner | 5,0 |  | 3 | 3 | false
        5 corner | 3,0 |  | 0 | 3 | false
        6 node 2 | 3,2 | unknown-back | 3 | 2 | true
        7 node 1 | 0,2 | known | 3 | 2 | false
        8 finish | -2,2 |  | - | 2 | false
    "#]]
    .assert_eq(&table(&maze, &trace));
    assert_eq!(trace.state(8).driven_ms, 18 * u64::from(CELL_MS));
    let ink = Ink::of(&maze, &trace, CELL_MS);
    // The loop at once, then the way back to node 1.
    assert_eq!((5..=8).map(|stop| ink.crossed_cells(stop)).collect::<Vec<_>>(), [0, 8, 11, 11]);
}

#[test]
fn a_wide_epsilon_takes_one_node_for_another_and_gets_lost() {
    let settings = Settings { epsilon_ms: Some(2 * CELL_MS + CELL_MS / 2), ..Settings::default() };
    let maze = figure_3_1();
    let trace = explore(&maze, &settings).unwrap();
    assert_eq!(trace.outcome(), Outcome::NoLine { node: 1, heading: Heading::South });
    assert_eq!(trace.outcome().to_string(), "lost at node 1: there is no line south (2)");
    assert_eq!(trace.stops(), 4);
    assert_eq!(trace.step(2).unwrap().node(), 1, "(0,3) is taken for node 1");
    assert_eq!(Ink::of(&maze, &trace, CELL_MS).place(4).to_string(), "2,1");
}

#[test]
fn an_epsilon_of_zero_never_meets_a_node_again() {
    let settings = Settings { epsilon_ms: Some(0), ..Settings::default() };
    let trace = explore(&figure_3_1(), &settings).unwrap();
    assert_eq!(trace.outcome(), Outcome::TableFull { capacity: 50 });
    assert_eq!(trace.outcome().to_string(), "node table full (50)");
    assert_eq!(trace.state(trace.stops()).ptr, 51);
}

#[test]
fn the_figure_s_node_table_after_stop_13() {
    let trace = explore(&figure_3_1(), &Settings::default()).unwrap();
    let row = |m: u32| {
        let row = trace.row(Moment::after(13), m).unwrap();
        let ways: String = Heading::ALL
            .into_iter()
            .map(|h| match row.way(h) {
                line_maze_lab::trace::WayState::None => '.',
                line_maze_lab::trace::WayState::Unvisited => 'o',
                line_maze_lab::trace::WayState::Visited => 'v',
                line_maze_lab::trace::WayState::Crossed => 'x',
            })
            .collect();
        format!("{ways} back {} at {},{}", row.node.back_path, row.node.x_cor, row.node.y_cor)
    };
    assert_eq!(row(1), "vxv. back S at 0,400");
    assert_eq!(row(2), "vov. back S at 0,1200");
    assert_eq!(row(3), ".vov back W at 1200,2000");
    assert_eq!(row(4), "v.xv back N at 2400,400");
    assert_eq!(row(5), "ov.v back E at 1600,400");
    assert_eq!(row(6), "ov.x back E at 800,400");
    assert_eq!(trace.row(Moment::after(13), 7), None);
    let unvisited: Vec<_> =
        trace.unvisited(Moment::after(13), 1).map(|(m, w)| (m, w.only().unwrap())).collect();
    use Heading::{East as E, North as N, South as S};
    assert_eq!(unvisited, [(2, E), (3, S), (5, N), (6, N)]);
}
