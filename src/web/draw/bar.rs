//! Above the drawing: files, title, size, history, generator.

use crate::web::erase::{mouse, sig};
use leptos::prelude::*;

use super::desk::{desk, many};
use super::menu::FileMenu;
use crate::maze::Kind;
use crate::maze::edit::History;
use crate::web::state::{Dialog, lab};
use crate::web::{icons, past};

/// The bar.
#[component]
pub fn Bar() -> impl IntoView {
    let (lab, desk) = (lab(), desk());
    let title = move || {
        lab.maze.with(|maze| {
            if maze.about.title.is_empty() { "Untitled maze".to_owned() } else { maze.about.title.clone() }
        })
    };
    let size = move || {
        lab.maze.with(|maze| {
            let (bounds, cells) = (maze.bounds(), maze.cells());
            let (places, cells) = match maze.kind {
                Kind::Line => ("points", many(cells, "cell")),
                Kind::Wall => ("squares", many(cells, "opening")),
            };
            format!(
                "{} × {} {places} · {cells} · {}",
                bounds.width(),
                bounds.height(),
                many(maze.nodes(), "node")
            )
        })
    };
    view! {
        <div class="bar">
            <FileMenu />
            <span class="title">
                <b>{title}</b>
                <button class="btn icon quiet" aria-label="Rename, describe" title="Title, source and note" on:click=mouse(move |_| lab.dialog.set(Some(Dialog::About)))>
                    {icons::pen()}
                </button>
            </span>
            <span class="hide-m size">{size}</span>
            <span class="spacer"></span>
            <Past />
            <button
                class="btn generate"
                id="generate"
                aria-expanded=sig(move || desk.generating.get().to_string())
                on:click=mouse(move |_| desk.generating.update(|on| *on = !*on))
            >
                "Generate"
            </button>
        </div>
    }
}

/// Undo and redo, each with what it would do.
#[component]
fn Past() -> impl IntoView {
    let lab = lab();
    let undo = move || {
        let label = lab.history.with(History::undo_label);
        label.map_or_else(|| "Undo (Ctrl Z)".to_owned(), |label| format!("Undo: {label} (Ctrl Z)"))
    };
    let redo = move || {
        let label = lab.history.with(History::redo_label);
        label
            .map_or_else(|| "Redo (Ctrl Shift Z)".to_owned(), |label| format!("Redo: {label} (Ctrl Shift Z)"))
    };
    view! {
        <span class="group" role="group" aria-label="History">
            <button class="btn icon" aria-label=undo title=undo disabled=sig(move || !lab.history.with(History::can_undo)) on:click=mouse(move |_| past::undo(lab))>
                {icons::undo()}
            </button>
            <button class="btn icon" aria-label=redo title=redo disabled=sig(move || !lab.history.with(History::can_redo)) on:click=mouse(move |_| past::redo(lab))>
                {icons::redo()}
            </button>
        </span>
    }
}
