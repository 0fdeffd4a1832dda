//! Small pictures of all runs at the same moment, and where they part.

use crate::web::erase::{mouse, part, sig};
use leptos::html;
use leptos::prelude::*;

use super::desk::{Desk, Field, desk};
use super::open_in_stepper;
use crate::compare::abreast::Position;
use crate::compare::floor::Shown;
use crate::compare::forks::{Fork, letter};
use crate::compare::words;
use crate::explorer::name::Name;
use crate::geometry::{Heading, Point};
use crate::maze::{Bounds, Kind};
use crate::playback::Motion;
use crate::scene::Pose;
use crate::web::maze_view::{Bot, FAR, size_of};
use crate::web::paths::{self, UNIT};
use crate::web::step::walled;
use crate::web::viewport::Size;
use crate::web::{browser, icons};

/// The pictures.
#[component]
pub fn Pictures() -> impl IntoView {
    let desk = desk();
    // Those of the cells across begin beside the stroke.
    let cross = |x: i32, y: i32| format!("M{} {}l14 14m0-14l-14 14", x - 7, y - 7);
    let marks = [(15, 40), (65, 40), (40, 15), (40, 65)].map(|(x, y)| cross(x, y)).join("");
    view! {
        <svg class="vh maze" aria-hidden="true">
            <defs><pattern id="small-crosses" width=UNIT height=UNIT x=-UNIT / 2 y=-UNIT / 2 patternUnits="userSpaceOnUse">
                <path class="cross-halo" d=marks.clone() /><path class="cross-mark" d=marks />
            </pattern></defs>
        </svg>
        <section class="multi" aria-label="The runs at the same moment" data-count=sig(move || desk.names.with(Vec::len))>
            {part(move || desk.names.get().into_iter().enumerate().map(|(nth, name)| view! { <Picture nth=nth name=name /> }).collect_view())}
        </section>
    }
}

/// A letter that names a run, each with a shape of its own.
pub fn badge(nth: usize) -> impl IntoView {
    let letter = letter(nth);
    view! { <span class=format!("who {}", letter.to_ascii_lowercase())>{letter.to_string()}</span> }
}

/// An explorer's name, short enough for a small card.
pub fn called(desk: Desk, name: Name) -> String {
    match name {
        Name::Book => format!("Book, {}", desk.lab.settings.with(|settings| settings.order)),
        other => other.about().title.to_owned(),
    }
}

