//! A trace says at every moment what the explorer said and held when it ran, in whatever order it is asked.
#![allow(clippy::unwrap_used, clippy::expect_used)]

mod support;

use line_maze_lab::event::Decision;
use line_maze_lab::explorer::Explorer;
use line_maze_lab::explorer::book::code::Line;
use line_maze_lab::explorer::book::grid_store::GridStore;
use line_maze_lab::explorer::book::store::{FixedStore, Node, NodeStore};
use line_maze_lab::explorer::book::{Book, Event};
use line_maze_lab::geometry::{Heading, Turn, Ways};
use line_maze_lab::ink::Ink;
use line_maze_lab::maze::Maze;
use line_maze_lab::report::Report;
use line_maze_lab::run::{explore, explore_with, stop_limit};
use line_maze_lab::settings::{Order, Settings};
use line_maze_lab::trace::{Moment, Row, Trace, WayState, events};
use line_maze_lab::world::{Ideal, World, line_start};
use proptest::prelude::*;
use support::random::{orders, recipes, roomy};

/// The explorer's state after a stop, and what it said there.
struct Live {
    at: (i32, i32),
    bot_dir: Heading,
    returning: bool,
    nodes: Vec<Node>,
    told: Vec<Event>,
}

/// Every stop of a run, the start first, as the explorer itself has it.
fn live(maze: &Maze, settings: &Settings) -> Vec<Live> {
    let epsilon = settings.epsilon(maze.scale);
    let mut bot = Book::new(GridStore::new(settings.node_max, epsilon), settings.order, epsilon);
    let mut world = Ideal::new(maze, line_start(maze).unwrap(), settings.pace.cell_ms(maze.scale));
    let mut stops = vec![];
    let mut told = vec![];
    let mut decision = Decision::Go(Turn::Straight);
    loop {
        stops.push(Live {
            at: bot.coordinates(),
            bot_dir: bot.bot_dir(),
            returning: bot.returning(),
            nodes: (1..bot.ptr()).map(|m| *bot.nodes().node(m)).collect(),
            told: std::mem::take(&mut told),
        });
        let Decision::Go(turn) = decision else { return stops };
        let Ok(sighting) = world.drive(turn) else { return stops };
        if stops.len() > stop_limit(maze) as usize {
            return stops;
        }
        decision = bot.decide(sighting, |event| told.push(event));
    }
}

/// What the events of some lines make of the explorer's state.
fn apply(state: &mut Live, time_diff: u32, paths: Ways, event: Event, ran: Line) {
    match event {
        Event::Coordinates => {
            let (dx, dy) = state.bot_dir.vector();
            state.at.0 += dx * time_diff as i32;
            state.at.1 += dy * time_diff as i32;
        }
        Event::Recorded(_) => {
            let back = state.bot_dir.opposite();
            state.nodes.push(Node::new(state.at.0, state.at.1, paths, back));
        }
        Event::Ptr(ptr) => state.nodes.truncate(ptr as usize - 1),
        Event::Visited(m, way) => {
            let node = &mut state.nodes[m as usize - 1];
            node.vpaths = node.vpaths.with(way);
            if ran == Line::TAKE {
                node.last_path = Some(way);
            }
        }
        Event::Returning(returning) => state.returning = returning,
        Event::Turned(turn) => state.bot_dir = state.bot_dir.turned(turn),
        Event::Ran(_) | Event::Matched(_) | Event::Case(_) => {}
    }
}

/// A trace's moment shows this state.
fn shows(trace: &Trace, moment: Moment, live: &Live) -> Result<(), TestCaseError> {
    let state = trace.frame(moment).state;
    prop_assert_eq!((state.cur_x, state.cur_y), live.at);
    prop_assert_eq!((state.bot_dir, state.returning), (live.bot_dir, live.returning));
    prop_assert_eq!(state.ptr as usize, live.nodes.len() + 1);
    for (node, m) in live.nodes.iter().zip(1u32..) {
        let row = trace.row(moment, m).unwrap();
        prop_assert_eq!((row.number, row.node), (m, *node));
        let (none, open) = (row.node.paths.minus(node.paths), node.unvisited());
        for way in Heading::ALL {
            prop_assert_eq!(row.way(way) == WayState::None, !node.paths.has(way), "{:?}", none);
            prop_assert_eq!(row.way(way) == WayState::Unvisited, open.has(way));
        }
    }
    prop_assert_eq!(trace.row(moment, 0), None);
    prop_assert_eq!(trace.row(moment, state.ptr), None);
    let unvisited: Vec<(u32, Ways)> = live
        .nodes
        .iter()
        .zip(1u32..)
        .map(|(node, m)| (m, node.unvisited()))
        .filter(|(_, w)| !w.is_empty())
        .collect();
    prop_assert_eq!(trace.unvisited(moment, 1).collect::<Vec<_>>(), unvisited);
    Ok(())
}

