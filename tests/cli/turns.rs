//! Turn lists, from outside.

use serde_json::{Value, json};

use super::{FIGURE, linemaze, with_input};

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
fn letters_are_reduced_and_turned_round() {
    for (option, letters, list) in [
        ("--reduce", "LBLLBSR", "SRR"),
        ("--reduce", "flu lr", "SSR"),
        ("--reduce", "{'L','B','L'}", "S"),
        ("--reduce", "", ""),
        ("--reverse", "SSR", "LSS"),
        ("--reverse", "←↑→", "LSR"),
    ] {
        let said = linemaze(&["turns", &format!("{option}={letters}")]);
        assert_eq!((said.status, said.out, said.err), (0, format!("{list}\n"), String::new()), "{letters}");
        let said = with_input(&["turns", option, "-"], letters);
        assert_eq!((said.status, said.out, said.err), (0, format!("{list}\n"), String::new()), "{letters}");
    }
    // What one command writes, the other reads.
    for form in ["letters", "json", "csv", "c"] {
        let list = linemaze(&["turns", FIGURE, "--form", form]).out;
        assert_eq!(with_input(&["turns", "--reverse", "-"], &list).out, "LSS\n", "{list}");
        let back = with_input(&["turns", "--reverse", "-", "--form", form], &list).out;
        assert_eq!(with_input(&["turns", "--reverse", "-"], &back).out, "SSR\n", "{back}");
    }
}

#[test]
fn a_wrong_letter_is_named_with_its_place_and_the_cure() {
    let cure = "write L, S or F (straight), R, or B or U (back)\n";
    let typed = linemaze(&["turns", "--reduce", "LSX"]);
    assert_eq!((typed.status, typed.out.as_str()), (2, ""));
    assert_eq!(typed.err, format!("--reduce: character 3 is “X”: {cure}"));
    let piped = with_input(&["turns", "--reverse", "-"], "LS\nR?\n");
    assert_eq!((piped.status, piped.out.as_str()), (2, ""));
    assert_eq!(piped.err, format!("standard input:2:2: “?”: {cure}"));
    let arrow = linemaze(&["turns", "--reduce", "L B L → R"]);
    assert!(arrow.err.contains("character 7 is “→”, an arrow among letters"), "{}", arrow.err);
    for args in [
        &["turns"][..],
        &["turns", FIGURE, "--reduce", "L"],
        &["turns", "--reduce", "L", "--reverse", "L"],
        &["turns", "--reduce", "L", "--explorer", "book"],
        &["turns", "--reverse", "L", "--order", "SLR"],
        &["turns", "--reverse", "L", "--corners"],
    ] {
        let said = linemaze(args);
        assert_eq!((said.status, said.out.as_str()), (2, ""), "{args:?}");
    }
}
