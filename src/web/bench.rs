//! Measurements in this browser, in development builds only: `#bench`.

use std::time::Duration;

use crate::web::erase::{mouse, part, sig};
use leptos::prelude::*;

use super::browser;
use super::lazy::lazy;
use crate::explorer::name::Name;
use crate::maze::Maze;
use crate::maze::generate::{Recipe, generate};
use crate::playback::Timeline;
use crate::route::best;
use crate::run::record;
use crate::settings::{Pace, Settings};

lazy! { bench;
    /// The page.
    pub fn room() -> AnyView {
        view! { <Bench /> }.into_any()
    }
}

/// Points a side of the maze that explorers run through; flood fill grows too fast for it.
const SIDE: u32 = 200;
const FLOOD_SIDE: u32 = 32;
/// Points a side of the maze whose shortest path is looked for.
const KNOWN_SIDE: u32 = 500;

/// What is measured, one at a time, so that the page shows how far it is.
#[derive(Clone, Copy)]
enum Task {
    Explorer(Name),
    Shortest,
}

/// A line of the table: what, how long, and the budget.
type Line = (String, String, String);

#[component]
fn Bench() -> impl IntoView {
    let lines = RwSignal::new(Vec::<Line>::new());
    let running = RwSignal::new(false);
    let begin = move |_| {
        lines.set(Vec::new());
        running.set(true);
        let tasks = Name::ALL.iter().copied().map(Task::Explorer);
        next(lines, running, [Task::Shortest].into_iter().chain(tasks).collect());
    };
    let row = |(what, took, budget): Line| view! { <tr><td>{what}</td><td class="num">{took}</td><td>{budget}</td></tr> };
    view! {
        <main class="main bench" id="main" tabindex="-1">
            <h1 class="vh">"Benches"</h1>
            <section class="card">
                <h2>"Benches in this browser"</h2>
                <div class="pad stack">
                    <p class="small">"The median of five. Only a release build says anything: cargo xtask serve --release."</p>
                    <div class="row"><button class="btn primary" disabled=sig(move || running.get()) on:click=mouse(begin)>"Run"</button></div>
                    <table><thead><tr><th scope="col">"What"</th><th scope="col" class="num">"Took"</th><th scope="col">"Budget"</th></tr></thead>
                        <tbody id="benches">{part(move || lines.get().into_iter().map(row).collect_view())}</tbody></table>
                    <p class="small" role="status">{part(move || if running.get() { "Measuring…" } else { "" })}</p>
                </div>
            </section>
        </main>
    }
}

fn next(lines: RwSignal<Vec<Line>>, running: RwSignal<bool>, mut tasks: Vec<Task>) {
    let work = move || {
        // The page may be left already.
        if running.try_get_untracked().is_none() {
            return;
        }
        if tasks.is_empty() {
            return running.set(false);
        }
        let line = measure(tasks.remove(0));
        lines.update(|lines| lines.push(line));
        next(lines, running, tasks);
    };
    set_timeout(work, Duration::from_millis(20));
}

fn measure(task: Task) -> Line {
    let settings = Settings { node_max: 1 << 19, ..Settings::default() };
    match task {
        Task::Shortest => {
            let maze = maze(KNOWN_SIDE);
            let seconds = median(|| {
                maze.start().map_or(0, |start| {
                    best::shortest(&maze, start, &Pace::default()).map_or(0, |best| best.cells)
                })
            });
            (
                format!("Shortest path, {KNOWN_SIDE} × {KNOWN_SIDE}, 10 % loops"),
                format!("{:.1} ms", seconds * 1e3),
                "20 ms".into(),
            )
        }
        Task::Explorer(name) => {
            let side = if name == Name::FloodFill { FLOOD_SIDE } else { SIDE };
            let maze = maze(side);
            let mut stops = 0;
            let seconds = median(|| {
                stops = record(&maze, &settings, name).map_or(0, |run| run.stops());
                stops
            });
            let each = seconds * 1e9 / f64::from(stops.max(1));
            (
                format!("{name}, {side} × {side}, {stops} stops"),
                format!("{each:.0} ns a stop"),
                "150 ns native".into(),
            )
        }
    }
}

fn maze(side: u32) -> Maze {
    let recipe = Recipe {
        width: side,
        height: side,
        loops_percent: 10,
        dead_ends_cut_percent: 0,
        seed: 1924,
        ..Recipe::default()
    };
    generate(&recipe).unwrap_or_else(|_| crate::maze::samples::figure_3_1())
}

/// The median of five, in seconds.
fn median(mut work: impl FnMut() -> u32) -> f64 {
    let mut times = [0.0; 5];
    for time in &mut times {
        let begin = browser::now_s();
        std::hint::black_box(work());
        *time = browser::now_s() - begin;
    }
    times.sort_by(f64::total_cmp);
    times[2]
}
