//! The driver of every explorer: it looks round at the start, drives from stop to stop, and is the referee
//! that sees what the robot cannot: that it circles, that it has been everywhere.

use alloc::vec;
use alloc::vec::Vec;

use super::any::{AnyRun, BookRun};
use super::explore;
use crate::event::{Decision, Outcome};
use crate::explorer::mind::{Costs, Field, Mind, Setup};
use crate::explorer::name::{About, Memory, Name, Seeks, Stops};
use crate::explorer::tell::Said;
use crate::geometry::{Heading, Point};
use crate::maze::{Maze, Start};
use crate::recording::{Recorder, Recording};
use crate::settings::Settings;
use crate::world::CannotStart;
use crate::world::rover::{Halt, Rover};

/// No run is recorded for longer; a step takes 8 bytes.
const MOST_STOPS: u32 = 1 << 25;

/// Lets an explorer explore a maze in an ideal world.
///
/// ```
/// use line_maze_lab::event::Outcome;
/// use line_maze_lab::explorer::name::Name;
/// use line_maze_lab::{maze::samples, run, settings::Settings};
/// let run = run::record(&samples::figure_3_1(), &Settings::default(), Name::RightHand)?;
/// assert_eq!(run.outcome(), Outcome::Circling { first: 1, again: 15 });
/// # Ok::<(), line_maze_lab::world::CannotStart>(())
/// ```
///
/// # Errors
/// Where there is no start; the book's explorer besides wants it at the end of a line.
pub fn record(maze: &Maze, settings: &Settings, name: Name) -> Result<AnyRun, CannotStart> {
    let start = maze.start().ok_or(CannotStart::NoStart)?;
    match Mind::new(name, &setup(maze, start, settings)) {
        None => {
            let trace = explore(maze, settings)?;
            Ok(AnyRun::Book(BookRun::new(trace, settings.pace.cell_ms(maze.scale))))
        }
        Some(mind) => Ok(AnyRun::Other(drive(maze, start, settings, name, mind))),
    }
}

/// What is written into a robot before it is put down in this maze.
#[must_use]
pub(super) fn setup(maze: &Maze, start: Start, settings: &Settings) -> Setup {
    let (bounds, pace) = (maze.bounds(), &settings.pace);
    let sw = bounds.sw();
    let inside = |at: Point| Point::new(at.x - sw.x, at.y - sw.y);
    let nanoseconds = |seconds: f64| (seconds * 1e9 + 0.5) as u64;
    Setup {
        order: settings.order,
        epsilon: settings.epsilon(maze.scale),
        cell_ms: pace.cell_ms(maze.scale),
        field: Field {
            width: bounds.width(),
            height: bounds.height(),
            start: inside(start.at),
            heading: start.heading,
        },
        rule: settings.rule,
        path_max: settings.path_max,
        search: settings.search,
        costs: Costs {
            cell: nanoseconds(maze.scale.cell_mm() / pace.speed_mm_s),
            turn: nanoseconds(pace.turn_s),
            uturn: nanoseconds(pace.uturn_s),
            stop: nanoseconds(pace.stop_s),
        },
        goal: maze.finish().iter().copied().map(inside).collect(),
    }
}

