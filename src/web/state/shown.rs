//! What can be open on the page: a room, a dialog, a message at the lower edge.

use crate::maze::checks::Cure;

/// The rooms of the lab.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Room {
    /// Draw a maze.
    Draw,
    /// Step through a run.
    Step,
    /// Explorers side by side, and the league.
    Compare,
    /// A real robot on a serial line.
    Connect,
    /// Measurements, in development builds.
    Bench,
}

/// Where somebody is: a room, or a page of one. The address and the document's title tell it.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Place {
    /// The room Draw.
    Draw,
    /// The room Step.
    Step,
    /// The same in large type.
    Projector,
    /// The room Compare.
    Compare,
    /// Its page for many mazes.
    League,
    /// The room Connect.
    Connect,
    /// Measurements.
    Bench,
}

impl Place {
    /// Its name in the address.
    #[must_use]
    pub const fn hash(self) -> &'static str {
        match self {
            Self::Draw => "draw",
            Self::Step => "step",
            Self::Projector => "projector",
            Self::Compare => "compare",
            Self::League => "league",
            Self::Connect => "connect",
            Self::Bench => "bench",
        }
    }

    /// The place of this name.
    #[must_use]
    pub fn of_hash(hash: &str) -> Option<Self> {
        match hash {
            "draw" => Some(Self::Draw),
            // The page's address before a room was opened.
            "step" | "" => Some(Self::Step),
            "projector" => Some(Self::Projector),
            "compare" => Some(Self::Compare),
            "league" => Some(Self::League),
            "connect" => Some(Self::Connect),
            "bench" if crate::web::browser::is_development() => Some(Self::Bench),
            _ => None,
        }
    }

    /// The room.
    #[must_use]
    pub const fn room(self) -> Room {
        match self {
            Self::Draw => Room::Draw,
            Self::Step | Self::Projector => Room::Step,
            Self::Compare | Self::League => Room::Compare,
            Self::Connect => Room::Connect,
            Self::Bench => Room::Bench,
        }
    }

    /// Its name for people.
    #[must_use]
    pub const fn name(self) -> &'static str {
        match self {
            Self::Draw => "Draw",
            Self::Step => "Step",
            Self::Projector => "Projector",
            Self::Compare => "Compare",
            Self::League => "League",
            Self::Connect => "Connect",
            Self::Bench => "Benches",
        }
    }
}

/// What a dialog shows.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Dialog {
    /// All keys.
    Keys,
    /// The glossary, opened at a name.
    Glossary(Option<&'static str>),
    /// All errata of the book.
    Errata,
    /// A link, its QR code, or a file instead.
    Share,
    /// Preference order, epsilon, `NODE_MAX`.
    Settings,
    /// A new, empty maze.
    New,
    /// Another size for the maze.
    Resize,
    /// Title, source and note.
    About,
    /// What can be done with a turn list.
    TurnList,
    /// A maze as text, to be pasted.
    Paste,
    /// All samples.
    Samples,
    /// Who is compared; the Compare room's own.
    Lineup,
}

/// A short message at the lower edge.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Toast {
    /// What it is about; may be empty.
    pub title: String,
    /// What happened, and the cure.
    pub text: String,
    /// Whether it is an error.
    pub tone: ToastTone,
    /// What can be done at once.
    pub action: Option<ToastAction>,
}

impl Toast {
    /// Something was done that can be taken back.
    #[must_use]
    pub const fn done(text: String) -> Self {
        Self { title: String::new(), text, tone: ToastTone::Info, action: Some(ToastAction::Undo) }
    }

    /// Whether it goes after a while: what is to be read or to be answered stays.
    #[must_use]
    pub const fn passes(&self) -> bool {
        match (self.tone, &self.action) {
            (ToastTone::Error | ToastTone::Remark, _)
            | (_, Some(ToastAction::Update | ToastAction::Cure(_))) => false,
            (ToastTone::Info, Some(ToastAction::Undo | ToastAction::Redo) | None) => true,
        }
    }

    /// Whether it speaks of the maze as it is, and is over when that changes.
    #[must_use]
    pub const fn is_about_maze(&self) -> bool {
        matches!(self.tone, ToastTone::Remark)
            || matches!(self.action, Some(ToastAction::Undo | ToastAction::Redo | ToastAction::Cure(_)))
    }
}

/// How a toast is meant.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum ToastTone {
    /// Something was done.
    Info,
    /// Something was done, and there is more to know about it.
    Remark,
    /// Something cannot be done.
    Error,
}

/// A toast's button.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum ToastAction {
    /// Takes back the last edit.
    Undo,
    /// Makes it again.
    Redo,
    /// Uses the new version of the page.
    Update,
    /// Cures what the maze lacks.
    Cure(Cure),
}
