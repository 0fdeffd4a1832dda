//! The stepper: the maze as the run leaves it, what just happened, the bot's memory, the algorithm, time.

use crate::web::erase::{mouse, part, sig};
use leptos::prelude::*;

use super::state::{Dialog, Lab, Room, Round, lab};
use crate::maze::Kind;

pub mod code;
mod errata;
pub mod now;
pub mod result;
pub mod scene;
pub mod table;
pub mod transport;
pub mod walled;

pub use errata::ErratumNote;
pub use now::{Length, Said};
pub use scene::Stage;

/// The room.
#[component]
pub fn StepRoom() -> impl IntoView {
    let lab = lab();
    let cannot = Memo::new(move |_| lab.run.with(|run| run.as_ref().err().copied()));
    view! {
        <main class="main" id="main" tabindex="-1">
            <h1 class="vh">"Step"</h1>
            <section class="stage" aria-label="Maze">
                <div>
                    <StageBar><Legend /></StageBar>
                    <super::notes::BrokenLink />
                    <GuestNote />
                </div>
                <Stage />
            </section>
            <div class="side">
                {part(move || match cannot.get() {
                    Some(why) => view! { <CannotRun why=why.to_string() /> }.into_any(),
                    None => view! {
                        <now::NowCard />
                        {part(move || (lab.round.get() == Round::Explore).then(|| view! { <table::NodeTable /> }))}
                        {part(move || match lab.round.get() {
                            Round::Explore => view! { <code::CodeCard /> }.into_any(),
                            Round::Solved => view! { <result::SolvedCard /> }.into_any(),
                        })}
                    }
                    .into_any(),
                })}
            </div>
        </main>
        <footer class="transport-bar" aria-label="Run">
            <transport::Transport />
        </footer>
    }
}

/// The maze's name and size, the legend, robot's eye.
#[component]
pub fn StageBar(children: Children) -> impl IntoView {
    let lab = lab();
    let title = move || {
        lab.stage.with(|maze| {
            if maze.about.title.is_empty() { "Untitled maze".to_owned() } else { maze.about.title.clone() }
        })
    };
    let size = move || {
        lab.stage.with(|maze| {
            let many = |n: usize, one: &str| format!("{n} {one}{}", if n == 1 { "" } else { "s" });
            let cells = match maze.kind {
                Kind::Line => many(maze.cells(), "cell") + " of line",
                Kind::Wall => many(maze.cells(), "opening"),
            };
            format!("{cells} · {} · {}", many(maze.nodes(), "node"), many(maze.loops(), "loop"))
        })
    };
    view! {
        <div class="bar">
            <b>{title}</b>
            <span class="hide-s size">{size}</span>
            <span class="spacer"></span>
            {children()}
            <button
                class="btn"
                aria-pressed=sig(move || lab.robots_eye.get().to_string())
                title="Show only what the robot has driven over or seen (V)"
                on:click=mouse(move |_| lab.robots_eye.update(|on| *on = !*on))
            >
                {super::icons::eye()}
                <span class="hide-m">"Robot’s eye"</span>
                <span class="vh">"Robot’s-eye view"</span>
            </button>
        </div>
    }
}

/// Whose run is shown, when it is not the page's own.
#[component]
pub fn GuestNote() -> impl IntoView {
    let lab = lab();
    part(move || {
        lab.guest.get().map(|guest| {
            view! {
                <div class="note guest" role="note">
                    <span class="mark info">{super::icons::info()}</span>
                    <div class="row">
                        <span>{guest.told.clone()}</span>
                        <span class="spacer"></span>
                        <button class="btn" on:click=mouse(move |_| lab.rewind())>"Back to the page’s own run"</button>
                    </div>
                </div>
            }
        })
    })
}

#[component]
fn Legend() -> impl IntoView {
    let lab = lab();
    let walls = Memo::new(move |_| lab.stage.with(|maze| maze.kind == Kind::Wall));
    view! {
        <span class="legend hide-l" class:walls=sig(move || walls.get()) aria-hidden="true">
            <span>
                <svg class="maze" width="26" height="14" viewBox="0 0 52 28"><path class="tape" d="M8 14h36" /></svg>
                {part(move || if walls.get() { "wall" } else { "line" })}
            </span>
            <span>
                <svg class="maze" width="26" height="14" viewBox="0 0 52 28">
                    <path class="tape" d="M8 14h36" />
                    <path class="remembered" d="M8 14h36" />
                </svg>
                "remembered"
            </span>
            <span>
                <svg class="maze" width="26" height="14" viewBox="0 0 52 28">
                    <path class="tape" d="M8 14h36" />
                    <path class="given-up" d="M8 14h36" />
                </svg>
                "given up"
            </span>
            <span>
                <svg class="maze" width="26" height="14" viewBox="0 0 52 28">
                    <path class="tape" d="M8 14h36" />
                    <path class="cross-halo" d="M11 7l12 14m0-14l-12 14M31 7l12 14m0-14l-12 14" />
                    <path class="cross-mark" d="M11 7l12 14m0-14l-12 14M31 7l12 14m0-14l-12 14" />
                </svg>
                "crossed out"
            </span>
        </span>
    }
}

/// Where the bot cannot be put down: why, and the way to the cure.
#[component]
pub fn CannotRun(why: String) -> impl IntoView {
    let lab = lab();
    view! {
        <section class="card" aria-live="polite">
            <h2>"The bot can’t start"</h2>
            <div class="pad stack">
                <p>{why}</p>
                <div class="row">
                    <button class="btn primary" on:click=mouse(move |_| super::app::go(lab, Room::Draw))>
                        "Draw it right"
                    </button>
                    <button class="btn" on:click=mouse(move |_| lab.dialog.set(Some(Dialog::Samples)))>"Open a sample"</button>
                </div>
            </div>
        </section>
    }
}

/// Opens the glossary at a name.
pub fn look_up(lab: Lab, name: &'static str) {
    lab.dialog.set(Some(Dialog::Glossary(Some(name))));
}
