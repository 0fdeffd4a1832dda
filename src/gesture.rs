//! What hands do on a drawing: presses, moves and releases of pointers become previews, and one edit at the end.
//!
//! A [`Hand`] knows no browser: it is told where pointers are, on the lattice and in pixels.

use alloc::vec;
use alloc::vec::Vec;

use crate::geometry::{Heading, Point};
use crate::maze::edit::{Edit, stroke};
use crate::maze::{Maze, Start};

mod place;

pub use place::{nearest_cell, nearest_line, nearest_point};

/// What the main button or a finger does.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Tool {
    /// Draws line.
    #[default]
    Line,
    /// Erases line.
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

/// The pointers on the drawing, and what they do.
///
/// ```
/// use line_maze_lab::gesture::{Button, Finishing, Hand, Handle, Press, Spot, Tool};
/// use line_maze_lab::maze::{Bounds, Maze, edit::Edit};
/// # use line_maze_lab::geometry::Point;
/// let maze = Maze::new(Bounds::new(Point::new(0, 0), Point::new(5, 5))?);
/// let at = |x, y| Spot { place: (x, y), pixel: (0.0, 0.0) };
/// let mut hand = Hand::default();
/// hand.press(&maze, &Press {
///     id: 1, button: Button::Main, spot: at(0.0, 0.1), tool: Tool::Line,
///     finishing: Finishing::Only, handle: Handle { arm: 0.5, reach: 0.2 },
/// });
/// hand.drag(&maze, 1, at(2.9, 0.0));
/// assert!(matches!(hand.release(1), Some(Edit::Draw(cells)) if cells.len() == 3));
/// # Ok::<(), line_maze_lab::maze::BoundsError>(())
/// ```
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Hand {
    doing: Doing,
    /// The pointer that does it.
    id: i32,
    /// What the pointer holds, besides what can be seen.
    grip: Grip,
    last: Spot,
    fingers: Vec<(i32, Spot)>,
}

/// How a press goes on when it is dragged.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
enum Grip {
    /// Where the pointer is counts.
    #[default]
    Free,
    /// The start's handle: only the direction counts.
    Turning,
    /// A finish point that is moved; the others stay.
    Finish(Point),
    /// It was said with the press.
    Done,
}

/// A pointer counts for a lattice point within this distance, so that a slip between two rows draws nothing.
const NEAR_POINT: f64 = 0.45;
/// And for a cell of line.
const NEAR_CELL: f64 = 0.4;
/// So near to a lattice point a moving eraser waits: it may only cross the lines there.
const CROSSING: f64 = 0.22;

impl Hand {
    /// What is going on.
    #[must_use]
    pub const fn doing(&self) -> &Doing {
        &self.doing
    }

    /// A pointer goes down.
    pub fn press(&mut self, maze: &Maze, press: &Press) {
        if press.button == Button::Finger {
            self.fingers.retain(|finger| finger.0 != press.id);
            self.fingers.push((press.id, press.spot));
            if self.fingers.len() > 1 {
                self.doing = if self.fingers.len() == 2 { Doing::Pinch } else { Doing::LetGo };
                return;
            }
        }
        if self.doing != Doing::Nothing {
            return;
        }
        (self.id, self.last, self.grip) = (press.id, press.spot, Grip::Free);
        let at = maze.bounds().clamp(nearest_point(press.spot.place));
        let tool = match press.button {
            Button::Middle => Tool::Move,
            Button::Second => Tool::Erase,
            Button::Main | Button::Finger => press.tool,
        };
        if let Some(start) = maze.start().filter(|&start| tool != Tool::Move && takes(press, start)) {
            self.grip = Grip::Turning;
            self.doing = Doing::Start(start);
            return;
        }
        self.doing = match tool {
            Tool::Line => Doing::Line(vec![at]),
            Tool::Erase => {
                Doing::Erase(nearest_line(maze, press.spot.place, NEAR_CELL).into_iter().collect())
            }
            Tool::Start => Doing::Start(put_start(maze, at)),
            Tool::Finish => self.press_finish(maze, at, press.finishing),
            Tool::Move => Doing::Pan,
        };
    }

