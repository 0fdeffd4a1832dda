//! Rubbish, floods, faulty wires, and an hour of it.

use line_maze_lab::link::demo::DemoRobot;
use line_maze_lab::link::frame::crc8;
use line_maze_lab::link::keep::Keep;
use line_maze_lab::link::monitor::KEPT_LINES;
use line_maze_lab::link::page::{Action, Command, Link, Port, PortEvent, Sent, State};
use proptest::prelude::*;

use crate::bench::{Bench, USB};
use crate::support::figure_3_1;

/// Whatever happens, the page is in a state that has a name, and gets back to the robot.
#[test]
fn faulty_wires_do_not_stop_the_page() {
    for seed in 0..12 {
        let robot = DemoRobot::new(&figure_3_1(), 0).unwrap().with_faults(seed);
        let mut bench = Bench::new(robot);
        let mut finished = 0;
        for _ in 0..60 {
            match bench.link.state() {
                State::Closed | State::Failed(_) => bench.command(Command::Use(USB)),
                State::Ready => {
                    bench.command(Command::Send("SSR".parse().unwrap()));
                    bench.wait(2_000);
                    bench.command(Command::Place);
                    bench.command(Command::Explore(crate::bench::mind()));
                }
                State::Absent
                | State::Choosing
                | State::Opening
                | State::Waiting
                | State::Sending
                | State::Running
                | State::Stopping
                | State::Alarm(_)
                | State::Lost
                | State::Reconnecting => {}
            }
            bench.wait(3_000);
            finished += u32::from(bench.link.live().is_some_and(|live| live.stops() > 3));
        }
        assert!(finished > 0, "seed {seed}: {:?}\n{}", bench.link.state(), bench.tail());
    }
}

/// A list that is sent over a faulty wire: sooner or later the page says which one the robot holds, and is right.
#[test]
fn faulty_wires_never_leave_it_open_which_list_is_kept() {
    for seed in 0..200 {
        let mut bench = Bench::new(DemoRobot::new(&figure_3_1(), 0).unwrap().with_faults(seed));
        bench.command(Command::Use(USB));
        let mut sent = Sent::Nothing;
        for second in 0.. {
            assert!(second < 120, "seed {seed}: {sent:?} {:?}\n{}", bench.link.state(), bench.tail());
            match bench.link.state() {
                State::Failed(_) => bench.command(Command::Use(USB)),
                State::Ready if sent == Sent::Nothing => bench.command(Command::Send("SSR".parse().unwrap())),
                _ => {}
            }
            bench.wait(1_000);
            sent = bench.link.snapshot().sent;
            if let Sent::New | Sent::Old | Sent::Differs = sent {
                break;
            }
        }
        let list = Keep::open(bench.robot.eeprom().unwrap().clone()).list().map(|list| list.upload.len);
        let expected = if list == Some(3) { Sent::New } else { Sent::Old };
        assert_eq!(sent, expected, "seed {seed}: {list:?}\n{}", bench.tail());
    }
}

#[test]
fn the_same_seed_brings_the_same_faults() {
    let run = |seed| {
        let mut bench = Bench::new(DemoRobot::new(&figure_3_1(), 0).unwrap().with_faults(seed));
        bench.command(Command::Use(USB));
        bench.wait(30_000);
        bench.link.monitor().download()
    };
    assert!(run(3) == run(3));
    assert!(run(3) != run(4));
}

/// The page with an open port and a robot that has said who it is.
fn met() -> Link {
    let mut link = Link::new(0, 0);
    link.command(Command::Use(Port::Serial(None)), 0);
    let actions = link.port_event(PortEvent::Opened, 0);
    carried_out(&mut link, actions, 0);
    let actions = link.bytes_in(&sealed("ready 1 lab-1 uno 50 400"), 1);
    carried_out(&mut link, actions, 1);
    assert_eq!(link.state(), State::Ready);
    link
}

/// Everything that was written leaves at once; how many actions there were in all.
fn carried_out(link: &mut Link, mut actions: Vec<Action>, ms: u64) -> usize {
    let mut all = 0;
    while !actions.is_empty() {
        all += actions.len();
        let writes = actions.iter().filter(|action| matches!(action, Action::Write(_))).count();
        actions = (0..writes).flat_map(|_| link.port_event(PortEvent::Written, ms)).collect();
    }
    all
}

