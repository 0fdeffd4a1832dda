//! The generator: sizes, seed and shares, a picture of what comes out, and the way into the drawing.

use crate::web::erase::{event, mouse, part, sig};
use leptos::html;
use leptos::prelude::*;

use super::desk::{desk, many};
use super::sizes::KindChoice;
use super::thumb::thumb;
use crate::maze::generate::{Recipe, generate};
use crate::maze::{Maze, checks};
use crate::web::browser;
use crate::web::dialogs::settings::NumberField;
use crate::web::icons;
use crate::web::run_view::Same;
use crate::web::state::lab;

/// Points along a side that the page generates at most; the command line has no such bound.
const SIDES: std::ops::RangeInclusive<u32> = 2..=200;

/// The popover.
#[component]
pub fn Generator() -> impl IntoView {
    let (lab, desk) = (lab(), desk());
    let recipe = RwSignal::new(Recipe::default());
    let made = Memo::new(move |_| generate(&recipe.get()).map(Same::new));
    let close = move || {
        desk.generating.set(false);
        browser::focus("generate");
    };
    let take = move |_| {
        if let Ok(maze) = made.get_untracked() {
            lab.open((*maze).clone());
            lab.say_done(format!("{} is open.", maze.about.title));
            close();
        }
    };
    let first = NodeRef::<html::Section>::new();
    Effect::new(move |_| {
        if first.get().is_some() {
            browser::focus("gen-width");
        }
    });
    view! {
        <section class="pop generator" node_ref=first role="dialog" aria-label="Generate a maze">
            <div class="row">
                <h2>"Generate"</h2>
                <span class="spacer"></span>
                <button class="btn icon quiet" aria-label="Close the generator (Esc)" on:click=mouse(move |_| close())>{icons::close()}</button>
            </div>
            <div class="gen">
                <Numbers recipe=recipe />
                <Shares recipe=recipe />
                <div class="wide">
                    <KindChoice id="gen-kind" kind=Signal::derive(move || recipe.get().kind) set=move |kind| recipe.update(|recipe| recipe.kind = kind) />
                </div>
                <div class="wide preview">
                    {part(move || match made.get() {
                        Ok(maze) => view! {
                            <figure>
                                {thumb(&maze)}
                                <figcaption class="small" role="status">{describe(&maze)}</figcaption>
                            </figure>
                        }
                        .into_any(),
                        Err(why) => view! { <p class="small" role="alert">{why.to_string()}</p> }.into_any(),
                    })}
                    <button class="btn primary" disabled=sig(move || made.with(Result::is_err)) on:click=mouse(take)>"Use this"</button>
                </div>
            </div>
        </section>
    }
}

#[component]
fn Numbers(recipe: RwSignal<Recipe>) -> impl IntoView {
    let side = |text: &str| text.parse().ok().filter(|side| SIDES.contains(side));
    // A seed that people can read to each other.
    let another = move |_| recipe.update(|recipe| recipe.seed = (js_sys::Math::random() * 10_000.0) as u64);
    view! {
        <NumberField id="gen-width" label="Width" value=Signal::derive(move || recipe.get().width.to_string())
            hint="2 to 200" read=side set=move |width| recipe.update(|recipe| recipe.width = width) />
        <NumberField id="gen-height" label="Height" value=Signal::derive(move || recipe.get().height.to_string())
            hint="2 to 200" read=side set=move |height| recipe.update(|recipe| recipe.height = height) />
        <div class="joined">
            <NumberField id="gen-seed" label="Seed" value=Signal::derive(move || recipe.get().seed.to_string())
                hint="A whole number" read=|text: &str| text.parse().ok() set=move |seed| recipe.update(|recipe| recipe.seed = seed) />
            <button class="btn icon" aria-label="Another seed" title="Another seed" on:click=mouse(another)>{icons::again()}</button>
        </div>
    }
}

#[component]
fn Shares(recipe: RwSignal<Recipe>) -> impl IntoView {
    let percent = |event: &web_sys::Event| event_target_value(event).parse::<u8>().unwrap_or(0).min(100);
    let (loops, cut) = (
        move || recipe.with(|recipe| recipe.loops_percent),
        move || recipe.with(|recipe| recipe.dead_ends_cut_percent),
    );
    view! {
        <label class="slide wide">
            "Loops"
            <input type="range" min="0" max="100" step="5" prop:value=sig(move || loops().to_string())
                on:input=event(move |event| recipe.update(|recipe| recipe.loops_percent = percent(&event))) />
            <output>{part(move || format!("{} %", loops()))}</output>
        </label>
        <label class="slide wide">
            "Dead ends cut back"
            <input type="range" min="0" max="100" step="5" prop:value=sig(move || cut().to_string())
                on:input=event(move |event| recipe.update(|recipe| recipe.dead_ends_cut_percent = percent(&event))) />
            <output>{part(move || format!("{} %", cut()))}</output>
        </label>
    }
}

/// `18 nodes, the shortest route is 23 cells`.
fn describe(maze: &Maze) -> String {
    let nodes = many(maze.nodes(), "node");
    let route = checks::report(maze).in_order.into_iter().find_map(|item| match item {
        checks::InOrder::Finish { cells, .. } => Some(cells),
        checks::InOrder::Start(_) => None,
    });
    match route {
        Some(cells) => format!("{nodes}, the shortest route is {}", many(cells as usize, "cell")),
        None => nodes,
    }
}
