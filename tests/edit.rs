//! Edits and their history: whatever was done can be taken back, and done again.
#![allow(clippy::unwrap_used, missing_docs)]

mod random;

use line_maze_lab::geometry::{Heading, Point};
use line_maze_lab::maze::edit::{Edit, History, stroke, walls};
use line_maze_lab::maze::{About, Bounds, Kind, Maze, Scale, Start};
use proptest::prelude::*;

fn point() -> impl Strategy<Value = Point> {
    (-3..12_i32, -3..12_i32).prop_map(|(x, y)| Point::new(x, y))
}

fn edit() -> impl Strategy<Value = Edit> {
    let cells = || (point(), point()).prop_map(|(from, to)| stroke(from, to));
    prop_oneof![
        6 => cells().prop_map(Edit::Draw),
        3 => cells().prop_map(Edit::Erase),
        1 => prop::option::of((point(), 0_u8..4)).prop_map(|start| {
            Edit::Start(start.map(|(at, index)| Start { at, heading: Heading::from_index(index) }))
        }),
        1 => prop::collection::vec(point(), 0..3).prop_map(Edit::Finish),
        1 => "[ab]?".prop_map(|title| Edit::About(About { title, ..About::default() })),
        1 => (1_u32..3).prop_map(|cell| Edit::Scale(Scale::new(f64::from(cell) * 100.0, 20.0).unwrap())),
        1 => any::<bool>().prop_map(|wall| Edit::Kind(if wall { Kind::Wall } else { Kind::Line })),
        1 => (0..3_i32, 3..9_i32).prop_map(|(sw, ne)| {
            Edit::Bounds(Bounds::new(Point::new(sw, sw), Point::new(ne, ne)).unwrap())
        }),
        1 => random::maze(5).prop_map(|maze| Edit::Replace(Box::new(maze))),
    ]
}

proptest! {
    #[test]
    fn undoing_all_gives_the_first_maze_and_redoing_all_the_last(
        first in random::maze(5),
        edits in prop::collection::vec(edit(), 0..20),
    ) {
        let mut history = History::new(first.clone());
        let mut mazes = vec![first];
        for edit in edits {
            let before = history.maze().clone();
            let changed = history.apply(edit);
            prop_assert_eq!(changed, before != *history.maze(), "an edit is kept if it changed something");
            if changed {
                mazes.push(history.maze().clone());
                prop_assert!(!history.can_redo());
            }
        }
        let mut labels = Vec::new();
        for maze in mazes.iter().rev().skip(1) {
            labels.push(history.undo_label());
            prop_assert!(history.undo());
            prop_assert_eq!(history.redo_label(), labels.last().unwrap().clone());
            prop_assert_eq!(history.maze(), maze);
        }
        prop_assert!(!history.can_undo() && !history.undo() && history.undo_label().is_none());
        for maze in mazes.iter().skip(1) {
            prop_assert!(history.redo());
            prop_assert_eq!(history.undo_label(), labels.pop().unwrap());
            prop_assert_eq!(history.maze(), maze);
        }
        prop_assert!(!history.can_redo() && !history.redo() && history.redo_label().is_none());
    }

    #[test]
    fn a_stroke_goes_from_point_to_point_with_one_corner(from in point(), to in point()) {
        let cells = stroke(from, to);
        prop_assert_eq!(cells.len() as u32, from.distance(to));
        let mut at = from;
        for &(cell, heading) in &cells {
            prop_assert_eq!(cell, at);
            at = at.step(heading);
        }
        prop_assert_eq!(at, to);
        prop_assert!(cells.windows(2).filter(|pair| pair[0].1 != pair[1].1).count() <= 1);
    }
}

#[test]
fn a_new_edit_takes_the_place_of_what_was_undone() {
    let mut history = History::new(Maze::new(Bounds::new(Point::new(0, 0), Point::new(3, 3)).unwrap()));
    let line = |x| Edit::Draw(stroke(Point::new(x, 0), Point::new(x, 2)));
    assert!(history.apply(line(0)) && history.apply(line(1)) && history.undo());
    assert!(!history.apply(line(0)), "nothing new");
    assert!(history.can_redo(), "so the undone line can still come back");
    assert!(history.apply(line(2)));
    assert!(!history.can_redo());
    assert_eq!(history.maze().cells(), 4);
}

