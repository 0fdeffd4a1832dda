//! The league at a desk: it hears what a page asks, works a course at a time, and tells what to show. Asked and
//! told are plain values that go as JSON, so that the desk can stand in a worker; what it shows is markup, so that
//! the page holds none of the numbers.

use alloc::string::{String, ToString};
use alloc::vec::Vec;

use base64::Engine;
use base64::prelude::BASE64_STANDARD;
use serde::{Deserialize, Serialize};

use super::{Course, CourseResult, League, results_csv, standings, standings_csv};
use crate::maze::generate::{Recipe, RecipeError, generate};
use crate::maze::{Kind, file, text};

mod show;
mod terms;

pub use show::{Shown, View};
pub use terms::Terms;

/// What a page asks for.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub enum Ask {
    /// A league from the beginning.
    Begin(Plan),
    /// No further courses.
    Stop,
    /// The results, in this order.
    Show(View),
    /// A file of a line for each run, or for each explorer.
    Csv(Sheet),
    /// A course's maze.
    Open {
        /// Which, by its place in the league.
        course: usize,
        /// Who is to drive in it.
        explorer: String,
    },
}

/// Which table is wanted.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
pub enum Sheet {
    /// A line a run.
    Results,
    /// A line an explorer.
    Standings,
}

/// Who runs, how, and where.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Plan {
    /// The explorers' names.
    pub explorers: Vec<String>,
    /// What they are set to.
    pub terms: Terms,
    /// Whether all samples are courses.
    pub samples: bool,
    /// Mazes to be made.
    pub generated: Option<Made>,
    /// Files, each with its name and its bytes in base64.
    pub files: Vec<(String, String)>,
}

/// Mazes to be made.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
pub struct Made {
    /// How many.
    pub count: u32,
    /// Points along each side.
    pub side: u32,
    /// Links that become loops, in per cent.
    pub loops_percent: u8,
    /// The first seed; the others follow.
    pub seed: u64,
}

impl Made {
    /// More mazes than this are not made at once.
    pub const MOST: u32 = 5000;

    fn recipe(self) -> Recipe {
        Recipe {
            width: self.side,
            height: self.side,
            loops_percent: self.loops_percent,
            dead_ends_cut_percent: 0,
            seed: self.seed,
            kind: Kind::Line,
        }
    }

    /// Whether there are such mazes.
    ///
    /// # Errors
    /// Why not.
    pub fn checked(self) -> Result<Self, RecipeError> {
        generate(&Recipe { width: self.side.min(3), height: self.side.min(3), ..self.recipe() })?;
        if self.side > crate::maze::MAX_SIDE { Err(RecipeError::TooLarge) } else { Ok(self) }
    }
}

/// What the desk tells.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub enum Tell {
    /// It is there and can be asked.
    Ready,
    /// How far it is.
    Progress {
        /// Courses that are done.
        done: usize,
        /// Courses of the league.
        of: usize,
    },
    /// Files that are no mazes: the name, and place and cure.
    Refused(Vec<(String, String)>),
    /// The results so far.
    Shown(Shown),
    /// A table.
    Csv {
        /// The file's name.
        name: String,
        /// The file.
        text: String,
    },
    /// A maze, as a `.maze` file.
    Maze {
        /// The file.
        text: String,
        /// Who is to drive in it.
        explorer: String,
    },
}

/// The desk.
#[derive(Debug, Default)]
pub struct Desk {
    league: Option<League>,
    results: Vec<CourseResult>,
    stopped: bool,
    view: View,
}

