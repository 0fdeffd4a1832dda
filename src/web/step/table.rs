//! The node table: what the bot remembers. Long tables show the rows that are in sight only.

use std::fmt::Write;

use crate::web::erase::{event, mouse, part, pointer, sig};
use leptos::html;
use leptos::prelude::*;

use super::look_up;
use crate::explorer::book::narrate::empty::empty_table;
use crate::geometry::Heading;
use crate::playback::{Command, Mark};
use crate::trace::{Frame, Moment, Row, WayState};
use crate::web::browser;
use crate::web::state::{Lab, lab};

/// The height of a row in rem; the style sheet says the same.
const ROW: f64 = 2.125;
/// About the height of the head, which stays in sight.
const HEAD: f64 = 1.75;
/// Rows that are made beyond those in sight.
const SPARE: u32 = 4;
/// What is in sight: rem from the top, and height.
type Sight = (f64, f64);
/// What is in sight at first; a short table may grow that high.
const AT_FIRST: Sight = (0.0, 17.5);
/// All of it: paper does not scroll.
const ALL: Sight = (0.0, 1e6);

/// The card.
#[component]
pub fn NodeTable() -> impl IntoView {
    let lab = lab();
    let ptr = Memo::new(move |_| lab.frame.with(|frame| frame.as_ref().map_or(1, |frame| frame.state.ptr)));
    let scrolled = RwSignal::new(AT_FIRST);
    let scroller = NodeRef::<html::Div>::new();
    let on_scroll = move |_| {
        // Scrolling is told later, when the table may be gone.
        if let Some(div) = scroller.try_get_untracked().flatten() {
            let _ = scrolled.try_set(sight_of(&div));
        }
    };
    keep_in_sight(lab, scroller, scrolled);
    let made = made(lab, scrolled);
    view! {
        <section class="card fill nodes-card" aria-labelledby="nodes-title">
            <h2 id="nodes-title">"Node table"<span class="spacer"></span><span class="small">{part(move || remembered(ptr.get() - 1))}</span></h2>
            {part(move || if ptr.get() > 1 {
                view! {
                    <div class="scroll nodes-scroll" node_ref=scroller on:scroll=event(on_scroll) tabindex="0" role="region" aria-labelledby="nodes-title">
                        <table class="nodes">
                            <thead><tr>
                                <th scope="col">"#"</th>
                                <th scope="col"><Term name="paths" />" · "<Term name="vpaths" /></th>
                                <th scope="col"><Term name="back_path" /></th>
                                <th scope="col"><Term name="x_cor" />", "<Term name="y_cor" />" ms"</th>
                            </tr></thead>
                            <tbody
                                inner_html=sig(move || rows(lab, made.get()))
                                on:pointerover=pointer(move |event| lab.lit.set(browser::data_number(&event, "data-node")))
                                on:pointerleave=pointer(move |_| lab.lit.set(None))
                            ></tbody>
                        </table>
                    </div>
                }.into_any()
            } else {
                view! { <NoNode /> }.into_any()
            })}
        </section>
    }
}

/// The rows that are made, first and last, counted from 0: those in sight, in steps, and some more.
fn made(lab: Lab, scrolled: RwSignal<Sight>) -> Memo<(u32, u32)> {
    let sight = Memo::new(move |before: Option<&(Moment, Sight)>| {
        let (moment, (mut top, height)) = (lab.moment.get(), scrolled.get());
        // A step scrolls to the node of the moment; who scrolls by hand may go anywhere.
        if before.is_none_or(|(before, _)| *before != moment) {
            top = scroll_for(current(lab), (top, height)).unwrap_or(top);
        }
        (moment, (top, height))
    });
    Memo::new(move |_| {
        let (top, height) = if lab.printed.get() { ALL } else { sight.get().1 };
        let first = ((top / ROW) as u32).saturating_sub(SPARE) / SPARE * SPARE;
        (first, ((top + height.max(AT_FIRST.1)) / ROW) as u32 / SPARE * SPARE + 2 * SPARE)
    })
}

/// The node of the moment; 0 if none.
fn current(lab: Lab) -> u32 {
    lab.frame.with(|frame| frame.as_ref().map_or(0, |frame| frame.node))
}

/// The made rows as markup (numbers and fixed words only): at every stop most of them change.
fn rows(lab: Lab, (first, last): (u32, u32)) -> String {
    let lit = lab.lit.get();
    lab.frame.with(|frame| {
        let Some(frame) = frame else { return String::new() };
        let all = frame.state.ptr - 1;
        // The table may have got shorter than what is in sight.
        let last = last.min(all);
        let first = first.min(last) + 1;
        let mut markup = gap(first - 1);
        lab.run.with(|run| {
            let Ok(run) = run else { return };
            for number in first..=last {
                if let Some(row) = run.trace.row(frame.moment, number) {
                    push_row(&mut markup, &row, frame, lit);
                }
            }
        });
        markup + &gap(all - last)
    })
}

