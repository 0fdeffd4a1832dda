//! Any bytes as a micromouse file: refused in words, or read, and then every form that can say the maze comes
//! back as it was.
#![no_main]

use libfuzzer_sys::fuzz_target;
use line_maze_lab::maze::Reading;
use line_maze_lab::maze::micromouse::{Form, read, write};

fuzz_target!(|bytes: &[u8]| {
    match read(bytes) {
        None => {}
        Some(Err(error)) => assert!(!error.to_string().is_empty()),
        Some(Ok(Reading { maze, .. })) => {
            for form in Form::ALL {
                if let Ok(written) = write(&maze, form) {
                    let back = read(&written).expect("it looks like what it is").expect("it is sound").maze;
                    assert_eq!(back.lines().collect::<Vec<_>>(), maze.lines().collect::<Vec<_>>());
                    assert_eq!((back.start(), back.bounds()), (maze.start(), maze.bounds()));
                }
            }
        }
    }
});
