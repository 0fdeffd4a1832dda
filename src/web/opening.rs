//! Opening what comes from outside: files, pasted text, links.

use leptos::prelude::*;
use wasm_bindgen::JsCast;
use wasm_bindgen::prelude::*;
use web_sys::HtmlInputElement;

use super::app::LINK;
use super::lazy::{self, lazy};
use super::state::{Lab, Room, ToastTone};
use super::{browser, keys};
use crate::maze::{file, json};
use crate::share;

/// Files dropped anywhere, and mazes pasted anywhere but into a field.
pub fn listen(lab: Lab) {
    let over = window_event_listener(leptos::ev::dragover, |event| event.prevent_default());
    let drop = window_event_listener(leptos::ev::drop, move |event| {
        event.prevent_default();
        let Some(transfer) = event.data_transfer() else { return };
        let files = transfer.files();
        let file = files.as_ref().filter(|files| files.length() == 1).and_then(|files| files.get(0));
        match file.filter(|_| !super::compare::holds_folder(&transfer)) {
            Some(file) => open_file(lab, &file),
            // Many files, or a folder of them: a league.
            None if files.is_some_and(|files| files.length() > 0) => {
                super::compare::drop_into_league(lab, &transfer)
            }
            None => {}
        }
    });
    let paste = window_event_listener(leptos::ev::paste, move |event| {
        if keys::is_typing(event.target()) {
            return;
        }
        let text =
            event.clipboard_data().and_then(|data| data.get_data("text/plain").ok()).unwrap_or_default();
        if !text.trim().is_empty() {
            event.prevent_default();
            open_text(lab, text);
        }
    });
    on_cleanup(move || {
        over.remove();
        drop.remove();
        paste.remove();
    });
}

/// Opens the maze, settings and stop of a link; a broken one is told, and nothing changes.
pub fn open_link(lab: Lab, payload: &str) {
    let payload = payload.to_owned();
    // One's own maze is neither shown nor kept anew on the way.
    let borrowed = lab.borrowed.get_untracked();
    lab.borrowed.set(true);
    lab.link_coming.set(true);
    lazy::act(lab, async move {
        let opened = link_opened(lab, payload).await;
        if !matches!(opened, Ok(true)) {
            lab.borrowed.set(borrowed);
        }
        lab.link_coming.set(false);
        opened.map(drop)
    });
}

/// Opens a maze or a link that was pasted.
pub fn open_text(lab: Lab, text: String) {
    match link_in(&text) {
        Some(payload) => open_link(lab, payload),
        None => lazy::act(lab, bytes_opened(lab, "the pasted maze".to_owned(), text.into_bytes())),
    }
}

/// The maze in the address, where the text is one line with such an address.
#[must_use]
pub fn link_in(text: &str) -> Option<&str> {
    let (before, payload) = text.trim().split_once(&format!("#{LINK}"))?;
    (!before.contains('\n')).then(|| payload.trim())
}

/// Opens a file that the user chose or dropped.
pub fn open_file(lab: Lab, file: &web_sys::File) {
    let (name, size) = (file.name(), file.size());
    if size > json::MAX_BYTES as f64 {
        let tenths = (size * 10.0 / 1_048_576.0) as u64;
        let (whole, part, most) = (tenths / 10, tenths % 10, json::MAX_BYTES >> 20);
        let text = format!("It has {whole}.{part} MiB; a maze file has at most {most} MiB.");
        return lab.say(ToastTone::Error, format!("Can’t read {name}"), text);
    }
    let bytes = file.array_buffer();
    lazy::act(lab, async move {
        match wasm_bindgen_futures::JsFuture::from(bytes).await {
            Ok(buffer) => bytes_opened(lab, name, js_sys::Uint8Array::new(&buffer).to_vec()).await?,
            Err(_) => lab.say(
                ToastTone::Error,
                format!("Can’t read {name}"),
                "The browser could not read the file. Is it still there?",
            ),
        }
        Ok(())
    });
}

/// Lets the user choose a file, and opens it.
pub fn choose_file(lab: Lab) {
    let Ok(input) = document().create_element("input").map(JsCast::unchecked_into::<HtmlInputElement>) else {
        return;
    };
    input.set_type("file");
    input.set_accept(".maze,.json,.txt,.map,.num,.maz,text/plain,application/json");
    let chosen = input.clone();
    let open = Closure::once_into_js(move || {
        if let Some(file) = chosen.files().and_then(|files| files.get(0)) {
            open_file(lab, &file);
        }
    });
    let _ = input.add_event_listener_with_callback("change", open.unchecked_ref());
    input.click();
}

lazy! { files;
    fn link_opened(lab: Lab, payload: String) -> bool {
        match share::decode(&payload) {
            Ok(shared) => {
                lab.broken_link.set(None);
                lab.room.set(Room::Step);
                lab.borrow(shared);
                true
            }
            Err(why) => {
                lab.broken_link.set(Some(why.to_string()));
                browser::replace_hash("step");
                false
            }
        }
    }
}

lazy! { files;
    fn bytes_opened(lab: Lab, name: String, bytes: Vec<u8>) -> () {
        match file::read(&bytes) {
            Ok(maze) => {
                lab.open(maze);
                lab.say_done(format!("Opened {name}."));
            }
            Err(why) => lab.say(ToastTone::Error, format!("Can’t read {name}"), why.to_string()),
        }
    }
}
