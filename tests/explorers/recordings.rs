//! Entering a recording anywhere.

use line_maze_lab::explorer::name::Name;
use line_maze_lab::recording::{Cursor, Recording};
use line_maze_lab::run::{AnyRun, record};
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
