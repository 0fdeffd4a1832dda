//! The virtual robot and the check of real ones, from outside.

use std::io::{Read, Write};
use std::path::Path;

use super::{FIGURE, command, linemaze, scratch};

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

#[test]
fn robot_wants_a_line_and_a_maze_it_can_start_in() {
    let said = linemaze(&["robot", "--maze", FIGURE]);
    assert_eq!(said.status, 2);
    assert!(said.err.contains("--stdio") || said.err.contains("--pty"), "{}", said.err);
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
        assert_eq!((kept, untried), (15, 3), "{}", said.out);
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
    let mut first = robot_on(&link, &[]);
    let _second = robot_on(&link, &[]);
    end(&mut first, "TERM");
    assert!(link.is_symlink(), "the second robot's link is not the first's to take");
}
