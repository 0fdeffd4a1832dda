//! What holds in every maze: the explorer is right, round 2 arrives, and the floor tells the same story.
#![allow(clippy::unwrap_used, clippy::expect_used)]

mod support;

use std::collections::{HashMap, HashSet};

use line_maze_lab::event::Outcome;
use line_maze_lab::explorer::book::Case;
use line_maze_lab::geometry::{Heading, Point, Turn};
use line_maze_lab::ink::{Cell, CellState, Ink};
use line_maze_lab::maze::{Maze, Start};
use line_maze_lab::report::Report;
use line_maze_lab::route::{Route, TurnList, best};
use line_maze_lab::run::explore;
use line_maze_lab::settings::{Pace, Settings};
use line_maze_lab::trace::{MAX_NODES, Trace};
use proptest::prelude::*;
use support::random::{Recipe, orders, recipes, roomy};

const CELL_MS: u32 = 400;

/// Points that can be reached along lines, and the cells of line between them.
fn reachable(maze: &Maze) -> (HashSet<Point>, usize) {
    let mut met = HashSet::from([maze.start().unwrap().at]);
    let mut todo: Vec<Point> = met.iter().copied().collect();
    while let Some(at) = todo.pop() {
        todo.extend(maze.ways(at).iter().map(|way| at.step(way)).filter(|&next| met.insert(next)));
    }
    let ways: u32 = met.iter().map(|&at| maze.ways(at).count()).sum();
    (met, ways as usize / 2)
}

/// A cell by its southern or western end.
fn cell(at: Point, heading: Heading) -> Cell {
    match heading {
        Heading::North | Heading::East => (at, heading),
        Heading::South | Heading::West => (at.step(heading), heading.opposite()),
    }
}

/// The cells driven towards each stop, in order.
fn drives(trace: &Trace, start: Start) -> Vec<Vec<Cell>> {
    let mut at = start.at;
    let drive = |step: &line_maze_lab::trace::Step| {
        let heading = step.arrival().out_of_frame_of(start.heading);
        let go = |_| {
            let driven = cell(at, heading);
            at = at.step(heading);
            driven
        };
        (0..step.time_diff() / CELL_MS).map(go).collect()
    };
    trace.steps().iter().map(drive).collect()
}

/// The cells of a route, in order.
fn route_cells(route: &Route) -> Vec<Cell> {
    let mut at = route.start;
    let mut cells = Vec::new();
    for leg in &route.legs {
        for _ in 0..leg.cells {
            cells.push(cell(at, leg.heading));
            at = at.step(leg.heading);
        }
    }
    cells
}

/// Seconds of the quickest way, cell by cell and with turning round, relaxed until nothing changes.
fn quickest(maze: &Maze, pace: &Pace) -> Option<f64> {
    let (bounds, start) = (maze.bounds(), maze.start().unwrap());
    let mut least = vec![f64::INFINITY; bounds.len() * 4];
    let place = |at: Point, heading: Heading| bounds.index(at).unwrap() * 4 + heading as usize;
    least[place(start.at, start.heading)] = 0.0;
    let mut todo = vec![(start.at, start.heading)];
    let mut arrival = f64::INFINITY;
    while let Some((at, heading)) = todo.pop() {
        let so_far = least[place(at, heading)];
        if maze.is_finish(at) {
            arrival = arrival.min(so_far + pace.stop_s);
            continue;
        }
        for turn in Turn::ALL.into_iter().filter(|&turn| maze.has_line(at, heading.turned(turn))) {
            let stops = at != start.at && (turn != Turn::Straight || maze.ways(at).count() > 2);
            let stop = if stops { pace.stop_s } else { 0.0 };
            let cost = so_far + stop + pace.seconds(turn) + maze.scale.cell_mm() / pace.speed_mm_s;
            let next = (at.step(heading.turned(turn)), heading.turned(turn));
            if cost < least[place(next.0, next.1)] - 1e-9 {
                least[place(next.0, next.1)] = cost;
                todo.push(next);
            }
        }
    }
    arrival.is_finite().then_some(arrival)
}

/// The explorer finds a finish that can be reached, and knows when there is none; it never takes a place for
/// a new node twice.
fn explores(maze: &Maze, trace: &Trace) -> Result<(), TestCaseError> {
    let (points, cells) = reachable(maze);
    let start = maze.start().unwrap();
    let can_finish = points.iter().any(|&at| maze.is_finish(at));
    let expected = if can_finish { Outcome::Finish } else { Outcome::NoFinishReachable };
    prop_assert_eq!(trace.outcome(), expected);
    let ink = Ink::of(maze, trace, CELL_MS);
    let mut recorded = HashSet::new();
    for (step, stop) in trace.steps().iter().zip(1u32..) {
        if step.case() == Case::New {
            prop_assert!(recorded.insert(ink.place(stop)), "stop {}: recorded twice", stop);
        }
    }
    if !can_finish {
        prop_assert_eq!(ink.driven_cells(trace.stops()) as usize, cells);
        prop_assert_eq!(ink.crossed_cells(trace.stops()) as usize, cells);
        prop_assert_eq!(ink.place(trace.stops()), start.at);
    }
    Ok(())
}

