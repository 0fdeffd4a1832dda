//! The virtual robot and the check of real ones, from outside.

use std::io::{Read, Write};
use std::path::Path;

use super::{FIGURE, command, linemaze, scratch, with_input};

/// A robot's words on standard output, to what is typed; it stops when the input ends.
#[test]
fn robot_speaks_on_standard_input_and_output() {
    let mut child = command(&["robot", "--stdio", "--maze", FIGURE, "--quiet"]).spawn().unwrap();
    let mut input = child.stdin.take().unwrap();
    input.write_all(b"hi\nget kp #7\n").unwrap();
    let mut heard = String::new();
    let mut output = child.stdout.take().unwrap();
    // It ends each answer with a line; reading on waits for them.
    let mut byte = [0];
    while heard.matches('\n').count() < 3 {
        output.read_exact(&mut byte).unwrap();
        heard.push(char::from(byte[0]));
    }
    drop(input);
    assert!(child.wait().unwrap().success());
    let lines: Vec<&str> = heard.lines().map(|line| line.split('*').next().unwrap()).collect();
    assert_eq!(lines, ["ready 1 lab-1 demo 50 451", "ok #-", "ok #7 kp 620"]);
}

/// What a robot on standard input says to this, without checksums.
fn typed(more: &[&str], input: &str) -> Vec<String> {
    let said = with_input(&[&["robot", "--stdio", "--maze", FIGURE], more].concat(), input);
    assert_eq!((said.status, said.err.as_str()), (0, ""));
    assert!(said.out.is_empty() || said.out.ends_with('\n'), "{}", said.out);
    said.out.lines().map(|line| line.split('*').next().unwrap().to_owned()).collect()
}

#[test]
fn robot_answers_everything_before_it_ends_with_its_input() {
    const READY: &str = "ready 1 lab-1 demo 50 451";
    assert_eq!(typed(&["--quiet"], "hi"), [""; 0], "half a line is no line");
    assert_eq!(typed(&["--quiet"], "hi\r\nget kp #7\r"), [READY, "ok #-", "ok #7 kp 620"]);
    // Nothing is lost while it starts; and more answers than fit at once are given one after the other.
    let many = "get kp\n".repeat(100);
    let heard = typed(&[], &many);
    let answers = heard.iter().filter(|line| *line == "ok #- kp 620").count();
    assert_eq!((heard[0].as_str(), answers), (READY, 100));
    // A run is driven to its end.
    let heard = typed(&["--hurry", "50"], "place\nwatch all\nrun explore SRL #2*7E\n");
    let end = heard.iter().rposition(|line| line.starts_with("end ")).expect("an end");
    assert!(heard[end].ends_with(" finish"), "{}", heard[end]);
    assert_eq!(heard.iter().filter(|line| line.starts_with("at ")).count(), 25);
}

#[test]
fn robot_wants_a_line_and_a_maze_it_can_start_in() {
    let said = linemaze(&["robot", "--maze", FIGURE]);
    assert_eq!(said.status, 2);
    assert!(said.err.contains("--stdio") && said.err.contains("--pty <PATH>"), "{}", said.err);
    let said = linemaze(&["robot", "--maze", FIGURE, "--stdio", "--pty", "x"]);
    assert_eq!(said.status, 2);
    assert!(said.err.contains("cannot be used with"), "{}", said.err);
    let empty = scratch("nowhere.maze");
    std::fs::write(&empty, "line-maze: 1\n\n+---F\n").unwrap();
    let said = linemaze(&["robot", "--stdio", "--maze", empty.to_str().unwrap()]);
    assert_eq!(said.status, 2);
    assert!(said.err.contains("The maze has no start"), "{}", said.err);
}

/// A child that is stopped whatever happens.
#[cfg(unix)]
struct Robot(std::process::Child);

#[cfg(unix)]
impl Drop for Robot {
    fn drop(&mut self) {
        let _ = self.0.kill();
        let _ = self.0.wait();
    }
}

