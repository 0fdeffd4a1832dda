//! The room's keys: those of the stepper, for all runs at once.

use leptos::prelude::*;

use super::desk::{Desk, Page, Towards};
use crate::web::keys::{is_typing, is_used_there};

/// Listens while the room is open.
pub fn listen(desk: Desk) {
    let handle = window_event_listener(leptos::ev::keydown, move |event| {
        let held = event.ctrl_key() || event.meta_key() || event.alt_key();
        let elsewhere = desk.lab.dialog.with_untracked(Option::is_some) || desk.lab.projector.get_untracked();
        if held
            || elsewhere
            || event.default_prevented()
            || is_typing(event.target())
            || is_used_there(&event)
        {
            return;
        }
        if desk.page.get_untracked() == Page::Maze && press(desk, &event.key()) {
            event.prevent_default();
        }
    });
    on_cleanup(move || handle.remove());
}

fn press(desk: Desk, key: &str) -> bool {
    match key {
        " " => desk.toggle(),
        "ArrowRight" | "PageDown" => desk.step(Towards::End),
        "ArrowLeft" | "PageUp" => desk.step(Towards::Start),
        "Home" => desk.seek(0.0),
        "End" => desk.seek(f64::INFINITY),
        "n" | "N" => desk.next_fork(),
        _ => return false,
    }
    true
}
