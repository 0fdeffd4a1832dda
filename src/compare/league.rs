//! The league: every chosen explorer over many mazes (samples, generated ones, files). One course at a time, in
//! any order and on any core; the standings follow from whatever is done so far.

use alloc::format;
use alloc::string::{String, ToString};
use alloc::vec::Vec;

use super::score::{Bests, Column, Score};
use crate::explorer::name::Name;
use crate::maze::generate::{Recipe, RecipeError, generate};
use crate::maze::samples::{SAMPLES, Sample};
use crate::maze::{Maze, Scale};
use crate::run::record;
use crate::settings::Settings;
use crate::world::CannotStart;

mod absent;
mod csv;
pub mod desk;
mod quartiles;

pub use absent::{Absence, absences, absent_runs};
pub use csv::{results_csv, standings_csv};
pub use quartiles::Quartiles;

/// A maze of the league.
#[derive(Clone, Debug, PartialEq)]
pub enum Course {
    /// From the shelf.
    Sample(Sample),
    /// Made when it is its turn.
    Generated(Recipe),
    /// From a file.
    File {
        /// The file's name.
        name: String,
        /// The maze in it.
        maze: Maze,
    },
}

impl Course {
    /// All samples.
    pub fn samples() -> impl Iterator<Item = Self> {
        SAMPLES.iter().copied().map(Self::Sample)
    }

    /// So many mazes of a recipe, with its seed and the ones after it.
    pub fn generated(recipe: Recipe, count: u32) -> impl Iterator<Item = Self> {
        (0..u64::from(count))
            .map(move |more| Self::Generated(Recipe { seed: recipe.seed.wrapping_add(more), ..recipe }))
    }

    /// How programs call it.
    #[must_use]
    pub fn name(&self) -> String {
        match self {
            Self::Sample(sample) => sample.file.to_string(),
            Self::Generated(recipe) => format!("{}x{} seed {}", recipe.width, recipe.height, recipe.seed),
            Self::File { name, .. } => name.clone(),
        }
    }

    /// How people call it.
    #[must_use]
    pub fn title(&self) -> String {
        match self {
            Self::Sample(sample) => sample.label.to_string(),
            Self::Generated(recipe) => {
                format!("{} × {}, seed {}", recipe.width, recipe.height, recipe.seed)
            }
            Self::File { name, .. } => name.clone(),
        }
    }

    /// Its sizes on the floor.
    #[must_use]
    pub fn scale(&self) -> Scale {
        match self {
            Self::Sample(sample) => sample.maze().scale,
            Self::Generated(_) => Scale::default(),
            Self::File { maze, .. } => maze.scale,
        }
    }

    /// Its maze, to be opened.
    ///
    /// # Errors
    /// Where a recipe makes no sense.
    pub fn maze(&self) -> Result<Maze, RecipeError> {
        match self {
            Self::Sample(sample) => Ok(sample.maze()),
            Self::Generated(recipe) => generate(recipe),
            Self::File { maze, .. } => Ok(maze.clone()),
        }
    }
}

/// What an explorer came to on a course.
#[derive(Clone, Debug, PartialEq)]
pub struct Entry {
    /// Who.
    pub name: Name,
    /// In numbers, or why it could not be put down there.
    pub score: Result<Score, CannotStart>,
}

/// What all explorers came to on a course, in the order of their names.
#[derive(Clone, Debug, PartialEq)]
pub struct CourseResult {
    /// Which course, by its place in the league.
    pub course: usize,
    /// One for each explorer; none where there is no such maze.
    pub entries: Vec<Entry>,
}

/// Who runs, how, and where.
#[derive(Clone, Debug, PartialEq)]
pub struct League {
    /// The explorers.
    pub names: Vec<Name>,
    /// What they are set to.
    pub settings: Settings,
    /// The mazes.
    pub courses: Vec<Course>,
}

