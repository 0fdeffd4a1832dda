//! Turn lists, comparisons and the league, from outside.

use serde_json::{Value, json};

use super::{FIGURE, linemaze, scratch};

#[test]
fn turns_prints_the_list_in_every_form() {
    let turns = |args: &[&str]| linemaze(&[&["turns", FIGURE], args].concat());
    assert_eq!(turns(&[]).out, "SSR\n");
    assert_eq!(turns(&["--corners"]).out, "SSRR\n");
    assert_eq!(turns(&["--form", "c"]).out, "const char turns[] = \"SSR\"; // The run of the book\n");
    assert_eq!(turns(&["--form", "csv", "--explorer", "mapping"]).out.lines().count(), 4);
    let json: Value = serde_json::from_str(&turns(&["--form", "json", "--corners"]).out).unwrap();
    assert_eq!(json, json!({"maze": "The run of the book", "corners": true, "turns": "SSRR"}));
    let none = turns(&["--explorer", "right-hand"]);
    assert_eq!((none.status, none.out.as_str()), (1, ""));
    assert!(none.err.contains("no turn list: circling"), "{}", none.err);
}

#[test]
fn compare_shows_explorers_side_by_side() {
    let said = linemaze(&["compare", FIGURE, "--explorers", "book,right-hand,mapping"]);
    assert_eq!((said.status, said.err.as_str()), (0, ""));
    let book = said.out.lines().find(|line| line.starts_with("book ")).unwrap();
    assert!(book.contains(" 49 ") && book.contains(" 1.00 ") && book.ends_with("finish reached"), "{book}");
    assert!(said.out.contains("circling: stop "), "{}", said.out);
    let parting = "At 0,1 (stop 1) book goes north and right-hand (stop 1) goes east.";
    assert!(said.out.contains(parting), "{}", said.out);
    let objects = linemaze(&["compare", FIGURE, "--json", "--explorers", "book,tremaux"]).out;
    let objects: Vec<Value> = objects.lines().map(|line| serde_json::from_str(line).unwrap()).collect();
    assert_eq!((&objects[0]["explorer"], &objects[1]["explorer"]), (&"book".into(), &"tremaux".into()));
    assert_eq!(objects[0].to_string() + "\n", {
        let run: Value = serde_json::from_str(&linemaze(&["run", FIGURE, "--json"]).out).unwrap();
        run.to_string() + "\n"
    });
    for (explorers, message) in [
        ("book", "2 to 6 explorers are compared, not 1"),
        ("book,book", "book is there twice"),
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

#[test]
fn the_league_runs_over_files_folders_samples_and_generated_mazes() {
    let (runs, standings) = (scratch("runs.csv"), scratch("standings.csv"));
    let said = linemaze(&[
        "league",
        "mazes",
        "tests/fixtures/bad/tab.maze",
        "--generate",
        "3",
        "--size",
        "6x6",
        "--explorers",
        "mapping,book",
        "--csv",
        runs.to_str().unwrap(),
        "--standings-csv",
        standings.to_str().unwrap(),
    ]);
    assert_eq!(said.status, 1, "one file could not be read");
    assert!(said.err.starts_with("tests/fixtures/bad/tab.maze:4:2: "), "{}", said.err);
    let mazes = std::fs::read_dir("mazes").unwrap().count() + 3;
    let csv = std::fs::read_to_string(&runs).unwrap();
    assert!(said.out.starts_with(&format!("{mazes} mazes; medians\nexplorer")), "{}", said.out);
    assert_eq!(csv.lines().count(), 1 + 2 * mazes);
    let page = include_str!("../../docs/formats.md");
    assert!(page.contains(csv.lines().next().unwrap()), "the head is documented");
    assert!(
        csv.contains("\nmazes/book-3-1.maze,book,finish,,25,49,9800,4,10,4,28,90,9,4.4,9,4.4,9,4.4,1,1\n"),
        "{csv}"
    );
    assert_eq!(std::fs::read_to_string(&standings).unwrap().lines().count(), 3);
    let samples = linemaze(&["league", "--explorers", "book"]);
    assert_eq!((samples.status, samples.err.as_str()), (0, ""));
    let nothing = linemaze(&["league", "tests/fixtures/bad/tab.maze"]);
    assert_eq!(nothing.status, 2);
    assert!(nothing.err.contains("no maze to run in"), "{}", nothing.err);
}
