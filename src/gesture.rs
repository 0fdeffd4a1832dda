//! What hands do on a drawing: presses, moves and releases of pointers become previews, and one edit at the end.
//!
//! A [`Hand`] knows no browser: it is told where pointers are, on the lattice and in pixels.

use alloc::vec::Vec;

use crate::geometry::{Heading, Point};
use crate::maze::Start;

mod hand;
mod place;
mod trail;

pub use hand::Hand;
pub use place::{nearest_cell, nearest_point};

/// What the main button or a finger does.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Tool {
    /// Draws line, or builds walls.
    #[default]
    Line,
    /// Erases line, or opens walls.
    Erase,
    /// Puts the start somewhere.
    Start,
    /// Puts the finish somewhere.
    Finish,
    /// Moves the paper.
    Move,
}

/// What is pressed.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Button {
    /// The left button, or a pen.
    Main,
    /// The right button: erases.
    Second,
    /// The wheel: moves the paper.
    Middle,
    /// A finger; two of them move and zoom.
    Finger,
}

/// What happens to the finish points that are there.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Finishing {
    /// There is one finish: it goes where it is put.
    #[default]
    Only,
    /// A point becomes finish, or stops being one.
    Further,
}

/// Where a pointer is.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Spot {
    /// On the lattice.
    pub place: (f64, f64),
    /// In the picture, in pixels.
    pub pixel: (f64, f64),
}

/// A pointer that goes down.
#[derive(Clone, Copy, Debug)]
pub struct Press {
    /// The pointer.
    pub id: i32,
    /// What of it.
    pub button: Button,
    /// Where.
    pub spot: Spot,
    /// What it is to do, if it is not a special button.
    pub tool: Tool,
    /// For the tool [`Tool::Finish`].
    pub finishing: Finishing,
    /// Where the start's handle is.
    pub handle: Handle,
}

/// How far the start's handle is from the start, and how near a pointer must be to take it, in cells.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Handle {
    /// From the start, where it faces.
    pub arm: f64,
    /// Around it.
    pub reach: f64,
}

/// What is going on.
#[derive(Clone, Debug, Default, PartialEq)]
pub enum Doing {
    /// Nothing.
    #[default]
    Nothing,
    /// A line through these points, the last one under the pointer.
    Line(Vec<Point>),
    /// Cells that will be erased.
    Erase(Vec<(Point, Heading)>),
    /// A wall through these posts, the last one under the pointer.
    Wall(Vec<Point>),
    /// Walls that will be opened, each by its southern or western post.
    Open(Vec<(Point, Heading)>),
    /// The start is moved or turned.
    Start(Start),
    /// These will be the finish points.
    Finish(Vec<Point>),
    /// The paper is moved.
    Pan,
    /// Two fingers move and zoom the paper.
    Pinch,
    /// Let go, with the pointer still down.
    LetGo,
}

/// How the paper moves.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Motion {
    /// Not.
    Still,
    /// By pixels.
    Pan(f64, f64),
    /// By pixels, then larger by a factor about a place of the picture.
    Zoom {
        /// Pixels.
        by: (f64, f64),
        /// Larger if more than 1.
        factor: f64,
        /// What stands still, in pixels.
        about: (f64, f64),
    },
}

#[cfg(test)]
mod tests;
