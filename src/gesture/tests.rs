use super::*;
use crate::maze::edit::History;
use crate::maze::{Maze, text};

const HANDLE: Handle = Handle { arm: 0.5, reach: 0.25 };

fn maze(drawing: &str) -> Maze {
    match text::parse(&alloc::format!("line-maze: 1\n{drawing}")) {
        Ok(maze) => maze,
        Err(why) => panic!("{why}"),
    }
}

fn at(x: f64, y: f64) -> Spot {
    Spot { place: (x, y), pixel: (x * 40.0, -y * 40.0) }
}

fn press(id: i32, button: Button, tool: Tool, x: f64, y: f64) -> Press {
    Press { id, button, spot: at(x, y), tool, finishing: Finishing::Only, handle: HANDLE }
}

/// Presses, moves along the places, lets go; returns the maze after it.
fn drawn(maze: &Maze, first: &Press, places: &[(f64, f64)]) -> Maze {
    let mut hand = Hand::default();
    hand.press(maze, first);
    for &(x, y) in places {
        assert_eq!(hand.drag(maze, first.id, at(x, y)), Motion::Still);
    }
    let mut history = History::new(maze.clone());
    if let Some(edit) = hand.release(first.id) {
        history.apply(edit);
    }
    assert_eq!(*hand.doing(), Doing::Nothing);
    history.maze().clone()
}

const FORK: &str = "\n.   +   .\n    |\n+---+---F\n    |\n.   ^   .\n";

#[test]
fn dragging_draws_and_dragging_back_takes_back() {
    let maze = maze("\n.   .   .   .\n\n.   .   .   .\n");
    let line = press(1, Button::Main, Tool::Line, 0.1, 0.2);
    assert_eq!(drawn(&maze, &line, &[(1.0, 0.0), (2.9, 0.1), (3.0, 0.9)]).cells(), 4);
    assert_eq!(drawn(&maze, &line, &[(3.0, 0.0), (1.1, 0.1)]).cells(), 1);
    assert_eq!(drawn(&maze, &line, &[(0.5, 0.5)]).cells(), 0);
    // Beyond the edge the nearest point counts.
    assert_eq!(drawn(&maze, &line, &[(9.0, -4.0)]).cells(), 3);
}

#[test]
fn the_eraser_takes_what_it_passes_and_spares_what_it_crosses() {
    let maze = maze(FORK);
    let along = press(1, Button::Main, Tool::Erase, 0.2, 1.05);
    let erased = drawn(&maze, &along, &[(1.9, 1.05)]);
    assert_eq!((erased.cells(), erased.has_line(Point::new(1, 0), Heading::North)), (2, true));
    let tap = press(1, Button::Second, Tool::Line, 1.3, 0.6);
    assert!(!drawn(&maze, &tap, &[]).has_line(Point::new(1, 0), Heading::North));
    let beside = press(1, Button::Main, Tool::Erase, 0.5, 0.3);
    assert_eq!(drawn(&maze, &beside, &[]).cells(), 4);
}

/// Four squares in a block, all closed.
const SQUARES: &str = "kind: wall\n\n.   .\n\n.   .\n";

#[test]
fn walls_are_opened_where_an_eraser_passes_and_built_from_post_to_post() {
    let closed = maze(SQUARES);
    let open = press(1, Button::Second, Tool::Line, 0.5, 0.1);
    // Down the wall in the middle; the post and the outer wall stay.
    let halves = drawn(&closed, &open, &[(0.5, 0.9), (0.5, 1.6)]);
    assert_eq!(halves.cells(), 2);
    assert!(halves.has_line(Point::new(0, 1), Heading::East));
    let all = drawn(&halves, &press(1, Button::Main, Tool::Erase, -0.2, 0.5), &[(1.2, 0.5)]);
    assert_eq!(all.cells(), 4);
    let build = press(1, Button::Finger, Tool::Line, 0.5, -0.4);
    assert_eq!(drawn(&all, &build, &[(0.5, 0.5)]).cells(), 3);
    assert_eq!(drawn(&all, &build, &[(0.5, 0.6), (1.4, 0.5)]).cells(), 2);
    // Back to the first post, and nothing is built; beyond the outer wall its posts count.
    assert_eq!(drawn(&all, &build, &[(0.5, 0.6), (0.5, -0.4)]).cells(), 4);
    assert_eq!(drawn(&all, &build, &[(0.5, 7.0)]).cells(), 2);
}

