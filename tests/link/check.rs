//! `link-check` against the virtual robot, and against robots that break a rule each.

use line_maze_lab::link::check::{Driving, Gone, RULES, Verdict, Wire, check};
use line_maze_lab::link::demo::DemoRobot;

use crate::bench::{moved, retelling, sealed};
use crate::firmware::{Firmware, Slip};
use crate::support::figure_3_1;

/// A robot, and what is done to its words.
struct Rig<F> {
    robot: DemoRobot,
    now_ms: u64,
    spoil: F,
    /// Longer lists are answered `err full`, as by a robot with less room.
    longest: u16,
    refused: Vec<u8>,
    /// What it makes of what it is sent.
    ear: fn(&[u8]) -> Vec<u8>,
    /// When the port goes.
    goes_ms: u64,
}

fn rig<F>(spoil: F) -> Rig<F> {
    let robot = DemoRobot::new(&figure_3_1(), 0).unwrap();
    let ear = |bytes: &[u8]| bytes.to_vec();
    Rig { robot, now_ms: 0, spoil, longest: u16::MAX, refused: Vec::new(), ear, goes_ms: u64::MAX }
}

/// All verdicts of a robot.
fn checked<F: FnMut(Vec<u8>) -> Vec<u8>>(rig: &mut Rig<F>, driving: Driving) -> Vec<(&'static str, Verdict)> {
    let mut verdicts = Vec::new();
    check(rig, driving, |rule, verdict| verdicts.push((rule.name, verdict.clone()))).unwrap();
    assert_eq!(verdicts.len(), RULES.len());
    verdicts
}

impl<F: FnMut(Vec<u8>) -> Vec<u8>> Wire for Rig<F> {
    fn send(&mut self, bytes: &[u8]) -> Result<(), Gone> {
        let bytes = &(self.ear)(bytes)[..];
        let text = String::from_utf8_lossy(bytes);
        let words: Vec<&str> = text.split([' ', '*']).collect();
        match words[..] {
            ["turns", "begin", _, len, _, tag, _] if len.parse().is_ok_and(|len: u16| len > self.longest) => {
                self.refused.extend(sealed(&format!("err {tag} full too long")));
            }
            _ => self.robot.bytes_in(bytes, self.now_ms),
        }
        Ok(())
    }

    fn wait(&mut self, ms: u64) -> Result<Vec<u8>, Gone> {
        self.now_ms += ms;
        if self.now_ms > self.goes_ms {
            return Err(Gone);
        }
        let mut bytes = std::mem::take(&mut self.refused);
        bytes.extend(self.robot.tick(self.now_ms));
        Ok((self.spoil)(bytes))
    }

    fn now_ms(&self) -> u64 {
        self.now_ms
    }
}

fn verdicts(driving: Driving, spoil: impl FnMut(Vec<u8>) -> Vec<u8>) -> Vec<(&'static str, Verdict)> {
    verdicts_with(driving, u16::MAX, spoil)
}

fn verdicts_with(
    driving: Driving,
    longest: u16,
    spoil: impl FnMut(Vec<u8>) -> Vec<u8>,
) -> Vec<(&'static str, Verdict)> {
    let mut rig = rig(spoil);
    rig.longest = longest;
    checked(&mut rig, driving)
}

/// The rules that are broken.
fn broken(spoil: impl FnMut(Vec<u8>) -> Vec<u8>) -> Vec<&'static str> {
    let broken = |(name, verdict)| matches!(verdict, Verdict::Broken(_)).then_some(name);
    verdicts(Driving::Allowed, spoil).into_iter().filter_map(broken).collect()
}

