//! When it goes wrong: a panic is told to the page's own script, which needs no wasm to show the way out.

use leptos::prelude::{document, window};
use wasm_bindgen::JsValue;
use web_sys::{CustomEvent, CustomEventInit};

/// Tells panics to the console and to the rescue screen.
pub fn catch_panics() {
    std::panic::set_hook(Box::new(|panic| {
        console_error_panic_hook::hook(panic);
        tell(&panic.to_string());
    }));
}

/// Shows the rescue screen with this report.
pub fn tell(report: &str) {
    dispatch("linemaze:panic", &JsValue::from_str(report));
}

/// Tells the rescue screen of a maze that the browser does not keep, so that it can be saved there; none where it is
/// kept.
pub fn tell_kept(not_kept: Option<&str>) {
    dispatch("linemaze:not-kept", &not_kept.map_or(JsValue::NULL, JsValue::from_str));
}

fn dispatch(name: &str, value: &JsValue) {
    let detail = CustomEventInit::new();
    detail.set_detail(value);
    if let Ok(event) = CustomEvent::new_with_event_init_dict(name, &detail) {
        let _ = window().dispatch_event(&event);
    }
}

/// Takes away what was shown while the page was loading.
pub fn loaded() {
    if let Some(loading) = document().get_element_by_id("loading") {
        loading.remove();
    }
}
