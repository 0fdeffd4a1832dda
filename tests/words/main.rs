//! What the learner reads: the sentence of every stop and line, the glossary and the errata.
#![allow(clippy::unwrap_used, clippy::expect_used)]

mod any_run;
mod errata;
mod figures;
mod glossary;
mod names;
#[path = "../support/mod.rs"]
mod support;

use line_maze_lab::explorer::book::narrate::{Narration, narrate};
use line_maze_lab::maze::Maze;
use line_maze_lab::run::explore;
use line_maze_lab::settings::Settings;
use line_maze_lab::trace::{Moment, Trace};

fn walk(maze: &Maze) -> Trace {
    explore(maze, &Settings::default()).unwrap()
}

fn told(trace: &Trace, stop: u32) -> Narration {
    narrate(trace, &trace.frame(Moment::after(stop)))
}
