//! From closed to ready, and every way in which that goes wrong.

use line_maze_lab::link::demo::DemoRobot;
use line_maze_lab::link::page::{
    Action, Command, Heard, Link, News, OpenError, Port, PortEvent, State, Trouble,
};

use crate::bench::{Bench, Opening, USB};
use crate::support::figure_3_1;

fn bench() -> Bench {
    Bench::new(DemoRobot::new(&figure_3_1(), 0).unwrap())
}

#[test]
fn an_uno_resets_and_says_ready() {
    let mut bench = bench();
    bench.command(Command::Use(USB));
    assert_eq!(bench.link.state(), State::Waiting);
    // `hi` at once, after an LF; the bootloader does not hear it.
    assert_eq!(bench.sent(0), ["", "hi #0"]);
    bench.until(State::Ready);
    assert!((1_000..1_100).contains(&bench.now_ms), "{}", bench.now_ms);
    let robot = bench.link.robot().unwrap();
    assert_eq!((robot.board.as_str(), robot.nodes), ("demo", 50));
    bench.wait(1_000);
    // Everything was asked once, and answered.
    assert_eq!(bench.link.monitor().bad(), 0);
    assert_eq!(bench.link.setting(line_maze_lab::link::tune::Name::Kp), Some(620));
    assert_eq!(bench.sent(0).len(), 2 + 2 + 12);
}

#[test]
fn a_radio_module_answers_the_first_hi() {
    let mut bench = bench();
    bench.opening = Opening::Leaves;
    bench.robot.wake(0);
    bench.command(Command::Use(Port::Serial(None)));
    bench.until(State::Ready);
    assert!(bench.now_ms < 100, "{}", bench.now_ms);
}

#[test]
fn nobody_answers() {
    let mut bench = bench();
    bench.to_robot = Box::new(|_| Vec::new());
    bench.to_page = Box::new(|_| Vec::new());
    bench.command(Command::Use(USB));
    let mut his = Vec::new();
    while bench.link.state() == State::Waiting {
        let before = bench.actions.len();
        bench.wait(5);
        if bench.sent(before).iter().any(|line| line.starts_with("hi")) {
            his.push(bench.now_ms);
        }
    }
    // After three seconds, a second apart.
    assert_eq!(his, [3_000, 4_000, 5_000]);
    assert_eq!(bench.now_ms, 6_000);
    let trouble = Trouble::NoAnswer { baud: 115_200, heard: Heard::Nothing };
    assert_eq!(bench.link.state(), State::Failed(trouble));
    assert_eq!(bench.actions.last(), Some(&Action::Close));
    // The button for the next rate.
    bench.command(Command::NextRate);
    assert!(bench.actions.contains(&Action::Open { baud: 9_600 }));
    let told = bench.link.notes().last().unwrap().news;
    assert_eq!(told, News::NextRate { from: 115_200, to: 9_600 });
}

#[test]
fn a_page_that_slept_gives_each_hi_its_second() {
    let mut bench = bench();
    bench.to_robot = Box::new(|_| Vec::new());
    bench.to_page = Box::new(|_| Vec::new());
    bench.command(Command::Use(USB));
    // A tab in the background, or a busy computer: nobody was woken for ten seconds.
    bench.now_ms += 10_000;
    bench.wait(900);
    assert_eq!(bench.link.state(), State::Waiting);
    assert_eq!(bench.sent(0).iter().filter(|line| line.starts_with("hi")).count(), 2);
    bench.wait(2_200);
    assert!(matches!(bench.link.state(), State::Failed(_)));
}

#[test]
fn rubbish_is_no_robot_and_is_shown() {
    let mut bench = bench();
    bench.to_page = Box::new(|bytes| bytes.into_iter().map(|byte| byte ^ 0xA5).collect());
    bench.command(Command::Use(USB));
    bench.wait(7_000);
    let trouble = Trouble::NoAnswer { baud: 115_200, heard: Heard::Rubbish };
    assert_eq!(bench.link.state(), State::Failed(trouble));
    assert!(bench.link.monitor().download().contains("\\x"));
}

#[test]
fn a_chooser_that_is_left_changes_nothing() {
    let mut bench = bench();
    bench.command(Command::Choose);
    assert_eq!(bench.link.state(), State::Choosing);
    assert_eq!(bench.actions, [Action::Choose]);
    bench.port(PortEvent::Cancelled);
    assert_eq!(bench.link.state(), State::Closed);
    assert!(bench.link.notes().last().unwrap().news.text().contains("another cable"));
}

#[test]
fn a_failed_open_says_why_and_gives_one_cure() {
    for error in [
        OpenError::InUse,
        OpenError::NoPermission,
        OpenError::InUseOrNoPermission,
        OpenError::Unplugged,
        OpenError::Policy,
        OpenError::Other,
    ] {
        let mut bench = bench();
        bench.command(Command::Choose);
        bench.link.port_event(PortEvent::Chosen(USB), 0);
        assert_eq!(bench.link.state(), State::Opening);
        bench.port(PortEvent::OpenFailed(error));
        let state = bench.link.state();
        assert_eq!(state, State::Failed(Trouble::Open(error)));
        assert!(state.says().ends_with('.') && state.cure().unwrap().len() > 10);
    }
    assert!(Trouble::Open(OpenError::NoPermission).cure().contains("dialout"));
}

#[test]
fn without_web_serial_there_is_still_the_demo_robot() {
    let mut bench = bench();
    bench.port(PortEvent::NoSerial);
    assert_eq!(bench.link.state(), State::Absent);
    bench.command(Command::Use(USB));
    assert_eq!(bench.link.state(), State::Absent);
    bench.command(Command::Use(Port::Demo));
    bench.until(State::Ready);
}

#[test]
fn what_was_told_of_a_connection_is_over_with_the_next() {
    let mut link = Link::new(0, 0);
    link.command(Command::Choose, 0);
    link.port_event(PortEvent::Cancelled, 10);
    assert_eq!(link.notes().next_back().unwrap().news, News::NothingChosen);
    link.command(Command::Use(USB), 20);
    assert!(link.notes().next().is_none());
}
