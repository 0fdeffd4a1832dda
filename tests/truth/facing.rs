//! The bot is drawn as its memory has it: a settled stop shows where it goes on to, a line what the lines so far
//! have set, in the stepper and in the comparison.

use line_maze_lab::compare::abreast::{self, Clock};
use line_maze_lab::event::Decision;
use line_maze_lab::explorer::mind::Mind;
use line_maze_lab::explorer::name::Name;
use line_maze_lab::geometry::{Heading, Turn};
use line_maze_lab::ink::Ink;
use line_maze_lab::maze::{Maze, samples::SAMPLES};
use line_maze_lab::playback::Timeline;
use line_maze_lab::run::{AnyRun, record};
use line_maze_lab::scene::{self, Shown, recorded};
use line_maze_lab::settings::Settings;
use line_maze_lab::trace::Moment;
use proptest::prelude::*;

use crate::support::figure_3_1;
use crate::support::random::recipes;

/// The heading that degrees clockwise from north are.
fn heading(degrees: f64) -> Heading {
    assert_eq!(degrees % 90.0, 0.0, "a settled bot faces along the lattice: {degrees}");
    Heading::from_index((degrees / 90.0).rem_euclid(4.0) as u8)
}

/// Every moment of a run of the book's, and of the drive from each stop to the next.
fn the_book_s_faces_bot_dir(maze: &Maze) {
    let settings = Settings::default();
    let Ok(AnyRun::Book(run)) = record(maze, &settings, Name::Book) else { return };
    let (trace, north) = (run.trace(), maze.start().unwrap().heading);
    let ink = Ink::of(maze, trace, run.cell_ms());
    for stop in 0..=trace.stops() {
        for lines in 0..=trace.lines(stop) {
            let moment = Moment { stop, lines };
            let state = trace.frame(moment).state.bot_dir.out_of_frame_of(north);
            let pose = scene::pose(trace, &ink, Shown::settled(moment));
            assert_eq!(heading(pose.degrees), state, "stop {stop}, {lines} lines");
            // The drive to this moment ends as the moment is drawn.
            if stop > 0 && lines > 0 {
                let before = Moment::after(stop - 1);
                let end = scene::pose(trace, &ink, Shown { moment: before, along: 1.0, bound: moment });
                let settled = scene::pose(trace, &ink, Shown::settled(moment));
                assert_eq!((end.x, end.y), (settled.x, settled.y), "stop {stop}");
                assert_eq!(heading(end.degrees), state, "the end of the drive to stop {stop}");
            }
        }
    }
}

/// Every stop of a run of another explorer's, against what its mind decided.
fn another_s_faces_its_way(maze: &Maze, name: Name) {
    let settings = Settings::default();
    let Ok(AnyRun::Other(run)) = record(maze, &settings, name) else { return };
    for stop in 0..=run.stops() {
        let (step, at) = (run.step(stop), run.at(stop));
        let settled = |lines| heading(recorded::pose(&run, Shown::settled(Moment { stop, lines })).degrees);
        let faces = settled(u8::MAX);
        match at.decision {
            Decision::Go(turn) => assert_eq!(faces, step.heading().turned(turn), "{name}, stop {stop}"),
            // The referee may have ended what the mind would have gone on with.
            Decision::End(_) => assert!(stop == run.stops(), "{name}, stop {stop}"),
        }
        if let Mind::Cornell(mind) = &at.mind {
            assert_eq!(faces, mind.orientation(), "{name} says how it faces at stop {stop}");
        }
        if stop > 0 {
            assert_eq!(settled(1), step.heading(), "{name} has not turned before the lines ran, stop {stop}");
            let before = Moment::after(stop - 1);
            let end = recorded::pose(&run, Shown { moment: before, along: 1.0, bound: Moment::after(stop) });
            assert_eq!(heading(end.degrees), faces, "{name}, the end of the drive to stop {stop}");
        }
    }
}

