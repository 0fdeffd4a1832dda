//! Who could not be put down in which maze, and why: they are in no share and no median, so they are named.

use alloc::format;
use alloc::string::{String, ToString};
use alloc::vec::Vec;

use super::{CourseResult, League};
use crate::explorer::name::Name;
use crate::world::CannotStart;

/// Explorers that could not start in a maze for the same reason.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Absence {
    /// Which course, by its place in the league.
    pub course: usize,
    /// Why.
    pub why: CannotStart,
    /// Who, in the order of the league's names.
    pub names: Vec<Name>,
}

impl Absence {
    /// Who and why, in a sentence or two.
    ///
    /// ```
    /// use line_maze_lab::compare::league::{Course, League, absences};
    /// use line_maze_lab::explorer::name::Name;
    /// use line_maze_lab::maze::{Bounds, Maze};
    /// let course = Course::File { name: "a.maze".into(), maze: Maze::new(Bounds::default()) };
    /// let names = vec![Name::Book, Name::Mapping];
    /// let league = League { names, settings: Default::default(), courses: vec![course] };
    /// let absences = absences(&[league.run(0)]);
    /// assert_eq!(absences[0].words(&league), "everybody. The maze has no start: put one at the end of a line.");
    /// ```
    #[must_use]
    pub fn words(&self, league: &League) -> String {
        let titles: Vec<&str> = self.names.iter().map(|name| name.about().title).collect();
        let all = titles.len() > 1 && titles.len() == league.names.len();
        // Titles have commas.
        let who = if all { String::from("everybody") } else { titles.join("; ") };
        format!("{who}. {}", self.why)
    }
}

/// All of them, in the order of the results.
#[must_use]
pub fn absences(results: &[CourseResult]) -> Vec<Absence> {
    let mut all: Vec<Absence> = Vec::new();
    for result in results {
        let first = all.len();
        for entry in &result.entries {
            let Err(why) = entry.score else { continue };
            match all[first..].iter_mut().find(|absence| absence.why == why) {
                Some(absence) => absence.names.push(entry.name),
                None => all.push(Absence { course: result.course, why, names: Vec::from([entry.name]) }),
            }
        }
    }
    all
}

/// How many runs these are, for people.
#[must_use]
pub fn absent_runs(absences: &[Absence]) -> String {
    match absences.iter().map(|absence| absence.names.len()).sum::<usize>() {
        1 => "1 run could not start".to_string(),
        runs => format!("{runs} runs could not start"),
    }
}
