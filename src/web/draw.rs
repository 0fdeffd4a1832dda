//! stub
use super::state::{Dialog, Lab};
use leptos::prelude::*;
#[component]
pub fn DrawRoom() -> impl IntoView {}
pub fn save(_: Lab) {}
pub fn choose_file() {}
pub fn dialog(_: Dialog) -> AnyView {
    ().into_any()
}