impl Desk {
    /// Hears a question, and answers at once.
    ///
    /// ```
    /// use line_maze_lab::compare::league::desk::{Ask, Desk, Made, Plan, Tell, Terms};
    /// let made = Made { count: 2, side: 5, loops_percent: 10, seed: 7 };
    /// let files = vec![("bad.maze".into(), "bm8gbWF6ZQ==".into())];
    /// let explorers = vec!["book".into(), "mapping".into()];
    /// let mut desk = Desk::default();
    /// let told = desk.hear(Ask::Begin(Plan { explorers, terms: Terms::default(), samples: false, generated: Some(made), files }));
    /// assert!(matches!(&told[..], [Tell::Refused(bad), Tell::Progress { done: 0, of: 2 }] if bad[0].0 == "bad.maze"));
    /// while desk.is_busy() {
    ///     desk.work();
    /// }
    /// let Some(Tell::Shown(shown)) = desk.hear(Ask::Show(Default::default())).pop() else { panic!() };
    /// assert_eq!((shown.runs, shown.standings.matches("<tr").count()), (4, 2));
    /// ```
    pub fn hear(&mut self, ask: Ask) -> Vec<Tell> {
        match ask {
            Ask::Begin(plan) => self.begin(plan),
            Ask::Stop => {
                self.stopped = true;
                alloc::vec![self.progress(), self.shown()]
            }
            Ask::Show(view) => {
                self.view = view;
                alloc::vec![self.shown()]
            }
            Ask::Csv(sheet) => self.csv(sheet).into_iter().collect(),
            Ask::Open { course, explorer } => {
                let maze = self.league.as_ref().and_then(|league| league.courses.get(course)?.maze().ok());
                maze.map(|maze| Tell::Maze { text: text::write(&maze), explorer }).into_iter().collect()
            }
        }
    }

    /// Whether courses are left to run.
    #[must_use]
    pub fn is_busy(&self) -> bool {
        !self.stopped && self.league.as_ref().is_some_and(|league| self.results.len() < league.courses.len())
    }

    /// Runs the next course.
    pub fn work(&mut self) {
        if let Some(league) = &self.league
            && self.results.len() < league.courses.len()
        {
            self.results.push(league.run(self.results.len()));
        }
    }

    /// How far it is.
    #[must_use]
    pub fn progress(&self) -> Tell {
        let of = self.league.as_ref().map_or(0, |league| league.courses.len());
        Tell::Progress { done: self.results.len(), of }
    }

    /// The results so far.
    #[must_use]
    pub fn shown(&self) -> Tell {
        Tell::Shown(
            self.league.as_ref().map(|league| self.view.of(league, &self.results)).unwrap_or_default(),
        )
    }

    fn begin(&mut self, plan: Plan) -> Vec<Tell> {
        let mut courses: Vec<Course> = Vec::new();
        let mut refused = Vec::new();
        if plan.samples {
            courses.extend(Course::samples());
        }
        if let Some(made) = plan.generated {
            courses.extend(Course::generated(made.recipe(), made.count.min(Made::MOST)));
        }
        for (name, content) in plan.files {
            let bytes = BASE64_STANDARD.decode(content).unwrap_or_default();
            match file::read(&bytes) {
                Ok(reading) => courses.push(Course::File { name, maze: reading.maze }),
                Err(why) => refused.push((name, why.to_string())),
            }
        }
        let names = plan.explorers.iter().filter_map(|name| name.parse().ok()).collect();
        let of = courses.len();
        self.league = Some(League { names, settings: plan.terms.settings(), courses });
        self.results = Vec::with_capacity(of);
        self.stopped = false;
        let mut told = Vec::new();
        if !refused.is_empty() {
            told.push(Tell::Refused(refused));
        }
        told.push(Tell::Progress { done: 0, of });
        told
    }

    fn csv(&self, sheet: Sheet) -> Option<Tell> {
        let league = self.league.as_ref()?;
        let (name, text) = match sheet {
            Sheet::Results => ("league.csv", results_csv(league, &self.results)),
            Sheet::Standings => ("standings.csv", standings_csv(&standings(&league.names, &self.results))),
        };
        Some(Tell::Csv { name: name.into(), text })
    }
}

/// A file's bytes as a plan has them.
#[must_use]
pub fn in_base64(bytes: &[u8]) -> String {
    BASE64_STANDARD.encode(bytes)
}
