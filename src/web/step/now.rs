//! What just happened: the case, the sentences, the variables, and where the book errs.

use crate::web::erase::{focus, mouse, part, pointer, sig};
use leptos::prelude::*;

use super::result::ResultCard;
use super::{errata, look_up};
use crate::explorer::book::locals::{Locals, locals};
use crate::explorer::book::narrate::{Narration, Span, Tone, narrate};
use crate::geometry::{Heading, Turn};
use crate::playback::Unit;
use crate::route::words;
use crate::trace::{Frame, State};
use crate::web::state::{Lab, Round, lab};

/// What is told at the moment that is shown.
fn narration(lab: Lab) -> Option<Narration> {
    lab.run.with(|run| {
        let run = run.as_ref().ok()?;
        lab.frame.with(|frame| Some(narrate(&run.trace, frame.as_ref()?)))
    })
}

/// How long the sentences are.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Length {
    /// For the stepper.
    Full,
    /// For the projector.
    Short,
}

/// The case and the sentences, of either round.
#[component]
pub fn Said(length: Length) -> impl IntoView {
    let lab = lab();
    part(move || match lab.round.get() {
        Round::Solved => view! { <SaidSolved /> }.into_any(),
        Round::Explore => narration(lab)
            .map(|told| {
                let spans = if length == Length::Full { told.said } else { told.short };
                view! {
                    <span class=tone(told.tone)>{told.case}</span>
                    <p>{spans.into_iter().map(piece).collect_view()}</p>
                    {(length == Length::Full).then(|| view! { <p class="ref">{told.section}</p> })}
                }
            })
            .into_any(),
    })
}

pub const fn tone(tone: Tone) -> &'static str {
    match tone {
        Tone::Now => "case",
        Tone::Go => "case go",
        Tone::Bad => "case bad",
        Tone::Info => "case info",
    }
}

/// A piece of a sentence; nodes light up in table and maze.
pub fn piece(span: Span) -> impl IntoView {
    let lab = lab();
    match span {
        Span::Text(text) => text.into_owned().into_any(),
        Span::Strong(text) => view! { <b>{text.into_owned()}</b> }.into_any(),
        Span::Code(text) => view! { <code>{text.into_owned()}</code> }.into_any(),
        Span::Way { node, heading } => {
            view! { <span class="mono">{format!("{node}·{heading}")}</span> }.into_any()
        }
        Span::Node(node) => view! {
            <button
                class="noderef"
                on:pointerenter=pointer(move |_| lab.lit.set(Some(node)))
                on:pointerleave=pointer(move |_| lab.lit.set(None))
                on:focus=focus(move |_| lab.lit.set(Some(node)))
                on:blur=focus(move |_| lab.lit.set(None))
                on:click=mouse(move |_| lab.lit.set(Some(node)))
            >
                {format!("node {node}")}
            </button>
        }
        .into_any(),
    }
}

/// Round 2, in words.
#[component]
pub fn SaidSolved() -> impl IntoView {
    let lab = lab();
    part(move || {
        let stop = lab.solved.with(|playback| playback.moment().stop);
        let told = lab.shown(|run| {
            let told = words::told(&run.drive()?.route, run.list()?.turns().len(), stop);
            Some(view! { <span class=tone(told.tone)>{told.case}</span> <p>{told.text}</p> })
        });
        told.flatten()
    })
}

/// The card.
#[component]
pub fn NowCard() -> impl IntoView {
    let lab = lab();
    let at_finish = Memo::new(move |_| {
        lab.round.get() == Round::Explore
            && lab.frame.with(|frame| frame.as_ref().is_some_and(|f| f.outcome.is_some()))
    });
    view! {
        <section class="card" aria-labelledby="now-title">
            <h2 id="now-title">"What just happened"</h2>
            <div class="told" id="said" data-told>
                <Said length=Length::Full />
            </div>
            {part(move || at_finish.get().then(|| view! { <ResultCard /> }))}
            {part(move || (lab.round.get() == Round::Explore).then(|| view! { <Variables /> <errata::Errata /> }))}
        </section>
    }
}

/// A variable: its name, its value, and whether it has changed.
struct Var {
    name: &'static str,
    value: String,
    changed: bool,
}

