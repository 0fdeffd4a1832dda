//! `link-check` against the virtual robot, and against robots that break a rule each.

use line_maze_lab::link::check::{Driving, RULES, Verdict, Wire, check};
use line_maze_lab::link::demo::DemoRobot;

use crate::support::figure_3_1;

/// A robot, and what is done to its words.
struct Rig<F> {
    robot: DemoRobot,
    now_ms: u64,
    spoil: F,
}

impl<F: FnMut(Vec<u8>) -> Vec<u8>> Wire for Rig<F> {
    fn send(&mut self, bytes: &[u8]) {
        self.robot.bytes_in(bytes, self.now_ms);
    }

    fn wait(&mut self, ms: u64) -> Vec<u8> {
        self.now_ms += ms;
        (self.spoil)(self.robot.tick(self.now_ms))
    }
}

fn verdicts(driving: Driving, spoil: impl FnMut(Vec<u8>) -> Vec<u8>) -> Vec<(&'static str, Verdict)> {
    let robot = DemoRobot::new(&figure_3_1(), 0).unwrap();
    let mut verdicts = Vec::new();
    let mut rig = Rig { robot, now_ms: 0, spoil };
    check(&mut rig, driving, |rule, verdict| verdicts.push((rule.name, verdict.clone())));
    assert_eq!(verdicts.len(), RULES.len());
    verdicts
}

/// The rules that are broken.
fn broken(spoil: impl FnMut(Vec<u8>) -> Vec<u8>) -> Vec<&'static str> {
    let broken = |(name, verdict)| matches!(verdict, Verdict::Broken(_)).then_some(name);
    verdicts(Driving::Allowed, spoil).into_iter().filter_map(broken).collect()
}

/// Replaces words in whole lines, and seals them anew.
fn saying(from: &'static str, to: &'static str) -> impl FnMut(Vec<u8>) -> Vec<u8> {
    let mut line = Vec::new();
    move |bytes| {
        let mut out = Vec::new();
        for byte in bytes {
            line.push(byte);
            if byte == b'\n' {
                let text = String::from_utf8(std::mem::take(&mut line)).unwrap();
                let body = text.split('*').next().unwrap().replace(from, to);
                let sum = line_maze_lab::link::frame::crc8(body.as_bytes());
                out.extend(format!("{body}*{sum:02X}\n").into_bytes());
            }
        }
        out
    }
}

#[test]
fn the_virtual_robot_keeps_every_rule() {
    for (name, verdict) in verdicts(Driving::Allowed, |bytes| bytes) {
        assert_eq!(verdict, Verdict::Kept, "{name}");
    }
}

#[test]
fn nothing_drives_unasked() {
    let verdicts = verdicts(Driving::Forbidden, |bytes| bytes);
    let untried: Vec<_> = verdicts
        .iter()
        .filter(|(_, verdict)| matches!(verdict, Verdict::NotTried(_)))
        .map(|(name, _)| *name)
        .collect();
    assert_eq!(untried, ["place", "run", "stop"]);
}

#[test]
fn broken_robots_are_found_out() {
    assert_eq!(broken(|_| Vec::new()), ["hi"]);
    assert_eq!(broken(saying("ready 1", "ready 2")), ["hi"]);
    assert_eq!(broken(saying("kp", "ki")), ["sealed", "damaged", "long", "unknown", "settings"]);
    assert_eq!(broken(saying("end", "fin")), ["stop", "lines"]);
    assert_eq!(broken(saying("beat", "beet")), ["watch", "lines"]);
    assert_eq!(broken(saying("sent", "send")), ["upload", "again", "whole", "room", "lines"]);
    // One line in a hundred is damaged: whatever else that breaks, the lines are.
    let mut count = 0u32;
    let noisy = broken(move |mut bytes| {
        for byte in &mut bytes {
            count += 1;
            if count.is_multiple_of(2_000) {
                *byte ^= 0x80;
            }
        }
        bytes
    });
    assert!(noisy.contains(&"lines"), "{noisy:?}");
}