#[component]
fn Picture(nth: usize, name: Name) -> impl IntoView {
    let desk = desk();
    let frame = NodeRef::<html::Div>::new();
    let size = size_of(frame);
    let view = Memo::new(move |_| {
        let size = size.get();
        desk.lab.maze.with(|maze| View::of(maze.bounds(), maze.kind, size, browser::scaled_px()))
    });
    let pixel = Memo::new(move |_| view.get().pixel);
    let position = Memo::new(move |_| {
        let clock = desk.clock();
        desk.field.with(|field| {
            let position = field.position(nth, clock)?;
            if desk.lab.motion.get() == Motion::Smooth || position.along == 0.0 {
                return Some(position);
            }
            // Without motion, the robot stands where it stopped last.
            let run = &field.racer(nth)?.entrant.run;
            let stopped = clock.at_stop(&field.maze, run, &field.pace, position.stop);
            Some(Position { along: 0.0, pose: field.position(nth, stopped)?.pose, ..position })
        })
    });
    let stop = Memo::new(move |_| position.get().map_or(0, |position| position.stop));
    let missing = move || {
        desk.field.with(|field| field.entrants.get(nth).and_then(|(_, racer)| racer.as_ref().err().cloned()))
    };
    let told = Memo::new(move |_| {
        let stop = stop.get();
        desk.field.with(|field| {
            field.racer(nth).map_or_else(String::new, |racer| words::said(&racer.entrant.run, stop))
        })
    });
    let label = move || {
        let driven = position.get().map_or(0.0, |at| at.along);
        format!(
            "{}, {}: stop {}{}",
            letter(nth),
            called(desk, name),
            stop.get(),
            if driven > 0.0 { ", driving on" } else { "" }
        )
    };
    view! {
        <article class="card run" data-nth=nth data-stop=sig(move || stop.get())>
            <h2>
                {badge(nth)}<span class="name">{part(move || called(desk, name))}</span><span class="spacer"></span>
                <span class="small hide-m">{part(move || format!("stop {}", stop.get()))}</span>
                <button class="btn icon quiet" aria-label=format!("Open {} in Step, at this moment", letter(nth)) title="Open in Step, at this moment"
                    on:click=mouse(move |_| open_in_stepper(desk.lab, name, stop.get_untracked()))>{icons::open()}</button>
            </h2>
            <div class="floor" node_ref=frame class:far=sig(move || pixel.get() > FAR) style:--px=sig(move || format!("{:.3}", pixel.get()))>
            <svg class="maze" class:walls=sig(move || desk.lab.maze.with(|maze| maze.kind == Kind::Wall)) viewBox=sig(move || view.get().view_box()) role="img" aria-label=sig(label)>
                <path class="solid" d=sig(move || desk.lab.maze.with(|maze| walled::solid(maze, None))) />
                <path class="tape" d=sig(move || tape(desk)) />
                <path class="remembered" d=sig(move || trail(desk, nth, stop.get(), Shown::Driven)) />
                <path class="crossed" stroke="url(#small-crosses)" d=sig(move || trail(desk, nth, stop.get(), Shown::Crossed)) />
                <path class="remembered" d=sig(move || driving(desk, nth, position.get())) />
                {part(move || ends(desk, pixel.get()))}
                {part(move || desk.field.with(|field| shown_fork(desk, field).map(|fork| fork_mark(fork, nth, pixel.get()))))}
                {part(move || position.get().is_some().then(|| view! {
                    <Bot pose=sig(move || position.get().map_or(Pose { x: 0.0, y: 0.0, degrees: 0.0 }, |at| at.pose)) pixel=pixel />
                }))}
            </svg>
            </div>
            <p class="say">{part(move || missing().unwrap_or_else(|| told.get()))}</p>
        </article>
    }
}

/// What a picture shows: the whole lattice, and room for a robot at its edge.
#[derive(Clone, Copy, Default, PartialEq)]
struct View {
    /// Left, top, width and height in picture units.
    shown: [f64; 4],
    /// Picture units that look like one pixel at the browser's usual font size.
    pixel: f64,
}

impl View {
    /// In a picture of this size.
    fn of(bounds: Bounds, kind: Kind, size: Size, px: f64) -> Self {
        const LEAST: f64 = 36.0;
        const ROBOT_PX: f64 = 22.0;
        // Walls stand half a cell further out.
        let walls = if kind == Kind::Wall { f64::from(UNIT) / 2.0 } else { 0.0 };
        let [x, y, w, h] = {
            let (sw, ne) = (bounds.sw(), bounds.ne());
            [sw.x, -ne.y, ne.x - sw.x, ne.y - sw.y].map(|at| f64::from(at * UNIT))
        };
        let (w, h) = (w + 2.0 * walls, h + 2.0 * walls);
        let fit = |margin: f64, around_px: f64| {
            let units = |side: f64, px: f64| (side + 2.0 * margin) / (px - 2.0 * around_px).max(1.0);
            units(w, size.w).max(units(h, size.h))
        };
        let margin = LEAST.max(fit(0.0, ROBOT_PX * px) * ROBOT_PX * px);
        let out = margin + walls;
        Self { shown: [x - out, y - out, w + 2.0 * margin, h + 2.0 * margin], pixel: fit(margin, 0.0) * px }
    }

    fn view_box(self) -> String {
        self.shown.map(|side| format!("{side:.1}")).join(" ")
    }
}

fn tape(desk: Desk) -> String {
    desk.lab.maze.with(|maze| {
        let bounds = maze.bounds();
        paths::drawn(maze, (bounds.sw(), bounds.ne()))
    })
}

fn trail(desk: Desk, nth: usize, stop: u32, wanted: Shown) -> String {
    desk.field.with(|field| {
        let Some(racer) = field.racer(nth) else { return String::new() };
        let bounds = field.maze.bounds();
        paths::cells((bounds.sw(), bounds.ne()), |at, heading| {
            racer.floor.cell((at, heading), stop) == wanted
        })
    })
}

