//! The keyboard in the Draw room: a cursor on the lattice, and keys for the tools.

use leptos::prelude::*;
use web_sys::KeyboardEvent;

use super::desk::Desk;
use crate::geometry::{Heading, Point};
use crate::gesture::Tool;
use crate::maze::Kind;
use crate::maze::edit::Edit;
use crate::web::keys;

/// A key while the drawing has the focus.
pub fn on_canvas(desk: Desk, event: &KeyboardEvent) {
    if event.ctrl_key() || event.meta_key() {
        return;
    }
    let key = event.key();
    if let Some(heading) = arrow(&key) {
        event.prevent_default();
        return go(desk, heading, event);
    }
    if event.alt_key() {
        return;
    }
    if press(desk, &key) {
        event.prevent_default();
    }
}

fn arrow(key: &str) -> Option<Heading> {
    Some(match key {
        "ArrowUp" => Heading::North,
        "ArrowRight" => Heading::East,
        "ArrowDown" => Heading::South,
        "ArrowLeft" => Heading::West,
        _ => return None,
    })
}

/// Goes to the next point; with Shift drawing, with Alt erasing. Among walls Alt opens the one on the way, and
/// Shift builds one there and stays.
fn go(desk: Desk, heading: Heading, event: &KeyboardEvent) {
    // The first arrow only shows where the cursor is.
    let shown = desk.by_keyboard.get_untracked();
    desk.by_keyboard.set(true);
    let at = desk.cursor.get_untracked();
    let to = desk.with_maze(|maze| maze.bounds().clamp(at.step(heading)));
    let cells = vec![(at, heading)];
    let builds = desk.with_maze(|maze| maze.kind == Kind::Wall);
    if event.shift_key() || event.alt_key() {
        let draws = event.shift_key() != builds;
        desk.lab.edit(if draws { Edit::Draw(cells) } else { Edit::Erase(cells) });
    }
    let stays = if builds { event.shift_key() } else { false };
    if stays || !(shown || event.shift_key() || event.alt_key()) {
        return desk.camera.show(at);
    }
    desk.cursor.set(to);
    desk.camera.show(to);
}

/// The cursor's keys; start and finish go to the cursor only while it is shown.
fn press(desk: Desk, key: &str) -> bool {
    let at = desk.cursor.get_untracked();
    if desk.by_keyboard.get_untracked() {
        match key {
            "s" | "S" => desk.put_start(at),
            "f" | "F" => desk.put_finish(at),
            "Delete" | "Backspace" => erase_at(desk, at),
            _ => return in_room(desk, key),
        }
        return true;
    }
    in_room(desk, key)
}

fn erase_at(desk: Desk, at: Point) {
    let edit = desk.with_maze(|maze| match maze.kind {
        Kind::Line => Edit::Erase(maze.ways(at).iter().map(|heading| (at, heading)).collect()),
        Kind::Wall => Edit::Draw(Heading::ALL.map(|heading| (at, heading)).to_vec()),
    });
    desk.lab.edit(edit);
}

/// Keys that count anywhere in the room.
fn in_room(desk: Desk, key: &str) -> bool {
    match key {
        "l" | "L" | "w" | "W" => desk.take(Tool::Line),
        "e" | "E" => desk.take(Tool::Erase),
        "s" | "S" => desk.take(Tool::Start),
        "f" | "F" => desk.take(Tool::Finish),
        "m" | "M" => desk.take(Tool::Move),
        "t" | "T" => desk.turn_start(),
        "+" | "=" => desk.camera.zoom(1.25, None),
        "-" | "−" => desk.camera.zoom(0.8, None),
        "0" => desk.camera.fit(),
        "Escape" => return escape(desk),
        " " => desk.holds_space.set(true),
        _ => return false,
    }
    true
}

/// Lets go of the line, or closes what is open.
fn escape(desk: Desk) -> bool {
    if desk.hand.try_update(crate::gesture::Hand::let_go) == Some(true) {
        return true;
    }
    if desk.generating.get_untracked() {
        desk.generating.set(false);
        crate::web::browser::focus("generate");
        return true;
    }
    desk.hide_shown()
}

/// Listens while the room is open.
pub fn listen(desk: Desk) {
    keys::hear(desk.lab, move |key, _| in_room(desk, key));
    let up = window_event_listener(leptos::ev::keyup, move |event| {
        if event.key() == " " {
            desk.holds_space.set(false);
        }
    });
    let blur = window_event_listener(leptos::ev::blur, move |_| desk.holds_space.set(false));
    on_cleanup(move || {
        up.remove();
        blur.remove();
    });
}
