//! The file menu: a button and its menu, for pointers and for keys.

use crate::web::erase::{key, mouse, part, sig};
use leptos::html;
use leptos::prelude::*;
use wasm_bindgen::JsCast;
use web_sys::{Element, HtmlElement, KeyboardEvent};

use super::files::{self, save};
use crate::maze::Kind;
use crate::maze::micromouse::{Form, Unsaid, has_unsaid_finish};
use crate::web::icons;
use crate::web::opening::choose_file;
use crate::web::state::{Dialog, lab};

/// The button and the menu.
#[component]
pub fn FileMenu() -> impl IntoView {
    let lab = lab();
    let open = RwSignal::new(false);
    let root = NodeRef::<html::Div>::new();
    let button = NodeRef::<html::Button>::new();
    let list = NodeRef::<html::Div>::new();
    close_from_outside(root, open);
    Effect::new(move |_| {
        if let Some(list) = list.get() {
            focus(list.first_element_child());
        }
    });
    let close = move || {
        open.set(false);
        if let Some(button) = button.get_untracked() {
            let _ = button.focus();
        }
    };
    let on_key = move |event: KeyboardEvent| {
        let Some(list) = list.get_untracked() else { return };
        let here = document().active_element();
        match event.key().as_str() {
            "Escape" => close(),
            "Tab" => return open.set(false),
            "ArrowDown" => {
                focus(next(here, Element::next_element_sibling).or_else(|| list.first_element_child()))
            }
            "ArrowUp" => {
                focus(next(here, Element::previous_element_sibling).or_else(|| list.last_element_child()))
            }
            "Home" => focus(list.first_element_child()),
            "End" => focus(list.last_element_child()),
            _ => return,
        }
        event.prevent_default();
        event.stop_propagation();
    };
    let item = move |label: &'static str, key: &'static str, act: fn(crate::web::state::Lab)| {
        view! {
            <button role="menuitem" tabindex="-1" on:click=mouse(move |_| { close(); act(lab); })>
                {label}
                {(!key.is_empty()).then(|| view! { <kbd aria-hidden="true">{key}</kbd> })}
            </button>
        }
    };
    let leaves = RwSignal::new(Unsaid::Refused);
    let has_unsaid = move || lab.maze.with(|maze| maze.kind == Kind::Wall && has_unsaid_finish(maze));
    let leave_out = move || {
        view! {
            <button role="menuitemcheckbox" tabindex="-1" aria-checked=sig(move || (leaves.get() == Unsaid::LeftOut).to_string())
                on:click=mouse(move |_| leaves.update(|it| *it = match *it { Unsaid::Refused => Unsaid::LeftOut, Unsaid::LeftOut => Unsaid::Refused }))>
                "Leave out a finish off the centre"
                <span class="tick" aria-hidden="true">{part(move || (leaves.get() == Unsaid::LeftOut).then(icons::ok))}</span>
            </button>
        }
    };
    let mouse_item = move |form: Form| {
        let name = format!("Export micromouse .{}", form.extension());
        view! {
            <button class="short" role="menuitem" tabindex="-1" aria-label=name on:click=mouse(move |_| { close(); files::export_mouse(lab, form, leaves.get_untracked()); })>
                "." {form.extension()}
            </button>
        }
    };
    view! {
        <div class="menu" node_ref=root>
            <button
                class="btn"
                node_ref=button
                aria-haspopup="menu"
                aria-expanded=sig(move || open.get().to_string())
                on:click=mouse(move |_| open.update(|on| *on = !*on))
                on:keydown=key(move |event| if event.key() == "ArrowDown" && !open.get_untracked() { event.prevent_default(); open.set(true) })
            >
                "File ▾"
            </button>
            {part(move || open.get().then(|| view! {
                <div class="menu-list" role="menu" aria-label="File" node_ref=list on:keydown=key(on_key)>
                    {item("New…", "Alt N", |lab| lab.dialog.set(Some(Dialog::New)))}
                    {item("Open a file…", "Ctrl O", choose_file)}
                    {item("Paste a maze…", "Ctrl V", |lab| lab.dialog.set(Some(Dialog::Paste)))}
                    <hr role="separator" />
                    {item("Save .maze", "Ctrl S", save)}
                    {item("Save .json", "", files::save_json)}
                    <hr role="separator" />
                    <span class="menu-head" role="none" aria-hidden="true">"Export for a micromouse"</span>
                    {Form::ALL.map(mouse_item).into_iter().collect_view()}
                    {has_unsaid().then(leave_out)}
                    <hr role="separator" />
                    {item("Export picture, SVG", "", files::export_svg)}
                    {item("Export picture, PNG", "", files::export_png)}
                    <hr role="separator" />
                    {item("Resize…", "", |lab| lab.dialog.set(Some(Dialog::Resize)))}
                </div>
            }))}
        </div>
    }
}

/// The next button, beyond separators.
fn next(from: Option<Element>, step: impl Fn(&Element) -> Option<Element>) -> Option<Element> {
    let mut at = step(&from?);
    while let Some(element) = at {
        if element.tag_name() == "BUTTON" {
            return Some(element);
        }
        at = step(&element);
    }
    None
}

fn focus(element: Option<Element>) {
    if let Some(element) = element.and_then(|element| element.dyn_into::<HtmlElement>().ok()) {
        let _ = element.focus();
    }
}

/// A press anywhere else closes the menu.
fn close_from_outside(root: NodeRef<html::Div>, open: RwSignal<bool>) {
    let handle = window_event_listener(leptos::ev::pointerdown, move |event| {
        let target = event.target().and_then(|target| target.dyn_into::<web_sys::Node>().ok());
        let inside = root.get_untracked().is_some_and(|root| root.contains(target.as_ref()));
        if open.get_untracked() && !inside {
            open.set(false);
        }
    });
    on_cleanup(move || handle.remove());
}
