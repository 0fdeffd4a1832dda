//! Runs: the live run is the simulated run, whatever happens on the way.

use line_maze_lab::event::{Cut, Outcome};
use line_maze_lab::geometry::{Heading, Turn, Ways};
use line_maze_lab::link::floor;
use line_maze_lab::link::live::{Errand, LiveRun, is_along};
use line_maze_lab::link::page::{Command, Kept, Placed, Sent, State};
use line_maze_lab::link::report::{Chose, End, Kind, Origin, Reached};
use line_maze_lab::run;
use line_maze_lab::settings::{Pace, Settings};

use crate::bench::{Bench, moved, retelling};
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

/// A robot that measures where it is: never quite on the axis, and never quite where it was before.
#[test]
fn a_robot_that_measures_its_way_is_followed_to_the_end() {
    let mut bench = Bench::ready();
    let mut stops = 0;
    bench.to_page = Box::new(retelling(move |line| {
        stops += i32::from(line.starts_with("at "));
        Some(moved(line, |x, y| (x + stops % 3 * 13 - y / 60, y - stops % 2 * 9 + x / 60)))
    }));
    bench.explore();
    bench.until(State::Ready);
    let live = bench.link.live().unwrap();
    assert_eq!((live.end(), live.stops()), (Some(Outcome::Finish), 25), "{}", bench.tail());
    assert_eq!(live.difference(), None);
    // It is drawn where it drove.
    let (maze, trace) = (figure_3_1(), live.trace());
    assert_eq!(floor::ground(&maze, &trace, 400), Some(floor::Ground { seen: None, cell_ms: 400 }));
    // A run that somebody starts by hand begins a little aside too.
    let text = bench.link.session().save();
    let unasked: Vec<&str> = text.lines().filter(|line| !line.contains(" > ")).collect();
    let session = line_maze_lab::link::session::Session::parse(&unasked.join("\n")).unwrap();
    let runs = session.runs(crate::bench::mind(), Pace::default());
    assert_eq!((runs.len(), runs[0].end()), (1, Some(Outcome::Finish)));
}

#[test]
fn an_eighth_of_a_drive_and_no_more_may_lead_aside() {
    for (along, aside, fits) in [
        (400, 50, true),
        (400, -50, true),
        (400, 51, false),
        (4_000, 500, true),
        (4_000, 501, false),
        (60, 20, true),
        (60, 21, false),
        (-20, 0, true),
        (-21, 0, false),
        (i32::MIN, i32::MIN, false),
    ] {
        assert_eq!(is_along(along, aside), fits, "{along} {aside}");
    }
}

/// A stop as it is told.
fn at(kind: Kind, node: u16, ways: &[Heading], (x, y): (i32, i32)) -> Reached {
    let ways = ways.iter().fold(Ways::NONE, |ways, &way| ways.with(way));
    Reached { ms: 0, kind, node, ways, x, y }
}

const fn on(turn: Turn, ptr: u16) -> Chose {
    Chose { ms: 0, turn: Some(turn), ptr, returning: false }
}

#[test]
fn a_lost_line_is_said_only_where_one_is_missing() {
    use Heading::{East, North};
    let begun = || {
        let mut run = LiveRun::new(Errand::Unasked, Pace::default());
        run.reached(at(Kind::New, 1, &[North, East], (3, 400)));
        run.chose(on(Turn::Right, 2));
        run
    };
    let end = |tell: &dyn Fn(&mut LiveRun)| {
        let mut run = begun();
        tell(&mut run);
        run.end()
    };
    let gap = Some(Outcome::Cut(Cut::Gap));
    let misfit = Some(Outcome::Cut(Cut::Misfit));
    // `do` without `at`, `at` without `do`, and a node too many.
    assert_eq!(
        end(&|run| {
            run.chose(on(Turn::Left, 2));
        }),
        gap
    );
    assert_eq!(
        end(&|run| {
            run.reached(at(Kind::Corner, 0, &[North], (403, 410)));
            run.reached(at(Kind::Corner, 0, &[East], (803, 410)));
        }),
        gap
    );
    assert_eq!(end(&|run| run.reached(at(Kind::New, 3, &[North, East], (403, 400)))), gap);
    // Aside, or another kind of stop than the ways say: nothing is known to be missing.
    assert_eq!(end(&|run| run.reached(at(Kind::New, 2, &[North, East], (403, 480)))), misfit);
    assert_eq!(end(&|run| run.reached(at(Kind::Corner, 0, &[North, East], (403, 400)))), misfit);
    // A little aside.
    assert_eq!(end(&|run| run.reached(at(Kind::New, 2, &[North, East], (403, 440)))), None);
}

#[test]
fn a_run_too_long_to_follow_is_told_as_that() {
    let mut run = LiveRun::new(Errand::Unasked, Pace::default());
    for stop in 0..=line_maze_lab::link::live::MAX_STOPS as i32 {
        run.reached(at(Kind::Corner, 0, &[Heading::North], (0, stop)));
        run.chose(on(Turn::Straight, 1));
    }
    run.ended(End::Finish);
    assert_eq!(run.end().map(Outcome::name), Some("lost"));
}
