//! The explorer's own data structures at the moment, under the names of its source, with what the last line (or
//! stop) changed: one piece of markup, made of numbers and fixed words.

use std::fmt::Write;

use leptos::html;
use leptos::prelude::*;

use super::Watched;
use super::run::{OtherRun, is_end};
use crate::explorer::depth_first::DepthFirst;
use crate::explorer::mind::Mind;
use crate::explorer::tremaux::Tremaux;
use crate::recording::moment::At;
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
        Memo::new(move |_| watched.at(|run, at| is_end(run, at) && matches!(at.mind, Mind::Mapping(_))));
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

/// The mind of this kind before, if there is one.
macro_rules! before {
    ($at:ident, $kind:ident) => {
        $at.before.as_ref().and_then(|mind| if let Mind::$kind(mind) = mind { Some(mind) } else { None })
    };
}

fn markup(run: &OtherRun, at: &At) -> String {
    let mut markup = memory(run, at);
    if markup.contains("changed\"") {
        let since = if at.is_whole() { "changed at this stop" } else { "changed by this line" };
        let _ = write!(markup, "<p class=\"keys small\"><span><i class=\"changed\"></i>{since}</span></p>");
    }
    markup
}

fn memory(run: &OtherRun, at: &At) -> String {
    let cell_ms = run.recording.cell_ms();
    match &at.mind {
        Mind::Hand(now) => letters::markup(now, before!(at, Hand), at.stop.decision),
        Mind::Sums(now) => sums::markup(now, before!(at, Sums)),
        Mind::Mapping(now) => columns::markup(now, before!(at, Mapping), is_end(run, at)),
        Mind::Parex(now) => path::markup(now, before!(at, Parex)),
        Mind::Cornell(now) => bytes::markup(now, before!(at, Cornell)),
        Mind::Tremaux(now) => marks::markup(now.memory(), before!(at, Tremaux).map(Tremaux::memory), cell_ms),
        Mind::DepthFirst(now) => {
            stack::markup(now.memory(), before!(at, DepthFirst).map(DepthFirst::memory), cell_ms)
        }
        Mind::FloodFill(now) => {
            flood::markup(now, before!(at, FloodFill), run.recording.from_start(at.stop.at))
        }
    }
}

/// A row of a table of columns: its name, then each cell with its class.
fn row(markup: &mut String, name: &str, cells: impl IntoIterator<Item = ([&'static str; 2], String)>) {
    let _ = write!(markup, "<tr><th scope=\"row\">{name}</th>");
    for ([class, changed], cell) in cells {
        let _ = write!(markup, "<td class=\"{class}{changed}\">{cell}</td>");
    }
    markup.push_str("</tr>");
}

/// The class of a value that differs from what it was; nothing was before the start.
fn changed<T: PartialEq>(now: T, before: Option<T>) -> &'static str {
    if before.is_some_and(|before| before != now) { " changed" } else { "" }
}

/// How many items of a long list are not shown.
fn earlier(all: usize) -> String {
    match all.saturating_sub(SHOWN) {
        0 => String::new(),
        left => format!("<p class=\"small\">… {left} earlier ones are not shown</p>"),
    }
}
