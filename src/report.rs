//! What a run comes to, in numbers: for the page's comparison and, as JSON, for other programs.

use alloc::string::{String, ToString};

use serde::Serialize;

use crate::compare::score::{judged, why_failed};
use crate::event::{Outcome, Seen};
use crate::explorer::book::Case;
use crate::geometry::{Heading, Turn};
use crate::ink::{Ink, cells_driven};
use crate::maze::Maze;
use crate::playback::Timeline as _;
use crate::recording::{Cursor, Recording};
use crate::route::tally::Tally;
use crate::route::{Route, Strayed, TurnList, best};
use crate::run::AnyRun;
use crate::settings::Settings;
use crate::trace::Trace;

mod extras;
mod not_started;

pub use extras::{Adjacency, Extras, Square};
pub use not_started::{CANNOT_START, NotStarted};

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
    /// Why it failed: how it ended, if not well, or why it left no route.
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
    /// Bytes that the robot needed at its peak, in the C types of the source.
    pub memory_bytes: u32,
    /// The book's `ptr` at the end.
    pub ptr: Option<u32>,
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
    /// What only some explorers have.
    #[serde(flatten)]
    pub extras: Extras,
}

/// What a run knows of itself.
struct Facts {
    explorer: &'static str,
    outcome: Outcome,
    stops: u32,
    decisions: u32,
    tally: Tally,
    memory_bytes: u32,
    ptr: Option<u32>,
    turns: Option<String>,
    route: Option<Result<Route, Strayed>>,
    extras: Extras,
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
        let list = TurnList::of(trace);
        let facts = Facts {
            explorer: "book",
            outcome: trace.outcome(),
            stops: trace.stops(),
            decisions: trace.steps().iter().filter(|step| step.sighting().seen() == Seen::Node).count()
                as u32,
            tally: driven(trace, settings.pace.cell_ms(maze.scale)),
            memory_bytes: book_memory_bytes(trace),
            ptr: Some(trace.state(trace.stops()).ptr),
            turns: list.as_ref().map(ToString::to_string),
            route: list.map(|list| Route::drive(maze, &list)),
            extras: Extras::default(),
        };
        Self::new(maze, settings, facts)
    }

    /// What a run of any explorer came to in this maze.
    #[must_use]
    pub fn of_run(maze: &Maze, settings: &Settings, run: &AnyRun) -> Self {
        let recording = match run {
            AnyRun::Book(book) => return Self::of(maze, settings, book.trace()),
            AnyRun::Other(recording) => recording,
        };
        let nodes = (1..=run.stops()).filter(|&stop| recording.look(stop).sighting.seen() == Seen::Node);
        let way = run.way(maze);
        let facts = Facts {
            explorer: recording.name().text(),
            outcome: run.outcome(),
            stops: run.stops(),
            decisions: nodes.count() as u32,
            tally: run.total(),
            memory_bytes: recording.last().robot().peak_bytes(),
            ptr: None,
            turns: way.as_ref().map(|way| way.list.to_string()),
            route: way.map(|way| way.route),
            extras: Extras::of(maze, recording),
        };
        Self::new(maze, settings, facts)
    }

    fn new(maze: &Maze, settings: &Settings, facts: Facts) -> Self {
        let cell_mm = maze.scale.cell_mm();
        let pace = &settings.pace;
        let Facts { explorer, outcome, stops, decisions, tally, memory_bytes, ptr, turns, route, extras } =
            facts;
        let route = judged(maze, route, outcome);
        let driven = route.as_ref().ok().map(Route::tally);
        let route_s = driven.map(|tally| tally.seconds(cell_mm, pace));
        let shortest = maze.start().and_then(|start| best::shortest(maze, start, pace));
        let fastest = maze.start().and_then(|start| best::fastest(maze, start, pace));
        Self {
            explorer,
            outcome: outcome.name(),
            reason: why_failed(outcome, route.err()),
            stops,
            decisions,
            distance_cells: tally.cells,
            distance_mm: tidy(f64::from(tally.cells) * cell_mm),
            turns,
            right_turns: tally.right_turns,
            left_turns: tally.left_turns,
            u_turns: tally.u_turns,
            seconds: tidy(tally.seconds(cell_mm, pace)),
            memory_bytes,
            ptr,
            route_cells: driven.map(|tally| tally.cells),
            route_s: route_s.map(tidy),
            shortest_cells: shortest.map(|best| best.cells),
            shortest_s: shortest.map(|best| tidy(best.seconds)),
            fastest_cells: fastest.map(|best| best.cells),
            fastest_s: fastest.map(|best| tidy(best.seconds)),
            ratio_shortest: ratio(
                driven.map(|t| f64::from(t.cells)),
                shortest.map(|best| f64::from(best.cells)),
            ),
            ratio_fastest: ratio(route_s, fastest.map(|best| best.seconds)),
            extras,
        }
    }
}

