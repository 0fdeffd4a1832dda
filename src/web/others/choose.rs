//! The one control that chooses the explorer, and what is to be known about it before: source, idea, what it
//! cannot do, and the sample that shows this.

use leptos::prelude::*;

use crate::explorer::name::{About, Name};
use crate::maze::samples::SAMPLES;
use crate::web::erase::{event, mouse, part, sig};
use crate::web::rooms::go;
use crate::web::state::{Room, lab};

/// The field, and the words under it.
#[component]
pub fn ExplorerField() -> impl IntoView {
    let lab = lab();
    let choose = move |event: web_sys::Event| {
        if let Ok(name) = event_target_value(&event).parse() {
            lab.choose(name);
        }
    };
    view! {
        <label class="field">
            "Explorer"
            <select class="input" id="explorer-name" on:change=event(choose) prop:value=sig(move || lab.explorer.get().text())>
                {groups().into_iter().map(|(source, names)| view! {
                    <optgroup label=source>
                        {names.into_iter().map(|name| view! {
                            <option value=name.text() selected=lab.explorer.get_untracked() == name>{name.about().title}</option>
                        }).collect_view()}
                    </optgroup>
                }).collect_view()}
            </select>
        </label>
        {part(move || about(lab.explorer.get().about()))}
    }
}

/// The explorers by their sources, in their order.
fn groups() -> Vec<(&'static str, Vec<Name>)> {
    let mut groups: Vec<(&'static str, Vec<Name>)> = Vec::new();
    for &name in Name::ALL {
        let source = group(name);
        match groups.iter_mut().find(|(known, _)| *known == source) {
            Some((_, names)) => names.push(name),
            None => groups.push((source, vec![name])),
        }
    }
    groups
}

/// A source in a few words.
const fn group(name: Name) -> &'static str {
    match name {
        Name::Book | Name::LeftHand | Name::RightHand => "Dhasade and Joshi 2017, the book",
        Name::DirectionSumLeft | Name::DirectionSumRight | Name::Mapping => "Sakib and others 2014",
        Name::ParexLeft | Name::ParexRight => "Swirbul 2002, PAReX",
        Name::Cornell1 | Name::Cornell2 | Name::Cornell3 => "Cornell team 2018",
        Name::Tremaux | Name::DepthFirst | Name::FloodFill => "For comparison",
    }
}

fn about(about: &'static About) -> impl IntoView {
    let lab = lab();
    let sample = SAMPLES.iter().find(|sample| sample.file == about.sample);
    view! {
        <div class="about-explorer" id="about-explorer">
            <p>{about.idea}</p>
            <p><b>"What it cannot do: "</b>{about.cannot}</p>
            <p class="reading">{crate::web::icons::pen()}<span><b>{about.reading.extent.words()}": "</b>{about.reading.text}</span></p>
            <p class="small">{about.source}</p>
            {sample.map(|sample| view! {
                <div class="row">
                    <button class="btn" on:click=mouse(move |_| {
                        lab.open(sample.maze());
                        lab.dialog.set(None);
                        go(lab, Room::Step);
                    })>"Open the sample that shows it"</button>
                </div>
            })}
        </div>
    }
}
