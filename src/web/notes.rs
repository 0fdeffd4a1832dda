//! Notes at the head of a room: what the user should know before going on.

use crate::web::erase::{mouse, part};
use leptos::prelude::*;

use super::icons;
use super::state::{Dialog, lab};

/// A link that does not hold a whole maze: why, and what to do.
#[component]
pub fn BrokenLink() -> impl IntoView {
    let lab = lab();
    let keep = move |_| lab.broken_link.set(None);
    part(move || {
        lab.broken_link.get().map(|why| {
            view! {
                <div class="note warn" role="alert">
                    <span class="mark warn">{icons::warn()}</span>
                    <div>
                        <p><b>"This link doesn’t hold a whole maze"</b></p>
                        <p class="small">{why} " Your own last maze is open instead."</p>
                        <div class="row">
                            <button class="btn" on:click=mouse(keep)>"Keep my maze"</button>
                            <button class="btn" on:click=mouse(move |_| lab.dialog.set(Some(Dialog::Paste)))>"Paste the link again"</button>
                        </div>
                    </div>
                </div>
            }
        })
    })
}

/// The browser keeps nothing: the drawing would be gone with the page.
#[component]
pub fn NotKept() -> impl IntoView {
    let lab = lab();
    part(move || {
        lab.not_kept.get().then(|| {
            view! {
                <div class="note warn" role="status">
                    <span class="mark warn">{icons::warn()}</span>
                    <div>
                        <p><b>"This browser doesn’t keep your drawing"</b></p>
                        <p class="small">"Its storage is full or forbidden. Save the maze as a file before you close the page."</p>
                        <div class="row">
                            <button class="btn" on:click=mouse(move |_| super::draw::save(lab))>"Save .maze"</button>
                        </div>
                    </div>
                </div>
            }
        })
    })
}
