//! A new, empty maze, and another size for the one that is there.

use crate::web::erase::{mouse, sig, submit};
use leptos::prelude::*;

use super::desk::many;
use crate::geometry::Point;
use crate::maze::edit::Edit;
use crate::maze::{Bounds, Kind, MAX_SIDE, Maze};
use crate::web::browser;
use crate::web::dialogs::settings::NumberField;
use crate::web::dialogs::{Modal, Width};
use crate::web::state::lab;

/// How many points along a side there can be.
const SIDES: std::ops::RangeInclusive<u32> = 2..=MAX_SIDE;
const SIDE_HINT: &str = "A whole number from 2 to 1000";

/// The dialog for an empty maze.
#[component]
pub fn New() -> impl IntoView {
    let lab = lab();
    let size = RwSignal::new((16_u32, 10_u32));
    let kind = RwSignal::new(Kind::Line);
    let make = move |event: web_sys::SubmitEvent| {
        event.prevent_default();
        if browser::has_wrong_field(&event) {
            return;
        }
        let (width, height) = size.get_untracked();
        let ne = Point::new(width.cast_signed() - 1, height.cast_signed() - 1);
        if let Ok(bounds) = Bounds::new(Point::new(0, 0), ne) {
            lab.open(Maze::blank(bounds, kind.get_untracked()));
            lab.dialog.set(None);
            lab.say_done("A new maze is open.");
        }
    };
    view! {
        <Modal title="New maze" width=Width::Narrow>
            <form class="stack" on:submit=submit(make) novalidate>
                <div class="pair">
                    <Side id="new-width" label="Width" value=Signal::derive(move || size.get().0) set=move |w| size.update(|size| size.0 = w) />
                    <Side id="new-height" label="Height" value=Signal::derive(move || size.get().1) set=move |h| size.update(|size| size.1 = h) />
                </div>
                <KindChoice id="new-kind" kind=Signal::derive(move || kind.get()) set=move |of| kind.set(of) />
                <p class="small">"The maze that is open now comes back with Undo."</p>
                <div class="row"><button class="btn primary" type="submit">"Begin"</button></div>
            </form>
        </Modal>
    }
}

/// Lines or walls.
#[component]
pub fn KindChoice(
    id: &'static str,
    #[prop(into)] kind: Signal<Kind>,
    set: impl Fn(Kind) + Copy + 'static,
) -> impl IntoView {
    let choice = move |of: Kind, name: &'static str| {
        view! {
            <button type="button" aria-pressed=sig(move || (kind.get() == of).to_string()) on:click=mouse(move |_| set(of))>{name}</button>
        }
    };
    view! {
        <div class="field">
            <span>"Drawn as"</span>
            <div class="seg wide" id=id role="group" aria-label="Drawn as">{choice(Kind::Line, "Lines")}{choice(Kind::Wall, "Walls")}</div>
        </div>
    }
}

#[component]
fn Side(
    id: &'static str,
    label: &'static str,
    value: Signal<u32>,
    set: impl Fn(u32) + 'static,
) -> impl IntoView {
    view! {
        <NumberField id=id label=label value=Signal::derive(move || value.get().to_string()) hint=SIDE_HINT
            read={|text: &str| text.parse().ok().filter(|side| SIDES.contains(side))} set=set />
    }
}

/// Columns and rows that are added on each side; less than 0 where they are cut off.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
struct Growth {
    west: i32,
    south: i32,
    east: i32,
    north: i32,
}

impl Growth {
    fn applied(self, to: Bounds) -> Option<Bounds> {
        let (sw, ne) = (to.sw(), to.ne());
        let bounds = Bounds::new(
            Point::new(sw.x - self.west, sw.y - self.south),
            Point::new(ne.x + self.east, ne.y + self.north),
        );
        bounds.ok().filter(|bounds| SIDES.contains(&bounds.width()) && SIDES.contains(&bounds.height()))
    }
}

