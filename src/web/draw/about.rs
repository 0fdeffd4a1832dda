//! What is written about a maze: title, source, note.

use crate::web::erase::submit;
use leptos::html;
use leptos::prelude::*;

use crate::maze::About as Words;
use crate::maze::edit::Edit;
use crate::web::dialogs::{Modal, Width};
use crate::web::state::lab;

/// The most characters of a title, a source, and a note.
const MOST: [&str; 3] = ["120", "200", "2000"];

/// The dialog.
#[component]
pub fn About() -> impl IntoView {
    let lab = lab();
    let about = lab.maze.with_untracked(|maze| maze.about.clone());
    let (title, source) = (NodeRef::<html::Input>::new(), NodeRef::<html::Input>::new());
    let note = NodeRef::<html::Textarea>::new();
    let keep = move |event: web_sys::SubmitEvent| {
        event.prevent_default();
        let text = |field: Option<String>| tidy(&field.unwrap_or_default());
        let about = Words {
            title: text(title.get_untracked().map(|field| field.value())),
            source: text(source.get_untracked().map(|field| field.value())),
            note: text(note.get_untracked().map(|field| field.value())),
        };
        lab.edit(Edit::About(about));
        lab.dialog.set(None);
    };
    view! {
        <Modal title="About this maze" width=Width::Narrow>
            <form class="stack" on:submit=submit(keep)>
                <label class="field">"Title"<input class="input" id="about-title" node_ref=title maxlength=MOST[0] autocomplete="off" prop:value=about.title /></label>
                <label class="field">"Source: where it is from"<input class="input" id="about-source" node_ref=source maxlength=MOST[1] autocomplete="off" prop:value=about.source /></label>
                <label class="field">"Note: what it teaches"<textarea class="input" id="about-note" rows="4" node_ref=note maxlength=MOST[2] prop:value=about.note></textarea></label>
                <div class="row"><button class="btn primary" type="submit">"Keep"</button></div>
            </form>
        </Modal>
    }
}

/// Without blanks at the ends of lines, and without characters that cannot be seen.
fn tidy(text: &str) -> String {
    let lines = text.lines().map(|line| line.trim_end().replace('\t', " "));
    let seen = |c: &char| *c == '\n' || !c.is_control();
    lines.collect::<Vec<_>>().join("\n").trim().chars().filter(seen).collect()
}
