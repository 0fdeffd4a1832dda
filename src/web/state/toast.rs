//! A short message over the head of the page. It ends with what it speaks of: each message says how long it
//! holds, and goes when it no longer does.

use std::sync::Arc;
use std::sync::atomic::{AtomicU32, Ordering};

use leptos::prelude::*;

use super::Lab;

/// A short message.
#[derive(Clone)]
pub struct Toast {
    /// What it is about; may be empty.
    pub title: String,
    /// What happened, and the cure.
    pub text: String,
    /// Whether it is an error.
    pub tone: ToastTone,
    /// What can be done at once.
    pub action: Option<ToastAction>,
    holds: Arc<dyn Fn() -> bool + Send + Sync>,
    number: u32,
}

/// How a toast is meant.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum ToastTone {
    /// Something was done.
    Info,
    /// Something cannot be done.
    Error,
}

/// A toast's button.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum ToastAction {
    /// Takes back the last edit.
    Undo,
    /// Uses the new version of the page.
    Update,
}

impl PartialEq for Toast {
    /// Whether they are the same message, said once.
    fn eq(&self, other: &Self) -> bool {
        self.number == other.number
    }
}

impl Toast {
    /// A message that stays true whatever is done on the page.
    pub fn new(tone: ToastTone, title: impl Into<String>, text: impl Into<String>) -> Self {
        static SAID: AtomicU32 = AtomicU32::new(0);
        Self {
            title: title.into(),
            text: text.into(),
            tone,
            action: None,
            holds: Arc::new(|| true),
            number: SAID.fetch_add(1, Ordering::Relaxed),
        }
    }

    /// The same with a button.
    #[must_use]
    pub fn with(mut self, action: ToastAction) -> Self {
        self.action = Some(action);
        self
    }

    /// The same, said only as long as something holds; it reads signals.
    #[must_use]
    pub fn only_while(mut self, holds: impl Fn() -> bool + Send + Sync + 'static) -> Self {
        self.holds = Arc::new(holds);
        self
    }

    /// Whether it still holds.
    #[must_use]
    pub fn holds(&self) -> bool {
        (self.holds)()
    }
}

impl Lab {
    /// Says something about the maze and the room that are open; with another of them it is over.
    pub fn say(self, tone: ToastTone, title: impl Into<String>, text: impl Into<String>) {
        self.say_while(tone, title, text, || true);
    }

    /// The same, said only as long as something else holds too; it reads signals.
    pub fn say_while(
        self,
        tone: ToastTone,
        title: impl Into<String>,
        text: impl Into<String>,
        holds: impl Fn() -> bool + Send + Sync + 'static,
    ) {
        let here = self.stays_here();
        self.tell(Toast::new(tone, title, text).only_while(move || here() && holds()));
    }

    /// Says that something was done to the maze which can be taken back, until something else is done to it.
    pub fn say_done(self, text: impl Into<String>) {
        let said = Toast::new(ToastTone::Info, "", text).with(ToastAction::Undo);
        self.tell(said.only_while(self.stays_here()));
    }

    /// Shows a message in place of the one before.
    pub fn tell(self, toast: Toast) {
        self.toast.set(Some(toast));
    }

    /// Whether room and maze are still what they are now.
    fn stays_here(self) -> impl Fn() -> bool + Send + Sync + 'static {
        let (room, maze) = (self.room.get_untracked(), self.maze.get_untracked());
        move || self.room.get() == room && self.maze.with(|now| *now == maze)
    }
}
