//! Dialogs and toasts: one of each at a time, in the browser's own `<dialog>` (focus stays inside, Esc closes).

use crate::web::erase::{event, mouse, part};
use leptos::html;
use leptos::prelude::*;

use super::lazy::{self, lazy};
use super::state::{Dialog, Lab, ToastAction, ToastTone, lab};
use super::{browser, icons};

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
    Effect::new(move |_| {
        if let Some(dialog) = element.get()
            && !dialog.open()
        {
            let _ = dialog.show_modal();
        }
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
            <Toasts />
        </dialog>
    }
}

/// Ends messages: all of them with what they speak of; what was only told goes by itself, too.
pub fn end_toasts(lab: Lab) {
    Effect::new(move |_| {
        let Some(toast) = lab.toast.get() else { return };
        if !toast.holds() {
            lab.toast.set(None);
        }
    });
    Effect::new(move |_| {
        let Some(toast) = lab.toast.get() else { return };
        if toast.tone == ToastTone::Info && toast.action != Some(ToastAction::Update) {
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
}

/// The message, read aloud when it comes: over the head of the page, or in the dialog that is open.
#[component]
pub fn Toasts() -> impl IntoView {
    let lab = lab();
    let act = move |action: ToastAction| {
        lab.toast.set(None);
        match action {
            ToastAction::Undo => lab.undo(),
            ToastAction::Update => {
                if let Ok(event) = web_sys::Event::new("linemaze:update-now") {
                    let _ = window().dispatch_event(&event);
                }
            }
        }
    };
    view! {
        <div class="toasts" aria-live="assertive">
            {part(move || lab.toast.get().map(|toast| {
                let error = toast.tone == ToastTone::Error;
                view! {
                    <div class="toast" role=if error { "alert" } else { "status" }>
                        <span class="mark">{if error { icons::no().into_any() } else { icons::info().into_any() }}</span>
                        <p>
                            {(!toast.title.is_empty()).then(|| view! { <b>{toast.title.clone()}"."</b>" " })}
                            {toast.text.clone()}
                        </p>
                        {toast.action.map(|action| view! {
                            <button class="btn" on:click=mouse(move |_| act(action))>
                                {match action { ToastAction::Undo => "Undo", ToastAction::Update => "Use it" }}
                            </button>
                        })}
                        <button class="btn icon" aria-label="Close the message" on:click=mouse(move |_| lab.toast.set(None))>{icons::close()}</button>
                    </div>
                }
            }))}
        </div>
    }
}