/// A virtual robot on a pseudo-terminal, as soon as that is there.
#[cfg(unix)]
fn robot_on(link: &Path, more: &[&str]) -> Robot {
    let link = link.to_str().unwrap();
    let mut child = command(&[&["robot", "--pty", link, "--maze", FIGURE], more].concat()).spawn().unwrap();
    let mut byte = [0];
    let output = child.stdout.as_mut().unwrap();
    while byte != *b"\n" {
        output.read_exact(&mut byte).unwrap();
    }
    Robot(child)
}

#[cfg(unix)]
#[test]
fn link_check_finds_the_virtual_robot_in_order_each_time_that_it_is_opened() {
    let link = scratch("robot-in-order");
    let _robot = robot_on(&link, &[]);
    for _ in 0..2 {
        let said = linemaze(&["link-check", "--pty", link.to_str().unwrap()]);
        assert_eq!((said.status, said.err.as_str()), (0, ""), "{}", said.out);
        let kept = said.out.lines().filter(|line| line.starts_with("kept ")).count();
        let untried = said.out.lines().filter(|line| line.starts_with("not tried ")).count();
        assert_eq!((kept, untried), (17, 3), "{}", said.out);
    }
}

#[cfg(unix)]
#[test]
fn link_check_says_what_is_broken_and_what_is_not_there() {
    let link = scratch("robot-at-9600");
    let _robot = robot_on(&link, &["--baud", "9600"]);
    let said = linemaze(&["link-check", "--pty", link.to_str().unwrap()]);
    assert_eq!(said.status, 1, "{}", said.out);
    assert!(said.out.starts_with("BROKEN     hi "), "{}", said.out);
    assert!(said.out.contains("the robot does not answer"), "{}", said.out);
    assert!(said.out.contains("at another rate; try --baud 9600"), "{}", said.out);
    let said = linemaze(&["link-check", "--pty", "/nowhere/robot"]);
    assert_eq!(said.status, 2);
    assert!(said.err.starts_with("/nowhere/robot: "), "{}", said.err);
}

#[cfg(unix)]
#[test]
fn a_robot_replaces_its_old_link_and_no_other_file() {
    let link = scratch("robot-again");
    drop(robot_on(&link, &[]));
    drop(robot_on(&link, &[]));
    let file = scratch("not-a-link");
    std::fs::write(&file, "precious").unwrap();
    let said = linemaze(&["robot", "--pty", file.to_str().unwrap(), "--maze", FIGURE]);
    assert_eq!(said.status, 2);
    assert!(said.err.contains("not-a-link"), "{}", said.err);
    assert_eq!(std::fs::read_to_string(&file).unwrap(), "precious");
}

#[cfg(unix)]
#[test]
fn a_robot_takes_its_link_away_when_a_signal_ends_it() {
    use std::os::unix::process::ExitStatusExt;

    let link = scratch("robot-signalled");
    // `kill` is built into every shell.
    let end = |robot: &mut Robot, signal: &str| {
        let kill = format!("kill -{signal} {}", robot.0.id());
        assert!(std::process::Command::new("sh").args(["-c", &kill]).status().unwrap().success());
        robot.0.wait().unwrap()
    };
    for (name, number) in [("INT", 2), ("TERM", 15)] {
        let mut robot = robot_on(&link, &[]);
        assert!(link.is_symlink());
        assert_eq!(end(&mut robot, name).signal(), Some(number), "it ends as anything would");
        assert!(!link.is_symlink(), "{name} leaves the link behind");
    }
    assert!(!link.with_file_name("robot-signalled.lock").exists());
}

#[cfg(unix)]
#[test]
fn a_robot_that_lives_keeps_its_link() {
    let link = scratch("robot-alone");
    let mut first = robot_on(&link, &[]);
    let target = std::fs::read_link(&link).unwrap();
    let second = || linemaze(&["robot", "--pty", link.to_str().unwrap(), "--maze", FIGURE]);
    let said = second();
    assert_eq!((said.status, said.out.as_str()), (2, ""));
    let who = format!("linemaze (process {}) has it", first.0.id());
    let told = said.err.contains(if cfg!(target_os = "linux") { &who } else { "has it" });
    assert!(said.err.starts_with(link.to_str().unwrap()) && told, "{}", said.err);
    assert_eq!(
        std::fs::read_link(&link).unwrap(),
        target,
        "the first robot's link is not the second's to take"
    );
    // One that was killed has left its link behind, and holds it no longer.
    first.0.kill().unwrap();
    first.0.wait().unwrap();
    assert!(link.is_symlink());
    drop(robot_on(&link, &[]));
}

