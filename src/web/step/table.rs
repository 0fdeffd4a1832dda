//! The node table: what the bot remembers. Long tables show the rows that are in sight only.

use crate::web::erase::{event, mouse, part, pointer, sig};
use leptos::html;
use leptos::prelude::*;

use super::look_up;
use crate::geometry::Heading;
use crate::playback::{Command, Mark};
use crate::trace::WayState;
use crate::web::state::{Lab, lab};

/// The height of a row in pixels; the style sheet says the same.
const ROW: f64 = 34.0;
/// Rows that are made beyond those in sight.
const SPARE: u32 = 12;

/// The card.
#[component]
pub fn NodeTable() -> impl IntoView {
    let lab = lab();
    let ptr = Memo::new(move |_| lab.frame.with(|frame| frame.as_ref().map_or(1, |frame| frame.state.ptr)));
    let scrolled = RwSignal::new((0.0f64, 400.0f64));
    let scroller = NodeRef::<html::Div>::new();
    let range = Memo::new(move |_| {
        let (top, height) = scrolled.get();
        let first = ((top / ROW) as u32).saturating_sub(SPARE) + 1;
        let last = ((top + height) / ROW) as u32 + SPARE;
        (first.min(ptr.get()), last.min(ptr.get() - 1))
    });
    let on_scroll = move |_| {
        if let Some(div) = scroller.get_untracked() {
            scrolled.set((f64::from(div.scroll_top()), f64::from(div.client_height())));
        }
    };
    keep_in_sight(lab, scroller);
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
                            <tbody>
                                <Gap rows=Signal::derive(move || range.get().0 - 1) />
                                {part(move || {
                                    let (first, last) = range.get();
                                    (first.max(1)..=last).map(|number| view! { <NodeRow number=number /> }).collect_view()
                                })}
                                <Gap rows=Signal::derive(move || (ptr.get() - 1).saturating_sub(range.get().1)) />
                            </tbody>
                        </table>
                    </div>
                }.into_any()
            } else {
                view! { <NoNode /> }.into_any()
            })}
        </section>
    }
}

fn remembered(nodes: u32) -> String {
    match nodes {
        0 => String::new(),
        1 => "1 node remembered".to_owned(),
        many => format!("{many} nodes remembered"),
    }
}

/// Scrolls the table so that the node of the moment is in sight.
fn keep_in_sight(lab: Lab, scroller: NodeRef<html::Div>) {
    Effect::new(move |_| {
        let node = lab.frame.with(|frame| frame.as_ref().map_or(0, |frame| frame.node));
        let Some(div) = scroller.get() else { return };
        if node > 0 {
            let (top, height) = (f64::from(div.scroll_top()), f64::from(div.client_height()));
            let row = f64::from(node - 1) * ROW;
            if row < top || row + 2.0 * ROW > top + height {
                div.set_scroll_top((row - height / 2.0).max(0.0) as i32);
            }
        }
    });
}

/// Rows that are not made.
#[component]
fn Gap(rows: Signal<u32>) -> impl IntoView {
    part(move || {
        (rows.get() > 0).then(|| {
            let height = format!("{}px", f64::from(rows.get()) * ROW);
            view! { <tr class="gap" aria-hidden="true"><td colspan="4" style:height=height></td></tr> }
        })
    })
}

/// A name that leads to the glossary.
#[component]
fn Term(name: &'static str) -> impl IntoView {
    let lab = lab();
    view! { <button class="name" on:click=mouse(move |_| look_up(lab, name))>{name}</button> }
}

#[component]
fn NodeRow(number: u32) -> impl IntoView {
    let lab = lab();
    let row = Memo::new(move |_| {
        lab.run.with(|run| run.as_ref().ok().and_then(|run| run.trace.row(lab.moment.get(), number)))
    });
    let frame =
        move |of: fn(&crate::trace::Frame) -> u32| lab.frame.with(|frame| frame.as_ref().map_or(0, of));
    let here = move || frame(|frame| frame.node) == number;
    let top = move || frame(|frame| frame.state.ptr) == number + 1;
    let way = move |heading: Heading| {
        let state = row.with(|row| row.map_or(WayState::None, |row| row.way(heading)));
        let (class, text, told) = match state {
            WayState::None => ("d no", "·".to_owned(), "no path"),
            WayState::Unvisited => ("d on", heading.to_string(), "unvisited"),
            WayState::Visited => ("d seen", heading.to_string(), "visited"),
            WayState::Crossed => ("d x", heading.to_string(), "crossed out"),
        };
        view! { <span class=class title=format!("{} ({}): {told}", heading.word(), heading.index())><span aria-hidden="true">{text}</span><span class="vh">{format!("{} {told}, ", heading.word())}</span></span> }
    };
    view! {
        <tr
            class:here=here
            class:lit=sig(move || lab.lit.get() == Some(number))
            data-node=number
            aria-current=sig(move || here().then_some("true"))
            on:pointerenter=pointer(move |_| lab.lit.set(Some(number)))
            on:pointerleave=pointer(move |_| lab.lit.set(None))
        >
            <td>
                {number}
                {part(move || here().then(|| view! { <span class="tag" title="The bot stands here">"◂"<span class="vh">"the bot stands here"</span></span> }))}
                {part(move || top().then(|| view! { <span class="tag">"ptr−1"</span> }))}
            </td>
            <td>{part(move || Heading::ALL.map(way).into_iter().collect_view())}</td>
            <td>{part(move || row.with(|row| row.map(|row| row.node.back_path.to_string())))}</td>
            <td>{part(move || row.with(|row| row.map(|row| format!("{}, {}", row.node.x_cor, row.node.y_cor))))}</td>
        </tr>
    }
}

/// Nothing remembered yet.
#[component]
fn NoNode() -> impl IntoView {
    let lab = lab();
    view! {
        <div class="blank">
            <p><b>"No node yet"</b></p>
            <p class="small">"The bot has met no fork. Step on to the first one."</p>
            <button class="btn" on:click=mouse(move |_| lab.play(Command::NextEvent(Some(Mark::Node))))>"Next node"</button>
        </div>
    }
}
