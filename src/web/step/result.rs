//! The end of a run: the turn list, how good its route is, and round 2.

use crate::decimal::Decimal;
use crate::web::erase::{mouse, part, sig};
use leptos::prelude::*;

use crate::maze::Maze;
use crate::web::browser;
use crate::web::played::Played;
use crate::web::run_view::Run;
use crate::web::state::{Dialog, Lab, Round, ToastTone, lab};

fn with_run<T>(lab: Lab, of: impl FnOnce(&Run) -> Option<T>) -> Option<T> {
    lab.run.with(|run| run.as_ref().ok().and_then(|run| of(run)))
}

/// What is shown under the sentence when the run is over and the finish was found.
#[component]
pub fn ResultCard() -> impl IntoView {
    let lab = lab();
    let c_array = RwSignal::new(false);
    part(move || {
        with_run(lab, |run| {
            let list = run.list.clone()?;
            let letters = list.to_string();
            let array = list.c_array(&title(&run.maze));
            let copied = move |ok: bool| match ok {
                true => lab.say(ToastTone::Info, "", "Copied."),
                false => lab.say(
                    ToastTone::Error,
                    "Can’t copy",
                    "This browser gives no access to the clipboard: select the text and copy it by hand.",
                ),
            };
            let (copy_letters, copy_array) = (letters.clone(), array.clone());
            Some(view! {
                <div class="result" id="result">
                    <Letters />
                    <Facts />
                    <div class="row">
                        <button class="btn primary" on:click=mouse(move |_| lab.drive_solved())>"Drive the solved run"</button>
                        <button class="btn" on:click=mouse(move |_| browser::copy(copy_letters.clone(), copied))>"Copy"</button>
                        <button class="btn" aria-expanded=sig(move || c_array.get().to_string()) on:click=mouse(move |_| c_array.update(|on| *on = !*on))>"C array"</button>
                        <button class="btn" on:click=mouse(move |_| lab.dialog.set(Some(Dialog::TurnList)))>"Turn-list lab"</button>
                        <button class="btn" on:click=mouse(move |_| lab.dialog.set(Some(Dialog::Share)))>"Share"</button>
                    </div>
                    {part(move || c_array.get().then(|| {
                        let (shown, copied_array) = (array.clone(), copy_array.clone());
                        view! {
                            <pre class="snip mono" tabindex="0"><code>{shown}</code></pre>
                            <div class="row"><button class="btn" on:click=mouse(move |_| browser::copy(copied_array.clone(), copied))>"Copy the array"</button></div>
                        }
                    }))}
                </div>
            })
        })
    })
}

/// What the maze is called.
pub fn title(maze: &Maze) -> String {
    if maze.about.title.is_empty() { "untitled maze".to_owned() } else { maze.about.title.clone() }
}

/// The turn list, a letter a node.
#[component]
pub fn Letters() -> impl IntoView {
    let lab = lab();
    let letters = move || {
        let of =
            |run: &dyn Played| Some(run.list()?.turns().iter().map(|turn| turn.letter()).collect::<Vec<_>>());
        lab.shown(of).flatten().unwrap_or_default()
    };
    // In round 2 the letter that was used last is marked.
    let used = move || {
        let stop = lab.solved.with(|playback| playback.moment().stop);
        if lab.round.get() == Round::Explore {
            return None;
        }
        let of = |run: &dyn Played| {
            let legs = &run.drive()?.route.legs;
            legs[..(stop as usize).min(legs.len())].iter().rev().find_map(|leg| leg.letter)
        };
        lab.shown(of).flatten()
    };
    part(move || {
        let letters = letters();
        if letters.is_empty() {
            return view! { <p class="small">"The turn list is empty: there is no node on the route, and corners need no letter."</p> }.into_any();
        }
        let said: String = letters.iter().collect();
        view! {
            <ol class="letters" aria-label=format!("Turn list {said}")>
                {letters
                    .into_iter()
                    .zip(1usize..)
                    .map(|(letter, i)| view! { <li class:lit=sig(move || used() == Some(i))><b>{letter}</b><span>{if lab.by_the_book() { format!("node {i}") } else { i.to_string() }}</span></li> })
                    .collect_view()}
            </ol>
        }
        .into_any()
    })
}

/// Lengths and their ratio.
#[component]
fn Facts() -> impl IntoView {
    let lab = lab();
    part(move || {
        with_run(lab, |run| {
            let ratio = run.ratio()?;
            let judged = if run.route_cells()? == run.shortest? {
                "as good as any".to_owned()
            } else {
                "times the shortest".to_owned()
            };
            let fact = |name: &'static str, value: String, unit: String| view! { <div><dt>{name}</dt><dd>{value}<small>{unit}</small></dd></div> };
            let cells = |name, count: u64| {
                fact(name, count.to_string(), if count == 1 { "cell" } else { "cells" }.into())
            };
            let stops = run.trace.stops();
            Some(view! {
                <dl class="facts three">
                    {cells("Route", run.route_cells()?.into())}
                    {cells("Shortest", run.shortest?.into())}
                    {fact("Ratio", format!("{:#}", Decimal(ratio, 2)), judged)}
                    {cells("Exploration", run.cells(stops))}
                    {fact("Stops", stops.to_string(), String::new())}
                </dl>
            })
        })
    })
}

/// The card of round 2.
#[component]
pub fn SolvedCard() -> impl IntoView {
    let lab = lab();
    view! {
        <section class="card" aria-labelledby="solved-title">
            <h2 id="solved-title">"Round 2: the turn list"</h2>
            <div class="result">
                <Letters />
                <Facts />
                <div class="row"><button class="btn primary" on:click=mouse(move |_| lab.round.set(Round::Explore))>"Back to the exploration"</button></div>
            </div>
        </section>
    }
}
