//! The page: catches panics, then mounts the app.

use leptos::prelude::*;

fn main() {
    console_error_panic_hook::set_once();
    mount_to_body(|| view! { <p>"Line Maze Lab"</p> });
}
