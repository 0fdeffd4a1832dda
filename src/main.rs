//! The page: catches panics, then mounts the app.

use line_maze_lab::web::{app::App, rescue};

use leptos::prelude::*;

fn main() {
    rescue::catch_panics();
    mount_to_body(|| view! { <App /> });
    rescue::loaded();
}
