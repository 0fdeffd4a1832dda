//! Pieces of a maze's picture that Draw and Step share: the frame that pans and zooms, finish, compass, bot.

use crate::decimal::Decimal;
use crate::web::erase::{mouse, sig};
use leptos::html;
use leptos::prelude::*;
use wasm_bindgen::JsCast;
use wasm_bindgen::prelude::*;

use super::browser;
use super::paths::UNIT;
use super::state::lab;
use super::viewport::{Overlays, Size, Viewport};
use crate::geometry::{Heading, Point};
use crate::maze::{Bounds, Kind, Maze};
use crate::scene::{NamePlace, Pose, name_place};

#[wasm_bindgen]
extern "C" {
    /// Tells when an element changes its size.
    type ResizeObserver;
    #[wasm_bindgen(constructor)]
    fn new(callback: &js_sys::Function) -> ResizeObserver;
    #[wasm_bindgen(method)]
    fn observe(this: &ResizeObserver, element: &web_sys::Element);
    #[wasm_bindgen(method)]
    fn disconnect(this: &ResizeObserver);
}

/// Picture units a pixel from which on lines get too thin to have anything drawn on them: trails then are as wide
/// as can be seen, and stand over the line (`.far` in the style sheets).
pub const FAR: f64 = 4.2;

/// The size of an element, as it changes.
pub fn size_of(element: NodeRef<html::Div>) -> ReadSignal<Size> {
    let (size, set_size) = signal(Size { w: 800.0, h: 600.0 });
    Effect::new(move |_| {
        let Some(element) = element.get() else { return };
        let measured = element.clone();
        let measure = Closure::<dyn FnMut()>::new(move || {
            let (w, h) = (f64::from(measured.client_width()), f64::from(measured.client_height()));
            if w > 0.0 && h > 0.0 {
                set_size.set(Size { w, h });
            }
        });
        let observer = ResizeObserver::new(measure.as_ref().unchecked_ref());
        observer.observe(&element);
        let held = StoredValue::new_local(Some((observer, measure)));
        on_cleanup(move || {
            if let Some((observer, _)) = held.try_update_value(Option::take).flatten() {
                observer.disconnect();
            }
        });
    });
    size
}

/// A viewport that shows everything until someone moves it.
#[derive(Clone, Copy)]
pub struct Camera {
    /// The picture's size.
    pub size: ReadSignal<Size>,
    /// Pixels that stand for one at the browser's usual font size: what keeps its size follows it.
    px: Memo<f64>,
    bounds: Memo<Bounds>,
    moved: RwSignal<Option<Viewport>>,
    most: f64,
    edge: f64,
    over: fn(Size) -> Overlays,
}

impl Camera {
    /// A camera on a lattice; a fitted cell is at most `most` pixels.
    #[must_use]
    pub fn new(size: ReadSignal<Size>, bounds: Memo<Bounds>, most: f64) -> Self {
        // Another font size is another layout.
        let px = Memo::new(move |_| {
            size.track();
            browser::scaled_px()
        });
        let moved = RwSignal::new(None);
        Self { size, px, bounds, moved, most, edge: 0.0, over: |_| Overlays::default() }
    }

    /// The same with so many pixels free at every edge of the picture that shows everything.
    #[must_use]
    pub const fn with_edge(self, edge: f64) -> Self {
        Self { edge, ..self }
    }

    /// The same with nothing of the maze under what stands on the picture while it shows everything.
    #[must_use]
    pub fn beside_overlays(self) -> Self {
        Self { over: Overlays::on, ..self }
    }

    fn fitted(self) -> Viewport {
        let (Size { w, h }, px) = (self.size.get(), self.px.get());
        let inner = |side: f64| (side / px - 2.0 * self.edge).max(1.0);
        let inner = Size { w: inner(w), h: inner(h) };
        let fitted = Viewport::fit_beside(self.bounds.get(), inner, self.most, (self.over)(inner));
        Viewport { scale: fitted.scale * px, ..fitted }
    }

    /// What the picture shows.
    #[must_use]
    pub fn view(self) -> Viewport {
        self.moved.get().unwrap_or_else(|| self.fitted())
    }

    /// Whether everything is shown.
    #[must_use]
    pub fn is_fitted(self) -> bool {
        self.moved.with(Option::is_none)
    }

    /// Shows everything again.
    pub fn fit(self) {
        self.moved.set(None);
    }

