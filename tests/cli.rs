//! The command line from outside: what it prints, where, and with which exit status.
#![allow(clippy::unwrap_used, clippy::expect_used)]

use std::io::{Read, Write};
use std::path::{Path, PathBuf};
use std::process::{Command, Stdio};

use expect_test::expect;
use serde_json::{Value, json};

#[path = "cli/compare.rs"]
mod compare;
#[path = "cli/explorers.rs"]
mod explorers;
#[path = "cli/files.rs"]
mod files;
#[path = "support/firmware.rs"]
mod firmware;
#[path = "cli/league.rs"]
mod league;
#[path = "cli/options.rs"]
mod options;
#[path = "cli/robot.rs"]
mod robot;
#[path = "cli/turns.rs"]
mod turns;
#[path = "cli/words.rs"]
mod words;

/// What a command said.
struct Said {
    status: i32,
    out: String,
    err: String,
}

fn linemaze(args: &[&str]) -> Said {
    with_input(args, "")
}

fn with_input(args: &[&str], input: &str) -> Said {
    let mut child = command(args).spawn().unwrap();
    // A command that fails early does not read to the end.
    let _ = child.stdin.take().unwrap().write_all(input.as_bytes());
    let output = child.wait_with_output().unwrap();
    Said {
        status: output.status.code().unwrap(),
        out: String::from_utf8(output.stdout).unwrap(),
        err: String::from_utf8(output.stderr).unwrap(),
    }
}

fn command(args: &[&str]) -> Command {
    let mut command = Command::new(env!("CARGO_BIN_EXE_linemaze"));
    command.current_dir(env!("CARGO_MANIFEST_DIR")).args(args);
    command.stdin(Stdio::piped()).stdout(Stdio::piped()).stderr(Stdio::piped());
    command
}

const FIGURE: &str = "mazes/book-3-1.maze";

/// A file that this test run may write.
fn scratch(name: &str) -> PathBuf {
    Path::new(env!("CARGO_TARGET_TMPDIR")).join(name)
}

#[test]
fn run_reports_for_programs() {
    let said = linemaze(&["run", FIGURE, "--explorer", "book", "--json"]);
    assert_eq!((said.status, said.err.as_str()), (0, ""));
    let report: Value = serde_json::from_str(&said.out).unwrap();
    let expected = json!({
        "explorer": "book", "outcome": "finish", "reason": null, "stops": 25, "decisions": 15,
        "distance_cells": 49, "distance_mm": 9800.0, "turns": "SSR",
        "right_turns": 4, "left_turns": 10, "u_turns": 4, "seconds": 28.0, "memory_bytes": 90, "ptr": 4,
        "route_cells": 9, "route_s": 4.4, "shortest_cells": 9, "shortest_s": 4.4,
        "fastest_cells": 9, "fastest_s": 4.4, "ratio_shortest": 1.0, "ratio_fastest": 1.0,
    });
    assert_eq!(report, expected);
    assert_eq!(said.out.lines().count(), 1);
}

#[test]
fn run_says_null_where_there_is_nothing_to_say() {
    let said = linemaze(&["run", "mazes/no-finish-reachable.maze", "--json"]);
    assert_eq!(said.status, 1);
    let report: Value = serde_json::from_str(&said.out).unwrap();
    assert_eq!(report.as_object().unwrap().len(), 22);
    assert_eq!(report["outcome"], "no-finish-reachable");
    let reason = report["reason"].as_str().unwrap();
    assert!(reason.starts_with("no finish reachable: "), "{reason}");
    for key in [
        "turns",
        "route_cells",
        "route_s",
        "shortest_cells",
        "shortest_s",
        "fastest_cells",
        "fastest_s",
        "ratio_shortest",
        "ratio_fastest",
    ] {
        assert_eq!(report[key], Value::Null, "{key}");
    }
}