#[test]
fn a_press_on_a_wall_toggles_it() {
    let closed = maze(SQUARES);
    let tap = |x, y| press(1, Button::Main, Tool::Line, x, y);
    let open = drawn(&closed, &tap(0.45, 0.1), &[]);
    assert!(open.has_line(Point::new(0, 0), Heading::East));
    assert_eq!(drawn(&open, &tap(0.6, -0.1), &[]).cells(), 0);
    // Nothing at a post, in the middle of a square, and at the outer wall.
    for (x, y) in [(0.5, 0.5), (0.0, 0.05), (-0.5, 0.0)] {
        assert_eq!(drawn(&closed, &tap(x, y), &[]).cells(), 0, "{x}, {y}");
    }
}

#[test]
fn a_start_on_a_lines_end_faces_along_it_and_its_handle_turns_it() {
    let maze = maze(FORK);
    let put = press(1, Button::Main, Tool::Start, 0.0, 1.0);
    let start = Start { at: Point::new(0, 1), heading: Heading::East };
    assert_eq!(drawn(&maze, &put, &[]).start(), Some(start));
    assert_eq!(
        drawn(&maze, &put, &[(1.0, 2.1)]).start(),
        Some(Start { at: Point::new(1, 2), heading: Heading::South })
    );
    // The handle is half a cell north of the start; any tool takes it.
    let turn = press(1, Button::Main, Tool::Line, 1.0, 0.55);
    assert_eq!(drawn(&maze, &turn, &[(2.0, 0.2)]).start().map(|start| start.heading), Some(Heading::East));
}

#[test]
fn finish_points_move_and_further_ones_come_and_go() {
    let maze = maze(FORK);
    let points = |maze: &Maze| maze.finish().to_vec();
    let moved = press(1, Button::Main, Tool::Finish, 1.0, 2.0);
    assert_eq!(points(&drawn(&maze, &moved, &[])), [Point::new(1, 2)]);
    let further = Press { finishing: Finishing::Further, ..moved };
    let two = drawn(&maze, &further, &[]);
    assert_eq!(points(&two).len(), 2);
    assert_eq!(points(&drawn(&two, &further, &[])), [Point::new(2, 1)]);
    // One of several is moved alone.
    assert_eq!(points(&drawn(&two, &moved, &[(0.0, 2.0)])), [Point::new(0, 2), Point::new(2, 1)]);
}

#[test]
fn a_second_finger_lets_the_first_ones_line_go_and_both_zoom() {
    let maze = maze("\n.   .   .\n");
    let mut hand = Hand::default();
    hand.press(&maze, &press(1, Button::Finger, Tool::Line, 0.0, 0.0));
    hand.drag(&maze, 1, at(1.0, 0.0));
    hand.press(&maze, &press(2, Button::Finger, Tool::Line, 2.0, 0.0));
    assert_eq!(*hand.doing(), Doing::Pinch);
    let Motion::Zoom { by, factor, about } = hand.drag(&maze, 2, at(3.0, 0.0)) else {
        panic!("two fingers zoom")
    };
    assert_eq!((by, about), ((20.0, 0.0), (80.0, 0.0)));
    assert!((1.9..2.0).contains(&factor));
    assert_eq!((hand.release(1), hand.doing()), (None, &Doing::LetGo));
    assert_eq!(hand.drag(&maze, 2, at(0.0, 0.0)), Motion::Still);
    assert_eq!((hand.release(2), hand.doing()), (None, &Doing::Nothing));
}

#[test]
fn letting_go_or_losing_the_pointer_keeps_nothing() {
    let maze = maze("\n.   .   .\n");
    let line = press(7, Button::Main, Tool::Line, 0.0, 0.0);
    let mut hand = Hand::default();
    hand.press(&maze, &line);
    hand.drag(&maze, 7, at(2.0, 0.0));
    assert!(hand.let_go());
    assert!(!hand.let_go());
    hand.drag(&maze, 7, at(1.0, 0.0));
    assert_eq!((hand.release(7), hand.doing()), (None, &Doing::Nothing));
    hand.press(&maze, &line);
    hand.lose(7);
    assert_eq!((hand.release(7), hand.doing()), (None, &Doing::Nothing));
}

#[test]
fn the_middle_button_moves_the_paper() {
    let maze = maze("\n.   .   .\n");
    let mut hand = Hand::default();
    hand.press(&maze, &press(1, Button::Middle, Tool::Line, 0.0, 0.0));
    assert_eq!(hand.drag(&maze, 1, at(1.0, 0.5)), Motion::Pan(40.0, -20.0));
    assert_eq!(hand.release(1), None);
}
