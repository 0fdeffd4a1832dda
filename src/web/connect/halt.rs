//! The robot's stop in the other rooms: it stands beside their transport while the robot drives.

use crate::web::erase::mouse;
use leptos::prelude::*;
use wasm_bindgen::JsCast;

use super::wire::Wire;
use crate::link::page::Command;
use crate::web::icons;
use crate::web::state::Lab;

const ID: &str = "stop-robot";

/// The button.
pub(super) fn button(lab: Lab) -> AnyView {
    on_cleanup(hand_on_focus);
    view! {
        <button class="btn stop" id=ID aria-label="Stop the robot" title="Stop the robot at once" on:click=mouse(move |_| {
            if let Some(wire) = Wire::of(lab) {
                wire.command(Command::Stop);
            }
        })>
            {icons::halt()}"Stop"
        </button>
    }
    .into_any()
}

/// The button goes once the robot stands: who has just pressed it by key goes on at its neighbour.
fn hand_on_focus() {
    let focused = document().active_element().is_some_and(|element| element.id() == ID);
    let neighbour = document().query_selector(".transport .play").ok().flatten();
    if let Some(play) = neighbour.filter(|_| focused) {
        let _ = play.unchecked_into::<web_sys::HtmlElement>().focus();
    }
}
