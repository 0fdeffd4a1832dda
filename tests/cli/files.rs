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

const FOREIGN: &str = "tests/fixtures/foreign";

/// How a file was read is said where no program looks for results.
#[test]
fn how_a_file_was_read_is_said_on_standard_error() {
    let path = format!("{FOREIGN}/unknown-walls.maze");
    for command in ["run", "trace", "turns", "compare", "check"] {
        let said = linemaze(&[command, &path]);
        let line = format!("{path}:3:6: remark: 3 unknown walls were taken as walls.");
        assert_eq!(said.err.lines().next(), Some(&line[..]), "{command}");
        assert!(!said.out.contains("remark"), "{}", said.out);
    }
    let json = linemaze(&["run", &path, "--json"]);
    assert!(serde_json::from_str::<serde_json::Value>(&json.out).is_ok(), "{}", json.out);
    // What an option says need not be said of the file.
    let num = format!("{FOREIGN}/no-finish.num");
    assert_eq!(linemaze(&["run", &num, "--finish", "centre", "--start", "0,0,E"]).err, "");
    assert_eq!(
        linemaze(&["run", &num, "--start", "0,0,E"]).err,
        format!("{num}: remark: The file names no finish.\n")
    );
}

#[test]
fn check_ends_well_where_there_are_only_warnings() {
    // A square that is closed off, as half of the contests' mazes have.
    let closed = "o---o---o---o\n| S   G |   |\no---o---o   o\n|       |   |\no---o---o---o\n";
    let check = |args: &[&str], input: &str| with_input(&[&["check", "-"], args].concat(), input);
    let apart = check(&[], closed);
    assert_eq!(apart.status, 0, "{}", apart.out);
    assert!(apart.out.contains("warning"), "{}", apart.out);
    assert_eq!(check(&["--strict"], closed).status, 1);
    for (maze, status, strict) in [
        ("line-maze: 1\n\n>---F\n", 0, 0),
        ("line-maze: 1\n\n>---+\n", 0, 1),
        ("line-maze: 1\n\n>---+   F---F\n", 0, 1),
        ("line-maze: 1\n\n^---F\n", 1, 1),
        ("line-maze: 1\n\n+---F\n", 1, 1),
        ("no maze", 2, 2),
    ] {
        assert_eq!((check(&[], maze).status, check(&["--strict"], maze).status), (status, strict), "{maze}");
    }
    let help = linemaze(&["check", "--help"]).out;
    for part in ["--strict", "Exit status: 0 in order, or only warnings; 1 errors", "standard error"] {
        assert!(help.contains(part), "{part}: {help}");
    }
}

/// A start that the book's explorer cannot use: `check` calls it an error and `run` bad input, in every format.
#[test]
fn check_and_run_say_the_same_of_a_start() {
    for (file, status, words) in [
        ("start-faces-a-wall.map", 0, "facing east"),
        ("start-with-two-ways.txt", 1, "Start has several ways out. 0,0 has 2 ways out"),
        ("half-size.maz", 0, "Start is in a square with one way out: 0,0 facing north"),
        ("rows-of-walls.json", 1, "Start has several ways out"),
    ] {
        let path = format!("{FOREIGN}/{file}");
        let (check, run) = (linemaze(&["check", &path]), linemaze(&["run", &path]));
        assert_eq!((check.status, run.status == 2), (status, status == 1), "{file}: {}", run.err);
        assert!(check.out.contains(words), "{}", check.out);
    }
    let other = format!("{FOREIGN}/start-with-two-ways.txt");
    assert_eq!(linemaze(&["run", &other, "--explorer", "flood-fill"]).status, 0, "others can start there");
    assert_eq!(linemaze(&["run", &other, "--start", "1,1,W"]).status, 2, "two ways there too");
}

/// Nothing is out of reach that is not there.
#[test]
fn a_finish_that_no_file_names_is_not_called_out_of_reach() {
    let path = format!("{FOREIGN}/no-finish.num");
    let run = linemaze(&["run", &path]);
    assert_eq!(run.status, 1);
    assert!(run.out.contains("outcome      the file names no finish\n"), "{}", run.out);
    for command in [&["trace"][..], &["turns"], &["compare"], &["run", "--json"]] {
        let said = linemaze(&[&[command[0], &path], &command[1..]].concat());
        let all = said.out + &said.err;
        assert!(all.contains("the file names no finish"), "{command:?}: {all}");
        assert!(!all.contains("no finish reachable"), "{command:?}: {all}");
    }
    let reachable = linemaze(&["run", "mazes/no-finish-reachable.maze"]).out;
    assert!(reachable.contains("outcome      no finish reachable: "), "{reachable}");
}