#[test]
fn run_tells_people() {
    let said = linemaze(&["run", FIGURE]);
    assert_eq!(said.status, 0);
    expect![[r#"
        The run of the book
        outcome      finish reached
        exploration  49 cells (9800 mm) in 28.0 s
                     25 stops, 15 of them at nodes
                     4 turns to the right, 10 to the left, 4 U-turns
        memory       90 bytes: 6 nodes at once; ptr = 4 at the end
        route        9 cells in 4.4 s: SSR
        shortest     9 cells in 4.4 s; the route is 1.00 times that
        fastest      9 cells in 4.4 s; the route is 1.00 times that
    "#]]
    .assert_eq(&said.out);
}

#[test]
fn settings_change_the_run() {
    let report = |args: &[&str]| -> Value {
        let said = linemaze(&[&["run", FIGURE, "--json"], args].concat());
        assert_eq!(said.err, "");
        serde_json::from_str(&said.out).unwrap()
    };
    assert_eq!(report(&["--speed", "1000"])["seconds"], 18.2);
    assert_eq!(report(&["--turn-s", "0", "--uturn-s", "0"])["seconds"], 19.6);
    assert_eq!(report(&["--turn-s", "0", "--uturn-s", "0", "--stop-s", "2"])["seconds"], 69.6);
    assert_eq!(report(&["--node-max", "3"])["outcome"], "table-full");
    assert_eq!(report(&["--node-max", "3"])["reason"], "node table full (3)");
    assert_eq!(report(&["--epsilon", "1000"])["outcome"], "lost");
    assert_eq!(report(&["--epsilon", "0"])["reason"], "node table full (50)");
    assert_ne!(report(&["--order", "LRS"])["stops"], 25);
    assert_eq!(report(&["--order", "random:7"]), report(&["--order", "random:7"]));
}

/// The specification's table of figure 3.1 in the trace's own words, and the cells crossed out.
#[test]
fn trace_tells_every_stop_of_figure_3_1() {
    let said = linemaze(&["trace", FIGURE, "--json"]);
    assert_eq!((said.status, said.err.as_str()), (0, ""));
    let mut table = String::new();
    for line in said.out.lines() {
        let stop: Value = serde_json::from_str(line).unwrap();
        let keys: Vec<&str> = stop.as_object().unwrap().keys().map(String::as_str).collect();
        assert_eq!(keys.len(), 11);
        let values = [
            "stop",
            "seen",
            "node",
            "at",
            "case",
            "leaves",
            "ptr",
            "returning",
            "cur_x",
            "cur_y",
            "crossed_cells",
        ]
        .map(|key| stop[key].to_string().replace('"', ""));
        table += &format!("{}\n", values.join(" "));
    }
    expect![[r#"
        1 node 1 [0,1] new 0 2 false 0 400 0
        2 node 2 [0,3] new 0 3 false 0 1200 0
        3 corner null [0,5] null 1 3 false 0 2000 0
        4 node 3 [3,5] new 1 4 false 1200 2000 0
        5 corner null [6,5] null 2 4 false 2400 2000 0
        6 node 4 [6,1] new 2 5 false 2400 400 0
        7 corner null [6,0] null 1 5 false 2400 0 0
        8 dead-end null [7,0] dead-end 3 5 true 2800 0 0
        9 corner null [6,0] null 0 5 true 2400 0 1
        10 node 4 [6,1] known 3 5 false 2400 400 2
        11 node 5 [4,1] new 3 6 false 1600 400 2
        12 node 6 [2,1] new 3 7 false 800 400 2
        13 node 1 [0,1] unknown-uturn 1 7 true 0 400 2
        14 node 6 [2,1] known 0 7 false 800 400 4
        15 corner null [2,3] null 3 7 false 800 1200 4
        16 node 2 [0,3] unknown-uturn 1 7 true 0 1200 4
        17 corner null [2,3] null 2 7 true 800 1200 6
        18 node 6 [2,1] known-back 1 6 true 800 400 8
        19 node 5 [4,1] known 0 6 false 1600 400 10
        20 dead-end null [4,2] dead-end 2 6 true 1600 800 10
        21 node 5 [4,1] known-back 1 5 true 1600 400 11
        22 node 4 [6,1] known-back 0 4 true 2400 400 13
        23 corner null [6,5] null 3 4 true 2400 2000 17
        24 node 3 [3,5] known 2 4 false 1200 2000 20
        25 finish null [3,4] null null 4 false 1200 1600 20
    "#]]
    .assert_eq(&table);
}

#[test]
fn trace_tells_people_too() {
    let said = linemaze(&["trace", FIGURE, "--epsilon", "1000"]);
    assert_eq!(said.status, 1);
    expect![[r#"
        stop at      seen     case                   node turn leaves ptr  returning cur_x   cur_y   crossed
        1    0,1     node     new node               1    S    N      2    false     0       400     0
        2    0,3     node     RETURN-UNKNOWN, U-turn 1    B    S      2    true      0       1200    0
        3    0,1     node     RETURN-KNOWN           1    L    E      2    false     0       400     2
        4    2,1     node     RETURN-UNKNOWN, back   1    R    S      1    true      800     400     4
        lost at node 1: there is no line south (2)
    "#]]
    .assert_eq(&said.out);
    let turned = linemaze(&["trace", "mazes/turned.maze", "--explorer", "mapping"]).out;
    assert!(turned.contains("\n2    4,5     dead end nearest                2    B    W "), "{turned}");
    assert!(
        turned.contains("\nN of the robot, where it faced at the start, is the drawing’s west\n"),
        "{turned}"
    );
    let help = linemaze(&["trace", "--help"]).out;
    for column in turned.lines().next().unwrap().split_whitespace() {
        assert!(help.contains(&format!("\n  {column} ")) || help.contains("cur_y: to the north"), "{column}");
    }
}

/// What cannot be written is said, whatever it is; a reader that has enough is no fault.
#[cfg(target_os = "linux")]
#[test]
fn a_full_disk_is_an_error_of_every_command() {
    let commands: [&[&str]; 16] = [
        &["--help"],
        &["-h"],
        &["help"],
        &["help", "run"],
        &["trace", "--help"],
        &["--version"],
        &["run", FIGURE],
        &["run", FIGURE, "--json"],
        &["trace", FIGURE],
        &["turns", FIGURE],
        &["compare", FIGURE],
        &["league", FIGURE],
        &["league", FIGURE, "--csv", "-"],
        &["check", FIGURE],
        &["generate"],
        &["robot", "--stdio", "--quiet", "--maze", FIGURE],
    ];
    for args in commands {
        let full = std::fs::File::options().write(true).open("/dev/full").unwrap();
        let mut child = command(args).stdout(full).spawn().unwrap();
        // The robot says something once it is spoken to, and goes on as long as somebody could speak.
        let mut input = child.stdin.take().unwrap();
        let _ = input.write_all(b"\nhi #0*04\n");
        let output = child.wait_with_output().unwrap();
        let said = String::from_utf8(output.stderr).unwrap();
        assert_eq!(output.status.code(), Some(2), "{args:?}: {said}");
        assert!(said.starts_with("standard output: No space left on device"), "{args:?}: {said}");
        let mut child = command(args).spawn().unwrap();
        drop(child.stdout.take());
        let mut input = child.stdin.take().unwrap();
        let _ = input.write_all(b"\nhi #0*04\n");
        let output = child.wait_with_output().unwrap();
        assert_eq!((output.status.code(), output.stderr), (Some(0), Vec::new()), "{args:?}");
    }
}

#[test]
fn check_names_place_and_cure() {
    let clean = linemaze(&["check", FIGURE]);
    assert_eq!(clean.status, 0);
    assert!(clean.out.starts_with("mazes/book-3-1.maze: in order\n"), "{}", clean.out);
    let found = with_input(&["check", "-"], "line-maze: 1\n\n^---F\n");
    assert_eq!((found.status, found.err.as_str()), (1, ""));
    assert_eq!(
        found.out.lines().next().unwrap(),
        "standard input: error at 0,0: Start faces off its line. The robot at 0,0 faces north, but its line leads \
         east. Turn the start east."
    );
    assert_eq!(with_input(&["check", "-"], "no maze").status, 2);
}

#[test]
fn bad_input_is_named_by_line_and_column() {
    let json = |lines: &str| {
        format!(
            "{{\"format\": \"line-maze/1\", \"kind\": \"line\", \"cell_mm\": 200, \"line_mm\": 20,\n \"start\": {{\"at\": [0, 0], \"heading\": \"N\"}}, \"finish\": [],\n \"lines\": {lines}}}"
        )
    };
    let cases = [
        (String::new(), "standard input:1:1: "),
        ("line-maze: 1\n\n>--x\n".to_owned(), "standard input:3:4: “-”"),
        ("line-maze: 1\nsize: 3\n\n>---F\n".to_owned(), "standard input:2:1: “size” is not a key"),
        ("{\"format\": 1,\n }".to_owned(), "standard input:1:1"),
        (json("[[[0, 0], [1, 1]]]"), "standard input:3:21: lines[0][1]: lines go along the axes"),
        (json("[[[0, 0], [0, 0]]]"), "standard input:3:21: lines[0][1]: this point is the same"),
        (json("[[[0, 0], [0, \"a\"]]]"), "standard input:3:"),
    ];
    for (text, start) in cases {
        for command in ["run", "trace", "check"] {
            let said = with_input(&[command, "-"], &text);
            assert_eq!((said.status, said.out.as_str()), (2, ""), "{text}");
            assert!(said.err.starts_with(start), "{} does not start with {start}", said.err);
        }
    }
    let missing = linemaze(&["run", "mazes/nowhere.maze"]);
    assert_eq!(missing.status, 2);
    assert!(missing.err.starts_with("mazes/nowhere.maze: "), "{}", missing.err);
}

#[test]
fn a_start_that_the_robot_cannot_use_is_bad_input() {
    let said = with_input(&["run", "-"], "line-maze: 1\n\n+---v---F\n");
    assert_eq!((said.status, said.out.as_str()), (2, ""));
    let start =
        "standard input: The start 1,0 has 2 ways: the bot could not know that it is back there. Put it at";
    assert!(said.err.starts_with(start), "{}", said.err);
    assert_eq!(said.err.lines().count(), 1);
}

#[test]
fn generate_prints_a_maze_that_the_others_read() {
    let args = ["generate", "--size", "20x12", "--loops", "0.1", "--dead-ends", "50%", "--seed", "7"];
    let maze = linemaze(&args);
    assert_eq!((maze.status, maze.err.as_str()), (0, ""));
    assert_eq!(maze.out, linemaze(&args).out, "the same seed gives the same maze");
    assert_ne!(maze.out, linemaze(&["generate", "--size", "20x12", "--seed", "8"]).out);
    assert_eq!(with_input(&["check", "-"], &maze.out).status, 0);
    let run = with_input(&["run", "-", "--node-max", "1000"], &maze.out);
    assert_eq!(run.status, 0);
    assert!(run.out.lines().all(|line| line.chars().count() < 110), "{}", run.out);
    let walls = linemaze(&["generate", "--kind", "wall"]);
    assert!(walls.out.contains("kind: wall"), "{}", walls.out);
    for (args, message) in [
        (["--size", "20"], "two whole numbers from 1 to 1000"),
        (["--size", "0x5"], "two whole numbers from 1 to 1000"),
        (["--size", "1x1"], "two points at least"),
        (["--loops", "10"], "from 0 to 1, as in 0.25, or from 0% to 100%"),
        (["--dead-ends", "101%"], "from 0 to 1, as in 0.25, or from 0% to 100%"),
        (["--kind", "paint"], "[possible values: line, wall]"),
    ] {
        let said = linemaze(&["generate", args[0], args[1]]);
        assert_eq!(said.status, 2);
        assert!(said.err.contains(message), "{args:?}: {}", said.err);
    }
}

#[test]
fn convert_goes_by_content_and_by_extension() {
    let (json, back, svg) = (scratch("figure.json"), scratch("figure.maze"), scratch("figure.SVG"));
    let convert = |from: &str, to: &Path| linemaze(&["convert", from, to.to_str().unwrap()]);
    // Whatever a file is called, its content says what it is.
    let disguised = scratch("disguised.maze");
    for (from, to) in [(FIGURE, &json), (json.to_str().unwrap(), &back), (FIGURE, &svg)] {
        let said = convert(from, to);
        assert_eq!((said.status, said.out + &said.err), (0, String::new()));
    }
    std::fs::copy(&json, &disguised).unwrap();
    let report = |path: &Path| linemaze(&["run", path.to_str().unwrap(), "--json"]).out;
    assert_eq!(report(&disguised), report(Path::new(FIGURE)));
    assert_eq!(report(&back), report(Path::new(FIGURE)));
    let document: Value = serde_json::from_str(&std::fs::read_to_string(&json).unwrap()).unwrap();
    assert_eq!(document["format"], "line-maze/1");
    assert!(std::fs::read_to_string(&svg).unwrap().starts_with("<svg"));
    for unknown in ["figure.png", "figure"] {
        let said = convert(FIGURE, &scratch(unknown));
        assert_eq!(said.status, 2);
        assert!(said.err.contains("it is .maze, .json or .svg, or for walls .txt"), "{}", said.err);
        assert!(!scratch(unknown).exists());
    }
    assert_eq!(convert(FIGURE, Path::new("/nowhere/at/all.maze")).status, 2);
}

#[test]
fn walls_go_through_micromouse_files_and_back() {
    let walls =
        linemaze(&["generate", "--kind", "wall", "--size", "16x16", "--seed", "3", "--dead-ends", "0"]).out;
    let walls_path = scratch("walls.maze");
    std::fs::write(&walls_path, &walls).unwrap();
    let convert =
        |from: &Path, to: &Path| linemaze(&["convert", from.to_str().unwrap(), to.to_str().unwrap()]);
    let report = |path: &Path| linemaze(&["run", path.to_str().unwrap(), "--node-max", "999", "--json"]).out;
    let drawn = scratch("walls.txt");
    assert_eq!(convert(&walls_path, &drawn).err, "");
    assert!(std::fs::read_to_string(&drawn).unwrap().starts_with("o---o"), "a drawing of posts and walls");
    assert_eq!(report(&drawn), report(&walls_path));
    let refused = convert(&drawn, &scratch("walls.maz"));
    assert_eq!(refused.status, 2);
    assert!(refused.err.contains("the finish is not written and means the centre"), "{}", refused.err);
    let unfinished = scratch("unfinished.txt");
    std::fs::write(&unfinished, std::fs::read_to_string(&drawn).unwrap().replace('G', " ")).unwrap();
    for (from, to) in
        [("unfinished.txt", "walls.maz"), ("walls.maz", "walls.num"), ("walls.num", "again.txt")]
    {
        let said = convert(&scratch(from), &scratch(to)).err;
        assert!(said.lines().all(|line| line.contains(": remark: ")), "{said}");
    }
    assert_eq!(std::fs::read(scratch("walls.maz")).unwrap().len(), 256);
    assert_eq!(std::fs::read(scratch("again.txt")).unwrap(), std::fs::read(&unfinished).unwrap());
    let lines = convert(Path::new(FIGURE), &scratch("figure.txt"));
    assert_eq!(lines.status, 2);
    assert!(lines.err.contains("this maze is drawn as lines; make its kind “wall” first"), "{}", lines.err);
    let bad = linemaze(&["check", "tests/fixtures/bad/mouse-ragged-short.txt"]);
    assert_eq!(bad.status, 2);
    assert!(
        bad.err.starts_with("tests/fixtures/bad/mouse-ragged-short.txt:2:13: this line has 12"),
        "{}",
        bad.err
    );
}

#[test]
fn a_reader_that_goes_away_is_no_fault() {
    let maze = linemaze(&["generate", "--size", "100x100", "--dead-ends", "0"]).out;
    let path = scratch("large.maze");
    std::fs::write(&path, maze).unwrap();
    let mut child = command(&["trace", path.to_str().unwrap(), "--node-max", "10000"]).spawn().unwrap();
    let mut first = [0; 100];
    child.stdout.take().unwrap().read_exact(&mut first).unwrap();
    let output = child.wait_with_output().unwrap();
    assert_eq!(String::from_utf8(output.stderr).unwrap(), "");
    assert_eq!(output.status.code(), Some(0));
}

#[test]
fn help_teaches() {
    let said = linemaze(&["--help"]);
    assert_eq!(said.status, 0);
    for part in ["Examples:", "linemaze run mazes/book-3-1.maze", "Exit status:", "FILE:LINE:COLUMN"] {
        assert!(said.out.contains(part), "{part}");
    }
    for command in ["run", "trace", "turns", "compare", "league", "check", "generate", "convert"] {
        assert_eq!(linemaze(&[command, "--help"]).status, 0);
    }
    assert_eq!(linemaze(&[]).status, 2);
}
