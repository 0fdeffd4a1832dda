//! What is shown and said is so: pictures and sentences beside the state that they tell of, over all samples, all
//! explorers and random mazes.
#![allow(clippy::unwrap_used, clippy::expect_used, clippy::panic, missing_docs)]

#[path = "../support/mod.rs"]
mod support;

mod facing;
mod moments;
mod sentences;
