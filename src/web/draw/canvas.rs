//! The drawing's frame: pointers and keys go in, the hand's edits come out.

use crate::web::erase::{focus, key, mouse, part, pointer, sig, wheel};
use leptos::prelude::*;
use web_sys::{PointerEvent, WheelEvent};

use super::desk::{Desk, desk};
use super::keyboard;
use super::picture::{HANDLE_ARM, Picture, marker_scale};
use crate::gesture::{Button, Doing, Finishing, Handle, Motion, Press, Spot};
use crate::maze::{Kind, samples};
use crate::web::paths::UNIT;

/// The drawing.
#[component]
pub fn Canvas() -> impl IntoView {
    let desk = desk();
    // A pointer's focus needs no ring.
    let held = RwSignal::new(false);
    let label = move || {
        let (bounds, kind) = desk.lab.maze.with(|maze| (maze.bounds(), maze.kind));
        let (places, keys) = match kind {
            Kind::Line => ("points", "Shift and arrows draw, Alt and arrows erase"),
            Kind::Wall => {
                ("squares", "Alt and arrows open a wall and go through, Shift and arrows build one")
            }
        };
        format!(
            "Drawing of {} by {} {places}. Arrow keys go, {keys}, S and F put start and finish.",
            bounds.width(),
            bounds.height()
        )
    };
    view! {
        <div
            class="canvas"
            id="drawing"
            node_ref=desk.frame
            role="application"
            tabindex="0"
            aria-label=label
            aria-describedby="draw-status"
            data-tool=sig(move || format!("{:?}", desk.held_tool()).to_ascii_lowercase())
            class:held=sig(move || held.get())
            on:blur=focus(move |_| {
                held.set(false);
                desk.by_keyboard.set(false);
            })
            class:panning=sig(move || desk.doing.with(|doing| *doing == Doing::Pan))
            on:keydown=key(move |event| {
                held.set(false);
                keyboard::on_canvas(desk, &event);
            })
            on:pointerdown=pointer(move |event| {
                press(desk, &event);
                held.set(true);
            })
            on:pointermove=pointer(move |event| drag(desk, &event))
            on:pointerup=pointer(move |event| release(desk, event.pointer_id()))
            on:pointercancel=pointer(move |event| desk.hand.update(|hand| hand.lose(event.pointer_id())))
            on:lostpointercapture=pointer(move |event: PointerEvent| lose(desk, event.pointer_id()))
            on:contextmenu=mouse(move |event| event.prevent_default())
            on:wheel=wheel(move |event| zoom_by_wheel(desk, &event))
        >
            <Picture />
            {part(move || is_empty(desk).then(|| view! { <Nothing /> }))}
        </div>
    }
}

fn press(desk: Desk, event: &PointerEvent) {
    let touch = event.pointer_type() == "touch";
    let button = match event.button() {
        _ if touch => Button::Finger,
        1 => Button::Middle,
        2 => Button::Second,
        _ => Button::Main,
    };
    let Some(frame) = desk.frame.get_untracked() else { return };
    let _ = frame.set_pointer_capture(event.pointer_id());
    let _ = frame.focus();
    // Neither autoscroll nor selection nor a mouse event made of a touch.
    event.prevent_default();
    let adds = event.shift_key() || event.ctrl_key() || event.meta_key();
    let (pixel, kind) = untrack(|| (desk.camera.pixel(), desk.kind()));
    let cells = |pixels: f64| pixels * pixel / f64::from(UNIT);
    // The wall before the start is no part of the handle.
    let most = if kind == Kind::Wall { 0.17 } else { f64::INFINITY };
    let press = Press {
        id: event.pointer_id(),
        button,
        spot: spot(desk, event),
        tool: untrack(|| desk.held_tool()),
        finishing: if adds { Finishing::Further } else { desk.finishing.get_untracked() },
        handle: Handle {
            arm: HANDLE_ARM * marker_scale(kind, pixel) / f64::from(UNIT),
            reach: cells(if touch { 22.0 } else { 15.0 }).min(most),
        },
    };
    desk.by_keyboard.set(false);
    desk.hand.update(|hand| desk.with_maze(|maze| hand.press(maze, &press)));
}

fn drag(desk: Desk, event: &PointerEvent) {
    if desk.doing.with_untracked(|doing| *doing == Doing::Nothing) {
        return;
    }
    let spot = spot(desk, event);
    let motion =
        desk.hand.try_update(|hand| desk.with_maze(|maze| hand.drag(maze, event.pointer_id(), spot)));
    match motion.unwrap_or(Motion::Still) {
        Motion::Still => {}
        Motion::Pan(dx, dy) => desk.camera.pan(dx, dy),
        Motion::Zoom { by: (dx, dy), factor, about } => {
            desk.camera.pan(dx, dy);
            desk.camera.zoom(factor, Some(about));
        }
    }
}

fn release(desk: Desk, id: i32) {
    let edit = desk.hand.try_update(|hand| hand.release(id)).flatten();
    if let Some(edit) = edit {
        desk.lab.edit(edit);
    }
}

/// After every release the capture is lost too; then there is nothing left to lose.
fn lose(desk: Desk, id: i32) {
    if desk.doing.with_untracked(|doing| *doing != Doing::Nothing) {
        desk.hand.update(|hand| hand.lose(id));
    }
}

fn zoom_by_wheel(desk: Desk, event: &WheelEvent) {
    event.prevent_default();
    let lines = if event.delta_mode() == WheelEvent::DOM_DELTA_LINE { 18.0 } else { 1.0 };
    let factor = (-event.delta_y() * lines / 400.0).exp().clamp(0.2, 5.0);
    desk.camera.zoom(factor, Some(pixel(desk, event)));
}

fn spot(desk: Desk, event: &PointerEvent) -> Spot {
    let pixel = pixel(desk, event);
    Spot { place: desk.camera.place(pixel.0, pixel.1), pixel }
}

/// Where the event is in the picture.
fn pixel(desk: Desk, event: &web_sys::MouseEvent) -> (f64, f64) {
    let Some(frame) = desk.frame.get_untracked() else { return (0.0, 0.0) };
    let rect = frame.get_bounding_client_rect();
    (
        f64::from(event.client_x()) - rect.left() - f64::from(frame.client_left()),
        f64::from(event.client_y()) - rect.top() - f64::from(frame.client_top()),
    )
}

fn is_empty(desk: Desk) -> bool {
    desk.lab.maze.with(|maze| maze.kind == Kind::Line && maze.lines().next().is_none())
        && !desk.by_keyboard.get()
        && desk.doing.with(|doing| *doing == Doing::Nothing)
}

/// What an empty drawing offers.
#[component]
fn Nothing() -> impl IntoView {
    let desk = desk();
    view! {
        <div class="blank nothing">
            <svg viewBox="-40 -28 80 56" aria-hidden="true">
                <path class="points" d="M-32-20h0M0-20h0M32-20h0M-32 0h0M0 0h0M32 0h0M-32 20h0M0 20h0M32 20h0" />
                <path class="dash" d="M-32 0H8" />
            </svg>
            <p><b>"Nothing drawn"</b></p>
            <p class="small">"Drag from point to point, or begin with a sample."</p>
            <button class="btn" on:pointerdown=pointer(move |event| event.stop_propagation()) on:click=mouse(move |_| desk.lab.open(samples::figure_3_1()))>
                "Open figure 3.1"
            </button>
        </div>
    }
}