/// A stop of a run, as other programs read it.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
pub struct StopReport {
    /// From 1; all explorers but the book's have a stop 0.
    pub stop: u32,
    /// `[x, y]` in the drawing's frame.
    pub at: [i32; 2],
    /// What the place looks like.
    pub seen: &'static str,
    /// The book's case, where corners and the finish have none; the explorer's own word for all others.
    pub case: Option<&'static str>,
    /// The node's place in the table; for others their own number of the node, if they have one.
    pub node: Option<u32>,
    /// The way out, 0 to 3 in the bot's frame; none where it stayed.
    pub leaves: Option<u8>,
    /// The book's `ptr` after the stop.
    pub ptr: Option<u32>,
    /// The book's `returning` after the stop.
    pub returning: Option<bool>,
    /// Milliseconds of driving to the east of the start, in the bot's frame.
    pub cur_x: i32,
    /// The same to the north.
    pub cur_y: i32,
    /// Cells that the book's explorer has crossed out after the stop.
    pub crossed_cells: Option<u32>,
    /// The same for people.
    #[serde(skip)]
    pub shown: ShownStop,
}

/// What of a stop people read in words and letters of their own.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct ShownStop {
    /// What the place looks like.
    pub seen: &'static str,
    /// The case.
    pub case: Option<&'static str>,
    /// The turn made there; none where it stayed.
    pub turn: Option<Turn>,
    /// The way out, in the bot's frame.
    pub leaves: Option<Heading>,
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
            ptr: Some(state.ptr),
            returning: Some(state.returning),
            cur_x: state.cur_x,
            cur_y: state.cur_y,
            crossed_cells: Some(ink.crossed_cells(stop)),
            shown: ShownStop {
                seen: step.sighting().seen().shown(),
                case: step.case().shown(),
                turn: step.turn(),
                leaves: step.turn().map(|_| step.departure()),
            },
        })
    }
}

impl StopReport {
    /// A stop of any explorer but the book's; the cursor makes one after the other quick.
    #[must_use]
    pub fn of_recording(run: &Recording, cursor: &mut Cursor, stop: u32) -> Self {
        let (step, at) = (run.step(stop), run.place(stop));
        let from_start = run.from_start(at);
        let here = cursor.seek(run, stop);
        let node = here.mind.robot().node(here.look);
        let leaves = |turn| step.heading().turned(turn).in_frame_of(run.start().heading);
        let leaves = step.turn().map(leaves);
        Self {
            stop,
            at: [at.x, at.y],
            seen: here.look.seen_name(),
            case: Some(run.case(stop).name),
            node,
            leaves: leaves.map(Heading::index),
            ptr: None,
            returning: None,
            cur_x: from_start.x.saturating_mul(run.cell_ms() as i32),
            cur_y: from_start.y.saturating_mul(run.cell_ms() as i32),
            crossed_cells: None,
            shown: ShownStop {
                seen: here.look.shown(),
                case: Some(run.case(stop).shown),
                turn: step.turn(),
                leaves,
            },
        }
    }
}

fn driven(trace: &Trace, cell_ms: u32) -> Tally {
    trace.steps().iter().fold(Tally::default(), |tally, step| {
        let tally = tally.driven(cells_driven(step.time_diff(), cell_ms));
        step.turn().map_or(tally, |turn| tally.turned(turn))
    })
}

/// Bytes that the book's robot needed for the nodes that it remembered at once.
pub(crate) fn book_memory_bytes(trace: &Trace) -> u32 {
    NODE_BYTES * most_remembered(trace)
}

/// Nodes are forgotten from the end of the table, so its highest number says how many it held.
fn most_remembered(trace: &Trace) -> u32 {
    trace.steps().iter().filter(|step| step.case() == Case::New).map(|step| step.node()).max().unwrap_or(0)
}

fn ratio(ours: Option<f64>, best: Option<f64>) -> Option<f64> {
    Some(tidy(ours? / best.filter(|&best| best > 0.0)?))
}

/// Rounded to millionths: 4.4, not 4.400000000000001.
pub(crate) fn tidy(number: f64) -> f64 {
    if number.abs() < 1e9 {
        let half = if number < 0.0 { -0.5 } else { 0.5 };
        (number * 1e6 + half) as i64 as f64 / 1e6
    } else {
        number
    }
}
