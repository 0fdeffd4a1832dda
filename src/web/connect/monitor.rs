//! The monitor: every line both ways, sifted, paused, sent, copied, kept. Only lines in sight are made.

use std::fmt::Write;

use crate::web::erase::{event, mouse, part, sig, submit};
use leptos::html;
use leptos::prelude::*;

use super::wire;
use crate::link::monitor::{LogLine, Mark, Monitor, Show, Way};
use crate::link::page::{Command, Link};
use crate::link::sieve::Sieve;
use crate::web::state::{ToastTone, lab};
use crate::web::{browser, icons};

/// The height of a line in rem; the style sheet says the same.
const LINE: f64 = 1.375;
/// Lines that are made beyond those in sight.
const SPARE: usize = 4;

/// What is in sight, in rem.
#[derive(Clone, Copy, PartialEq)]
struct Sight {
    top: f64,
    height: f64,
    /// Whether the newest line is kept in sight.
    follows: bool,
}

/// The card.
#[component]
pub fn MonitorCard() -> impl IntoView {
    let (lab, wire) = (lab(), wire());
    let scroller = NodeRef::<html::Div>::new();
    let sight = RwSignal::new(Sight { top: 0.0, height: 20.0, follows: true });
    let (show, letters, paused) =
        (RwSignal::new(Show::All), RwSignal::new(String::new()), RwSignal::new(false));
    let sieve = StoredValue::new(Sieve::default());
    let typed = RwSignal::new(String::new());
    // Another filter begins from the first line that is kept.
    let filter = Memo::new(move |_| (show.get(), letters.get()));
    Effect::new(move |_| {
        let (show, letters) = filter.get();
        sieve.set_value(Sieve::new(show, &letters));
        sight.update(|sight| sight.follows = true);
    });
    let count = Memo::new(move |_| wire.look(|link| (link.monitor().total(), link.monitor().bad())));
    let lines = Memo::new(move |_| {
        filter.track();
        let (sight, paused) = (sight.get(), paused.get());
        if !paused {
            count.track();
        }
        wire.peek(|link| {
            sieve.try_update_value(|sieve| in_sight(link, sieve, sight, paused)).unwrap_or_default()
        })
    });
    let on_scroll = move |_| {
        if let Some(div) = scroller.get_untracked() {
            let rem = browser::rem_px();
            let [top, height, all] =
                [div.scroll_top(), div.client_height(), div.scroll_height()].map(|px| f64::from(px) / rem);
            let before = sight.get_untracked();
            // Lines may have come since it was scrolled down: only who scrolls up lets the newest go.
            let down = top + height + LINE >= all;
            let follows = down || before.follows && top >= before.top;
            sight.set(Sight { top, height, follows });
        }
    };
    // After the lines are made, the newest is scrolled to.
    Effect::new(move |_| {
        lines.track();
        if sight.get_untracked().follows
            && let Some(div) = scroller.get()
        {
            let height = f64::from(div.client_height()) / browser::rem_px();
            if (sight.get_untracked().height - height).abs() > 0.06 {
                sight.update(|sight| sight.height = height);
            }
            // Once the lines are there.
            request_animation_frame(move || {
                if sight.try_get_untracked().is_some_and(|sight| sight.follows) {
                    div.set_scroll_top(div.scroll_height());
                }
            });
        }
    });
    let copied = move |ok: bool| match ok {
        true => lab.say(ToastTone::Info, "", "The log is copied."),
        false => lab.say(
            ToastTone::Error,
            "Can’t copy",
            "This browser gives no access to the clipboard: download the log instead.",
        ),
    };
    let download = move |_| {
        browser::download("robot-log.txt", "text/plain", &wire.peek(|link| link.monitor().download()));
        lab.say(ToastTone::Info, "", "robot-log.txt goes to your downloads.");
    };
    let send = move |event: web_sys::SubmitEvent| {
        event.prevent_default();
        let line = typed.get_untracked();
        if !line.trim().is_empty() {
            wire.command(Command::Line(line.trim().to_owned()));
            typed.set(String::new());
        }
    };
    let connected = Memo::new(move |_| wire.snapshot().state);
    let can_send = move || {
        connected.get().is_connected()
            || matches!(
                connected.get(),
                crate::link::page::State::Waiting | crate::link::page::State::Alarm(_)
            )
    };
    let sort = move |of: Show, name: &'static str| {
        view! { <button aria-pressed=sig(move || (show.get() == of).to_string()) on:click=mouse(move |_| show.set(of))>{name}</button> }
    };
    view! {
        <section class="card monitor" aria-labelledby="monitor-title">
            <h2 id="monitor-title">"Monitor"<span class="aside" id="monitor-count">{part(move || {
                let (total, bad) = count.get();
                format!("{total} lines · {bad} bad")
            })}</span><span class="spacer"></span>
                <span class="group">
                    <button class="btn icon" aria-label="Pause the monitor" aria-pressed=sig(move || paused.get().to_string()) on:click=mouse(move |_| paused.update(|on| *on = !*on))>
                        {part(move || if paused.get() { icons::play().into_any() } else { icons::pause().into_any() })}
                    </button>
                    <button class="btn icon" aria-label="Copy the log" on:click=mouse(move |_| browser::copy(wire.peek(|link| link.monitor().download()), copied))>{icons::copy()}</button>
                    <button class="btn icon" aria-label="Download the log" on:click=mouse(download)>{icons::download()}</button>
                </span>
            </h2>
            <div class="row filter">
                <div class="seg" role="group" aria-label="Show">
                    {sort(Show::All, "All")}
                    {sort(Show::Events, "Events")}
                    {sort(Show::Sent, "Sent")}
                </div>
                <input class="input" id="filter" aria-label="Filter" placeholder="filter" autocomplete="off" on:input=event(move |event| letters.set(event_target_value(&event))) />
            </div>
            <div class="log scroll" node_ref=scroller on:scroll=event(on_scroll) tabindex="0" role="log" aria-live="off" aria-label="Lines, newest last">
                {part(move || (count.get().0 == 0).then(|| view! { <p class="small blank">"Every line that is sent or comes is shown here."</p> }))}
                <ol inner_html=sig(move || lines.get())></ol>
            </div>
            <form class="row filter" on:submit=submit(send)>
                <input class="input" id="line" aria-label="Line to send" placeholder="hi, stop, help" autocomplete="off" autocapitalize="off" spellcheck="false" maxlength="80" prop:value=sig(move || typed.get()) on:input=event(move |event| typed.set(event_target_value(&event))) />
                <button class="btn" id="send-line" disabled=sig(move || !can_send())>"Send line"</button>
            </form>
        </section>
    }
}

