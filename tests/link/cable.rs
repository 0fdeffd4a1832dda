//! Cables that are pulled, robots that fall silent, resets in the middle of a run.

use line_maze_lab::event::{Cut, Outcome};
use line_maze_lab::link::live::Mind;
use line_maze_lab::link::page::{Action, Command, News, Placed, PortEvent, State, Trouble};
use line_maze_lab::link::plot::Showing;
use line_maze_lab::link::tune::Name;
use line_maze_lab::link::words::Source;

use crate::bench::{Bench, USB, mind};

#[test]
fn pulled_and_plugged_in_again() {
    let mut bench = Bench::ready();
    bench.explore();
    bench.wait(5_000);
    let lines = bench.link.monitor().total();
    bench.unplug();
    assert_eq!(bench.link.state(), State::Lost);
    let live = bench.link.live().unwrap();
    assert_eq!(live.end(), Some(Outcome::Cut(Cut::ConnectionLost)));
    assert!(live.stops() > 3);
    bench.wait(2_500);
    assert_eq!(bench.link.state(), State::Reconnecting);
    bench.plugged = true;
    bench.until(State::Ready);
    bench.wait(500);
    // The run is kept, the log too, and the robot has to be put back.
    assert_eq!(bench.link.live().unwrap().end(), Some(Outcome::Cut(Cut::ConnectionLost)));
    assert!(bench.link.monitor().total() > lines);
    assert_eq!(bench.link.snapshot().placed, Placed::Somewhere);
    assert!(bench.link.notes().any(|note| note.news == News::Reconnected));
    bench.command(Command::Explore(mind()));
    bench.wait(100);
    assert!(bench.tail().contains("put me back at the start"), "{}", bench.tail());
    bench.explore();
    bench.until(State::Ready);
    assert_eq!(bench.link.live().unwrap().end(), Some(Outcome::Finish));
}

#[test]
fn what_is_known_of_a_robot_ends_with_the_connection() {
    let mut bench = Bench::ready();
    bench.command(Command::Set(Name::Kp, 700));
    bench.wait(500);
    let plot = |bench: &Bench| bench.link.plot().showing(bench.now_ms);
    assert!(bench.link.is_open());
    assert_eq!((plot(&bench), bench.link.setting(Name::Kp)), (Showing::Live, Some(700)));
    bench.command(Command::Disconnect);
    assert!(!bench.link.is_open());
    assert_eq!((plot(&bench), bench.link.setting(Name::Kp)), (Showing::Over, None));
    assert!(bench.link.plot().newest().is_some());
    assert_eq!(bench.link.notes().count(), 0);
    // With the next one, everything begins anew.
    bench.command(Command::Use(USB));
    bench.until(State::Ready);
    assert_eq!(plot(&bench), Showing::Waiting);
    bench.wait(500);
    assert_eq!(plot(&bench), Showing::Live);
}

#[test]
fn who_disconnects_is_not_told_that_the_connection_was_lost() {
    let mut bench = Bench::ready();
    bench.explore();
    bench.wait(3_000);
    bench.command(Command::Disconnect);
    let live = bench.link.live().unwrap();
    let told = live.told(Source::Past);
    assert!(told.starts_with("The robot’s last run: "), "{told}");
    assert!(told.ends_with("then it was disconnected"), "{told}");
    let mut bench = Bench::ready();
    bench.explore();
    bench.wait(3_000);
    bench.unplug();
    bench.command(Command::Disconnect);
    let told = bench.link.live().unwrap().told(Source::Past);
    assert!(told.ends_with("connection lost"), "{told}");
}

#[test]
fn looked_for_each_second_for_half_a_minute() {
    let mut bench = Bench::ready();
    bench.unplug();
    let before = bench.actions.len();
    bench.wait(30_500);
    let looks = bench.actions[before..].iter().filter(|&action| *action == Action::Look).count();
    assert_eq!(looks, 30);
    bench.wait(1_000);
    assert_eq!(bench.link.state(), State::Failed(Trouble::Gone));
    // The browser's event alone is not taken as a robot.
    bench.port(PortEvent::Appeared);
    assert_eq!(bench.link.state(), State::Failed(Trouble::Gone));
}

#[test]
fn a_robot_that_stands_and_falls_silent_is_asked_and_given_up() {
    let mut bench = Bench::ready();
    bench.to_page = Box::new(|_| Vec::new());
    bench.wait(2_400);
    assert_eq!(bench.link.state(), State::Ready);
    bench.wait(2_000);
    assert_eq!(bench.link.state(), State::Failed(Trouble::Silent));
    assert_eq!(bench.actions.last(), Some(&Action::Close));
}

