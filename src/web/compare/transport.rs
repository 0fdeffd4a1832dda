//! One time for all runs: the buttons, a lane for each run under one scrubber, and what holds them equal.

use crate::web::erase::{event, key, mouse, part, pointer, sig};
use leptos::html;
use leptos::prelude::*;

use super::desk::{By, Desk, Towards, desk};
use crate::compare::forks::letter;
use crate::compare::words::End;
use crate::playback::SPEEDS;
use crate::web::{browser, icons};

/// The whole bar.
#[component]
pub fn Transport() -> impl IntoView {
    view! {
        <Buttons />
        <Lanes />
        <Sync />
    }
}

#[component]
fn Buttons() -> impl IntoView {
    let desk = desk();
    let button = |label: &'static str, icon: AnyView, act: fn(Desk)| {
        view! { <button aria-label=label title=label on:click=mouse(move |_| act(desk))>{icon}</button> }
    };
    let playing = move || desk.playing.get();
    view! {
        <div class="transport" role="group" aria-label="Transport of all runs">
            {button("To start (Home)", icons::to_start().into_any(), |desk| desk.seek(0.0))}
            {button("Back: to the last stop of any run (←)", icons::back().into_any(), |desk| desk.step(Towards::Start))}
            <button class="play" aria-label=sig(move || if playing() { "Pause all (Space)" } else { "Play all (Space)" }) on:click=mouse(move |_| desk.toggle())>
                {part(move || if playing() { icons::pause().into_any() } else { icons::play().into_any() })}
            </button>
            {button("Step: to the next stop of any run (→)", icons::forward().into_any(), |desk| desk.step(Towards::End))}
            {button("To end (End)", icons::to_end().into_any(), |desk| desk.seek(f64::INFINITY))}
            {button("Next parting (N)", icons::next_event().into_any(), Desk::next_fork)}
        </div>
    }
}

/// What a time is in words.
fn spelled(desk: Desk, time: f64) -> String {
    match desk.by.get() {
        By::Distance => format!("{time:.1} cells"),
        By::Time => format!("{time:.1} s"),
    }
}

#[component]
fn Lanes() -> impl IntoView {
    let desk = desk();
    let element = NodeRef::<html::Div>::new();
    let held = RwSignal::new(false);
    let share =
        move |value: f64| if desk.most() > 0.0 { (value / desk.most()).clamp(0.0, 1.0) * 100.0 } else { 0.0 };
    let seek = move |event: &web_sys::PointerEvent| {
        let Some(lanes) = element.get_untracked() else { return };
        let Ok(Some(track)) = lanes.query_selector(".over") else { return };
        let track = track.get_bounding_client_rect();
        let along = (f64::from(event.client_x()) - track.left()) / track.width().max(1.0);
        desk.seek(along * untrack(|| desk.most()));
    };
    let lanes = move || {
        desk.field.with(|field| {
            let by = desk.by.get();
            let lane = |nth: usize| {
                let racer = field.racer(nth);
                let length = racer.map_or(0.0, |racer| share(field.length(&racer.entrant.run, by)));
                let end = racer.map_or("failed", |racer| End::of(racer.entrant.score.outcome).class());
                let width = format!("{length:.2}%");
                let driven = sig(move || format!("{:.2}%", share(desk.now.get()).min(length)));
                view! {
                    <div class="lane"><span>{letter(nth).to_string()}</span><div>
                        <i class="way" style:width=width.clone()></i><i class="driven" style:width=driven></i>
                        <i class=format!("end-mark {end}") style:left=width></i>
                    </div></div>
                }
            };
            (0..field.entrants.len()).map(lane).collect_view()
        })
    };
    let forks = move || {
        desk.field.with(|field| {
            let by = desk.by.get();
            field
                .forks
                .iter()
                .map(|fork| {
                    let at = format!("{:.2}%", share(field.fork_time(fork, by)));
                    view! { <i class="part" style:left=at></i> }
                })
                .collect_view()
        })
    };
    let keys = move |event: web_sys::KeyboardEvent| {
        match event.key().as_str() {
            "ArrowRight" | "ArrowUp" => desk.step(Towards::End),
            "ArrowLeft" | "ArrowDown" => desk.step(Towards::Start),
            "Home" => desk.seek(0.0),
            "End" => desk.seek(f64::INFINITY),
            _ => return,
        }
        event.prevent_default();
    };
    view! {
        <div class="lanes" role="slider" tabindex="0" node_ref=element
            aria-label=sig(move || match desk.by.get() { By::Distance => "Distance driven", By::Time => "Time passed" })
            aria-valuemin="0" aria-valuemax=sig(move || format!("{:.1}", desk.most())) aria-valuenow=sig(move || format!("{:.1}", desk.now.get()))
            aria-valuetext=sig(move || spelled(desk, desk.now.get()))
            on:keydown=key(keys)
            on:pointerdown=pointer(move |event| {
                held.set(true);
                if let Some(lanes) = element.get_untracked() {
                    let _ = lanes.set_pointer_capture(event.pointer_id());
                }
                seek(&event);
            })
            on:pointermove=pointer(move |event| if held.get_untracked() { seek(&event) })
            on:pointerup=pointer(move |_| held.set(false))
            on:pointercancel=pointer(move |_| held.set(false))
        >
            {part(lanes)}
            <div class="over">{part(forks)}<i class="head" style:left=sig(move || format!("{:.2}%", share(desk.now.get())))></i></div>
        </div>
    }
}

#[component]
fn Sync() -> impl IntoView {
    let desk = desk();
    let by = move |by: By, name: &'static str| {
        let chosen = move || (desk.by.get() == by).to_string();
        view! { <button aria-pressed=sig(chosen) on:click=mouse(move |_| desk.hold_by(by))>{name}</button> }
    };
    let choose = move |event: web_sys::Event| {
        browser::let_go(&event);
        let value = event_target_value(&event);
        if let Some(speed) = SPEEDS.into_iter().find(|speed| speed.to_string() == value) {
            desk.speed.set(speed);
        }
    };
    view! {
        <div class="sync">
            <div class="seg" role="group" aria-label="Run together by">
                {by(By::Distance, "Distance")}
                {by(By::Time, "Time")}
            </div>
            <select class="input" aria-label="Speed" title="Speed; 1× is the robots’ own pace" on:change=event(choose) prop:value=sig(move || desk.speed.get().to_string())>
                {SPEEDS.map(|speed| view! { <option value=speed.to_string()>{format!("{speed}×")}</option> }).into_iter().collect_view()}
            </select>
            <span class="count" id="abreast">{part(move || {
                let most = desk.most();
                match desk.by.get() {
                    By::Distance => format!("{:.1} of {most:.0} cells", desk.now.get()),
                    By::Time => format!("{:.1} of {most:.1} s", desk.now.get()),
                }
            })}</span>
        </div>
    }
}
