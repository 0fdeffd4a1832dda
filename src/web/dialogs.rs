//! Dialogs and toasts: one of each at a time, in the browser's own `<dialog>` (focus stays inside, Esc closes).

use crate::web::erase::{event, mouse, part};
use leptos::html;
use leptos::prelude::*;

use super::lazy::{self, lazy};
use super::state::{Dialog, ToastAction, ToastTone, lab};
use super::{browser, focus, icons, past};

mod books;
mod glossary;
pub mod settings;
mod share;

/// The open dialog.
#[component]
pub fn Dialogs() -> impl IntoView {
    let lab = lab();
    part(move || {
        lab.dialog.get().map(|dialog| {
            lazy::view(move || {
                let dialog = dialog.clone();
                async move {
                    match dialog {
                        Dialog::New | Dialog::Resize | Dialog::About | Dialog::Paste | Dialog::Samples => {
                            super::draw::dialog(dialog).await
                        }
                        Dialog::Settings => super::others::settings().await,
                        Dialog::TurnList => super::others::turn_list().await,
                        Dialog::Keys | Dialog::Glossary(_) | Dialog::Errata | Dialog::Share => {
                            opened(dialog).await
                        }
                        // The room shows it itself.
                        Dialog::Lineup => Ok(().into_any()),
                    }
                }
            })
        })
    })
}

lazy! { dialogs;
    fn opened(dialog: Dialog) -> AnyView {
        match dialog {
            Dialog::Keys => view! { <books::Keys /> }.into_any(),
            Dialog::Glossary(name) => view! { <glossary::Glossary at=name /> }.into_any(),
            Dialog::Errata => view! { <glossary::Errata /> }.into_any(),
            Dialog::Share => view! { <share::Share /> }.into_any(),
            // The rooms' own, and the explorers'.
            Dialog::Settings
            | Dialog::TurnList
            | Dialog::New
            | Dialog::Resize
            | Dialog::About
            | Dialog::Paste
            | Dialog::Samples
            | Dialog::Lineup => ().into_any(),
        }
    }
}

/// How wide a dialog is.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Width {
    /// For reading.
    #[default]
    Wide,
    /// For a few fields.
    Narrow,
}

/// A dialog with a head and a way out.
#[component]
pub fn Modal(title: &'static str, #[prop(optional)] width: Width, children: Children) -> impl IntoView {
    let lab = lab();
    let element = NodeRef::<html::Dialog>::new();
    let opener = StoredValue::new_local(focus::here());
    Effect::new(move |_| {
        if let Some(dialog) = element.get()
            && !dialog.open()
        {
            begin_at_first_field(&dialog);
            let _ = dialog.show_modal();
        }
    });
    // However it is left. An open dialog that is only taken away would take the focus with it.
    on_cleanup(move || {
        if let Some(dialog) = element.get_untracked() {
            dialog.close();
        }
        opener.with_value(|opener| focus::give_back(opener.as_ref()));
    });
    let close = move || lab.dialog.set(None);
    view! {
        <dialog
            node_ref=element
            class:narrow=width == Width::Narrow
            aria-labelledby="dialog-title"
            // What was typed counts, however the dialog is left.
            on:cancel=event(move |_| browser::blur())
            on:close=event(move |_| close())
            on:click=mouse(move |event: web_sys::MouseEvent| {
                // A click on the veil lands on the dialog itself.
                let on_veil = event.target() == element.get_untracked().map(|dialog| dialog.into());
                if on_veil {
                    close();
                }
            })
        >
            <div class="dialog-head">
                <h2 id="dialog-title">{title}</h2>
                <button class="btn icon quiet" aria-label="Close" on:click=mouse(move |_| close())>{icons::close()}</button>
            </div>
            // What scrolls can be scrolled by keys.
            <div class="dialog-body" tabindex="0">{children()}</div>
        </dialog>
    }
}

/// A dialog opens with the focus in its first field; one that is only read, in its text, which keys scroll.
fn begin_at_first_field(dialog: &web_sys::HtmlDialogElement) {
    const FIELDS: &str = "input:not(:disabled), select:not(:disabled), textarea:not(:disabled)";
    let find = |css: &str| dialog.query_selector(css).ok().flatten();
    let fields = format!(".dialog-body :is({FIELDS})");
    if let Some(first) = find("[data-first]").or_else(|| find(&fields)).or_else(|| find(".dialog-body")) {
        let _ = first.set_attribute("autofocus", "");
    }
}

/// The toast, read aloud when it comes.
#[component]
pub fn Toasts() -> impl IntoView {
    let lab = lab();
    let act = move |action: ToastAction| {
        lab.toast.set(None);
        match action {
            ToastAction::Undo => past::undo(lab),
            ToastAction::Redo => past::redo(lab),
            ToastAction::Cure(cure) => lab.cure(cure),
            ToastAction::Update => {
                if let Ok(event) = web_sys::Event::new("linemaze:update-now") {
                    let _ = window().dispatch_event(&event);
                }
            }
        }
    };
    // What was only told goes by itself; errors and questions stay.
    Effect::new(move |_| {
        let Some(toast) = lab.toast.get() else { return };
        if toast.passes() {
            set_timeout(
                move || {
                    if lab.toast.try_get_untracked().flatten().as_ref() == Some(&toast) {
                        lab.toast.set(None);
                    }
                },
                std::time::Duration::from_secs(6),
            );
        }
    });
    view! {
        <div class="toasts" aria-live="assertive">
            {part(move || lab.toast.get().map(|toast| {
                let error = toast.tone == ToastTone::Error;
                view! {
                    <div class="toast" role=if error { "alert" } else { "status" }>
                        <span class="mark">{if error { icons::no().into_any() } else { icons::info().into_any() }}</span>
                        <p>
                            {(!toast.title.is_empty()).then(|| view! { <b>{toast.title.clone()}</b> <br /> })}
                            {toast.text.clone()}
                        </p>
                        {toast.action.map(|action| {
                            let label = match &action {
                                ToastAction::Undo => "Undo".to_owned(),
                                ToastAction::Redo => "Redo".to_owned(),
                                ToastAction::Update => "Use it".to_owned(),
                                ToastAction::Cure(cure) => cure.label.clone(),
                            };
                            view! { <button class="btn" on:click=mouse(move |_| act(action.clone()))>{label}</button> }
                        })}
                        <button class="btn icon" aria-label="Close the message" on:click=mouse(move |_| lab.toast.set(None))>{icons::close()}</button>
                    </div>
                }
            }))}
        </div>
    }
}
