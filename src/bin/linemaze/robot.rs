//! `linemaze robot`: the virtual robot on a pseudo-terminal, or on standard input and output.

use std::collections::VecDeque;
use std::io::{self, Read, Write};
use std::sync::mpsc::{self, RecvTimeoutError};
use std::thread;
use std::time::{Duration, Instant};

use line_maze_lab::link::demo::DemoRobot;
use line_maze_lab::link::frame::is_end;

use crate::args::Robot;
use crate::{Failure, Status, files};

/// How often the robot is looked after.
const TICK_MS: u32 = 2;

/// `linemaze robot`
pub(crate) fn robot(args: &Robot, out: &mut impl Write) -> Result<Status, Failure> {
    let maze = files::marked(&args.maze, &args.marks)?;
    let refused = |error| Failure::Message(format!("{}: {error}", files::name(&args.maze)));
    let mut robot = DemoRobot::new(&maze, 0).map_err(refused)?.at_baud(args.baud.unwrap_or(115_200));
    if let Some(seed) = args.faults {
        robot = robot.with_faults(seed);
    }
    if args.quiet {
        robot.wake(0);
    }
    let clock = Clock { began: Instant::now(), hurry: args.hurry };
    match &args.pty {
        Some(path) => on_pty(args, path, robot, &clock, out),
        None => on_stdio(robot, &clock, out),
    }
}

/// The robot's time.
struct Clock {
    began: Instant,
    hurry: u32,
}

impl Clock {
    fn now_ms(&self) -> u64 {
        (self.began.elapsed() * self.hurry).as_millis() as u64
    }
}

/// Standard input is read by a thread of its own, as it cannot be waited for with a time limit everywhere. A pipe
/// waits, as no wire does: nothing of it is lost while the robot starts or still answers, and at its end
/// everything that was asked is answered and a run is driven to its end.
fn on_stdio(mut robot: DemoRobot, clock: &Clock, out: &mut impl Write) -> Result<Status, Failure> {
    let tick = Duration::from_millis(TICK_MS.into());
    let (sender, receiver) = mpsc::sync_channel(16);
    thread::spawn(move || {
        let mut bytes = [0; 1024];
        while let Ok(count @ 1..) = io::stdin().lock().read(&mut bytes) {
            if sender.send(bytes[..count].to_vec()).is_err() {
                break;
            }
        }
    });
    let mut typed = VecDeque::new();
    let mut over = false;
    loop {
        match receiver.recv_timeout(tick) {
            Ok(bytes) => typed.extend(bytes),
            Err(RecvTimeoutError::Timeout) => {}
            Err(RecvTimeoutError::Disconnected) => {
                over = true;
                thread::sleep(tick);
            }
        }
        while !typed.is_empty() && robot.takes_more() {
            let line = typed.iter().position(|&byte| is_end(byte)).map_or(typed.len(), |end| end + 1);
            let line: Vec<u8> = typed.drain(..line).collect();
            robot.bytes_in(&line, clock.now_ms());
        }
        let last = over && typed.is_empty();
        if last && robot.stands() {
            robot.hush();
        }
        let said = robot.tick(clock.now_ms());
        if !said.is_empty() {
            out.write_all(&said)?;
            out.flush()?;
        }
        if last && robot.is_done() {
            return Ok(Status::Good);
        }
    }
}

#[cfg(unix)]
fn on_pty(
    args: &Robot,
    path: &std::path::Path,
    mut robot: DemoRobot,
    clock: &Clock,
    out: &mut impl Write,
) -> Result<Status, Failure> {
    use crate::pty::{Peer, Pty};
    use crate::signals::Signals;

    let fails = |error: io::Error| Failure::Message(format!("{}: {error}", path.display()));
    let signals = Signals::held().map_err(fails)?;
    let mut pty = Pty::new(path).map_err(fails)?;
    writeln!(out, "robot at {} ({})", path.display(), pty.name().display())?;
    out.flush()?;
    let mut peer = Peer::Gone;
    let mut waiting = Vec::new();
    while !signals.came() {
        let was = std::mem::replace(&mut peer, pty.wait(TICK_MS).map_err(fails)?);
        if (was, peer) == (Peer::Gone, Peer::Open) {
            pty.opened().map_err(fails)?;
            waiting.clear();
            if !args.quiet {
                robot.reset(clock.now_ms());
            }
        }
        let garbled = match args.baud {
            Some(baud) => pty.baud().map_err(fails)? != baud,
            None => false,
        };
        let at_this_rate = |bytes: Vec<u8>| -> Vec<u8> {
            if garbled { bytes.into_iter().map(|byte| byte.rotate_left(3) ^ 0x9C).collect() } else { bytes }
        };
        let heard = at_this_rate(pty.read().map_err(fails)?);
        robot.bytes_in(&heard, clock.now_ms());
        waiting.extend(at_this_rate(robot.tick(clock.now_ms())));
        // A wire does not wait: what nobody takes is gone.
        let written = if peer == Peer::Open { pty.write(&waiting).map_err(fails)? } else { waiting.len() };
        waiting.drain(..written);
        let too_much = waiting.len().saturating_sub(64 * 1024);
        waiting.drain(..too_much);
    }
    // The link goes first: nobody is to open a terminal that nobody serves.
    drop(pty);
    signals.obey().map_err(fails)?;
    Ok(Status::Good)
}

#[cfg(not(unix))]
fn on_pty(
    _: &Robot,
    path: &std::path::Path,
    _: DemoRobot,
    _: &Clock,
    _: &mut impl Write,
) -> Result<Status, Failure> {
    Err(Failure::Message(format!("{}: there are no pseudo-terminals here; use --stdio", path.display())))
}
