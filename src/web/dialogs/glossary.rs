//! The glossary of the explorer that is shown, what its pictures mean, and what its source slips on or leaves open.

use leptos::prelude::*;

use super::Modal;
use crate::explorer::glossary::{self, Belongs, Entry};
use crate::explorer::name::{About, Name};
use crate::web::icons;
use crate::web::state::{Lab, lab};
use crate::web::step::ErratumNote;

mod floor;

/// Whose names are meant: a robot's run is the book's too.
fn shown(lab: Lab) -> Name {
    if lab.by_the_book() { Name::Book } else { lab.explorer.get() }
}

/// An explorer's names; opened at one of them.
#[component]
pub fn Glossary(at: Option<&'static str>) -> impl IntoView {
    let lab = lab();
    Effect::new(move |_| {
        let Some(name) = at else { return };
        // Before the dialog is shown, nothing in it has a place.
        request_animation_frame(move || {
            if let Some(entry) = document().get_element_by_id(&id(name)) {
                entry.scroll_into_view();
            }
        });
    });
    let explorer = untrack(|| shown(lab));
    let entry = move |entry: &'static Entry| {
        let place = if entry.section.is_empty() { "the lab’s" } else { entry.section };
        view! {
            <div id=id(entry.name) class:lit=at == Some(entry.name)>
                <dt>{entry.name}</dt>
                <dd>
                    {entry.meaning}
                    <span class="small">{place}" · "{entry.seen}</span>
                </dd>
            </div>
        }
    };
    let group = move |belongs: Belongs, title: &'static str| {
        let entries: Vec<_> =
            glossary::of(explorer).iter().filter(|entry| entry.belongs == belongs).collect();
        (!entries.is_empty()).then(|| {
            view! {
                <h3>{(belongs == Belongs::Ours).then(|| view! { <span class="ours-head">{icons::pen()}</span> })}{title}</h3>
                <dl class="entries">{entries.into_iter().map(entry).collect_view()}</dl>
            }
        })
    };
    view! {
        <Modal title="Glossary">
            {head(explorer.about())}
            {group(Belongs::Shown, "The source’s names, as the lab shows them")}
            {group(Belongs::Ours, "The lab’s: what the source leaves unnamed")}
            {group(Belongs::Robot, "The physical robot’s")}
            {floor::signs(lab, explorer)}
        </Modal>
    }
}

/// Whose, after whom, and what of it is the lab's.
fn head(about: &'static About) -> impl IntoView {
    view! {
        <p><b>{about.title}</b><br /><span class="small">{about.source}</span></p>
        <p class="reading">{icons::pen()}<span><b>{about.reading.extent.words()}": "</b>{about.reading.text}</span></p>
    }
}

fn id(name: &str) -> String {
    format!("name-{}", name.replace(' ', "-"))
}

/// All notes on the source.
#[component]
pub fn Errata() -> impl IntoView {
    let about = untrack(|| shown(lab())).about();
    let none = about.errata.is_empty();
    view! {
        <Modal title="Where the source slips or is silent">
            {head(about)}
            {about.errata.iter().map(|erratum| view! { <ErratumNote erratum=erratum /> }).collect_view()}
            {none.then(|| view! { <p>"There are no notes on it."</p> })}
        </Modal>
    }
}
