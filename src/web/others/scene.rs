//! The maze while a run goes on: what was driven once and again, the path that is kept, numbers and marks, the bot.

use std::fmt::Write;

use leptos::html;
use leptos::prelude::*;

use super::Watched;
use super::run::OtherRun;
use crate::geometry::{Point, Ways};
use crate::recording::driven::Times;
use crate::recording::moment::At;
use crate::scene::{self, Pose, recorded};
use crate::trace::Moment;
use crate::web::erase::{part, sig};
use crate::web::maze_view::{Bot, Camera, size_of};
use crate::web::paths::{self, UNIT};
use crate::web::state::{Lab, Round, lab};
use crate::web::step::scene::{Defs, Ends, Floor, NUMBERED, canvas, discs, dots, route, shown};
use crate::web::step::walled;

/// The picture of the run.
pub fn stage(watched: Watched) -> AnyView {
    let lab = lab();
    let frame = NodeRef::<html::Div>::new();
    let bounds = Memo::new(move |_| lab.maze.with(|maze| maze.bounds()));
    let camera = Camera::new(size_of(frame), bounds, 100.0).beside_overlays();
    let stop = Memo::new(move |_| lab.moment.get().stop);
    let trail = move |times: Times| {
        watched.of(|run| {
            let bounds = run.maze.bounds();
            let stop = stop.get();
            paths::cells((bounds.sw(), bounds.ne()), |at, heading| {
                run.driven.times((at, heading), stop) == times
            })
        })
    };
    let known = Box::new(move |at| watched.of(|run| run.driven.passed(at, stop.get())));
    let large = Memo::new(move |_| camera.view().scale >= 16.0);
    let readable = Memo::new(move |_| camera.view().scale >= 38.0);
    let picture = view! {
        <svg
            class="maze"
            class:walls=sig(move || walled::is(lab))
            viewBox=sig(move || camera.view_box())
            role="img"
            aria-label=sig(move || watched.of(|run| describe(run, lab.moment.get())))
            data-stop=sig(move || stop.get())
        >
            <Defs />
            <Floor />
            <path class="solid" d=sig(move || solid(lab, watched, stop)) />
            <path class="tape" d=sig(move || tape(lab, watched, stop)) />
            {part(move || (lab.round.get() == Round::Explore).then(|| view! {
                <path class="remembered" d=sig(move || trail(Times::Once)) />
                <path class="given-up" d=sig(move || trail(Times::Again)) />
                <path class="route" d=sig(move || watched.at(|run, at| paths::line(recorded::path(&run.recording, &at.mind)))) />
                <path class="remembered" d=sig(move || driving(lab, watched)) />
            }))}
            {part(move || (lab.round.get() == Round::Solved).then(|| view! { <path class="route" d=sig(move || route(lab)) /> }))}
            <Ends camera=camera known=known />
            <g class="marks" inner_html=sig(move || watched.at(marks))></g>
            <g class="square-names" aria-hidden="true" inner_html=sig(move || if readable.get() { watched.at(names) } else { String::new() })></g>
            <Bot pose=Signal::derive(move || pose(lab, watched)) pixel=Signal::derive(move || camera.pixel()) />
            <g inner_html=sig(move || watched.at(|run, at| nodes(run, at, large.get())))></g>
        </svg>
    };
    canvas(lab, camera, frame, picture.into_any())
}

/// What the strokes mean.
pub fn legend(watched: Watched) -> AnyView {
    let path =
        Memo::new(move |_| watched.at(|_, at| matches!(at.mind, crate::explorer::mind::Mind::Parex(_))));
    let stroke = |class: &'static str, word: &'static str| {
        view! {
            <span>
                <svg class="maze" width="26" height="14" viewBox="0 0 52 28"><path class="tape" d="M8 14h36" /><path class=class d="M8 14h36" /></svg>
                {word}
            </span>
        }
    };
    view! {
        <span class="legend hide-l" aria-hidden="true">
            {stroke("", "line")}
            {stroke("remembered", "driven once")}
            {stroke("given-up", "driven again")}
            {part(move || path.get().then(|| stroke("route", "path")))}
        </span>
    }
    .into_any()
}

/// The places that the robot has stood on or passed, in order, with their ways; none where all is shown.
fn seen(lab: Lab, watched: Watched, stop: u32) -> Option<Vec<(Point, Ways)>> {
    lab.robots_eye.get().then(|| {
        watched.of(|run| {
            let mut seen: Vec<_> = run
                .maze
                .bounds()
                .points()
                .filter(|&at| run.driven.passed(at, stop))
                .map(|at| (at, run.maze.ways(at)))
                .collect();
            seen.sort_unstable_by_key(|square| square.0);
            seen
        })
    })
}

/// The stop up to which the robot has seen things.
fn seen_until(lab: Lab, watched: Watched, stop: Memo<u32>) -> u32 {
    match lab.round.get() {
        Round::Solved => watched.of(|run| run.recording.stops()),
        Round::Explore => stop.get(),
    }
}

