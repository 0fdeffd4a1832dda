//! Files in and out: open, save, and export as a picture.

use leptos::prelude::*;
use wasm_bindgen::JsCast;
use wasm_bindgen::prelude::*;
use wasm_bindgen_futures::JsFuture;
use web_sys::{Blob, BlobPropertyBag, CanvasRenderingContext2d, HtmlCanvasElement, HtmlImageElement, Url};

use crate::maze::micromouse::{self, CannotSay, Form, Unsaid};
use crate::maze::{Maze, file, json, svg, text};
use crate::web::browser::{download, download_blob};
use crate::web::state::{Lab, ToastTone};

/// Pixels a cell of an exported picture, where it does not become too large.
const CELL_PX: f64 = 96.0;
/// The most pixels along a side: what browsers draw without complaint.
const MOST_PX: f64 = 6000.0;

/// Saves the maze as a `.maze` file.
pub fn save(lab: Lab) {
    saved(lab, "maze", "text/plain", text::write);
}

/// Saves the maze as JSON.
pub fn save_json(lab: Lab) {
    saved(lab, "json", "application/json", json::write);
}

/// Saves a picture in the maze's true size.
pub fn export_svg(lab: Lab) {
    saved(lab, "svg", "image/svg+xml", svg::write);
}

/// Saves a micromouse file, where the maze can be said in that form.
pub fn export_mouse(lab: Lab, form: Form, finish: Unsaid) {
    let extension = form.extension();
    let (name, written) = lab
        .maze
        .with_untracked(|maze| (file::name(maze, extension), micromouse::write_with(maze, form, finish)));
    match written {
        Ok(bytes) => {
            let parts = js_sys::Array::of1(&js_sys::Uint8Array::from(&bytes[..]));
            let options = BlobPropertyBag::new();
            options.set_type("application/octet-stream");
            if let Ok(blob) = Blob::new_with_u8_array_sequence_and_options(&parts, &options) {
                download_blob(&name, &blob);
                lab.say(ToastTone::Info, "", format!("{name} goes to your downloads."));
            }
        }
        Err(why) => {
            let mut words = sentence(&why.to_string());
            if why == CannotSay::Finish {
                words += " The File menu has a choice for leaving it out.";
            }
            lab.say(ToastTone::Error, format!("Can’t write this maze as .{extension}"), words);
        }
    }
}

/// With a capital at the beginning and a full stop at the end.
fn sentence(words: &str) -> String {
    let mut chars = words.chars();
    let first: String = chars.next().into_iter().flat_map(char::to_uppercase).collect();
    format!("{first}{}.", chars.as_str())
}

fn saved(lab: Lab, extension: &str, mime: &str, write: impl FnOnce(&Maze) -> String) {
    let (name, text) = lab.maze.with_untracked(|maze| (file::name(maze, extension), write(maze)));
    download(&name, mime, &text);
    lab.say(ToastTone::Info, "", format!("{name} goes to your downloads."));
}

/// Saves a picture in pixels.
pub fn export_png(lab: Lab) {
    let (name, text, width, height) = lab.maze.with_untracked(|maze| {
        let bounds = maze.bounds();
        let (w, h) = (f64::from(bounds.width() + 1), f64::from(bounds.height() + 1));
        let cell = CELL_PX.min(MOST_PX / w.max(h));
        (file::name(maze, "png"), svg::write(maze), (w * cell).ceil(), (h * cell).ceil())
    });
    leptos::task::spawn_local(async move {
        if paint(name.clone(), &text, width, height).await.is_err() {
            lab.say(
                ToastTone::Error,
                format!("Can’t make {name}"),
                "This browser could not draw the picture. Export it as SVG instead.",
            );
        }
    });
}

/// Lets the browser draw the SVG, and offers what it drew.
async fn paint(name: String, svg: &str, width: f64, height: f64) -> Result<(), JsValue> {
    let options = BlobPropertyBag::new();
    options.set_type("image/svg+xml");
    let parts = js_sys::Array::of1(&svg.into());
    let url = Url::create_object_url_with_blob(&Blob::new_with_str_sequence_and_options(&parts, &options)?)?;
    let image = HtmlImageElement::new()?;
    image.set_src(&url);
    let decoded = JsFuture::from(image.decode()).await;
    let canvas: HtmlCanvasElement = document().create_element("canvas")?.unchecked_into();
    canvas.set_width(width as u32);
    canvas.set_height(height as u32);
    let context = canvas.get_context("2d")?.ok_or(JsValue::NULL)?.dyn_into::<CanvasRenderingContext2d>()?;
    let drawn = decoded.and_then(|_| {
        context.draw_image_with_html_image_element_and_dw_and_dh(&image, 0.0, 0.0, width, height)
    });
    Url::revoke_object_url(&url)?;
    drawn?;
    let blob = to_blob(&canvas).await?.dyn_into::<Blob>()?;
    download_blob(&name, &blob);
    Ok(())
}

/// `toBlob` as a promise.
async fn to_blob(canvas: &HtmlCanvasElement) -> Result<JsValue, JsValue> {
    let promise = js_sys::Promise::new(&mut |done, failed| {
        let given = Closure::once_into_js(move |blob: JsValue| {
            let _ = done.call1(&JsValue::NULL, &blob);
        });
        if canvas.to_blob(given.unchecked_ref()).is_err() {
            let _ = failed.call0(&JsValue::NULL);
        }
    });
    JsFuture::from(promise).await
}
