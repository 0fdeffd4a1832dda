//! The driver: it puts a robot into a world, carries sightings to its mind and decisions back, and writes the
//! trace. It is also the referee: it ends what would go on for ever.

mod any;
mod referee;

pub use any::{AnyRun, BookRun, Way};
pub use referee::record;

use crate::event::{Decision, Outcome, Sighting};
use crate::explorer::Explorer;
use crate::explorer::book::Book;
use crate::explorer::book::grid_store::GridStore;
use crate::explorer::book::store::NodeStore;
use crate::geometry::Turn;
use crate::maze::Maze;
use crate::settings::Settings;
use crate::trace::{MAX_NODES, Recorder, Trace};
use crate::world::{CannotStart, Ideal, World, line_start};

/// Explores a maze with the book's explorer in an ideal world.
///
/// ```
/// use line_maze_lab::event::Outcome;
/// use line_maze_lab::maze::samples;
/// use line_maze_lab::{run, settings::Settings};
/// let maze = samples::figure_3_1();
/// let trace = run::explore(&maze, &Settings::default())?;
/// assert_eq!(trace.outcome(), Outcome::Finish);
/// assert_eq!(trace.stops(), 25);
/// # Ok::<(), line_maze_lab::world::CannotStart>(())
/// ```
///
/// # Errors
/// Where the bot cannot be put down at the start.
pub fn explore(maze: &Maze, settings: &Settings) -> Result<Trace, CannotStart> {
    let epsilon = settings.epsilon(maze.scale);
    explore_with(maze, settings, GridStore::new(settings.node_max.min(MAX_NODES), epsilon))
}

/// [`explore`] over a given node table.
///
/// # Errors
/// As [`explore`].
pub fn explore_with<S: NodeStore>(maze: &Maze, settings: &Settings, nodes: S) -> Result<Trace, CannotStart> {
    let start = line_start(maze)?;
    let mut world = Ideal::new(maze, start, settings.pace.cell_ms(maze.scale));
    let mut bot = Book::new(nodes, settings.order, settings.epsilon(maze.scale));
    let mut recorder = Recorder::new(settings.pace);
    let limit = stop_limit(maze);
    let outcome = drive(&mut world, limit, |sighting| {
        let decision = bot.decide(sighting, |event| recorder.hear(event));
        recorder.stop(sighting, if let Decision::Go(turn) = decision { Some(turn) } else { None });
        decision
    });
    let outcome = match outcome {
        Outcome::NoLine { heading, .. } => Outcome::NoLine { node: recorder.last_node(), heading },
        other => other,
    };
    Ok(recorder.finish(outcome))
}

/// `8 × ways in the maze + 64`: more stops than any sound exploration takes.
#[must_use]
pub fn stop_limit(maze: &Maze) -> u32 {
    // A cell of line is a way out of both of its ends.
    (maze.cells() as u32).saturating_mul(16).saturating_add(64)
}

/// Drives until the mind ends the run, turns where there is no line, or passes `limit` stops.
fn drive(world: &mut impl World, limit: u32, mut mind: impl FnMut(Sighting) -> Decision) -> Outcome {
    let mut turn = Turn::Straight;
    let mut heading = crate::geometry::Heading::North;
    for _ in 0..limit {
        heading = heading.turned(turn);
        let Ok(sighting) = world.drive(turn) else {
            return Outcome::NoLine { node: 0, heading };
        };
        match mind(sighting) {
            Decision::Go(next) => turn = next,
            Decision::End(outcome) => return outcome,
        }
    }
    Outcome::TooManyStops { limit }
}
