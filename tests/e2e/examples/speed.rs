//! How quick the page is in this browser: a step, a scrub, opening a large maze, a robot that
//! tells 100 lines a second. It only prints; `cargo xtask speed` builds the page and runs it.

#![allow(missing_docs, clippy::print_stdout)]

use anyhow::{Context, Result};
use e2e::{Page, Setup, lab};
use line_maze_lab::maze::generate::{Recipe, generate};
use line_maze_lab::maze::text;
use line_maze_lab::run::explore;
use line_maze_lab::settings::Settings;
use serde_json::json;

/// Does something many times, each time from the event to the finished layout, views and frame included; the
/// milliseconds, sorted. What a frame's callbacks do is in it, waiting for the frame is not.
const TIMES: &str = "async (many, act) => {
    const settled = () => new Promise((done) => {
        const { port1, port2 } = new MessageChannel();
        port1.onmessage = done;
        port2.postMessage(0);
    });
    const layout = () => document.body.getBoundingClientRect();
    const frames = [];
    const ask = window.requestAnimationFrame.bind(window);
    window.requestAnimationFrame = (call) => ask((at) => {
        const begin = performance.now();
        call(at);
        frames.push(performance.now() - begin);
    });
    const took = [];
    for (let i = 0; i < many; i += 1) {
        await new Promise(ask);
        await settled();
        frames.length = 0;
        const begin = performance.now();
        act(i);
        await settled();
        layout();
        const events = performance.now() - begin;
        await new Promise(ask);
        await settled();
        const after = performance.now();
        layout();
        took.push(events + frames.reduce((sum, ms) => sum + ms, 0) + performance.now() - after);
    }
    window.requestAnimationFrame = ask;
    return took.sort((a, b) => a - b);
}";

const STEP: &str =
    "(i) => document.body.dispatchEvent(new KeyboardEvent('keydown', { key: 'ArrowRight', bubbles: true }))";

const SCRUB: &str = "(i) => {
    const time = document.querySelector('.time');
    const { left, width, top } = time.getBoundingClientRect();
    const at = left + width * ((i * 0.381966) % 1);
    const event = (kind) => new PointerEvent(kind, { clientX: at, clientY: top + 20, pointerId: 1, bubbles: true });
    time.dispatchEvent(event('pointerdown'));
    time.dispatchEvent(event('pointerup'));
}";

/// Nodes that the bot can remember here.
const NODE_MAX: u32 = 100_000;

/// Of twenty mazes of this size, the one that takes the book's explorer longest.
fn maze(side: u32) -> Result<String> {
    let settings = Settings { node_max: NODE_MAX, ..Settings::default() };
    let mut longest = (0, String::new());
    for seed in 1..=20 {
        let recipe = Recipe {
            width: side,
            height: side,
            loops_percent: 10,
            dead_ends_cut_percent: 0,
            seed,
            ..Recipe::default()
        };
        let maze = generate(&recipe)?;
        let stops = explore(&maze, &settings)?.stops();
        if stops > longest.0 {
            longest = (stops, text::write(&maze));
        }
    }
    Ok(longest.1)
}

fn setup(side: u32) -> Result<Setup> {
    Ok(Setup::default().stored("maze", &maze(side)?).stored("settings", &format!("node_max={NODE_MAX}")))
}

/// Median and the ninth of ten.
async fn times(page: &Page, what: &str, many: u32, act: &str) -> Result<()> {
    let took = page.promised(&format!("({TIMES})({many}, {act})")).await?;
    let took: Vec<f64> = took.as_array().context("no list")?.iter().filter_map(|ms| ms.as_f64()).collect();
    let at = |share: usize| took[(took.len() * share / 10).min(took.len() - 1)];
    println!("{what:<44} median {:6.1} ms   9 of 10 within {:6.1} ms", at(5), at(9));
    Ok(())
}

async fn run_through(side: u32) -> Result<()> {
    lab(setup(side)?, async |page| {
        page.wait_for("svg.maze[data-stop]").await?;
        let stops = page.eval("document.querySelector('.time').getAttribute('aria-valuemax')").await?;
        println!("{side} × {side} points, {} stops", stops.as_str().unwrap_or("?"));
        times(page, "  a step", 200, STEP).await?;
        times(page, "  a scrub", 100, SCRUB).await
    })
    .await
}

/// From the paste to the finished layout.
async fn opening(side: u32) -> Result<()> {
    let mazes = json!([maze(side)?, maze(side - 1)?]);
    lab(Setup::default().stored("settings", &format!("node_max={NODE_MAX}")), async |page| {
        page.wait_for("svg.maze[data-stop]").await?;
        page.call("(mazes) => { window.mazes = mazes; }", &[mazes]).await?;
        let paste = "(i) => {
            const clipboardData = new DataTransfer();
            clipboardData.setData('text/plain', window.mazes[i % 2]);
            document.body.dispatchEvent(new ClipboardEvent('paste', { clipboardData, bubbles: true, cancelable: true }));
        }";
        times(page, &format!("opening {side} × {side}"), 10, paste).await
    })
    .await
}

/// How much of each frame the page uses while a robot tells 100 sensor lines a second, and explores.
async fn telemetry() -> Result<()> {
    lab(Setup::default().at("connect"), async |page| {
        page.wait_for("#demo").await?;
        page.click("Demo robot").await?;
        page.wait_until("document.querySelector('#tune-line4')?.value === '400'").await?;
        page.click("I put it back").await?;
        page.wait_until("!document.querySelector('#explore').disabled").await?;
        page.click("Explore").await?;
        page.tools("Performance.enable", json!({})).await?;
        let spent = async || -> Result<(f64, f64)> {
            let metrics = page.tools("Performance.getMetrics", json!({})).await?;
            let of = |name: &str| {
                let all = metrics["metrics"].as_array().into_iter().flatten();
                all.filter(|metric| metric["name"] == name).find_map(|metric| metric["value"].as_f64())
            };
            let busy = ["ScriptDuration", "RecalcStyleDuration", "LayoutDuration"].into_iter().filter_map(of).sum();
            Ok((of("Timestamp").context("no time")?, busy))
        };
        let frames = "new Promise((done) => { let left = 300; const next = () => (left -= 1) ? requestAnimationFrame(next) : done(300); next(); })";
        let (begin, before) = spent().await?;
        page.promised(frames).await?;
        let (end, after) = spent().await?;
        println!(
            "100 lines a second, live run: of a frame of {:.1} ms, script, style and layout take {:.1} ms",
            (end - begin) / 300.0 * 1e3,
            (after - before) / 300.0 * 1e3
        );
        Ok(())
    })
    .await
}

#[tokio::main(flavor = "current_thread")]
async fn main() -> Result<()> {
    run_through(60).await?;
    run_through(200).await?;
    opening(200).await?;
    telemetry().await
}
