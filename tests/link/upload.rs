//! Uploads that break off, everywhere they can: the robot holds the old list or the new, and the page says
//! which.

use line_maze_lab::link::demo::{DemoRobot, Eeprom};
use line_maze_lab::link::keep::Keep;
use line_maze_lab::link::page::{Command, Kept, Sent, State};
use line_maze_lab::link::request::Upload;
use line_maze_lab::link::tune::{Name, Tune};
use line_maze_lab::link::{Letters, frame::crc16};
use proptest::prelude::*;

use crate::bench::{Bench, USB};
use crate::support::figure_3_1;

const OLD: &str = "LRLS";
/// Two data lines.
const NEW: &str = "SSRLSRLSRLSSSRLSRLSRLSSSRLSRLSRLSSSRLSRLSRLSBR";

/// A robot that keeps the old list, with the page connected.
fn with_old() -> Bench {
    let mut bench = Bench::ready();
    bench.command(Command::Send(OLD.parse().unwrap()));
    bench.until(State::Ready);
    assert_eq!(bench.link.snapshot().sent, Sent::New);
    bench
}

fn held(bench: &Bench) -> String {
    let keep = Keep::open(bench.robot.eeprom().unwrap().clone());
    let len = keep.list().unwrap().upload.len;
    (0..len).map(|index| keep.letter(index).unwrap().letter()).collect()
}

/// What the page says after it has read the robot's list is what the robot holds.
fn page_knows(bench: &Bench, what: &str) {
    let held = held(bench);
    let expected = match held.as_str() {
        OLD => Sent::Old,
        NEW => Sent::New,
        _ => panic!("{what}: a mixture: {held}"),
    };
    let sent = bench.link.snapshot().sent;
    assert_eq!(sent, expected, "{what}: {held}\n{}", bench.tail());
    let Kept::List(list) = bench.link.kept() else { panic!("{what}: {:?}", bench.link.kept()) };
    assert_eq!(list.letters, held, "{what}");
}

/// Bytes that a whole upload sends.
fn upload_bytes() -> usize {
    let mut bench = with_old();
    let before = bench.actions.len();
    bench.command(Command::Send(NEW.parse().unwrap()));
    bench.until(State::Ready);
    assert_eq!(held(&bench), NEW);
    bench.sent(before).iter().map(|line| line.len() + 4).sum()
}

#[test]
fn the_cable_is_pulled_after_any_byte() {
    let all = upload_bytes();
    assert!(all > 150);
    let (mut old, mut new) = (0, 0);
    for cut in 0..=all {
        let mut bench = with_old();
        let mut left = cut;
        bench.to_robot = Box::new(move |bytes| {
            let passes = bytes.len().min(left);
            left -= passes;
            bytes[..passes].to_vec()
        });
        bench.command(Command::Send(NEW.parse().unwrap()));
        // What is left of the line hangs in the air; a retry does not come through either.
        bench.wait(300);
        bench.unplug();
        match bench.link.snapshot().sent {
            Sent::Old => assert_eq!(held(&bench), OLD, "{cut}"),
            Sent::New => assert_eq!(held(&bench), NEW, "{cut}"),
            Sent::Unsure => {}
            // It was through before: that was told of a connection that is over.
            Sent::Nothing => {
                assert_eq!(held(&bench), NEW, "{cut}");
                new += 1;
                continue;
            }
            other @ (Sent::Going { .. } | Sent::Differs | Sent::Past) => panic!("{cut}: {other:?}"),
        }
        bench.to_robot = Box::new(|bytes| bytes);
        bench.plugged = true;
        bench.until(State::Ready);
        bench.wait(1_500);
        page_knows(&bench, &format!("{cut} bytes"));
        if held(&bench) == OLD { old += 1 } else { new += 1 }
    }
    assert!(old > 100 && new > 0, "{old} {new}");
}

#[test]
fn the_robot_resets_at_any_moment() {
    for reset_ms in (0..120).step_by(5) {
        let mut bench = with_old();
        bench.command(Command::Send(NEW.parse().unwrap()));
        bench.wait(reset_ms);
        bench.robot.reset(bench.now_ms);
        // The page begins anew by itself.
        bench.wait(4_000);
        bench.until(State::Ready);
        page_knows(&bench, &format!("reset after {reset_ms} ms"));
        assert_eq!(held(&bench), NEW, "{reset_ms}");
    }
}

#[test]
fn the_answers_are_lost() {
    // The robot hears everything, the page nothing.
    let mut bench = with_old();
    bench.command(Command::Send(NEW.parse().unwrap()));
    bench.to_page = Box::new(|_| Vec::new());
    bench.wait(2_000);
    assert_eq!(bench.link.snapshot().sent, Sent::Old);
    assert!(bench.link.notes().any(|note| note.news.text().contains("asked three times")));
}

#[test]
fn a_reading_that_failed_is_done_again() {
    // The commit comes through, no answer to it, and none to the reading that would settle it.
    let mut bench = with_old();
    let before = bench.actions.len();
    bench.command(Command::Send(NEW.parse().unwrap()));
    bench.until_so(|bench| bench.sent(before).iter().any(|line| line.starts_with("turns commit")));
    bench.to_page = Box::new(|_| Vec::new());
    bench.wait(3_100);
    assert_eq!(bench.link.snapshot().sent, Sent::Unsure);
    bench.to_page = Box::new(|bytes| bytes);
    bench.wait(2_000);
    page_knows(&bench, "heard again");
}

