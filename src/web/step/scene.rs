//! The maze while a run goes on: line, trails, nodes, bot.

use crate::decimal::Decimal;
use crate::web::erase::{part, pointer, sig, wheel};
use leptos::html;
use leptos::prelude::*;

use crate::geometry::{Heading, Point, Ways};
use crate::ink::CellState;
use crate::maze::{Kind, Maze};
use crate::playback::Playback;
use crate::scene::{self, NodeMark, Pose, Shown, Trail};
use crate::web::maze_view::{Bot, Camera, Compass, ZoomButtons, finish_mark, name, size_of};
use crate::web::paths::{self, UNIT};
use crate::web::played::Played;
use crate::web::run_view::Run;
use crate::web::state::{Lab, Round, lab};

use super::walled;

/// More nodes than this are shown without their numbers.
pub const NUMBERED: usize = 300;

/// The trails' path data.
#[derive(Clone, Default, PartialEq)]
struct Drawn {
    remembered: String,
    given_up: String,
    crossed: String,
}

/// The picture of the run.
#[component]
pub fn Stage() -> impl IntoView {
    let lab = lab();
    let frame = NodeRef::<html::Div>::new();
    let bounds = Memo::new(move |_| lab.stage.with(|maze| maze.bounds()));
    let camera = Camera::new(size_of(frame), bounds, 100.0).beside_overlays();
    let stop = Memo::new(move |_| lab.moment.get().stop);
    let drawn = Memo::new(move |_| with_run(lab, |run| draw_trails(run, stop.get())));
    let picture = view! {
            <svg
                class="maze"
                class:walls=sig(move || walled::is(lab))
                viewBox=sig(move || camera.view_box())
                role="img"
                aria-label=sig(move || describe(lab, stop.get()))
                data-stop=sig(move || stop.get())
                data-crossed=sig(move || with_run(lab, |run| run.ink.crossed_cells(stop.get())))
            >
                <Defs />
                <Floor />
                <path class="solid" d=sig(move || lab.stage.with(|maze| walled::solid(maze, seen(lab, stop).as_deref()))) />
                <path class="tape" d=sig(move || tape(lab, stop)) />
                {part(move || (lab.round.get() == Round::Explore).then(|| view! {
                    <path class="remembered" d=sig(move || drawn.with(|d| d.remembered.clone())) />
                    <path class="given-up" d=sig(move || drawn.with(|d| d.given_up.clone())) />
                    <path class="crossed" stroke="url(#crosses)" d=sig(move || drawn.with(|d| d.crossed.clone())) />
                    <Driving />
                }))}
                {part(move || (lab.round.get() == Round::Solved).then(|| view! { <path class="route" d=sig(move || route(lab)) /> }))}
                <Ends camera=camera known=Box::new(move |at| with_run(lab, |run| run.solved() && run.ink.place(lab.moment.get().stop) == at)) />
                // Under the nodes, so that their numbers stay readable: nose and wheels look out.
                <Bot pose=Signal::derive(move || pose(lab)) pixel=Signal::derive(move || camera.pixel()) />
                <Nodes camera=camera />
                {part(move || (lab.round.get() == Round::Explore).then(|| {
                    let ways = Memo::new(move |_| open_ways(lab));
                    view! { <path class="open-way-halo" d=sig(move || ways.get()) /><path class="open-way" d=sig(move || ways.get()) /> }
                }))}
                {part(move || differs(lab))}
            </svg>
    };
    canvas(lab, camera, frame, picture.into_any())
}

/// The frame around a picture of the maze, which zooms and moves it.
pub fn canvas(lab: Lab, camera: Camera, frame: NodeRef<html::Div>, picture: AnyView) -> AnyView {
    let drag = RwSignal::new(None::<(i32, f64, f64)>);
    let on_wheel = move |event: web_sys::WheelEvent| {
        if event.ctrl_key() || lab.projector.get_untracked() || !camera.is_fitted() {
            event.prevent_default();
            let factor = (-event.delta_y() / 400.0).exp();
            camera.zoom(factor, Some((f64::from(event.offset_x()), f64::from(event.offset_y()))));
        }
    };
    view! {
        <div
            class="canvas"
            node_ref=frame
            class:zoomed=sig(move || !camera.is_fitted())
            class:far=sig(move || camera.is_far())
            style:--px=sig(move || Decimal(camera.pixel(), 3).to_string())
            on:wheel=wheel(on_wheel)
            on:pointerdown=pointer(move |event| {
                if !camera.is_fitted() {
                    drag.set(Some((event.pointer_id(), f64::from(event.client_x()), f64::from(event.client_y()))));
                }
            })
            on:pointermove=pointer(move |event| {
                let (x, y) = (f64::from(event.client_x()), f64::from(event.client_y()));
                if let Some((id, from_x, from_y)) = drag.get_untracked().filter(|drag| drag.0 == event.pointer_id()) {
                    camera.pan(x - from_x, y - from_y);
                    drag.set(Some((id, x, y)));
                }
            })
            on:pointerup=pointer(move |_| drag.set(None))
            on:pointercancel=pointer(move |_| drag.set(None))
        >
            {picture}
            <Compass north=Signal::derive(move || lab.north()) />
            <span class="zoom"><ZoomButtons camera=camera /></span>
        </div>
    }
    .into_any()
}

