//! Turn lists, from outside.

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
