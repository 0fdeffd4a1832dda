//! Stop: repeated until it is confirmed, never followed by what was wanted before, and told as what it is.

use line_maze_lab::event::{Cut, Outcome};
use line_maze_lab::link::page::{Action, Alarm, Command, Job, News, PortEvent, State, TRIES};
use line_maze_lab::link::tune::Name;

use crate::bench::{Bench, Opening, USB, mind};

/// A robot that drives, and whose words the page no longer hears.
fn unheard() -> Bench {
    let mut bench = Bench::ready();
    bench.explore();
    bench.wait(2_000);
    bench.to_page = Box::new(|_| Vec::new());
    bench
}

fn stops(lines: &[String]) -> usize {
    lines.iter().filter(|line| line.starts_with("stop #")).count()
}

fn runs(lines: &[String]) -> usize {
    lines.iter().filter(|line| line.starts_with("run ")).count()
}

fn told(bench: &Bench, news: impl Fn(News) -> bool) -> bool {
    bench.link.notes().any(|note| news(note.news))
}

#[test]
fn a_stop_that_is_not_confirmed_is_said_four_times_a_second_until_it_is() {
    let mut bench = unheard();
    let before = bench.actions.len();
    bench.command(Command::Stop);
    assert_eq!(bench.link.state(), State::Stopping);
    bench.wait(450);
    assert_eq!(bench.link.state(), State::Stopping, "not every answer is quick");
    bench.wait(9_600);
    assert_eq!(bench.link.state(), State::Alarm(Alarm::Unconfirmed));
    let sent = bench.sent(before);
    assert!((40..=42).contains(&stops(&sent)), "{} in 10 s", stops(&sent));
    // The same bytes each time, and nothing else.
    let first = sent.iter().find(|line| !line.is_empty()).unwrap();
    assert!(sent.iter().all(|line| line.is_empty() || line == first), "{sent:?}");
    // The state says what to do with one's hands, and stays for minutes.
    assert!(bench.link.state().says().contains("may still be driving"));
    assert!(bench.link.state().cure().unwrap().starts_with("Lift the robot"));
    bench.wait(120_000);
    assert_eq!(bench.link.state(), State::Alarm(Alarm::Unconfirmed));
    bench.to_page = Box::new(|bytes| bytes);
    bench.until(State::Ready);
    assert_eq!(bench.link.live().unwrap().end(), Some(Outcome::Cut(Cut::Stopped)));
    assert!(told(&bench, |news| news == News::Done(Job::Stop)));
    let after = bench.actions.len();
    bench.wait(2_000);
    assert_eq!(stops(&bench.sent(after)), 0);
}

#[test]
fn whoever_presses_again_in_an_alarm_is_obeyed_at_once() {
    let mut bench = unheard();
    bench.command(Command::Stop);
    bench.wait(1_010);
    let before = bench.actions.len();
    bench.command(Command::Stop);
    assert_eq!(stops(&bench.sent(before)), 1);
}

#[test]
fn a_robot_that_falls_silent_in_a_run_is_told_to_stop() {
    let mut bench = unheard();
    let before = bench.actions.len();
    bench.wait(2_400);
    assert_eq!(bench.link.state(), State::Running);
    bench.wait(1_000);
    assert_eq!(bench.link.state(), State::Alarm(Alarm::Silent));
    assert!(stops(&bench.sent(before)) > 0);
    // The port is not given up: only through it can the robot be stopped.
    bench.wait(60_000);
    assert_eq!(bench.link.state(), State::Alarm(Alarm::Silent));
    assert!(bench.open);
    bench.to_page = Box::new(|bytes| bytes);
    bench.until(State::Ready);
    // What is not known of it is asked; what was known is not forgotten.
    bench.wait(500);
    assert_eq!(bench.link.setting(Name::Kp), Some(620));
}

#[test]
fn a_run_that_is_not_answered_may_drive_and_is_stopped() {
    let mut bench = Bench::ready();
    bench.command(Command::Place);
    bench.wait(100);
    bench.to_page = Box::new(|_| Vec::new());
    let before = bench.actions.len();
    bench.command(Command::Explore(mind()));
    bench.wait(2_100);
    let sent = bench.sent(before);
    assert_eq!(runs(&sent), usize::from(TRIES));
    assert!(sent.last().unwrap().starts_with("stop #"), "{sent:?}");
    assert!(matches!(bench.link.state(), State::Alarm(_)), "{:?}", bench.link.state());
    bench.to_page = Box::new(|bytes| bytes);
    bench.until(State::Ready);
    bench.wait(5_000);
    assert_eq!(runs(&bench.sent(before)), usize::from(TRIES));
}