/// Every stop and every line of it, against the explorer run by hand.
fn agrees(maze: &Maze, settings: &Settings, trace: &Trace) -> Result<(), TestCaseError> {
    let live = live(maze, settings);
    prop_assert_eq!(trace.stops() as usize, live.len() - 1);
    shows(trace, Moment::default(), &live[0])?;
    for (pair, stop) in live.windows(2).zip(1u32..) {
        let [before, after] = pair else { continue };
        let step = trace.step(stop).unwrap();
        prop_assert_eq!(&events(step, &trace.state(stop - 1)), &after.told, "stop {}", stop);
        shows(trace, Moment::after(stop), after)?;
        let mut now = Live { nodes: before.nodes.clone(), told: vec![], ..*before };
        let mut lines: Vec<Line> = vec![];
        let arrival = now.bot_dir;
        for (i, event) in after.told.iter().enumerate() {
            if let Event::Ran(line) = *event {
                lines.push(line);
            }
            let ran = *lines.last().unwrap();
            apply(&mut now, step.time_diff(), step.sighting().ways.out_of_frame_of(arrival), *event, ran);
            // The last event of a line.
            if matches!(after.told.get(i + 1), None | Some(Event::Ran(_))) {
                let moment = Moment { stop, lines: lines.len() as u8 };
                shows(trace, moment, &now)?;
                let next = after.told[i + 1..]
                    .first()
                    .map(|event| Event::Ran(trace.frame(moment).next.unwrap()) == *event);
                prop_assert_eq!(trace.frame(moment).ran, Some(ran));
                prop_assert_ne!(next, Some(false), "the line that is announced is the one that runs");
            }
        }
        prop_assert_eq!(trace.lines(stop) as usize, lines.len());
        prop_assert_eq!(
            (now.at, now.bot_dir, now.returning, now.nodes),
            (after.at, after.bot_dir, after.returning, after.nodes.clone())
        );
    }
    Ok(())
}

/// From the start by lines to the end, and back again over the same moments.
fn walks_by_line(trace: &Trace) -> Result<(), TestCaseError> {
    let mut there = vec![trace.clamp(Moment::default())];
    while let Some(&here) = there.last().filter(|&&here| here != trace.clamp(trace.end())) {
        let next = trace.line_after(here);
        prop_assert!(next > here, "{:?} then {:?}", here, next);
        there.push(next);
    }
    let lines: usize = (1..=trace.stops()).map(|stop| trace.lines(stop) as usize).sum();
    prop_assert_eq!(there.len(), lines + 1);
    prop_assert_eq!(trace.line_after(*there.last().unwrap()), *there.last().unwrap());
    let mut here = trace.end();
    for &before in there.iter().rev().skip(1) {
        here = trace.line_before(here);
        prop_assert_eq!(here, before);
    }
    prop_assert_eq!(trace.line_before(here), here);
    Ok(())
}

/// Asked in any order, a moment is always the same.
fn can_be_entered_anywhere(trace: &Trace, order: &[prop::sample::Index]) -> Result<(), TestCaseError> {
    let stops = trace.stops() as usize + 1;
    let view = |stop: usize| {
        let moment = Moment::after(stop as u32);
        let rows: Vec<Option<Row>> = (0..8).map(|m| trace.row(moment, m)).collect();
        (trace.frame(moment), rows)
    };
    let in_turn: Vec<_> = (0..stops).map(view).collect();
    for index in order {
        let stop = index.index(stops);
        prop_assert_eq!(&view(stop), &in_turn[stop]);
    }
    Ok(())
}

/// Epsilons that make coordinates wrong: nothing matches, or everything does.
fn any_epsilon() -> impl Strategy<Value = Option<u32>> {
    prop_oneof![
        Just(None),
        Just(Some(0)),
        Just(Some(1)),
        (1u32..8).prop_map(|n| Some(n * 200 + 1)),
        any::<u32>().prop_map(Some)
    ]
}

fn many(cases: u32) -> ProptestConfig {
    ProptestConfig { cases, failure_persistence: None, ..ProptestConfig::default() }
}

proptest! {
    #![proptest_config(many(1000))]

    #[test]
    fn a_trace_is_what_the_explorer_did(recipe in recipes(6), order in orders(), epsilon in any_epsilon()) {
        let maze = recipe.maze();
        // Mazes and tables are small, as every row is looked at in every line.
        let settings = Settings { epsilon_ms: epsilon, node_max: 20, ..roomy(order) };
        let trace = explore(&maze, &settings).unwrap();
        agrees(&maze, &settings, &trace)?;
        walks_by_line(&trace)?;
    }

    #[test]
    fn a_trace_can_be_entered_anywhere(
        recipe in recipes(12), order in orders(), moments in prop::collection::vec(any::<prop::sample::Index>(), 40)
    ) {
        let trace = explore(&recipe.maze(), &roomy(order)).unwrap();
        can_be_entered_anywhere(&trace, &moments)?;
    }

    #[test]
    fn both_tables_give_the_same_run(recipe in recipes(12), order in orders(), epsilon in any_epsilon()) {
        let maze = recipe.maze();
        let settings = Settings { epsilon_ms: epsilon, node_max: 40, ..roomy(order) };
        let indexed = explore(&maze, &settings).unwrap();
        let scanned = explore_with(&maze, &settings, FixedStore::<40>::new()).unwrap();
        prop_assert_eq!(indexed.outcome(), scanned.outcome());
        prop_assert_eq!(indexed.steps(), scanned.steps());
    }

    #[test]
    fn wrong_coordinates_end_and_are_told(recipe in recipes(20), order in orders(), epsilon in any_epsilon()) {
        let maze = recipe.maze();
        let settings = Settings { epsilon_ms: epsilon, ..roomy(order) };
        let trace = explore(&maze, &settings).unwrap();
        prop_assert!(trace.stops() <= stop_limit(&maze));
        let ink = Ink::of(&maze, &trace, settings.pace.cell_ms(maze.scale));
        prop_assert!(ink.crossed_cells(trace.stops()) <= ink.driven_cells(trace.stops()));
        let report = Report::of(&maze, &settings, &trace);
        prop_assert_eq!(report.stops, trace.stops());
        prop_assert_eq!(report.outcome == "finish", report.turns.is_some());
    }
}

#[test]
fn the_same_seed_prefers_the_same_ways() {
    let maze = support::figure_3_1();
    let run = |seed| explore(&maze, &roomy(Order::Random(seed))).unwrap().steps().to_vec();
    assert_eq!(run(7), run(7));
    assert!((0..20).any(|seed| run(seed) != run(7)));
}