fn drive(maze: &Maze, start: Start, settings: &Settings, name: Name, mut mind: Mind) -> Recording {
    let about = name.about();
    let halt = match about.stops {
        Stops::Line => Halt::Line,
        Stops::Square => Halt::Square,
    };
    let cell_ms = settings.pace.cell_ms(maze.scale);
    let mut rover = Rover::new(maze, start, cell_ms, halt);
    let mut recorder = Recorder::new(name, maze.bounds(), start, cell_ms);
    let mut referee = Referee::new(maze, start, about);
    // Two cells a point are more than there are; counting them would take longer than many a run.
    let cells = 2 * maze.bounds().len() as u32;
    let limit = cells.saturating_mul(256).saturating_add(64).min(MOST_STOPS);
    let mut look = rover.look_round();
    let outcome = loop {
        recorder.begin(&mind);
        let mut said = Said::default();
        let meant = mind.decide(look, &mut said);
        let (at, heading, stop) = (rover.at(), rover.heading(), recorder.next());
        let decision = match meant {
            Decision::End(Outcome::Mapped) | Decision::Go(_) => {
                referee.verdict(stop, at, heading).map_or(meant, Decision::End)
            }
            // Where no way leaves the start, there is more to say than that the finish is out of reach.
            Decision::End(Outcome::NoFinishReachable) if referee.stuck => Decision::End(Outcome::Stuck),
            Decision::End(_) => meant,
        };
        recorder.end(look, at, heading, [meant, decision], &said);
        let turn = match decision {
            Decision::End(outcome) => break outcome,
            Decision::Go(_) if stop >= limit => break Outcome::TooManyStops { limit },
            Decision::Go(turn) => turn,
        };
        match rover.drive(turn) {
            Ok(next) => look = next,
            Err(_) => {
                let heading = rover.heading().in_frame_of(start.heading);
                break Outcome::NoLine { node: 0, heading };
            }
        }
    };
    recorder.finish(outcome, mind)
}

/// Who knows the maze and watches the robot. All that it does at a stop takes the same time in any maze.
struct Referee<'m> {
    maze: &'m Maze,
    memory: Memory,
    /// For each place and arrival heading, one more than the last stop there with it; 0 is never.
    before: Vec<[u32; 4]>,
    /// Where the robot is to map everything, what is known of each place.
    known: Vec<u8>,
    /// The last stop at a place that was new.
    newest: u32,
    /// Places next to visited ones that were not visited themselves.
    open: u32,
    /// Whether no way leaves the start.
    stuck: bool,
}

// Numbers, not an enum: memory that comes zeroed costs nothing until it is used, and most runs use little.
/// Next to a visited place.
const OPEN: u8 = 1;
/// Visited.
const VISITED: u8 = 2;

impl<'m> Referee<'m> {
    fn new(maze: &'m Maze, start: Start, about: &About) -> Self {
        let watched = match about.memory {
            Memory::None | Memory::Visited => maze.bounds().len(),
            Memory::Enough => 0,
        };
        let known = match about.seeks {
            Seeks::Map => vec![0; watched],
            Seeks::Finish => Vec::new(),
        };
        Self {
            maze,
            memory: about.memory,
            before: vec![[0; 4]; watched],
            known,
            newest: 0,
            open: 0,
            stuck: maze.ways(start.at).is_empty(),
        }
    }

    /// What the robot cannot know: that the run is over at this stop.
    fn verdict(&mut self, stop: u32, at: Point, heading: Heading) -> Option<Outcome> {
        if self.stuck {
            return Some(Outcome::Stuck);
        }
        let index = self.maze.bounds().index(at)?;
        let place = self.before.get_mut(index)?;
        let new = *place == [0; 4];
        let before = core::mem::replace(&mut place[usize::from(heading.index())], stop + 1);
        if new {
            self.newest = stop;
            if !self.known.is_empty() && self.visit(index, at) {
                return Some(Outcome::Mapped);
            }
        }
        let before = before.checked_sub(1)?;
        let circling = match self.memory {
            Memory::None => true,
            Memory::Visited => self.newest <= before,
            Memory::Enough => false,
        };
        circling.then_some(Outcome::Circling { first: before, again: stop })
    }

    /// A place is visited for the first time; whether that was the last one.
    fn visit(&mut self, index: usize, at: Point) -> bool {
        let known = core::mem::replace(&mut self.known[index], VISITED);
        self.open -= u32::from(known == OPEN);
        for heading in self.maze.ways(at).iter() {
            let next = self.maze.bounds().index(at.step(heading));
            if let Some(next) = next.and_then(|next| self.known.get_mut(next))
                && *next == 0
            {
                *next = OPEN;
                self.open += 1;
            }
        }
        self.open == 0
    }
}
