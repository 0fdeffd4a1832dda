//! Projector mode: nothing but maze, sentence and controls, large enough for the last row. It is a part of the page
//! that is loaded when it is first asked for.

use crate::web::erase::{mouse, part};
use leptos::prelude::*;

use super::lazy::lazy;
use super::notes::MazeNote;
use super::state::{Lab, Place, Round, lab};
use super::step::transport::{Buttons, Counter};
use super::step::{Length, Said, Stage};

lazy! { dialogs;
    /// The room of the book's explorer, filled.
    pub fn room() -> AnyView {
        // Asked for here: what runs later, once this part has come, may have no context.
        let lab = lab();
        let words = view! { <Said length=Length::Short /> {part(move || letters(lab))} };
        filled(view! { <Stage /> }.into_any(), words.into_any())
    }
}

/// The turn list, once the exploration is over.
fn letters(lab: Lab) -> Option<AnyView> {
    let over = lab.round.get() == Round::Explore
        && lab.frame.with(|frame| frame.as_ref().is_some_and(|frame| frame.outcome.is_some()));
    let letters = lab.run.with(|run| {
        run.as_ref().ok().filter(|_| over).and_then(|run| run.list.as_ref().map(ToString::to_string))
    });
    letters.map(|letters| view! { <p class="finish-list" aria-label="Turn list">{letters}</p> }.into_any())
}

/// A room with this picture and these words.
pub fn filled(picture: AnyView, words: AnyView) -> AnyView {
    let lab = lab();
    view! {
        <main class="projector" id="main" tabindex="-1">
            <h1 class="vh">"Projector"</h1>
            {picture}
            <div class="words">
                <div class="said" data-told>{words}</div>
                <MazeNote />
            </div>
        </main>
        <footer class="transport-bar projector-bar" aria-label="Run">
            <Buttons />
            <Counter />
            <div class="row">
                {part(move || lab.shown(|run| run.drive().is_some()).unwrap_or(false).then(|| view! {
                    <button class="btn" on:click=mouse(move |_| match lab.round.get_untracked() {
                        Round::Explore => lab.drive_solved(),
                        Round::Solved => lab.round.set(Round::Explore),
                    })>
                        {part(move || if lab.round.get() == Round::Explore { "Drive the solved run" } else { "Back to the exploration" })}
                    </button>
                }))}
                <button class="btn" on:click=mouse(move |_| lab.go(Place::Step))>"Leave (P)"</button>
            </div>
        </footer>
    }
    .into_any()
}
