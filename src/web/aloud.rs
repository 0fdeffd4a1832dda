//! What screen readers hear of a run and of the page: two places that nobody sees, one for the moment that is shown,
//! one for what was just done. The moment's words are those that stand on the page.

use std::time::Duration;

use leptos::leptos_dom::helpers::TimeoutHandle;
use leptos::prelude::*;
use wasm_bindgen::JsCast;
use web_sys::HtmlElement;

use super::browser;
use super::erase::part;
use super::state::{Lab, Place, Round, lab};
use super::step::transport;
use crate::playback::voice::{Mover, Voice};
use crate::trace::Moment;

/// What is to be read when the moment changes.
const TOLD: &str = "[data-told]";

/// Who speaks.
#[derive(Clone, Copy)]
pub struct Speaker {
    voice: StoredValue<Voice>,
    waiting: StoredValue<Option<TimeoutHandle>>,
    said: RwSignal<String>,
}

impl Speaker {
    /// Somebody who has said nothing yet.
    #[must_use]
    pub fn new() -> Self {
        Self {
            voice: StoredValue::new(Voice::default()),
            waiting: StoredValue::new(None),
            said: RwSignal::default(),
        }
    }
}

impl Default for Speaker {
    fn default() -> Self {
        Self::new()
    }
}

/// The places.
#[component]
pub fn Aloud() -> impl IntoView {
    let lab = lab();
    listen(lab);
    view! {
        <div class="vh" id="heard" role="status">{anew(lab.speaker.said)}</div>
        <div class="vh" id="done" role="status">{anew(lab.done)}</div>
    }
}

/// A text whose element is made anew each time: the same words, said twice, are heard twice.
fn anew(text: RwSignal<String>) -> impl FnMut() -> AnyView + Send {
    part(move || view! { <p>{text.get()}</p> })
}

/// Speaks of each moment of the run that is shown, where a room shows it.
fn listen(lab: Lab) {
    Effect::new(move |before: Option<(Round, (Moment, bool))>| {
        let shows = matches!(lab.place(), Place::Step | Place::Projector | Place::Connect);
        let now =
            (lab.round.get(), lab.playing().with(|playback| (playback.moment(), playback.is_playing())));
        let Some(before) = before.filter(|before| shows && *before != now) else { return now };
        // What plays to the end stops there by itself.
        let (played, plays) = (before.1.1, now.1.1);
        let ended = played && untrack(|| transport::is_at_end(lab));
        let drives = lab.halt.with_untracked(Option::is_some);
        news(lab, if plays || ended || drives { Mover::Time } else { Mover::Hand });
        now
    });
}

/// Something is told that was not there before.
pub fn news(lab: Lab, mover: Mover) {
    let Speaker { voice, waiting, .. } = lab.speaker;
    let wait_s = voice.with_value(|voice| voice.wait_s(browser::now_s(), mover));
    match (mover, waiting.with_value(Option::is_some)) {
        // By then it is the newest.
        (Mover::Time, true) => return,
        (Mover::Hand, true) => {
            if let Some(timer) = waiting.try_update_value(Option::take).flatten() {
                timer.clear();
            }
        }
        (_, false) => {}
    }
    // Also at once only after all views have followed.
    let timer = set_timeout_with_handle(move || speak(lab), Duration::from_secs_f64(wait_s)).ok();
    waiting.set_value(timer);
}

fn speak(lab: Lab) {
    lab.speaker.waiting.set_value(None);
    let element = document().query_selector(TOLD).ok().flatten();
    let told = element.and_then(|element| element.dyn_into::<HtmlElement>().ok());
    // A robot's run in a room without sentences.
    let text = told.map_or_else(|| untrack(|| transport::said_now(lab)), |told| told.inner_text());
    if lab.speaker.said.with_untracked(|said| *said != text) {
        lab.speaker.voice.update_value(|voice| voice.spoke(browser::now_s()));
        lab.speaker.said.set(text);
    }
}
