//! Entering a recording anywhere.

use line_maze_lab::event::Outcome;
use line_maze_lab::explorer::name::Name;
use line_maze_lab::geometry::{Heading, Point};
use line_maze_lab::maze::generate::{Recipe, generate};
use line_maze_lab::maze::{Bounds, Kind, Maze, Start, samples};
use line_maze_lab::recording::{Cursor, Recording};
use line_maze_lab::run::{AnyRun, explore, record};
use line_maze_lab::settings::Settings;
use proptest::prelude::*;

use crate::support::random::recipes;

/// What can be told of a stop.
fn told(run: &Recording, cursor: &mut Cursor, stop: u32) -> String {
    let stop = cursor.seek(run, stop).clone();
    format!("{stop:?} {:?}", run.narrate(&stop))
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(64))]

    #[test]
    fn a_jump_shows_what_stepping_shows(recipe in recipes(9), pick in any::<prop::sample::Index>(), jumps in prop::collection::vec(any::<prop::sample::Index>(), 8)) {
        let name = Name::ALL[1..][pick.index(Name::ALL.len() - 1)];
        let AnyRun::Other(run) = record(&recipe.maze(), &Settings::default(), name).unwrap() else {
            unreachable!()
        };
        let stops = run.stops() + 1;
        let mut stepper = Cursor::default();
        let stepped: Vec<String> = (0..stops).map(|stop| told(&run, &mut stepper, stop)).collect();
        let mut jumper = Cursor::default();
        for stop in jumps.iter().map(|jump| jump.index(stops as usize)).chain((0..stops as usize).rev().take(20)) {
            prop_assert_eq!(&told(&run, &mut jumper, stop as u32), &stepped[stop]);
        }
    }
}

#[test]
fn a_jump_in_a_long_run_shows_what_stepping_shows() {
    let recipe =
        Recipe { width: 60, height: 60, loops_percent: 5, dead_ends_cut_percent: 0, ..Recipe::default() };
    let mut maze = generate(&recipe).unwrap();
    for &name in &Name::ALL[1..] {
        // Flood fill needs a finish; all others drive longer without.
        maze.set_finish(if name == Name::FloodFill { vec![maze.bounds().ne()] } else { vec![] });
        let AnyRun::Other(run) = record(&maze, &Settings::default(), name).unwrap() else { unreachable!() };
        let words = |cursor: &mut Cursor, stop| {
            let here = cursor.seek(&run, stop).clone();
            (here.said, here.decision, here.mind.robot().peak_bytes(), run.narrate(&here))
        };
        let (mut stepper, mut jumper) = (Cursor::default(), Cursor::default());
        let stepped: Vec<_> = (0..=run.stops()).map(|stop| words(&mut stepper, stop)).collect();
        for jump in (0..=run.stops()).rev().step_by(97) {
            assert_eq!(words(&mut jumper, jump), stepped[jump as usize], "{name}, stop {jump}");
        }
        assert_eq!(run.last().robot().peak_bytes(), stepped.last().unwrap().2);
    }
}

#[test]
fn every_case_is_told_in_whole_sentences() {
    for &name in &Name::ALL[1..] {
        let about = name.about();
        assert!(!about.listing.is_empty() && !about.cannot.is_empty() && !about.idea.is_empty(), "{name}");
        for case in about.cases {
            for (mark, why) in [('*', "strong"), ('`', "code")] {
                assert!(case.told.matches(mark).count() % 2 == 0, "{name}, {}: {why}", case.name);
            }
            assert_eq!(case.told.matches('{').count(), case.told.matches('}').count(), "{name}");
            assert!(case.told.ends_with('.'), "{name}, {}", case.name);
        }
        for line in about.listing {
            assert!(line.len() <= 100, "{name}: {line}");
        }
    }
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(100))]

    #[test]
    fn sentences_have_no_holes(recipe in recipes(6)) {
        for &name in &Name::ALL[1..] {
            let AnyRun::Other(run) = record(&recipe.maze(), &Settings::default(), name).unwrap() else {
                unreachable!()
            };
            let mut cursor = Cursor::default();
            for stop in 0..=run.stops() {
                let here = cursor.seek(&run, stop).clone();
                prop_assert!(!here.said.lines().is_empty());
                prop_assert_eq!(here.said.lines().len(), usize::from(run.step(stop).lines()));
                let told = run.narrate(&here);
                for text in [told.text(), told.short_text()] {
                    prop_assert!(text.ends_with('.'), "{}: {}", name, text);
                    let hole = ["{", "}", "*", "`", "  ", " ,", " .", ": ,"].iter().any(|hole| text.contains(hole));
                    prop_assert!(!hole, "{}: {}", name, text);
                }
                prop_assert!(told.text().split_whitespace().count() <= 60, "{}: {}", name, told.text());
            }
        }
    }
}

/// What the referee sees has its own word: the case of the last stop is not why the run is over.
#[test]
fn a_run_that_circles_is_called_that() {
    let maze = samples::figure_3_1();
    let mut circled = 0;
    for &name in &Name::ALL[1..] {
        let run = crate::hands::recording(&maze, name);
        if let Outcome::Circling { .. } = run.outcome() {
            let told = run.narrate(&run.at(run.stops()));
            assert_eq!(told.case, "circling", "{name}");
            circled += 1;
        }
    }
    assert!(circled > 2);
}

#[test]
fn who_cannot_start_between_walls_is_told_of_walls() {
    let mut maze = Maze::new(Bounds::new(Point::new(0, 0), Point::new(1, 1)).unwrap());
    maze.kind = Kind::Wall;
    maze.set_start(Some(Start { at: Point::new(0, 0), heading: Heading::North }));
    let why = |maze: &Maze| explore(maze, &Settings::default()).unwrap_err().to_string();
    assert!(why(&maze).contains("walls all round: open one side"), "{}", why(&maze));
    assert!(maze.draw(Point::new(0, 0), Heading::North) && maze.draw(Point::new(0, 0), Heading::East));
    assert!(why(&maze).ends_with("a square with one opening, or choose another explorer."), "{}", why(&maze));
    maze.kind = Kind::Line;
    assert!(why(&maze).ends_with("at the end of a line, or choose another explorer."), "{}", why(&maze));
}
