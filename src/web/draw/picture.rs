//! What is on the paper: points, line, start, finish, what a hand is doing, and what a check points to.

use crate::web::erase::{part, sig};
use leptos::prelude::*;

use super::desk::{Desk, desk, many};
use crate::geometry::{Heading, Point};
use crate::gesture::Doing;
use crate::maze::checks::Finding;
use crate::maze::{Bounds, Kind, Start};
use crate::scene::name_place;
use crate::web::maze_view::{Label, finish_mark, name};
use crate::web::paths::{self, UNIT};

/// Picture units from the start to its handle.
pub const HANDLE_ARM: f64 = 40.0;

/// How much larger the start's marker is drawn, so that a finger can take its handle. Between walls it has to
/// stay in its square.
#[must_use]
pub fn marker_scale(kind: Kind, pixel: f64) -> f64 {
    match kind {
        Kind::Line => (0.65 * pixel).max(1.0),
        Kind::Wall => 0.62,
    }
}

/// The picture.
#[component]
pub fn Picture() -> impl IntoView {
    let desk = desk();
    view! {
        <svg class="maze" class:walls=sig(move || desk.kind() == Kind::Wall) viewBox=sig(move || desk.camera.view_box()) aria-hidden="true">
            <defs>
                <pattern id="draw-dots" width=UNIT height=UNIT x=-UNIT / 2 y=-UNIT / 2 patternUnits="userSpaceOnUse">
                    <circle class="dot" cx=UNIT / 2 cy=UNIT / 2 r="3" />
                </pattern>
            </defs>
            <Paper />
            <Tape />
            <Axes />
            <Shown />
            <Finish />
            <StartMarker />
            <Preview />
            <Cursor />
        </svg>
    }
}

/// A part of the lattice with a margin, as x, y, width and height in picture units.
fn frame(part: Bounds, margin: i32) -> [i32; 4] {
    [
        part.sw().x * UNIT - margin,
        -part.ne().y * UNIT - margin,
        (part.ne().x - part.sw().x) * UNIT + 2 * margin,
        (part.ne().y - part.sw().y) * UNIT + 2 * margin,
    ]
}

/// The lattice's edge and points.
#[component]
fn Paper() -> impl IntoView {
    let desk = desk();
    let bounds = Memo::new(move |_| desk.lab.maze.with(|maze| maze.bounds()));
    // Points nearer than this to each other would only be grey.
    let dotted = Memo::new(move |_| desk.camera.view().scale >= 7.0);
    let kind = Memo::new(move |_| desk.kind());
    part(move || {
        let [x, y, w, h] = frame(bounds.get(), UNIT / 2);
        // Walls have their posts, and their own edge.
        if kind.get() == Kind::Wall {
            return ().into_any();
        }
        let fill = if dotted.get() { "url(#draw-dots)" } else { "none" };
        view! { <rect class="paper-edge" x=x y=y width=w height=h rx="18" fill=fill /> }.into_any()
    })
}

/// Numbers along the lower and the left edge; they stay in the picture.
#[component]
fn Axes() -> impl IntoView {
    let desk = desk();
    let numbers = move || {
        let (view, size, bounds) =
            (desk.camera.view(), desk.camera.size.get(), desk.lab.maze.with(|maze| maze.bounds()));
        let step = [5, 10, 20, 50, 100]
            .into_iter()
            .find(|&step| f64::from(step) * view.scale >= 34.0)
            .unwrap_or(200);
        let (left, top) = view.to_lattice(size, 0.0, 0.0);
        let (right, bottom) = view.to_lattice(size, size.w, size.h);
        let lattice = |px: f64| px / view.scale;
        let below = (f64::from(bounds.sw().y) - 0.5 - lattice(18.0)).max(bottom + lattice(8.0));
        let beside = (f64::from(bounds.sw().x) - 0.5 - lattice(8.0)).max(left + lattice(26.0));
        let within = |low: i32, high: i32, from: f64, to: f64| {
            let (first, last) = (low.max(from.ceil() as i32), high.min(to.floor() as i32));
            (first..=last).filter(move |v| v.rem_euclid(step) == 0)
        };
        let along =
            within(bounds.sw().x, bounds.ne().x, left, right).map(|x| (x, f64::from(x), below, "middle"));
        let up = within(bounds.sw().y, bounds.ne().y, bottom, top)
            .map(|y| (y, beside, f64::from(y) - lattice(5.0), "end"));
        let pixel = desk.camera.pixel();
        along
            .chain(up)
            .map(|(number, x, y, anchor)| {
                let unit = f64::from(UNIT);
                let place = format!("translate({:.2} {:.2}) scale({pixel:.4})", x * unit, -y * unit);
                view! { <text class="axis" text-anchor=anchor transform=place>{number}</text> }
            })
            .collect_view()
    };
    view! { <g>{numbers}</g> }
}

