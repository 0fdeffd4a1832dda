//! The app: what is open at the beginning, what the browser keeps, and the rooms.

use crate::web::erase::{mouse, part, sig};
use leptos::prelude::*;
use wasm_bindgen::JsCast;
use wasm_bindgen::prelude::*;

use super::header::Header;
use super::keeping::{self, Kept};
use super::state::{Lab, Room};
use super::step::StepRoom;
use super::{
    aloud, bench, browser, clock, compare, connect, dialogs, draw, focus, keys, lazy, opening, others,
    projector, rooms, storage,
};
use crate::maze::samples;
use crate::playback::Motion;

/// The whole page.
#[component]
pub fn App() -> impl IntoView {
    let (own, known) = keeping::last();
    let own = own.unwrap_or_else(samples::figure_3_1);
    let motion = if browser::reduced_motion() { Motion::Reduced } else { Motion::Smooth };
    let lab = Lab::new(own, storage::settings(), storage::explorer(), motion);
    lab.known.set_value(known);
    provide_context(lab);
    rooms::listen(lab);
    keeping::listen(lab);
    show_theme(lab);
    clock::run_clock(lab);
    focus::watch();
    keys::listen(lab);
    opening::listen(lab);
    listen_for_updates(lab);
    let book = Memo::new(move |_| lab.by_the_book());
    view! {
        {part(move || lab.halt.get().map(|halt| halt(lab)))}
        <div class="app" class:projecting=sig(move || lab.projector.get())>
            <a class="vh skip" href="#main" on:click=mouse(move |event| { event.prevent_default(); browser::focus("main"); })>"Skip to the maze"</a>
            <Header />
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
        <aloud::Aloud />
        <dialogs::Dialogs />
        <dialogs::Toasts />
    }
}

/// Sets the theme on the root element, and follows the system where that is chosen.
fn show_theme(lab: Lab) {
    const DARK: &str = "(prefers-color-scheme: dark)";
    let show = move || {
        let dark = match lab.theme.get_untracked() {
            storage::Theme::System => browser::media(DARK),
            storage::Theme::Light => false,
            storage::Theme::Dark => true,
        };
        if let Some(root) = document().document_element() {
            let _ = root.set_attribute("data-theme", if dark { "dark" } else { "light" });
        }
    };
    Effect::new(move |_| {
        storage::keep_theme(lab.theme.get());
        show();
    });
    if let Ok(Some(system)) = window().match_media(DARK) {
        let changed = Closure::<dyn FnMut()>::new(show);
        let _ = system.add_event_listener_with_callback("change", changed.as_ref().unchecked_ref());
        // The app lives as long as the page.
        changed.forget();
    }
}

/// Says when a new version of the page waits.
fn listen_for_updates(lab: Lab) {
    use super::state::{Toast, ToastAction, ToastTone};
    let waiting = window_event_listener_untyped("linemaze:update-ready", move |_| {
        let toast = Toast {
            title: "A new version is here".into(),
            text: if lab.kept.with_untracked(|kept| *kept == Kept::Here) {
                "Your maze stays as it is.".into()
            } else {
                "This browser does not keep your maze: save it as a file first (Ctrl S).".into()
            },
            tone: ToastTone::Info,
            action: Some(ToastAction::Update),
        };
        lab.toast.set(Some(toast));
    });
    on_cleanup(move || waiting.remove());
}
