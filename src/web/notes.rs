//! Notes at the head of a room: what the user should know before going on.

use crate::web::erase::{event, mouse, part};
use leptos::prelude::*;

use super::keeping::Kept;
use super::lazy;
use super::state::{Dialog, lab};
use super::{browser, icons, storage};

mod kept;

/// What concerns the maze in whatever room it is shown.
#[component]
pub fn Notes() -> impl IntoView {
    let lab = lab();
    let other = move || lab.kept.with(|kept| matches!(kept, Kept::Other(_)));
    view! {
        <BrokenLink />
        {part(move || lab.aside.get().then(|| lazy::view(kept::aside)))}
        {part(move || other().then(|| lazy::view(kept::other)))}
    }
}

/// A link that does not hold a whole maze: why, and what to do.
#[component]
fn BrokenLink() -> impl IntoView {
    let lab = lab();
    let keep = move |_| lab.broken_link.set(None);
    part(move || {
        lab.broken_link.get().map(|why| {
            view! {
                <div class="note warn" role="alert">
                    <span class="mark warn">{icons::warn()}</span>
                    <div>
                        <p><b>"This link doesn’t hold a whole maze"</b></p>
                        <p class="small">{why} " What was open before stays open."</p>
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

/// What the maze teaches, as its author noted it; it folds, and stays so.
#[component]
pub fn MazeNote() -> impl IntoView {
    const LONG: usize = 300;
    const ROOMY: &str = "(min-width: 1024px) and (min-height: 860px)";
    let lab = lab();
    let open = RwSignal::new(storage::note_open().unwrap_or_else(|| browser::media(ROOMY)));
    let note = Memo::new(move |_| lab.stage.with(|maze| maze.about.note.clone()));
    // The browser tells this also of a note that is open from the beginning.
    let fold = move |event: web_sys::Event| {
        let now = browser::is_open(&event);
        if now != open.get_untracked() {
            open.set(now);
            storage::keep_note_open(now);
        }
    };
    part(move || {
        (!note.with(String::is_empty)).then(|| {
            view! {
                <details class="maze-note" prop:open=open.get_untracked() on:toggle=event(fold)>
                    <summary><b>"What it teaches"</b><span class="begins">{note.get()}</span></summary>
                    // A long one scrolls, and what scrolls can be scrolled by keys.
                    <p tabindex=(note.with(String::len) > LONG).then_some("0")>{note.get()}</p>
                </details>
            }
        })
    })
}

/// The browser keeps nothing: the drawing would be gone with the page.
#[component]
pub fn NotKept() -> impl IntoView {
    let lab = lab();
    part(move || {
        lab.kept.with(|kept| *kept == Kept::Refused).then(|| {
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
