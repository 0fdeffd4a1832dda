//! The Compare room: two to six explorers side by side in the page's maze, random orders, and the league.

use crate::web::erase::{mouse, part, sig};
use leptos::prelude::*;

use super::app::go;
use super::lazy::{self, lazy};
use super::state::{Dialog, Lab, Room, Round, lab};
use crate::explorer::name::Name;

mod desk;
mod files;
mod keyboard;
mod league;
mod lineup;
mod office;
mod orders;
mod pictures;
mod results;
mod transport;
mod worker;

pub use files::holds_folder;

use desk::{Desk, Page};

lazy! { compare;
    /// The room.
    pub fn room() -> AnyView {
        view! { <CompareRoom /> }.into_any()
    }
}

lazy! { compare;
    fn served() -> () {
        worker::serve();
    }
}

lazy! { compare;
    fn dropped(lab: Lab, items: Vec<wasm_bindgen::JsValue>) -> () {
        files::dropped(lab, items);
    }
}

/// Runs the league for the page: what the program does in a worker.
pub fn serve() {
    console_error_panic_hook::set_once();
    wasm_bindgen_futures::spawn_local(async {
        let _ = served().await;
    });
}

/// Opens the league with files that were dropped.
pub fn drop_into_league(lab: Lab, transfer: &web_sys::DataTransfer) {
    // What was dropped can be asked for only now.
    let items = files::items(transfer);
    lazy::act(lab, async move { dropped(lab, items).await });
}

/// Opens a run in the stepper at a stop.
pub fn open_in_stepper(lab: Lab, name: Name, stop: u32) {
    go(lab, Room::Step);
    lab.watch(name, Round::Explore, stop);
}

/// More explorers than this want more room than a window has.
const SIDE_BY_SIDE: usize = 3;

#[component]
fn CompareRoom() -> impl IntoView {
    let lab = lab();
    let desk = Desk::of(lab);
    provide_context(desk);
    keyboard::listen(desk);
    desk.run_clock();
    let shows = move |page: Page| desk.page.get() == page;
    view! {
        <main class="main compare" class:league-open=sig(move || shows(Page::League)) class:many=sig(move || shows(Page::Maze) && desk.names.with(|names| names.len() > SIDE_BY_SIDE)) id="main" tabindex="-1">
            <h1 class="vh">"Compare"</h1>
            {part(move || match desk.page.get() {
                Page::Maze => view! {
                    <super::notes::BrokenLink />
                    {part(move || desk.cannot().map(|why| view! { <CannotCompare why=why /> }))}
                    <pictures::Pictures />
                    <pictures::Parting />
                    <results::Results />
                    <orders::Orders />
                    <league::Card />
                }.into_any(),
                Page::League => view! { <league::Room /> }.into_any(),
            })}
        </main>
        {part(move || shows(Page::Maze).then(|| view! {
            <footer class="transport-bar abreast" aria-label="All runs">
                <transport::Transport />
            </footer>
        }))}
        {part(move || (lab.dialog.get() == Some(Dialog::Lineup)).then(|| view! { <lineup::Lineup /> }))}
    }
}

/// Where no robot can be put down: why, and the way to the cure.
#[component]
fn CannotCompare(why: String) -> impl IntoView {
    let lab = lab();
    view! {
        <section class="card cannot" aria-live="polite">
            <h2>"The bots can’t start"</h2>
            <div class="pad stack">
                <p>{why}</p>
                <div class="row">
                    <button class="btn primary" on:click=mouse(move |_| go(lab, Room::Draw))>"Draw it right"</button>
                    <button class="btn" on:click=mouse(move |_| lab.dialog.set(Some(Dialog::Samples)))>"Open a sample"</button>
                </div>
            </div>
        </section>
    }
}

/// One maze, or the league.
#[component]
fn Tabs() -> impl IntoView {
    let desk = desk::desk();
    let tab = move |page: Page, name: &'static str| {
        let chosen = move || (desk.page.get() == page).to_string();
        view! { <button aria-pressed=sig(chosen) on:click=mouse(move |_| desk.turn_to(page))>{name}</button> }
    };
    view! {
        <div class="seg" role="group" aria-label="Compare in">
            {tab(Page::Maze, "This maze")}
            {tab(Page::League, "League")}
        </div>
    }
}
