//! The mazes on the shelf: figures of the book and of the other sources, and small mazes that each make one point. Their files are in
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

/// Figure 2 of Sakib and others, which their full mapping maps in figure 3.
pub const SAKIB_2: Sample = sample!("sakib-2", "Sakib 2, 3");

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
    sample!("hand-circles", "Finish in a loop"),
    sample!("sakib-1", "Sakib 1"),
    sample!("sums-lap", "A lap"),
    SAKIB_2,
    sample!("parex-1", "PAReX 1"),
    sample!("parex-special-2", "PAReX 2"),
    sample!("cornell-6x4", "Cornell 6×4"),
    sample!("cornell-3x5", "Cornell 3×5"),
    sample!("fast-or-short", "Fast or short"),
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
