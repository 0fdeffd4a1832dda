//! What is in order in the maze and what is not: each with its place and a cure.

use crate::web::erase::{mouse, part, sig};
use leptos::prelude::*;

use super::desk::{Desk, desk, many};
use crate::maze::Kind;
use crate::maze::checks::{Finding, InOrder, Report, Severity};
use crate::maze::edit::Edit;
use crate::web::icons;

/// More findings than these are only counted.
const LISTED: usize = 8;

/// The card.
#[component]
pub fn Checks() -> impl IntoView {
    let desk = desk();
    let listed = move || {
        let kind = desk.kind();
        desk.report.with(|report| {
            let more = report.findings.len().saturating_sub(LISTED);
            view! {
                {report.findings.iter().take(LISTED).cloned().map(|finding| item(desk, finding, kind)).collect_view()}
                {(more > 0).then(|| view! { <li><span></span><span class="small">{format!("and {more} more like these")}</span></li> })}
                {report.in_order.iter().map(|item| in_order(item, kind)).collect_view()}
            }
        })
    };
    view! {
        <section class="card checks-card" aria-live="polite">
            <h2>"Checks" <span class="spacer"></span> {part(move || desk.report.with(count))}</h2>
            <ul class="checks">{listed}</ul>
        </section>
    }
}

/// How many are not in order.
fn count(report: &Report) -> impl IntoView + use<> {
    let of = |severity| report.findings.iter().filter(|finding| finding.severity() == severity).count();
    match (of(Severity::Error), of(Severity::Warning)) {
        (0, 0) => view! { <span class="case go">"in order"</span> }.into_any(),
        (0, warnings) => view! { <span class="case">{many(warnings, "warning")}</span> }.into_any(),
        (errors, 0) => view! { <span class="case bad">{many(errors, "error")}</span> }.into_any(),
        (errors, warnings) => view! {
            <span class="case bad">{many(errors, "error")}</span>
            <span class="case">{many(warnings, "warning")}</span>
        }
        .into_any(),
    }
}

fn item(desk: Desk, finding: Finding, kind: Kind) -> impl IntoView {
    let this = finding.clone();
    let is_shown = Memo::new(move |_| desk.shown.with(|shown| shown.as_ref() == Some(&this)));
    let mark = match finding.severity() {
        Severity::Error => {
            view! { <span class="mark bad">{icons::no()}<span class="vh">"Error: "</span></span> }.into_any()
        }
        Severity::Warning => {
            view! { <span class="mark warn">{icons::warn()}<span class="vh">"Warning: "</span></span> }
                .into_any()
        }
    };
    let show = finding.place().is_some().then(|| {
        let finding = finding.clone();
        view! {
            <button class="btn" aria-pressed=sig(move || is_shown.get().to_string()) on:click=mouse(move |_| desk.toggle_shown(finding.clone()))>"Show it"</button>
        }
    });
    let erase = if let Finding::Apart(piece) = &finding {
        let cells = piece.cells.clone();
        let label = match (kind, cells.len()) {
            (Kind::Line, 1) => "Erase it",
            (Kind::Line, _) => "Erase them",
            (Kind::Wall, _) => "Close them off",
        };
        Some(view! { <button class="btn" on:click=mouse(move |_| erase(desk, &cells))>{label}</button> })
    } else {
        None
    };
    let turn = matches!(finding, Finding::StartFacesAway { .. })
        .then(|| view! { <button class="btn" on:click=mouse(move |_| turn(desk))>"Turn it"</button> });
    view! {
        <li class:at=sig(move || is_shown.get())>
            {mark}
            <div>
                <b>{finding.title_in(kind)}</b>
                <span class="small">{finding.cure_in(kind)}</span>
                <div class="row">{show}{erase}{turn}</div>
            </div>
        </li>
    }
}

fn erase(desk: Desk, cells: &[(crate::geometry::Point, crate::geometry::Heading)]) {
    if desk.lab.edit(Edit::Erase(cells.to_vec())) {
        let said = match desk.with_maze(|maze| maze.kind) {
            Kind::Line => format!("{} erased.", many(cells.len(), "cell")),
            Kind::Wall => format!("{} built.", many(cells.len(), "wall")),
        };
        desk.lab.say_done(said);
    }
}

/// Turns the start along its line.
fn turn(desk: Desk) {
    if let Some(start) = desk.with_maze(crate::maze::Maze::start) {
        desk.put_start(start.at);
    }
}

fn in_order(item: &InOrder, kind: Kind) -> impl IntoView + use<> {
    view! {
        <li>
            <span class="mark ok">{icons::ok()}<span class="vh">"In order: "</span></span>
            <div>{item.title_in(kind)}<span class="small">{item.detail()}</span></div>
        </li>
    }
}
