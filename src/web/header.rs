//! The head of the page: rooms, and what concerns all of them.

use crate::web::erase::{mouse, part, sig};
use leptos::prelude::*;

use super::icons;
use super::state::{Dialog, Place, Room, lab};
use super::storage::Theme;
use crate::explorer::name::Name;
use crate::settings::Order;

/// The head.
#[component]
pub fn Header() -> impl IntoView {
    let lab = lab();
    let room = move |room: Room, name: &'static str, hash: &'static str| {
        let here = move || (lab.room.get() == room).then_some("page");
        view! {
            <a href=hash aria-current=here on:click=mouse(move |event| { event.prevent_default(); super::rooms::go(lab, room); })>{name}</a>
        }
    };
    view! {
        <header class="top">
            <div class="brand">
                <svg viewBox="0 0 26 26" fill="none" stroke="currentColor" stroke-width="3.2" stroke-linecap="round" stroke-linejoin="round" aria-hidden="true">
                    <path d="M4 23V4h12v9H10v10" />
                    <circle cx="21" cy="20" r="2.6" fill="var(--bot)" stroke="none" />
                </svg>
                <span>"Line Maze Lab"</span>
            </div>
            <nav aria-label="Rooms">
                {room(Room::Draw, "Draw", "#draw")}
                {room(Room::Step, "Step", "#step")}
                {room(Room::Compare, "Compare", "#compare")}
                {room(Room::Connect, "Connect", "#connect")}
            </nav>
            <div class="spacer"></div>
            <div class="tools-right">
                <OrderButton />
                <button class="btn icon hide-s" aria-label="Projector (P)" title="Projector: large type (P)" on:click=mouse(move |_| lab.go(Place::Projector))>
                    {icons::screen()}
                </button>
                <button class="btn" aria-label="Share" title="A link and a QR code of this maze" on:click=mouse(move |_| lab.dialog.set(Some(Dialog::Share)))>
                    {icons::share()}<span class="hide-l">"Share"</span>
                </button>
                <button class="btn icon" aria-label="Keys (?)" title="All keys (?)" on:click=mouse(move |_| lab.dialog.set(Some(Dialog::Keys)))>{icons::keyboard()}</button>
                <ThemeButton />
            </div>
        </header>
    }
}

/// Who drives, and its preference order; opens explorer and settings.
#[component]
fn OrderButton() -> impl IntoView {
    let lab = lab();
    let order = move || match lab.settings.with(|settings| settings.order) {
        _ if !lab.by_the_book() => lab.shown(|run| run.title()).unwrap_or("Explorer").to_owned(),
        Order::Fixed(preference) => preference.turns().map(|turn| turn.letter().to_string()).join(" → "),
        Order::Random(seed) => format!("random {seed}"),
    };
    // What is set otherwise than usual and changes the run: the first of it here, all of it in the name.
    let off = move || {
        let explorer = if lab.by_the_book() { Name::Book } else { lab.explorer.get() };
        lab.settings.with(|settings| explorer.off_defaults(settings))
    };
    let named = move || {
        let off = off();
        let book = if lab.by_the_book() { "Book · " } else { "" };
        format!(
            "Settings of the run: {book}{}{}",
            order(),
            off.iter().map(|off| format!(" · {off}")).collect::<String>()
        )
    };
    let briefly = move || match off().as_slice() {
        [] => String::new(),
        [one] => format!(" · {one}"),
        [first, rest @ ..] => format!(" · {first} +{}", rest.len()),
    };
    view! {
        <button class="btn" id="explorer" aria-label=sig(named) title="Explorer, preference order, settings (O)" on:click=mouse(move |_| lab.dialog.set(Some(Dialog::Settings)))>
            {icons::settings()}
            <span class="hide-s">{part(move || lab.by_the_book().then_some(view! { <span class="hide-l">"Book · "</span> }))}{order}{briefly}</span>
        </button>
    }
}

/// Light, dark, by system: each press the next.
#[component]
fn ThemeButton() -> impl IntoView {
    let lab = lab();
    let label = move || match lab.theme.get() {
        Theme::System => "Theme: by system",
        Theme::Light => "Theme: light",
        Theme::Dark => "Theme: dark",
    };
    let next = move |_| {
        lab.theme.update(|theme| {
            *theme = match theme {
                Theme::System => Theme::Light,
                Theme::Light => Theme::Dark,
                Theme::Dark => Theme::System,
            };
        });
    };
    view! {
        <button class="btn icon" aria-label=label title=label on:click=mouse(next)>
            {part(move || match lab.theme.get() {
                Theme::System => icons::system().into_any(),
                Theme::Light => icons::sun().into_any(),
                Theme::Dark => icons::moon().into_any(),
            })}
        </button>
    }
}
