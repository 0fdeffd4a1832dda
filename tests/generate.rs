//! Generated mazes: the same everywhere, sound, and as the recipe says.
#![allow(clippy::unwrap_used, missing_docs)]

use expect_test::expect_file;
use line_maze_lab::geometry::Point;
use line_maze_lab::maze::generate::{Recipe, RecipeError, generate};
use line_maze_lab::maze::{Kind, Maze, checks, text};
use line_maze_lab::route::best;
use line_maze_lab::settings::Pace;
use proptest::prelude::*;

fn dead_ends(maze: &Maze) -> usize {
    let marked = |at: Point| maze.is_finish(at) || maze.start().unwrap().at == at;
    maze.joined_points().filter(|&(at, ways)| ways.count() == 1 && !marked(at)).count()
}

proptest! {
    #[test]
    fn every_recipe_gives_a_sound_maze(
        width in 1_u32..30,
        height in 1_u32..30,
        loops_percent in 0_u8..=100,
        dead_ends_cut_percent in 0_u8..=100,
        seed in any::<u64>(),
    ) {
        prop_assume!(width * height > 1);
        let recipe = Recipe { width, height, loops_percent, dead_ends_cut_percent, seed, kind: Kind::Wall };
        let maze = generate(&recipe).unwrap();
        prop_assert_eq!(checks::check(&maze), []);
        prop_assert_eq!((maze.bounds().width(), maze.bounds().height(), maze.kind), (width, height, Kind::Wall));
        prop_assert_eq!(&generate(&recipe).unwrap(), &maze);
        if dead_ends_cut_percent == 0 {
            prop_assert_eq!(maze.joined_points().count() as u32, width * height);
        }
        if loops_percent == 0 {
            prop_assert_eq!(maze.loops(), 0);
        }
        if dead_ends_cut_percent == 100 {
            prop_assert_eq!(dead_ends(&maze), 0);
        }
    }
}

#[test]
fn this_maze_comes_from_this_seed_on_every_machine() {
    // The browser's tests compare with the same file.
    let maze = generate(&Recipe { seed: 1924, ..Recipe::default() }).unwrap();
    expect_file!["fixtures/generated-1924.maze"].assert_eq(&text::write_drawing(&maze));
}

#[test]
fn shares_do_what_they_say() {
    let recipe = Recipe {
        width: 30,
        height: 20,
        loops_percent: 0,
        dead_ends_cut_percent: 0,
        seed: 7,
        kind: Kind::Line,
    };
    let tree = generate(&recipe).unwrap();
    // 30 × 20 points: 1,150 links, of which the tree takes 599 and one is kept off the start.
    let half = generate(&Recipe { loops_percent: 50, ..recipe }).unwrap();
    assert_eq!(half.loops(), 275);
    assert_eq!(generate(&Recipe { loops_percent: 100, ..recipe }).unwrap().loops(), 550);
    let cut = generate(&Recipe { dead_ends_cut_percent: 50, ..recipe }).unwrap();
    assert!(dead_ends(&tree) > 60, "a tree with branches: {}", dead_ends(&tree));
    assert!(dead_ends(&cut).abs_diff(dead_ends(&tree) / 2) <= 1);
    let far = best::shortest(&tree, tree.start().unwrap(), &Pace::default()).unwrap().cells;
    assert!(far > 50, "the finish is {far} cells away");
}

#[test]
fn what_cannot_be_made_is_said() {
    let fails = |recipe| generate(&recipe).unwrap_err();
    let recipe = Recipe::default();
    assert_eq!(fails(Recipe { width: 1, height: 1, ..recipe }), RecipeError::TooSmall);
    assert_eq!(fails(Recipe { width: 0, ..recipe }), RecipeError::TooSmall);
    assert_eq!(fails(Recipe { height: 1001, ..recipe }), RecipeError::TooLarge);
    assert_eq!(fails(Recipe { loops_percent: 101, ..recipe }), RecipeError::Loops);
    assert_eq!(fails(Recipe { dead_ends_cut_percent: 101, ..recipe }), RecipeError::DeadEnds);
}

#[test]
fn the_largest_maze_is_made_checked_written_and_read_in_a_moment() {
    let began = std::time::Instant::now();
    let maze = generate(&Recipe { width: 1000, height: 1000, ..Recipe::default() }).unwrap();
    let made = began.elapsed();
    assert!(checks::check(&maze).is_empty());
    let checked = began.elapsed();
    let written = text::write(&maze);
    assert!(written.len() < text::MAX_BYTES);
    let wrote = began.elapsed();
    assert_eq!(text::parse(&written).unwrap(), maze);
    let read = began.elapsed();
    let json = line_maze_lab::maze::json::write(&maze);
    assert!(line_maze_lab::maze::json::parse(&json).unwrap() == maze);
    println!(
        "made {made:?}, checked {checked:?}, written {wrote:?} ({} bytes), read {read:?}, JSON {:?} ({} bytes)",
        written.len(),
        began.elapsed(),
        json.len()
    );
    assert!(began.elapsed().as_secs() < 20, "even on a slow machine");
}
