//! Beside the drawing: sizes on the floor, and what the book's explorer makes of the maze.

use crate::web::erase::{mouse, sig};
use leptos::prelude::*;

use super::desk::{desk, many};
use super::sizes::KindChoice;
use crate::event::Outcome;
use crate::maze::edit::Edit;
use crate::maze::{Scale, millimetres};
use crate::web::dialogs::settings::NumberField;
use crate::web::icons;
use crate::web::rooms::go;
use crate::web::run_view::Run;
use crate::web::state::{Room, lab};

/// Sizes on the floor, and how the maze is drawn.
#[component]
pub fn Floor() -> impl IntoView {
    let (lab, desk) = (lab(), desk());
    let scale = Memo::new(move |_| lab.maze.with(|maze| maze.scale));
    let now = move || scale.get_untracked();
    let set = move |scale| {
        lab.edit(Edit::Scale(scale));
    };
    let number = |text: &str| millimetres(&text.replace(',', "."));
    let kind = Memo::new(move |_| lab.maze.with(|maze| maze.kind));
    let has_start = Memo::new(move |_| lab.maze.with(|maze| maze.start().is_some()));
    view! {
        <section class="card">
            <h2>"Maze"</h2>
            <div class="pad props">
                <NumberField id="cell-mm" label="Cell, mm" value=Signal::derive(move || scale.get().cell_mm().to_string())
                    hint="1 to 10,000 mm, and not less than the line is wide"
                    read=move |text: &str| Scale::new(number(text)?, now().line_mm()).ok() set=set />
                <NumberField id="line-mm" label="Line, mm" value=Signal::derive(move || scale.get().line_mm().to_string())
                    hint="0.1 mm to the length of a cell"
                    read=move |text: &str| Scale::new(now().cell_mm(), number(text)?).ok() set=set />
                <KindChoice id="drawn-as" kind=kind set=move |of| { lab.edit(Edit::Kind(of)); } />
                <div class="field">
                    <span>"Start"</span>
                    <button class="btn" title="Turn the start clockwise (T)" disabled=sig(move || !has_start.get()) on:click=mouse(move |_| desk.turn_start())>
                        {icons::again()} "Turn"<span class="vh">" the start clockwise"</span>
                    </button>
                </div>
            </div>
        </section>
    }
}

/// The run in one sentence.
#[component]
pub fn Explorer() -> impl IntoView {
    let lab = lab();
    let rests = desk().rests;
    // The run itself is not followed: in a large maze it waits until the hands rest.
    let follow = move || {
        rests.track();
        lab.settings.track();
    };
    let sentence = move || {
        follow();
        lab.own.with_untracked(|run| match run {
            Ok(run) => verdict(run),
            Err(why) => view! { {why.to_string()} }.into_any(),
        })
    };
    let can = Memo::new(move |_| {
        follow();
        lab.own.with_untracked(Result::is_ok)
    });
    view! {
        <section class="card fill explorer">
            <h2>"The book’s explorer"</h2>
            <div class="pad stack">
                <p aria-live="polite">{sentence}</p>
                <button class="btn primary" disabled=sig(move || !can.get()) on:click=mouse(move |_| go(lab, Room::Step))>"Step through it →"</button>
            </div>
        </section>
    }
}

fn verdict(run: &Run) -> AnyView {
    let driven = many(usize::try_from(run.cells(run.trace.stops())).unwrap_or(usize::MAX), "cell");
    let outcome = run.trace.outcome();
    let Some((route, shortest)) = run.route_cells().zip(run.shortest).filter(|_| outcome == Outcome::Finish)
    else {
        let why = match outcome {
            Outcome::Finish => "the finish was reached, but its turn list does not lead there".to_owned(),
            Outcome::TableFull { capacity } => {
                format!(
                    "its node table is full: it can remember {capacity} nodes at once (settings of the run, O)"
                )
            }
            Outcome::NoFinishReachable if run.maze.finish().is_empty() => {
                "the maze has no finish, so it drove every line and came back".to_owned()
            }
            Outcome::NoFinishReachable
            | Outcome::Mapped
            | Outcome::Circling { .. }
            | Outcome::Stuck
            | Outcome::PathFull { .. }
            | Outcome::NoLine { .. }
            | Outcome::TooManyStops { .. }
            | Outcome::Cut(_) => outcome.to_string(),
        };
        return view! { "Stops after " <b>{driven}</b> ": " {why} "." }.into_any();
    };
    let how = match run.ratio() {
        Some(ratio) if route > shortest => format!("{ratio:.1} times the shortest, {shortest}."),
        _ => "no route is shorter.".to_owned(),
    };
    view! { "Finds the finish after " <b>{driven}</b> ". Its route is " <b>{many(route as usize, "cell")}</b> "; " {how} }
        .into_any()
}
