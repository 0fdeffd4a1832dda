//! The floor as a live run has seen it: a maze to draw where the page has none, and whether the page's fits.

use alloc::vec::Vec;

use crate::event::Finish;
use crate::geometry::{Heading, Point, Ways};
use crate::ink::cells_driven;
use crate::maze::{Bounds, MAX_SIDE, Maze, Scale, Start};
use crate::trace::{Step, Trace};

/// How long a cell takes the robot, guessed from its drives: the longest time of which all drives are about
/// multiples. Nothing before the first drive.
#[must_use]
pub fn guess_cell_ms(trace: &Trace) -> Option<u32> {
    let drives: Vec<u32> = trace.steps().iter().map(|step| step.time_diff()).filter(|&ms| ms > 0).collect();
    let shortest = drives.iter().copied().min()?;
    // The shortest drive is a cell, or two, or three: else nothing fits, and it counts as one.
    let fits = |&cell: &u32| drives.iter().all(|&ms| off_lattice(ms, cell) * 5 <= u64::from(cell));
    let cell = [shortest, shortest / 2, shortest / 3].into_iter().find(|cell| *cell > 0 && fits(cell));
    let cell = cell.unwrap_or(shortest);
    // Long drives tell more exactly how long one cell takes.
    let cells: u64 = drives.iter().map(|&ms| u64::from(cells_driven(ms, cell))).sum();
    let driven: u64 = drives.iter().map(|&ms| u64::from(ms)).sum();
    u32::try_from((driven + cells / 2) / cells.max(1)).ok()
}

/// Where a live run is drawn.
#[derive(Clone, Debug, PartialEq)]
pub struct Ground {
    /// What has been seen as a maze; nothing where the page's own maze fits.
    pub seen: Option<Maze>,
    /// Milliseconds that a cell takes the robot.
    pub cell_ms: u32,
}

/// The floor under a live run: the page's maze at the page's pace, or at the robot's own, or else what has
/// been seen. Nothing where the robot went too far for any maze.
#[must_use]
pub fn ground(maze: &Maze, trace: &Trace, page_ms: u32) -> Option<Ground> {
    let guess_ms = guess_cell_ms(trace).unwrap_or(page_ms).max(1);
    let fitting = [page_ms, guess_ms].into_iter().find(|&ms| first_misfit(maze, trace, ms).is_none());
    match fitting {
        Some(cell_ms) => Some(Ground { seen: None, cell_ms }),
        None => Some(Ground { seen: Some(seen_maze(trace, guess_ms, maze.scale)?), cell_ms: guess_ms }),
    }
}

/// How far a drive is from a whole number of cells, in milliseconds.
fn off_lattice(ms: u32, cell_ms: u32) -> u64 {
    u64::from(ms).abs_diff(u64::from(cells_driven(ms, cell_ms)) * u64::from(cell_ms))
}

/// A stop on the lattice: where, arriving how, after how many cells, seeing what.
struct Stop {
    from: Point,
    at: Point,
    heading: Heading,
    cells: u32,
    step: Step,
}

/// The stops of a trace on a lattice, with the robot put down like this.
fn stops(trace: &Trace, cell_ms: u32, start: Start) -> impl Iterator<Item = Stop> {
    let mut from = start.at;
    trace.steps().iter().map(move |&step| {
        let heading = step.arrival().out_of_frame_of(start.heading);
        let cells = cells_driven(step.time_diff(), cell_ms);
        let at = from.ahead(heading, i32::try_from(cells).unwrap_or(0));
        Stop { from: core::mem::replace(&mut from, at), at, heading, cells, step }
    })
}

/// What has been seen as a maze: driven lines, and a cell of every way that was seen at a stop. The robot
/// was put down at 0,0, facing north. Nothing where it went too far for any maze.
#[must_use]
pub fn seen_maze(trace: &Trace, cell_ms: u32, scale: Scale) -> Option<Maze> {
    let start = Start { at: Point::new(0, 0), heading: Heading::North };
    let far = |stop: &Stop| stop.cells >= MAX_SIDE;
    if stops(trace, cell_ms, start).any(|stop| far(&stop)) {
        return None;
    }
    let around = |at: Point| Heading::ALL.into_iter().map(move |way| at.step(way));
    let points = stops(trace, cell_ms, start).flat_map(|stop| around(stop.at));
    let mut maze = Maze::new(Bounds::around(points.chain(around(start.at))).ok()?);
    maze.scale = scale;
    let mut finish = Vec::new();
    for stop in stops(trace, cell_ms, start) {
        for cell in 0..stop.cells as i32 {
            maze.draw(stop.from.ahead(stop.heading, cell), stop.heading);
        }
        let sighting = stop.step.sighting();
        for way in sighting.ways.out_of_frame_of(stop.heading).iter() {
            maze.draw(stop.at, way);
        }
        if sighting.finish == Finish::Yes {
            finish.push(stop.at);
        }
    }
    if trace.stops() == 0 {
        maze.draw(start.at, start.heading);
    }
    maze.set_start(Some(start));
    maze.set_finish(finish);
    Some(maze)
}

/// The first stop at which the robot saw something else than the maze has there; nothing where it fits.
#[must_use]
pub fn first_misfit(maze: &Maze, trace: &Trace, cell_ms: u32) -> Option<u32> {
    let Some(start) = maze.start() else { return Some(0) };
    let fits = |stop: &Stop| {
        let sighting = stop.step.sighting();
        let ways = sighting.ways.out_of_frame_of(stop.heading);
        let seen: Ways = if sighting.finish == Finish::Yes { maze.ways(stop.at) } else { ways };
        let driven = (0..stop.cells as i32)
            .all(|cell| maze.has_line(stop.from.ahead(stop.heading, cell), stop.heading));
        let finish = maze.is_finish(stop.at) == (sighting.finish == Finish::Yes);
        stop.cells < MAX_SIDE && driven && finish && maze.ways(stop.at) == seen
    };
    stops(trace, cell_ms, start).zip(1..).find(|(stop, _)| !fits(stop)).map(|(_, number)| number)
}