#[test]
fn a_write_that_does_not_end_is_thrown_away_with_all_that_waits() {
    for running in [false, true] {
        let mut bench = Bench::ready();
        if running {
            bench.explore();
        } else {
            bench.command(Command::Place);
            bench.wait(100);
        }
        bench.stalled = true;
        let before = bench.actions.len();
        bench.command(Command::Set(Name::Kp, 700));
        if !running {
            bench.command(Command::Explore(mind()));
        }
        bench.command(Command::ReadNodes);
        bench.command(Command::Line("get ki".into()));
        assert!(told(&bench, |news| news == News::LineNotNow));
        bench.wait(950);
        // One line at a time: nothing is queued behind it in the system.
        assert_eq!(
            bench.sent(before),
            [format!("set kp 700 #{}", bench.sent(before)[0].split('#').nth(1).unwrap())]
        );
        bench.wait(100);
        assert_eq!(bench.link.state(), State::Alarm(Alarm::Stalled));
        assert!(bench.actions[before..].contains(&Action::Abort));
        assert!(told(&bench, |news| news == News::LostWrite));
        assert!(told(&bench, |news| news == News::ThrownAway(Job::Set(Name::Kp, 700))));
        assert_eq!(told(&bench, |news| matches!(news, News::ThrownAway(Job::Run(_)))), !running);
        assert!(bench.tail().contains("did not leave the computer"), "{}", bench.tail());
        // The next line is stop, and so is every other, until the cable takes one again.
        bench.wait(10_000);
        let sent = bench.sent(before);
        assert!(sent[1..].iter().all(|line| line.is_empty() || line.starts_with("stop #")), "{sent:?}");
        let back = bench.actions.len();
        bench.stalled = false;
        bench.until(State::Ready);
        bench.wait(10_000);
        let sent = bench.sent(back);
        assert_eq!((runs(&sent), sent.iter().any(|line| line.starts_with("set "))), (0, false), "{sent:?}");
        assert_eq!(bench.link.state(), State::Ready);
        assert_eq!(bench.link.setting(Name::Kp), Some(620));
    }
}

#[test]
fn a_port_that_does_not_even_let_go_is_gone() {
    let mut bench = unheard();
    bench.link.command(Command::Stop, bench.now_ms);
    // Neither `Written` nor `Aborted` ever comes.
    let mut actions = Vec::new();
    while bench.link.state() != State::Lost {
        bench.now_ms += 20;
        assert!(bench.now_ms < 60_000);
        actions.extend(bench.link.tick(bench.now_ms));
    }
    assert_eq!(actions.iter().filter(|&action| *action == Action::Abort).count(), 1);
    assert_eq!(actions.last(), Some(&Action::Close));
    assert_eq!(bench.link.notes().last().unwrap().news, News::MayDrive);
}

#[test]
fn a_page_that_slept_takes_no_write_for_lost() {
    let mut bench = Bench::ready();
    bench.explore();
    bench.stalled = true;
    bench.command(Command::ReadNodes);
    // Nobody was woken for a minute; then it turns out that everything had left long ago.
    bench.now_ms += 60_000;
    let actions = bench.link.tick(bench.now_ms);
    assert!(!actions.contains(&Action::Abort), "{actions:?}");
}

#[test]
fn a_run_that_waited_too_long_is_not_sent() {
    let mut bench = Bench::ready();
    bench.command(Command::Place);
    bench.wait(100);
    // Deaf for a while; some questions are asked first.
    bench.to_robot = Box::new(|_| Vec::new());
    let before = bench.actions.len();
    bench.command(Command::Set(Name::Kp, 700));
    bench.command(Command::Set(Name::Ki, 7));
    bench.command(Command::Explore(mind()));
    bench.wait(2_900);
    bench.to_robot = Box::new(|bytes| bytes);
    bench.wait(3_000);
    assert_eq!(runs(&bench.sent(before)), 0, "{}", bench.tail());
    assert!(told(&bench, |news| matches!(news, News::TooLate(Job::Run(_)))));
}

#[test]
fn a_page_that_slept_does_not_repeat_an_old_run() {
    let mut bench = Bench::ready();
    bench.command(Command::Place);
    bench.wait(100);
    bench.to_page = Box::new(|_| Vec::new());
    bench.command(Command::Explore(mind()));
    let before = bench.actions.len();
    bench.now_ms += 60_000;
    bench.wait(3_000);
    let sent = bench.sent(before);
    assert_eq!(runs(&sent), 0, "{sent:?}");
    assert!(stops(&sent) > 0);
}

