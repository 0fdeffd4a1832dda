//! Time: the buttons, the scrubber with its event markers, the counter, and what a step is.

use crate::decimal::Decimal;
use crate::web::erase::{event, mouse, part, pointer, sig};
use leptos::html;
use leptos::prelude::*;

use crate::playback::{Command, Mark, SPEEDS, Timeline, Unit};
use crate::trace::Moment;
use crate::web::maze_view::size_of;
use crate::web::played;
use crate::web::state::{Lab, Round, lab};
use crate::web::{browser, icons};

/// The height of the picture of events, where one is drawn at the browser's usual font size.
const MARKS: u32 = 34;

/// The whole bar.
#[component]
pub fn Transport() -> impl IntoView {
    view! {
        <Buttons />
        <Scrubber />
        <div class="transport-more">
            <Counter />
            <EventPicker />
            <UnitPicker />
            <SpeedPicker />
        </div>
    }
}

/// To start, back, play, forward, to end; and a robot's stop, while one drives.
#[component]
pub fn Buttons() -> impl IntoView {
    let lab = lab();
    let playing = move || lab.playing().with(|playback| playback.is_playing());
    let dead = move || lab.shown(|_| ()).is_none();
    let button = move |label: &'static str, command: Command, icon: AnyView| {
        view! {
            <button aria-label=label title=label disabled=dead on:click=mouse(move |_| lab.play(command))>
                {icon}
            </button>
        }
    };
    view! {
        <div class="transport" role="group" aria-label="Transport">
            {button("To start (Home)", Command::ToStart, icons::to_start().into_any())}
            {button("Back (←)", Command::Back, icons::back().into_any())}
            <button
                class="play"
                aria-label=sig(move || if playing() { "Pause (Space)" } else { "Play (Space)" })
                disabled=dead
                on:click=mouse(move |_| lab.play(Command::Toggle))
            >
                {part(move || if playing() { icons::pause().into_any() } else { icons::play().into_any() })}
            </button>
            {button("Forward (→)", Command::Forward, icons::forward().into_any())}
            {button("To end (End)", Command::ToEnd, icons::to_end().into_any())}
        </div>
    }
}

/// Stops of what is played.
fn stops(lab: Lab) -> u32 {
    timeline(lab, 0, |line| line.stops())
}

/// Something about what is played; `default` where there is nothing.
fn timeline<T>(lab: Lab, default: T, of: impl FnOnce(&dyn Timeline) -> T) -> T {
    let round = lab.round.get();
    lab.shown(|run| match (round, run.drive()) {
        (Round::Solved, Some(drive)) => of(drive),
        _ => of(run.line()),
    })
    .unwrap_or(default)
}

