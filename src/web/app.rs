//! The app: what is open at the beginning, what the browser keeps, and the rooms.

use crate::web::erase::{mouse, part, sig};
use leptos::prelude::*;

use super::header::Header;
use super::state::{Lab, Room};
use super::step::StepRoom;
use super::{
    bench, browser, clock, compare, connect, dialogs, draw, keys, lazy, opening, others, projector, storage,
};
use crate::maze::samples;
use crate::playback::Motion;

/// The part of the address that holds a maze.
pub const LINK: &str = "m=";

/// The whole page.
#[component]
pub fn App() -> impl IntoView {
    let own = storage::maze().unwrap_or_else(samples::figure_3_1);
    let lab = Lab::new(own, storage::settings(), storage::explorer());
    provide_context(lab);
    follow_address(lab, browser::hash().as_str());
    keep(lab);
    show_theme(lab);
    follow_motion(lab);
    dialogs::end_toasts(lab);
    clock::run_clock(lab);
    keys::listen(lab);
    opening::listen(lab);
    listen_for_updates(lab);
    let on_hash =
        window_event_listener(leptos::ev::hashchange, move |_| follow_address(lab, browser::hash().as_str()));
    on_cleanup(move || on_hash.remove());
    let book = Memo::new(move |_| lab.by_the_book());
    view! {
        {part(move || lab.halt.get().map(|halt| halt(lab)))}
        <div class="app" class:projecting=sig(move || lab.projector.get())>
            <a class="vh skip" href="#main" on:click=mouse(move |event| { event.prevent_default(); browser::focus("main"); })>"Skip to the maze"</a>
            <div class="head">
                <Header />
                {part(move || lab.dialog.get().is_none().then(|| view! { <dialogs::Toasts /> }))}
            </div>
            {part(move || match (lab.projector.get(), lab.room.get()) {
                _ if lab.link_coming.get() => lazy::arriving(),
                (false, Room::Draw) => lazy::view(draw::room),
                (false, Room::Connect) => lazy::view(connect::room),
                (true, _) if !book.get() => lazy::view(others::projector),
                (false, Room::Step) if !book.get() => lazy::view(others::room),
                (true, _) => lazy::view(projector::room),
                (false, Room::Step) => view! { <StepRoom /> }.into_any(),
                (false, Room::Compare) => lazy::view(compare::room),
                (false, Room::Bench) => lazy::view(bench::room),
            })}
        </div>
        <dialogs::Dialogs />
    }
}

/// Opens a room, and says so in the address: the browser's *Back* leads to the room before.
pub fn go(lab: Lab, room: Room) {
    lab.projector.set(false);
    let other = lab.room.get_untracked() != room;
    lab.room.set(room);
    // A borrowed maze stays in the address, so that reloading shows it again.
    if other && !lab.borrowed.get_untracked() {
        browser::push_hash(room.hash());
    }
}

/// Opens what the address names: a room, or the maze of a link.
fn follow_address(lab: Lab, hash: &str) {
    if let Some(payload) = hash.strip_prefix(LINK) {
        opening::open_link(lab, payload);
    } else if let Some(room) = Room::of_hash(hash) {
        lab.projector.set(false);
        lab.room.set(room);
    }
}

/// Keeps maze and settings as they change.
fn keep(lab: Lab) {
    Effect::new(move |before: Option<()>| {
        let maze = lab.maze.get();
        if !lab.borrowed.get() {
            lab.not_kept.set(storage::keep_maze(&maze).is_err());
            // A maze of one's own is not in the address.
            if before.is_some() && browser::hash().starts_with(LINK) {
                browser::replace_hash(lab.room.get_untracked().hash());
            }
        }
    });
    Effect::new(move |_| {
        lab.settings.with(|settings| {
            if !lab.borrowed.get() {
                storage::keep_settings(settings, lab.explorer.get());
            }
        });
    });
}

/// Sets the theme on the root element, and follows the system where that is chosen.
fn show_theme(lab: Lab) {
    let system = browser::media("(prefers-color-scheme: dark)");
    Effect::new(move |_| storage::keep_theme(lab.theme.get()));
    Effect::new(move |_| {
        let dark = match lab.theme.get() {
            storage::Theme::System => system.get(),
            storage::Theme::Light => false,
            storage::Theme::Dark => true,
        };
        if let Some(root) = document().document_element() {
            let _ = root.set_attribute("data-theme", if dark { "dark" } else { "light" });
        }
    });
}

/// Whether the bot is seen to drive, as the system wants it.
fn follow_motion(lab: Lab) {
    let less = browser::media("(prefers-reduced-motion: reduce)");
    Effect::new(move |_| lab.set_motion(if less.get() { Motion::Reduced } else { Motion::Smooth }));
}

/// Says when a new version of the page waits.
fn listen_for_updates(lab: Lab) {
    use super::state::{Toast, ToastAction, ToastTone};
    let waiting = window_event_listener_untyped("linemaze:update-ready", move |_| {
        let text = "Your maze stays as it is.";
        lab.tell(Toast::new(ToastTone::Info, "A new version is here", text).with(ToastAction::Update));
    });
    on_cleanup(move || waiting.remove());
}
