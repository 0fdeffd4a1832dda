//! Every explorer there is, by the name that the command line and links use, and what is to be known before
//! choosing one.

use core::fmt;
use core::str::FromStr;

use super::book::errata::Erratum;
use super::tell::Case;
use super::{book, cornell, depth_first, flood_fill, hand, mapping, parex, sums, tremaux};

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
            Self::Mapping => &MAPPING,
            Self::ParexLeft => &PAREX_LEFT,
            Self::ParexRight => &PAREX_RIGHT,
            Self::Cornell1 => &CORNELL_1,
            Self::Cornell2 => &CORNELL_2,
            Self::Cornell3 => &CORNELL_3,
            Self::Tremaux => &TREMAUX,
            Self::DepthFirst => &DEPTH_FIRST,
            Self::FloodFill => &FLOOD_FILL,
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

static MAPPING: About = About {
    name: "mapping",
    title: "Full mapping",
    source: "S. Sakib, A. Chowdhury, S. T. Ahamed and S. Imam Hasan, Maze solving algorithm for line following robot, 2014, §III and §IV",
    idea: "It records every point with its coordinates until no way is unexplored, and then finds the shortest and the quickest way on its map.",
    cannot: "It drives every line even where the finish is next to the start, and it lives on its coordinates: when they drift further than the tolerance, it takes places for each other.",
    sample: "long-way",
    settings: &[Setting::Epsilon, Setting::Search],
    stops: Stops::Line,
    seeks: Seeks::Map,
    memory: Memory::Enough,
    bytes: "10 for each column: five numbers of an int each",
    listing: mapping::LISTING,
    cases: mapping::CASES,
    errata: mapping::ERRATA,
};

const PAREX: About = About {
    name: "",
    title: "",
    source: "Fred Swirbul, Maze path mapping, Phoenix Area Robotics eXperimenters, 2002",
    idea: "It keeps one hand on the wall, numbers the squares, and lists those of its way. What led back to a square of the list is cut out of it.",
    cannot: "It circles where a loop lies around the finish, and where a loop has a shorter side it never notices: only a square that comes twice is cut out (special case 2).",
    sample: "parex-special-2",
    settings: &[Setting::Rule, Setting::PathMax],
    stops: Stops::Square,
    seeks: Seeks::Finish,
    memory: Memory::None,
    bytes: "2 for each square of the path at its longest",
    listing: parex::LISTING,
    cases: &[],
    errata: &[],
};

static PAREX_LEFT: About = About {
    name: "parex-left",
    title: "Path mapping, left hand",
    cases: parex::CASES,
    errata: parex::ERRATA,
    ..PAREX
};
static PAREX_RIGHT: About = About {
    name: "parex-right",
    title: "Path mapping, right hand",
    cases: parex::CASES,
    errata: parex::ERRATA,
    ..PAREX
};

const CORNELL: About = About {
    name: "",
    title: "",
    source: "A Cornell team’s Milestone 3: maze traversing, 2018",
    idea: "",
    cannot: "",
    sample: "",
    settings: &[],
    stops: Stops::Square,
    seeks: Seeks::Map,
    memory: Memory::None,
    bytes: "1 for each square of the field",
    listing: cornell::LISTING,
    cases: &[],
    errata: &[],
};

static CORNELL_1: About = About {
    name: "cornell-1",
    title: "Cornell 1, turn by turn",
    idea: "It drives ahead until there is a wall, then turns left, else right, else round. It keeps a map but does not look at it.",
    cannot: "It goes round and round in most mazes and leaves much of the field unseen.",
    sample: "cornell-3x5",
    cases: cornell::CASES,
    ..CORNELL
};
static CORNELL_2: About = About {
    name: "cornell-2",
    title: "Cornell 2, unvisited first",
    idea: "It prefers neighbours that it has not visited; where all were visited, it drives as the first does.",
    cannot: "It looks one square far. Among visited squares it can go round for ever, though an unvisited one is near.",
    sample: "cornell-6x4",
    memory: Memory::Visited,
    cases: cornell::CASES,
    ..CORNELL
};
static CORNELL_3: About = About {
    name: "cornell-3",
    title: "Cornell 3, with path planning",
    idea: "It prefers neighbours that it has not visited; where all were visited, it drives to the nearest square that was not.",
    cannot: "It maps the whole field even where the finish is next to the start, and needs to be told how large the field is.",
    sample: "long-way",
    memory: Memory::Enough,
    cases: cornell::CASES,
    ..CORNELL
};

static TREMAUX: About = About {
    name: "tremaux",
    title: "Trémaux’s marks",
    source: "Édouard Lucas, Récréations mathématiques, 1882, after Trémaux",
    idea: "At each node it marks every way in and out. A way with two marks is never used again; at the finish, those with one are the route.",
    cannot: "Its route need not be short: where it closes a loop it turns round, and never learns that the new way was the better one.",
    sample: "long-way",
    settings: &[Setting::Order, Setting::Epsilon],
    stops: Stops::Line,
    seeks: Seeks::Finish,
    memory: Memory::Enough,
    bytes: "8 for each node: two ints of coordinates, a byte of marks for each way",
    listing: tremaux::LISTING,
    cases: tremaux::CASES,
    errata: &[],
};

static DEPTH_FIRST: About = About {
    name: "depth-first",
    title: "Depth first",
    source: "Textbooks, for comparison",
    idea: "At a new node it takes the first unused way; where it closes a loop it turns round; when all ways are used it goes back as it came.",
    cannot: "Its route need not be short: where it closes a loop it turns round, and never learns that the new way was the better one.",
    sample: "long-way",
    settings: &[Setting::Order, Setting::Epsilon],
    stops: Stops::Line,
    seeks: Seeks::Finish,
    memory: Memory::Enough,
    bytes: "6 for each node: two ints of coordinates, a byte each of first entry and used ways",
    listing: depth_first::LISTING,
    cases: depth_first::CASES,
    errata: &[],
};

static FLOOD_FILL: About = About {
    name: "flood-fill",
    title: "Flood fill, goal told",
    source: "Micromouse practice, for comparison; S. Sakib and others, 2014, §I, name it as one that must know the goal",
    idea: "It is told where the goal is, takes every wall that it has not seen for open, and always goes to the square that is nearest to the goal by its map.",
    cannot: "Without the goal it can do nothing: a line maze’s finish is not known before it is found. Its first way there need not be the shortest.",
    sample: "fast-or-short",
    settings: &[],
    stops: Stops::Square,
    seeks: Seeks::Finish,
    memory: Memory::Enough,
    bytes: "3 for each square of the field: an int of distance, a byte of walls",
    listing: flood_fill::LISTING,
    cases: flood_fill::CASES,
    errata: &[],
};