/// Round 2 drives the turn list without turning round, over no point twice, along what is driven and not
/// crossed out.
fn drives_round_2(maze: &Maze, trace: &Trace) -> Result<(), TestCaseError> {
    let Some(list) = TurnList::of(trace) else {
        prop_assert_ne!(trace.outcome(), Outcome::Finish);
        return Ok(());
    };
    prop_assert!(!list.turns().contains(&Turn::Back));
    let route = Route::drive(maze, &list).map_err(|strayed| TestCaseError::fail(strayed.to_string()))?;
    prop_assert!(maze.is_finish(route.legs.last().unwrap().at));
    let cells = route_cells(&route);
    prop_assert_eq!(cells.len(), route.cells() as usize);
    let mut at = route.start;
    let mut met = HashSet::from([at]);
    for leg in &route.legs {
        for _ in 0..leg.cells {
            at = at.step(leg.heading);
            prop_assert!(met.insert(at), "{} twice", at);
        }
    }
    let (ink, end) = (Ink::of(maze, trace, CELL_MS), trace.stops());
    prop_assert_eq!(ink.driven_cells(end) - ink.crossed_cells(end), route.cells());
    for cell in cells {
        prop_assert_eq!(ink.cell(cell, end), CellState::Driven);
    }
    Ok(())
}

/// At every stop, what is driven and not crossed out is the way from the start to the bot; a crossed-out
/// cell is never driven again, and none is driven more than twice.
fn crosses_out(maze: &Maze, trace: &Trace) -> Result<(), TestCaseError> {
    let ink = Ink::of(maze, trace, CELL_MS);
    let mut way: Vec<Cell> = Vec::new();
    let mut reach = HashMap::new();
    let mut driven: Vec<Cell> = Vec::new();
    let mut told = vec![Vec::new()];
    for (stop, drive) in (1u32..).zip(drives(trace, maze.start().unwrap())) {
        for cell in drive {
            prop_assert_ne!(ink.cell(cell, stop - 1), CellState::Crossed, "{:?} is driven at {}", cell, stop);
            driven.push(cell);
            // Going back over the way's end takes it back; anything else makes it longer.
            if way.last() == Some(&cell) {
                way.pop();
            } else {
                way.push(cell);
            }
        }
        let step = trace.step(stop).unwrap();
        match step.case() {
            Case::New => {
                reach.insert(step.node(), way.len());
            }
            // The loop that is just closed is left out.
            Case::UnknownBack => way.truncate(reach[&step.node()]),
            _ => {}
        }
        let now: HashSet<Cell> =
            ink.cells(stop).filter(|(_, state)| *state == CellState::Driven).map(|(cell, _)| cell).collect();
        prop_assert_eq!(&now, &way.iter().copied().collect::<HashSet<Cell>>(), "stop {}", stop);
        prop_assert_eq!(now.len(), way.len());
        prop_assert_eq!(ink.driven_cells(stop) - ink.crossed_cells(stop), way.len() as u32);
        told.push(ink.cells(stop).collect());
    }
    for (stop, cells) in told.into_iter().enumerate().rev() {
        prop_assert_eq!(ink.cells(stop as u32).collect::<Vec<_>>(), cells, "backwards to stop {}", stop);
    }
    driven.sort_unstable();
    let thrice = driven.windows(3).find(|cells| cells[0] == cells[2]);
    prop_assert_eq!(thrice, None, "driven three times");
    Ok(())
}

/// The best routes are what a slow and simple search finds, and no run beats them.
fn compares(maze: &Maze, settings: &Settings, trace: &Trace) -> Result<(), TestCaseError> {
    let (start, pace) = (maze.start().unwrap(), &settings.pace);
    let (shortest, fastest) = (best::shortest(maze, start, pace), best::fastest(maze, start, pace));
    // When only driving costs time, a cell takes a second.
    let one = Pace { speed_mm_s: maze.scale.cell_mm(), turn_s: 0.0, uturn_s: 0.0, stop_s: 0.0 };
    prop_assert_eq!(shortest.map(|best| f64::from(best.cells)), quickest(maze, &one));
    match (fastest.map(|best| best.seconds), quickest(maze, pace)) {
        (Some(ours), Some(slow)) => prop_assert!((ours - slow).abs() < 1e-6, "{} {}", ours, slow),
        (ours, slow) => prop_assert_eq!(ours, slow),
    }
    let report = Report::of(maze, settings, trace);
    if let (Some(shortest), Some(fastest)) = (shortest, fastest) {
        prop_assert!(shortest.cells <= fastest.cells);
        prop_assert!(fastest.seconds <= shortest.seconds + 1e-9);
        prop_assert!(report.route_cells >= report.shortest_cells && report.ratio_shortest >= Some(1.0));
        prop_assert!(report.route_s >= report.fastest_s && report.ratio_fastest >= Some(1.0));
    }
    prop_assert!(report.distance_cells as usize <= 2 * maze.cells());
    Ok(())
}

