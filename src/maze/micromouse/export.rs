//! Mazes as micromouse files, where they can be said: walls, start and finish must come through. Title, source,
//! note, sizes on the floor and where the lattice lies have no place in any of these forms.

use alloc::vec::Vec;
use core::fmt;

use super::{Form, binary, drawing, num};
use crate::geometry::{Heading, Point};
use crate::maze::{Kind, Maze};

/// Why a maze cannot be said in a form.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum CannotSay {
    /// It is drawn as lines.
    Lines,
    /// It has no start, and the form always has one.
    NoStart,
    /// The start faces another way than readers take it to face.
    StartHeading {
        /// As it faces.
        faces: Heading,
        /// As it would be read.
        read: Heading,
    },
    /// The start is not in the south-west, where the form has it.
    StartAt(Point),
    /// The start is part of the finish, and there is room for one letter in a square.
    StartOnFinish(Point),
    /// The finish is somewhere else than in the centre, and the form doesn't say it.
    Finish,
    /// A `.maz` is as high as it is wide.
    Size {
        /// The maze's squares from west to east.
        width: u32,
        /// Those from south to north.
        height: u32,
    },
}

impl fmt::Display for CannotSay {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Lines => f.write_str(
                "a micromouse file holds walls, and this maze is drawn as lines; make its kind “wall” first",
            ),
            Self::NoStart => f.write_str("a micromouse file has a start, and this maze has none; set one"),
            Self::StartHeading { faces, read } => write!(
                f,
                "a micromouse file gives no heading, and so the start would be read as facing {}, not {}; turn it",
                read.word(),
                faces.word()
            ),
            Self::StartAt(at) => write!(
                f,
                "in this format the start is the south-west square, and here it is {at}; move it, or write a .txt"
            ),
            Self::StartOnFinish(at) => {
                write!(f, "start and finish are both in {at}, and a square has room for one letter; move one")
            }
            Self::Finish => f.write_str(
                "in this format the finish is not written and means the centre; move it there, leave it out, or \
                 write a .txt",
            ),
            Self::Size { width, height } => write!(
                f,
                "a .maz file is as high as it is wide, and this maze has {width} × {height} squares; write a .txt, \
                 .map or .num"
            ),
        }
    }
}

impl core::error::Error for CannotSay {}

/// What becomes of a finish that a form cannot say.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Unsaid {
    /// The maze is not written.
    Refused,
    /// The maze is written without it.
    LeftOut,
}

/// Writes a maze in a form, all of it or not at all.
///
/// # Errors
/// Where the maze cannot be said in that form.
pub fn write(maze: &Maze, form: Form) -> Result<Vec<u8>, CannotSay> {
    write_with(maze, form, Unsaid::Refused)
}

/// Whether the finish is none that a form without one could mean.
#[must_use]
pub fn has_unsaid_finish(maze: &Maze) -> bool {
    !maze.finish().is_empty() && maze.finish() != maze.bounds().centre()
}

/// Writes a maze in a form.
///
/// ```
/// use line_maze_lab::maze::micromouse::{self, CannotSay, Form};
/// use line_maze_lab::maze::samples;
/// assert_eq!(micromouse::write(&samples::figure_3_1(), Form::Online), Err(CannotSay::Lines));
/// ```
///
/// # Errors
/// Where the maze cannot be said in that form.
pub fn write_with(maze: &Maze, form: Form, finish: Unsaid) -> Result<Vec<u8>, CannotSay> {
    if maze.kind == Kind::Line {
        return Err(CannotSay::Lines);
    }
    let bounds = maze.bounds();
    let start = maze.start().ok_or(CannotSay::NoStart)?;
    let read = super::heading(maze, start.at);
    if start.heading != read {
        return Err(CannotSay::StartHeading { faces: start.heading, read });
    }
    match form {
        Form::Online if maze.is_finish(start.at) => return Err(CannotSay::StartOnFinish(start.at)),
        Form::Online => {}
        Form::Map | Form::Num | Form::Binary => {
            if start.at != bounds.sw() {
                return Err(CannotSay::StartAt(start.at));
            }
            if finish == Unsaid::Refused && has_unsaid_finish(maze) {
                return Err(CannotSay::Finish);
            }
        }
    }
    match form {
        Form::Online | Form::Map => Ok(drawing::write(maze, form).into_bytes()),
        Form::Num => Ok(num::write(maze).into_bytes()),
        Form::Binary if bounds.width() == bounds.height() => Ok(binary::write(maze)),
        Form::Binary => Err(CannotSay::Size { width: bounds.width(), height: bounds.height() }),
    }
}
