//! Files that are no mazes, from outside.

use super::{linemaze, scratch};

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