/// Something about the run; the default where there is none.
fn with_run<T: Default>(lab: Lab, of: impl FnOnce(&Run) -> T) -> T {
    lab.run.with(|run| run.as_ref().map_or_else(|_| T::default(), |run| of(run)))
}

/// Patterns: crosses on every cell, dots on every lattice point.
#[component]
pub fn Defs() -> impl IntoView {
    let cross = |x: i32, y: i32| format!("M{} {}l12 12m0-12l-12 12", x - 6, y - 6);
    let marks = [(13, 40), (67, 40), (40, 13), (40, 67)].map(|(x, y)| cross(x, y)).join("");
    let halo = marks.clone();
    view! {
        <defs>
            <pattern id="crosses" width=UNIT height=UNIT x=-UNIT / 2 y=-UNIT / 2 patternUnits="userSpaceOnUse">
                <path class="cross-halo" d=halo />
                <path class="cross-mark" d=marks />
            </pattern>
            <pattern id="dots" width=UNIT height=UNIT x=-UNIT / 2 y=-UNIT / 2 patternUnits="userSpaceOnUse">
                <circle class="dot" cx="40" cy="40" r="1.8" />
            </pattern>
        </defs>
    }
}

/// The lattice's points; the robot does not see them.
#[component]
pub fn Floor() -> impl IntoView {
    let lab = lab();
    let rect = move || {
        lab.stage.with(|maze| {
        let bounds = maze.bounds();
        let at = |v: i32| v * UNIT;
        let (w, h) = (bounds.width() as i32 * UNIT, bounds.height() as i32 * UNIT);
        view! { <rect x=at(bounds.sw().x) - UNIT / 2 y=-at(bounds.ne().y) - UNIT / 2 width=w height=h fill="url(#dots)" /> }
    })
    };
    part(move || (!lab.robots_eye.get() && lab.stage.with(|maze| maze.kind == Kind::Line)).then(rect))
}

/// What the robot has seen until now; none where all of the maze is shown. Only this changes from stop to stop.
fn seen(lab: Lab, stop: Memo<u32>) -> Option<Vec<(Point, Ways)>> {
    lab.robots_eye.get().then(|| {
        with_run(lab, |run| {
            let stop = if lab.round.get() == Round::Solved { run.trace.stops() } else { stop.get() };
            scene::seen_points(&run.maze, &run.ink, stop)
        })
    })
}

/// The line, or the walls: all of them, or what the robot has seen.
fn tape(lab: Lab, stop: Memo<u32>) -> String {
    let kind = lab.stage.with(|maze| maze.kind);
    let seen = (kind == Kind::Wall).then(|| seen(lab, stop)).flatten();
    if let Some(seen) = seen {
        return walled::seen_walls(&seen);
    }
    if kind == Kind::Wall || !lab.robots_eye.get() {
        return lab.stage.with(|maze| {
            let bounds = maze.bounds();
            paths::drawn(maze, (bounds.sw(), bounds.ne()))
        });
    }
    with_run(lab, |run| {
        let bounds = run.maze.bounds();
        let stop = if lab.round.get() == Round::Solved { run.trace.stops() } else { stop.get() };
        let driven = |at, heading| run.ink.cell((at, heading), stop) != CellState::Clean;
        let mut data = paths::cells((bounds.sw(), bounds.ne()), driven);
        for (at, ways) in scene::seen_points(&run.maze, &run.ink, stop) {
            for heading in ways.iter().filter(|&heading| !driven(at, heading)) {
                let (dx, dy) = heading.vector();
                let (x, y) = (at.x * UNIT, -at.y * UNIT);
                data.push_str(&format!("M{x} {y}l{} {}", dx * UNIT * 2 / 5, -dy * UNIT * 2 / 5));
            }
        }
        data
    })
}

