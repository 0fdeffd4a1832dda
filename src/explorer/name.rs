//! Every explorer there is, by the name that the command line and links use, and what is to be known before
//! choosing one.

use core::fmt;
use core::str::FromStr;

use super::book::errata::Erratum;
use super::tell::Case;
use super::{book, hand, sums};

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

/// What is to be known about an explorer.
#[derive(Debug)]
pub struct About {
    /// As the command line and links write it.
    pub name: &'static str,
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
    /// What of the settings it heeds.
    pub settings: &'static [Setting],
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
    /// What a stop can be; the book's has an enum of its own, `book::Case`.
    pub cases: &'static [Case],
    /// Where the source slips or leaves something open.
    pub errata: &'static [Erratum],
}

impl Name {
    /// All of them, the book's first.
    pub const ALL: &'static [Self] =
        &[Self::Book, Self::LeftHand, Self::RightHand, Self::DirectionSumLeft, Self::DirectionSumRight];

    /// As the command line and links write it.
    #[must_use]
    pub const fn text(self) -> &'static str {
        self.about().name
    }

    /// What is to be known about it.
    #[must_use]
    pub const fn about(self) -> &'static About {
        match self {
            Self::Book => &BOOK,
            Self::LeftHand => &LEFT_HAND,
            Self::RightHand => &RIGHT_HAND,
            Self::DirectionSumLeft => &SUM_LEFT,
            Self::DirectionSumRight => &SUM_RIGHT,
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

static BOOK: About = About {
    name: "book",
    title: "The book’s explorer",
    source: "Akash Dhasade and Saket Joshi, Maze Solving Robot, 2017, chapters 2 and 3",
    idea: "It remembers the nodes of its way in a table, knows them again by their coordinates, and forgets them when nothing is left there.",
    cannot: "It drives every line of a maze with loops, yet may come home with a long way round: what it learns of a node by coming back to it from elsewhere is thrown away.",
    sample: "long-way",
    settings: &[Setting::Order, Setting::Epsilon, Setting::NodeMax],
    stops: Stops::Line,
    seeks: Seeks::Finish,
    memory: Memory::Enough,
    bytes: "15 for each node that it remembers at once",
    listing: &[],
    cases: &[],
    errata: book::errata::ERRATA,
};

const HAND: About = About {
    name: "",
    title: "",
    source: "Akash Dhasade and Saket Joshi, Maze Solving Robot, 2017, §1.2",
    idea: "It keeps one hand on the wall. Of its way it remembers the turns, and where a way led back, three letters become one.",
    cannot: "Where lines close a loop it can go round for ever, and what it finds need not be short: it never knows that it has been somewhere before.",
    sample: "hand-circles",
    settings: &[],
    stops: Stops::Line,
    seeks: Seeks::Finish,
    memory: Memory::None,
    bytes: "1 for each letter",
    listing: hand::LISTING,
    cases: &[],
    errata: &[],
};

static LEFT_HAND: About =
    About { name: "left-hand", title: "Left hand on the wall", cases: hand::CASES, ..HAND };
static RIGHT_HAND: About =
    About { name: "right-hand", title: "Right hand on the wall", cases: hand::CASES, ..HAND };

const SUM: About = About {
    name: "",
    title: "",
    source: "S. Sakib, A. Chowdhury, S. T. Ahamed and S. Imam Hasan, Maze solving algorithm for line following robot, 2014, §II",
    idea: "Each junction of the way has a number, to which every way that is tried there adds its direction. At the finish the numbers are the route.",
    cannot: "It drives as a hand on the wall does, so it circles where the finish lies inside a loop. Even in a small loop without branches its numbers can hold a whole lap.",
    sample: "sums-lap",
    settings: &[],
    stops: Stops::Line,
    seeks: Seeks::Finish,
    memory: Memory::None,
    bytes: "1 for each number of the array",
    listing: sums::LISTING,
    cases: &[],
    errata: &[],
};

static SUM_LEFT: About =
    About { name: "direction-sum-left", title: "Direction sums, left first", cases: sums::CASES, ..SUM };
static SUM_RIGHT: About =
    About { name: "direction-sum-right", title: "Direction sums, right first", cases: sums::CASES, ..SUM };
