//! Time for what moves: one animation frame after the other while something does, none otherwise.

use std::cell::Cell;
use std::rc::Rc;

use leptos::prelude::*;

use super::browser;
use super::state::Lab;
use crate::playback::Playback;

/// Ticks the lab while a run is moving.
pub fn run_clock(lab: Lab) {
    let moving = Memo::new(move |_| lab.playing().with(Playback::is_moving));
    let ticking = Rc::new(Cell::new(false));
    Effect::new(move |_| {
        if moving.get() && !ticking.replace(true) {
            next_frame(lab, moving, Rc::clone(&ticking), browser::now_s());
        }
    });
}

fn next_frame(lab: Lab, moving: Memo<bool>, ticking: Rc<Cell<bool>>, before_s: f64) {
    request_animation_frame(move || {
        let now_s = browser::now_s();
        lab.tick(now_s - before_s);
        if moving.try_get_untracked() == Some(true) {
            next_frame(lab, moving, ticking, now_s);
        } else {
            ticking.set(false);
        }
    });
}