/// The line, or walls and closed squares, in tiles: an edit draws only the tiles anew that it changes.
#[component]
fn Tape() -> impl IntoView {
    let desk = desk();
    let bounds = Memo::new(move |_| desk.lab.maze.with(|maze| maze.bounds()));
    let tile = move |corners: (Point, Point)| {
        let data = Memo::new(move |_| desk.lab.maze.with(|maze| paths::drawn(maze, corners)));
        let solid = Memo::new(move |_| {
            desk.lab.maze.with(|maze| match maze.kind {
                Kind::Line => String::new(),
                Kind::Wall => paths::squares(corners, |at| maze.ways(at).is_empty()),
            })
        });
        view! {
            <path class="solid" d=sig(move || solid.get()) />
            <path class="tape" d=sig(move || data.get()) />
        }
    };
    part(move || paths::tiles(bounds.get()).into_iter().map(tile).collect_view())
}

/// The finish points.
#[component]
fn Finish() -> impl IntoView {
    let desk = desk();
    let points = Memo::new(move |_| match desk.doing.get() {
        Doing::Finish(points) => points,
        _ => desk.lab.maze.with(|maze| maze.finish().to_vec()),
    });
    part(move || {
        let pixel = desk.camera.pixel();
        points
            .get()
            .into_iter()
            .enumerate()
            .map(|(i, at)| desk.lab.maze.with(|maze| finish_mark(maze, at, i == 0, pixel)))
            .collect_view()
    })
}

/// The start with the handle that turns it.
#[component]
fn StartMarker() -> impl IntoView {
    let desk = desk();
    let start = Memo::new(move |_| match desk.doing.get() {
        Doing::Start(start) => Some(start),
        _ => desk.lab.maze.with(|maze| maze.start()),
    });
    let mark = move |Start { at, heading }: Start| {
        let place = move || {
            format!(
                "translate({} {}) scale({:.3})",
                at.x * UNIT,
                -at.y * UNIT,
                marker_scale(desk.kind(), desk.camera.pixel())
            )
        };
        // Between walls there is no room for a name; elsewhere it stands off the ring and its handle.
        let label = move || {
            let pixel = desk.camera.pixel();
            let place = desk.lab.maze.with(|maze| name_place(maze.bounds(), maze.ways(at).with(heading), at));
            (desk.kind() == Kind::Line)
                .then(|| name(at, place, HANDLE_ARM * marker_scale(Kind::Line, pixel), pixel, "start"))
        };
        view! {
            <g class="start" transform=place>
                <circle class="ring" r=HANDLE_ARM />
                <g transform=format!("rotate({})", u32::from(heading.index()) * 90)>
                    <circle class="disc-start" r="14" />
                    <path class="nose" d="M0-6l5.5 10h-11z" />
                    <g transform=format!("translate(0 {})", -HANDLE_ARM)>
                        <circle class="handle" r="13" />
                        <path class="arrow" d="M0 5V-5M-4-1l4-4.5L4-1" />
                    </g>
                </g>
            </g>
            {label}
        }
    };
    part(move || start.get().map(mark))
}

/// What the hand is doing: a line under way, or cells that will go.
#[component]
fn Preview() -> impl IntoView {
    let desk = desk();
    part(move || {
        desk.doing.with(|doing| match doing {
            Doing::Line(path) => Some(line(desk, path).into_any()),
            Doing::Erase(cells) => Some(erasing(cells, "").into_any()),
            // Posts stand half a cell to the south-west of their squares' middles.
            Doing::Wall(posts) => Some(view! { <g transform=POSTS>{line(desk, posts)}</g> }.into_any()),
            Doing::Open(walls) => Some(erasing(walls, POSTS).into_any()),
            Doing::Nothing
            | Doing::Start(_)
            | Doing::Finish(_)
            | Doing::Pan
            | Doing::Pinch
            | Doing::LetGo => None,
        })
    })
}

/// From squares to their posts, in picture units.
const POSTS: &str = "translate(-40 40)";

