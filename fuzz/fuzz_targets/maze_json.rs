//! Any text as JSON: refused in words, or read, and then it comes back as it was.
#![no_main]

use libfuzzer_sys::fuzz_target;
use line_maze_lab::maze::{checks, json};

fuzz_target!(|text: &str| {
    match json::parse(text) {
        Err(error) => assert!(!error.to_string().is_empty()),
        Ok(maze) => {
            assert_eq!(json::parse(&json::write(&maze)).as_ref(), Ok(&maze));
            for finding in checks::check(&maze) {
                assert!(!finding.cure_in(maze.kind).is_empty());
            }
        }
    }
});
