//! What a reader made of a file besides what is written there: a maze is read wherever it can only be meant one
//! way, and then its owner is told how it was read.

use alloc::vec::Vec;
use core::fmt;

use super::json::Layout;
use super::text::Place;
use super::{Maze, Start};

/// A maze as it was read, and what there is to say about that.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Reading {
    /// The maze.
    pub maze: Maze,
    /// What its owner should know, in the order in which it was found.
    pub remarks: Vec<Remark>,
}

/// Something that a file's owner should know.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Remark {
    /// Walls that nobody knows were taken as walls.
    UnknownWalls {
        /// How many.
        walls: u32,
        /// The first of them.
        first: Place,
    },
    /// Walls that are drawn in part: where the middle is drawn, they were taken as walls.
    PartWalls {
        /// How many.
        walls: u32,
        /// The first of them.
        first: Place,
    },
    /// Another character than usual was taken for the posts.
    Posts {
        /// The character.
        post: char,
        /// The first post.
        first: Place,
    },
    /// What stands before the maze was left out.
    Before {
        /// The maze's first line.
        line: u32,
    },
    /// What stands after the maze was left out.
    After {
        /// The first line that was left out.
        line: u32,
    },
    /// The maze does not begin in the first column.
    Indented {
        /// By how much.
        columns: u32,
        /// The maze's first line.
        line: u32,
    },
    /// A grid of walls as thick as ways: how it was read.
    Grid(Grid),
    /// A way in or out through the outer wall was taken for the square inside.
    Entrance(Place),
    /// A list of walls: how it was read.
    List(Layout),
    /// The file gives no heading: the robot faces its only way.
    Faces(Start),
    /// The file names no start.
    NoStart {
        /// Where it was put, if anywhere.
        put: Option<Start>,
    },
    /// The file names no finish, and it stays without.
    NoFinish,
    /// The file names no finish; where it is from, that means the centre.
    FinishInCentre,
}

/// What the characters of a grid are.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Grid {
    /// Squares and the walls between them, in turn.
    Between,
    /// Squares that are open or not.
    Squares,
}

impl Remark {
    /// The place in the file that it is about; none where it is about all of it.
    #[must_use]
    pub const fn place(&self) -> Option<Place> {
        match *self {
            Self::UnknownWalls { first, .. }
            | Self::PartWalls { first, .. }
            | Self::Posts { first, .. }
            | Self::Entrance(first) => Some(first),
            Self::Before { line } | Self::After { line } | Self::Indented { line, .. } => {
                Some(Place { line, column: 1 })
            }
            Self::Grid(_)
            | Self::List(_)
            | Self::Faces(_)
            | Self::NoStart { .. }
            | Self::NoFinish
            | Self::FinishInCentre => None,
        }
    }
}

/// A sentence without its place.
impl fmt::Display for Remark {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match *self {
            Self::UnknownWalls { walls: 1, .. } => f.write_str("1 unknown wall was taken as a wall."),
            Self::UnknownWalls { walls, .. } => write!(f, "{walls} unknown walls were taken as walls."),
            Self::PartWalls { walls: 1, .. } => {
                f.write_str("1 wall is drawn in part; its middle says whether it is one.")
            }
            Self::PartWalls { walls, .. } => {
                write!(f, "{walls} walls are drawn in part; their middles say whether they are.")
            }
            Self::Posts { post, .. } => write!(f, "“{post}” was taken for the posts, which usually are “o”."),
            Self::Before { line } => {
                write!(f, "The maze begins in line {line}; what stands before it was left out.")
            }
            Self::After { line } => {
                write!(f, "The maze ends before line {line}; what stands there was left out.")
            }
            Self::Indented { columns: 1, .. } => {
                f.write_str("The maze is indented by 1 column, which was left out.")
            }
            Self::Indented { columns, .. } => {
                write!(f, "The maze is indented by {columns} columns, which were left out.")
            }
            Self::Grid(Grid::Between) => {
                f.write_str("It was read as a grid in which squares and the walls between them take turns.")
            }
            Self::Grid(Grid::Squares) => {
                f.write_str("It was read as a grid in which every open place is a square.")
            }
            Self::Entrance(_) => f.write_str(
                "The way through the outer wall was closed, and the square inside it taken instead.",
            ),
            Self::List(layout) => write!(f, "It was read as a list of walls: {layout}."),
            Self::Faces(start) => write!(
                f,
                "The file gives no heading; at the start {} the robot faces {}, its only way.",
                start.at,
                start.heading.word()
            ),
            Self::NoStart { put: Some(start) } => {
                write!(f, "The file names no start; it was put in the south-west, {}.", start.at)
            }
            Self::NoStart { put: None } => f.write_str("The file names no start."),
            Self::NoFinish => f.write_str("The file names no finish."),
            Self::FinishInCentre => {
                f.write_str("The file names no finish; in a .map file that means the centre.")
            }
        }
    }
}
