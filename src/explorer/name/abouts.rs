//! What is to be known about each explorer: source, idea, limits, and the sample that shows them.

use super::{About, Extent, Memory, Reading, Seeks, Stops};
use crate::explorer::{book, cornell, depth_first, flood_fill, hand, mapping, parex, sums, tremaux};
use Extent::{Parts, Whole};

pub(super) static BOOK: About = About {
    title: "The book’s explorer",
    source: "Akash Dhasade and Saket Joshi, Maze Solving Robot, 2017, chapters 2 and 3",
    idea: "It remembers the nodes of its way in a table, knows them again by their coordinates, and forgets them when nothing is left there.",
    cannot: "Its route need not be short: it keeps the first way to the finish that its order leads it to, and where a new way comes back to a node it turns round, without asking which way was the shorter.",
    sample: "long-way",
    stops: Stops::Line,
    seeks: Seeks::Finish,
    memory: Memory::Enough,
    bytes: "15 for each node that it remembers at once",
    listing: &[],
    ours: &[],
    reading: Reading {
        extent: Parts,
        text: "The book leaves its pseudo-code unwritten (§3.3): these lines are the lab’s, after §2.5 and §3.1. Where the book is silent or contradicts itself, the line is marked.",
    },
    cases: &[],
    errata: book::errata::ERRATA,
};

const HAND: About = About {
    title: "",
    source: "Akash Dhasade and Saket Joshi, Maze Solving Robot, 2017, §1.2",
    idea: "It keeps one hand on the wall. Of its way it remembers the turns, and where a way led back, three letters become one.",
    cannot: "Where lines close a loop it can go round for ever, and what it finds need not be short: it never knows that it has been somewhere before.",
    sample: "hand-circles",
    stops: Stops::Line,
    seeks: Seeks::Finish,
    memory: Memory::None,
    bytes: "1 for each letter",
    listing: hand::LISTING,
    ours: hand::OURS,
    reading: Reading {
        extent: Whole,
        text: "The book names LEFT-HAND-ON-THE-WALL and points to another page. The order of ways, the letters, how three of them become one, and the right hand are the lab’s, after common practice.",
    },
    cases: &[],
    errata: hand::ERRATA,
};

pub(super) static LEFT_HAND: About = About { title: "Left hand on the wall", cases: hand::CASES, ..HAND };
pub(super) static RIGHT_HAND: About = About { title: "Right hand on the wall", cases: hand::CASES, ..HAND };

const SUM: About = About {
    title: "",
    source: "S. Sakib, A. Chowdhury, S. T. Ahamed and S. Imam Hasan, Maze solving algorithm for line following robot, 2014, §II",
    idea: "Each junction of the way has a number, to which every way that is tried there adds its direction. At the finish the numbers are the route.",
    cannot: "It drives as a hand on the wall does, so it can circle where the finish lies inside a loop. Even in a small loop with only two branches, both outside, its numbers can hold a whole lap.",
    sample: "sums-lap",
    stops: Stops::Line,
    seeks: Seeks::Finish,
    memory: Memory::None,
    bytes: "1 for each number of the array",
    listing: sums::LISTING,
    ours: sums::OURS,
    reading: Reading {
        extent: Parts,
        text: "The paper counts down as 4, takes no remainder, and does not say what becomes of a junction whose ways are all tried, or of a maze without a finish. Those lines are the lab’s reading.",
    },
    cases: &[],
    errata: sums::ERRATA,
};

pub(super) static SUM_LEFT: About = About {
    title: "Direction sums, left first",
    // In the other sample its order leads straight to the finish.
    sample: "hand-circles",
    cases: sums::CASES,
    ..SUM
};
pub(super) static SUM_RIGHT: About =
    About { title: "Direction sums, right first", cases: sums::CASES, ..SUM };

pub(super) static MAPPING: About = About {
    title: "Full mapping",
    source: "S. Sakib, A. Chowdhury, S. T. Ahamed and S. Imam Hasan, Maze solving algorithm for line following robot, 2014, §III and §IV",
    idea: "It records every point with its coordinates until no way is unexplored, and then finds the shortest and the quickest way on its map.",
    cannot: "It drives every line even where the finish is next to the start, and it lives on its coordinates: where they drift further than the tolerance, it takes places for each other or does not know them again.",
    sample: "long-way",
    stops: Stops::Line,
    seeks: Seeks::Map,
    memory: Memory::Enough,
    bytes: "10 for each column: five numbers of an int each",
    listing: mapping::LISTING,
    ours: mapping::OURS,
    reading: Reading {
        extent: Parts,
        text: "The paper does not give its sequence of preference, nor which of two equally near points it drives to and how, and it counts Explored in two ways. Those lines are the lab’s reading.",
    },
    cases: mapping::CASES,
    errata: mapping::ERRATA,
};

const PAREX: About = About {
    title: "",
    source: "Fred Swirbul, Maze path mapping, Phoenix Area Robotics eXperimenters, 2002",
    idea: "It keeps one hand on the wall, numbers the squares, and lists those of its way. What led back to a square of the list is cut out of it.",
    cannot: "It can circle where a loop lies around the finish, and where a loop has a shorter side it need not notice: nothing is cut unless a square comes twice (special case 2).",
    sample: "parex-special-2",
    stops: Stops::Square,
    seeks: Seeks::Finish,
    memory: Memory::None,
    bytes: "2 for each square of the path at its longest",
    listing: parex::LISTING,
    ours: parex::OURS,
    reading: Reading {
        extent: Parts,
        text: "The article takes wall following as known, and its listing for special case 1 cannot run as printed. Those lines are the lab’s reading.",
    },
    cases: &[],
    errata: &[],
};

