//! The page: catches panics, then mounts the app; or, in a worker, runs the league.

use line_maze_lab::web::{app::App, compare, rescue};

use leptos::prelude::*;

fn main() {
    // The page's worker runs the same program.
    if web_sys::window().is_none() {
        return compare::serve();
    }
    rescue::catch_panics();
    mount_to_body(|| view! { <App /> });
    rescue::loaded();
}
