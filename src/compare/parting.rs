//! Where two runs part for the first time: the last place that both came to in the same way, compared cell by
//! cell, as one robot may stop where the other drives on.

use alloc::format;
use alloc::string::String;

use super::Path;
use crate::geometry::{Heading, Point};
use crate::maze::{Maze, Start};
use crate::run::AnyRun;

/// Where two runs part.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Parting {
    /// The last common place.
    pub at: Point,
    /// Cells that both have driven up to there.
    pub cells: u32,
    /// What each does there.
    pub sides: [Side; 2],
}

/// What one of two runs does where they part.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Side {
    /// Its last stop up to there: the one to open in the stepper.
    pub stop: u32,
    /// Where it goes on to; none where its run is over.
    pub leaves: Option<Heading>,
}

/// The first parting of two runs in the same maze; none where they drive the same way to the end.
///
/// ```
/// use line_maze_lab::compare::parting;
/// use line_maze_lab::explorer::name::Name;
/// use line_maze_lab::{maze::samples, run::record, settings::Settings};
/// let (maze, settings) = (samples::figure_3_1(), Settings::default());
/// let left = record(&maze, &settings, Name::LeftHand)?;
/// let right = record(&maze, &settings, Name::RightHand)?;
/// let parting = parting::first(&maze, &left, &right).unwrap();
/// assert_eq!(parting.words(['A', 'B']), "At 0,1, A (stop 1) goes north, and B (stop 1) goes east.");
/// # Ok::<(), line_maze_lab::world::CannotStart>(())
/// ```
#[must_use]
pub fn first(maze: &Maze, a: &AnyRun, b: &AnyRun) -> Option<Parting> {
    let start = maze.start()?;
    let mut walks = [Walk::new(a, start), Walk::new(b, start)];
    let mut cells = 0;
    loop {
        let [a, b] = walks.each_mut();
        let (ways, at) = ([a.leaves(), b.leaves()], a.at);
        match ways {
            [None, None] => return None,
            [Some(one), Some(other)] if one == other => {
                let both = a.left.min(b.left);
                a.drive(both);
                b.drive(both);
                cells += both;
            }
            [one, other] => {
                return Some(Parting { at, cells, sides: [a.side(one), b.side(other)] });
            }
        }
    }
}

/// What a run does when it has driven so many cells, and where that is.
pub(super) fn side_after(start: Start, run: &AnyRun, cells: u32) -> (Point, Side) {
    let mut walk = Walk::new(run, start);
    let mut rest = cells;
    loop {
        let leaves = walk.leaves();
        if rest == 0 || leaves.is_none() {
            return (walk.at, walk.side(leaves));
        }
        let leg = walk.left.min(rest);
        walk.drive(leg);
        rest -= leg;
    }
}

/// One run, driven cell by cell.
struct Walk<'r> {
    path: Path<'r>,
    /// The last stop that was reached.
    stop: u32,
    at: Point,
    heading: Heading,
    /// Cells to the next stop.
    left: u32,
}

impl<'r> Walk<'r> {
    const fn new(run: &'r AnyRun, start: Start) -> Self {
        Self { path: Path { run, start }, stop: 0, at: start.at, heading: start.heading, left: 0 }
    }

    /// The heading that it goes on with; none at the end.
    fn leaves(&mut self) -> Option<Heading> {
        if self.left == 0 {
            if self.stop >= self.path.stops() {
                return None;
            }
            let next = self.path.place(self.stop + 1);
            self.left = self.at.distance(next);
            self.heading = self.path.heading(self.stop + 1);
        }
        Some(self.heading)
    }

    const fn drive(&mut self, cells: u32) {
        self.at = self.at.ahead(self.heading, cells.cast_signed());
        self.left -= cells;
        if self.left == 0 {
            self.stop += 1;
        }
    }

    fn side(&self, leaves: Option<Heading>) -> Side {
        Side { stop: self.stop, leaves }
    }
}

impl Parting {
    /// In a sentence, with their letters in the line-up.
    #[must_use]
    pub fn words(&self, letters: [char; 2]) -> String {
        let does = |side: &Side| match side.leaves {
            Some(heading) => format!("goes {}", heading.word()),
            None => String::from("is at its end"),
        };
        let [a, b] = &self.sides;
        let [one, other] = letters;
        format!(
            "At {}, {one} (stop {}) {}, and {other} (stop {}) {}.",
            self.at,
            a.stop,
            does(a),
            b.stop,
            does(b)
        )
    }
}