fn draw_trails(run: &Run, stop: u32) -> Drawn {
    let bounds = run.maze.bounds();
    let corners = (bounds.sw(), bounds.ne());
    let index = |at: Point, heading: Heading| bounds.index(at).map(|i| i * 2 + usize::from(heading.index()));
    let mut trail = vec![None; bounds.len() * 2];
    for ((at, heading), shown) in scene::trails(&run.maze, &run.trace, &run.ink, stop) {
        if let Some(index) = index(at, heading) {
            trail[index] = Some(shown);
        }
    }
    let shown = |wanted: Trail| {
        paths::cells(corners, |at, heading| index(at, heading).is_some_and(|i| trail[i] == Some(wanted)))
    };
    Drawn {
        remembered: shown(Trail::Remembered),
        given_up: shown(Trail::GivenUp),
        crossed: shown(Trail::Crossed),
    }
}

/// The drive that goes on: remembered as the bot goes, or crossed out behind it.
#[component]
fn Driving() -> impl IntoView {
    let lab = lab();
    let path = Memo::new(move |_| {
        let shown = shown(lab);
        let stop = shown.moment.stop;
        if shown.along == 0.0 {
            return (String::new(), false);
        }
        with_run(lab, |run| {
            let pose = scene::pose(&run.trace, &run.ink, shown);
            let (from, unit) = (run.ink.place(stop), f64::from(UNIT));
            let data = format!(
                "M{} {}L{} {}",
                from.x * UNIT,
                -from.y * UNIT,
                Decimal(pose.x * unit, 1),
                Decimal(-pose.y * unit, 1)
            );
            (data, run.trace.state(stop).returning)
        })
    });
    view! {
        <path
            class=sig(move || if path.with(|path| path.1) { "crossed" } else { "remembered" })
            stroke=sig(move || path.with(|path| path.1.then_some("url(#crosses)")))
            d=sig(move || path.with(|path| path.0.clone()))
        />
    }
}

/// The unvisited ways that the sentence lists: an arrow out of its node each, no longer than what the robot sees.
fn open_ways(lab: Lab) -> String {
    let moment = lab.moment.get();
    let mut data = String::new();
    for (at, heading) in with_run(lab, |run| scene::listed_ways(&run.trace, &run.ink, moment)) {
        let (dx, dy) = heading.vector();
        let (x, y) = (at.x * UNIT, -at.y * UNIT);
        // Two chevrons, one behind the other.
        for tip in [28, 38] {
            let (tx, ty) = (x + dx * tip, y - dy * tip);
            data.push_str(&format!(
                "M{} {}L{tx} {ty}L{} {}",
                tx - dx * 9 - dy * 9,
                ty + dy * 9 - dx * 9,
                tx - dx * 9 + dy * 9,
                ty + dy * 9 + dx * 9
            ));
        }
    }
    data
}

/// Where robot and page decided differently for the first time: a dashed ring and ≠.
fn differs(lab: Lab) -> impl IntoView {
    lab.guest.with(|guest| {
        let guest = guest.as_ref()?;
        let stop = guest.differs.filter(|&stop| stop <= lab.moment.get().stop)?;
        let at = guest.run.ink.place(stop);
        Some(view! {
            <g class="differs" data-stop=stop transform=format!("translate({} {})", at.x * UNIT, -at.y * UNIT)>
                <circle r="34" />
                <circle class="plate" cx="-34" cy="-26" r="15" />
                <path d="M-40-29h12M-40-23h12M-31-34l-6 16" />
            </g>
        })
    })
}

/// The way of round 2.
pub fn route(lab: Lab) -> String {
    let points = |run: &dyn Played| {
        run.drive().map_or_else(String::new, |drive| {
            paths::line([drive.route.start].into_iter().chain(drive.route.legs.iter().map(|leg| leg.at)))
        })
    };
    lab.shown(points).unwrap_or_default()
}

/// Where the run is shown.
pub fn shown(lab: Lab) -> Shown {
    let shown = |playback: &Playback| Shown {
        moment: playback.moment(),
        along: playback.along(),
        bound: playback.bound(),
    };
    lab.playing().with(shown)
}

fn pose(lab: Lab) -> Pose {
    let shown = shown(lab);
    let posed = lab.run.with(|run| {
        let run = run.as_ref().ok()?;
        Some(match (lab.round.get(), &run.drive) {
            (Round::Solved, Some(drive)) => {
                scene::route_pose(&drive.route, run.ink.north(), shown.moment.stop, shown.along)
            }
            _ => scene::pose(&run.trace, &run.ink, shown),
        })
    });
    posed.unwrap_or_else(|| {
        let start = lab.stage.with(|maze| maze.start());
        let at = start.map_or_else(Point::default, |start| start.at);
        let degrees = start.map_or(0.0, |start| f64::from(start.heading.index()) * 90.0);
        Pose { x: f64::from(at.x), y: f64::from(at.y), degrees }
    })
}

