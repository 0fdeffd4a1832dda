//! The stepper of every explorer but the book's: the same room, with its own memory on show. It is a part of the
//! page that is loaded when such an explorer is chosen.

use std::sync::Arc;

use leptos::prelude::*;

use super::erase::part;
use super::lazy::lazy;
use super::projector::filled;
use super::run_view::Same;
use super::state::{Lab, Round, lab};
use super::step::transport::Transport;
use super::step::{CannotRun, Length, StageBar};
use crate::recording::moment::At;
use crate::world::CannotStart;

pub mod choose;
mod code;
mod inspect;
mod now;
mod result;
mod run;
mod scene;
mod search;
mod turns;

use run::OtherRun;

lazy! { others;
    /// The room.
    pub fn room() -> AnyView {
        let watched = Watched::begin(lab());
        view! { <Room watched=watched /> }.into_any()
    }
}

lazy! { others;
    /// The room on the projector.
    pub fn projector() -> AnyView {
        let watched = Watched::begin(lab());
        filled(scene::stage(watched), now::said(watched, Length::Short))
    }
}

lazy! { others;
    /// The dialog in which explorer and settings are chosen.
    pub fn settings() -> AnyView {
        view! { <super::dialogs::settings::RunSettings /> }.into_any()
    }
}

lazy! { others;
    /// The turn-list lab.
    pub fn turn_list() -> AnyView {
        view! { <turns::TurnLab /> }.into_any()
    }
}

/// The run that is watched, and the moment.
#[derive(Clone, Copy)]
pub struct Watched {
    run: Memo<Result<Same<OtherRun>, CannotStart>>,
    at: Memo<Option<Same<At>>>,
}

impl Watched {
    /// Makes the run, anew whenever maze, settings or explorer change, and tells the lab.
    fn begin(lab: Lab) -> Self {
        let run = Memo::new(move |_| {
            lab.settings
                .with(|settings| OtherRun::of(lab.maze.get(), settings, lab.explorer.get()).map(Same::new))
        });
        let tell = move |run: Result<Same<OtherRun>, CannotStart>| {
            lab.other.set(Some(run.map(|run| Arc::new(run) as _)));
            if let Some((round, stop)) = lab.awaited.try_update(Option::take).flatten() {
                lab.show(round, stop);
            }
        };
        tell(run.get_untracked());
        Effect::new(move |told: Option<()>| {
            let run = run.get();
            if told.is_some() {
                tell(run);
            }
        });
        let at = Memo::new(move |_| {
            let moment = lab.moment.get();
            run.with(|run| run.as_ref().ok().map(|run| Same::new(run.recording.moment(moment))))
        });
        Self { run, at }
    }

    /// Something about the run; the default where there is none.
    fn of<T: Default>(self, of: impl FnOnce(&OtherRun) -> T) -> T {
        self.run.with(|run| run.as_ref().map_or_else(|_| T::default(), |run| of(run)))
    }

    /// Something about the run and the moment.
    fn at<T: Default>(self, of: impl FnOnce(&OtherRun, &At) -> T) -> T {
        self.at.with(|at| at.as_ref().map_or_else(T::default, |at| self.of(|run| of(run, at))))
    }
}

#[component]
fn Room(watched: Watched) -> impl IntoView {
    let lab = lab();
    let cannot = Memo::new(move |_| watched.run.with(|run| run.as_ref().err().copied()));
    view! {
        <main class="main" id="main" tabindex="-1">
            <h1 class="vh">"Step"</h1>
            <section class="stage" aria-label="Maze">
                <div>
                    <StageBar>{scene::legend(watched)}</StageBar>
                    <super::notes::MazeNote />
                    <super::notes::Notes />
                </div>
                {scene::stage(watched)}
            </section>
            <div class="side">
                {part(move || match cannot.get() {
                    Some(why) => view! { <CannotRun why=why.to_string() /> }.into_any(),
                    None => view! {
                        {now::card(watched)}
                        {part(move || match lab.round.get() {
                            Round::Explore => view! { {inspect::card(watched)} {code::card(watched)} }.into_any(),
                            Round::Solved => result::solved_card(watched),
                        })}
                    }
                    .into_any(),
                })}
            </div>
        </main>
        <footer class="transport-bar" aria-label="Run">
            <Transport />
        </footer>
    }
}
