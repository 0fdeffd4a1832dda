//! A maze as a small picture: shelf, samples, generator.

use leptos::prelude::*;

use crate::maze::Maze;
use crate::web::paths::{self, UNIT};

/// The picture; it scales to its box.
pub fn thumb(maze: &Maze) -> impl IntoView + use<> {
    let bounds = maze.bounds();
    let (sw, ne) = (bounds.sw(), bounds.ne());
    let (w, h) = ((ne.x - sw.x) * UNIT, (ne.y - sw.y) * UNIT);
    // Marks and lines are as thick in a large maze as in a small one.
    let thick = f64::from(w.max(h * 3 / 2).max(2 * UNIT)) / 26.0;
    let margin = (thick * 2.2) as i32;
    let frame =
        format!("{} {} {} {}", sw.x * UNIT - margin, -ne.y * UNIT - margin, w + 2 * margin, h + 2 * margin);
    let line = paths::cells((sw, ne), |at, heading| maze.has_line(at, heading));
    let width = thick.min(16.0);
    let side = thick * 1.9;
    let finish = maze.finish().iter().map(|at| {
        let (x, y) = (f64::from(at.x * UNIT) - side / 2.0, f64::from(-at.y * UNIT) - side / 2.0);
        view! { <rect class="f" x=x y=y width=side height=side /> }
    });
    let start = maze.start().map(|start| {
        view! { <circle class="s" cx=start.at.x * UNIT cy=-start.at.y * UNIT r=thick * 1.15 /> }
    });
    view! {
        <svg class="thumb" viewBox=frame aria-hidden="true">
            <path d=line stroke-width=width />
            {finish.collect_view()}
            {start}
        </svg>
    }
}