pub(super) static PAREX_LEFT: About = About {
    title: "Path mapping, left hand",
    // In the other sample its hand leads along the shorter side.
    sample: "hand-circles",
    cases: parex::CASES,
    errata: parex::ERRATA,
    ..PAREX
};
pub(super) static PAREX_RIGHT: About =
    About { title: "Path mapping, right hand", cases: parex::CASES, errata: parex::ERRATA, ..PAREX };

const CORNELL: About = About {
    title: "",
    source: "A Cornell team’s Milestone 3: maze traversing, 2018",
    idea: "",
    cannot: "",
    sample: "",
    stops: Stops::Square,
    seeks: Seeks::Map,
    memory: Memory::None,
    bytes: "1 for each square of the field",
    listing: cornell::LISTING,
    ours: cornell::OURS,
    reading: Reading { extent: Parts, text: "" },
    cases: &[],
    errata: &[],
};

pub(super) static CORNELL_1: About = About {
    title: "Cornell 1, turn by turn",
    idea: "It drives ahead until there is a wall, then turns left, else right, else round. It keeps a map but does not look at it.",
    cannot: "In many mazes it goes round and round and leaves a part of the field unseen.",
    sample: "cornell-3x5",
    reading: Reading {
        extent: Parts,
        text: "The page describes the driving. It tells of the map only for the second, and where the run ends is what the lab’s driver sees.",
    },
    errata: cornell::ERRATA_1,
    cases: cornell::CASES,
    ..CORNELL
};
pub(super) static CORNELL_2: About = About {
    title: "Cornell 2, unvisited first",
    idea: "It prefers neighbours that it has not visited; where all were visited, it drives as the first does.",
    cannot: "It looks one square far. Among visited squares it can go round for ever, though unvisited ones are left.",
    sample: "cornell-6x4",
    memory: Memory::Visited,
    reading: Reading {
        extent: Parts,
        text: "The page does not say to which of several unvisited neighbours the robot goes, nor when it is done. The order is the lab’s reading, and the lab’s driver ends the run.",
    },
    errata: cornell::ERRATA_2,
    cases: cornell::CASES,
    ..CORNELL
};
pub(super) static CORNELL_3: About = About {
    title: "Cornell 3, with path planning",
    source: "After a Cornell team’s Milestone 3: maze traversing, 2018, which describes its third algorithm elsewhere",
    idea: "It prefers neighbours that it has not visited; where all were visited, it drives to the nearest square that was not.",
    cannot: "It maps the whole field even where the finish is next to the start, and needs to be told how large the field is.",
    sample: "long-way",
    memory: Memory::Enough,
    reading: Reading {
        extent: Parts,
        text: "The page only says that searching and path planning were added and are described elsewhere. What and how the third searches, and where it ends, is the lab’s reading.",
    },
    errata: cornell::ERRATA_3,
    cases: cornell::CASES,
    ..CORNELL
};

pub(super) static TREMAUX: About = About {
    title: "Trémaux’s marks",
    source: "Édouard Lucas, Récréations mathématiques, 1882, after Trémaux",
    idea: "At each node it marks every way in and out. A way with two marks is never used again; at the finish, those with one are the route.",
    cannot: "Its route need not be short: it keeps the first way to the finish that its order leads it to, and where it closes a loop it turns round, without asking which way was the shorter.",
    sample: "long-way",
    stops: Stops::Line,
    seeks: Seeks::Finish,
    memory: Memory::Enough,
    bytes: "8 for each node: two ints of coordinates, a byte of marks for each way",
    listing: tremaux::LISTING,
    ours: tremaux::OURS,
    reading: Reading {
        extent: Whole,
        text: "The marks are Trémaux’s, as Lucas tells it. That the robot finds them again by coordinates, the order of ways and where it ends are the lab’s.",
    },
    cases: tremaux::CASES,
    errata: tremaux::ERRATA,
};

pub(super) static DEPTH_FIRST: About = About {
    title: "Depth first",
    source: "Textbooks, for comparison",
    idea: "At a new node it takes the first unused way; where it closes a loop it turns round; when all ways are used it goes back as it came.",
    cannot: "Its route need not be short: it keeps the first way to the finish that its order leads it to, and where it closes a loop it turns round, without asking which way was the shorter.",
    sample: "long-way",
    stops: Stops::Line,
    seeks: Seeks::Finish,
    memory: Memory::Enough,
    bytes: "6 for each node: two ints of coordinates, a byte each of first entry and used ways",
    listing: depth_first::LISTING,
    ours: depth_first::OURS,
    reading: Reading {
        extent: Whole,
        text: "The book names depth first search and no more (§1.2). How a robot has to drive it is the lab’s wording.",
    },
    cases: depth_first::CASES,
    errata: &[],
};

pub(super) static FLOOD_FILL: About = About {
    title: "Flood fill, goal told",
    source: "Micromouse practice, for comparison; S. Sakib and others, 2014, §I, name it as one that must know the goal",
    idea: "It is told where the goal is, takes every wall that it has not seen for open, and always goes to the square that is nearest to the goal by its map.",
    cannot: "Without the goal it can do nothing: a line maze’s finish is not known before it is found. Its first way there need not be the shortest.",
    sample: "fast-or-short",
    stops: Stops::Square,
    seeks: Seeks::Finish,
    memory: Memory::Enough,
    bytes: "3 for each square of the field: an int of distance, a byte of walls",
    listing: flood_fill::LISTING,
    ours: flood_fill::OURS,
    reading: Reading {
        extent: Whole,
        text: "The paper only names flood fill as one that must know the goal. The rules are the lab’s wording of micromouse practice.",
    },
    cases: flood_fill::CASES,
    errata: &[],
};
