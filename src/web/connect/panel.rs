//! The connection: which port, where it stands, what to do about it.

use crate::web::erase::{event, mouse, part, sig};
use leptos::prelude::*;

use super::wire;
use crate::link::page::{Command, Port, RATES, State, Trouble};
use crate::link::usb;
use crate::web::icons;

/// The steps of a connection, as far as they are shown.
const STEPS: [&str; 3] = ["opened", "answered", "running"];

/// The card.
#[component]
pub fn Connection() -> impl IntoView {
    let wire = wire();
    let state = Memo::new(move |_| wire.snapshot().state);
    let port = Memo::new(move |_| {
        let now = wire.snapshot();
        (now.port, now.baud)
    });
    let open = move || {
        matches!(
            state.get(),
            State::Opening
                | State::Waiting
                | State::Ready
                | State::Sending
                | State::Running
                | State::Stopping
                | State::Alarm(_)
                | State::Lost
                | State::Reconnecting
        )
    };
    let note = Memo::new(move |_| wire.look(|link| link.notes().next_back().copied()));
    view! {
        <section class="card link-card" aria-labelledby="link-title">
            <h2 id="link-title">"Connection"<span class="spacer"></span><span class=sig(move || format!("case {}", tone(state.get()))) id="state">{part(move || view! { {shape(state.get())} {state.get().name()} })}</span></h2>
            <div class="pad stack">
                {part(move || open().then(|| view! { <Who /> }))}
                <div aria-live="polite" class="stack says" id="link-says">
                    {part(move || (!state.get().is_connected()).then(|| view! { <p>{state.get().says()}</p> }))}
                    {part(move || state.get().cure().map(|cure| view! {
                        <div class="note cure" class:bad=is_bad(state.get()) class:warn=!is_bad(state.get())>
                            <span class=if is_bad(state.get()) { "mark bad" } else { "mark warn" }>{icons::warn()}</span>
                            <p class="small" id="cure">{cure}</p>
                        </div>
                    }))}
                </div>
                {part(move || open().then(|| view! { <Steps state=state /> }))}
                {part(move || note.get().map(|note| view! { <p class="small news" id="news" role="status">{note.news.text()}</p> }))}
                {part(move || (!open() && state.get() != State::Absent).then(|| view! { <Known /> }))}
                <div class="row even">
                    {part(move || match (open(), state.get()) {
                        (true, _) => view! { <button class="btn" id="disconnect" on:click=mouse(move |_| wire.command(Command::Disconnect))>"Disconnect"</button> }.into_any(),
                        (false, State::Absent) => ().into_any(),
                        (false, _) => view! {
                            // No id is a place in the address: the browser would move the focus there.
                            <button class="btn primary" id="choose-port" disabled=state.get() == State::Choosing on:click=mouse(move |_| wire.command(Command::Choose))>"Connect…"</button>
                        }.into_any(),
                    })}
                    {part(move || (!open()).then(|| view! {
                        <button class="btn" id="demo" title="A robot inside the page, standing in your maze" on:click=mouse(move |_| wire.command(Command::Use(Port::Demo)))>"Demo robot"</button>
                    }))}
                </div>
                {part(move || matches!(state.get(), State::Failed(Trouble::NoAnswer { .. })).then(|| view! {
                    <button class="btn" id="next-rate" on:click=mouse(move |_| wire.command(Command::NextRate))>"Try the next rate"</button>
                }))}
                {part(move || (state.get() != State::Absent && port.get().0 != Some(Port::Demo) || !open()).then(|| view! { <Rate /> }))}
            </div>
        </section>
    }
}

/// Each kind of state has its own shape beside its colour.
fn shape(state: State) -> impl IntoView {
    let data = match state {
        State::Absent => "M3 3l10 10M13 3L3 13",
        State::Closed => "M8 2a6 6 0 100 12A6 6 0 108 2",
        State::Choosing | State::Opening | State::Waiting => "M2 8h.1M8 8h.1M14 8h.1",
        State::Ready => "M3 8.5l3.5 3.5L13 4.5",
        State::Sending => "M8 13V3M4 7l4-4 4 4",
        State::Running => "M4 2.5v11L13 8z",
        State::Lost | State::Reconnecting => "M3 8h3M10 8h3M8 4v8",
        State::Stopping => "M3 3h10v10H3z",
        State::Alarm(_) | State::Failed(_) => "M8 2l6 11H2zM8 6v3.5",
    };
    view! { <svg class="shape" viewBox="0 0 16 16" aria-hidden="true"><path d=data /></svg> }
}

