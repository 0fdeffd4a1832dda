//! Where several runs part: at the first parting they fall into groups by where they go on to, and each group
//! may part again.

use alloc::format;
use alloc::string::{String, ToString};
use alloc::vec::Vec;

use super::parting::{Side, first, side_after};
use crate::geometry::Point;
use crate::maze::Maze;
use crate::run::AnyRun;

/// A place where runs that came there in the same way go on in different ones.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Fork {
    /// Where.
    pub at: Point,
    /// Cells that they all have driven up to there.
    pub cells: u32,
    /// Who, by the place in the line-up, and what each does.
    pub sides: Vec<(usize, Side)>,
}

/// All partings, the earliest first.
///
/// ```
/// use line_maze_lab::compare::forks::forks;
/// use line_maze_lab::explorer::name::Name;
/// use line_maze_lab::{maze::samples, run::record, settings::Settings};
/// let (maze, settings) = (samples::figure_3_1(), Settings::default());
/// let left = record(&maze, &settings, Name::LeftHand)?;
/// let right = record(&maze, &settings, Name::RightHand)?;
/// let forks = forks(&maze, &[&right, &left, &right]);
/// assert_eq!(forks.len(), 1);
/// assert_eq!(forks[0].words(), "At 0,1, after 1 cell: A and C go east; B goes north.");
/// # Ok::<(), line_maze_lab::world::CannotStart>(())
/// ```
#[must_use]
pub fn forks(maze: &Maze, runs: &[&AnyRun]) -> Vec<Fork> {
    let Some(start) = maze.start() else { return Vec::new() };
    let mut found = Vec::new();
    let mut groups: Vec<Vec<usize>> = alloc::vec![(0..runs.len()).collect()];
    while let Some(group) = groups.pop() {
        let Some((&pivot, others)) = group.split_first() else { continue };
        // All agree with the first until one doesn't: then none of them parts from another earlier.
        let partings = others.iter().filter_map(|&other| first(maze, runs[pivot], runs[other]));
        let Some(cells) = partings.map(|parting| parting.cells).min() else { continue };
        let at = side_after(start, runs[pivot], cells).0;
        let sides: Vec<(usize, Side)> =
            group.iter().map(|&nth| (nth, side_after(start, runs[nth], cells).1)).collect();
        for (nth, (who, side)) in sides.iter().enumerate() {
            let same = |(_, other): &&(usize, Side)| other.leaves == side.leaves;
            if side.leaves.is_some() && !sides[..nth].iter().any(|earlier| same(&earlier)) {
                groups.push(sides[nth..].iter().filter(same).map(|(who, _)| *who).collect());
            }
            debug_assert!(group.contains(who));
        }
        found.push(Fork { at, cells, sides });
    }
    found.sort_by_key(|fork| (fork.cells, fork.sides.first().map(|(who, _)| *who)));
    found
}

/// The letter of a place in the line-up: A for the first.
#[must_use]
pub fn letter(nth: usize) -> char {
    char::from(b'A' + (nth % 26) as u8)
}

impl Fork {
    /// In a sentence, with the letters of the line-up.
    #[must_use]
    pub fn words(&self) -> String {
        let many = if self.cells == 1 { "cell" } else { "cells" };
        let mut parts: Vec<String> = Vec::new();
        for (nth, (_, side)) in self.sides.iter().enumerate() {
            let same = |(_, other): &&(usize, Side)| other.leaves == side.leaves;
            if self.sides[..nth].iter().any(|earlier| same(&earlier)) {
                continue;
            }
            let who: Vec<String> =
                self.sides.iter().filter(same).map(|(who, _)| letter(*who).to_string()).collect();
            let does = match (side.leaves, who.len()) {
                (Some(heading), 1) => format!("goes {}", heading.word()),
                (Some(heading), _) => format!("go {}", heading.word()),
                (None, 1) => String::from("is at its end"),
                (None, _) => String::from("are at their ends"),
            };
            parts.push(format!("{} {does}", joined(&who)));
        }
        format!("At {}, after {} {many}: {}.", self.at, self.cells, parts.join("; "))
    }
}

/// “A”, “A and B”, “A, B and C”.
fn joined(who: &[String]) -> String {
    match who {
        [] => String::new(),
        [one] => one.clone(),
        [all @ .., last] => format!("{} and {last}", all.join(", ")),
    }
}
