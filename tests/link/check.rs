//! `link-check` against the virtual robot, and against robots that break a rule each.

use line_maze_lab::link::check::{Driving, RULES, Verdict, Wire, check};
use line_maze_lab::link::demo::DemoRobot;

use crate::support::figure_3_1;

/// A robot, and what is done to its words.
struct Rig<F> {
    robot: DemoRobot,
    now_ms: u64,
    spoil: F,
    /// Longer lists are answered `err full`, as by a robot with less room.
    longest: u16,
    refused: Vec<u8>,
}

impl<F: FnMut(Vec<u8>) -> Vec<u8>> Wire for Rig<F> {
    fn send(&mut self, bytes: &[u8]) {
        let text = String::from_utf8_lossy(bytes);
        let words: Vec<&str> = text.split([' ', '*']).collect();
        match words[..] {
            ["turns", "begin", _, len, _, tag, _] if len.parse().is_ok_and(|len: u16| len > self.longest) => {
                self.refused.extend(sealed(&format!("err {tag} full too long")));
            }
            _ => self.robot.bytes_in(bytes, self.now_ms),
        }
    }

    fn wait(&mut self, ms: u64) -> Vec<u8> {
        self.now_ms += ms;
        let mut bytes = std::mem::take(&mut self.refused);
        bytes.extend(self.robot.tick(self.now_ms));
        (self.spoil)(bytes)
    }

    fn now_ms(&self) -> u64 {
        self.now_ms
    }
}

fn sealed(body: &str) -> Vec<u8> {
    format!("{body}*{:02X}\n", line_maze_lab::link::frame::crc8(body.as_bytes())).into_bytes()
}

fn verdicts(driving: Driving, spoil: impl FnMut(Vec<u8>) -> Vec<u8>) -> Vec<(&'static str, Verdict)> {
    verdicts_with(driving, u16::MAX, spoil)
}

fn verdicts_with(
    driving: Driving,
    longest: u16,
    spoil: impl FnMut(Vec<u8>) -> Vec<u8>,
) -> Vec<(&'static str, Verdict)> {
    let robot = DemoRobot::new(&figure_3_1(), 0).unwrap();
    let mut verdicts = Vec::new();
    let mut rig = Rig { robot, now_ms: 0, spoil, longest, refused: Vec::new() };
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
                out.extend(sealed(&body));
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
fn a_robot_with_little_room_keeps_every_rule_too() {
    for room in [1, 12, 24, 40] {
        let told: &'static str = Box::leak(format!(" 50 {room}").into_boxed_str());
        for (name, verdict) in verdicts_with(Driving::Allowed, room, saying(" 50 451", told)) {
            let tried = room >= 24 || name != "whole";
            assert!(verdict == Verdict::Kept || !tried, "{name} with room for {room}: {verdict:?}");
        }
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
