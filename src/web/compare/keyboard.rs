//! The room's keys: those of the stepper, for all runs at once.

use leptos::prelude::*;

use super::desk::{Desk, Page, Towards};
use crate::web::keys;

/// Listens while the room is open.
pub fn listen(desk: Desk) {
    keys::hear(desk.lab, move |key, _| {
        desk.page.get_untracked() == Page::Maze && !desk.lab.projector.get_untracked() && press(desk, key)
    });
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
