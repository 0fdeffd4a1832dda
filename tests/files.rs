//! Maze files: what is written can be read again, and what is wrong is named with its place.
#![allow(clippy::unwrap_used, missing_docs)]

mod random;

use line_maze_lab::maze::{file, json, text};
use proptest::prelude::*;

proptest! {
    #![proptest_config(ProptestConfig::with_cases(1000))]

    #[test]
    fn any_maze_survives_text(maze in random::maze(300)) {
        let written = text::write(&maze);
        prop_assert_eq!(text::parse(&written), Ok(maze.clone()), "{}", written);
        let drawn = text::write_drawing(&maze);
        prop_assert_eq!(text::parse(&drawn), Ok(maze.clone()), "{}", drawn);
        prop_assert!(written.len() <= drawn.len(), "{written}\nis larger than\n{drawn}");
        let windows = format!("\u{feff}{}", drawn.trim_end().replace('\n', "  \r\n"));
        prop_assert_eq!(file::read(windows.as_bytes()), Ok(maze), "{}", windows);
    }

    #[test]
    fn any_maze_survives_json(maze in random::maze(300)) {
        let written = json::write(&maze);
        prop_assert_eq!(file::read(written.as_bytes()), Ok(maze), "{}", written);
    }

    #[test]
    fn no_text_is_too_odd_to_be_refused(bytes in prop::collection::vec(any::<u8>(), 0..200), rest in "[ -+.|F^>v<0-9,\nlines:]{0,80}") {
        let _ = file::read(&bytes);
        let _ = text::parse(&format!("line-maze: 1\n\n{rest}"));
        let _ = text::parse(&format!("line-maze: 1\nbounds: 0,0 9,9\n\nlines:\n{rest}"));
    }
}
