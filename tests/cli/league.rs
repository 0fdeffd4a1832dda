//! The league, from outside.

use serde_json::Value;

use super::{linemaze, scratch};

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
    let head =
        format!("{mazes} mazes. Solved: of those with a way to the finish. Columns after it: medians.\n");
    assert!(said.out.starts_with(&(head + "explorer ")), "{}", said.out);
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

/// The two say the same of a run, in the words that a table has.
#[test]
fn the_league_gives_the_reasons_that_a_run_gives() {
    let runs = scratch("reasons.csv");
    for (maze, explorer, words) in [
        ("mazes/cornell-6x4.maze", "mapping", Some("the file names no finish")),
        ("mazes/no-finish-reachable.maze", "mapping", Some("everything is mapped, and no finish was seen")),
        ("tests/fixtures/foreign/no-finish.num", "depth-first", Some("the file names no finish")),
        ("mazes/cornell-6x4.maze", "cornell-1", Some("circling: stop ")),
        ("mazes/no-finish-reachable.maze", "book", Some("no finish reachable: ")),
        ("mazes/book-3-1.maze", "book", None),
    ] {
        let said = linemaze(&["league", maze, "--explorers", explorer, "--csv", runs.to_str().unwrap()]);
        assert_eq!((said.status, said.err.as_str()), (0, ""));
        let csv = std::fs::read_to_string(&runs).unwrap();
        let run = linemaze(&["run", maze, "--explorer", explorer, "--json"]).out;
        let run: Value = serde_json::from_str(&run).unwrap();
        let reason = run["reason"].as_str();
        assert_eq!(reason.is_some(), words.is_some(), "{maze} {explorer}: {reason:?}");
        let reason = reason.unwrap_or_default();
        assert!(reason.starts_with(words.unwrap_or_default()), "{reason}");
        let cell = if reason.contains(',') { format!("\"{reason}\"") } else { reason.to_owned() };
        let start = format!("\n{maze},{explorer},{},{cell},", run["outcome"].as_str().unwrap());
        assert!(csv.contains(&start), "{start} is not in {csv}");
    }
    let people = linemaze(&["run", "mazes/cornell-6x4.maze", "--explorer", "mapping"]);
    assert_eq!(people.status, 0);
    assert!(people.out.contains("\nroute        none: the file names no finish\n"), "{}", people.out);
}

#[test]
fn the_league_goes_down_into_folders_and_leaves_hidden_files_alone() {
    let folder = scratch("folders");
    let _ = std::fs::remove_dir_all(&folder);
    std::fs::create_dir_all(folder.join("b/deeper")).unwrap();
    std::fs::create_dir_all(folder.join(".git")).unwrap();
    for name in ["c.maze", "b/deeper/1.maze", "b/2.maze", "a.maze"] {
        std::fs::copy("mazes/book-3-1.maze", folder.join(name)).unwrap();
    }
    for hidden in [".DS_Store", "b/.hidden.maze", ".git/config"] {
        std::fs::write(folder.join(hidden), [0, 0, 0, 1]).unwrap();
    }
    // A link to where it is would lead down for ever.
    #[cfg(unix)]
    std::os::unix::fs::symlink(&folder, folder.join("b/loop")).unwrap();
    let runs = scratch("folders.csv");
    let league = |path: &std::path::Path| {
        let path = path.to_str().unwrap();
        linemaze(&["league", path, "--explorers", "book", "--csv", runs.to_str().unwrap()])
    };
    let said = league(&folder);
    assert_eq!((said.status, said.err.as_str()), (0, ""));
    let csv = std::fs::read_to_string(&runs).unwrap();
    let courses = csv.lines().skip(1).map(|line| line.split(',').next().unwrap());
    let order = ["a.maze", "b/2.maze", "b/deeper/1.maze", "c.maze"].map(|name| folder.join(name));
    assert!(courses.eq(order.iter().map(|path| path.to_str().unwrap())), "{csv}");
    // Who names it means it.
    let hidden = league(&folder.join(".DS_Store"));
    assert_eq!(hidden.status, 2);
    assert!(hidden.err.contains(".DS_Store:"), "{}", hidden.err);
}

#[test]
fn a_dash_is_standard_output_and_nothing_else_is_written_there() {
    let league = |more: &[&str]| {
        linemaze(&[&["league", "mazes/book-3-1.maze", "--explorers", "book,right-hand"], more].concat())
    };
    let runs = league(&["--csv", "-"]);
    assert_eq!((runs.status, runs.err.as_str()), (0, ""));
    assert!(runs.out.starts_with("course,explorer,outcome,reason,"), "{}", runs.out);
    assert_eq!(runs.out.lines().count(), 3, "{}", runs.out);
    let (file, written) = (scratch("beside.csv"), |path| std::fs::read_to_string(path).unwrap());
    let standings = league(&["--standings-csv", "-", "--csv", file.to_str().unwrap()]);
    assert!(
        standings.out.starts_with("explorer,runs,not_started,solvable,solved,solved_percent,"),
        "{}",
        standings.out
    );
    assert_eq!((standings.out.lines().count(), written(&file)), (3, runs.out));
    let both = league(&["--standings-csv", "-", "--csv", "-"]);
    assert_eq!((both.status, both.out.as_str()), (2, ""));
    assert!(both.err.contains("write one of them into a file"), "{}", both.err);
    assert!(!std::path::Path::new("-").exists());
}

