//! Taking back and doing again. Where the drawing does not show what that was, it is said.

use leptos::prelude::*;

use super::lazy::{self, lazy};
use super::state::{Lab, Room, Toast, ToastAction, ToastTone};
use crate::maze::edit::History;

/// Which way one goes.
#[derive(Clone, Copy, PartialEq, Eq)]
enum Way {
    Back,
    Again,
}

/// Takes the last edit back.
pub fn undo(lab: Lab) {
    match lab.undo() {
        true => lazy::act(lab, told(lab, Way::Back)),
        false => lab.say(ToastTone::Info, "", "There is nothing to take back."),
    }
}

/// Makes the last edit again.
pub fn redo(lab: Lab) {
    match lab.redo() {
        true => lazy::act(lab, told(lab, Way::Again)),
        false => lab.say(ToastTone::Info, "", "There is nothing to do again."),
    }
}

lazy! { files;
    fn told(lab: Lab, way: Way) -> () {
        let (label, did, action) = match way {
            Way::Back => (lab.history.with_untracked(History::redo_label), "Took back", ToastAction::Redo),
            Way::Again => (lab.history.with_untracked(History::undo_label), "Did again", ToastAction::Undo),
        };
        let text = format!("{did}: {}.", label.unwrap_or_default());
        if lab.room.get_untracked() == Room::Draw && !lab.projector.get_untracked() {
            lab.done.set(text);
        } else {
            lab.toast.set(Some(Toast { title: String::new(), text, tone: ToastTone::Info, action: Some(action) }));
        }
    }
}
