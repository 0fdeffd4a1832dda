//! What can be read: the keys, the glossary of the book's names, the errata.

use leptos::prelude::*;

use super::Modal;
use crate::explorer::book::errata::ERRATA;
use crate::explorer::book::glossary::{Belongs, Entry, GLOSSARY};
use crate::web::keys::HELP;
use crate::web::step::ErratumNote;

/// All keys.
#[component]
pub fn Keys() -> impl IntoView {
    let key = |keys: &'static str| keys.split(' ').map(|key| view! { <kbd>{key}</kbd>" " }).collect_view();
    view! {
        <Modal title="Keys">
            <div class="keycols">
                {HELP.iter().map(|(group, keys)| view! {
                    <dl>
                        <dt>{*group}</dt>
                        {keys.iter().map(|(keys, what)| view! { <dd><span>{key(keys)}</span><span>{*what}</span></dd> }).collect_view()}
                    </dl>
                }).collect_view()}
            </div>
        </Modal>
    }
}

/// The names of tables 2.1 and 2.2, and ours; opened at one of them.
#[component]
pub fn Glossary(at: Option<&'static str>) -> impl IntoView {
    Effect::new(move |_| {
        let Some(name) = at else { return };
        // Before the dialog is shown, nothing in it has a place.
        request_animation_frame(move || {
            if let Some(entry) = document().get_element_by_id(&id(name)) {
                entry.scroll_into_view();
            }
        });
    });
    let entry = move |entry: &'static Entry| {
        view! {
            <div id=id(entry.name) class:lit=at == Some(entry.name)>
                <dt>{entry.name}</dt>
                <dd>
                    {entry.meaning}
                    <span class="small">{entry.section}" · "{entry.seen}</span>
                </dd>
            </div>
        }
    };
    let group = move |belongs: Belongs, title: &'static str| {
        view! {
            <h3>{title}</h3>
            <dl class="entries">{GLOSSARY.iter().filter(|entry| entry.belongs == belongs).map(entry).collect_view()}</dl>
        }
    };
    view! {
        <Modal title="Glossary">
            {group(Belongs::Shown, "The book’s names, as the lab shows them")}
            {group(Belongs::Ours, "Ours: what the book leaves unnamed")}
            {group(Belongs::Robot, "The physical robot’s")}
        </Modal>
    }
}

fn id(name: &str) -> String {
    format!("name-{name}")
}

/// All errata.
#[component]
pub fn Errata() -> impl IntoView {
    view! {
        <Modal title="Where the book slips or is silent">
            {ERRATA.iter().map(|erratum| view! { <ErratumNote erratum=erratum /> }).collect_view()}
        </Modal>
    }
}
