//! What the core costs: a stop of exploring, a jump in a trace, the floor, and maze files.
//!
//! Budget: at most 100 ns a stop with the trace on, whatever the maze's size; a jump costs the same at the start, in
//! the middle and at the end of a trace.
#![allow(missing_docs, clippy::unwrap_used, clippy::expect_used)]

use std::hint::black_box;

use criterion::{BenchmarkId, Criterion, SamplingMode, Throughput, criterion_group, criterion_main};
use line_maze_lab::compare::league::{Course, League};
use line_maze_lab::explorer::name::Name;
use line_maze_lab::ink::Ink;
use line_maze_lab::maze::generate::{Recipe, generate};
use line_maze_lab::maze::{Maze, checks, json, text};
use line_maze_lab::route::best;
use line_maze_lab::run::explore;
use line_maze_lab::settings::Settings;
use line_maze_lab::trace::{MAX_NODES, Moment, Trace};

fn maze(side: u32, loops_percent: u8) -> Maze {
    let recipe =
        Recipe { width: side, height: side, loops_percent, dead_ends_cut_percent: 0, ..Recipe::default() };
    let mut maze = generate(&recipe).unwrap();
    // Without a finish every line is driven.
    maze.set_finish(vec![]);
    maze
}

fn settings() -> Settings {
    Settings { node_max: MAX_NODES, ..Settings::default() }
}

fn run(maze: &Maze) -> Trace {
    explore(maze, &settings()).unwrap()
}

/// Nanoseconds a stop: criterion's time divided by its number of elements.
fn explorer(c: &mut Criterion) {
    for (name, loops) in [("explore/tree", 0), ("explore/loops 10 %", 10)] {
        let mut group = c.benchmark_group(name);
        group.sampling_mode(SamplingMode::Flat).sample_size(10);
        for side in [60, 200, 1000] {
            let maze = maze(side, loops);
            group.throughput(Throughput::Elements(u64::from(run(&maze).stops())));
            group.bench_with_input(BenchmarkId::from_parameter(side), &maze, |b, maze| b.iter(|| run(maze)));
        }
        group.finish();
    }
}

/// Entering a trace of more than a million stops.
fn jump(c: &mut Criterion) {
    let trace = run(&maze(1000, 0));
    let stops = trace.stops();
    assert!(stops >= 1_000_000, "{stops} stops");
    let mut group = c.benchmark_group("jump");
    for (place, around) in [("start", 500), ("middle", stops / 2), ("end", stops - 500)] {
        let mut stop = around;
        group.bench_function(BenchmarkId::new("frame", place), |b| {
            b.iter(|| {
                stop = around - 500 + (stop * 7 + 3) % 1000;
                black_box(trace.frame(Moment::after(stop)))
            });
        });
        group.bench_function(BenchmarkId::new("row", place), |b| {
            b.iter(|| {
                stop = around - 500 + (stop * 7 + 3) % 1000;
                black_box(trace.row(Moment::after(stop), 1 + stop % 40))
            });
        });
    }
    let mut chance = oorandom::Rand32::new(1);
    group.bench_function("frame/anywhere", |b| {
        b.iter(|| black_box(trace.frame(Moment::after(chance.rand_range(0..stops)))));
    });
    group.finish();
}

/// What follows a run of a large maze.
fn floor(c: &mut Criterion) {
    let maze = maze(1000, 10);
    let trace = run(&maze);
    let mut group = c.benchmark_group("floor");
    group.sampling_mode(SamplingMode::Flat).sample_size(10);
    group.throughput(Throughput::Elements(u64::from(trace.stops())));
    group.bench_function("ink", |b| b.iter(|| Ink::of(&maze, &trace, 400)));
    let mut goal = maze.clone();
    goal.set_finish(vec![goal.bounds().ne()]);
    group.bench_function("best", |b| {
        b.iter(|| best::fastest(&goal, goal.start().unwrap(), &settings().pace).unwrap());
    });
    group.finish();
}

/// The best routes of a maze that is known. Budget: the shortest of 500 × 500 in at most 10 ms.
fn routes(c: &mut Criterion) {
    let mut maze = maze(500, 10);
    maze.set_finish(vec![maze.bounds().ne()]);
    let (start, pace) = (maze.start().unwrap(), settings().pace);
    let mut group = c.benchmark_group("routes/500 × 500");
    group.bench_function("shortest", |b| b.iter(|| best::shortest_route(&maze, start, &pace).unwrap()));
    group.bench_function("fastest", |b| b.iter(|| best::fastest_route(&maze, start, &pace).unwrap()));
    group.finish();
}

/// Eight explorers over 500 mazes of 16 × 16 on one core. Budget: at most 2 s on two.
fn league(c: &mut Criterion) {
    let recipe = Recipe { width: 16, height: 16, ..Recipe::default() };
    let names = Name::ALL[..8].to_vec();
    let league = League { names, settings: settings(), courses: Course::generated(recipe, 500).collect() };
    let mut group = c.benchmark_group("league");
    group.sampling_mode(SamplingMode::Flat).sample_size(10);
    group.bench_function("8 explorers × 500 mazes", |b| {
        b.iter(|| (0..500).map(|course| league.run(course)).collect::<Vec<_>>());
    });
    group.finish();
}

/// A maze of 200 × 200 points.
fn files(c: &mut Criterion) {
    let maze = maze(200, 10);
    let (drawing, list) = (text::write(&maze), json::write(&maze));
    let mut group = c.benchmark_group("200 × 200");
    group.bench_function("parse text", |b| b.iter(|| text::parse(&drawing).unwrap()));
    group.bench_function("parse JSON", |b| b.iter(|| json::parse(&list).unwrap()));
    group.bench_function("check", |b| b.iter(|| checks::check(&maze)));
    group.finish();
}

criterion_group!(benches, explorer, jump, floor, routes, league, files);
criterion_main!(benches);
