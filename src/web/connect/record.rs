//! The recorder: save what was said, open it again without the robot, choose a run of it.

use crate::web::erase::{event, mouse, part, sig};
use leptos::prelude::*;
use wasm_bindgen::JsCast;
use web_sys::HtmlInputElement;

use super::wire;
use super::wire::Wire;
use crate::link::live::{Difference, Errand, LiveRun};
use crate::link::page::Link;
use crate::link::session::{MAX_BYTES, Session};
use crate::web::browser;
use crate::web::icons;
use crate::web::state::{Lab, ToastTone, lab};

/// The file that a session is saved as.
const FILE: &str = "robot-session.txt";

/// A recording that is open.
#[derive(Clone, Debug, PartialEq)]
pub struct Recorded {
    /// The file's name.
    pub name: String,
    /// Its runs, in a few words each.
    pub runs: Vec<String>,
    /// Which of them is shown.
    pub chosen: usize,
    /// Where robot and page decided differently in it.
    pub difference: Option<Difference>,
}

/// What is recorded, save, open.
#[component]
pub fn RecordBar() -> impl IntoView {
    let (lab, wire) = (lab(), wire());
    let lines = Memo::new(move |_| wire.look(|link| link.session().len()));
    let recording = Memo::new(move |_| wire.look(Link::is_open));
    let past = Memo::new(move |_| wire.look(Link::shows_past) && lab.guest.with(Option::is_some));
    let field = NodeRef::<leptos::html::Input>::new();
    let save = move |_| {
        browser::download(FILE, "text/plain", &wire.peek(|link| link.session().save()));
        lab.say(ToastTone::Info, "", format!("{FILE} goes to your downloads."));
    };
    let choose = move |event: web_sys::Event| {
        let Some(input) = event.target().and_then(|target| target.dyn_into::<HtmlInputElement>().ok()) else {
            return;
        };
        if let Some(file) = input.files().and_then(|files| files.get(0)) {
            open(lab, wire, &file);
        }
        // The same file may be chosen again.
        input.set_value("");
    };
    view! {
        <div class="bar">
            <b>{part(move || match (wire.recorded.with(Option::is_some), past.get()) {
                (true, _) => "Recording",
                (false, true) => "Last run",
                (false, false) => "Live",
            })}</b>
            {part(move || wire.recorded.get().map(|open| view! { <Runs open=open /> }))}
            <span class="spacer"></span>
            {part(move || match (recording.get(), lines.get()) {
                (_, 0) => ().into_any(),
                (true, lines) => view! { <span class="rec" id="recording" title=format!("{lines} lines")><span class="dot" aria-hidden="true"></span>"recording"</span> }.into_any(),
                (false, lines) => view! { <span class="small" id="recorded">{format!("{lines} lines recorded")}</span> }.into_any(),
            })}
            <span class="group">
                <button class="btn" id="save-session" disabled=sig(move || lines.get() == 0) on:click=mouse(save)>"Save"</button>
                <button class="btn" id="open-session" on:click=mouse(move |_| { if let Some(field) = field.get_untracked() { field.click(); } })>"Open a recording"</button>
            </span>
            <input type="file" hidden id="session-file" accept=".txt,text/plain" node_ref=field on:change=event(choose) />
        </div>
    }
}

/// The runs of an open recording, and the way back.
#[component]
fn Runs(open: Recorded) -> impl IntoView {
    let wire = wire();
    let Recorded { runs, chosen, .. } = open;
    view! {
        <select class="input runs" aria-label="Run of the recording" on:change=event(move |event| {
            let index = event_target_value(&event).parse().unwrap_or(0);
            browser::let_go(&event);
            wire.choose_run(index);
        })>
            {runs.into_iter().enumerate().map(|(i, run)| view! { <option value=i selected=i == chosen>{run}</option> }).collect_view()}
        </select>
        <button class="btn icon quiet" aria-label="Close the recording" title="Close the recording" on:click=mouse(move |_| wire.close_recording())>{icons::close()}</button>
    }
}

fn open(lab: Lab, wire: Wire, file: &web_sys::File) {
    let (name, size) = (file.name(), file.size());
    let buffer = file.array_buffer();
    leptos::task::spawn_local(async move {
        let cannot = |why: String| lab.say(ToastTone::Error, format!("Can’t open {name}"), why);
        if size > MAX_BYTES as f64 {
            return cannot("A session has at most 16 MB; cut the file after a line.".into());
        }
        let Ok(buffer) = wasm_bindgen_futures::JsFuture::from(buffer).await else {
            return cannot("The browser could not read the file. Is it still there?".into());
        };
        let bytes = js_sys::Uint8Array::new(&buffer).to_vec();
        match Session::parse(&String::from_utf8_lossy(&bytes)) {
            Err(why) => cannot(why.to_string()),
            Ok(session) => {
                let pace = lab.settings.with_untracked(|settings| settings.pace);
                let runs = session.runs(wire.mind(), pace);
                if runs.is_empty() {
                    return cannot("Nobody drove in it: there is no run to show.".into());
                }
                wire.open_recording(name, runs);
            }
        }
    });
}

impl Recorded {
    /// A recording, with its last run chosen.
    pub(super) fn new(name: String, runs: &[LiveRun]) -> Self {
        let words = |(number, run): (usize, &LiveRun)| {
            let errand = match run.errand() {
                Errand::Explore(mind) => format!("explore {}", mind.order),
                Errand::Route => "route".to_owned(),
                Errand::Unasked => "run".to_owned(),
            };
            format!("{number}: {errand}, {} stops", run.stops())
        };
        let chosen = runs.len().saturating_sub(1);
        let difference = runs.last().and_then(LiveRun::difference);
        Self { name, runs: (1..).zip(runs).map(words).collect(), chosen, difference }
    }
}