impl League {
    /// Runs every explorer over one course; one piece of the league's work. A course past the last has no
    /// entries.
    ///
    /// ```
    /// use line_maze_lab::compare::league::{Course, League, standings};
    /// use line_maze_lab::explorer::name::Name;
    /// let names = vec![Name::Book, Name::RightHand];
    /// let league = League { names, settings: Default::default(), courses: Course::samples().collect() };
    /// let results: Vec<_> = (0..3).map(|course| league.run(course)).collect();
    /// let standings = standings(&league.names, &results);
    /// assert_eq!((standings[0].name, standings[0].runs), (Name::Book, 3));
    /// ```
    #[must_use]
    pub fn run(&self, course: usize) -> CourseResult {
        let maze = self.courses.get(course).and_then(|course| course.maze().ok());
        let entries = maze.map_or(Vec::new(), |maze| {
            let bests = Bests::of(&maze, &self.settings);
            self.names.iter().map(|&name| self.entry(&maze, name, bests)).collect()
        });
        CourseResult { course, entries }
    }

    fn entry(&self, maze: &Maze, name: Name, bests: Bests) -> Entry {
        let run = record(maze, &self.settings, name);
        Entry { name, score: run.map(|run| Score::of(maze, &self.settings, &run, bests)) }
    }
}

/// How an explorer stands.
#[derive(Clone, Debug, PartialEq)]
pub struct Standing {
    /// Who.
    pub name: Name,
    /// Courses that it could be put down on.
    pub runs: usize,
    /// Those that it could not start in.
    pub absent: usize,
    /// Those on which it left a route to the finish.
    pub solved: usize,
    /// Those on which no way leads there: nobody could.
    pub hopeless: usize,
    /// Of the runs with a number in this column; in the order of [`Column::ALL`].
    numbers: Vec<Option<Quartiles>>,
}

impl Standing {
    /// The courses that it ran on and that could be solved: a way leads to their finish.
    #[must_use]
    pub const fn solvable(&self) -> usize {
        self.runs - self.hopeless
    }

    /// The share of those that it solved.
    #[must_use]
    pub fn share_solved(&self) -> Option<f64> {
        (self.solvable() > 0).then(|| self.solved as f64 / self.solvable() as f64)
    }

    /// That share in whole per cent; all and none are said of all and none only.
    #[must_use]
    pub fn percent_solved(&self) -> Option<u32> {
        let nearest = (self.share_solved()? * 100.0 + 0.5) as u32;
        Some(match self.solved {
            0 => 0,
            all if all == self.solvable() => 100,
            _ => nearest.clamp(1, 99),
        })
    }

    /// Median and quartiles of a column; none where no run has a number there.
    #[must_use]
    pub fn quartiles(&self, column: Column) -> Option<Quartiles> {
        Column::ALL.iter().position(|&other| other == column).and_then(|nth| self.numbers[nth])
    }
}

/// How all stand after these results, in the order of the names.
#[must_use]
pub fn standings(names: &[Name], results: &[CourseResult]) -> Vec<Standing> {
    names.iter().map(|&name| standing(name, results)).collect()
}

fn standing(name: Name, results: &[CourseResult]) -> Standing {
    let entries = || results.iter().flat_map(|result| &result.entries).filter(|entry| entry.name == name);
    let scores: Vec<&Score> = entries().filter_map(|entry| entry.score.as_ref().ok()).collect();
    let numbers =
        Column::ALL.map(|column| Quartiles::of(scores.iter().filter_map(|score| score.number(column))));
    Standing {
        name,
        runs: scores.len(),
        absent: entries().count() - scores.len(),
        solved: scores.iter().filter(|score| score.is_solved()).count(),
        hopeless: scores.iter().filter(|score| score.bests.shortest.is_none()).count(),
        numbers: numbers.to_vec(),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn all_and_none_are_said_of_all_and_none_only() {
        let percent = |solved, runs, hopeless| {
            let standing =
                Standing { name: Name::Book, runs, absent: 3, solved, hopeless, numbers: Vec::new() };
            standing.percent_solved()
        };
        assert_eq!(percent(116, 122, 3), Some(97));
        assert_eq!(percent(1999, 2000, 0), Some(99));
        assert_eq!(percent(2000, 2000, 0), Some(100));
        assert_eq!(percent(1, 2000, 0), Some(1));
        assert_eq!(percent(0, 2000, 0), Some(0));
        assert_eq!(percent(0, 5, 5), None);
    }
}
