//! Both ends of the link under foreign lines, foreign bytes, and time that leaps: neither panics nor grows, and
//! the page never claims a robot that is not there.
#![no_main]

use libfuzzer_sys::fuzz_target;
use line_maze_lab::link::demo::DemoRobot;
use line_maze_lab::link::frame::crc8;
use line_maze_lab::link::page::{Action, Command, Link, Port, PortEvent, State};
use line_maze_lab::link::session::Session;
use line_maze_lab::maze::samples;
use line_maze_lab::settings::Pace;

fuzz_target!(|bytes: &[u8]| {
    let mut link = Link::new(0, 0);
    let Ok(mut robot) = DemoRobot::new(&samples::figure_3_1(), 0) else { return };
    robot.wake(0);
    link.command(Command::Use(Port::Serial(None)), 0);
    let mut now_ms = 0;
    link.port_event(PortEvent::Opened, now_ms);
    link.port_event(PortEvent::Written, now_ms);
    link.bytes_in(&sealed(b"ready 1 fuzz fuzz 50 400"), now_ms);
    link.port_event(PortEvent::Written, now_ms);
    // The first byte of each line says what is done with it, and how much later.
    for line in bytes.split(|&byte| byte == b'\n') {
        let Some((&first, rest)) = line.split_first() else { continue };
        now_ms += u64::from(first >> 3) * 40;
        match first & 7 {
            0 => drop(link.bytes_in(rest, now_ms)),
            1 | 2 => drop(link.bytes_in(&sealed(rest), now_ms)),
            3 => robot.bytes_in(rest, now_ms),
            4 | 5 => robot.bytes_in(&sealed(rest), now_ms),
            6 => drop(link.port_event(PortEvent::Gone, now_ms)),
            _ => {
                link.command(Command::Send("SSRLLB".parse().unwrap_or_default()), now_ms);
                link.command(Command::RunRoute, now_ms);
                link.command(Command::Stop, now_ms);
            }
        }
        // Every other line leaves the computer; what is thrown away is away at once.
        for action in link.tick(now_ms) {
            if action == Action::Abort {
                link.port_event(PortEvent::Aborted, now_ms);
            }
        }
        if first & 1 == 0 {
            link.port_event(PortEvent::Written, now_ms);
        }
        let said = robot.tick(now_ms);
        assert!(said.is_ascii());
    }
    assert!(link.state() != State::Sending || link.is_busy());
    assert!(link.monitor().bytes() < bytes.len() * 64 + 100_000);
    if let Some(live) = link.live() {
        let trace = live.trace();
        let _ = trace.frame(trace.end());
    }
    let saved = link.session().save();
    match Session::parse(&saved) {
        Err(error) => panic!("{error} in {saved}"),
        Ok(session) => drop(session.runs(
            line_maze_lab::link::live::Mind {
                order: "SRL".parse().unwrap_or(line_maze_lab::settings::Order::Random(1)),
                epsilon_ms: 200,
                node_max: 50,
            },
            Pace::default(),
        )),
    }
});

/// A line with its checksum.
fn sealed(body: &[u8]) -> Vec<u8> {
    let mut line = body.to_vec();
    line.extend(format!("*{:02X}\n", crc8(body)).into_bytes());
    line
}
