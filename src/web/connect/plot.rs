//! Five sensors, the error and both motors over the last seconds.

use std::fmt::Write;

use crate::web::erase::{mouse, part, sig};
use leptos::prelude::*;

use super::wire;
use crate::link::page::{Command, Link};
use crate::link::plot::Showing;
use crate::link::request::Level;
use crate::link::strips::{Curve, WIDTH};
use crate::web::icons;

/// The strips are drawn anew so often at most, on the robot's clock.
const EVERY_MS: u32 = 50;

/// The card.
#[component]
pub fn Sensors() -> impl IntoView {
    let wire = wire();
    let paused = RwSignal::new(false);
    let showing = Memo::new(move |_| wire.look(|link| link.plot().showing(wire.now_ms())));
    let connected = Memo::new(move |_| wire.snapshot().state.is_connected());
    // What is drawn changes with this only.
    let moment = Memo::new(move |before: Option<&Option<(u32, Showing)>>| match before {
        Some(before) if paused.get() => *before,
        _ => wire.look(|link| link.plot().newest().map(|ir| (ir.ms / EVERY_MS, showing.get()))),
    });
    let draw = move |(_, showing)| wire.peek(|link| strips(link, showing));
    let markup = Memo::new(move |_| moment.get().map(draw).unwrap_or_default());
    let says = move || match (showing.get(), connected.get()) {
        (Showing::Live, _) => None,
        // Paused, nothing is waited for.
        (Showing::Waiting, _) if paused.get() => None,
        (Showing::Waiting, true) => Some("Waiting for data"),
        (Showing::Waiting, false) => Some("Waiting for data: no robot is connected"),
        (Showing::Over, _) => Some("Not connected: this is from before"),
    };
    view! {
        <section class="card plot" aria-labelledby="plot-title">
            <h2 id="plot-title">"Sensors"<span class="aside">"last 6 s"</span><span class="spacer"></span>
                <button class="btn icon quiet" aria-label="Pause the plot" aria-pressed=sig(move || paused.get().to_string()) on:click=mouse(move |_| paused.update(|on| *on = !*on))>
                    {part(move || if paused.get() { icons::play().into_any() } else { icons::pause().into_any() })}
                </button>
            </h2>
            <div class="plot-body">
                <div class="strips" role="img" aria-label="Five sensors, line error and both motors over the last six seconds" class:over=sig(move || showing.get() == Showing::Over) inner_html=sig(move || markup.get())></div>
                {part(move || says().map(|says| view! { <p class="waiting" id="plot-waiting" role="status">{says}</p> }))}
            </div>
            <div class="keys small">
                <span><svg width="28" height="10" aria-hidden="true"><path d="M1 5h26" class="curve" /></svg>"left"</span>
                <span><svg width="28" height="10" aria-hidden="true"><path d="M1 5h26" class="curve right" /></svg>"right motor"</span>
                <span><svg width="14" height="14" aria-hidden="true"><path d="M7 0v14" class="stopline" /></svg>"stop"</span>
                <span class="spacer"></span>
                <label class="field watch">"Robot tells"
                    <select class="input" id="watch" on:change=crate::web::erase::event(move |event| {
                        let level = match event_target_value(&event).as_str() {
                            "off" => Level::Off,
                            "events" => Level::Events,
                            _ => Level::All,
                        };
                        wire.command(Command::Watch(level));
                    })>
                        <option value="all">"everything"</option>
                        <option value="events">"events"</option>
                        <option value="off">"nothing"</option>
                    </select>
                </label>
            </div>
        </section>
    }
}

/// The strips as markup: numbers and fixed words only. A number beside a strip is what is sensed now.
fn strips(link: &Link, showing: Showing) -> String {
    let plot = link.plot();
    let Some(newest) = plot.newest().copied() else { return String::new() };
    let (now, last) = match showing {
        Showing::Live | Showing::Waiting => (true, "now"),
        Showing::Over => (false, "last"),
    };
    let value = |value: String| if now { value } else { "–".to_owned() };
    let mut markup = String::new();
    for sensor in 0..5 {
        let curve = Curve::Sensor(sensor);
        let (paths, value) = ([("area", curve)], value(curve.of(&newest).to_string()));
        strip(&mut markup, link, "", &format!("S{sensor}"), 24, &paths, &value);
    }
    let error = Curve::Error;
    strip(&mut markup, link, "err", "error", 36, &[("curve", error)], &value(error.of(&newest).to_string()));
    let motors = [("curve", Curve::Left), ("curve right", Curve::Right)];
    let both = value(format!("{}<br>{}", newest.left, newest.right));
    strip(&mut markup, link, "mot", "motors", 44, &motors, &both);
    let _ = write!(
        markup,
        "<div class=\"axis\"><span></span><span class=\"ticks\"><i>−6 s</i><i>−4</i><i>−2</i><i>{last}</i></span><b></b></div>"
    );
    markup
}

fn strip(
    markup: &mut String,
    link: &Link,
    class: &str,
    name: &str,
    height: u32,
    curves: &[(&str, Curve)],
    value: &str,
) {
    let _ = write!(
        markup,
        "<div class=\"{class}\"><span>{name}</span><svg viewBox=\"0 0 {WIDTH} {height}\" preserveAspectRatio=\"none\" aria-hidden=\"true\">"
    );
    if !class.is_empty() {
        let _ = write!(markup, "<path class=\"zero\" d=\"M0 {}H{WIDTH}\"/>", height / 2);
    }
    for (class, curve) in curves {
        let _ = write!(markup, "<path class=\"{class}\" d=\"{}\"/>", link.plot().path(*curve, height));
    }
    for place in link.plot().stop_places() {
        let x = place / 100.0 * f64::from(WIDTH);
        let _ = write!(markup, "<path class=\"stopline\" d=\"M{x:.0} 0V{height}\"/>");
    }
    let _ = write!(markup, "</svg><b>{value}</b></div>");
}
