//! Files for the league: chosen, dropped, or in a folder that was dropped; hundreds at once.

use leptos::prelude::*;
use wasm_bindgen::JsCast;
use wasm_bindgen::prelude::*;
use wasm_bindgen_futures::JsFuture;
use web_sys::{DataTransfer, File, FileList, FileSystemDirectoryEntry, FileSystemEntry, FileSystemFileEntry};

use super::desk::{Desk, Page};
use super::league::LeagueDesk;
use crate::compare::league::desk::in_base64;
use crate::maze::json;
use crate::web::rooms::go;
use crate::web::state::{Lab, Room};

/// Whether a folder was dropped.
pub fn holds_folder(transfer: &DataTransfer) -> bool {
    let items = transfer.items();
    (0..items.length()).filter_map(|nth| entry(transfer, nth)).any(|entry| entry.is_directory())
}

fn entry(transfer: &DataTransfer, nth: u32) -> Option<FileSystemEntry> {
    transfer.items().get(nth)?.webkit_get_as_entry().ok()?
}

/// What was dropped: folders as entries, files as files.
pub fn items(transfer: &DataTransfer) -> Vec<JsValue> {
    let items = transfer.items();
    let item = |nth| match entry(transfer, nth).filter(FileSystemEntry::is_directory) {
        Some(folder) => Some(folder.into()),
        None => items.get(nth)?.get_as_file().ok()?.map(JsValue::from),
    };
    (0..items.length()).filter_map(item).collect()
}

/// Opens the league, reads what was dropped, and lets the league begin.
pub fn dropped(lab: Lab, items: Vec<JsValue>) {
    let desk = Desk::of(lab);
    go(lab, Room::Compare);
    desk.turn_to(Page::League);
    leptos::task::spawn_local(async move {
        let mut files = Vec::new();
        for item in items {
            match item.dyn_into::<File>() {
                Ok(file) => files.push(file),
                Err(folder) => in_folder(folder, &mut files).await,
            }
        }
        desk.league.samples.set(false);
        desk.league.generate.set(false);
        read(desk.league, files).await;
        desk.league.begin();
    });
}

/// Reads files that were chosen.
pub fn chosen(league: LeagueDesk, list: Option<FileList>) {
    let Some(list) = list else { return };
    let files: Vec<File> = (0..list.length()).filter_map(|nth| list.get(nth)).collect();
    leptos::task::spawn_local(read(league, files));
}

/// Keeps the files in the order of their names; those that nobody could read are told.
async fn read(league: LeagueDesk, files: Vec<File>) {
    league.reading.set(Some((0, files.len())));
    let (mut read, mut refused) = (Vec::new(), Vec::new());
    let count = files.len();
    for (nth, file) in files.into_iter().enumerate() {
        // The system's own, in many folders.
        if file.name().starts_with('.') {
            continue;
        }
        if file.size() > json::MAX_BYTES as f64 {
            refused.push((file.name(), format!("A maze file has at most {} MiB.", json::MAX_BYTES >> 20)));
            continue;
        }
        match JsFuture::from(file.array_buffer()).await {
            Ok(buffer) => read.push((file.name(), in_base64(&js_sys::Uint8Array::new(&buffer).to_vec()))),
            Err(_) => refused.push((file.name(), "The browser could not read it. Is it still there?".into())),
        }
        league.reading.set(Some((nth + 1, count)));
    }
    read.sort();
    league.reading.set(None);
    league.take_files(read, refused);
}

/// All files in a folder and in the folders in it.
async fn in_folder(folder: JsValue, files: &mut Vec<File>) {
    let mut folders = vec![folder];
    while let Some(folder) = folders.pop() {
        let reader = folder.unchecked_into::<FileSystemDirectoryEntry>().create_reader();
        // It tells about a hundred at a time, and none at the end.
        loop {
            let batch =
                promised(|done, failed| reader.read_entries_with_callback_and_callback(done, failed).is_ok())
                    .await;
            let Ok(batch) = batch.and_then(|batch| batch.dyn_into::<js_sys::Array>()) else { break };
            if batch.length() == 0 {
                break;
            }
            for entry in batch.iter() {
                let entry = entry.unchecked_into::<FileSystemEntry>();
                if entry.is_directory() {
                    folders.push(entry.into());
                    continue;
                }
                let entry = entry.unchecked_into::<FileSystemFileEntry>();
                let file = promised(|done, failed| {
                    entry.file_with_callback_and_callback(done, failed);
                    true
                });
                if let Ok(file) = file.await {
                    files.push(file.unchecked_into());
                }
            }
        }
    }
}

/// What a function with two callbacks comes to.
async fn promised(begin: impl Fn(&js_sys::Function, &js_sys::Function) -> bool) -> Result<JsValue, JsValue> {
    let promise = js_sys::Promise::new(&mut |done, failed| {
        if !begin(&done, &failed) {
            let _ = failed.call0(&JsValue::NULL);
        }
    });
    JsFuture::from(promise).await
}
