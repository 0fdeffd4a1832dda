//! What the browser keeps and this page does not show: a maze that can't be read, and one that another tab has kept.

use leptos::prelude::*;

use crate::maze::text;
use crate::web::erase::{mouse, part, sig};
use crate::web::keeping::{self, Kept};
use crate::web::lazy::lazy;
use crate::web::state::lab;
use crate::web::{browser, icons, storage};

lazy! { dialogs;
    /// A kept maze that can't be read: why, and the way to have it as a file.
    pub fn aside() -> AnyView {
        let lab = lab();
        let kept = storage::aside().unwrap_or_default();
        let why = text::parse(&kept).err().map(|why| why.to_string());
        let drop = {
            let kept = kept.clone();
            move |_| {
                storage::drop_aside(&kept);
                // There may be another one.
                lab.aside.set(storage::aside().is_some());
            }
        };
        let why = why.unwrap_or_else(|| "It can be read now.".to_owned());
        let save = save(kept, "kept-aside.maze");
        let buttons = view! {
            {save}
            <button class="btn" on:click=mouse(drop)>"Throw it away"</button>
        };
        let told = sig(move || format!("{why} It is put aside, as it was."));
        note("A maze that this browser kept can’t be read", told, buttons.into_any())
    }
}

lazy! { dialogs;
    /// Another tab's maze stands where this one's is kept.
    pub fn other() -> AnyView {
        let lab = lab();
        let buttons = move || {
            let Kept::Other(text) = lab.kept.get() else { return ().into_any() };
            let theirs = match text::parse(&text) {
                Ok(maze) => view! {
                    <button class="btn" on:click=mouse(move |_| keeping::take_other(lab, maze.clone()))>"Take the other tab’s"</button>
                }
                .into_any(),
                // Of a later version.
                Err(_) => save(text, "other-tab.maze"),
            };
            view! {
                {theirs}
                <button class="btn" on:click=mouse(move |_| keeping::keep_mine(lab))>"Keep this one"</button>
            }
            .into_any()
        };
        let told = sig(move || {
            let title = lab.kept.with(|kept| match kept {
                Kept::Other(text) => text::parse(text).ok().map(|maze| maze.about.title),
                Kept::Here | Kept::Refused => None,
            });
            let title = title.filter(|title| !title.is_empty()).map(|title| format!(", “{title}”")).unwrap_or_default();
            format!("The browser keeps one maze, and that is the other tab’s now{title}. What is open here is not kept until you choose.")
        });
        note("Another tab has changed the maze", told, part(buttons).into_any())
    }
}

/// A note with what is to be known and what can be done.
fn note(title: &'static str, told: Signal<String>, buttons: AnyView) -> AnyView {
    view! {
        <div class="note warn" role="status">
            <span class="mark warn">{icons::warn()}</span>
            <div>
                <p><b>{title}</b></p>
                <p class="small">{told}</p>
                <div class="row">{buttons}</div>
            </div>
        </div>
    }
    .into_any()
}

/// Offers a text as a file.
fn save(text: String, name: &'static str) -> AnyView {
    view! {
        <button class="btn" on:click=mouse(move |_| browser::download(name, "text/plain", &text))>"Save it as a file"</button>
    }
    .into_any()
}
