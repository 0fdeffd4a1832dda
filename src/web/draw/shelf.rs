//! The samples: a shelf below the drawing, and all of them with their notes.

use crate::web::erase::mouse;
use leptos::prelude::*;

use super::thumb::thumb;
use crate::maze::samples::{SAMPLES, Sample};
use crate::web::dialogs::Modal;
use crate::web::state::{Dialog, Lab, lab};

/// The shelf.
#[component]
pub fn Shelf() -> impl IntoView {
    let lab = lab();
    let item = move |sample: &'static Sample| {
        let maze = sample.maze();
        let title = maze.about.title.clone();
        view! {
            <li>
                <button title=title on:click=mouse(move |_| open(lab, sample))>
                    {thumb(&maze)}
                    <span>{sample.label}</span>
                </button>
            </li>
        }
    };
    view! {
        <footer class="samples">
            <div class="samples-head">
                <h2>"Samples"</h2>
                <span class="small hide-m">"or drop a file anywhere"</span>
            </div>
            <ul class="shelf">{SAMPLES.iter().map(item).collect_view()}</ul>
            <button class="btn" on:click=mouse(move |_| lab.dialog.set(Some(Dialog::Samples)))>{format!("All {}", SAMPLES.len())}</button>
        </footer>
    }
}

fn open(lab: Lab, sample: &Sample) {
    let maze = sample.maze();
    let title = maze.about.title.clone();
    lab.open(maze);
    lab.say_done(format!("{title} is open."));
}

/// All samples with title and note.
#[component]
pub fn Samples() -> impl IntoView {
    let lab = lab();
    let item = move |sample: &'static Sample| {
        let maze = sample.maze();
        let about = maze.about.clone();
        let choose = move |_| {
            lab.dialog.set(None);
            open(lab, sample);
        };
        view! {
            <li>
                <button on:click=mouse(choose)>
                    {thumb(&maze)}
                    <span>
                        <b>{about.title}</b>
                        <span class="small">{about.note}</span>
                    </span>
                </button>
            </li>
        }
    };
    view! {
        <Modal title="Samples">
            <ul class="all-samples">{SAMPLES.iter().map(item).collect_view()}</ul>
        </Modal>
    }
}
