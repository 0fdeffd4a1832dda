//! What the explorers of the other sources cost, recording included, on a tree and on a tree with one link in ten
//! more.
//!
//! Budget on 1,000 × 1,000: hands, sums, path mapping and the Cornell traversals at most 150 ns a stop and
//! linear in what they drive; full mapping with both routes at most 2 s and 400 MB. Flood fill is exempt: each
//! new wall fills the whole field again, so a run grows with squares × stops (small fields show it).
#![allow(missing_docs, clippy::unwrap_used, clippy::expect_used)]

use std::hint::black_box;

use criterion::{BenchmarkId, Criterion, SamplingMode, Throughput, criterion_group, criterion_main};
use line_maze_lab::explorer::mapping::search::Aim;
use line_maze_lab::explorer::mind::Mind;
use line_maze_lab::explorer::name::Name;
use line_maze_lab::maze::Maze;
use line_maze_lab::maze::generate::{Recipe, generate};
use line_maze_lab::recording::Recording;
use line_maze_lab::run::{AnyRun, record};
use line_maze_lab::settings::Settings;

fn maze(side: u32, loops_percent: u8) -> Maze {
    let recipe =
        Recipe { width: side, height: side, loops_percent, dead_ends_cut_percent: 0, ..Recipe::default() };
    generate(&recipe).unwrap()
}

fn run(maze: &Maze, name: Name) -> Recording {
    match record(maze, &Settings::default(), name).unwrap() {
        AnyRun::Other(run) => run,
        AnyRun::Book(_) => unreachable!(),
    }
}

/// Nanoseconds a stop: criterion's time divided by its number of elements.
fn explore(c: &mut Criterion) {
    const NAMES: [Name; 11] = [
        Name::LeftHand,
        Name::RightHand,
        Name::DirectionSumLeft,
        Name::ParexLeft,
        Name::ParexRight,
        Name::Cornell1,
        Name::Cornell2,
        Name::Cornell3,
        Name::Mapping,
        Name::Tremaux,
        Name::DepthFirst,
    ];
    for (kind, loops) in [("tree", 0), ("loops 10 %", 10)] {
        for side in [200, 1000] {
            // Without a finish the drives are as long as they get.
            let mut maze = maze(side, loops);
            maze.set_finish(vec![]);
            let mut group = c.benchmark_group(format!("{kind}/{side}"));
            group.sampling_mode(SamplingMode::Flat).sample_size(10);
            for name in NAMES {
                group.throughput(Throughput::Elements(u64::from(run(&maze, name).stops())));
                group.bench_function(name.text(), |b| b.iter(|| run(&maze, name)));
            }
            group.finish();
        }
    }
}

/// The map and both routes.
fn routes(c: &mut Criterion) {
    let mut maze = maze(1000, 10);
    maze.set_finish(vec![maze.bounds().ne()]);
    let mut group = c.benchmark_group("mapping/1000");
    group.sampling_mode(SamplingMode::Flat).sample_size(10);
    group.bench_function("with both routes", |b| {
        b.iter(|| {
            let run = run(&maze, Name::Mapping);
            let Mind::Mapping(map) = run.last() else { unreachable!() };
            assert!(black_box(map.route(Aim::Shortest)).is_some());
            assert!(black_box(map.route(Aim::Quickest)).is_some());
            run.bytes()
        });
    });
    group.finish();
}

fn flood(c: &mut Criterion) {
    let mut group = c.benchmark_group("flood-fill");
    group.sampling_mode(SamplingMode::Flat).sample_size(10);
    for side in [25, 50, 100] {
        let mut maze = maze(side, 10);
        maze.set_finish(vec![maze.bounds().ne()]);
        group.throughput(Throughput::Elements(u64::from(run(&maze, Name::FloodFill).stops())));
        group.bench_with_input(BenchmarkId::from_parameter(side), &maze, |b, maze| {
            b.iter(|| run(maze, Name::FloodFill));
        });
    }
    group.finish();
}

/// Entering a long recording anywhere.
fn jump(c: &mut Criterion) {
    let maze = maze(200, 10);
    for name in [Name::RightHand, Name::Mapping, Name::Cornell3] {
        let run = run(&maze, name);
        let mut chance = oorandom::Rand32::new(1);
        c.bench_function(&format!("jump/{name}/{} stops", run.stops()), |b| {
            b.iter(|| black_box(run.at(chance.rand_range(0..run.stops()))));
        });
    }
}

criterion_group!(benches, explore, routes, flood, jump);
criterion_main!(benches);