/// Lines with their checksums.
fn sealed(lines: &str) -> Vec<u8> {
    lines.lines().flat_map(|line| format!("{line}*{:02X}\n", crc8(line.as_bytes())).into_bytes()).collect()
}

#[test]
fn a_megabyte_a_second_of_rubbish_changes_nothing_and_grows_nothing() {
    let mut chance = oorandom::Rand32::new(1);
    let rubbish: Vec<u8> = (0..16_000).map(|_| chance.rand_u32() as u8).collect();
    let mut link = met();
    let mut most = 0;
    for ms in (0..20_000).step_by(16) {
        let actions = [link.bytes_in(&rubbish, ms), link.tick(ms)].concat();
        carried_out(&mut link, actions, ms);
        most = most.max(link.monitor().bytes());
        if link.state() != State::Ready {
            break;
        }
    }
    // Nothing good came: the robot is not there, and nobody claims that it is.
    assert!(matches!(link.state(), State::Failed(_)), "{:?}", link.state());
    assert!(most < 4_000_000, "{most}");
}

#[test]
fn a_flood_of_ready_lines_is_answered_seldom() {
    let mut link = met();
    let ready = sealed("ready 1 lab-1 uno 50 400");
    let mut written = 0;
    for ms in (1_000..6_000).step_by(16) {
        for _ in 0..400 {
            let actions = link.bytes_in(&ready, ms);
            written += carried_out(&mut link, actions, ms);
        }
        let actions = link.tick(ms);
        written += carried_out(&mut link, actions, ms);
    }
    assert!(written < 100, "{written}");
}

#[test]
fn an_hour_of_a_hundred_lines_a_second_stays_flat() {
    let mut link = met();
    let mut after_ten_minutes = None;
    for tick in 0..360_000u64 {
        let ms = tick * 10;
        let line = match tick % 100 {
            0 => format!("beat {ms} 7400"),
            50 => format!("at {ms} corner 0 L 0 {}", ms / 100),
            _ => format!("ir {ms} 2000 30 31 740 33 34 -12 120 130"),
        };
        let actions = [link.bytes_in(&sealed(&line), ms), link.tick(ms)].concat();
        carried_out(&mut link, actions, ms);
        if tick == 60_000 {
            after_ten_minutes = Some((link.monitor().bytes(), link.session().len()));
        }
    }
    let (bytes, recorded) = after_ten_minutes.unwrap();
    assert!(link.monitor().bytes() <= bytes * 11 / 10);
    assert_eq!(link.monitor().lines().len(), KEPT_LINES);
    assert!(link.session().len() <= recorded + 5_000, "{recorded} {}", link.session().len());
    assert!(link.plot().samples(6_000).count() > 500);
}

proptest! {
    #[test]
    fn any_bytes_at_any_time_never_panic(
        pieces in proptest::collection::vec((proptest::collection::vec(any::<u8>(), 0..200), 0u64..3_000), 1..20),
    ) {
        let mut link = met();
        let mut robot = DemoRobot::new(&figure_3_1(), 0).unwrap();
        robot.wake(0);
        let mut ms = 0;
        for (bytes, wait_ms) in pieces {
            ms += wait_ms;
            link.bytes_in(&bytes, ms);
            link.tick(ms);
            robot.bytes_in(&bytes, ms);
            let said = robot.tick(ms);
            link.bytes_in(&said, ms);
        }
    }

    /// However the bytes are cut into pieces, the page ends up knowing the same.
    #[test]
    fn any_split_of_the_bytes_is_the_same(cuts in proptest::collection::vec(1usize..60, 1..200)) {
        let session = sealed("turns have 1 3 EA59 sent\nat 5 new 1 SR 0 400\ndo 5 S 2 0\nbeat 9 7000\nbeat 9 1");
        let whole = { let mut link = met(); link.bytes_in(&session, 5); link.monitor().download() };
        let mut link = met();
        let mut rest = &session[..];
        for cut in cuts {
            let (piece, after) = rest.split_at(cut.min(rest.len()));
            link.bytes_in(piece, 5);
            rest = after;
        }
        link.bytes_in(rest, 5);
        prop_assert_eq!(link.monitor().download(), whole);
    }
}