#[test]
fn labels_say_what_is_undone() {
    let bounds = Bounds::new(Point::new(0, 0), Point::new(3, 3)).unwrap();
    let mut history = History::new(Maze::new(bounds));
    let start = |x, heading| Edit::Start(Some(Start { at: Point::new(x, 0), heading }));
    let steps = [
        (Edit::Draw(stroke(Point::new(0, 0), Point::new(9, 0))), "draw 3 cells"),
        (Edit::Erase(stroke(Point::new(1, 0), Point::new(0, 0))), "erase 1 cell"),
        (start(1, Heading::East), "set the start"),
        (start(1, Heading::North), "turn the start"),
        (start(2, Heading::North), "move the start"),
        (Edit::Start(None), "remove the start"),
        (Edit::Finish(vec![Point::new(3, 0), Point::new(3, 0)]), "set the finish"),
        (Edit::Finish(vec![Point::new(3, 0), Point::new(2, 0)]), "add a finish point"),
        (Edit::Finish(vec![Point::new(3, 3), Point::new(2, 0)]), "move the finish"),
        (Edit::Finish(vec![Point::new(3, 3)]), "remove a finish point"),
        (Edit::Finish(vec![]), "remove the finish"),
        (Edit::About(About { title: "Hook".into(), ..About::default() }), "change the title"),
        (
            Edit::About(About { note: "Short".into(), source: "Me".into(), ..About::default() }),
            "change the description",
        ),
        (Edit::Scale(Scale::new(180.0, 19.0).unwrap()), "change the sizes"),
        (Edit::Kind(Kind::Wall), "draw it as walls"),
        (Edit::Bounds(Bounds::default()), "change the lattice"),
        (Edit::Replace(Box::new(Maze::new(bounds))), "replace the maze"),
    ];
    for (edit, label) in steps {
        assert!(!history.apply(Edit::Erase(vec![])) && !history.apply(start(9, Heading::North)));
        assert!(history.apply(edit.clone()), "{label}");
        assert_eq!(history.undo_label().as_deref(), Some(label));
        assert!(!history.apply(edit), "{label} once more changes nothing");
    }
}

#[test]
fn walls_are_built_and_opened_between_posts() {
    let bounds = Bounds::new(Point::new(0, 0), Point::new(2, 2)).unwrap();
    let mut maze = Maze::new(bounds);
    maze.kind = Kind::Wall;
    let mut history = History::new(maze);
    // Around the middle square, from its south-west corner and back.
    let corners = [(1, 1), (2, 1), (2, 2), (1, 2), (1, 1)].map(|(x, y)| Point::new(x, y));
    let ways = |history: &History| history.maze().ways(Point::new(1, 1)).count();
    for (nth, pair) in corners.windows(2).enumerate() {
        assert!(history.apply(walls::open(pair[0], pair[1])));
        assert_eq!(ways(&history), nth as u32 + 1);
        assert_eq!(history.undo_label().as_deref(), Some("open 1 wall"));
    }
    assert!(history.apply(walls::build(corners[0], corners[2])));
    assert_eq!(history.undo_label().as_deref(), Some("build 2 walls"));
    let left = history.maze().ways(Point::new(1, 1));
    assert!(left.has(Heading::North) && left.has(Heading::West) && left.count() == 2);
    let outer = walls::open(Point::new(0, 0), Point::new(3, 0));
    assert!(!history.apply(outer), "the outer wall stays");
    let toggle = walls::toggle(history.maze(), Point::new(1, 1), Heading::North).unwrap();
    assert!(history.apply(toggle) && ways(&history) == 1);
    let toggle = walls::toggle(history.maze(), Point::new(1, 2), Heading::South).unwrap();
    assert!(history.apply(toggle) && ways(&history) == 2);
    assert_eq!(walls::toggle(history.maze(), Point::new(3, 1), Heading::West), None, "off the lattice");
}
