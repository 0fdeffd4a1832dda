//! The room *Connect*: a real robot on a serial line, or the demo robot; its turn list, settings, run, sensors
//! and every line that is said.

use crate::web::erase::{mouse, part, sig};
use leptos::prelude::*;

use super::icons;
use super::lazy::lazy;
use super::state::lab;
use super::step::table::NodeTable;
use super::step::transport::{Counter, Scrubber};
use crate::link::page::{Command, Placed, State};

mod halt;
mod list;
mod live;
mod monitor;
mod panel;
mod plot;
mod record;
mod tune;
mod wire;

use wire::Wire;

lazy! { connect;
    /// The room.
    pub fn room() -> AnyView {
        match Wire::of(lab()) {
            Some(wire) => {
                provide_context(wire);
                view! { <ConnectRoom /> }.into_any()
            }
            None => ().into_any(),
        }
    }
}

/// The room's connection.
fn wire() -> Wire {
    expect_context::<Wire>()
}

#[component]
fn ConnectRoom() -> impl IntoView {
    view! {
        <main class="main connect" id="main" tabindex="-1">
            <h1 class="vh">"Connect"</h1>
            <div class="col left">
                <panel::Connection />
                <list::TurnLists />
                <tune::Settings />
            </div>
            <div class="col mid">
                <live::LiveStage />
                <live::Disagreement />
                <NodeTable />
            </div>
            <div class="col right">
                <plot::Sensors />
                <monitor::MonitorCard />
            </div>
        </main>
        <footer class="transport-bar connect-bar" aria-label="Robot and run">
            <Drive />
            <Scrubber />
            <div class="transport-more"><Counter /></div>
        </footer>
    }
}

/// What the robot is told to do.
#[component]
fn Drive() -> impl IntoView {
    let wire = wire();
    let look = Memo::new(move |_| {
        let now = wire.snapshot();
        (now.state, now.placed)
    });
    let ready = move || look.get().0 == State::Ready;
    let placed = move || look.get() == (State::Ready, Placed::AtStart);
    let unplaced = move || ready() && !placed();
    let stoppable = move || {
        let state = look.get().0;
        state.is_connected() || matches!(state, State::Waiting | State::Alarm(_))
    };
    view! {
        <div class="drive" role="group" aria-label="Robot">
            <button class="btn" id="explore" disabled=sig(move || !placed()) title="Learn the maze" on:click=mouse(move |_| {
                wire.recorded.set(None);
                wire.command(Command::Explore(wire.mind()));
            })>"Explore"</button>
            <button class="btn" id="run-route" disabled=sig(move || !placed()) title="Drive by the turn list on the robot" on:click=mouse(move |_| {
                wire.recorded.set(None);
                wire.command(Command::RunRoute);
            })>"Run route"</button>
            <button class="btn stop" id="stop" disabled=sig(move || !stoppable()) title="Stop at once (Ctrl .)" aria-keyshortcuts="Control+." on:click=mouse(move |_| wire.command(Command::Stop))>
                {icons::halt()}"Stop"
            </button>
            <button class="btn" id="place" class:primary=sig(unplaced) disabled=sig(move || !ready()) title="The robot stands at the start again" on:click=mouse(move |_| wire.command(Command::Place))>
                "I put it back"
            </button>
            {part(move || unplaced().then(|| view! { <span class="small hint" id="place-hint">"Put the robot at the start, then say so."</span> }))}
        </div>
    }
}
