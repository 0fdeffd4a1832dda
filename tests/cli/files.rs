//! Files that are no mazes, from outside.

use super::{linemaze, scratch, with_input};

/// What is in it was not looked at, and how large it is was not measured: neither is told.
#[test]
fn a_file_that_is_too_large_is_called_nothing_else() {
    let large = scratch("large.bin");
    std::fs::File::create(&large).unwrap().set_len(33 << 20).unwrap();
    let path = large.to_str().unwrap();
    for command in ["run", "check"] {
        let said = linemaze(&[command, path]);
        assert_eq!((said.status, said.out.as_str()), (2, ""));
        assert_eq!(said.err, format!("{path}: The file is too large: a maze file has at most 32 MiB.\n"));
    }
    let league = linemaze(&["league", path, "mazes/book-3-1.maze", "--explorers", "book"]);
    assert_eq!(league.status, 1);
    assert!(league.err.contains("too large"), "{}", league.err);
}

/// A file of numbers names no finish, and its start faces a wall: both are set from outside.
#[test]
fn start_and_finish_are_set_by_options() {
    // Two squares, one beside the other, and a third to the north of the second.
    const NUM: &str = "0 0 1 0 1 1\n1 0 0 1 1 0\n0 1 1 1 1 1\n1 1 1 1 0 1\n";
    let run = |args: &[&str]| -> serde_json::Value {
        let said = with_input(&[&["run", "-", "--json", "--explorer", "flood-fill"], args].concat(), NUM);
        serde_json::from_str(&said.out).unwrap_or_else(|error| panic!("{error}: {}", said.err))
    };
    assert_eq!(run(&["--finish", "1,1"])["route_cells"], 2);
    assert_eq!(run(&["--finish", "1,1", "--start", "1,0,W"])["route_cells"], 1);
    let row = "0 0 1 0 1 1\n1 0 1 0 1 0\n2 0 1 0 1 0\n3 0 1 1 1 0\n";
    let centre = with_input(&["run", "-", "--finish", "centre", "--start", "3,0,W", "--json"], row).out;
    assert!(centre.contains("\"route_cells\":1,"), "2,0 is one of the two in the middle: {centre}");
    assert_eq!(run(&["--finish", "0,0", "--finish", "1,0", "--start", "1,1,S"])["route_cells"], 1);
    assert_eq!(run(&["--finish", "none"])["route_cells"], serde_json::Value::Null);
    for command in ["run", "trace", "turns", "compare", "check"] {
        let said = with_input(&[command, "-", "--finish", "1,1", "--start", "0,0,E"], NUM);
        assert_eq!((said.status, said.err.as_str()), (0, ""), "{command}");
    }
    let path = scratch("marked.maze");
    let convert = ["convert", "-", path.to_str().unwrap(), "--finish", "1,1", "--start", "0,0,E"];
    assert_eq!(with_input(&convert, NUM).err, "");
    let text = std::fs::read_to_string(&path).unwrap();
    assert!(text.contains("F\n") && text.contains('>'), "{text}");
}

#[test]
fn a_start_or_finish_that_makes_no_sense_is_told_with_the_lattice() {
    let maze = "line-maze: 1\n\n>---F\n";
    for (args, words) in [
        (["--finish", "7,0"], "--finish 7,0 is off the lattice, which goes from 0,0 to 1,0"),
        (["--start", "0,-1,N"], "--start 0,-1 is off the lattice, which goes from 0,0 to 1,0"),
        (["--finish", "middle"], "a finish is centre, none, or a point X,Y as in 7,8"),
        (["--start", "0,0"], "a start is a point and where the robot faces, X,Y,N, as in 0,0,N"),
    ] {
        let said = with_input(&["run", "-", args[0], args[1]], maze);
        assert_eq!((said.status, said.out.as_str()), (2, ""));
        assert!(said.err.contains(words), "{}", said.err);
    }
}

/// In a league it is only said of files that say nothing themselves.
#[test]
fn a_league_gives_a_finish_to_files_that_name_none() {
    let num = scratch("no-finish.num");
    std::fs::write(&num, "0 0 0 1 1 1\n0 1 1 1 0 1\n").unwrap();
    let csv = |args: &[&str]| {
        let all =
            ["league", num.to_str().unwrap(), "mazes/book-3-1.maze", "--explorers", "book", "--csv", "-"];
        linemaze(&[&all, args].concat()).out
    };
    let outcomes = |csv: &str| -> Vec<String> {
        csv.lines().skip(1).map(|line| line.split(',').nth(2).unwrap().to_owned()).collect()
    };
    assert_eq!(outcomes(&csv(&[])), ["no-finish-reachable", "finish"]);
    assert_eq!(outcomes(&csv(&["--finish", "0,1"])), ["finish", "finish"]);
}