/// The line that is under way: dashed, with rings at its ends and its length.
fn line(desk: Desk, path: &[Point]) -> impl IntoView + use<> {
    let data = paths::line(path.iter().copied());
    let (under, cells) = (data.clone(), path.len() - 1);
    let end = |at: Option<&Point>| at.map_or((0, 0), |at| (at.x * UNIT, -at.y * UNIT));
    let ((x0, y0), (x1, y1)) = (end(path.first()), end(path.last()));
    let middle = end(path.get(path.len() / 2).filter(|_| cells > 1).or(path.first()));
    let middle = if cells == 1 { ((x0 + x1) / 2, (y0 + y1) / 2) } else { middle };
    let tag = move || {
        let pixel = desk.camera.pixel();
        let place = format!("translate({} {}) scale({pixel:.4})", middle.0, middle.1);
        view! {
            <g class="tag" transform=place>
                <rect x="-38" y="-42" width="76" height="26" rx="8" />
                <text y="-24">{many(cells, if desk.kind() == Kind::Wall { "wall" } else { "cell" })}</text>
            </g>
        }
    };
    view! {
        <path class="drawn-under" d=under />
        <path class="drawn" d=data />
        <circle class="drawn-end" cx=x0 cy=y0 r="10" />
        <circle class="drawn-end" cx=x1 cy=y1 r="14" />
        {(cells > 0).then_some(tag)}
    }
}

fn erasing(cells: &[(Point, Heading)], moved: &'static str) -> impl IntoView + use<> {
    let data: String = cells.iter().map(|&(at, heading)| paths::line([at, at.step(heading)])).collect();
    let dashes = data.clone();
    view! {
        <g transform=moved>
            <path class="erased-under" d=data />
            <path class="erased" d=dashes />
        </g>
    }
}

/// The place that a check points to.
#[component]
fn Shown() -> impl IntoView {
    let desk = desk();
    let mark = move |finding: Finding| {
        let [x, y, w, h] = frame(finding.place()?, 40);
        let corner = move || format!("translate({x} {y}) scale({:.3})", desk.camera.pixel().max(0.6));
        let label = move || {
            let pixel = desk.camera.pixel();
            view! { <Label x=f64::from(x) + 8.0 y=f64::from(y + h) + 12.0 * pixel pixel=pixel text=word(&finding, desk.kind()) /> }
        };
        Some(view! {
            <g class="shown">
                <rect class="dotted" x=x y=y width=w height=h rx="20" />
                <g transform=corner>
                    <path class="triangle" d="M0-15L17 13H-17z" />
                    <path class="mark" d="M0-5v8M0 8v.1" />
                </g>
                {label}
            </g>
        })
    };
    part(move || desk.shown.get().and_then(mark))
}

/// A finding in a word or two, for the drawing.
const fn word(finding: &Finding, kind: Kind) -> &'static str {
    match finding {
        Finding::StartOffLine(_) | Finding::FinishOffLine(_) if matches!(kind, Kind::Wall) => "walled in",
        Finding::StartFacesWall { .. } => "faces a wall",
        Finding::StartFacesAway { .. } if matches!(kind, Kind::Wall) => "faces a wall",
        Finding::StartNotAtEnd { .. } if matches!(kind, Kind::Wall) => "several ways",
        Finding::Apart(_) => "apart",
        Finding::FinishUnreachable { .. } => "no way there",
        Finding::StartOffLine(_) | Finding::FinishOffLine(_) => "no line here",
        Finding::StartNotAtEnd { .. } => "not a line’s end",
        Finding::StartFacesAway { .. } => "faces off its line",
        Finding::FinishOnStart(_) => "start and finish",
        Finding::NoLines | Finding::NoStart | Finding::NoFinish => "",
    }
}

/// The keyboard's place.
#[component]
fn Cursor() -> impl IntoView {
    let desk = desk();
    let ring = move || {
        let at = desk.cursor.get();
        let place =
            format!("translate({} {}) scale({:.4})", at.x * UNIT, -at.y * UNIT, desk.camera.pixel().max(0.8));
        view! {
            <g class="cursor" transform=place>
                <circle class="under" r="15" />
                <circle r="15" />
                <path d="M0-20v7M0 20v-7M-20 0h7M20 0h-7" />
            </g>
        }
    };
    part(move || desk.by_keyboard.get().then_some(ring))
}
