//! Numbers of things, as people read them.

use super::{linemaze, with_input};

/// One cell and no node on the way.
const ONE: &str = "line-maze: 1\n\n>---F\n";
/// A node with a side line, which is driven first if straight on comes last: one U-turn.
const SIDE: &str = "line-maze: 1\n\n>---+---F\n    |\n    +\n";

#[test]
fn one_of_a_thing_is_singular() {
    let said = |args: &[&str], maze| {
        let said = with_input(args, maze);
        assert_eq!((said.status, said.err.as_str()), (0, ""), "{args:?}");
        said.out
    };
    let run = said(&["run", "-"], ONE);
    for line in [
        "exploration  1 cell (200 mm) in 0.4 s",
        "             1 stop, 0 of them at nodes",
        "             0 turns to the right, 0 to the left, 0 U-turns",
        "route        1 cell in 0.4 s: no node on the way",
        "shortest     1 cell in 0.4 s; the route is 1.00 times that",
    ] {
        assert!(run.lines().any(|said| said == line), "{line} is not in {run}");
    }
    let run = said(&["run", "-", "--order", "LRS"], SIDE);
    assert!(run.contains(" 2 turns to the right, 0 to the left, 1 U-turn\n"), "{run}");
    assert!(run.contains(" 15 bytes: 1 node at once; "), "{run}");
    let compared = said(&["compare", "-"], ONE);
    assert!(compared.contains("\nthe shortest route: 1 cell in 0.4 s\n"), "{compared}");
    let orders = said(&["compare", "-", "--random-orders", "1"], ONE);
    assert!(orders.starts_with("           1 cell       1  #"), "{orders}");
    assert!(orders.contains("\n1 route; 0 runs left none\n"), "{orders}");
    assert!(orders.contains("\nthe shortest there is has 1 cell: 1 run found one\n"), "{orders}");
    assert!(orders.contains("\nbest : 1 cell, --order random:1\n"), "{orders}");
    assert!(said(&["league", "-"], ONE).starts_with("1 maze. Solved: "));
}

/// What is for programs has hyphens; people read `next way`, not `next-way`.
#[test]
fn tables_for_people_show_no_names_for_programs() {
    let mut all = linemaze(&["league", "--generate", "2", "--samples"]).out;
    for maze in ["mazes/book-3-1.maze", "mazes/cornell-3x5.maze", "mazes/no-finish-reachable.maze"] {
        all +=
            &linemaze(&["compare", maze, "--explorers", "book,left-hand,parex-left,cornell-2,depth-first"])
                .out;
        for name in
            ["book", "left-hand", "direction-sum-left", "mapping", "parex-right", "cornell-3", "tremaux"]
        {
            all += &linemaze(&["trace", maze, "--explorer", name]).out;
            all += &linemaze(&["run", maze, "--explorer", name]).out;
        }
    }
    for shown in ["RETURN-UNKNOWN, U-turn", "dead end", "on route", "cannot start: ", "Direction sums, left"]
    {
        assert!(all.contains(shown), "{shown}");
    }
    let slug = |word: &&str| {
        word.contains('-')
            && word.len() > 1
            && word.chars().all(|c| c.is_ascii_lowercase() || c.is_ascii_digit() || c == '-')
            && word.starts_with(|c: char| c.is_ascii_lowercase())
    };
    let found: Vec<&str> = all.split(|c: char| !c.is_alphanumeric() && c != '-').filter(slug).collect();
    assert!(found.is_empty(), "{found:?}");
}
