//! Where somebody is on the page: the address and the document's title tell it, the browser's *Back* leads to the
//! place before, screen readers hear it, and the keyboard begins there.
//!
//! While a maze of a link is open, the address stays the link, so that loading it again shows that maze; the
//! history's entry remembers the place.

use std::time::Duration;

use leptos::prelude::*;

use super::state::{Lab, Place, Room};
use super::{browser, focus, opening};

/// The part of the address that holds a maze.
pub const LINK: &str = "m=";

/// Opens a room, at the page where it was left.
pub fn go(lab: Lab, room: Room) {
    lab.go(match room {
        Room::Draw => Place::Draw,
        Room::Step => Place::Step,
        Room::Compare if lab.league.get_untracked() => Place::League,
        Room::Compare => Place::Compare,
        Room::Connect => Place::Connect,
        Room::Bench => Place::Bench,
    });
}

/// Opens what the address names, tells changes of place, and follows the browser's *Back* and *Forward*.
pub fn listen(lab: Lab) {
    follow(lab);
    let place = Memo::new(move |_| lab.place());
    Effect::new(move |before: Option<Place>| {
        let place = place.get();
        document().set_title(&format!("{} · Line Maze Lab", place.name()));
        if before.is_some_and(|before| before != place) {
            lab.done.set(place.name().to_owned());
            focus::enter(if place == Place::League { Place::Compare.name() } else { place.name() });
        }
        if before.is_some() && named() != Some(place) {
            browser::push_entry(&address(lab, place), place.hash());
        }
        place
    });
    // A little later: the browser itself still looks for what the address may name, and takes the focus away. Some
    // browsers tell one of these, some both, for an address that was typed.
    let later = move || set_timeout(move || follow(lab), Duration::ZERO);
    let back = window_event_listener(leptos::ev::popstate, move |_| later());
    let typed = window_event_listener(leptos::ev::hashchange, move |_| later());
    on_cleanup(move || {
        back.remove();
        typed.remove();
    });
}

/// What is open is the user's own from now on: the address no longer holds it.
pub fn forget_link(lab: Lab) {
    if browser::hash().starts_with(LINK) {
        let place = untrack(|| lab.place());
        browser::replace_entry(place.hash(), place.hash());
    }
}

/// The address of a place: the link, while one is open.
fn address(lab: Lab, place: Place) -> String {
    let hash = browser::hash();
    if lab.borrowed.get_untracked() && hash.starts_with(LINK) { hash } else { place.hash().to_owned() }
}

/// The place that the browser's history or the address names.
fn named() -> Option<Place> {
    let hash = browser::hash();
    let remembered = browser::remembered().and_then(|name| Place::of_hash(&name));
    match hash.starts_with(LINK) {
        true => Some(remembered.unwrap_or(Place::Step)),
        false => Place::of_hash(&hash),
    }
}

fn follow(lab: Lab) {
    let hash = browser::hash();
    let Some(place) = named() else { return };
    match hash.strip_prefix(LINK) {
        Some(payload) if !opening::is_open(lab, payload) => opening::open_link(lab, payload, place),
        _ => lab.go(place),
    }
}