/// The time line: drag it, click it, or use it as a slider.
#[component]
pub fn Scrubber() -> impl IntoView {
    let lab = lab();
    let track = NodeRef::<html::Div>::new();
    let hover = RwSignal::new(None::<(u32, f64)>);
    let dragging = RwSignal::new(false);
    let count = Memo::new(move |_| stops(lab));
    let at = move || lab.playing().with(|playback| f64::from(playback.moment().stop) + playback.along());
    let share = move |stop: f64| stop / f64::from(count.get().max(1));
    let size = size_of(track);
    let stop_under = move |event: &web_sys::PointerEvent| {
        let rect = track.get_untracked()?.get_bounding_client_rect();
        let share = ((f64::from(event.client_x()) - rect.left()) / rect.width().max(1.0)).clamp(0.0, 1.0);
        Some(((share * f64::from(count.get_untracked())).round() as u32, share * 100.0))
    };
    let seek = move |event: &web_sys::PointerEvent| {
        if let Some((stop, _)) = stop_under(event) {
            lab.play(Command::Seek(Moment::after(stop)));
        }
    };
    view! {
        <div
            class="time"
            role="slider"
            tabindex="0"
            aria-label="Stop"
            aria-valuemin="0"
            aria-valuemax=sig(move || count.get())
            aria-valuenow=sig(move || lab.playing().with(|playback| playback.moment().stop))
            aria-valuetext=sig(move || said(lab, lab.playing().with(|playback| playback.moment().stop)))
            on:pointerdown=pointer(move |event| {
                if let Some(element) = track.get_untracked() {
                    let _ = element.set_pointer_capture(event.pointer_id());
                }
                dragging.set(true);
                seek(&event);
            })
            on:pointermove=pointer(move |event| {
                hover.set(stop_under(&event));
                if dragging.get_untracked() {
                    seek(&event);
                }
            })
            on:pointerup=pointer(move |_| dragging.set(false))
            on:pointercancel=pointer(move |_| dragging.set(false))
            on:pointerleave=pointer(move |_| hover.set(None))
        >
            <div class="track" node_ref=track>
                <div class="fill" style:transform=sig(move || format!("scaleX({})", Decimal(share(at()), 5)))></div>
                <Markers count=count width=sig(move || size.get().w) />
                // As wide as the track, so that it moves by shares of it: a move is no new layout.
                <div class="thumb" style:transform=sig(move || format!("translateX({}%)", Decimal(share(at()) * 100.0, 3)))></div>
                {part(move || hover.get().map(|(stop, left)| view! {
                    <div class="tip" style:left=format!("{}%", Decimal(left, 2)) aria-hidden="true">{said(lab, stop)}</div>
                }))}
            </div>
        </div>
    }
}

/// A stop in a few words.
fn said(lab: Lab, stop: u32) -> String {
    let what = match lab.round.get() {
        Round::Explore => lab.shown(|run| run.word(stop)).unwrap_or_default(),
        Round::Solved => timeline(lab, "", |line| played::name(line.mark(stop), stop)).to_owned(),
    };
    format!("stop {stop}: {what}")
}

/// Most markers of a kind that are drawn: with more of them, they are thinned out.
const MARKERS: u32 = 400;

/// The events on the time line: disc, bar, tick, triangle, square. All of a kind are one shape, as a long run has
/// hundreds of them.
#[component]
fn Markers(count: Memo<u32>, #[prop(into)] width: Signal<f64>) -> impl IntoView {
    let lab = lab();
    let marks = Memo::new(move |_| {
        let count = count.get();
        let every = count.div_ceil(MARKERS).max(1);
        let worth =
            |&(stop, mark): &(u32, Mark)| mark != Mark::Plain && (mark == Mark::End || stop % every == 0);
        timeline(lab, Vec::new(), |line| {
            (1..=count).map(|stop| (stop, line.mark(stop))).filter(worth).collect::<Vec<_>>()
        })
    });
    // Their picture is as wide as the track, at the browser's usual font size.
    let wide = move || width.get() / browser::scaled_px();
    let drawn = move || {
        let a_stop = wide() / f64::from(count.get().max(1));
        let kinds = [Mark::Known, Mark::Node, Mark::DeadEnd, Mark::Unknown, Mark::End];
        kinds.map(|kind| {
            let stops = marks.with(|marks| {
                marks.iter().filter(|(_, mark)| *mark == kind).map(|(stop, _)| *stop).collect::<Vec<_>>()
            });
            let (class, shape) = shape(kind);
            let data: String = stops
                .into_iter()
                .map(|stop| format!("M{} 0{shape}", Decimal(f64::from(stop) * a_stop, 1)))
                .collect();
            view! { <path class=class d=data /> }
        })
    };
    let view_box = move || format!("0 0 {} {MARKS}", Decimal(wide().max(1.0), 1));
    view! {
        <svg aria-hidden="true" viewBox=sig(view_box) preserveAspectRatio="none">{part(move || drawn().into_iter().collect_view())}</svg>
    }
}

