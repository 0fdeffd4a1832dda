//! The robot's stop, in every room: a bar above the page while the robot drives or may be driving, first in the
//! order of Tab; and the key that works wherever the focus is, over dialogs too.

use crate::web::erase::{mouse, part, sig};
use leptos::prelude::*;
use wasm_bindgen::prelude::*;

use super::wire::Wire;
use crate::link::page::{Command, Link, State};
use crate::web::icons;
use crate::web::state::Lab;

/// The bar.
pub(super) fn bar(lab: Lab) -> AnyView {
    let state = Memo::new(move |_| Wire::of(lab).map(|wire| wire.look(Link::state)));
    let alarm = move || match state.get() {
        Some(State::Alarm(alarm)) => Some(alarm),
        Some(_) | None => None,
    };
    view! {
        <div class="halt-bar" class:alarm=sig(move || alarm().is_some()) role="group" aria-label="Robot’s stop">
            <button class="btn stop" id="stop-robot" aria-label="Stop the robot" title="Stop the robot at once" aria-keyshortcuts="Control+." on:click=mouse(move |_| {
                if let Some(wire) = Wire::of(lab) {
                    wire.command(Command::Stop);
                }
            })>
                {icons::halt()}"Stop"<kbd>"Ctrl ."</kbd>
            </button>
            {part(move || match alarm() {
                Some(alarm) => view! { <p role="alert" id="alarm"><b>{alarm.says()}</b>" "{alarm.cure()}</p> }.into_any(),
                None => view! { <p>{state.get().map(State::says)}</p> }.into_any(),
            })}
        </div>
    }
    .into_any()
}

/// Listens as long as the page lives; before everything else that hears keys.
pub(super) fn listen(wire: Wire) {
    let pressed = Closure::<dyn FnMut(web_sys::KeyboardEvent)>::new(move |event: web_sys::KeyboardEvent| {
        let ours = (event.ctrl_key() || event.meta_key()) && event.key() == ".";
        if ours && wire.peek(Link::may_drive) {
            event.prevent_default();
            event.stop_propagation();
            wire.command(Command::Stop);
        }
    });
    let handler = pressed.as_ref().unchecked_ref();
    let _ = window().add_event_listener_with_callback_and_bool("keydown", handler, true);
    pressed.forget();
}
