//! What a run comes to, in numbers: for the page's comparison and, as JSON, for other programs.

use alloc::string::{String, ToString};

use serde::Serialize;

use crate::event::{Outcome, Seen};
use crate::explorer::book::Case;
use crate::ink::{Ink, cells_driven};
use crate::maze::Maze;
use crate::route::tally::Tally;
use crate::route::{Route, TurnList, best};
use crate::settings::Settings;
use crate::trace::Trace;

/// Bytes that a node takes on the book's board, where an `int` has 2: `paths` and `vpaths` of four `bool`s
/// each, `back_path`, `x_cor` and `y_cor`, and a byte for `last_path`.
pub const NODE_BYTES: u32 = 15;

/// A whole run and its route. `None` where there is nothing to say: no route without a finish, no best one
/// where none can be reached.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Report {
    /// Which mind drove.
    pub explorer: &'static str,
    /// The outcome's name.
    pub outcome: &'static str,
    /// Why it ended there, if not at the finish.
    pub reason: Option<String>,
    /// Stops after the start.
    pub stops: u32,
    /// Stops at nodes.
    pub decisions: u32,
    /// Cells driven.
    pub distance_cells: u32,
    /// The same on the floor.
    pub distance_mm: f64,
    /// The route's letters.
    pub turns: Option<String>,
    /// The exploration's turns to the right, at nodes and corners.
    pub right_turns: u32,
    /// The exploration's turns to the left, at nodes and corners.
    pub left_turns: u32,
    /// The exploration's turns round.
    pub u_turns: u32,
    /// Seconds that the exploration took: driving, turns, and stops.
    pub seconds: f64,
    /// Bytes that the robot needed for the nodes that it remembered at once.
    pub memory_bytes: u32,
    /// `ptr` at the end.
    pub ptr: u32,
    /// Cells of the route.
    pub route_cells: Option<u32>,
    /// Seconds of the route.
    pub route_s: Option<f64>,
    /// Cells of the shortest way that the maze has.
    pub shortest_cells: Option<u32>,
    /// Seconds of the shortest way, the quickest of several.
    pub shortest_s: Option<f64>,
    /// Cells of the quickest way.
    pub fastest_cells: Option<u32>,
    /// Seconds of the quickest way.
    pub fastest_s: Option<f64>,
    /// The route's cells over the shortest's.
    pub ratio_shortest: Option<f64>,
    /// The route's seconds over the quickest's.
    pub ratio_fastest: Option<f64>,
}

impl Report {
    /// What the book's explorer came to in this maze.
    ///
    /// ```
    /// # use line_maze_lab::geometry::{Heading::North, Point};
    /// # use line_maze_lab::maze::{Bounds, Maze, Start};
    /// use line_maze_lab::{report::Report, run, settings::Settings};
    /// # let mut maze = Maze::new(Bounds::new(Point::new(0, 0), Point::new(0, 1))?);
    /// # maze.draw(Point::new(0, 0), North);
    /// # maze.set_start(Some(Start { at: Point::new(0, 0), heading: North }));
    /// # maze.set_finish(vec![Point::new(0, 1)]);
    /// let settings = Settings::default();
    /// let trace = run::explore(&maze, &settings)?;
    /// let report = Report::of(&maze, &settings, &trace);
    /// assert_eq!((report.outcome, report.seconds), ("finish", 0.4));
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    #[must_use]
    pub fn of(maze: &Maze, settings: &Settings, trace: &Trace) -> Self {
        let cell_mm = maze.scale.cell_mm();
        let pace = &settings.pace;
        let tally = driven(trace, pace.cell_ms(maze.scale));
        let list = TurnList::of(trace);
        let route = list.as_ref().map(|list| Route::drive(maze, list));
        let strayed = route.as_ref().and_then(|route| route.as_ref().err());
        let route = route.as_ref().and_then(|route| route.as_ref().ok()).map(Route::tally);
        let route_s = route.map(|tally| tally.seconds(cell_mm, pace));
        let shortest = maze.start().and_then(|start| best::shortest(maze, start, pace));
        let fastest = maze.start().and_then(|start| best::fastest(maze, start, pace));
        Self {
            explorer: "book",
            outcome: trace.outcome().name(),
            reason: match trace.outcome() {
                Outcome::Finish => strayed.map(ToString::to_string),
                other => Some(other.to_string()),
            },
            stops: trace.stops(),
            decisions: trace.steps().iter().filter(|step| step.sighting().seen() == Seen::Node).count()
                as u32,
            distance_cells: tally.cells,
            distance_mm: tidy(f64::from(tally.cells) * cell_mm),
            turns: list.map(|list| list.to_string()),
            right_turns: tally.right_turns,
            left_turns: tally.left_turns,
            u_turns: tally.u_turns,
            seconds: tidy(tally.seconds(cell_mm, pace)),
            memory_bytes: NODE_BYTES * most_remembered(trace),
            ptr: trace.state(trace.stops()).ptr,
            route_cells: route.map(|tally| tally.cells),
            route_s: route_s.map(tidy),
            shortest_cells: shortest.map(|best| best.cells),
            shortest_s: shortest.map(|best| tidy(best.seconds)),
            fastest_cells: fastest.map(|best| best.cells),
            fastest_s: fastest.map(|best| tidy(best.seconds)),
            ratio_shortest: ratio(
                route.map(|t| f64::from(t.cells)),
                shortest.map(|best| f64::from(best.cells)),
            ),
            ratio_fastest: ratio(route_s, fastest.map(|best| best.seconds)),
        }
    }
}