    /// Zooms about a place of the picture; about its middle if none is named.
    pub fn zoom(self, factor: f64, about: Option<(f64, f64)>) {
        let (view, size) = untrack(|| (self.view(), self.size.get()));
        let about = about.unwrap_or((size.w / 2.0, size.h / 2.0));
        self.moved.set(Some(view.zoomed(size, factor, about)));
    }

    /// Moves the paper by pixels.
    pub fn pan(self, dx: f64, dy: f64) {
        let view = untrack(|| self.view());
        self.moved.set(Some(view.moved(dx, dy)));
    }

    /// Moves the paper, if needed, so that a lattice point is in the picture.
    pub fn show(self, at: Point) {
        let (view, size) = untrack(|| (self.view(), self.size.get()));
        let (px, py) = view.to_screen(size, f64::from(at.x), f64::from(at.y));
        if !(20.0..=size.w - 20.0).contains(&px) || !(20.0..=size.h - 20.0).contains(&py) {
            self.moved.set(Some(Viewport { x: f64::from(at.x), y: f64::from(at.y), ..view }));
        }
    }

    /// Moves the paper, and zooms out if needed, so that a part of the lattice is in the picture.
    pub fn show_all(self, part: Bounds) {
        let (view, size) = untrack(|| (self.view(), self.size.get()));
        let inside = |at: Point| {
            let (px, py) = view.to_screen(size, f64::from(at.x), f64::from(at.y));
            (30.0..=size.w - 30.0).contains(&px) && (30.0..=size.h - 30.0).contains(&py)
        };
        if !inside(part.sw()) || !inside(part.ne()) {
            self.moved.set(Some(Viewport::fit(part, size, view.scale)));
        }
    }

    /// The lattice place under a pointer event on the picture.
    #[must_use]
    pub fn place(self, px: f64, py: f64) -> (f64, f64) {
        untrack(|| self.view().to_lattice(self.size.get(), px, py))
    }

    /// The SVG `viewBox` that shows it, in picture units.
    #[must_use]
    pub fn view_box(self) -> String {
        let (view, size) = (self.view(), self.size.get());
        let unit = f64::from(UNIT);
        let (w, h) = (size.w / view.scale * unit, size.h / view.scale * unit);
        let [x, y] = [view.x * unit - w / 2.0, -view.y * unit - h / 2.0].map(|at| Decimal(at, 2));
        format!("{x} {y} {} {}", Decimal(w, 2), Decimal(h, 2))
    }

    /// Picture units that look like one pixel at the browser's usual font size: for labels and handles that keep
    /// their size.
    #[must_use]
    pub fn pixel(self) -> f64 {
        f64::from(UNIT) / self.view().scale * self.px.get()
    }

    /// Whether lines are too thin to have anything drawn on them.
    #[must_use]
    pub fn is_far(self) -> bool {
        self.pixel() > FAR
    }
}

/// Zoom out, in, and show everything.
#[component]
pub fn ZoomButtons(camera: Camera) -> impl IntoView {
    view! {
        <span class="group" role="group" aria-label="Zoom">
            <button class="btn icon" aria-label="Zoom out" on:click=mouse(move |_| camera.zoom(0.8, None))>
                {super::icons::minus()}
            </button>
            <button class="btn icon" aria-label="Zoom in" on:click=mouse(move |_| camera.zoom(1.25, None))>
                {super::icons::plus()}
            </button>
            <button class="btn" disabled=sig(move || camera.is_fitted()) on:click=mouse(move |_| camera.fit())>"Fit"</button>
        </span>
    }
}

/// A finish point, with its name where one is wanted.
pub fn finish_mark(maze: &Maze, at: Point, named: bool, pixel: f64) -> AnyView {
    // Never smaller than can be seen.
    let place =
        format!("translate({} {}) scale({})", at.x * UNIT, -at.y * UNIT, Decimal((pixel / 4.0).max(1.0), 2));
    view! {
        <rect class="finish" x="-18" y="-14" width="36" height="28" rx="3" transform=place />
        {named.then(|| finish_name(maze, at, pixel))}
    }
    .into_any()
}

