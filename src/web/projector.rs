//! Projector mode: nothing but maze, sentence and controls, large enough for the last row.

use crate::web::erase::{mouse, part};
use leptos::prelude::*;

use super::state::{Round, lab};
use super::step::transport::{Buttons, Counter};
use super::step::{Said, Stage};
use crate::web::step::Length;

/// The room, filled.
#[component]
pub fn Projector() -> impl IntoView {
    let lab = lab();
    let letters = move || {
        let over = lab.round.get() == Round::Explore
            && lab.frame.with(|f| f.as_ref().is_some_and(|f| f.outcome.is_some()));
        lab.run.with(|run| {
            run.as_ref().ok().filter(|_| over).and_then(|run| run.list.as_ref().map(ToString::to_string))
        })
    };
    view! {
        <main class="projector" id="main" tabindex="-1">
            <h1 class="vh">"Projector"</h1>
            <Stage />
            <div class="words" role="status" aria-live="polite">
                <Said length=Length::Short />
                {part(move || letters().map(|letters| view! { <p class="finish-list" aria-label="Turn list">{letters}</p> }))}
            </div>
        </main>
        <footer class="transport-bar projector-bar" aria-label="Run">
            <Buttons />
            <Counter />
            <div class="row">
                {part(move || lab.run.with(|run| run.as_ref().is_ok_and(|run| run.drive.is_some())).then(|| view! {
                    <button class="btn" on:click=mouse(move |_| match lab.round.get_untracked() {
                        Round::Explore => lab.drive_solved(),
                        Round::Solved => lab.round.set(Round::Explore),
                    })>
                        {part(move || if lab.round.get() == Round::Explore { "Drive the solved run" } else { "Back to the exploration" })}
                    </button>
                }))}
                <button class="btn" on:click=mouse(move |_| lab.projector.set(false))>"Leave (P)"</button>
            </div>
        </footer>
    }
}
