//! The path search of full mapping, one settled point at a time: its frontier, and both routes.

use std::fmt::Write;

use leptos::prelude::*;

use super::Watched;
use crate::explorer::mapping::Mapping;
use crate::explorer::mapping::search::Aim;
use crate::explorer::mind::Mind;
use crate::web::erase::{mouse, part, sig};

/// Steps of a search that are listed, the last ones.
const SHOWN: usize = 12;

/// The panel.
pub fn panel(watched: Watched) -> AnyView {
    let quickest = RwSignal::new(false);
    let steps = RwSignal::new(0_usize);
    let aim = move || if quickest.get() { Aim::Quickest } else { Aim::Shortest };
    let markup = move || {
        let (aim, steps) = (aim(), steps.get());
        watched.of(|run| match run.recording.last() {
            Mind::Mapping(map) => searched(map, aim, steps),
            _ => String::new(),
        })
    };
    let choose = move |time: bool| {
        quickest.set(time);
        steps.set(0);
    };
    let pressed = move |time: bool| sig(move || (quickest.get() == time).to_string());
    view! {
        <div class="insp search" id="search">
            <h3>"Path search"</h3>
            <div class="seg wide" role="group" aria-label="Aim">
                <button aria-pressed=pressed(false) on:click=mouse(move |_| choose(false))>"Shortest"</button>
                <button aria-pressed=pressed(true) on:click=mouse(move |_| choose(true))>"Shortest time"</button>
            </div>
            <div class="row">
                <button class="btn" disabled=sig(move || steps.get() == 0) on:click=mouse(move |_| steps.update(|steps| *steps = steps.saturating_sub(1)))>"Back"</button>
                <button class="btn primary" on:click=mouse(move |_| steps.update(|steps| *steps += 1))>"Settle one more"</button>
                <button class="btn" on:click=mouse(move |_| steps.set(usize::MAX))>"To the end"</button>
            </div>
            <div role="status" aria-live="polite" inner_html=sig(markup)></div>
            {part(move || watched.of(|run| match run.recording.last() {
                Mind::Mapping(map) => Some(routes(map)),
                _ => None,
            }))}
        </div>
    }
    .into_any()
}

/// The search after so many steps.
fn searched(map: &Mapping, aim: Aim, steps: usize) -> String {
    let mut search = map.search(aim);
    let mut settled = Vec::new();
    while settled.len() < steps
        && let Some(next) = search.step()
    {
        settled.push(next);
    }
    let mut frontier: Vec<u32> = search.frontier().collect();
    frontier.sort_unstable();
    frontier.dedup();
    let unit = match aim {
        Aim::Shortest => |cost: u64| format!("{cost} ms of driving"),
        Aim::Quickest => |cost: u64| format!("{:.2} s", cost as f64 / 1e9),
    };
    let mut markup = String::from(
        "<table class=\"settled\"><thead><tr><th scope=\"col\">settled</th><th scope=\"col\">its least cost</th></tr></thead><tbody>",
    );
    for step in &settled[settled.len().saturating_sub(SHOWN)..] {
        let _ = write!(markup, "<tr><td>{}</td><td>{}</td></tr>", step.point, unit(step.cost));
    }
    let _ = write!(
        markup,
        "</tbody></table><p>{} settled · frontier: <span class=\"mono frontier\">{}</span></p>",
        settled.len(),
        if search.path().is_some() { "the finish is settled".to_owned() } else { words(&frontier) }
    );
    if let Some(path) = search.path() {
        let _ = write!(markup, "<p><b>Route:</b> <span class=\"mono\">{}</span></p>", words(&path));
    }
    markup
}

fn words(points: &[u32]) -> String {
    points.iter().map(ToString::to_string).collect::<Vec<_>>().join(" ")
}

/// Both routes, as the robot would find them.
fn routes(map: &Mapping) -> impl IntoView + use<> {
    let route =
        |aim| map.route(aim).map_or_else(|| "none: no finish was found".to_owned(), |path| words(&path));
    view! {
        <dl class="routes">
            <div><dt>"Shortest path"</dt><dd class="mono">{route(Aim::Shortest)}</dd></div>
            <div><dt>"Shortest-time path"</dt><dd class="mono">{route(Aim::Quickest)}</dd></div>
        </dl>
    }
}