/// The dialog for another size: the south-west corner stays, unless points are added or cut there.
#[component]
pub fn Resize() -> impl IntoView {
    let lab = lab();
    let (before, kind) = lab.maze.with_untracked(|maze| (maze.bounds(), maze.kind));
    let places = match kind {
        Kind::Line => "points",
        Kind::Wall => "squares",
    };
    let growth = RwSignal::new(Growth::default());
    let after = Memo::new(move |_| growth.get().applied(before));
    let size = move || {
        after.get().map_or_else(
            || format!("A maze has 2 to {MAX_SIDE} {places} along a side."),
            |after| {
                format!(
                    "{} × {} {places} become {} × {}.",
                    before.width(),
                    before.height(),
                    after.width(),
                    after.height()
                )
            },
        )
    };
    let cut = move || after.get().map(|after| lab.maze.with_untracked(|maze| cut_off(maze, after)));
    let apply = move |event: web_sys::SubmitEvent| {
        event.prevent_default();
        let Some(after) = after.get_untracked().filter(|_| !browser::has_wrong_field(&event)) else { return };
        lab.dialog.set(None);
        if lab.edit(Edit::Bounds(after)) {
            lab.say_done(format!("The maze has {} × {} {places} now.", after.width(), after.height()));
        }
    };
    let width =
        Signal::derive(move || before.width().saturating_add_signed(growth.get().west + growth.get().east));
    let height = Signal::derive(move || {
        before.height().saturating_add_signed(growth.get().south + growth.get().north)
    });
    let grow =
        move |side: fn(&mut Growth) -> &mut i32| move |by: i32| growth.update(|growth| *side(growth) = by);
    let grown = move |side: fn(&mut Growth) -> &mut i32| Signal::derive(move || *side(&mut growth.get()));
    view! {
        <Modal title="Resize" width=Width::Narrow>
            <form class="stack" on:submit=submit(apply) novalidate>
                <div class="pair">
                    <Side id="resize-width" label="Width" value=width
                        set=move |w| growth.update(|g| g.east = w.cast_signed() - before.width().cast_signed() - g.west) />
                    <Side id="resize-height" label="Height" value=height
                        set=move |h| growth.update(|g| g.north = h.cast_signed() - before.height().cast_signed() - g.south) />
                </div>
                <p class="small">"Or say for each side how many rows or columns to add; a number below 0 cuts them off."</p>
                <div class="pair">
                    <Edge id="grow-west" label="West" value=grown(|g| &mut g.west) set=grow(|g| &mut g.west) />
                    <Edge id="grow-east" label="East" value=grown(|g| &mut g.east) set=grow(|g| &mut g.east) />
                    <Edge id="grow-north" label="North" value=grown(|g| &mut g.north) set=grow(|g| &mut g.north) />
                    <Edge id="grow-south" label="South" value=grown(|g| &mut g.south) set=grow(|g| &mut g.south) />
                </div>
                <p role="status">{size} " " <b>{cut}</b></p>
                <div class="row"><button class="btn primary" type="submit" disabled=sig(move || after.get().is_none())>"Resize"</button></div>
            </form>
        </Modal>
    }
}

#[component]
fn Edge(
    id: &'static str,
    label: &'static str,
    value: Signal<i32>,
    set: impl Fn(i32) + 'static,
) -> impl IntoView {
    view! {
        <NumberField id=id label=label value=Signal::derive(move || value.get().to_string())
            hint="A whole number, such as 2 or -3"
            read={|text: &str| text.replace('−', "-").parse().ok().filter(|by: &i32| by.unsigned_abs() <= MAX_SIDE)} set=set />
    }
}

/// What would be lost, in words; empty if nothing.
fn cut_off(maze: &Maze, after: Bounds) -> String {
    let cells = maze
        .lines()
        .filter(|&(at, heading)| !after.contains(at) || !after.contains(at.step(heading)))
        .count();
    let start = maze.start().is_some_and(|start| !after.contains(start.at));
    let finish = maze.finish().iter().any(|&at| !after.contains(at));
    let lost: Vec<String> = [
        (cells > 0).then(|| many(cells, if maze.kind == Kind::Wall { "opening" } else { "cell" })),
        start.then(|| "the start".to_owned()),
        finish.then(|| "the finish".to_owned()),
    ]
    .into_iter()
    .flatten()
    .collect();
    match &lost[..] {
        [] => String::new(),
        [one] => format!("This cuts off {one}."),
        [most @ .., last] => format!("This cuts off {} and {last}.", most.join(", ")),
    }
}
