//! What a person types in any terminal.

use line_maze_lab::link::demo::DemoRobot;
use proptest::prelude::*;

use crate::support::figure_3_1;

/// A robot that is on, and says nothing unasked.
fn robot() -> DemoRobot {
    let mut robot = DemoRobot::new(&figure_3_1(), 0).unwrap();
    robot.wake(0);
    robot
}

/// What it says within a second, without checksums.
fn said(robot: &mut DemoRobot, from_ms: u64) -> Vec<String> {
    let bytes: Vec<u8> = (0..100).flat_map(|tick| robot.tick(from_ms + 10 * tick)).collect();
    String::from_utf8(bytes).unwrap().lines().map(|line| line.split('*').next().unwrap().into()).collect()
}

#[test]
fn hi_is_answered_whatever_ends_the_line() {
    for end in ["\n", "\r", "\r\n", "\n\r", "\r\r\n"] {
        let mut robot = robot();
        robot.bytes_in(format!("hi{end}").as_bytes(), 10);
        assert_eq!(said(&mut robot, 20), ["ready 1 lab-1 demo 50 451", "ok #-"], "{end:?}");
    }
}

#[test]
fn an_lf_that_comes_late_belongs_to_its_cr() {
    let mut robot = robot();
    robot.bytes_in(b"hi\r", 10);
    assert_eq!(said(&mut robot, 20).len(), 2);
    robot.bytes_in(b"\nhi\r", 2_000);
    assert_eq!(said(&mut robot, 2_010), ["ready 1 lab-1 demo 50 451", "ok #-"]);
}

#[test]
fn help_tells_what_may_be_typed() {
    let mut robot = robot();
    robot.bytes_in(b"help\r", 10);
    let typed = "ok #- type hi, stop, get NAME, watch LEVEL, place, turns read, nodes read";
    assert_eq!(said(&mut robot, 20), [typed]);
}

proptest! {
    /// However it is typed and cut into pieces: each `hi` once.
    #[test]
    fn every_hi_is_answered_once(
        ends in proptest::collection::vec(proptest::sample::select(vec!["\n", "\r", "\r\n", "\r\n\r\n"]), 1..5),
        cut in 1usize..5,
    ) {
        let mut robot = robot();
        let typed: String = ends.iter().map(|end| format!("hi{end}")).collect();
        let mut heard = Vec::new();
        for (piece, ms) in typed.as_bytes().chunks(cut).zip((100..).step_by(1_000)) {
            robot.bytes_in(piece, ms);
            heard.extend(said(&mut robot, ms));
        }
        prop_assert_eq!(heard.iter().filter(|line| *line == "ok #-").count(), ends.len());
        prop_assert_eq!(heard.len(), 2 * ends.len());
    }
}