    fn press_finish(&mut self, maze: &Maze, at: Point, finishing: Finishing) -> Doing {
        let mut finish = maze.finish().to_vec();
        match finishing {
            Finishing::Further => {
                self.grip = Grip::Done;
                if maze.is_finish(at) {
                    finish.retain(|&other| other != at);
                } else {
                    finish.push(at);
                }
            }
            Finishing::Only if maze.is_finish(at) => self.grip = Grip::Finish(at),
            Finishing::Only => finish = vec![at],
        }
        Doing::Finish(finish)
    }

    /// A pointer moves; says how the paper moves with it.
    pub fn drag(&mut self, maze: &Maze, id: i32, spot: Spot) -> Motion {
        let pinched = (self.doing == Doing::Pinch).then(|| self.two_fingers()).flatten();
        if let Some(finger) = self.fingers.iter_mut().find(|finger| finger.0 == id) {
            finger.1 = spot;
        }
        if let Some(before) = pinched {
            return self.two_fingers().map_or(Motion::Still, |after| pinch(before, after));
        }
        if id != self.id {
            return Motion::Still;
        }
        let before = core::mem::replace(&mut self.last, spot);
        let at = maze.bounds().clamp(nearest_point(spot.place));
        match &mut self.doing {
            Doing::Nothing | Doing::Pinch | Doing::LetGo => {}
            Doing::Pan => return Motion::Pan(spot.pixel.0 - before.pixel.0, spot.pixel.1 - before.pixel.1),
            Doing::Line(path) => {
                if is_near(maze, spot.place, at) {
                    extend(path, at);
                }
            }
            Doing::Erase(cells) => erase_along(maze, cells, before.place, spot.place),
            Doing::Start(start) => match self.grip {
                Grip::Turning => {
                    start.heading = place::heading(start.at, spot.place).unwrap_or(start.heading)
                }
                Grip::Free | Grip::Finish(_) | Grip::Done => *start = put_start(maze, at),
            },
            Doing::Finish(finish) => match self.grip {
                Grip::Free => *finish = vec![at],
                Grip::Finish(held) => {
                    *finish = maze.finish().iter().copied().filter(|&other| other != held).collect();
                    finish.push(at);
                }
                Grip::Turning | Grip::Done => {}
            },
        }
        Motion::Still
    }

    /// A pointer goes up: what it did is kept.
    pub fn release(&mut self, id: i32) -> Option<Edit> {
        self.fingers.retain(|finger| finger.0 != id);
        match self.doing {
            Doing::Pinch => {
                // The finger that is left draws nothing.
                self.doing = Doing::LetGo;
            }
            _ if id != self.id && self.doing != Doing::LetGo => return None,
            _ => {}
        }
        if self.doing == Doing::LetGo {
            if self.fingers.is_empty() {
                self.doing = Doing::Nothing;
            }
            return None;
        }
        match core::mem::take(&mut self.doing) {
            Doing::Line(path) => {
                let cells: Vec<_> = path.windows(2).flat_map(|leg| stroke(leg[0], leg[1])).collect();
                (!cells.is_empty()).then_some(Edit::Draw(cells))
            }
            Doing::Erase(cells) => (!cells.is_empty()).then_some(Edit::Erase(cells)),
            Doing::Start(start) => Some(Edit::Start(Some(start))),
            Doing::Finish(finish) => Some(Edit::Finish(finish)),
            Doing::Nothing | Doing::Pan | Doing::Pinch | Doing::LetGo => None,
        }
    }

    /// The browser took a pointer away: what it did is not kept.
    pub fn lose(&mut self, id: i32) {
        self.fingers.retain(|finger| finger.0 != id);
        if id == self.id || self.doing == Doing::Pinch || self.doing == Doing::LetGo {
            self.doing = if self.fingers.is_empty() { Doing::Nothing } else { Doing::LetGo };
        }
    }