#[cfg(unix)]
#[test]
fn link_check_has_its_port_alone() {
    let link = scratch("robot-locked");
    let _robot = robot_on(&link, &[]);
    let port = std::fs::OpenOptions::new().read(true).write(true).open(&link).unwrap();
    port.try_lock().unwrap();
    let said = linemaze(&["link-check", "--pty", link.to_str().unwrap()]);
    assert_eq!((said.status, said.out.as_str()), (2, ""));
    let who = format!("(process {}) has it", std::process::id());
    let told = said.err.contains(if cfg!(target_os = "linux") { &who } else { "has it" });
    assert!(said.err.starts_with(link.to_str().unwrap()) && told, "{}", said.err);
}

#[cfg(unix)]
#[test]
fn link_check_ends_when_its_port_goes() {
    let link = scratch("robot-gone");
    let robot = robot_on(&link, &[]);
    let mut check = command(&["link-check", "--pty", link.to_str().unwrap()]).spawn().unwrap();
    // As soon as the first rule is told, it is in the middle of the second.
    let (mut byte, output) = ([0], check.stdout.as_mut().unwrap());
    while byte != *b"\n" {
        output.read_exact(&mut byte).unwrap();
    }
    drop(robot);
    let output = check.wait_with_output().unwrap();
    let said = String::from_utf8(output.stderr).unwrap();
    assert_eq!(output.status.code(), Some(2), "{said}");
    assert!(said.starts_with(link.to_str().unwrap()) && said.contains("the port has gone"), "{said}");
    assert!(!String::from_utf8(output.stdout).unwrap().contains("BROKEN"));
}

/// A sketch on a pseudo-terminal, for as long as the test needs it.
#[cfg(unix)]
fn sketch(slip: super::firmware::Slip) -> std::path::PathBuf {
    use std::ffi::OsStr;
    use std::os::unix::ffi::OsStrExt;

    use rustix::pty::{OpenptFlags, grantpt, openpt, ptsname, unlockpt};
    use rustix::termios::{OptionalActions, tcgetattr, tcsetattr};

    let master = openpt(OpenptFlags::RDWR | OpenptFlags::NOCTTY).unwrap();
    grantpt(&master).unwrap();
    unlockpt(&master).unwrap();
    let name = std::path::PathBuf::from(OsStr::from_bytes(ptsname(&master, Vec::new()).unwrap().as_bytes()));
    // Held open, so that the sketch may speak before and after somebody listens.
    let slave = std::fs::OpenOptions::new().read(true).write(true).open(&name).unwrap();
    let mut settings = tcgetattr(&slave).unwrap();
    settings.make_raw();
    tcsetattr(&slave, OptionalActions::Now, &settings).unwrap();
    std::thread::spawn(move || {
        let (mut master, _slave) = (std::fs::File::from(master), slave);
        let mut firmware = super::firmware::Firmware::new(slip);
        let mut bytes = [0; 256];
        while let Ok(count @ 1..) = master.read(&mut bytes) {
            firmware.hear(&bytes[..count]);
            if master.write_all(&firmware.speak()).is_err() {
                break;
            }
        }
    });
    name
}

#[cfg(unix)]
#[test]
fn link_check_quotes_a_sketch_that_it_does_not_understand() {
    use super::firmware::Slip;

    let port = sketch(Slip::NoSum);
    let said = linemaze(&["link-check", "--pty", port.to_str().unwrap()]);
    assert_eq!((said.status, said.err.as_str()), (1, ""));
    assert!(said.out.contains("“ready 1 my uno 30 400” has no checksum"), "{}", said.out);
    let port = sketch(Slip::CrOnly);
    let said = linemaze(&["link-check", "--pty", port.to_str().unwrap()]);
    assert!(said.out.starts_with("kept       hi "), "{}", said.out);
}