fn var<T: PartialEq + ToString>(name: &'static str, frame: &Frame, of: impl Fn(&State) -> T) -> Var {
    let (now, before) = (of(&frame.state), of(&frame.before));
    Var { name, value: now.to_string(), changed: now != before }
}

/// What the functions that run hold.
fn locals_of(lab: Lab, frame: &Frame) -> Vec<Var> {
    // Where a step is a stop, no function runs any more.
    let by_lines = lab.playing().with(|playback| playback.unit()) == Unit::Line;
    if frame.moment.lines == frame.lines && !by_lines {
        return Vec::new();
    }
    let step = lab.run.with(|run| run.as_ref().ok().and_then(|run| run.trace.step(frame.moment.stop)));
    let Locals { m, d, arrival, m_set, d_set } =
        step.map_or_else(Locals::default, |step| locals(frame, step));
    let direction = |name, heading: Option<Heading>, changed| {
        heading.map(|heading| Var {
            name,
            value: format!("{} {}", heading.index(), heading.letter()),
            changed,
        })
    };
    [
        m.map(|m| Var { name: "m", value: m.to_string(), changed: m_set }),
        direction("d", d, d_set),
        direction("arrival", arrival, false),
    ]
    .into_iter()
    .flatten()
    .collect()
}

/// The variables that matter most.
fn first(frame: &Frame) -> Vec<Var> {
    let dir = |state: &State| format!("{} {}", state.bot_dir.index(), state.bot_dir.letter());
    vec![
        var("ptr", frame, |state| state.ptr),
        var("returning", frame, |state| state.returning),
        var("bot_dir", frame, dir),
        var("cur_x", frame, |state| state.cur_x),
        var("cur_y", frame, |state| state.cur_y),
    ]
}

/// Clock and sensors.
fn further(frame: &Frame) -> Vec<Var> {
    let seen = frame.sighting;
    let sees = |turn: Turn| seen.is_some_and(|seen| seen.sees(turn));
    let kind = |name, wanted| Var {
        name,
        value: seen.is_some_and(|s| s.seen() == wanted).to_string(),
        changed: false,
    };
    let path = |name, turn| Var { name, value: sees(turn).to_string(), changed: false };
    use crate::event::Seen;
    vec![
        var("curr_time", frame, |state| state.curr_time),
        var("prev_time", frame, |state| state.prev_time),
        var("time_diff", frame, State::time_diff),
        path("left_path", Turn::Left),
        path("right_path", Turn::Right),
        path("left_path_var", Turn::Left),
        path("right_path_var", Turn::Right),
        kind("blank_var", Seen::DeadEnd),
        kind("junction_var", Seen::Node),
        kind("finish_var", Seen::Finish),
    ]
}

#[component]
fn Variables() -> impl IntoView {
    let lab = lab();
    let chips = move |of: fn(&Frame) -> Vec<Var>| {
        lab.frame
            .with(|frame| frame.as_ref().map(of))
            .unwrap_or_default()
            .into_iter()
            .map(chip)
            .collect_view()
    };
    let more = RwSignal::new(false);
    view! {
        <div class="vars" aria-label="Variables" role="group">
            {part(move || lab.frame.with(|frame| {
                frame.as_ref().map(|frame| locals_of(lab, frame)).unwrap_or_default().into_iter().map(chip).collect_view()
            }))}
            {part(move || chips(first))}
            {part(move || more.get().then(|| chips(further)))}
            <button class="var more" aria-expanded=sig(move || more.get().to_string()) on:click=mouse(move |_| more.update(|on| *on = !*on))>
                {part(move || if more.get() { "less ▴" } else { "clock, sensors ▾" })}
            </button>
        </div>
    }
}

fn chip(var: Var) -> impl IntoView {
    let lab = lab();
    let Var { name, value, changed } = var;
    view! {
        <button
            class="var"
            class:changed=changed
            data-var=name
            title=if changed { "changed here; click for its meaning" } else { "click for its meaning" }
            on:click=mouse(move |_| look_up(lab, name))
        >
            <i>{name}</i>
            <span>{value}</span>
            {changed.then(|| view! { <span class="vh">"changed"</span> })}
        </button>
    }
}