/// Every stop in the comparison, by either clock.
fn abreast_it_faces_the_same(maze: &Maze, name: Name) {
    let settings = Settings::default();
    let (Ok(run), Some(start)) = (record(maze, &settings, name), maze.start()) else { return };
    for stop in 0..=run.stops() {
        let faces = match &run {
            AnyRun::Book(run) => run.trace().state(stop).bot_dir.out_of_frame_of(start.heading),
            AnyRun::Other(run) => recorded::faces(run, Moment::after(stop)),
        };
        for clock in [Clock::Cells(0.0), Clock::Seconds(0.0)] {
            let settled = clock.at_stop(maze, &run, &settings.pace, stop);
            let at = abreast::at(maze, &run, &settings.pace, settled).unwrap();
            assert_eq!(at.stop, stop, "{name}");
            let degrees = (at.pose.degrees * 1e6).round() / 1e6;
            assert_eq!(heading(degrees), faces, "{name}, stop {stop} by {clock:?}");
        }
    }
}

fn all(maze: &Maze) {
    the_book_s_faces_bot_dir(maze);
    for &name in Name::ALL {
        another_s_faces_its_way(maze, name);
        abreast_it_faces_the_same(maze, name);
    }
}

#[test]
fn figure_3_1_is_drawn_as_it_is_told() {
    let maze = figure_3_1();
    all(&maze);
    let Ok(AnyRun::Book(run)) = record(&maze, &Settings::default(), Name::Book) else { panic!() };
    let ink = Ink::of(&maze, run.trace(), run.cell_ms());
    let faces = |stop| heading(scene::pose(run.trace(), &ink, Shown::settled(Moment::after(stop))).degrees);
    // The spec's column “leaves”.
    let leaves = [0, 0, 1, 1, 2, 2, 1, 3, 0, 3, 3, 3, 1, 0, 3, 1, 2, 1, 0, 2, 1, 0, 3, 2];
    for (stop, leaves) in (1u32..).zip(leaves) {
        assert_eq!(faces(stop).index(), leaves, "stop {stop}");
    }
    assert_eq!(faces(25), Heading::South, "it came to the finish southwards and stays");
}

#[test]
fn every_sample_is_drawn_as_it_is_told() {
    for sample in SAMPLES {
        all(&sample.maze());
    }
}

#[test]
fn a_step_abreast_ends_with_the_turn_made() {
    let (maze, settings) = (figure_3_1(), Settings::default());
    let run = record(&maze, &settings, Name::Book).unwrap();
    // To stop 3, a corner: 5 cells of 0.4 s, then the turn of 0.4 s.
    let Some(Clock::Seconds(at)) = abreast::next(&maze, [&run], &settings.pace, Clock::Seconds(1.9)) else {
        panic!("there are stops after 1.9 s")
    };
    assert!((at - 2.4).abs() < 1e-9, "{at}");
    let while_turning = abreast::at(&maze, &run, &settings.pace, Clock::Seconds(2.2)).unwrap();
    assert!((while_turning.pose.degrees - 45.0).abs() < 1e-6);
    let back = abreast::before(&maze, [&run], &settings.pace, Clock::Seconds(2.4)).unwrap();
    assert!((back.value() - 1.2).abs() < 1e-9, "{back:?}");
}

#[test]
fn turning_is_at_the_end_of_a_drive() {
    let maze = figure_3_1();
    let Ok(AnyRun::Book(run)) = record(&maze, &Settings::default(), Name::Book) else { panic!() };
    let ink = Ink::of(&maze, run.trace(), run.cell_ms());
    let towards = |bound, along| {
        let pose = scene::pose(run.trace(), &ink, Shown { moment: Moment::after(2), along, bound });
        (pose.y, pose.degrees)
    };
    // From 0,3 north to the corner 0,5, where it turns to the east.
    let whole = Moment::after(3);
    assert_eq!(towards(whole, 0.0), (3.0, 0.0));
    assert_eq!(towards(whole, 0.375), (4.0, 0.0));
    assert_eq!(towards(whole, 0.75), (5.0, 0.0));
    assert_eq!(towards(whole, 0.875), (5.0, 45.0));
    assert_eq!(towards(whole, 1.0), (5.0, 90.0));
    // Line by line it comes as it drove: line 5 turns it.
    assert_eq!(towards(Moment { stop: 3, lines: 1 }, 1.0), (5.0, 0.0));
    assert_eq!(run.trace().frame(Moment::after(3)).turn, Some(Turn::Right));
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 100, failure_persistence: None, ..ProptestConfig::default() })]

    #[test]
    fn random_mazes_are_drawn_as_they_are_told(recipe in recipes(6)) {
        all(&recipe.maze());
    }
}
