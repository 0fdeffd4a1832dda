//! Below the drawing: what is going on there, in words that are also read aloud, and the zoom.

use crate::web::erase::{mouse, part, sig};
use leptos::prelude::*;

use super::desk::{Desk, desk, many};
use crate::geometry::Point;
use crate::gesture::{Doing, Finishing, Tool};
use crate::maze::Kind;
use crate::web::icons;

/// Pixels a cell at 100 %.
const WHOLE: f64 = 48.0;

/// The bar.
#[component]
pub fn Foot() -> impl IntoView {
    let desk = desk();
    let said = Memo::new(move |_| say(desk));
    view! {
        <div class="bar foot">
            <span class="status" role="status" id="draw-status">
                <b>{part(move || said.with(|said| said.0.clone()))}</b>
                {part(move || said.with(|said| said.1.clone()))}
            </span>
            {part(move || (desk.tool.get() == Tool::Finish).then(|| view! { <Further /> }))}
            <span class="hide-m small">{part(move || hint(desk))}</span>
            <span class="spacer"></span>
            <Zoom />
        </div>
    }
}

/// Whether the finish tool puts further points: what Shift does with a mouse.
#[component]
fn Further() -> impl IntoView {
    let desk = desk();
    let on = move || desk.finishing.get() == Finishing::Further;
    let toggle = move |_| {
        desk.finishing.update(|finishing| {
            *finishing = match finishing {
                Finishing::Only => Finishing::Further,
                Finishing::Further => Finishing::Only,
            };
        });
    };
    view! {
        <button class="btn" aria-pressed=sig(move || on().to_string()) title="Each press adds a finish point or takes it away (Shift)" on:click=mouse(toggle)>
            "Several"
        </button>
    }
}

/// What the hand does, or what is at the keyboard's place, or what the tool does.
fn say(desk: Desk) -> (String, String) {
    let said = |what: &str, more: String| (what.to_owned(), more);
    desk.doing.with(|doing| match doing {
        Doing::Line(path) => match (path.first(), path.last()) {
            (Some(from), Some(to)) => said("Drawing ", format!("{from} → {to}")),
            _ => said("Drawing", String::new()),
        },
        Doing::Erase(cells) => said("Erasing ", many(cells.len(), "cell")),
        Doing::Wall(posts) => said("Building ", many(posts.len().saturating_sub(1), "wall")),
        Doing::Open(walls) => said("Opening ", many(walls.len(), "wall")),
        Doing::Start(start) => said("Start ", format!("at {} facing {}", start.at, start.heading.word())),
        Doing::Finish(points) => match points[..] {
            [] => said("No finish", String::new()),
            [at] => said("Finish ", format!("at {at}")),
            _ => said("Finish ", format!("at {} places", points.len())),
        },
        Doing::Pan | Doing::Pinch => said("Moving the paper", String::new()),
        Doing::LetGo => said("Let go", String::new()),
        Doing::Nothing if desk.by_keyboard.get() => {
            let at = desk.cursor.get();
            (format!("{at}: "), there(desk, at))
        }
        Doing::Nothing => {
            let (what, how) = use_of(desk.held_tool(), desk.kind());
            said(what, how.to_owned())
        }
    })
}

/// A tool's name, and how it is used.
const fn use_of(tool: Tool, kind: Kind) -> (&'static str, &'static str) {
    match (tool, kind) {
        (Tool::Line, Kind::Line) => ("Line: ", "drag from point to point"),
        (Tool::Line, Kind::Wall) => ("Wall: ", "drag from post to post, or press a wall"),
        (Tool::Erase, Kind::Line) => ("Erase: ", "drag along lines"),
        (Tool::Erase, Kind::Wall) => ("Open: ", "drag along walls"),
        (Tool::Start, Kind::Line) => ("Start: ", "press a line’s end"),
        (Tool::Start, Kind::Wall) => ("Start: ", "press a square"),
        (Tool::Finish, Kind::Line) => ("Finish: ", "press a point"),
        (Tool::Finish, Kind::Wall) => ("Finish: ", "press a square"),
        (Tool::Move, _) => ("Move: ", "drag the paper"),
    }
}

/// What is at a point.
fn there(desk: Desk, at: Point) -> String {
    desk.lab.maze.with(|maze| {
        let ways: Vec<&str> = maze.ways(at).iter().map(|heading| heading.word()).collect();
        let (none, some) = match maze.kind {
            Kind::Line => ("no line", "line"),
            Kind::Wall => ("walls all round", "open"),
        };
        let mut text = match &ways[..] {
            [] => none.to_owned(),
            [one] => format!("{some} to the {one}"),
            [most @ .., last] => format!("{some} to the {} and {last}", most.join(", ")),
        };
        if let Some(start) = maze.start().filter(|start| start.at == at) {
            text += &format!("; start, facing {}", start.heading.word());
        }
        if maze.is_finish(at) {
            text += "; finish";
        }
        text
    })
}

fn hint(desk: Desk) -> AnyView {
    match desk.doing.get() {
        Doing::Line(_)
        | Doing::Erase(_)
        | Doing::Wall(_)
        | Doing::Open(_)
        | Doing::Start(_)
        | Doing::Finish(_) => view! { "let go to keep · " <kbd>"Esc"</kbd> " takes it back" }.into_any(),
        Doing::Nothing | Doing::Pan | Doing::Pinch | Doing::LetGo => {
            let (key, what) = match desk.kind() {
                Kind::Line => ("Shift", " draw"),
                Kind::Wall => ("Alt", " open"),
            };
            view! {
                <span class="hide-l">"Keyboard: " <kbd>"arrows"</kbd> " go · " <kbd>{key}</kbd> " + " <kbd>"arrows"</kbd> {what}</span>
            }
            .into_any()
        }
    }
}

#[component]
fn Zoom() -> impl IntoView {
    let camera = desk().camera;
    let percent = move || format!("{:.0} %", camera.view().scale / WHOLE * 100.0);
    let whole = move |_| camera.zoom(WHOLE / untrack(|| camera.view()).scale, None);
    view! {
        <span class="group" role="group" aria-label="Zoom">
            <button class="btn icon" aria-label="Zoom out (−)" title="Zoom out (−)" on:click=mouse(move |_| camera.zoom(0.8, None))>{icons::minus()}</button>
            <button class="btn percent" title="Zoom to 100 %" on:click=mouse(whole)><span class="vh">"Zoom to 100 %, now "</span>{percent}</button>
            <button class="btn icon" aria-label="Zoom in (+)" title="Zoom in (+)" on:click=mouse(move |_| camera.zoom(1.25, None))>{icons::plus()}</button>
            <button class="btn" title="Show all of it (0)" disabled=sig(move || camera.is_fitted()) on:click=mouse(move |_| camera.fit())>"Fit"</button>
        </span>
    }
}
