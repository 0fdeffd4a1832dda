//! The keyboard: everything that the page does can be done with it. [`HELP`] is what `?` shows.

use leptos::prelude::*;
use wasm_bindgen::JsCast;
use web_sys::{EventTarget, HtmlElement, KeyboardEvent};

use super::app::go;
use super::state::{Dialog, Lab, Room};
use crate::playback::{Command, Unit};

/// Keys and what they do, in groups.
pub const HELP: &[(&str, &[(&str, &str)])] = &[
    (
        "Step",
        &[
            ("Space", "play, pause"),
            ("← →", "one step: a stop, or a line"),
            ("↑ ↓", "one line of the algorithm"),
            ("Home End", "start, end"),
            ("N", "next event; Shift N the one before"),
            ("PgUp PgDn", "presenter remote: back, on"),
            ("V", "robot’s-eye view"),
            ("O", "explorer and settings"),
            ("T", "turn-list lab"),
        ],
    ),
    (
        "Draw (in the drawing)",
        &[
            ("arrows", "go from point to point"),
            ("Shift arrows", "draw; build a wall"),
            ("Alt arrows", "erase; open a wall"),
            ("S F", "start, finish here"),
            ("T", "turn the start"),
            ("L E M", "line or wall, erase or open, move the paper"),
            ("+ − 0", "zoom in, out, fit"),
            ("Esc", "let go of the line"),
        ],
    ),
    (
        "Everywhere",
        &[
            ("Ctrl Z", "undo; Ctrl Shift Z or Ctrl Y redo"),
            ("Ctrl S", "save the maze as a file"),
            ("Ctrl O", "open a file"),
            ("Ctrl V", "paste a maze or a link"),
            ("Alt N", "new maze"),
            ("1 2 3 4", "Draw, Step, Compare, Connect"),
            ("P", "projector"),
            ("Ctrl .", "stop the robot, whatever has the focus"),
            ("G", "glossary"),
            ("?", "these keys"),
            ("Esc", "close"),
        ],
    ),
];

/// Whether the keys go into a field.
#[must_use]
pub fn is_typing(target: Option<EventTarget>) -> bool {
    target.and_then(|target| target.dyn_into::<HtmlElement>().ok()).is_some_and(|element| {
        let typed = element.dyn_ref::<web_sys::HtmlInputElement>().is_some_and(|input| {
            !matches!(input.type_().as_str(), "checkbox" | "radio" | "range" | "button" | "file")
        });
        typed || matches!(element.tag_name().as_str(), "TEXTAREA" | "SELECT") || element.is_content_editable()
    })
}

/// Whether the focused element uses this key itself: buttons and links their Space and Enter, scrolling
/// places and range inputs their arrows.
#[must_use]
pub fn is_used_there(event: &KeyboardEvent) -> bool {
    let Some(element) = event.target().and_then(|target| target.dyn_into::<HtmlElement>().ok()) else {
        return false;
    };
    let tag = element.tag_name();
    match event.key().as_str() {
        " " | "Enter" => matches!(tag.as_str(), "BUTTON" | "A" | "SUMMARY"),
        "ArrowUp" | "ArrowDown" | "PageUp" | "PageDown" | "Home" | "End" => {
            element.class_list().contains("code") || element.class_list().contains("scroll") || tag == "INPUT"
        }
        "ArrowLeft" | "ArrowRight" => tag == "INPUT",
        _ => false,
    }
}

/// Listens as long as the page lives.
pub fn listen(lab: Lab) {
    let handle = window_event_listener(leptos::ev::keydown, move |event| {
        if event.default_prevented()
            || is_typing(event.target())
            || lab.dialog.with_untracked(Option::is_some)
        {
            return;
        }
        if press(lab, &event) {
            event.prevent_default();
        }
    });
    on_cleanup(move || handle.remove());
}

/// Does what the key says; whether it was one of ours.
fn press(lab: Lab, event: &KeyboardEvent) -> bool {
    let key = event.key();
    if event.ctrl_key() || event.meta_key() {
        return with_control(lab, &key.to_ascii_lowercase(), event.shift_key());
    }
    if event.alt_key() {
        let new = key.eq_ignore_ascii_case("n");
        if new {
            lab.dialog.set(Some(Dialog::New));
        }
        return new;
    }
    if is_used_there(event) {
        return false;
    }
    everywhere(lab, &key)
        || (matches!(lab.room.get_untracked(), Room::Step | Room::Connect)
            && untrack(|| lab.shown(|_| ()).is_some())
            && step(lab, &key, event))
}

fn with_control(lab: Lab, key: &str, shift: bool) -> bool {
    match (key, shift) {
        ("z", false) => lab.undo(),
        ("z", true) | ("y", false) => lab.redo(),
        ("s", false) => super::draw::save(lab),
        ("o", false) => super::opening::choose_file(lab),
        _ => return false,
    }
    true
}

fn everywhere(lab: Lab, key: &str) -> bool {
    match key {
        "?" => lab.dialog.set(Some(Dialog::Keys)),
        "g" | "G" => lab.dialog.set(Some(Dialog::Glossary(None))),
        "o" | "O" => lab.dialog.set(Some(Dialog::Settings)),
        "1" => go(lab, Room::Draw),
        "2" => go(lab, Room::Step),
        "3" => go(lab, Room::Compare),
        "4" => go(lab, Room::Connect),
        "p" | "P" => {
            lab.room.set(Room::Step);
            lab.projector.update(|on| *on = !*on);
        }
        "Escape" if lab.toast.with_untracked(Option::is_some) => lab.toast.set(None),
        "Escape" if lab.projector.get_untracked() => lab.projector.set(false),
        _ => return false,
    }
    true
}

fn step(lab: Lab, key: &str, event: &KeyboardEvent) -> bool {
    let command = match key {
        " " => Command::Toggle,
        "ArrowRight" => Command::Forward,
        "ArrowLeft" => Command::Back,
        "ArrowDown" => Command::ForwardBy(Unit::Line),
        "ArrowUp" => Command::BackBy(Unit::Line),
        "PageDown" => Command::ForwardBy(Unit::Stop),
        "PageUp" => Command::BackBy(Unit::Stop),
        "Home" => Command::ToStart,
        "End" => Command::ToEnd,
        "n" | "N" if event.shift_key() => Command::PreviousEvent(None),
        "n" | "N" => Command::NextEvent(None),
        "t" | "T" => {
            lab.dialog.set(Some(Dialog::TurnList));
            return true;
        }
        "v" | "V" => {
            lab.robots_eye.update(|on| *on = !*on);
            return true;
        }
        _ => return false,
    };
    lab.play(command);
    true
}