/// Start and finish.
#[component]
pub fn Ends(
    camera: Camera,
    /// Whether the robot knows this finish; asked for the robot's eye only.
    known: Box<dyn Fn(Point) -> bool + Send>,
) -> impl IntoView {
    let lab = lab();
    let known = move |at: Point| !lab.robots_eye.get() || known(at);
    part(move || {
        let pixel = camera.pixel();
        lab.stage.with(|maze: &super::super::run_view::Same<Maze>| {
            let finish: Vec<Point> = maze.finish().iter().copied().filter(|&at| known(at)).collect();
            // Between walls there is no room for a name.
            let start = maze.start().filter(|_| maze.kind == Kind::Line).map(|start| {
                let ways = maze.ways(start.at).with(start.heading);
                name(start.at, scene::name_place(maze.bounds(), ways, start.at), 28.0, pixel, "start")
            });
            view! {
                {finish.into_iter().enumerate().map(|(i, at)| finish_mark(maze, at, i == 0, pixel)).collect_view()}
                {start}
            }
        })
    })
}

/// The remembered nodes. A long run has hundreds, and every stop may change them: they are one piece of
/// markup (numbers only), and a ring of its own shows the one that is pointed at.
#[component]
fn Nodes(camera: Camera) -> impl IntoView {
    let lab = lab();
    let nodes = Memo::new(move |_| match lab.round.get() {
        Round::Explore => with_run(lab, |run| scene::nodes(&run.trace, &run.ink, lab.moment.get())),
        Round::Solved => with_run(lab, |run| scene::nodes(&run.trace, &run.ink, run.trace.end())),
    });
    let here = move || lab.frame.with(|frame| frame.as_ref().map_or(0, |frame| frame.node));
    let numbered = Memo::new(move |_| camera.view().scale >= 16.0);
    let markup = move || {
        nodes.with(|nodes| match numbered.get() && nodes.len() <= NUMBERED {
            true => discs(nodes, here()),
            false => dots(nodes, here()),
        })
    };
    let lit = move || {
        let number = lab.lit.get()?;
        nodes.with(|nodes| nodes.iter().find(|node| node.number == number).copied())
    };
    let pointed_at = move |event: &web_sys::PointerEvent| {
        let (x, y) = camera.place(f64::from(event.offset_x()), f64::from(event.offset_y()));
        let at = Point::new(x.round() as i32, y.round() as i32);
        nodes.with_untracked(|nodes| nodes.iter().find(|node| node.at == at).map(|node| node.number))
    };
    view! {
        <g
            inner_html=sig(markup)
            on:pointermove=pointer(move |event| lab.lit.set(pointed_at(&event)))
            on:pointerout=pointer(move |_| lab.lit.set(None))
        ></g>
        {part(move || lit().map(|node| view! { <circle class="ring lit" data-node=node.number cx=node.at.x * UNIT cy=-node.at.y * UNIT r="20" /> }))}
    }
}

/// The nodes' numbered discs as SVG markup.
pub fn discs(nodes: &[NodeMark], here: u32) -> String {
    let mut markup = String::new();
    for NodeMark { number, at } in nodes {
        let class = if *number == here { "node here" } else { "node" };
        let (x, y) = (at.x * UNIT, -at.y * UNIT);
        markup.push_str(&format!(
            "<g class=\"{class}\" data-node=\"{number}\" transform=\"translate({x} {y})\"><circle class=\"disc\" r=\"17\"/><text y=\"6\">{number}</text></g>"
        ));
    }
    markup
}

/// Many nodes, or small ones: one shape for all of them, and one for where the bot is.
pub fn dots(nodes: &[NodeMark], here: u32) -> String {
    let shape = |class: &str, wanted: &dyn Fn(u32) -> bool| {
        let data: String = nodes
            .iter()
            .filter(|node| wanted(node.number))
            .map(|NodeMark { at, .. }| {
                format!("M{} {}a17 17 0 1 0 34 0a17 17 0 1 0-34 0", at.x * UNIT - 17, -at.y * UNIT)
            })
            .collect();
        format!("<g class=\"{class}\"><path class=\"disc\" d=\"{data}\"/></g>")
    };
    shape("node", &|number| number != here) + &shape("node here", &|number| number == here)
}

/// The picture in words.
fn describe(lab: Lab, stop: u32) -> String {
    with_run(lab, |run| {
        let at = run.ink.place(stop);
        let crossed = run.ink.crossed_cells(stop);
        let faces = run.trace.bot_dir(lab.moment.get()).word();
        format!(
            "Maze at stop {stop} of {}: the bot is at {at}, facing {faces}; {crossed} cells are crossed out",
            run.trace.stops()
        )
    })
}
