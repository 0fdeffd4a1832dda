//! The head of the page: rooms, and what concerns all of them. It is one row at any width: where there is little,
//! the rooms are behind one button and the tools behind another.

use crate::web::erase::{key, mouse, part, sig};
use leptos::prelude::*;
use wasm_bindgen::JsCast;
use web_sys::{Element, KeyboardEvent};

use super::state::{Dialog, Room, lab};
use super::storage::Theme;
use super::{browser, icons};
use crate::explorer::name::Name;
use crate::settings::Order;

/// The rooms that the head leads to, with their names and addresses.
const ROOMS: [(Room, &str, &str); 4] = [
    (Room::Draw, "Draw", "#draw"),
    (Room::Step, "Step", "#step"),
    (Room::Compare, "Compare", "#compare"),
    (Room::Connect, "Connect", "#connect"),
];

/// What is folded away where there is little width, by its id.
const ROOMS_FOLD: &str = "rooms";
const TOOLS_FOLD: &str = "tools";

/// The head.
#[component]
pub fn Header() -> impl IntoView {
    let lab = lab();
    let unfolded = RwSignal::new(None::<&'static str>);
    close_from_outside(unfolded);
    let room = move |(room, name, hash): (Room, &'static str, &'static str)| {
        let here = move || (lab.room.get() == room).then_some("page");
        view! {
            <a href=hash aria-current=here on:click=mouse(move |event| { event.prevent_default(); super::app::go(lab, room); })>{name}</a>
        }
    };
    let here =
        move || ROOMS.iter().find(|(room, ..)| *room == lab.room.get()).map_or("Rooms", |(_, name, _)| name);
    let on_key = move |event: KeyboardEvent| {
        if event.key() == "Escape"
            && let Some(fold) = unfolded.get_untracked()
        {
            event.stop_propagation();
            unfolded.set(None);
            browser::focus(&format!("{fold}-button"));
        }
    };
    view! {
        <header class="top" data-unfolded=sig(move || unfolded.get()) on:keydown=key(on_key)>
            <div class="brand">
                <svg viewBox="0 0 26 26" fill="none" stroke="currentColor" stroke-width="3.2" stroke-linecap="round" stroke-linejoin="round" aria-hidden="true">
                    <path d="M4 23V4h12v9H10v10" />
                    <circle cx="21" cy="20" r="2.6" fill="var(--bot)" stroke="none" />
                </svg>
                <span>"Line Maze Lab"</span>
            </div>
            <FoldButton fold=ROOMS_FOLD unfolded=unfolded label=sig(move || format!("Room: {}", here()))>{here}" ▾"</FoldButton>
            <nav aria-label="Rooms" id=ROOMS_FOLD on:click=mouse(move |_| unfolded.set(None))>{ROOMS.map(room).into_iter().collect_view()}</nav>
            <div class="spacer"></div>
            <div class="tools-right">
                <OrderButton />
                <FoldButton fold=TOOLS_FOLD unfolded=unfolded label=sig(|| "More".to_owned())>"⋯"</FoldButton>
                <div class="tools-more" id=TOOLS_FOLD on:click=mouse(move |_| unfolded.set(None))>
                    <button class="btn icon" aria-label="Projector (P)" title="Projector: large type (P)" on:click=mouse(move |_| { lab.room.set(Room::Step); lab.projector.set(true); })>
                        {icons::screen()}<span class="word">"Projector"</span>
                    </button>
                    <button class="btn icon share" aria-label="Share" title="A link and a QR code of this maze" on:click=mouse(move |_| lab.dialog.set(Some(Dialog::Share)))>
                        {icons::share()}<span class="word">"Share"</span>
                    </button>
                    <button class="btn icon" aria-label="Keys (?)" title="All keys (?)" on:click=mouse(move |_| lab.dialog.set(Some(Dialog::Keys)))>
                        {icons::keyboard()}<span class="word">"Keys"</span>
                    </button>
                    <ThemeButton />
                </div>
            </div>
        </header>
    }
}

/// Shows what is folded away, or hides it again.
#[component]
fn FoldButton(
    fold: &'static str,
    unfolded: RwSignal<Option<&'static str>>,
    label: Signal<String>,
    children: Children,
) -> impl IntoView {
    let open = move || unfolded.get() == Some(fold);
    view! {
        <button
            class="btn fold"
            id=format!("{fold}-button")
            aria-label=label
            aria-expanded=sig(move || open().to_string())
            aria-controls=fold
            on:click=mouse(move |_| unfolded.update(|unfolded| *unfolded = (*unfolded != Some(fold)).then_some(fold)))
        >
            {children()}
        </button>
    }
}

/// A press anywhere but on what is unfolded and its button folds it.
fn close_from_outside(unfolded: RwSignal<Option<&'static str>>) {
    let handle = window_event_listener(leptos::ev::pointerdown, move |event| {
        let Some(fold) = unfolded.get_untracked() else { return };
        let at = event.target().and_then(|target| target.dyn_into::<Element>().ok());
        let inside = at.and_then(|at| at.closest(&format!("#{fold}, #{fold}-button")).ok().flatten());
        if inside.is_none() {
            unfolded.set(None);
        }
    });
    on_cleanup(move || handle.remove());
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
            <span class="order">{part(move || lab.by_the_book().then_some(view! { <span class="hide-l">"Book · "</span> }))}{order}{briefly}</span>
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
            <span class="word">{label}</span>
        </button>
    }
}
