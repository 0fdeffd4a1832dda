//! Every explorer there is, by the name that the command line and links use, and what is to be known before
//! choosing one.

use core::fmt;
use core::str::FromStr;

use super::book::errata::Erratum;
use super::tell::Case;

mod abouts;
mod off;

/// An explorer.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum Name {
    /// The book's own.
    #[default]
    Book,
    /// Left hand on the wall.
    LeftHand,
    /// Right hand on the wall.
    RightHand,
    /// Sakib's direction sums, left first.
    DirectionSumLeft,
    /// Sakib's direction sums, right first.
    DirectionSumRight,
    /// Sakib's full mapping.
    Mapping,
    /// PAReX path mapping, left hand on the wall.
    ParexLeft,
    /// PAReX path mapping, right hand on the wall.
    ParexRight,
    /// Cornell's first: turn by turn.
    Cornell1,
    /// Cornell's second: unvisited neighbours first.
    Cornell2,
    /// Cornell's third: the same with path planning.
    Cornell3,
    /// Trémaux's marks.
    Tremaux,
    /// Depth first.
    DepthFirst,
    /// Flood fill, with the goal told.
    FloodFill,
}

/// Where an explorer stops.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Stops {
    /// At nodes, corners, dead ends, the finish and the start.
    Line,
    /// At every lattice point.
    Square,
}

/// What in a mind can change a decision that it took before at the same place with the same heading: what the
/// referee has to know to tell circling from exploring.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Memory {
    /// Nothing: the same place and heading once more is circling.
    None,
    /// Which squares were visited: the same place and heading once more, and no new square in between.
    Visited,
    /// It ends by itself.
    Enough,
}

/// What an explorer is after.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Seeks {
    /// The finish, which ends the run.
    Finish,
    /// All there is; a finish on the way is noted.
    Map,
}

/// A setting that an explorer heeds besides the pace, which all heed.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Setting {
    /// `order`
    Order,
    /// `epsilon_ms`
    Epsilon,
    /// `node_max`
    NodeMax,
    /// `rule`
    Rule,
    /// `path_max`
    PathMax,
    /// `search`
    Search,
}

/// What of an explorer its source does not say, so that the lab had to read it into it or fill it in.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Reading {
    /// How much of it.
    pub extent: Extent,
    /// What, in a sentence or two.
    pub text: &'static str,
}

/// How much of an explorer is the lab's.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Extent {
    /// Some lines, which are marked.
    Parts,
    /// All of it: the source gives the idea, or there is no single one.
    Whole,
}

impl Extent {
    /// In a few words.
    #[must_use]
    pub const fn words(self) -> &'static str {
        match self {
            Self::Parts => "in part the lab’s reading",
            Self::Whole => "the lab’s own wording",
        }
    }
}

/// What is to be known about an explorer.
#[derive(Debug)]
pub struct About {
    /// As the page writes it.
    pub title: &'static str,
    /// Who described it, and where.
    pub source: &'static str,
    /// How it works, in a sentence or two.
    pub idea: &'static str,
    /// What it cannot do, in a sentence or two.
    pub cannot: &'static str,
    /// The sample that shows this: a file in `mazes/`, without `.maze`.
    pub sample: &'static str,
    /// Where it stops.
    pub stops: Stops,
    /// What it is after.
    pub seeks: Seeks,
    /// What decides whether it circles.
    pub memory: Memory,
    /// How its bytes on the robot are counted.
    pub bytes: &'static str,
    /// Its pseudo-code; the book's has a listing of its own, `book::code::LISTING`.
    pub listing: &'static [&'static str],
    /// Which of these lines are the lab's reading, in part at least; the book's are `book::code::OURS`.
    pub ours: &'static [bool],
    /// What of the explorer is the lab's reading of its source.
    pub reading: Reading,
    /// What a stop can be; the book's has an enum of its own, `book::Case`.
    pub cases: &'static [Case],
    /// Where the source slips or leaves something open.
    pub errata: &'static [Erratum],
}