/// A stop of a run, as other programs read it.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
pub struct StopReport {
    /// From 1.
    pub stop: u32,
    /// `[x, y]` in the drawing's frame.
    pub at: [i32; 2],
    /// What the place looks like.
    pub seen: &'static str,
    /// The book's case; corners and the finish have none.
    pub case: Option<&'static str>,
    /// The node's place in the table.
    pub node: Option<u32>,
    /// The way out, 0 to 3 in the bot's frame; none where it stayed.
    pub leaves: Option<u8>,
    /// `ptr` after the stop.
    pub ptr: u32,
    /// `returning` after the stop.
    pub returning: bool,
    /// `cur_x`, in milliseconds.
    pub cur_x: i32,
    /// `cur_y`, in milliseconds.
    pub cur_y: i32,
    /// Cells crossed out after the stop.
    pub crossed_cells: u32,
}

impl StopReport {
    /// A stop of a trace, and of the floor that it left; none for the start and past the end.
    #[must_use]
    pub fn of(trace: &Trace, ink: &Ink, stop: u32) -> Option<Self> {
        let (step, state, at) = (trace.step(stop)?, trace.state(stop), ink.place(stop));
        Some(Self {
            stop,
            at: [at.x, at.y],
            seen: step.sighting().seen().name(),
            case: step.case().name(),
            node: Some(step.node()).filter(|&node| node > 0),
            leaves: step.turn().map(|_| step.departure().index()),
            ptr: state.ptr,
            returning: state.returning,
            cur_x: state.cur_x,
            cur_y: state.cur_y,
            crossed_cells: ink.crossed_cells(stop),
        })
    }
}

fn driven(trace: &Trace, cell_ms: u32) -> Tally {
    trace.steps().iter().fold(Tally::default(), |tally, step| {
        let tally = tally.driven(cells_driven(step.time_diff(), cell_ms));
        step.turn().map_or(tally, |turn| tally.turned(turn))
    })
}

/// Nodes are forgotten from the end of the table, so its highest number says how many it held.
fn most_remembered(trace: &Trace) -> u32 {
    trace.steps().iter().filter(|step| step.case() == Case::New).map(|step| step.node()).max().unwrap_or(0)
}

fn ratio(ours: Option<f64>, best: Option<f64>) -> Option<f64> {
    Some(tidy(ours? / best.filter(|&best| best > 0.0)?))
}

/// Rounded to millionths: 4.4, not 4.400000000000001.
fn tidy(number: f64) -> f64 {
    if number < 1e9 { (number * 1e6 + 0.5) as u64 as f64 / 1e6 } else { number }
}
