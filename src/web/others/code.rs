//! The explorer's pseudo-code, with the lines that ran at this stop, the last of them, and the one that runs next.

use leptos::html;
use leptos::prelude::*;

use super::Watched;
use crate::explorer::glossary;
use crate::web::erase::{part, sig};
use crate::web::state::lab;
use crate::web::step::code::{books, pen, token};

/// The card.
pub fn card(watched: Watched) -> AnyView {
    let lines = Memo::new(move |_| watched.at(|_, at| (at.ran_lines().to_vec(), at.next())));
    let last = move || lines.with(|(ran, _)| ran.last().copied());
    let list = NodeRef::<html::Ol>::new();
    // The line that ran stays in sight without moving the page.
    Effect::new(move |_| {
        let (Some(list), Some(ran)) = (list.get(), last()) else { return };
        request_animation_frame(move || {
            let Some(row) = list.children().item(u32::from(ran)) else { return };
            let (top, bottom) = (row.get_bounding_client_rect(), list.get_bounding_client_rect());
            let off = top.top() - bottom.top();
            if off < 10.0 || off > bottom.height() - 40.0 {
                list.set_scroll_top((f64::from(list.scroll_top()) + off - bottom.height() / 2.5) as i32);
            }
        });
    });
    let lab = lab();
    let whose = Memo::new(move |_| watched.of(|run| (run.recording.name(), run.about().ours)));
    let row = move |(line, text): (u8, &'static str)| {
        let is_last = move || last() == Some(line);
        let is_next = move || lines.with(|(_, next)| *next == Some(line));
        let did = move || lines.with(|(ran, _)| ran.contains(&line));
        let (explorer, ours) = whose.get_untracked();
        view! {
            <li class:ran=sig(is_last) class:next=sig(is_next) class:did=sig(did) aria-current=sig(move || is_last().then_some("step"))>
                <span class="ln">{line + 1}</span>
                <span class=indent(text)>
                    {glossary::split(explorer, text.trim_start()).map(token).collect_view()}
                    {ours.get(usize::from(line)).is_some_and(|ours| *ours).then(pen)}
                </span>
                <span class="tag">{part(move || if is_last() { "ran" } else if is_next() { "next" } else { "" })}</span>
            </li>
        }
    };
    let listing = Memo::new(move |_| watched.of(|run| run.about().listing));
    view! {
        <section class="card fill code-card" aria-labelledby="code-title">
            <h2 id="code-title">
                "The algorithm"
                <span class="spacer"></span>
                {books(lab)}
            </h2>
            <ol class="code" node_ref=list tabindex="0" aria-labelledby="code-title">
                {part(move || (0u8..).zip(listing.get().iter().copied()).map(row).collect_view())}
            </ol>
        </section>
    }
    .into_any()
}

/// The class for a line's indentation: two spaces a level.
fn indent(text: &str) -> &'static str {
    match (text.len() - text.trim_start().len()) / 2 {
        0 => "in-0",
        1 => "in-1",
        2 => "in-2",
        _ => "in-3",
    }
}