#[test]
fn a_robot_that_was_lost_while_it_drove_is_told_to_stop_first() {
    let mut bench = Bench::ready();
    bench.opening = Opening::Leaves;
    bench.explore();
    bench.wait(2_000);
    bench.unplug();
    assert_eq!(bench.link.notes().last().unwrap().news, News::MayDrive);
    bench.wait(1_500);
    bench.plugged = true;
    let before = bench.actions.len();
    bench.until(State::Ready);
    let sent: Vec<String> = bench.sent(before).into_iter().filter(|line| !line.is_empty()).collect();
    assert!(sent[0].starts_with("stop #") && sent[1].starts_with("hi #"), "{sent:?}");
    assert_eq!(runs(&sent), 0);
    // It stands, and is not told so again the next time.
    bench.command(Command::Disconnect);
    let before = bench.actions.len();
    bench.command(Command::Use(USB));
    bench.until(State::Ready);
    assert_eq!(stops(&bench.sent(before)), 0);
}

/// What is left for somebody's hands is told last, whichever answer comes first.
#[test]
fn a_robot_that_is_back_is_to_be_put_at_the_start() {
    for opening in [Opening::Resets, Opening::Leaves] {
        let mut bench = Bench::ready();
        bench.opening = opening;
        bench.explore();
        bench.wait(2_000);
        bench.unplug();
        bench.wait(1_500);
        bench.plugged = true;
        bench.until(State::Ready);
        bench.wait(3_000);
        assert!(told(&bench, |news| news == News::Done(Job::Stop)), "{opening:?}");
        assert_eq!(bench.link.notes().last().unwrap().news, News::Reconnected, "{opening:?}");
    }
}

#[test]
fn an_alarm_ends_with_the_port() {
    let mut bench = unheard();
    bench.command(Command::Stop);
    bench.wait(1_000);
    bench.port(PortEvent::Gone);
    bench.open = false;
    bench.plugged = false;
    assert_eq!(bench.link.state(), State::Lost);
    let before = bench.actions.len();
    bench.wait(5_000);
    assert_eq!(stops(&bench.sent(before)), 0);
}

#[test]
fn an_end_that_is_told_confirms_a_stop() {
    let mut bench = Bench::ready();
    bench.explore();
    bench.wait(2_000);
    // Its answers are swallowed, not what it tells.
    bench.to_page = Box::new(crate::bench::retelling(|line| (!line.starts_with("ok ")).then(|| line.into())));
    bench.command(Command::Stop);
    bench.wait(100);
    assert_ne!(bench.link.state(), State::Stopping);
    assert!(!bench.link.may_drive(), "{:?}", bench.link.state());
}

#[test]
fn stop_is_confirmed_by_a_robot_that_has_not_said_who_it_is() {
    let mut bench = Bench::ready();
    bench.command(Command::Disconnect);
    bench.opening = Opening::Leaves;
    // Its ready lines are lost for a while.
    bench.to_page =
        Box::new(crate::bench::retelling(|line| (!line.starts_with("ready ")).then(|| line.into())));
    bench.command(Command::Use(USB));
    bench.wait(200);
    assert_eq!(bench.link.state(), State::Waiting);
    let before = bench.actions.len();
    bench.command(Command::Stop);
    bench.wait(1_000);
    assert_eq!((bench.link.state(), stops(&bench.sent(before))), (State::Waiting, 1));
    bench.to_page = Box::new(|bytes| bytes);
    bench.until(State::Ready);
}

#[test]
fn nothing_is_asked_of_a_robot_that_may_be_driving() {
    let mut bench = unheard();
    bench.command(Command::Stop);
    bench.wait(1_000);
    let before = bench.actions.len();
    for command in [Command::Explore(mind()), Command::RunRoute, Command::Place, Command::Set(Name::Kp, 1)] {
        bench.command(command);
    }
    assert_eq!(bench.link.notes().filter(|note| matches!(note.news, News::NotNow(_))).count(), 4);
    bench.to_page = Box::new(|bytes| bytes);
    bench.until(State::Ready);
    bench.wait(2_000);
    let sent = bench.sent(before);
    assert!(
        !sent.iter().any(|line| ["run", "place", "set"].iter().any(|verb| line.starts_with(verb))),
        "{sent:?}"
    );
}

#[test]
fn a_run_is_accepted_then_drives_then_has_ended() {
    let mut bench = Bench::ready();
    bench.command(Command::Place);
    bench.command(Command::Explore(mind()));
    bench.until(State::Running);
    let last = |bench: &Bench| bench.link.notes().last().unwrap().news.text();
    assert_eq!(last(&bench), "explore SRL: accepted.");
    bench.until_so(|bench| bench.link.live().is_some_and(|live| live.stops() > 0));
    assert_eq!(last(&bench), "explore SRL: driving.");
    bench.until(State::Ready);
    assert_eq!(last(&bench), "explore SRL: ended, finish reached.");
    bench.explore();
    bench.command(Command::Stop);
    bench.until(State::Ready);
    assert_eq!(last(&bench), "stop: the robot says that it stands.");
}
