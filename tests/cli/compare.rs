//! Comparisons and random orders, from outside.

use serde_json::Value;

use super::{FIGURE, linemaze, with_input};

#[test]
fn compare_shows_explorers_side_by_side() {
    let said = linemaze(&["compare", FIGURE, "--explorers", "book,right-hand,mapping"]);
    assert_eq!((said.status, said.err.as_str()), (0, ""));
    let book = said.out.lines().find(|line| line.starts_with("A  Book ")).unwrap();
    assert!(book.contains(" 49 ") && book.contains(" 1.00 ") && book.ends_with("finish reached"), "{book}");
    assert!(said.out.contains("circling: stop "), "{}", said.out);
    let parting = "At 0,1, A (stop 1) goes north, and B (stop 1) goes east.";
    assert!(said.out.contains(parting), "{}", said.out);
    let blanks = linemaze(&["compare", FIGURE, "--explorers", " Book, right-hand ,mapping"]);
    assert_eq!((blanks.status, blanks.out), (0, said.out), "{}", blanks.err);
    let objects = linemaze(&["compare", FIGURE, "--json", "--explorers", "book,tremaux"]).out;
    let objects: Vec<Value> = objects.lines().map(|line| serde_json::from_str(line).unwrap()).collect();
    assert_eq!((&objects[0]["explorer"], &objects[1]["explorer"]), (&"book".into(), &"tremaux".into()));
    assert_eq!(objects[0].to_string() + "\n", {
        let run: Value = serde_json::from_str(&linemaze(&["run", FIGURE, "--json"]).out).unwrap();
        run.to_string() + "\n"
    });
    for (explorers, message) in [
        ("book", "2 to 6 explorers are compared, not 1"),
        ("book,book", "“book” is there twice; name each once"),
        ("book, ,mapping", "--explorers <NAMES>: an explorer’s name is missing"),
        ("book,nobody", "invalid value 'nobody'"),
    ] {
        let said = linemaze(&["compare", FIGURE, "--explorers", explorers]);
        assert_eq!(said.status, 2);
        assert!(said.err.contains(message), "{}", said.err);
    }
}

#[test]
fn random_orders_are_a_histogram() {
    let said = linemaze(&["compare", "mazes/long-way.maze", "--random-orders", "200"]);
    assert_eq!((said.status, said.err.as_str()), (0, ""));
    let counts = said.out.lines().filter(|line| line.contains(" cells  "));
    let count = |line: &str| -> u32 { line.split_whitespace().nth(2).unwrap().parse().unwrap() };
    assert_eq!(counts.map(count).sum::<u32>(), 200);
    let worst = said.out.lines().find(|line| line.starts_with("worst")).unwrap();
    let (cells, order) = worst.split_once(" cells, --order ").unwrap();
    let run = linemaze(&["run", "mazes/long-way.maze", "--order", order, "--json"]).out;
    let run: Value = serde_json::from_str(&run).unwrap();
    assert_eq!(format!("worst: {}", run["route_cells"]), cells, "a seed can be opened");
}

/// Its start has two ways: line robots cannot begin there, robots of squares can.
const TWO_WAYS: &str = "mazes/cornell-3x5.maze";

#[test]
fn who_cannot_start_keeps_a_row_and_the_others_run() {
    let said = linemaze(&["compare", TWO_WAYS]);
    assert_eq!((said.status, said.err.as_str()), (0, ""));
    let row = |name: &str| {
        said.out.lines().find(|line| line.starts_with(&format!("{name} "))).unwrap().split_whitespace()
    };
    assert_eq!(row("A  Book").nth(2), Some("-"));
    assert!(
        said.out.contains("  -  cannot start: The start 0,4 has 2 ways: the bot could not"),
        "{}",
        said.out
    );
    assert_eq!(row("D  Full mapping").nth(3), Some("22"));
    // They part from the first that runs.
    assert!(said.out.contains("\nAt 0,4, B (stop 0) goes east, and D (stop 0) goes"), "{}", said.out);
    let objects = linemaze(&["compare", TWO_WAYS, "--json", "--explorers", "book,left-hand"]);
    assert_eq!((objects.status, objects.err.as_str()), (0, ""));
    let objects: Vec<Value> = objects.out.lines().map(|line| serde_json::from_str(line).unwrap()).collect();
    let [absent, run] = &objects[..] else { panic!("{objects:?}") };
    assert_eq!((&absent["explorer"], &absent["outcome"]), (&"book".into(), &"cannot-start".into()));
    assert!(absent["reason"].as_str().unwrap().starts_with("The start 0,4 has 2 ways"), "{absent}");
    let keys = |object: &Value| object.as_object().unwrap().keys().cloned().collect::<Vec<_>>();
    assert_eq!(keys(absent), keys(run), "whoever reads one reads the other");
    assert_eq!(absent.as_object().unwrap().values().filter(|value| value.is_null()).count(), 19);
}

#[test]
fn where_nobody_can_start_there_is_nothing_to_compare() {
    for more in [&[][..], &["--json"]] {
        let said = with_input(&[&["compare", "-"], more].concat(), "line-maze: 1\n\n+---F\n");
        assert_eq!((said.status, said.out.as_str()), (2, ""));
        assert_eq!(
            said.err,
            "standard input: no explorer can start. The maze has no start: put one at the end of a line.\n"
        );
    }
}

/// What a command says on a terminal that its standard error is.
#[cfg(unix)]
fn on_terminal(args: &[&str]) -> String {
    use std::io::Read;

    use rustix::pty::{OpenptFlags, grantpt, openpt, ptsname, unlockpt};

    let terminal = openpt(OpenptFlags::RDWR | OpenptFlags::NOCTTY).unwrap();
    grantpt(&terminal).unwrap();
    unlockpt(&terminal).unwrap();
    let name = ptsname(&terminal, Vec::new()).unwrap();
    let other_side = std::fs::File::options().read(true).write(true).open(name.to_str().unwrap()).unwrap();
    let mut command = super::command(args);
    let mut child = command.stderr(other_side).stdout(std::process::Stdio::null()).spawn().unwrap();
    // The last to have the terminal open is the child: when it ends, so does what can be read.
    drop(command);
    let mut said = Vec::new();
    let _ = std::fs::File::from(terminal).read_to_end(&mut said);
    assert!(child.wait().unwrap().success());
    String::from_utf8(said).unwrap()
}

#[cfg(unix)]
#[test]
fn long_jobs_say_how_far_they_are_on_a_terminal() {
    for (args, of) in [
        (&["compare", FIGURE][..], "/6 "),
        (&["compare", FIGURE, "--random-orders", "30"], "/30 "),
        (&["league", FIGURE], "/1 "),
    ] {
        let said = on_terminal(args);
        assert!(said.contains(of), "{args:?}: {said:?}");
        assert_eq!(linemaze(args).err, "", "{args:?}: elsewhere it is quiet");
    }
}