/// What is solid in a maze of walls.
fn solid(lab: Lab, watched: Watched, stop: Memo<u32>) -> String {
    let seen = seen(lab, watched, seen_until(lab, watched, stop));
    lab.maze.with(|maze| walled::solid(maze, seen.as_deref()))
}

/// The line, or the walls: all of them, or what the robot has seen.
fn tape(lab: Lab, watched: Watched, stop: Memo<u32>) -> String {
    if !lab.robots_eye.get() {
        return lab.maze.with(|maze| {
            let bounds = maze.bounds();
            paths::drawn(maze, (bounds.sw(), bounds.ne()))
        });
    }
    let stop = seen_until(lab, watched, stop);
    if walled::is(lab) {
        return walled::seen_walls(&seen(lab, watched, stop).unwrap_or_default());
    }
    watched.of(|run| {
        let bounds = run.maze.bounds();
        let driven = |at, heading| run.driven.times((at, heading), stop) != Times::Never;
        let mut data = paths::cells((bounds.sw(), bounds.ne()), driven);
        for at in bounds.points().filter(|&at| run.driven.passed(at, stop)) {
            for heading in run.maze.ways(at).iter().filter(|&heading| !driven(at, heading)) {
                let (dx, dy) = heading.vector();
                let part = UNIT * 2 / 5;
                let _ = write!(data, "M{} {}l{} {}", at.x * UNIT, -at.y * UNIT, dx * part, -dy * part);
            }
        }
        data
    })
}

/// The drive that goes on.
fn driving(lab: Lab, watched: Watched) -> String {
    let shown = shown(lab);
    if shown.along == 0.0 {
        return String::new();
    }
    watched.of(|run| {
        let pose = recorded::pose(&run.recording, shown);
        let (from, unit) = (run.recording.place(shown.moment.stop), f64::from(UNIT));
        format!("M{} {}L{:.1} {:.1}", from.x * UNIT, -from.y * UNIT, pose.x * unit, -pose.y * unit)
    })
}

fn pose(lab: Lab, watched: Watched) -> Pose {
    let shown = shown(lab);
    let posed = watched.of(|run| {
        Some(match (lab.round.get(), &run.drive) {
            (Round::Solved, Some(drive)) => {
                let north = run.recording.start().heading;
                scene::route_pose(&drive.route, north, shown.moment.stop, shown.along)
            }
            _ => recorded::pose(&run.recording, shown),
        })
    });
    posed.unwrap_or(Pose { x: 0.0, y: 0.0, degrees: 0.0 })
}

/// The numbered places.
fn nodes(run: &OtherRun, at: &At, large: bool) -> String {
    let nodes = recorded::nodes(&run.recording, &at.mind);
    let here = nodes.iter().find(|node| node.at == at.stop.at).map_or(u32::MAX, |node| node.number);
    if large && nodes.len() <= NUMBERED { discs(&nodes, here) } else { dots(&nodes, here) }
}

/// Trémaux's chalk: a bar across the way for every mark.
fn marks(run: &OtherRun, at: &At) -> String {
    let mut data = String::new();
    for (at, way, count) in recorded::marks(&run.recording, &at.mind) {
        let (dx, dy) = way.vector();
        for i in 0..i32::from(count) {
            let (x, y) = (at.x * UNIT + dx * (25 + 8 * i), -at.y * UNIT - dy * (25 + 8 * i));
            let _ = write!(data, "M{} {}l{} {}", x - dy * 11, y - dx * 11, dy * 22, dx * 22);
        }
    }
    format!("<path class=\"chalk-halo\" d=\"{data}\"/><path class=\"chalk\" d=\"{data}\"/>")
}

/// What a square explorer calls its squares: flood fill all, the others those that it was on.
fn names(run: &OtherRun, at: &At) -> String {
    let all = matches!(at.mind, crate::explorer::mind::Mind::FloodFill(_));
    let mut markup = String::new();
    for point in run.maze.bounds().points() {
        if !all && !run.driven.passed(point, at.stop.stop) {
            continue;
        }
        let Some(name) = recorded::square_name(&run.recording, &at.mind, point) else { return String::new() };
        let (x, y) = (point.x * UNIT + 34, -point.y * UNIT - 20);
        let _ = write!(markup, "<text class=\"label\" text-anchor=\"end\" x=\"{x}\" y=\"{y}\">{name}</text>");
    }
    markup
}

/// The picture in words; directions are the robot's own, as in its sentences.
fn describe(run: &OtherRun, moment: Moment) -> String {
    let Point { x, y } = run.recording.place(moment.stop);
    let faces = recorded::faces(&run.recording, moment).in_frame_of(run.recording.start().heading);
    format!(
        "Maze at stop {} of {}: the bot is at {x},{y}, facing {}",
        moment.stop,
        run.recording.stops(),
        faces.word()
    )
}
