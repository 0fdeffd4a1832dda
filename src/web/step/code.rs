//! The algorithm, with the line that ran and the one that runs next.

use crate::web::erase::{mouse, part, sig};
use leptos::html;
use leptos::prelude::*;

use super::look_up;
use crate::explorer::book::code::{LISTING, Listed, OURS};
use crate::explorer::book::glossary::{Token, split};
use crate::web::icons;
use crate::web::state::{Dialog, Lab, lab};

/// The card.
#[component]
pub fn CodeCard() -> impl IntoView {
    let lab = lab();
    let line = |of: fn(&crate::trace::Frame) -> Option<crate::explorer::book::code::Line>| {
        Memo::new(move |_| lab.frame.with(|frame| frame.as_ref().and_then(of)).map(|line| line.index()))
    };
    let (ran, next) = (line(|frame| frame.ran), line(|frame| frame.next));
    let list = NodeRef::<html::Ol>::new();
    // The line that ran stays in sight without moving the page.
    Effect::new(move |_| {
        let (Some(list), Some(ran)) = (list.get(), ran.get()) else { return };
        // Once all views have followed the step: to ask for places earlier would lay the page out twice.
        request_animation_frame(move || {
            let Some(row) = list.children().item(ran as u32) else { return };
            let (top, bottom) = (row.get_bounding_client_rect(), list.get_bounding_client_rect());
            let off = top.top() - bottom.top();
            if off < 30.0 || off > bottom.height() - 60.0 {
                list.set_scroll_top((f64::from(list.scroll_top()) + off - bottom.height() / 2.5) as i32);
            }
        });
    });
    let row = move |(index, listed): (usize, &'static Listed)| {
        let is = move |line: Memo<Option<usize>>| line.get() == Some(index);
        view! {
            <li class:ran=sig(move || is(ran)) class:next=sig(move || is(next)) aria-current=sig(move || is(ran).then_some("step"))>
                <span class="ln">{listed.label}</span>
                <span class=indent(listed.text)>{split(listed.text).map(token).collect_view()}{OURS.iter().any(|line| line.index() == index).then(pen)}</span>
                <span class="tag">{part(move || if is(ran) { "ran" } else if is(next) { "next" } else { "" })}</span>
            </li>
        }
    };
    view! {
        <section class="card fill code-card" aria-labelledby="code-title">
            <h2 id="code-title">
                "The algorithm"
                <span class="spacer"></span>
                {books(lab)}
            </h2>
            <ol class="code" node_ref=list tabindex="0" aria-labelledby="code-title">
                {LISTING.iter().enumerate().map(row).collect_view()}
            </ol>
        </section>
    }
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

/// The ways to what is to be read about the listing: what of it is the lab's, and the names.
pub fn books(lab: Lab) -> AnyView {
    view! {
        <button class="btn quiet" title="What of this is the lab’s reading, and where the source slips" on:click=mouse(move |_| lab.dialog.set(Some(Dialog::Errata)))>
            {icons::pen()}"lab’s reading"
        </button>
        <button class="btn quiet" on:click=mouse(move |_| lab.dialog.set(Some(Dialog::Glossary(None))))>"Glossary (G)"</button>
    }
    .into_any()
}

/// The mark of a line that is the lab's reading.
pub fn pen() -> AnyView {
    view! { <span class="ours" title="the lab’s reading">{icons::pen()}<span class="vh">" (the lab’s reading)"</span></span> }.into_any()
}

/// A piece of a line; names lead to the glossary.
pub fn token(token: Token<'static>) -> impl IntoView {
    let lab = lab();
    match token {
        Token::Keyword(text) => view! { <b>{text}</b> }.into_any(),
        Token::Comment(text) => view! { <span class="comment">{text}</span> }.into_any(),
        Token::Text(text) => text.into_any(),
        Token::Name(text, name) => {
            view! { <button class="name" tabindex="-1" on:click=mouse(move |_| look_up(lab, name))>{text}</button> }
                .into_any()
        }
    }
}
