//! A maze as a small picture: shelf, samples, generator.

use leptos::prelude::*;

use crate::maze::{Kind, Maze};
use crate::web::paths::{self, UNIT};

/// The picture; it scales to its box.
pub fn thumb(maze: &Maze) -> impl IntoView + use<> {
    let bounds = maze.bounds();
    let (sw, ne) = (bounds.sw(), bounds.ne());
    // Walls stand half a cell outside of the outermost squares' middles.
    let edge = if maze.kind == Kind::Wall { UNIT / 2 } else { 0 };
    let (w, h) = ((ne.x - sw.x) * UNIT + 2 * edge, (ne.y - sw.y) * UNIT + 2 * edge);
    // Marks and lines are as thick in a large maze as in a small one.
    let thick = f64::from(w.max(h * 3 / 2).max(2 * UNIT)) / 26.0;
    let margin = (thick * if maze.kind == Kind::Wall { 0.8 } else { 2.2 }) as i32;
    let (left, top) = (sw.x * UNIT - edge - margin, -ne.y * UNIT - edge - margin);
    let frame = format!("{left} {top} {} {}", w + 2 * margin, h + 2 * margin);
    let line = paths::drawn(maze, (sw, ne));
    let width = thick.min(if maze.kind == Kind::Wall { 10.0 } else { 16.0 });
    // A mark stays in its square.
    let most = if maze.kind == Kind::Wall { 36.0 } else { f64::INFINITY };
    let side = (thick * 1.9).min(most);
    let finish = maze.finish().iter().map(|at| {
        let (x, y) = (f64::from(at.x * UNIT) - side / 2.0, f64::from(-at.y * UNIT) - side / 2.0);
        view! { <rect class="f" x=x y=y width=side height=side /> }
    });
    let start = maze.start().map(|start| {
        view! { <circle class="s" cx=start.at.x * UNIT cy=-start.at.y * UNIT r=(thick * 1.15).min(most / 2.0) /> }
    });
    view! {
        <svg class="thumb" viewBox=frame aria-hidden="true">
            <path d=line stroke-width=width />
            {finish.collect_view()}
            {start}
        </svg>
    }
}