#[test]
fn a_short_silence_is_survived() {
    let mut bench = Bench::ready();
    bench.to_page = Box::new(|_| Vec::new());
    bench.wait(3_000);
    bench.to_page = Box::new(|bytes| bytes);
    bench.wait(2_000);
    assert_eq!(bench.link.state(), State::Ready);
}

#[test]
fn a_reset_in_the_middle_of_a_run_ends_it() {
    let mut bench = Bench::ready();
    bench.explore();
    bench.wait(5_000);
    bench.robot.reset(bench.now_ms);
    bench.wait(1_500);
    assert_eq!(bench.link.state(), State::Ready);
    assert_eq!(bench.link.live().unwrap().end(), Some(Outcome::Cut(Cut::ConnectionLost)));
    assert!(bench.link.notes().any(|note| note.news == News::Restarted));
    // It tells everything again, as it was told before.
    bench.wait(500);
    assert_eq!(bench.link.plot().showing(bench.now_ms), Showing::Live);
}

#[test]
fn a_reset_is_noticed_without_its_ready_line() {
    let mut bench = Bench::ready();
    bench.explore();
    bench.wait(5_000);
    bench.robot.reset(bench.now_ms);
    let mut swallowed = false;
    bench.to_page = Box::new(move |bytes| {
        if !swallowed && bytes.windows(5).any(|bytes| bytes == b"ready") {
            swallowed = true;
            return Vec::new();
        }
        bytes
    });
    bench.wait(3_500);
    assert!(bench.link.notes().any(|note| note.news == News::Restarted), "{}", bench.tail());
    assert_eq!(bench.link.state(), State::Ready);
}

#[test]
fn an_end_that_is_lost_comes_again() {
    let mut bench = Bench::ready();
    bench.explore();
    let mut lost = 0;
    bench.to_page = Box::new(move |mut bytes| {
        if let Some(at) = bytes.windows(5).position(|word| word == b"\nend ")
            && lost < 2
        {
            lost += 1;
            bytes[at + 1] ^= 1;
        }
        bytes
    });
    bench.until(State::Ready);
    assert_eq!(bench.link.live().unwrap().end(), Some(Outcome::Finish), "{}", bench.tail());
}

#[test]
fn a_lost_line_is_a_gap_and_no_wrong_run() {
    let mut bench = Bench::ready();
    bench.explore();
    let mut lost = false;
    bench.to_page = Box::new(move |mut bytes| {
        if let Some(at) = bytes.windows(3).position(|word| word == b"do ")
            && !lost
        {
            lost = true;
            bytes[at] ^= 1;
        }
        bytes
    });
    bench.until(State::Ready);
    let live = bench.link.live().unwrap();
    assert_eq!(live.end(), Some(Outcome::Cut(Cut::Gap)));
    assert_eq!(live.difference(), None);
}

#[test]
fn the_first_disagreement_is_marked() {
    let mut bench = Bench::ready();
    // The robot takes places a cell and a half apart for one; the page does not.
    bench.command(Command::Set(Name::Epsilon, 1_000));
    bench.wait(500);
    assert_eq!(bench.link.setting(Name::Epsilon), Some(1_000));
    bench.explore();
    bench.until(State::Ready);
    let live = bench.link.live().unwrap();
    let difference = live.difference().unwrap();
    // The golden of the explorer's specification: (0,3) is taken for node 1.
    assert_eq!((difference.stop, difference.robot.node, difference.page.node), (2, 1, 2));
    assert_eq!(live.end().unwrap().name(), "lost");
    assert!(bench.link.monitor().download().contains("the page decides otherwise"));
}

#[test]
fn the_page_is_no_cleverer_than_the_robot() {
    let mut bench = Bench::ready();
    bench.command(Command::Place);
    bench.command(Command::Explore(Mind { node_max: 1_000, ..mind() }));
    bench.until(State::Running);
    bench.until(State::Ready);
    assert_eq!(bench.link.live().unwrap().difference(), None);
}

#[test]
fn leaving_is_asked_only_while_something_would_be_cut_off() {
    let mut bench = Bench::ready();
    assert!(!bench.link.is_busy());
    bench.explore();
    assert!(bench.link.is_busy());
    bench.command(Command::Disconnect);
    assert_eq!(bench.link.state(), State::Closed);
    assert!(!bench.link.is_busy());
    assert_eq!(bench.actions.last(), Some(&Action::Close));
}
