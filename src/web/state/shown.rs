//! What can be open on the page: a room, a dialog.

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

impl Room {
    /// Its name in the address.
    #[must_use]
    pub const fn hash(self) -> &'static str {
        match self {
            Self::Draw => "draw",
            Self::Step => "step",
            Self::Compare => "compare",
            Self::Connect => "connect",
            Self::Bench => "bench",
        }
    }

    /// The room of this name.
    #[must_use]
    pub fn of_hash(hash: &str) -> Option<Self> {
        match hash {
            "draw" => Some(Self::Draw),
            // The page's address before a room was opened.
            "step" | "" => Some(Self::Step),
            "compare" | "league" => Some(Self::Compare),
            "connect" => Some(Self::Connect),
            "bench" if crate::web::browser::is_development() => Some(Self::Bench),
            _ => None,
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