/// The lines in sight as markup.
fn in_sight(link: &Link, sieve: &mut Sieve, sight: Sight, paused: bool) -> String {
    let monitor = link.monitor();
    if !paused {
        sieve.catch_up(monitor);
    }
    let all = sieve.len();
    let fit = (sight.height / LINE) as usize + 2 * SPARE;
    let from = match sight.follows {
        true => all.saturating_sub(fit),
        false => ((sight.top / LINE) as usize).saturating_sub(SPARE).min(all.saturating_sub(1)),
    };
    let mut markup = gap(from);
    for (number, line) in sieve.lines(monitor, from, fit) {
        push_line(&mut markup, monitor, number, line);
    }
    markup + &gap(all.saturating_sub(from + fit))
}

fn gap(lines: usize) -> String {
    if lines == 0 {
        return String::new();
    }
    let height = lines as f64 * LINE;
    format!("<li class=\"gap\" aria-hidden=\"true\"><svg width=\"1\" height=\"{height}rem\"></svg></li>")
}

fn push_line(markup: &mut String, monitor: &Monitor, number: u64, line: &LogLine) {
    let (class, arrow, told) = match line.way {
        Way::In => ("in", "←", " from the robot"),
        Way::Out => ("out", "→", " to the robot"),
    };
    let mark = match line.mark {
        Mark::Plain => "",
        Mark::Bad(_) | Mark::Strange | Mark::Lost => " bad",
        Mark::Differs => " differs",
    };
    let _ = write!(
        markup,
        "<li class=\"{class}{mark}\" data-line=\"{number}\"><time>{}</time><span class=\"dir\">{arrow}<span class=\"vh\">{told}</span></span><span class=\"ln\">",
        monitor.time(line)
    );
    let text = line.text();
    let (body, sum) = text.rsplit_once('*').filter(|(_, sum)| sum.len() == 2).unwrap_or((&text, ""));
    escape(markup, body);
    if !sum.is_empty() {
        markup.push_str("<i>*");
        escape(markup, sum);
        markup.push_str("</i>");
    }
    markup.push_str("</span>");
    if line.mark != Mark::Plain {
        let _ = write!(markup, "<em>{}</em>", line.mark.text());
    }
    markup.push_str("</li>");
}

/// What a robot says may hold anything.
fn escape(markup: &mut String, text: &str) {
    for letter in text.chars() {
        match letter {
            '&' => markup.push_str("&amp;"),
            '<' => markup.push_str("&lt;"),
            '>' => markup.push_str("&gt;"),
            '"' => markup.push_str("&quot;"),
            _ => markup.push(letter),
        }
    }
}
