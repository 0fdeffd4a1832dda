//! The tools beside the drawing; on a phone below it.

use crate::web::erase::{mouse, sig};
use leptos::prelude::*;

use super::desk::desk;
use crate::gesture::Tool;
use crate::maze::Kind;
use crate::web::icons;

/// The toolbar.
#[component]
pub fn Tools() -> impl IntoView {
    let desk = desk();
    let walls = Memo::new(move |_| desk.kind() == Kind::Wall);
    let word =
        move |line: &'static str, wall: &'static str| sig(move || if walls.get() { wall } else { line });
    let still = |word: &'static str| sig(move || word);
    let tool = move |tool: Tool, name: Signal<&'static str>, title: Signal<&'static str>, icon: AnyView| {
        view! {
            <button class="tool" title=title aria-pressed=sig(move || (desk.held_tool() == tool).to_string()) on:click=mouse(move |_| desk.take(tool))>
                {icon}
                {name}
            </button>
        }
    };
    view! {
        <div class="tools" role="toolbar" aria-label="Tools">
            {tool(Tool::Line, word("Line", "Wall"), word("Line (L)", "Wall (W)"), icons::line().into_any())}
            {tool(Tool::Erase, word("Erase", "Open"), word("Erase (E), or the right button", "Open walls (E), or the right button"), icons::erase().into_any())}
            <hr />
            {tool(Tool::Start, still("Start"), still("Start (S)"), icons::start().into_any())}
            {tool(Tool::Finish, still("Finish"), still("Finish (F); Shift adds or removes further points"), icons::finish().into_any())}
            <hr />
            {tool(Tool::Move, still("Move"), still("Move the paper (M, or hold Space)"), icons::move_paper().into_any())}
        </div>
    }
}
