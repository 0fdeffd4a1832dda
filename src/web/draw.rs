//! The Draw room: a maze under one's hands, what is in order in it, and what the book's explorer makes of it.

use crate::web::erase::part;
use leptos::prelude::*;

use super::lazy::lazy;
use super::state::{Dialog, lab};

mod about;
mod bar;
mod canvas;
mod checks;
mod desk;
mod files;
mod foot;
mod generator;
mod keyboard;
mod menu;
mod paste;
mod picture;
mod rest;
mod shelf;
mod side;
mod sizes;
mod thumb;
mod tools;

pub use files::save;

use desk::Desk;

lazy! { draw;
    /// The room.
    pub fn room() -> AnyView {
        view! { <DrawRoom /> }.into_any()
    }
}

lazy! { draw;
    /// The dialogs that belong to the drawing.
    pub fn dialog(dialog: Dialog) -> AnyView {
        match dialog {
            Dialog::New => view! { <sizes::New /> }.into_any(),
            Dialog::Resize => view! { <sizes::Resize /> }.into_any(),
            Dialog::About => view! { <about::About /> }.into_any(),
            Dialog::Paste => view! { <paste::Paste /> }.into_any(),
            Dialog::Samples => view! { <shelf::Samples /> }.into_any(),
            Dialog::Keys
            | Dialog::Glossary(_)
            | Dialog::Errata
            | Dialog::Share
            | Dialog::Settings
            | Dialog::TurnList
            | Dialog::Lineup => ().into_any(),
        }
    }
}

#[component]
fn DrawRoom() -> impl IntoView {
    let desk = Desk::new(lab());
    provide_context(desk);
    keyboard::listen(desk);
    view! {
        <main class="main draw" id="main" tabindex="-1">
            <h1 class="vh">"Draw"</h1>
            <section class="stage" aria-label="Drawing">
                <div>
                    <bar::Bar />
                    <super::notes::Notes />
                    <super::notes::NotKept />
                </div>
                <div class="desk">
                    <tools::Tools />
                    <canvas::Canvas />
                    {part(move || desk.generating.get().then(|| view! { <generator::Generator /> }))}
                </div>
                <foot::Foot />
            </section>
            <div class="side">
                <checks::Checks />
                <side::Floor />
                <side::Explorer />
            </div>
        </main>
        <shelf::Shelf />
    }
}
