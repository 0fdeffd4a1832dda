//! The book's tables 2.1 and 2.2 in our own words: every name of the pseudo-code and of the inspector.

mod names;
mod split;

pub use names::{GLOSSARY, SPELLINGS};
pub use split::{Token, pieces, split};

/// A name and what it means.
#[derive(Debug, PartialEq, Eq)]
pub struct Entry {
    /// As the lab writes it; functions without their brackets.
    pub name: &'static str,
    /// Other spellings that the book has for it.
    pub aliases: &'static [&'static str],
    /// What it is.
    pub kind: Kind,
    /// What it means.
    pub meaning: &'static str,
    /// Where it is seen in the lab.
    pub seen: &'static str,
    /// Whose it is.
    pub belongs: Belongs,
    /// Where the book has it; empty where it hasn't.
    pub section: &'static str,
}

impl Kind {
    /// Whether a word is this name where it stands: `rest` is what follows it.
    #[must_use]
    pub fn stands(self, rest: &str) -> bool {
        match self {
            Self::Variable | Self::Field => !rest.starts_with('('),
            Self::Array => rest.starts_with(['(', '[']),
            Self::Function => rest.starts_with('('),
            Self::Case => true,
            Self::Term => false,
        }
    }
}

/// A name as it is written.
#[derive(Debug, PartialEq, Eq)]
pub struct Spelling {
    /// As the lab writes it.
    pub name: &'static str,
    /// Other spellings that the book has for it.
    pub aliases: &'static [&'static str],
    /// What it is.
    pub kind: Kind,
}

/// What a name is.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Kind {
    /// A variable or a constant.
    Variable,
    /// A field of a node.
    Field,
    /// An array: it counts as such before a bracket only.
    Array,
    /// A function: it counts as such before its bracket only.
    Function,
    /// What a stop can be.
    Case,
    /// A word of the listing's plain sentences: no link there.
    Term,
}

/// Whose a name is.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Belongs {
    /// The source's, and shown in the lab.
    Shown,
    /// The physical robot's: its sensors, motors and line control.
    Robot,
    /// Ours: the source does without it or leaves it unnamed.
    Ours,
}

/// The entry of a name, in any of its spellings; brackets after it don't matter.
///
/// ```
/// use line_maze_lab::explorer::book::glossary::entry;
/// assert_eq!(entry("curr_x"), entry("cur_x"));
/// assert_eq!(entry("paths[4]").map(|entry| entry.section), Some("Table 2.2, §2.4.2"));
/// assert_eq!(entry("map"), None);
/// ```
#[must_use]
pub fn entry(name: &str) -> Option<&'static Entry> {
    let name = name.split(['(', '[']).next().unwrap_or(name);
    GLOSSARY.iter().find(|entry| entry.name == name || entry.aliases.contains(&name))
}
