//! The explorer's own data structures at the moment, under the names of its source: one piece of markup, made of
//! numbers and fixed words.

use std::fmt::Write;

use leptos::html;
use leptos::prelude::*;

use super::Watched;
use super::run::{At, OtherRun};
use crate::explorer::mind::Mind;
use crate::web::erase::{mouse, part, sig};
use crate::web::state::lab;
use crate::web::step::look_up;

mod bytes;
mod columns;
mod flood;
mod letters;
mod links;
mod marks;
mod path;
mod stack;
mod sums;

/// Of a long list so many of the last items are shown.
const SHOWN: usize = 60;

/// The card.
pub fn card(watched: Watched) -> AnyView {
    let mapped =
        Memo::new(move |_| watched.at(|run, at| at.is_end(run) && matches!(at.mind, Mind::Mapping(_))));
    let lab = lab();
    let body = NodeRef::<html::Div>::new();
    // The newest column stays in sight without moving the page.
    Effect::new(move |_| {
        let Some(div) = body.get() else { return };
        watched.at(|_, at| at.stop.stop);
        request_animation_frame(move || {
            let Ok(Some(now)) = div.query_selector(".cols .now, .cols td:last-child") else { return };
            let (inner, outer) = (now.get_bounding_client_rect(), div.get_bounding_client_rect());
            let off = inner.right() - outer.right() + 24.0;
            if off > 0.0 || inner.left() < outer.left() + 80.0 {
                div.set_scroll_left((f64::from(div.scroll_left()) + off).max(0.0) as i32);
            }
        });
    });
    view! {
        <section class="card inspector" aria-labelledby="inspector-title">
            <h2 id="inspector-title">{part(move || watched.at(|_, at| title(&at.mind)))}</h2>
            <div class="insp" id="inspector" node_ref=body tabindex="0" role="region" aria-labelledby="inspector-title" inner_html=sig(move || watched.at(|run, at| links::linked(run.recording.name(), &markup(run, at))))
                on:click=mouse(move |event| {
                    if let Some(name) = links::clicked(watched.of(|run| run.recording.name()), &event) {
                        look_up(lab, name);
                    }
                })></div>
            {part(move || mapped.get().then(|| super::search::panel(watched)))}
        </section>
    }
    .into_any()
}

const fn title(mind: &Mind) -> &'static str {
    match mind {
        Mind::Hand(_) => "Turn letters",
        Mind::Sums(_) => "Direction sums",
        Mind::Mapping(_) => "Arrays, one column a visit",
        Mind::Parex(_) => "Path of squares",
        Mind::Cornell(_) => "A byte for every square",
        Mind::Tremaux(_) => "Marks on the ways",
        Mind::DepthFirst(_) => "Stack and used ways",
        Mind::FloodFill(_) => "Numbers of the flood",
    }
}

fn markup(run: &OtherRun, at: &At) -> String {
    let before = (at.whole && at.stop.stop > 0).then(|| run.recording.at(at.stop.stop - 1).mind);
    match (&at.mind, &before) {
        (Mind::Hand(now), Some(Mind::Hand(before))) => letters::markup(now, Some(before), at.stop.decision),
        (Mind::Hand(now), _) => letters::markup(now, None, at.stop.decision),
        (Mind::Sums(mind), _) => sums::markup(mind),
        (Mind::Mapping(mind), _) => columns::markup(mind, at.is_end(run)),
        (Mind::Parex(now), Some(Mind::Parex(before))) => path::markup(now, Some(before)),
        (Mind::Parex(now), _) => path::markup(now, None),
        (Mind::Cornell(mind), _) => bytes::markup(mind),
        (Mind::Tremaux(mind), _) => marks::markup(mind, run.recording.cell_ms()),
        (Mind::DepthFirst(mind), _) => stack::markup(mind, run.recording.cell_ms()),
        (Mind::FloodFill(mind), _) => flood::markup(mind, run.recording.from_start(at.stop.at)),
    }
}

/// A row of a table of columns: its name, then each cell with its class.
fn row(markup: &mut String, name: &str, cells: impl IntoIterator<Item = (&'static str, String)>) {
    let _ = write!(markup, "<tr><th scope=\"row\">{name}</th>");
    for (class, cell) in cells {
        let _ = write!(markup, "<td class=\"{class}\">{cell}</td>");
    }
    markup.push_str("</tr>");
}

/// How many items of a long list are not shown.
fn earlier(all: usize) -> String {
    match all.saturating_sub(SHOWN) {
        0 => String::new(),
        left => format!("<p class=\"small\">… {left} earlier ones are not shown</p>"),
    }
}