const fn tone(state: State) -> &'static str {
    match state {
        State::Ready | State::Sending | State::Running => "go",
        State::Lost | State::Reconnecting | State::Failed(_) | State::Alarm(_) => "bad",
        State::Absent
        | State::Closed
        | State::Choosing
        | State::Opening
        | State::Waiting
        | State::Stopping => "info",
    }
}

/// Whether something has to be done at once.
const fn is_bad(state: State) -> bool {
    matches!(state, State::Failed(_) | State::Alarm(_))
}

/// The port and who is at its other end.
#[component]
fn Who() -> impl IntoView {
    let wire = wire();
    let who = Memo::new(move |_| {
        let now = wire.snapshot();
        let robot = wire.look(|link| link.robot().cloned());
        (now.port, now.baud, robot, now.millivolts)
    });
    part(move || {
        let (port, baud, robot, millivolts) = who.get();
        let port = port?;
        let mut facts: Vec<String> = usb::ids(port).into_iter().collect();
        facts.push(format!("{baud} baud"));
        if let Some(robot) = &robot {
            facts.push(format!("firmware {}", robot.firmware));
            facts.push(format!("{} nodes", robot.nodes));
        }
        if let Some(mv) = millivolts {
            facts.push(format!("battery {}.{:02} V", mv / 1000, mv % 1000 / 10));
        }
        let board = robot.filter(|_| port != Port::Demo).map(|robot| robot.board);
        Some(view! {
            <p class="port" id="port"><b>{usb::name(port)}</b>{board.map(|board| format!(", says “{board}”"))}<span class="small">{facts.join(" · ")}</span></p>
        })
    })
}

/// How far the connection is.
#[component]
fn Steps(state: Memo<State>) -> impl IntoView {
    let reached = move || match state.get() {
        State::Waiting => 1,
        State::Ready | State::Sending => 2,
        State::Running | State::Stopping | State::Alarm(_) => 3,
        State::Absent
        | State::Closed
        | State::Choosing
        | State::Opening
        | State::Lost
        | State::Reconnecting
        | State::Failed(_) => 0,
    };
    view! {
        <ol class="states" aria-label="How far the connection is">
            {STEPS.into_iter().zip(1..).map(|(name, step)| view! {
                <li class:done=sig(move || step < reached()) aria-current=sig(move || (step == reached()).then_some("step"))>{name}</li>
            }).collect_view()}
        </ol>
    }
}

/// Ports that were allowed before: one click to come back.
#[component]
fn Known() -> impl IntoView {
    let wire = wire();
    part(move || {
        let known = wire.known.get();
        (!known.is_empty()).then(|| view! {
            <ul class="known" aria-label="Known ports">
                {known.into_iter().enumerate().map(|(index, port)| view! {
                    <li>
                        <button class="btn" on:click=mouse(move |_| wire.use_known(index))>
                            {format!("Use {}", usb::name(port))}<span class="small">{usb::ids(port)}</span>
                        </button>
                    </li>
                }).collect_view()}
            </ul>
        })
    })
}

#[component]
fn Rate() -> impl IntoView {
    let wire = wire();
    let baud = Memo::new(move |_| wire.snapshot().baud);
    view! {
        <label class="field rate">"Rate"
            <select class="input" id="rate" prop:value=sig(move || baud.get().to_string()) on:change=event(move |event| {
                if let Ok(rate) = event_target_value(&event).parse() {
                    wire.command(Command::Baud(rate));
                }
            })>
                {RATES.map(|rate| view! { <option value=rate.to_string() selected=rate == baud.get_untracked()>{format!("{rate} baud")}</option> }).into_iter().collect_view()}
            </select>
        </label>
    }
}
