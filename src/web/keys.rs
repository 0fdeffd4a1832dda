//! The keyboard: everything that the page does can be done with it. [`HELP`] is what `?` shows.

use std::cell::Cell;

use leptos::prelude::*;
use wasm_bindgen::JsCast;
use web_sys::{Element, EventTarget, HtmlElement, KeyboardEvent};

use super::rooms::go;
use super::state::{Dialog, Lab, Place, Room};
use super::step::transport::seek_event;
use super::{focus, past};
use crate::playback::{Command, Unit};

/// The group of keys that count while the drawing has the focus, also when single keys are off.
pub const IN_DRAWING: &str = "Draw (in the drawing)";

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
        IN_DRAWING,
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

/// Whether the keys go into a field for text.
#[must_use]
pub fn is_typing(target: Option<EventTarget>) -> bool {
    target.and_then(|target| target.dyn_into::<HtmlElement>().ok()).is_some_and(|element| {
        let typed = element.dyn_ref::<web_sys::HtmlInputElement>().is_some_and(|input| {
            !matches!(input.type_().as_str(), "checkbox" | "radio" | "range" | "button" | "file")
        });
        typed || element.tag_name() == "TEXTAREA" || element.is_content_editable()
    })
}

/// Whether the focused element uses this key itself. A presenter's remote steps whatever button or list was clicked
/// before; who came there by keys presses the button and chooses from the list.
fn is_used_there(key: &str, event: &KeyboardEvent) -> bool {
    let Some(element) = event.target().and_then(|target| target.dyn_into::<Element>().ok()) else {
        return false;
    };
    let is = |css: &str| element.matches(css).unwrap_or(false);
    let by_keys = focus::by_keys();
    let arrow = key.starts_with("Arrow");
    let far = matches!(key, "Home" | "End");
    if is("select") {
        // A browser that can't tell whether the list is open keeps all its keys.
        let open = element.matches(":open").unwrap_or(true);
        return open || is_single(key) || by_keys && (arrow || far || key == " ");
    }
    if is("input[type=range]") {
        return arrow || far || key.starts_with("Page");
    }
    if is("[role=menuitem]") || is("input[type=radio]") && arrow {
        return true;
    }
    if is("button, summary, input") {
        return key == "Enter" || by_keys && key == " ";
    }
    // What scrolls has its arrows.
    is("[tabindex='0']:not([role=slider])") && by_keys && (far || matches!(key, "ArrowUp" | "ArrowDown"))
}

/// A letter, a digit or a mark. Such keys can be switched off: who dictates to the computer, or hits keys by accident,
/// would set off all kinds of things (WCAG 2.1.4).
#[must_use]
pub fn is_single(key: &str) -> bool {
    let mut characters = key.chars();
    characters.next().is_some_and(|first| first != ' ') && characters.next().is_none()
}

thread_local! {
    /// Whether the page took the space bar when it went down: its way up must press no button then.
    static TOOK_SPACE: Cell<bool> = const { Cell::new(false) };
}

/// Hears the page's plain keys as long as what asks is shown; `press` says whether a key was its own. None is heard
/// that belongs to what has the focus, to a dialog, or to the browser.
pub fn hear(lab: Lab, press: impl Fn(&str, &KeyboardEvent) -> bool + 'static) {
    let handle = window_event_listener(leptos::ev::keydown, move |event| {
        let key = event.key();
        let held = event.ctrl_key() || event.meta_key() || event.alt_key();
        let off = is_single(&key) && !lab.letters.get_untracked();
        if held || off || is_elsewhere(lab, &event) || is_used_there(&key, &event) {
            return;
        }
        if press(&key, &event) {
            event.prevent_default();
            TOOK_SPACE.set(key == " ");
        }
    });
    on_cleanup(move || handle.remove());
}

/// Whether a key goes to somebody else: a dialog, a field, what heard it first.
fn is_elsewhere(lab: Lab, event: &KeyboardEvent) -> bool {
    let popover = || {
        let element = event.target().and_then(|target| target.dyn_into::<Element>().ok());
        element.is_some_and(|element| element.closest("[role=dialog]").ok().flatten().is_some())
    };
    event.default_prevented()
        || lab.dialog.with_untracked(Option::is_some)
        || is_typing(event.target())
        || event.key() != "Escape" && popover()
}

/// Listens as long as the page lives.
pub fn listen(lab: Lab) {
    let held = window_event_listener(leptos::ev::keydown, move |event| {
        TOOK_SPACE.set(false);
        let key = event.key();
        if key == "Escape" && lab.dialog.with_untracked(Option::is_some) && !is_dialog_open() {
            // It could not be loaded.
            return lab.dialog.set(None);
        }
        if !is_elsewhere(lab, &event) && with_modifier(lab, &key, &event) {
            event.prevent_default();
        }
    });
    let up = window_event_listener(leptos::ev::keyup, |event| {
        if event.key() == " " && TOOK_SPACE.take() {
            event.prevent_default();
        }
    });
    on_cleanup(move || {
        held.remove();
        up.remove();
    });
    hear(lab, move |key, event| {
        everywhere(lab, key)
            || (matches!(lab.room.get_untracked(), Room::Step | Room::Connect)
                && untrack(|| lab.shown(|_| ()).is_some())
                && step(lab, key, event))
    });
}

fn is_dialog_open() -> bool {
    document().query_selector("dialog[open]").ok().flatten().is_some()
}

/// Keys with Ctrl or Alt; whether it was one of ours.
fn with_modifier(lab: Lab, key: &str, event: &KeyboardEvent) -> bool {
    if event.ctrl_key() || event.meta_key() {
        return with_control(lab, &key.to_ascii_lowercase(), event.shift_key());
    }
    let new = event.alt_key() && key.eq_ignore_ascii_case("n");
    if new {
        lab.dialog.set(Some(Dialog::New));
    }
    new
}

fn with_control(lab: Lab, key: &str, shift: bool) -> bool {
    match (key, shift) {
        ("z", false) => past::undo(lab),
        ("z", true) | ("y", false) => past::redo(lab),
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
        "p" | "P" => lab.go(if lab.projector.get_untracked() { Place::Step } else { Place::Projector }),
        "Escape" if lab.toast.with_untracked(Option::is_some) => lab.toast.set(None),
        "Escape" if lab.projector.get_untracked() => lab.go(Place::Step),
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
        "n" | "N" => {
            let towards = if event.shift_key() { Command::PreviousEvent } else { Command::NextEvent };
            seek_event(lab, towards(None));
            return true;
        }
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
