//! Values that an option cannot have: the message says what it can have.

use super::{FIGURE, linemaze};

#[test]
fn arguments_out_of_range_say_what_is_possible() {
    let cases: [(&[&str], &str); 19] = [
        (&["--explorer", "third-hand"], "[possible values: book, left-hand, right-hand, "),
        (&["--order", "SRB"], "an order is S, R and L once each"),
        (&["--order", "random:"], "random: and a whole number"),
        (&["--epsilon", "-1"], "a whole number from 0 to 4294967295 is wanted"),
        (&["--epsilon", "x"], "invalid value 'x' for '--epsilon <MS>': a whole number from 0 to 4294967295"),
        (&["--node-max", "0"], "a whole number from 1 to 1048575 is wanted"),
        (&["--node-max", "1048576"], "a whole number from 1 to 1048575 is wanted"),
        (&["--speed", "0"], "a speed is a number above 0"),
        (&["--speed", "inf"], "a speed is a number above 0"),
        (&["--speed", "NaN"], "a speed is a number above 0"),
        (
            &["--speed", "0.01"],
            "--speed 0.01: a cell of 200 mm would take longer than 2000 s; choose 0.1 or more",
        ),
        (&["--turn-s", "61"], "from 0 to 60"),
        (&["--uturn-s=-1"], "from 0 to 60"),
        (&["--stop-s", "NaN"], "from 0 to 60"),
        (&["--stop-s", "-0.5"], "from 0 to 60"),
        (&["--turn-s", "-1"], "from 0 to 60"),
        (&["--speed", "-5"], "a speed is a number above 0"),
        (&["--node-max", "-3"], "a whole number from 1 to 1048575 is wanted"),
        (&["--path-max", "-3"], "a whole number from 1 to 4294967295 is wanted"),
    ];
    for (args, message) in cases {
        let said = linemaze(&[&["run", FIGURE], args].concat());
        assert_eq!((said.status, said.out.as_str()), (2, ""), "{args:?}");
        assert!(said.err.contains(message), "{args:?}: {}", said.err);
    }
}

/// What is below 0 is a value that is out of range, not an option that nobody knows.
#[test]
fn numbers_below_0_are_told_what_is_possible() {
    let robot = ["robot", "--stdio", "--maze", FIGURE];
    let cases: [(&[&str], [&str; 2], &str); 10] = [
        (&["generate"], ["--size", "-3x5"], "two whole numbers from 1 to 1000"),
        (&["generate"], ["--loops", "-1"], "from 0 to 1, as in 0.25, or from 0% to 100%"),
        (&["generate"], ["--dead-ends", "-1%"], "from 0 to 1, as in 0.25, or from 0% to 100%"),
        (&["generate"], ["--seed", "-1"], "a whole number from 0 to 18446744073709551615 is wanted"),
        (&["league"], ["--generate", "-1"], "a whole number from 1 to 100000 is wanted"),
        (&["compare", FIGURE], ["--random-orders", "-1"], "a whole number from 1 to 1000000 is wanted"),
        (&robot, ["--faults", "-1"], "a whole number from 0 to"),
        (&robot, ["--baud", "-1"], "a whole number from 300 to 4000000 is wanted"),
        (&robot, ["--hurry", "-1"], "a whole number from 1 to 100 is wanted"),
        (&["link-check", "--pty", "port"], ["--baud", "-1"], "a whole number from 300 to 4000000 is wanted"),
    ];
    for (command, [option, value], message) in cases {
        let said = linemaze(&[command, &[option, value]].concat());
        assert_eq!((said.status, said.out.as_str()), (2, ""), "{command:?} {option}");
        let start = format!("error: invalid value '{value}' for '{option} <");
        assert!(said.err.starts_with(&start) && said.err.contains(message), "{option}: {}", said.err);
    }
}

/// A recipe keeps whole per cent: what is between them is refused, not rounded.
#[test]
fn shares_go_in_steps_of_a_hundredth() {
    let maze = |loops: &str| linemaze(&["generate", "--loops", loops]);
    // Some of these are not quite whole once they are multiplied by 100.
    for percent in [0, 1, 7, 14, 28, 29, 55, 56, 57, 58, 99, 100] {
        let said = maze(&format!("{}", f64::from(percent) / 100.0));
        assert_eq!((said.status, said.out), (0, maze(&format!("{percent}%")).out), "{percent}%");
    }
    for (share, nearest) in [("0.004", "0%"), ("0.256", "26%"), ("33.4%", "33%")] {
        let said = maze(share);
        assert_eq!((said.status, said.out.as_str()), (2, ""), "{share}");
        let message = format!("a share goes in steps of 0.01, which is 1%; the nearest is {nearest}");
        assert!(said.err.contains(&message), "{}", said.err);
    }
    let help = linemaze(&["generate", "--help"]).out;
    assert!(
        help.split_whitespace().collect::<Vec<_>>().join(" ").contains("0 to 1 in steps of 0.01"),
        "{help}"
    );
}

/// What nobody can read is not repeated.
#[test]
fn long_values_are_echoed_short() {
    let long = "9".repeat(300);
    let cases: [&[&str]; 12] = [
        &["run", FIGURE, "--node-max", &long],
        &["run", FIGURE, "--order", &long],
        &["run", FIGURE, "--explorer", &long],
        &["run", FIGURE, "--rule", &long],
        &["run", FIGURE, "--speed", &long],
        &["run", FIGURE, "--speed", "1e-300"],
        &["run", FIGURE, &long],
        &["run", FIGURE, &format!("--{long}")],
        &["generate", "--size", &format!("{long}x5")],
        &["generate", "--seed", &long],
        &["compare", FIGURE, "--random-orders", &long],
        &[&long],
    ];
    for args in cases {
        let said = linemaze(args);
        assert_eq!((said.status, said.out.as_str()), (2, ""), "{}", said.err);
        assert!(!said.err.contains(&long[..30]) && !said.err.contains(&"0".repeat(30)), "{}", said.err);
        let echo = said.err.contains("999999999999999999999999…") || said.err.contains("--9999");
        assert!(echo || said.err.starts_with("--speed 0.0000"), "{}", said.err);
        assert!(said.err.lines().all(|line| line.chars().count() < 260), "{}", said.err);
    }
}

/// Blanks come with what is pasted.
#[test]
fn blanks_around_a_value_are_no_matter() {
    let plain = linemaze(&["run", FIGURE, "--node-max", "5", "--speed", "250", "--turn-s", "1"]);
    let blank = linemaze(&["run", FIGURE, "--node-max", " 5", "--speed", "250 ", "--turn-s", " 1 "]);
    assert_eq!((blank.status, blank.err, blank.out), (plain.status, plain.err, plain.out));
    let maze = linemaze(&["generate", "--size", "9 x 6", "--loops", " 30% ", "--seed", " 7"]);
    let same = linemaze(&["generate", "--size", "9x6", "--loops", "0.3", "--seed", "7"]);
    assert_eq!((maze.err, maze.out), (String::new(), same.out));
}
