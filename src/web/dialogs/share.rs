//! Sharing: a link that holds maze, settings and stop, its QR code for the projector, or a file where the
//! maze is too big for a link.

use crate::web::erase::{mouse, part};
use leptos::prelude::*;
use qrcodegen::{QrCode, QrCodeEcc};
use std::fmt::Write;

use super::Modal;
use crate::share::{self, Shared};
use crate::web::browser;
use crate::web::draw;
use crate::web::rooms::LINK;
use crate::web::state::{Lab, Round, ToastTone, lab};

/// A link, and whether it holds the maze's note.
struct Made {
    link: String,
    whole: bool,
}

/// The link to what is shown, if the maze fits into one; without its note, if only that is too long.
fn made(lab: Lab) -> Result<Made, share::ShareError> {
    let mut shared = Shared {
        maze: lab.maze.with(|maze| (**maze).clone()),
        settings: lab.settings.get(),
        explorer: lab.explorer.get(),
        stop: lab.playing().with(|playback| playback.moment().stop),
        solved: lab.round.get() == Round::Solved,
    };
    let link = |shared: &Shared| Ok(format!("{}#{LINK}{}", browser::address(), share::encode(shared)?));
    match link(&shared) {
        Ok(link) => Ok(Made { link, whole: true }),
        Err(_) if !shared.maze.about.note.is_empty() => {
            shared.maze.about.note.clear();
            Ok(Made { link: link(&shared)?, whole: false })
        }
        Err(why) => Err(why),
    }
}

/// The dialog.
#[component]
pub fn Share() -> impl IntoView {
    let lab = lab();
    view! {
        <Modal title="Share">
            {part(move || match made(lab) {
                Ok(made) => view! { <Link made=made /> }.into_any(),
                Err(_) => view! { <FileInstead /> }.into_any(),
            })}
        </Modal>
    }
}

#[component]
fn Link(made: Made) -> impl IntoView {
    let lab = lab();
    let Made { link, whole } = made;
    let code = QrCode::encode_text(&link, QrCodeEcc::Low).ok();
    let to_copy = link.clone();
    let copied = move |ok: bool| match ok {
        true => lab.say(ToastTone::Info, "", "The link is copied."),
        false => lab.say(
            ToastTone::Error,
            "Can’t copy",
            "This browser gives no access to the clipboard: select the link and copy it by hand.",
        ),
    };
    view! {
        <p>"Whoever opens this link sees this maze, these settings and this stop. Nothing is sent anywhere: the link holds it all."</p>
        {(!whole).then(|| view! { <p id="without-note"><b>"All but its note: "</b>"with it the link would be too long. A file holds it too."</p> })}
        <label class="field">
            "Link"
            <textarea class="input link" id="link" rows="3" readonly prop:value=link.clone()></textarea>
        </label>
        <div class="row">
            <button class="btn primary" on:click=mouse(move |_| browser::copy(to_copy.clone(), copied))>"Copy the link"</button>
            <button class="btn" on:click=mouse(move |_| draw::save(lab))>"Save as a file"</button>
        </div>
        {match code {
            Some(code) => view! { <Qr code=code /> }.into_any(),
            None => view! { <p class="small">"The link is too long for a QR code; copy it, or save a file."</p> }.into_any(),
        }}
    }
}

/// The code as one path, with the quiet zone that readers need.
#[component]
fn Qr(code: QrCode) -> impl IntoView {
    let (size, quiet) = (code.size(), 4);
    let mut data = String::new();
    for y in 0..size {
        for x in (0..size).filter(|&x| code.get_module(x, y)) {
            let _ = write!(data, "M{} {}h1v1h-1z", x + quiet, y + quiet);
        }
    }
    let side = size + 2 * quiet;
    view! {
        <div class="qr">
            <svg viewBox=format!("0 0 {side} {side}") role="img" aria-label="QR code of the link" shape-rendering="crispEdges">
                <rect class="qr-paper" width=side height=side />
                <path class="qr-ink" d=data />
            </svg>
            <p class="small">"Point a phone’s camera at it."</p>
        </div>
    }
}

#[component]
fn FileInstead() -> impl IntoView {
    let lab = lab();
    view! {
        <p>"This maze is too big for a link. Send it as a file: it opens here by drag and drop, or with Ctrl O."</p>
        <div class="row"><button class="btn primary" on:click=mouse(move |_| draw::save(lab))>"Save .maze"</button></div>
    }
}