#[test]
fn stop_cuts_an_upload_and_tells_which_list_is_kept() {
    for after_ms in (0..80).step_by(5) {
        let mut bench = with_old();
        bench.command(Command::Send(NEW.parse().unwrap()));
        bench.wait(after_ms);
        bench.command(Command::Stop);
        bench.wait(1_000);
        assert_eq!(bench.link.state(), State::Ready);
        page_knows(&bench, &format!("stopped after {after_ms} ms"));
    }
}

/// An upload straight into the memory; whether the power lasted.
fn write(eeprom: Eeprom, id: u16, letters: &str) -> Eeprom {
    let mut keep = Keep::open(eeprom);
    let upload = Upload { id, len: letters.len() as u16, crc: crc16(letters.bytes()) };
    let _ = keep.begin(upload);
    for offset in (0..letters.len()).step_by(40) {
        let piece = Letters::new(&letters[offset..(offset + 40).min(letters.len())]).unwrap();
        let _ = keep.data(id, offset as u16, piece);
    }
    let _ = keep.commit(id);
    keep.close()
}

fn list(eeprom: &Eeprom) -> String {
    let keep = Keep::open(eeprom.clone());
    let Some(list) = keep.list() else { return "none".to_owned() };
    (0..list.upload.len).map(|index| keep.letter(index).unwrap().letter()).collect()
}

/// What is told beside the page's list, and whether the robot's list is known.
fn told(bench: &Bench, here: &str) -> (Sent, bool) {
    (bench.link.sent_beside(Some(here)), *bench.link.kept() != Kept::Unknown)
}

#[test]
fn what_was_sent_is_told_of_this_connection_only() {
    let mut bench = with_old();
    assert_eq!(told(&bench, OLD), (Sent::New, true));
    bench.command(Command::Disconnect);
    assert_eq!(told(&bench, OLD), (Sent::Nothing, false));
    bench.command(Command::Use(USB));
    bench.until(State::Ready);
    bench.wait(500);
    assert_eq!(told(&bench, OLD), (Sent::Nothing, true));
    // Of an upload that is cut off, it is told which list the robot holds.
    bench.command(Command::Send(NEW.parse().unwrap()));
    bench.command(Command::Disconnect);
    assert_eq!(told(&bench, NEW), (Sent::Old, false));
}

#[test]
fn what_was_sent_is_told_as_past_beside_another_list() {
    let mut bench = with_old();
    assert_eq!(told(&bench, NEW), (Sent::Past, true));
    assert_eq!(bench.link.sent_beside(None), Sent::Past);
    assert_eq!(told(&bench, OLD), (Sent::New, true));
    // Read again it is the same; the list that the robot learns is another.
    bench.command(Command::ReadBack);
    bench.wait(500);
    assert_eq!(told(&bench, OLD), (Sent::New, true));
    bench.explore();
    bench.until(State::Ready);
    bench.wait(500);
    assert_eq!(told(&bench, OLD), (Sent::Nothing, true));
}

#[test]
fn the_power_goes_at_any_byte_that_is_written() {
    let whole = write(write(Eeprom::default(), 1, OLD), 2, NEW);
    let before = write(Eeprom::default(), 1, OLD);
    let writes = whole.writes() - before.writes();
    for torn in [0x00, 0xFF, 0xA0, 0xA1, 0xA2, 0x53] {
        for cut in 1..=writes {
            let eeprom = write(before.clone().dies_after(cut, torn), 2, NEW).alive();
            let kept = list(&eeprom);
            assert!(kept == OLD || kept == NEW, "write {cut}, {torn:02X}: {kept}");
            // And the next upload goes through, whatever was left behind.
            assert_eq!(list(&write(eeprom, 3, "RRL")), "RRL", "write {cut}, {torn:02X}");
        }
    }
}

#[test]
fn settings_survive_a_power_loss_at_any_byte() {
    let old = Tune::default().with(Name::Kp, 500).unwrap();
    let new = old.with(Name::Kp, 700).unwrap();
    let set = |eeprom, tune: &Tune| {
        let mut keep = Keep::open(eeprom);
        let _ = keep.set_tune(tune);
        keep.close()
    };
    let before = set(Eeprom::default(), &old);
    let writes = set(before.clone(), &new).writes() - before.writes();
    for torn in [0x00, 0xFF, 0xA0, 0xA1, 0xA2] {
        for cut in 1..=writes {
            let tune = Keep::open(set(before.clone().dies_after(cut, torn), &new).alive()).tune();
            assert!(tune == old || tune == new, "write {cut}, {torn:02X}: {tune:?}");
        }
    }
}

proptest! {
    /// Whatever a memory holds when the robot comes from its box, it starts, and can be written.
    #[test]
    fn any_memory_is_no_matter(bytes in proptest::collection::vec(any::<u8>(), 1024)) {
        use line_maze_lab::link::keep::Memory;
        let mut eeprom = Eeprom::default();
        for (at, byte) in bytes.into_iter().enumerate() {
            eeprom.write(at as u16, byte);
        }
        prop_assert_eq!(list(&write(eeprom, 9, "LLS")), "LLS");
    }
}

#[test]
fn a_list_that_is_kept_stays_without_power() {
    let bench = with_old();
    let eeprom = bench.robot.eeprom().unwrap().clone();
    let mut bench = Bench::new(DemoRobot::with_memory(&figure_3_1(), eeprom, 0).unwrap());
    bench.command(Command::Use(USB));
    bench.until(State::Ready);
    bench.wait(500);
    let Kept::List(list) = bench.link.kept() else { panic!() };
    assert_eq!(list.letters, OLD);
}