impl Name {
    /// All of them, the book's first.
    pub const ALL: &'static [Self] = &[
        Self::Book,
        Self::LeftHand,
        Self::RightHand,
        Self::DirectionSumLeft,
        Self::DirectionSumRight,
        Self::Mapping,
        Self::ParexLeft,
        Self::ParexRight,
        Self::Cornell1,
        Self::Cornell2,
        Self::Cornell3,
        Self::Tremaux,
        Self::DepthFirst,
        Self::FloodFill,
    ];

    /// As the command line and links write it.
    #[must_use]
    pub const fn text(self) -> &'static str {
        // Not among what is to be known about it, which the page loads when someone asks.
        match self {
            Self::Book => "book",
            Self::LeftHand => "left-hand",
            Self::RightHand => "right-hand",
            Self::DirectionSumLeft => "direction-sum-left",
            Self::DirectionSumRight => "direction-sum-right",
            Self::Mapping => "mapping",
            Self::ParexLeft => "parex-left",
            Self::ParexRight => "parex-right",
            Self::Cornell1 => "cornell-1",
            Self::Cornell2 => "cornell-2",
            Self::Cornell3 => "cornell-3",
            Self::Tremaux => "tremaux",
            Self::DepthFirst => "depth-first",
            Self::FloodFill => "flood-fill",
        }
    }

    /// As people read it where there is little room, in tables and plots: the beginning of its title.
    #[must_use]
    pub const fn short(self) -> &'static str {
        match self {
            Self::Book => "Book",
            Self::LeftHand => "Left hand",
            Self::RightHand => "Right hand",
            Self::DirectionSumLeft => "Direction sums, left",
            Self::DirectionSumRight => "Direction sums, right",
            Self::Mapping => "Full mapping",
            Self::ParexLeft => "Path mapping, left",
            Self::ParexRight => "Path mapping, right",
            Self::Cornell1 => "Cornell 1",
            Self::Cornell2 => "Cornell 2",
            Self::Cornell3 => "Cornell 3",
            Self::Tremaux => "Trémaux",
            Self::DepthFirst => "Depth first",
            Self::FloodFill => "Flood fill",
        }
    }

    /// Whether it heeds a setting, besides the pace, which all heed.
    #[must_use]
    pub const fn heeds(self, setting: Setting) -> bool {
        match self {
            Self::Book => matches!(setting, Setting::Order | Setting::Epsilon | Setting::NodeMax),
            Self::Tremaux | Self::DepthFirst => matches!(setting, Setting::Order | Setting::Epsilon),
            Self::Mapping => matches!(setting, Setting::Epsilon | Setting::Search),
            Self::ParexLeft | Self::ParexRight => matches!(setting, Setting::Rule | Setting::PathMax),
            Self::LeftHand
            | Self::RightHand
            | Self::DirectionSumLeft
            | Self::DirectionSumRight
            | Self::Cornell1
            | Self::Cornell2
            | Self::Cornell3
            | Self::FloodFill => false,
        }
    }

    /// What is to be known about it.
    #[must_use]
    pub const fn about(self) -> &'static About {
        match self {
            Self::Book => &abouts::BOOK,
            Self::LeftHand => &abouts::LEFT_HAND,
            Self::RightHand => &abouts::RIGHT_HAND,
            Self::DirectionSumLeft => &abouts::SUM_LEFT,
            Self::DirectionSumRight => &abouts::SUM_RIGHT,
            Self::Mapping => &abouts::MAPPING,
            Self::ParexLeft => &abouts::PAREX_LEFT,
            Self::ParexRight => &abouts::PAREX_RIGHT,
            Self::Cornell1 => &abouts::CORNELL_1,
            Self::Cornell2 => &abouts::CORNELL_2,
            Self::Cornell3 => &abouts::CORNELL_3,
            Self::Tremaux => &abouts::TREMAUX,
            Self::DepthFirst => &abouts::DEPTH_FIRST,
            Self::FloodFill => &abouts::FLOOD_FILL,
        }
    }
}

impl fmt::Display for Name {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(self.text())
    }
}

/// A text that names no explorer.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct NotAnExplorer;

impl fmt::Display for NotAnExplorer {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str("no explorer has this name; choose one of")?;
        Name::ALL.iter().try_for_each(|name| write!(f, " {name}"))
    }
}

impl core::error::Error for NotAnExplorer {}

impl FromStr for Name {
    type Err = NotAnExplorer;

    fn from_str(text: &str) -> Result<Self, NotAnExplorer> {
        Self::ALL.iter().copied().find(|name| name.text() == text).ok_or(NotAnExplorer)
    }
}
