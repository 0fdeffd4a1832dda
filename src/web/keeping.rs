//! Keeping the user's own maze: as it changes, and never over something that nobody has seen. A kept maze that this
//! page can't read is put aside; one that another tab has kept meanwhile stays until the user says which of both is
//! to be kept.

use leptos::prelude::*;

use super::state::Lab;
use super::{rescue, rooms, storage};
use crate::maze::{Maze, text};

/// Whether the browser keeps the user's own maze.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub enum Kept {
    /// It does.
    #[default]
    Here,
    /// Its storage is full or forbidden.
    Refused,
    /// This text stands in its place, which this page has neither written nor read: another tab has.
    Other(String),
}

/// The user's own last maze, and what this page knows to be kept.
#[must_use]
pub fn last() -> (Option<Maze>, Option<String>) {
    let Some(kept) = storage::maze() else { return (None, None) };
    match text::parse(&kept) {
        Ok(maze) => (Some(maze), Some(kept)),
        // Where there is no room to put it aside, it stays where it is, as another tab's would.
        Err(_) => (None, storage::put_aside(&kept).is_ok().then_some(kept)),
    }
}

/// Keeps maze and settings as they change, and hears of other tabs.
pub fn listen(lab: Lab) {
    Effect::new(move |before: Option<()>| {
        lab.maze.track();
        if lab.borrowed.get() {
            // Nobody's maze yet; but what can be promised is known.
            return if storage::is_forbidden() {
                lab.kept.set(Kept::Refused)
            };
        }
        keep(lab);
        // A maze of one's own is not in the address.
        if before.is_some() {
            rooms::forget_link(lab);
        }
    });
    Effect::new(move |_| {
        lab.settings.with(|settings| {
            if !lab.borrowed.get() {
                storage::keep_settings(settings, lab.explorer.get());
            }
        });
    });
    Effect::new(move |_| storage::keep_letters(lab.letters.get()));
    let elsewhere = window_event_listener_untyped("storage", move |_| {
        if !lab.borrowed.get_untracked() {
            keep(lab);
        }
    });
    on_cleanup(move || elsewhere.remove());
}

/// Keeps the maze, unless another tab's stands in its place.
fn keep(lab: Lab) {
    let mine = lab.maze.with_untracked(|maze| text::write(maze));
    let there = storage::maze();
    let known =
        |there: &String| *there == mine || lab.known.with_value(|known| known.as_ref() == Some(there));
    let kept = match there.filter(|there| !known(there)) {
        Some(there) => other(lab, there),
        None => match storage::keep_maze(&mine) {
            Ok(()) => {
                lab.known.set_value(Some(mine.clone()));
                Kept::Here
            }
            Err(storage::NotKept) => Kept::Refused,
        },
    };
    rescue::tell_kept(if kept == Kept::Here { None } else { Some(&mine) });
    if lab.kept.with_untracked(|before| *before != kept) {
        lab.kept.set(kept);
    }
}

/// What it means that this text is kept, which this page has not written.
fn other(lab: Lab, there: String) -> Kept {
    let same = text::parse(&there).is_ok_and(|other| lab.maze.with_untracked(|maze| **maze == other));
    if same {
        lab.known.set_value(Some(there));
        return Kept::Here;
    }
    Kept::Other(there)
}

/// From now on this tab's maze is kept, in place of the other's.
pub fn keep_mine(lab: Lab) {
    lab.known.set_value(storage::maze());
    keep(lab);
}

/// Opens the other tab's maze; undo brings this one back.
pub fn take_other(lab: Lab, maze: Maze) {
    lab.known.set_value(storage::maze());
    lab.open(maze);
    keep(lab);
}