    /// Lets go without keeping anything. Returns whether there was something.
    pub fn let_go(&mut self) -> bool {
        let busy = !matches!(self.doing, Doing::Nothing | Doing::LetGo);
        if busy {
            self.doing = Doing::LetGo;
        }
        busy
    }

    fn two_fingers(&self) -> Option<[(f64, f64); 2]> {
        let [a, b] = self.fingers[..] else { return None };
        Some([a.1.pixel, b.1.pixel])
    }
}

/// Whether the press is on the start's handle, and not nearer to the start itself.
fn takes(press: &Press, start: Start) -> bool {
    let (dx, dy) = start.heading.vector();
    let (x, y) = (f64::from(start.at.x), f64::from(start.at.y));
    let arm = press.handle.arm;
    let handle = (x + f64::from(dx) * arm, y + f64::from(dy) * arm);
    let far = place::squared(press.spot.place, handle);
    far <= press.handle.reach * press.handle.reach && far < place::squared(press.spot.place, (x, y))
}

/// A start put on a point: it faces along the line where there is only one way, else as before.
fn put_start(maze: &Maze, at: Point) -> Start {
    let before = maze.start().map_or(Heading::North, |start| start.heading);
    Start { at, heading: maze.ways(at).only().unwrap_or(before) }
}

/// Whether the place is near enough to the point; beyond the lattice's edge the nearest point counts.
fn is_near(maze: &Maze, (x, y): (f64, f64), at: Point) -> bool {
    let bounds = maze.bounds();
    let inside = |v: f64, low: i32, high: i32| v.clamp(f64::from(low), f64::from(high));
    let place = (inside(x, bounds.sw().x, bounds.ne().x), inside(y, bounds.sw().y, bounds.ne().y));
    place::squared(place, (f64::from(at.x), f64::from(at.y))) <= NEAR_POINT * NEAR_POINT
}

/// Goes on to a point; going back over the last cell takes it back.
fn extend(path: &mut Vec<Point>, to: Point) {
    let Some(&from) = path.last() else { return };
    for (at, heading) in stroke(from, to) {
        let next = at.step(heading);
        if path.len() > 1 && path[path.len() - 2] == next {
            path.pop();
        } else {
            path.push(next);
        }
    }
}

/// Takes in the cells that an eraser passes.
fn erase_along(maze: &Maze, cells: &mut Vec<(Point, Heading)>, from: (f64, f64), to: (f64, f64)) {
    /// Steps a cell.
    const FINE: f64 = 8.0;
    let (dx, dy) = (to.0 - from.0, to.1 - from.1);
    let far = if dx.abs() > dy.abs() { dx.abs() } else { dy.abs() };
    // Nobody passes thousands of cells between two moves: the picture does not hold so many.
    let steps = ((far * FINE) as u32 + 1).min(20_000);
    for step in 1..=steps {
        let part = f64::from(step) / f64::from(steps);
        let place = (from.0 + dx * part, from.1 + dy * part);
        let point = nearest_point(place);
        if place::squared(place, (f64::from(point.x), f64::from(point.y))) < CROSSING * CROSSING {
            continue;
        }
        if let Some(cell) = nearest_line(maze, place, NEAR_CELL)
            && !cells.contains(&cell)
        {
            cells.push(cell);
        }
    }
}

/// How two fingers moved the paper.
fn pinch(before: [(f64, f64); 2], after: [(f64, f64); 2]) -> Motion {
    let middle = |[a, b]: [(f64, f64); 2]| ((a.0 + b.0) / 2.0, (a.1 + b.1) / 2.0);
    // The larger of width and height, and a little more, needs no square root and is never 0.
    let spread = |[a, b]: [(f64, f64); 2]| {
        let (w, h) = ((a.0 - b.0).abs(), (a.1 - b.1).abs());
        1.0 + if w > h { w + h * 0.4 } else { h + w * 0.4 }
    };
    let (old, new) = (middle(before), middle(after));
    Motion::Zoom { by: (new.0 - old.0, new.1 - old.1), factor: spread(after) / spread(before), about: new }
}

#[cfg(test)]
mod tests;