/// The finish's name: beside its mark, or, where walls are all round, below it in its square; there it needs room.
fn finish_name(maze: &Maze, at: Point, pixel: f64) -> AnyView {
    const ROOMY: f64 = 1.5;
    match maze.kind {
        Kind::Line => name(at, name_place(maze.bounds(), maze.ways(at), at), 24.0, pixel, "finish"),
        Kind::Wall if pixel > ROOMY => ().into_any(),
        Kind::Wall => {
            let (x, y) = (f64::from(at.x * UNIT) - 19.0 * pixel.max(0.35), f64::from(-at.y * UNIT) + 26.0);
            view! { <Label x=x y=y pixel=pixel text="finish" /> }.into_any()
        }
    }
}

/// The name of a lattice point, that many picture units off.
pub fn name(at: Point, place: NamePlace, off: f64, pixel: f64, text: &'static str) -> AnyView {
    let (dx, dy) = place.side.vector();
    // The bot keeps its size in small pictures. Above and below, the middle of the text stands further off.
    let off = off.max(16.0 * pixel) + if dx == 0 { 11.0 } else { 6.0 } * pixel;
    let runs = f64::from(place.runs);
    let along = if dx == 0 { -14.0 * runs } else { f64::from(dx) * off };
    let (x, y) = (f64::from(at.x * UNIT) + along, f64::from(-at.y * UNIT) - f64::from(dy) * off);
    view! { <Label x=x y=y pixel=pixel text=text runs=place.runs /> }.into_any()
}

/// A word beside a place; its size stays the same when the picture is zoomed.
#[component]
pub fn Label(
    x: f64,
    y: f64,
    pixel: f64,
    text: &'static str,
    /// On to the east (1), to both sides (0), or up to the place from the west (−1).
    #[prop(default = 1)]
    runs: i8,
) -> impl IntoView {
    let scale = pixel.max(0.35);
    let anchor = match runs {
        0 => "middle",
        1.. => "start",
        _ => "end",
    };
    view! {
        <g transform=format!("translate({} {}) scale({})", Decimal(x, 2), Decimal(y, 2), Decimal(scale, 3)) aria-hidden="true">
            <text class="label" y="5" text-anchor=anchor>{text}</text>
        </g>
    }
}

/// The bot, its nose towards the top; drawn in picture units around its middle.
pub fn bot_shape() -> impl IntoView {
    view! {
        <rect class="bot-body" x="-15" y="-20" width="30" height="38" rx="8" />
        <path class="bot-body" d="M0-34l9 13h-18z" />
        <g class="bot-wheel">
            <rect x="-20" y="-4" width="6" height="18" rx="3" />
            <rect x="14" y="-4" width="6" height="18" rx="3" />
        </g>
        <path class="bot-eye" d="M-9-14h0M-4.5-14h0M0-14h0M4.5-14h0M9-14h0" />
    }
}

/// The bot in the picture; never smaller than can be seen.
#[component]
pub fn Bot(#[prop(into)] pose: Signal<Pose>, #[prop(into)] pixel: Signal<f64>) -> impl IntoView {
    let lab = lab();
    // Between walls its nose stays in its square.
    let least = Memo::new(move |_| lab.maze.with(|maze| if maze.kind == Kind::Wall { 1.0 } else { 1.25 }));
    let transform = move || {
        let (pose, unit) = (pose.get(), f64::from(UNIT));
        let scale = (0.62 * pixel.get()).max(least.get());
        let [x, y, degrees] = [pose.x * unit, -pose.y * unit, pose.degrees].map(|of| Decimal(of, 2));
        format!("translate({x} {y}) rotate({degrees}) scale({})", Decimal(scale, 3))
    };
    view! { <g class="bot" transform=transform>{bot_shape()}</g> }
}

/// The bot's directions on the drawing: its 0, the bot's north, may point anywhere.
#[component]
pub fn Compass(#[prop(into)] north: Signal<Heading>) -> impl IntoView {
    let turned = move || format!("rotate({})", u32::from(north.get().index()) * 90);
    let label = move || {
        let (dx, dy) = north.get().vector();
        (dx * 30, -dy * 30 + 4)
    };
    view! {
        <svg
            class="compass-rose maze"
            viewBox="-44 -44 88 88"
            role="img"
            aria-label=sig(move || format!("The bot’s north, direction 0, is {} on the drawing", north.get().word()))
        >
            <g class="compass">
                <circle r="20" />
                <path transform=turned d="M0-14l5 14h-10z" />
                <text x=sig(move || label().0) y=sig(move || label().1)>"0 N"</text>
            </g>
        </svg>
    }
}
