//! What people paste, and what is wrong with it.

use super::*;
use crate::route::forms::{Form, write};
use crate::route::{Corners, lab};

fn letters(text: &str) -> alloc::string::String {
    match read(text) {
        Ok(list) => alloc::format!("{list}"),
        Err(why) => alloc::format!("! {why}"),
    }
}

#[test]
fn turn_lists_are_read_as_people_write_them() {
    for (text, list) in [
        ("", ""),
        ("LUL", "LBL"),
        ("FLBLFRFRBL", "SLBLSRSRBL"),
        ("lsrb", "LSRB"),
        ("L B L", "LBL"),
        ("L,S;R-B.L|S/R", "LSRBLSR"),
        ("{'L','B','L'}", "LBL"),
        ("[\"L\", \"B\"]", "LB"),
        ("\"LBLR\"", "LBLR"),
        ("“L” ‘S’ «R»", "LSR"),
        ("←→↑↓", "LRSB"),
        ("⬅\u{fe0f}➡\u{fe0f} ⬆ ⬇", "LRSB"),
        ("Left, right, STRAIGHT, forward, u-turn, back", "LRSSBB"),
        ("const char turns[] = \"SSR\";", "SSR"),
        ("static const char PROGMEM path[4] = {'L', 'S', 'R', '\\0'};", "LSR"),
        ("const int n = 3; // three\nconst char turns[] = \"SSR\"; /* right = home */\n", "SSR"),
        ("String path = \"LSR\"; // not LLL", "LSR"),
        ("path = LSR", "LSR"),
        ("// the list\nSSR // S = straight\n", "SSR"),
        ("/* open", ""),
        ("// one\rSSR\r// three", "SSR"),
        ("\u{feff}SSR\r\n", "SSR"),
        ("number,letter,turn\n1,S,straight\n2,R,right\n", "SR"),
        ("Letter;Turn\r\n\"l\";left\r\n\r\nB;back\r\n", "LB"),
        ("{\"maze\":\"LBL = S\",\"corners\":false,\"turns\":\"SSR\"}\n", "SSR"),
        ("{\"turns\": \"\"}", ""),
    ] {
        assert_eq!(letters(text), list, "{text}");
    }
}

#[test]
fn what_is_no_turn_is_named_with_its_place_and_a_cure() {
    let cure = "write L, S or F (straight), R, or B or U (back)";
    for (text, error) in [
        ("LSX", alloc::format!("character 3 is “X”: {cure}")),
        ("L 4", alloc::format!("character 3 is “4”: {cure}")),
        ("LS\r\nLR\rLtR", alloc::format!("line 3, character 2 is “t”: {cure}")),
        ("LS\nLtR", alloc::format!("line 2, character 2 is “t”: {cure}")),
        ("lefts", alloc::format!("character 2 is “e”: {cure}")),
        ("char turns[] = \"SXR\";", alloc::format!("character 18 is “X”: {cure}")),
        ("number,letter\n1,S\n2,Q\n", alloc::format!("line 3, character 3 is “Q”: {cure}")),
        ("{\"turns\": \"SXR\"}", alloc::format!("character 13 is “X”: {cure}")),
        (
            "L B L → R",
            "character 7 is “→”, an arrow among letters: write letters only, or arrows only".into(),
        ),
        (
            "LBL = S",
            "character 5 is a sign with turns on both sides: keep one side, the list to be read".into(),
        ),
        (
            "{\"turns\": \"SSR\"",
            "character 15 is where this stops being JSON: mend it, or give the letters alone".into(),
        ),
        (
            "{\"outcome\": \"stuck\", \"turns\": null}",
            "character 22 is an object without a list in “turns”: choose a run that left a route".into(),
        ),
    ] {
        assert_eq!(letters(text), alloc::format!("! {error}"), "{text}");
    }
}

#[test]
fn every_form_that_is_written_is_read() {
    for text in ["", "S", "SSR", "LBLLBSR"] {
        let list = read(text).unwrap();
        for form in Form::ALL {
            for title in ["", "The run of the book", "a = \"b\"; // *LSR*", "/* letter */"] {
                let written = write(&list, form, Corners::LeftOut, title);
                assert_eq!(read(&written), Ok(list.clone()), "{written}");
            }
        }
    }
}

#[test]
fn the_lab_reduces_what_it_reads() {
    let left = |text: &str| alloc::format!("{}", lab::reductions(&read(text).unwrap()).1);
    assert_eq!(left("LBLLBSR"), "SRR");
    assert_eq!(left("fLuLfRfRuL"), left("SLBLSRSRBL"));
}
