//! The mazes on the shelf: the book's figures, and small mazes that each make one point. Their files are in
//! `mazes/`, and `tests/samples.rs` holds each to its claim.

use super::{Bounds, Maze, text};

/// A maze on the shelf.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Sample {
    /// The file's name in `mazes/`, without `.maze`.
    pub file: &'static str,
    /// A few words for the shelf; the maze itself has a longer title.
    pub label: &'static str,
    /// The file.
    pub text: &'static str,
}

impl Sample {
    /// The maze.
    #[must_use]
    pub fn maze(&self) -> Maze {
        // A test reads every sample: none is empty.
        text::parse(self.text).unwrap_or_else(|_| Maze::new(Bounds::default()))
    }
}

macro_rules! sample {
    ($file:literal, $label:literal) => {
        Sample { file: $file, label: $label, text: include_str!(concat!("../../mazes/", $file, ".maze")) }
    };
}

/// The book's figure 2.4.
pub const FIGURE_2_4: Sample = sample!("book-2-4", "2.4 loop");

/// The book's figure 3.1, whose run the book tells stop by stop.
pub const FIGURE_3_1: Sample = sample!("book-3-1", "3.1 the run");

/// All samples, in the shelf's order.
pub const SAMPLES: &[Sample] = &[
    sample!("book-1-1", "1.1 loops"),
    sample!("book-2-2", "2.2 nodes"),
    sample!("book-2-3", "2.3 U-turn"),
    FIGURE_2_4,
    FIGURE_3_1,
    sample!("tree", "A tree"),
    sample!("no-finish-reachable", "No way there"),
    sample!("long-way", "A long way"),
    sample!("sixty-one-nodes", "61 nodes"),
    sample!("turned", "Turned"),
];

/// The book's figure 3.1.
#[must_use]
pub fn figure_3_1() -> Maze {
    FIGURE_3_1.maze()
}

/// The book's figure 2.4.
#[must_use]
pub fn figure_2_4() -> Maze {
    FIGURE_2_4.maze()
}
