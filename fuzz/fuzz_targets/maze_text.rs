//! Any bytes as a maze file: refused in words, or read, and then both forms of it come back as they were.
#![no_main]

use libfuzzer_sys::fuzz_target;
use line_maze_lab::maze::{Reading, file, text};

fuzz_target!(|bytes: &[u8]| {
    match file::read(bytes) {
        Err(error) => assert!(!error.to_string().is_empty()),
        Ok(Reading { maze, .. }) => {
            assert_eq!(text::parse(&text::write(&maze)).as_ref(), Ok(&maze));
            assert_eq!(text::parse(&text::write_drawing(&maze)).as_ref(), Ok(&maze));
        }
    }
});
