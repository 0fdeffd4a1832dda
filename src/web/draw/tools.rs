//! The tools beside the drawing; on a phone below it.

use crate::web::erase::{mouse, sig};
use leptos::prelude::*;

use super::desk::desk;
use crate::gesture::Tool;
use crate::web::icons;

/// The toolbar.
#[component]
pub fn Tools() -> impl IntoView {
    let desk = desk();
    let tool = move |tool: Tool, name: &'static str, title: &'static str, icon: AnyView| {
        view! {
            <button class="tool" title=title aria-pressed=sig(move || (desk.held_tool() == tool).to_string()) on:click=mouse(move |_| desk.take(tool))>
                {icon}
                {name}
            </button>
        }
    };
    view! {
        <div class="tools" role="toolbar" aria-label="Tools">
            {tool(Tool::Line, "Line", "Line (L)", icons::line().into_any())}
            {tool(Tool::Erase, "Erase", "Erase (E), or the right button", icons::erase().into_any())}
            <hr />
            {tool(Tool::Start, "Start", "Start (S)", icons::start().into_any())}
            {tool(Tool::Finish, "Finish", "Finish (F); Shift adds or removes further points", icons::finish().into_any())}
            <hr />
            {tool(Tool::Move, "Move", "Move the paper (M, or hold Space)", icons::move_paper().into_any())}
        </div>
    }
}
