//! The explorers of the other sources against what those sources print: figures, tables and runs.
#![allow(clippy::unwrap_used, clippy::expect_used, missing_docs)]

mod support;

#[path = "explorers/hands.rs"]
mod hands;
#[path = "explorers/laws.rs"]
mod laws;
#[path = "explorers/lines.rs"]
mod lines;
#[path = "explorers/map.rs"]
mod map;
#[path = "explorers/recordings.rs"]
mod recordings;
#[path = "explorers/squares.rs"]
mod squares;