/// The longest table of the run decides whether a smaller one is full.
fn fills_up(maze: &Maze, settings: &Settings, trace: &Trace, capacity: u32) -> Result<(), TestCaseError> {
    let first = trace.steps().iter().position(|step| step.node() > capacity);
    let small = explore(maze, &Settings { node_max: capacity, ..*settings }).unwrap();
    match first {
        None => prop_assert_eq!(small.outcome(), trace.outcome()),
        Some(first) => {
            prop_assert_eq!(small.outcome(), Outcome::TableFull { capacity });
            prop_assert_eq!(small.stops() as usize, first + 1);
            prop_assert_eq!(&small.steps()[..first], &trace.steps()[..first]);
            prop_assert_eq!(small.state(small.stops()).ptr, capacity + 1);
        }
    }
    Ok(())
}

/// Failures print their recipe; it belongs into a named test, not into a file of seeds.
fn many(cases: u32) -> ProptestConfig {
    ProptestConfig { cases, failure_persistence: None, ..ProptestConfig::default() }
}

fn paces() -> impl Strategy<Value = Pace> {
    let seconds = || prop_oneof![Just(0.0), 0.0..3.0];
    (50.0..1000.0, seconds(), seconds(), seconds()).prop_map(|(speed_mm_s, turn_s, uturn_s, stop_s)| Pace {
        speed_mm_s,
        turn_s,
        uturn_s,
        stop_s,
    })
}

proptest! {
    #![proptest_config(many(3000))]

    #[test]
    fn small_mazes_are_explored_rightly(recipe in recipes(9), order in orders(), capacity in 1u32..60) {
        let (maze, settings) = (recipe.maze(), roomy(order));
        let trace = explore(&maze, &settings).unwrap();
        explores(&maze, &trace)?;
        drives_round_2(&maze, &trace)?;
        crosses_out(&maze, &trace)?;
        fills_up(&maze, &settings, &trace, capacity)?;
    }

    #[test]
    fn the_best_routes_are_the_best(recipe in recipes(8), order in orders(), pace in paces()) {
        let (maze, settings) = (recipe.maze(), Settings { pace, ..roomy(order) });
        let trace = explore(&maze, &settings).unwrap();
        compares(&maze, &settings, &trace)?;
    }
}

proptest! {
    #![proptest_config(many(150))]

    #[test]
    fn large_mazes_are_explored_rightly(recipe in recipes(60), order in orders()) {
        let maze = recipe.maze();
        let trace = explore(&maze, &roomy(order)).unwrap();
        explores(&maze, &trace)?;
        drives_round_2(&maze, &trace)?;
        small_trace(&trace)?;
    }
}

/// A trace takes at most 13 bytes a stop, and the first keyframe.
fn small_trace(trace: &Trace) -> Result<(), TestCaseError> {
    prop_assert!(trace.bytes() <= 13 * trace.stops() as usize + 64, "{} bytes", trace.bytes());
    Ok(())
}

/// A straight line with a stub at every point: every stop on the way to the finish is a new node.
#[test]
fn a_trace_of_nothing_but_new_nodes_is_small() {
    let lines: Vec<Vec<(i32, i32)>> =
        (1..998).map(|y| vec![(0, y), (1, y)]).chain([vec![(0, 0), (0, 998)]]).collect();
    let lines: Vec<&[(i32, i32)]> = lines.iter().map(Vec::as_slice).collect();
    let maze = support::maze(&lines, (0, 0, Heading::North), &[(0, 998)]);
    let trace = explore(&maze, &roomy(Settings::default().order)).unwrap();
    assert_eq!(trace.stops(), 998);
    assert_eq!(trace.state(997).ptr, 998);
    small_trace(&trace).unwrap();
}

#[test]
fn the_51st_node_fills_the_book_s_table() {
    let recipe =
        Recipe { width: 40, height: 40, loops: 0, gaps: 0, finishes: 0, heading: Heading::North, seed: 1 };
    let maze = recipe.maze();
    let trace = explore(&maze, &Settings::default()).unwrap();
    assert_eq!(trace.outcome(), Outcome::TableFull { capacity: 50 });
    assert_eq!(trace.outcome().to_string(), "node table full (50)");
    let roomy = explore(&maze, &Settings { node_max: MAX_NODES, ..Settings::default() }).unwrap();
    assert_eq!(roomy.outcome(), Outcome::NoFinishReachable);
}
