//! A maze or a link, pasted by hand.

use crate::web::erase::{sig, submit};
use leptos::html;
use leptos::prelude::*;

use crate::maze::file;
use crate::web::dialogs::Modal;
use crate::web::opening;
use crate::web::state::lab;

/// The dialog.
#[component]
pub fn Paste() -> impl IntoView {
    let lab = lab();
    let text = NodeRef::<html::Textarea>::new();
    let wrong = RwSignal::new(String::new());
    let open = move |event: web_sys::SubmitEvent| {
        event.prevent_default();
        let text = text.get_untracked().map(|field| field.value()).unwrap_or_default();
        if opening::link_in(&text).is_some() {
            lab.dialog.set(None);
            return opening::open_text(lab, text);
        }
        match file::read(text.as_bytes()) {
            Ok(maze) => {
                lab.dialog.set(None);
                lab.broken_link.set(None);
                lab.open(maze);
                lab.say_done("The pasted maze is open.");
            }
            Err(why) => wrong.set(why.to_string()),
        }
    };
    view! {
        <Modal title="Paste a maze">
            <form class="stack" on:submit=submit(open)>
                <label class="field" for="paste">"The text of a .maze, .json or micromouse file, or a link to a maze"</label>
                <textarea class="input" id="paste" rows="12" spellcheck="false" autocomplete="off" node_ref=text
                    aria-invalid=sig(move || (!wrong.with(String::is_empty)).to_string()) aria-describedby="paste-wrong"></textarea>
                <p class="wrong" id="paste-wrong" role="alert">{wrong}</p>
                <div class="row"><button class="btn primary" type="submit">"Open"</button></div>
            </form>
        </Modal>
    }
}
