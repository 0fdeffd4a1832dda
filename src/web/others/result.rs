//! The end of a run: how it ended, the turn list in all its forms, and its route against the best ones.

use leptos::prelude::*;

use super::Watched;
use super::run::OtherRun;
use crate::event::Outcome;
use crate::route::forms::{self, Form};
use crate::route::{Corners, TurnList};
use crate::web::browser;
use crate::web::erase::{event, mouse, part, sig};
use crate::web::state::{Dialog, Lab, Round, ToastTone, lab};
use crate::web::step::result::{Letters, title};

/// What is shown under the sentence when the run is over.
pub fn card(watched: Watched) -> AnyView {
    let lab = lab();
    let outcome = move || {
        watched.of(|run| match run.recording.outcome() {
            Outcome::NoFinishReachable if run.maze.finish().is_empty() => "the maze has no finish".to_owned(),
            outcome => outcome.to_string(),
        })
    };
    let strayed = move || watched.of(|run| run.strayed.map(|strayed| strayed.to_string()));
    view! {
        <div class="result" id="result">
            <p class="outcome"><b>"Outcome: "</b>{part(outcome)}</p>
            {part(move || strayed().map(|why| view! { <p class="small">"Its letters lead elsewhere: "{why}"."</p> }))}
            {part(move || watched.of(|run| run.list.is_some()).then(|| view! { <Letters /> }))}
            {facts(watched)}
            {part(move || watched.of(|run| run.drive.is_some()).then(|| view! {
                <div class="row">
                    <button class="btn primary" on:click=mouse(move |_| lab.drive_solved())>"Drive the solved run"</button>
                    <button class="btn" on:click=mouse(move |_| lab.dialog.set(Some(Dialog::TurnList)))>"Turn-list lab"</button>
                    <button class="btn" on:click=mouse(move |_| lab.dialog.set(Some(Dialog::Share)))>"Share"</button>
                </div>
            }))}
            {part(move || watched.of(|run| run.list.is_some()).then(|| export(watched)))}
        </div>
    }
    .into_any()
}

/// The card of round 2.
pub fn solved_card(watched: Watched) -> AnyView {
    let lab = lab();
    view! {
        <section class="card" aria-labelledby="solved-title">
            <h2 id="solved-title">"Round 2: the turn list"</h2>
            <div class="result">
                <Letters />
                {facts(watched)}
                <div class="row"><button class="btn primary" on:click=mouse(move |_| lab.round.set(Round::Explore))>"Back to the exploration"</button></div>
            </div>
        </section>
    }
    .into_any()
}

/// Lengths and times, and how they compare.
fn facts(watched: Watched) -> AnyView {
    let fact = |name: &'static str, value: String, unit: String| view! { <div><dt>{name}</dt><dd>{value}<small>{unit}</small></dd></div> };
    part(move || {
        watched.of(|run| -> Option<AnyView> {
            let cell_mm = run.maze.scale.cell_mm();
            let seconds = |s: f64| format!("cells · {s:.1} s");
            let route = run.drive.as_ref().map(|drive| (drive.route.cells(), drive.route.seconds(cell_mm, &run.pace)));
            let ratio = |of: Option<f64>, best: Option<f64>| Some(format!("{:.2}", of? / best?.max(f64::MIN_POSITIVE)));
            let length = ratio(route.map(|route| f64::from(route.0)), run.shortest.map(|best| f64::from(best.cells)));
            let time = ratio(route.map(|route| route.1), run.fastest.map(|best| best.seconds));
            let total = run.total;
            let bytes = run.recording.last().robot().peak_bytes();
            let facts = view! {
                <dl class="facts">
                    {route.map(|(cells, s)| fact("Route", cells.to_string(), seconds(s)))}
                    {run.shortest.map(|best| fact("Shortest", best.cells.to_string(), seconds(best.seconds)))}
                    {run.fastest.map(|best| fact("Fastest", best.cells.to_string(), seconds(best.seconds)))}
                    {length.map(|ratio| fact("Ratio", ratio, "to the shortest".into()))}
                    {time.map(|ratio| fact("Time", ratio, "to the fastest".into()))}
                    {fact("Exploration", total.cells.to_string(), seconds(total.seconds(cell_mm, &run.pace)))}
                    {fact("Stops", run.recording.stops().to_string(), String::new())}
                    {fact("Turns", format!("{}", total.left_turns + total.right_turns + total.u_turns), format!("L {} · R {} · B {}", total.left_turns, total.right_turns, total.u_turns))}
                    {fact("Memory", bytes.to_string(), "bytes on the robot".into())}
                </dl>
            }
            .into_any();
            Some(facts)
        })
    })
    .into_any()
}

/// The list as it is to be exported.
fn list(run: &OtherRun, corners: Corners) -> Option<TurnList> {
    match (corners, &run.drive) {
        (Corners::Listed, Some(drive)) => Some(drive.route.list(Corners::Listed)),
        (Corners::Listed | Corners::LeftOut, _) => run.list.clone(),
    }
}

/// The turn list as letters, JSON, CSV or C, with corners or without.
fn export(watched: Watched) -> AnyView {
    let lab = lab();
    let form = RwSignal::new(Form::Letters);
    let corners = RwSignal::new(false);
    let text = Memo::new(move |_| {
        let corners = if corners.get() { Corners::Listed } else { Corners::LeftOut };
        watched.of(|run| {
            list(run, corners)
                .map_or_else(String::new, |list| forms::write(&list, form.get(), corners, &title(&run.maze)))
        })
    });
    let choose = move |event: web_sys::Event| {
        browser::let_go(&event);
        let value = event_target_value(&event);
        form.set(Form::ALL.into_iter().find(|form| form.extension() == value).unwrap_or_default());
    };
    view! {
        <details class="export">
            <summary>"Export the turn list"</summary>
            <div class="row">
                <select class="input" aria-label="Form" on:change=event(choose)>
                    {Form::ALL.map(|form| view! { <option value=form.extension()>{name(form)}</option> }).into_iter().collect_view()}
                </select>
                <label class="switch"><input type="checkbox" prop:checked=sig(move || corners.get()) on:change=event(move |event| corners.set(event_target_checked(&event))) />"corners too"</label>
            </div>
            <pre class="snip mono" tabindex="0" aria-label="Turn list"><code>{part(move || text.get())}</code></pre>
            <div class="row">
                <button class="btn" on:click=mouse(move |_| browser::copy(text.get_untracked(), move |ok| copied(lab, ok)))>"Copy"</button>
                <button class="btn" on:click=mouse(move |_| {
                    let name = format!("turns.{}", form.get_untracked().extension());
                    browser::download(&name, "text/plain", &text.get_untracked());
                })>"Save"</button>
            </div>
        </details>
    }
    .into_any()
}

const fn name(form: Form) -> &'static str {
    match form {
        Form::Letters => "Letters",
        Form::Json => "JSON",
        Form::Csv => "CSV",
        Form::C => "C array",
    }
}

/// Says whether a text was copied.
pub fn copied(lab: Lab, ok: bool) {
    match ok {
        true => lab.say(ToastTone::Info, "", "Copied."),
        false => lab.say(
            ToastTone::Error,
            "Can’t copy",
            "This browser gives no access to the clipboard: select the text and copy it by hand.",
        ),
    }
}