/// Numbers and bytes have no finish but the centre: another one is left out where that is wanted.
#[test]
fn a_finish_off_the_centre_is_left_out_when_told_to() {
    let from = format!("{FOREIGN}/goals-off-centre.txt");
    let convert = |to: &str, more: &[&str]| {
        let to = scratch(to);
        linemaze(&[&["convert", &from, to.to_str().unwrap()], more].concat())
    };
    for to in ["left-out.num", "left-out.maz"] {
        let refused = convert(to, &[]);
        assert_eq!(refused.status, 2);
        assert!(
            refused.err.contains("leave it out, or write a .txt (--finish none leaves it out)"),
            "{}",
            refused.err
        );
        let written = convert(to, &["--finish", "none"]);
        assert_eq!((written.status, written.err.as_str()), (0, ""));
        let back = linemaze(&["run", scratch(to).to_str().unwrap(), "--finish", "3,3", "--json"]).out;
        assert_eq!(back, linemaze(&["run", &from, "--finish", "3,3", "--json"]).out, "{to}");
    }
    assert_eq!(std::fs::read(scratch("left-out.maz")).unwrap().len(), 16, "4 × 4 squares");
    let large = scratch("large.maz");
    let half = format!("{FOREIGN}/half-size.maz");
    assert_eq!(linemaze(&["convert", &half, large.to_str().unwrap()]).status, 0);
    assert_eq!(std::fs::read(large).unwrap(), std::fs::read(half).unwrap());
}
#[test]
fn convert_writes_to_standard_output_in_the_format_that_is_asked_for() {
    let convert = |args: &[&str]| linemaze(&[&["convert"], args].concat());
    let maze = convert(&["mazes/book-3-1.maze", "-", "--to", "maze"]);
    assert_eq!((maze.status, maze.err.as_str()), (0, ""));
    let file = scratch("same.maze");
    assert_eq!(convert(&["mazes/book-3-1.maze", file.to_str().unwrap()]).err, "");
    assert_eq!(maze.out, std::fs::read_to_string(&file).unwrap());
    let json = with_input(&["convert", "-", "-", "--to", "json"], &maze.out);
    assert!(json.out.starts_with('{'), "{}", json.out);
    assert_eq!(with_input(&["convert", "-", "-", "--to", "maze"], &json.out).out, maze.out);
    assert!(!std::path::Path::new("-").exists());
    let unsaid = convert(&["mazes/book-3-1.maze", "-"]);
    assert_eq!((unsaid.status, unsaid.out.as_str()), (2, ""));
    assert!(unsaid.err.contains("say --to maze, json or svg"), "{}", unsaid.err);
    let refused = convert(&["mazes/book-3-1.maze", "-", "--to", "map"]);
    assert!(refused.err.starts_with("mazes/book-3-1.maze: cannot become a .map: "), "{}", refused.err);
    // The option goes before the extension.
    let odd = scratch("drawing.txt");
    assert_eq!(convert(&["mazes/book-3-1.maze", odd.to_str().unwrap(), "--to", "json"]).err, "");
    assert_eq!(std::fs::read_to_string(&odd).unwrap(), json.out);
}

#[test]
fn a_picture_can_hold_the_route_of_a_run() {
    let picture =
        |args: &[&str]| linemaze(&[&["convert", "mazes/book-3-1.maze", "-", "--to", "svg"], args].concat());
    let plain = picture(&[]).out;
    let route = picture(&["--route"]);
    assert_eq!((route.status, route.err.as_str()), (0, ""));
    // From the start by the nodes to the finish, in millimetres.
    let way = "M200 1200L200 1000L200 600L200 200L800 200L800 400";
    assert_eq!((plain.matches(way).count(), route.out.matches(way).count()), (0, 2), "{}", route.out);
    assert!(route.out.contains("<title>The book’s explorer: 9 cells</title>"), "{}", route.out);
    let other = picture(&["--route", "--explorer", "book", "--order", "LRS", "--finish", "7,0"]).out;
    assert!(other.contains("<title>The book’s explorer: ") && !other.contains(way), "{other}");
    let none = picture(&["--route", "--explorer", "right-hand"]);
    assert_eq!((none.status, none.out.as_str()), (1, ""));
    assert!(none.err.starts_with("mazes/book-3-1.maze: no route: circling: "), "{}", none.err);
    let no_picture = linemaze(&["convert", "mazes/book-3-1.maze", "-", "--to", "json", "--route"]);
    assert_eq!((no_picture.status, no_picture.out.as_str()), (2, ""));
    assert!(no_picture.err.contains("only a picture holds a route"), "{}", no_picture.err);
    for without in [["--explorer", "book"], ["--order", "LRS"]] {
        let said = picture(&without);
        assert_eq!((said.status, said.out.as_str()), (2, ""));
        assert!(said.err.contains("--route"), "{}", said.err);
    }
}

/// What the system says is told without its numbers.
#[test]
fn files_and_folders_that_cannot_be_read_or_written_are_told_plainly() {
    for (args, message) in [
        (&["run", "mazes"][..], "mazes: this is a folder; name a maze file in it\n"),
        (&["check", "nowhere.maze"], "nowhere.maze: No such file or directory\n"),
        (&["convert", "mazes/tree.maze", "nowhere/a.maze"], "nowhere/a.maze: No such file or directory\n"),
        (&["league", "mazes/tree.maze", "--csv", "mazes"], "mazes: Is a directory\n"),
    ] {
        let said = linemaze(args);
        assert_eq!((said.status, said.out.as_str(), said.err.as_str()), (2, "", message), "{args:?}");
    }
}