/// Replaces words in whole lines, and seals them anew.
fn saying(from: &'static str, to: &'static str) -> impl FnMut(Vec<u8>) -> Vec<u8> {
    retelling(move |body| Some(body.replace(from, to)))
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

/// A sketch with a slip, in simulated time.
struct Board {
    firmware: Firmware,
    now_ms: u64,
}

impl Wire for Board {
    fn send(&mut self, bytes: &[u8]) -> Result<(), Gone> {
        self.firmware.hear(bytes);
        Ok(())
    }

    fn wait(&mut self, ms: u64) -> Result<Vec<u8>, Gone> {
        self.now_ms += ms;
        Ok(self.firmware.speak())
    }

    fn now_ms(&self) -> u64 {
        self.now_ms
    }
}

/// What is said of a sketch's `hi`.
fn said_of(slip: Slip) -> Verdict {
    let mut board = Board { firmware: Firmware::new(slip), now_ms: 0 };
    let mut verdicts = Vec::new();
    check(&mut board, Driving::Forbidden, |_, verdict| verdicts.push(verdict.clone())).unwrap();
    verdicts.remove(0)
}

#[test]
fn a_sketch_that_keeps_the_first_rule_is_told_so_whatever_ends_its_lines() {
    for slip in [Slip::None, Slip::CrOnly] {
        assert_eq!(said_of(slip), Verdict::Kept, "{slip:?}");
    }
}

#[test]
fn who_is_not_understood_is_quoted_and_told_what_is_wrong() {
    for (slip, quoted, cause) in [
        (
            Slip::NoSum,
            "“ready 1 my uno 30 400”",
            "no checksum: the robot ends every line with * and two digits",
        ),
        (Slip::LowerCase, "“ready 1 my uno 30 400*d8”", "lower-case hex: it must be *D8"),
        (Slip::Xor, "“ready 1 my uno 30 400*", "the XOR of the bytes; it must be the CRC-8"),
        (Slip::FourDigits, "“ready 1 my uno 30 400*00D8”", "exactly two digits"),
        (Slip::Spaces, "“ready  1  my", "single spaces"),
        (Slip::OtherNumber, "“ok #99”", "another number"),
        (Slip::Echo, "“watch al”", "came back as it was sent"),
        (Slip::Sketch, "“Left: ", "another sketch is on the board"),
        (Slip::Noise, "\\x", "speaks at another rate"),
        (Slip::Mute, "", "not a byte came"),
    ] {
        let Verdict::Broken(words) = said_of(slip) else { panic!("{slip:?} is not found out") };
        assert!(words.contains(quoted) && words.contains(cause), "{slip:?}: {words}");
    }
}

#[test]
fn a_port_that_goes_ends_the_check_at_once() {
    for goes_ms in [50, 1_500, 8_000] {
        let mut rig = rig(|bytes| bytes);
        rig.goes_ms = goes_ms;
        let mut told = 0;
        let checked = check(&mut rig, Driving::Allowed, |_, verdict| {
            assert_eq!(*verdict, Verdict::Kept);
            told += 1;
        });
        assert_eq!((checked, told < RULES.len()), (Err(Gone), true), "after {goes_ms} ms");
        assert!(rig.now_ms < goes_ms + 20, "{}", rig.now_ms);
    }
}

#[test]
fn what_makes_life_easier_is_a_remark_and_breaks_nothing() {
    // A robot that drops CRs, as version 1 once had it.
    let whole: fn(Vec<u8>) -> Vec<u8> = |bytes| bytes;
    let mut deaf_to_cr = rig(whole);
    deaf_to_cr.ear = |bytes| bytes.iter().copied().filter(|&byte| byte != b'\r').collect();
    // And one that knows no help.
    let mut helpless = rig(whole);
    helpless.ear = |bytes| String::from_utf8_lossy(bytes).replace("help", "hilf").into_bytes();
    for (mut rig, name, words) in [(deaf_to_cr, "ends", "CR alone"), (helpless, "help", "err verb")] {
        for (rule, verdict) in checked(&mut rig, Driving::Allowed) {
            match verdict {
                Verdict::Remark(said) => {
                    assert!(rule == name && said.contains(words), "{rule}: {said}");
                }
                other => assert!(other == Verdict::Kept && rule != name, "{rule}: {other:?}"),
            }
        }
    }
}

#[test]
fn a_drive_may_lead_a_little_aside_and_no_more() {
    let drifts = |part: i32| retelling(move |line| Some(moved(line, |x, y| (x + y / part, y - x / part))));
    assert_eq!(broken(drifts(10)), [""; 0]);
    assert_eq!(broken(drifts(4)), ["run"]);
}

/// Whatever a robot does, it is told in the words of PROTOCOL.md, never in those of this program.
#[test]
fn no_name_of_the_code_gets_into_the_words() {
    let mut said = Vec::new();
    let mut hear = |verdicts: Vec<(&'static str, Verdict)>| {
        for (_, verdict) in verdicts {
            if let Verdict::Broken(words) | Verdict::Remark(words) = verdict {
                said.push(words);
            }
        }
    };
    for (from, to) in [
        ("kp", "ki"),
        ("ok", "err"),
        ("err", "ok"),
        ("sum", "verb"),
        ("busy", "place"),
        ("sent", "learned"),
        ("turns data", "turns date"),
        ("end", "fin"),
        ("at", "att"),
        ("do", "dot"),
        ("beat", "beet"),
        ("nodes", "knots"),
        ("#", "##"),
    ] {
        hear(verdicts(Driving::Allowed, saying(from, to)));
    }
    // A robot that answers `hi` and nothing else.
    hear(verdicts(
        Driving::Allowed,
        retelling(|line| (line.starts_with("ready") || line == "ok #0").then(|| line.into())),
    ));
    // One that keeps no list.
    hear(verdicts(
        Driving::Allowed,
        retelling(|line| {
            Some(if line.starts_with("turns have") { "err #9 no-list".into() } else { line.to_owned() })
        }),
    ));
    assert!(said.len() > 30, "{}", said.len());
    for words in said {
        let leaks =
            words.contains(['[', ']', '{', '"', '_']) || words.contains("Some") || words.contains("None");
        let calls =
            words.as_bytes().windows(2).any(|pair| pair[0].is_ascii_alphanumeric() && pair[1] == b'(');
        assert!(!leaks && !calls, "{words}");
    }
}
