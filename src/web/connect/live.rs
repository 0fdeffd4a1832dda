//! The robot's run in the stepper: live, or recorded; and where the page's explorer decides otherwise.

use crate::web::erase::{mouse, part};
use leptos::prelude::*;

use super::record::RecordBar;
use super::wire;
use crate::link::floor::ground;
use crate::link::live::{Difference, LiveRun};
use crate::link::words::Source;
use crate::playback::Command;
use crate::trace::Moment;
use crate::web::icons;
use crate::web::run_view::{Guest, Run, Same};
use crate::web::state::{Lab, Room, lab};
use crate::web::step::{GuestNote, Stage};

/// Shows a run in the stepper.
pub(super) fn show(lab: Lab, run: &LiveRun, source: Source<'_>) {
    let (maze, trace) = (lab.maze.get_untracked(), run.trace());
    let page_ms = lab.settings.with_untracked(|settings| settings.pace.cell_ms(maze.scale));
    let Some(ground) = ground(&maze, &trace, page_ms) else { return };
    let fits = ground.seen.is_none();
    let maze = ground.seen.map_or(maze, Same::new);
    let differs = run.difference().map(|difference| difference.stop);
    let mut told = format!("{}.", run.told(source));
    if !fits {
        told.push_str(" It is not the maze of this page: what the robot has seen is drawn.");
    }
    if let Some(stop) = differs {
        told.push_str(&format!(" ≠ At stop {stop} the page decides otherwise."));
    }
    let run = Same::new(Run::told(maze, trace, ground.cell_ms));
    lab.show_guest(Guest { run, told, differs });
}

/// The run, with the recorder.
#[component]
pub fn LiveStage() -> impl IntoView {
    let (lab, wire) = (lab(), wire());
    let there = Memo::new(move |_| wire.look(|link| link.live().is_some()));
    view! {
        <section class="stage live" aria-label="Live run">
            <div>
                <RecordBar />
                <GuestNote />
                {part(move || lab.guest.with(Option::is_none).then(|| view! {
                    <div class="note guest">
                        <span class="mark info">{icons::info()}</span>
                        <div class="row">
                            <span>{if there.get() { "This is the page’s own run." } else { "This is the page’s own run. When the robot drives, its run is shown here, and in Step." }}</span>
                            <span class="spacer"></span>
                            {there.get().then(|| view! { <button class="btn" on:click=mouse(move |_| wire.show_again())>"Show the robot’s run"</button> })}
                            {(!there.get()).then(|| view! { <button class="btn" on:click=mouse(move |_| crate::web::rooms::go(lab, Room::Step))>"Step"</button> })}
                        </div>
                    </div>
                }))}
            </div>
            <Stage />
        </section>
    }
}

/// The first disagreement, once there is one.
#[component]
pub fn Disagreement() -> impl IntoView {
    let (lab, wire) = (lab(), wire());
    let difference = Memo::new(move |_| {
        let recorded = wire.recorded.with(|open| open.as_ref().map(|open| open.difference));
        recorded.unwrap_or_else(|| wire.look(|link| link.live().and_then(LiveRun::difference)))
    });
    part(move || {
        let difference: Difference = difference.get()?;
        let stop = difference.stop;
        Some(view! {
            <section class="card diff" aria-labelledby="diff-title">
                <h2 id="diff-title"><span class="mark warn">{icons::differs()}</span>"First disagreement"</h2>
                <table class="versus">
                    <thead><tr><th scope="col">{format!("stop {stop}")}</th><th scope="col">"Robot"</th><th scope="col">"Page"</th></tr></thead>
                    <tbody>{difference.rows().into_iter().map(|row| {
                        let class = if row.robot == row.page { "" } else { "ne" };
                        view! { <tr class=class><th scope="row">{row.name}</th><td>{row.robot}</td><td>{row.page}</td></tr> }
                    }).collect_view()}</tbody>
                </table>
                <div class="pad stack">
                    <p class="small">{difference.says()}</p>
                    <div class="row"><button class="btn" on:click=mouse(move |_| lab.play(Command::Seek(Moment::after(stop))))>{format!("Go to stop {stop}")}</button></div>
                </div>
            </section>
        })
    })
}
