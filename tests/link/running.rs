//! Runs: the live run is the simulated run, whatever happens on the way.

use line_maze_lab::event::{Cut, Outcome};
use line_maze_lab::link::page::{Command, Kept, Placed, Sent, State};
use line_maze_lab::link::report::Origin;
use line_maze_lab::run;
use line_maze_lab::settings::Settings;

use crate::bench::Bench;
use crate::support::figure_3_1;

#[test]
fn figure_3_1_live_is_figure_3_1_simulated() {
    let mut bench = Bench::ready();
    bench.explore();
    bench.until(State::Ready);
    bench.wait(1_000);
    let live = bench.link.live().unwrap();
    let simulated = run::explore(&figure_3_1(), &Settings::default()).unwrap();
    assert_eq!(live.difference(), None);
    assert_eq!(live.trace().steps(), simulated.steps());
    assert_eq!(live.end(), Some(Outcome::Finish));
    // The robot has kept the way that it found, and the table is what the trace says.
    let Kept::List(list) = bench.link.kept() else { panic!("{:?}", bench.link.kept()) };
    assert_eq!((list.letters.as_str(), list.origin), ("SSR", Origin::Learned));
    assert_eq!(bench.link.nodes().len(), 3);
    assert_eq!(bench.link.snapshot().placed, Placed::Somewhere);
}

#[test]
fn a_sent_list_is_read_back_and_driven() {
    let mut bench = Bench::ready();
    assert_eq!(bench.link.kept(), &Kept::Nothing);
    bench.command(Command::Send("SSR".parse().unwrap()));
    assert_eq!(bench.link.state(), State::Sending);
    bench.until(State::Ready);
    assert_eq!(bench.link.snapshot().sent, Sent::New);
    let Kept::List(list) = bench.link.kept() else { panic!("{:?}", bench.link.kept()) };
    assert_eq!((list.letters.as_str(), list.origin), ("SSR", Origin::Sent));
    bench.command(Command::Place);
    bench.command(Command::RunRoute);
    bench.until(State::Running);
    bench.until(State::Ready);
    let live = bench.link.live().unwrap();
    assert_eq!((live.end(), live.stops()), (Some(Outcome::Finish), 5));
}

#[test]
fn stop_overtakes_what_waits_and_ends_the_run() {
    let mut bench = Bench::ready();
    bench.explore();
    bench.wait(3_000);
    let before = bench.actions.len();
    bench.command(Command::ReadSettings);
    bench.command(Command::ReadNodes);
    bench.command(Command::Stop);
    let sent = bench.sent(before);
    assert!(sent[0].starts_with("get kp"), "{sent:?}");
    assert_eq!(sent[1], "");
    assert!(sent[2].starts_with("stop #"), "{sent:?}");
    bench.wait(100);
    assert_eq!(bench.link.state(), State::Ready);
    assert_eq!(bench.link.live().unwrap().end(), Some(Outcome::Cut(Cut::Stopped)));
}
