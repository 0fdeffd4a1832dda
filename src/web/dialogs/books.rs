//! What can be read: all keys.

use leptos::prelude::*;

use super::Modal;
use crate::web::erase::{event, part, sig};
use crate::web::keys::{HELP, IN_DRAWING, is_single};
use crate::web::state::lab;

/// All keys, and the switch for those that are only a letter, a digit or a mark.
#[component]
pub fn Keys() -> impl IntoView {
    let lab = lab();
    let off = move || !lab.letters.get();
    let row = move |group: &'static str, (keys, what): (&'static str, &'static str)| {
        let names = keys.split(' ').map(|key| view! { <kbd>{key}</kbd>" " }).collect_view();
        let single =
            group != IN_DRAWING && keys.split(' ').all(|key| is_single(key) && !"←→↑↓".contains(key));
        view! {
            <dd class:off=sig(move || single && off())>
                <span>{names}</span>
                <span>{what}{part(move || (single && off()).then_some(view! { <b>" (off)"</b> }))}</span>
            </dd>
        }
    };
    view! {
        <Modal title="Keys">
            <div class="keycols" data-first tabindex="-1">
                {HELP.iter().map(|(group, keys)| view! {
                    <dl>
                        <dt>{*group}</dt>
                        {keys.iter().map(|&keys| row(group, keys)).collect_view()}
                    </dl>
                }).collect_view()}
            </div>
            <label class="switch">
                <input type="checkbox" id="letters" prop:checked=sig(move || lab.letters.get())
                    on:change=event(move |event| lab.letters.set(event_target_checked(&event))) />
                "Keys that are only a letter, a digit or a mark"
            </label>
            <p class="small" id="letters-told">{part(move || if off() {
                "They are off, on this device: nothing happens when you speak, or hit them by accident. All they do can be done with buttons; in the drawing they count while it has the focus."
            } else {
                "Switch them off where you speak to the computer, or hit keys by accident. Arrows, Space, Esc, and keys with Ctrl or Alt stay."
            })}</p>
        </Modal>
    }
}