/// From the last stop to the robot.
fn driving(desk: Desk, nth: usize, position: Option<Position>) -> String {
    let Some(position) = position.filter(|position| position.along > 0.0) else { return String::new() };
    let from = desk.field.with(|field| field.racer(nth)?.floor.place(position.stop));
    let unit = f64::from(UNIT);
    from.map_or_else(String::new, |from| {
        format!(
            "M{} {}L{:.1} {:.1}",
            from.x * UNIT,
            -from.y * UNIT,
            position.pose.x * unit,
            -position.pose.y * unit
        )
    })
}

fn ends(desk: Desk, pixel: f64) -> impl IntoView {
    let size = 1.0 + pixel / 4.0;
    desk.lab.maze.with(|maze| {
        let at = |point: Point| format!("translate({} {}) scale({size:.2})", point.x * UNIT, -point.y * UNIT);
        let finish = maze.finish().iter().map(|&point| {
            view! { <rect class="finish" x="-18" y="-14" width="36" height="28" rx="3" transform=at(point) /> }
        });
        let start = maze.start().map(|start| view! { <circle class="from" r="9" transform=at(start.at) /> });
        view! { {finish.collect_view()}{start} }
    })
}

/// The parting that is shown: the last one that was passed, or else the first.
fn shown_fork(desk: Desk, field: &Field) -> Option<&Fork> {
    let (by, now) = (desk.by.get(), desk.now.get());
    let passed = |fork: &&Fork| field.fork_time(fork, by) <= now + 1e-9;
    field.forks.iter().rfind(passed).or_else(|| field.forks.first())
}

/// The diamond, and where this run goes on to.
fn fork_mark(fork: &Fork, nth: usize, pixel: f64) -> impl IntoView + use<> {
    let side = fork.sides.iter().find(|(who, _)| *who == nth).map(|(_, side)| *side);
    let (x, y, size) = (fork.at.x * UNIT, -fork.at.y * UNIT, (pixel * 0.45).max(1.0));
    let arrow = side.and_then(|side| side.leaves).map(|heading: Heading| {
        let turn = format!("rotate({})", u32::from(heading.index()) * 90);
        view! { <path class="went" transform=turn d="M0-26v-26m-13 13l13-14 13 14" /> }
    });
    side.map(|_| {
        view! { <g class="fork" transform=format!("translate({x} {y}) scale({size:.2})")><path class="diamond" d="M0-24L24 0 0 24-24 0z" />{arrow}</g> }
    })
}

/// The parting in words.
#[component]
pub fn Parting() -> impl IntoView {
    let desk = desk();
    let told = Memo::new(move |_| {
        desk.field.with(|field| {
            let first = field.forks.first().map(|fork| (fork.at, fork.cells));
            let shown = shown_fork(desk, field)?;
            let title = if first == Some((shown.at, shown.cells)) { "First parting" } else { "Parting" };
            Some((title, shown.words(), field.fork_time(shown, desk.by.get()), field.forks.len()))
        })
    });
    view! {
        <section class="note warn parting" aria-label="Where the runs part" aria-live="polite">
            <span class="mark warn"><svg viewBox="0 0 22 22" aria-hidden="true"><path d="M11 2l9 9-9 9-9-9z" /></svg></span>
            <div class="row">
                {part(move || match told.get() {
                    Some((title, words, time, count)) => view! {
                        <p><b>{title}". "</b>{words}</p>
                        <span class="spacer"></span>
                        <button class="btn" on:click=mouse(move |_| desk.seek(time))>"Go there"</button>
                        {(count > 1).then(|| view! {
                            <button class="btn" title="The next place where two of them part (N)" on:click=mouse(move |_| desk.next_fork())>"Next parting"</button>
                        })}
                    }.into_any(),
                    None => view! { <p>{desk.field.with(|field| match field.runs().count() {
                        all if all == field.entrants.len() => "All of them drive the same way to the end.",
                        0 | 1 => "Two have to drive before they can part.",
                        _ => "Where they part is marked once all of them can start.",
                    })}</p> }.into_any(),
                })}
            </div>
        </section>
    }
}
