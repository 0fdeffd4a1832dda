//! The browser's odds and ends, each behind a small function: clock, clipboard, downloads, media queries.

use js_sys::Array;
use leptos::prelude::*;
use wasm_bindgen::JsCast;
use wasm_bindgen::prelude::*;
use wasm_bindgen_futures::JsFuture;
use web_sys::{Blob, BlobPropertyBag, HtmlAnchorElement, Url};

/// Seconds on a clock that only goes forward.
#[must_use]
pub fn now_s() -> f64 {
    window().performance().map_or(0.0, |clock| clock.now() / 1000.0)
}

/// A media query: whether it holds, also when that changes while the page is open.
#[must_use]
pub fn media(query: &str) -> ReadSignal<bool> {
    let list = window().match_media(query).ok().flatten();
    let (holds, set_holds) = signal(list.as_ref().is_some_and(web_sys::MediaQueryList::matches));
    if let Some(list) = list {
        let asked = list.clone();
        let changed = Closure::<dyn FnMut()>::new(move || {
            // The signal may be gone before the page is.
            let _ = set_holds.try_set(asked.matches());
        });
        let _ = list.add_event_listener_with_callback("change", changed.as_ref().unchecked_ref());
        changed.forget();
    }
    holds
}

/// Pixels a rem: what the style sheet measures in rem follows the browser's font size.
#[must_use]
pub fn rem_px() -> f64 {
    const USUAL: f64 = 16.0;
    let root = document().document_element();
    let style = root.and_then(|root| window().get_computed_style(&root).ok().flatten());
    let size = style.and_then(|style| style.get_property_value("font-size").ok());
    size.and_then(|size| size.trim_end_matches("px").parse().ok()).unwrap_or(USUAL)
}

/// Pixels that stand for one at the browser's usual font size.
#[must_use]
pub fn scaled_px() -> f64 {
    rem_px() / 16.0
}

/// Offers a text as a file to keep.
pub fn download(name: &str, mime: &str, text: &str) {
    let parts = Array::of1(&JsValue::from_str(text));
    let options = BlobPropertyBag::new();
    options.set_type(mime);
    if let Ok(blob) = Blob::new_with_str_sequence_and_options(&parts, &options) {
        download_blob(name, &blob);
    }
}

/// Offers a blob as a file to keep.
pub fn download_blob(name: &str, blob: &Blob) {
    let Ok(url) = Url::create_object_url_with_blob(blob) else { return };
    if let Ok(link) = document().create_element("a").map(JsCast::unchecked_into::<HtmlAnchorElement>) {
        link.set_href(&url);
        link.set_download(name);
        link.click();
    }
    // The browser reads the address after this turn of the event loop.
    set_timeout(
        move || {
            let _ = Url::revoke_object_url(&url);
        },
        std::time::Duration::from_secs(30),
    );
}

/// Copies a text; `done` learns whether that worked.
pub fn copy(text: String, done: impl FnOnce(bool) + 'static) {
    // Pages outside a secure context have no clipboard.
    let clipboard = js_sys::Reflect::get(&window().navigator(), &"clipboard".into());
    let Some(clipboard) = clipboard.ok().filter(|clipboard| clipboard.is_object()) else {
        return done(false);
    };
    let promise = clipboard.unchecked_into::<web_sys::Clipboard>().write_text(&text);
    leptos::task::spawn_local(async move { done(JsFuture::from(promise).await.is_ok()) });
}

/// The page's address without what follows `#`.
#[must_use]
pub fn address() -> String {
    let href = window().location().href().unwrap_or_default();
    href.split('#').next().unwrap_or_default().to_owned()
}

/// What follows `#` in the address.
#[must_use]
pub fn hash() -> String {
    window().location().hash().unwrap_or_default().trim_start_matches('#').to_owned()
}

/// Sets what follows `#` without a new entry in the browser's history.
pub fn replace_hash(hash: &str) {
    if let Ok(history) = window().history() {
        let _ = history.replace_state_with_url(&JsValue::NULL, "", Some(&format!("#{hash}")));
    }
}

/// Sets what follows `#`, with an entry in the browser's history to come back to.
pub fn push_hash(hash: &str) {
    if let Ok(history) = window().history() {
        let _ = history.push_state_with_url(&JsValue::NULL, "", Some(&format!("#{hash}")));
    }
}

/// Takes the keyboard's focus away from a list once something is chosen, so that Space plays again.
pub fn let_go(event: &web_sys::Event) {
    if let Some(element) = event.target().and_then(|target| target.dyn_into::<web_sys::HtmlElement>().ok()) {
        let _ = element.blur();
    }
}

/// Takes the keyboard's focus from where it is; a field says what was typed.
pub fn blur() {
    if let Some(element) =
        document().active_element().and_then(|element| element.dyn_into::<web_sys::HtmlElement>().ok())
    {
        let _ = element.blur();
    }
}

/// Whether a form has a field that says what is wrong with it; the first such gets the focus.
#[must_use]
pub fn has_wrong_field(event: &web_sys::SubmitEvent) -> bool {
    let form = event.target().map(JsCast::unchecked_into::<web_sys::Element>);
    let wrong = form.and_then(|form| form.query_selector("[aria-invalid=true]").ok().flatten());
    if let Some(wrong) = &wrong {
        let _ = wrong.unchecked_ref::<web_sys::HtmlElement>().focus();
    }
    wrong.is_some()
}

/// Whether the `<details>` of a toggle event is open now.
#[must_use]
pub fn is_open(event: &web_sys::Event) -> bool {
    event.target().is_some_and(|details| details.unchecked_into::<web_sys::Element>().has_attribute("open"))
}

/// Moves the keyboard's focus to an element.
pub fn focus(id: &str) {
    if let Some(element) = document().get_element_by_id(id) {
        let _ = element.unchecked_into::<web_sys::HtmlElement>().focus();
    }
}

/// The number that an attribute gives to the element under the pointer, or to one around it.
#[must_use]
pub fn data_number(event: &web_sys::PointerEvent, attribute: &str) -> Option<u32> {
    let element = event.target()?.dyn_into::<web_sys::Element>().ok()?;
    element.closest(&format!("[{attribute}]")).ok()??.get_attribute(attribute)?.parse().ok()
}

/// Whether this page was not made by `cargo xtask dist`.
#[must_use]
pub fn is_development() -> bool {
    let version = document().query_selector("meta[name=version]").ok().flatten();
    version.and_then(|meta| meta.get_attribute("content")).as_deref() == Some("development")
}