/// The class of a kind of marker, and its path from the middle of its upper edge.
const fn shape(mark: Mark) -> (&'static str, &'static str) {
    match mark {
        Mark::Plain => ("", ""),
        Mark::Node => ("m-node", "m-4 5a4 4 0 1 0 8 0a4 4 0 1 0-8 0m3 0h2v23h-2z"),
        Mark::DeadEnd => ("m-dead", "m-5 2h10v4h-10zm4 3h2v23h-2z"),
        Mark::Known => ("m-known", "m-.75 11h1.5v17h-1.5z"),
        Mark::Unknown => ("m-unk", "l5 9h-10zm-1.5 8h3v20h-3z"),
        Mark::End => ("m-end", "m-4 1h8v8h-8zm2 7h4v20h-4z"),
    }
}

/// Where the run is, in numbers.
#[component]
pub fn Counter() -> impl IntoView {
    let lab = lab();
    let stop = move || lab.playing().with(|playback| playback.moment().stop);
    let cells = move || match lab.round.get() {
        Round::Explore => {
            let of = |run: &dyn played::Played| (run.cells(stop()), run.cells(run.line().stops()));
            lab.shown(of).map_or_else(String::new, |(now, all)| format!(" · {now} of {all} cells"))
        }
        Round::Solved => String::new(),
    };
    view! { <div class="count" id="count">"stop "<b>{stop}</b>" / "{part(move || stops(lab))}<span class="hide-l">{cells}</span></div> }
}

/// To the next event of a kind.
#[component]
fn EventPicker() -> impl IntoView {
    let lab = lab();
    let kind = RwSignal::new(None::<Mark>);
    let kinds = Memo::new(move |_| lab.shown(|run| run.kinds().to_vec()).unwrap_or_default());
    let choose = move |event: web_sys::Event| {
        browser::let_go(&event);
        let index: usize = event_target_value(&event).parse().unwrap_or(0);
        kind.set(
            index
                .checked_sub(1)
                .and_then(|index| kinds.with(|kinds| kinds.get(index).map(|(mark, _)| *mark))),
        );
    };
    view! {
        <span class="group">
            <select class="input event-kind" aria-label="Kind of event" on:change=event(choose)>
                <option value="0">"any event"</option>
                {part(move || kinds.get().into_iter().zip(1..).map(|((_, name), i)| view! { <option value=i>{name}</option> }).collect_view())}
            </select>
            <button class="btn icon" aria-label="Next event (N)" title="Next event of this kind (N; Shift+N back)" on:click=mouse(move |_| lab.play(Command::NextEvent(kind.get_untracked())))>
                {icons::next_event()}
            </button>
        </span>
    }
}

/// By stop or by line.
#[component]
fn UnitPicker() -> impl IntoView {
    let lab = lab();
    let button = move |unit: Unit, name: &'static str| {
        let chosen = move || lab.playing().with(|playback| playback.unit() == unit);
        view! { <button aria-pressed=sig(move || chosen().to_string()) on:click=mouse(move |_| lab.play(Command::StepBy(unit)))>{name}</button> }
    };
    view! {
        <div class="seg" role="group" aria-label="A step is">
            {button(Unit::Stop, "Stops")}
            {button(Unit::Line, "Lines")}
        </div>
    }
}

#[component]
fn SpeedPicker() -> impl IntoView {
    let lab = lab();
    let choose = move |event: web_sys::Event| {
        browser::let_go(&event);
        let value = event_target_value(&event);
        if let Some(speed) = SPEEDS.into_iter().find(|&speed| Decimal(speed, 1).to_string() == value) {
            lab.play(Command::Speed(speed));
        }
    };
    view! {
        <select class="input" aria-label="Speed" title="Speed; 1× is the robot’s own pace" on:change=event(choose) prop:value=sig(move || lab.playing().with(|playback| Decimal(playback.speed(), 1).to_string()))>
            {SPEEDS.map(|speed| view! { <option value=Decimal(speed, 1).to_string()>{format!("{}×", Decimal(speed, 1))}</option> }).into_iter().collect_view()}
        </select>
    }
}
