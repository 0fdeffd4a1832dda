//! Every explorer's names and what they mean, under the names that its source uses; the book's own are in
//! [`super::book::glossary`]. They are apart from the algorithms' files, as the page loads them when someone asks.

pub use super::book::glossary::{Belongs, Entry, Kind, Token};

use super::book::glossary::{GLOSSARY, pieces};
use super::name::Name;

/// Makes a glossary: for each kind, owner and section its names, with what they mean and where they are seen.
macro_rules! entries {
    ($($kind:ident $belongs:ident $section:literal {
        $($name:literal $meaning:literal $seen:literal)*
    })*) => {
        pub(super) static ENTRIES: &[super::Entry] = &[$($(super::Entry {
            name: $name,
            aliases: &[],
            kind: super::Kind::$kind,
            meaning: $meaning,
            seen: $seen,
            belongs: super::Belongs::$belongs,
            section: $section,
        }),*),*];
    };
}

mod cornell;
mod depth_first;
mod flood_fill;
mod hand;
mod mapping;
mod parex;
mod sums;
mod tremaux;

/// An explorer's glossary.
#[must_use]
pub fn of(name: Name) -> &'static [Entry] {
    match name {
        Name::Book => GLOSSARY,
        Name::LeftHand | Name::RightHand => hand::ENTRIES,
        Name::DirectionSumLeft | Name::DirectionSumRight => sums::ENTRIES,
        Name::Mapping => mapping::ENTRIES,
        Name::ParexLeft | Name::ParexRight => parex::ENTRIES,
        Name::Cornell1 | Name::Cornell2 | Name::Cornell3 => cornell::ENTRIES,
        Name::Tremaux => tremaux::ENTRIES,
        Name::DepthFirst => depth_first::ENTRIES,
        Name::FloodFill => flood_fill::ENTRIES,
    }
}

/// The entry of a name as the page writes it, brackets and all.
///
/// ```
/// use line_maze_lab::explorer::glossary::entry;
/// use line_maze_lab::explorer::name::Name;
/// assert_eq!(entry(Name::ParexLeft, "CSIP").map(|entry| entry.name), Some("CSIP"));
/// assert_eq!(entry(Name::DirectionSumLeft, "a[j]").map(|entry| entry.name), Some("a"));
/// assert_eq!(entry(Name::LeftHand, "CSIP"), None);
/// ```
#[must_use]
pub fn entry(explorer: Name, written: &str) -> Option<&'static Entry> {
    let word = written.split(['(', '[']).next().unwrap_or(written);
    let is = |entry: &&Entry| {
        [written, word].iter().any(|name| entry.name == *name || entry.aliases.contains(name))
    };
    of(explorer).iter().find(is)
}

/// A line of an explorer's pseudo-code in pieces; names are as its glossary has them.
pub fn split(explorer: Name, line: &str) -> impl Iterator<Item = Token<'_>> {
    pieces(line, move |word, rest| {
        let entry = of(explorer).iter().find(|entry| entry.name == word)?;
        entry.kind.stands(rest).then_some(entry.name)
    })
}
