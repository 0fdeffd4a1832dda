//! Turn lists and comparisons, from outside.

use serde_json::{Value, json};

use super::{FIGURE, linemaze};

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