#[test]
fn the_league_takes_lists_as_compare_does() {
    let league = |explorers: &str| linemaze(&["league", "mazes/tree.maze", "--explorers", explorers]);
    let said = league("mapping,book");
    assert_eq!((said.status, said.err.as_str()), (0, ""));
    assert_eq!(league(" Book , mapping").out, said.out);
    for (explorers, message) in [
        ("book,book", "“book” is there twice; name each once"),
        ("book,nobody", "invalid value 'nobody'"),
        ("book, ,mapping", "--explorers <NAMES>: an explorer’s name is missing"),
        ("book,", "an explorer’s name is missing"),
    ] {
        let (league, compare) =
            (league(explorers), linemaze(&["compare", "mazes/tree.maze", "--explorers", explorers]));
        assert_eq!((league.status, league.out.as_str()), (2, ""), "{explorers}");
        assert!(league.err.contains(message), "{}", league.err);
        assert_eq!(league.err, compare.err);
    }
}

#[test]
fn shares_say_of_how_many_and_who_could_not_start_is_named() {
    // The book's robot cannot start in two of the samples, and no way leads to the finish in three.
    let said = linemaze(&["league", "--explorers", "book,mapping"]);
    assert_eq!((said.status, said.err.as_str()), (0, ""));
    let row = |name: &str| -> Vec<String> {
        let row = said.out.lines().find(|line| line.starts_with(&format!("{name} "))).unwrap();
        row[name.len()..].split_whitespace().map(str::to_owned).collect()
    };
    assert_eq!(row("Book")[..6], ["17", "2", "15", "of", "16", "94"]);
    assert_eq!(row("Full mapping")[..6], ["19", "0", "16", "of", "16", "100"]);
    let absent = said.out.split_once("2 runs could not start:\n").unwrap().1;
    assert!(
        absent.starts_with("  Cornell 6×4: The book’s explorer. At the start 0,3 the bot faces"),
        "{absent}"
    );
    assert_eq!(absent.lines().count(), 2);
    let csv = linemaze(&["league", "--explorers", "book,mapping", "--standings-csv", "-"]).out;
    assert!(csv.contains("\nbook,17,2,16,15,93.75,"), "{csv}");
    // Many are not all named.
    let folder = scratch("no-starts");
    let _ = std::fs::remove_dir_all(&folder);
    std::fs::create_dir_all(&folder).unwrap();
    for nth in 0..12 {
        std::fs::write(folder.join(format!("{nth:02}.maze")), "line-maze: 1\n\n+---F\n").unwrap();
    }
    let said = linemaze(&["league", folder.to_str().unwrap(), "--explorers", "book,mapping"]).out;
    let absent = said.split_once("\n24 runs could not start:\n").unwrap().1;
    assert_eq!(absent.lines().count(), 11, "{absent}");
    assert!(absent.contains("00.maze: everybody. The maze has no start: put one"), "{absent}");
    assert!(absent.ends_with("\n  and 2 more; --csv FILE has them all\n"), "{absent}");
}

#[test]
fn a_folder_without_files_is_named() {
    let empty = scratch("empty-folder");
    std::fs::create_dir_all(empty.join("deeper")).unwrap();
    let name = empty.to_str().unwrap();
    let said = linemaze(&["league", name, "mazes/tree.maze", "--explorers", "book"]);
    assert_eq!(said.status, 1);
    assert!(said.err.starts_with(&format!("{name}: this folder holds no files")), "{}", said.err);
    assert!(said.out.starts_with("1 maze. "), "{}", said.out);
    let nothing = linemaze(&["league", name]);
    assert_eq!((nothing.status, nothing.out.as_str()), (2, ""));
    assert!(
        nothing.err.contains(name)
            && nothing.err.ends_with("no maze to run in; name files, or --samples, or --generate N\n"),
        "{}",
        nothing.err
    );
}

/// A file may be called anything; a spreadsheet must not work it out.
#[test]
fn no_cell_of_the_csv_is_a_formula() {
    let path = scratch("formula");
    std::fs::create_dir_all(&path).unwrap();
    std::fs::copy("mazes/tree.maze", path.join("=1+1.maze")).unwrap();
    let mut command = super::command(&["league", "=1+1.maze", "--explorers", "book", "--csv", "-"]);
    let output = command.current_dir(&path).output().unwrap();
    let csv = String::from_utf8(output.stdout).unwrap();
    assert!(csv.contains("\n'=1+1.maze,book,finish,"), "{csv}");
}