/// Rows that are not made.
fn gap(rows: u32) -> String {
    if rows == 0 {
        return String::new();
    }
    let height = f64::from(rows) * ROW;
    format!(
        "<tr class=\"gap\" aria-hidden=\"true\"><td colspan=\"4\"><svg width=\"1\" height=\"{height}rem\"></svg></td></tr>"
    )
}

fn push_row(markup: &mut String, row: &Row, frame: &Frame, lit: Option<u32>) {
    let number = row.number;
    let here = frame.node == number;
    let lit = if lit == Some(number) { "lit" } else { "" };
    let (class, current) = if here { ("here", " aria-current=\"true\"") } else { ("", "") };
    let _ = write!(markup, "<tr class=\"{class} {lit}\" data-node=\"{number}\"{current}><td>{number}");
    if here {
        markup.push_str("<span class=\"tag\" title=\"The bot stands here\">◂<span class=\"vh\">the bot stands here</span></span>");
    }
    if frame.state.ptr == number + 1 {
        markup.push_str("<span class=\"tag\">ptr−1</span>");
    }
    let (mut told, mut shown) = (String::new(), String::new());
    for heading in Heading::ALL {
        let (class, state) = match row.way(heading) {
            WayState::None => ("no", "no path"),
            WayState::Unvisited => ("on", "unvisited"),
            WayState::Visited => ("seen", "visited"),
            WayState::Crossed => ("x", "crossed out"),
        };
        let (word, index) = (heading.word(), heading.index());
        let _ = write!(told, "{word} {state}, ");
        let _ = write!(shown, "<span class=\"d {class}\" title=\"{word} ({index}): {state}\">");
        match row.way(heading) {
            WayState::None => shown.push('·'),
            WayState::Unvisited | WayState::Visited | WayState::Crossed => {
                let _ = write!(shown, "{heading}");
            }
        }
        shown.push_str("</span>");
    }
    let told = told.trim_end_matches(", ");
    let _ = write!(markup, "</td><td aria-label=\"{told}\">{shown}");
    let node = &row.node;
    let _ = write!(markup, "</td><td>{}</td><td>{}, {}</td></tr>", node.back_path, node.x_cor, node.y_cor);
}

fn remembered(nodes: u32) -> String {
    match nodes {
        0 => String::new(),
        1 => "1 node remembered".to_owned(),
        many => format!("{many} nodes remembered"),
    }
}

/// Where to scroll to so that a node's row is in sight; nowhere if it is.
fn scroll_for(node: u32, (top, height): Sight) -> Option<f64> {
    let row = f64::from(node.checked_sub(1)?) * ROW;
    let in_sight = row >= top && row + ROW + HEAD <= top + height;
    (!in_sight).then(|| (row - height / 2.0).max(0.0))
}

fn sight_of(scroller: &web_sys::Element) -> Sight {
    let rem = browser::rem_px();
    (f64::from(scroller.scroll_top()) / rem, f64::from(scroller.client_height()) / rem)
}

/// Scrolls the table so that the node of the moment is in sight.
fn keep_in_sight(lab: Lab, scroller: NodeRef<html::Div>, scrolled: RwSignal<Sight>) {
    Effect::new(move |_| {
        let node = current(lab);
        if scroller.get().is_none() || node == 0 {
            return;
        }
        // Once all views have followed the step: to ask for sizes earlier would lay the page out twice.
        request_animation_frame(move || {
            let Some(div) = scroller.try_get_untracked().flatten() else { return };
            let (mut top, height) = sight_of(&div);
            if let Some(wanted) = scroll_for(node, (top, height)) {
                div.set_scroll_top((wanted * browser::rem_px()) as i32);
                top = wanted;
            }
            if scrolled.try_get_untracked().is_some_and(|known| known != (top, height)) {
                let _ = scrolled.try_set((top, height));
            }
        });
    });
}

/// A name that leads to the glossary.
#[component]
fn Term(name: &'static str) -> impl IntoView {
    let lab = lab();
    view! { <button class="name" on:click=mouse(move |_| look_up(lab, name))>{name}</button> }
}

/// Nothing remembered: no node met yet, or none left.
#[component]
fn NoNode() -> impl IntoView {
    let lab = lab();
    let empty = move || {
        lab.run.with(|run| {
            let run = run.as_ref().ok()?;
            lab.frame.with(|frame| Some(empty_table(&run.trace, frame.as_ref()?)))
        })
    };
    let empty = Memo::new(move |_| empty());
    part(move || {
        empty.get().map(|empty| view! {
        <div class="blank">
            <p><b>{empty.title}</b></p>
            <p class="small">{empty.text}</p>
            {empty.more.then(|| view! { <button class="btn" on:click=mouse(move |_| lab.play(Command::NextEvent(Some(Mark::Node))))>"Next node"</button> })}
        </div>
    })
    })
}
