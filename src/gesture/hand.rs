//! The pointers on the drawing: what they hold, and the edit that they leave behind.

use alloc::vec;
use alloc::vec::Vec;

use super::place::{self, nearest_point, nearest_post};
use super::trail::{NEAR_POINT, Paper, extend, is_near};
use super::{Button, Doing, Finishing, Motion, Press, Spot, Tool};
use crate::geometry::{Heading, Point};
use crate::maze::edit::{Edit, stroke, walls};
use crate::maze::{Kind, Maze, Start};

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
    /// What a press on a wall does that is not dragged.
    tap: Option<Edit>,
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
        let place = press.spot.place;
        self.tap = None;
        self.doing = match (tool, maze.kind) {
            (Tool::Line, Kind::Line) => Doing::Line(vec![at]),
            (Tool::Line, Kind::Wall) => {
                self.tap = tapped(maze, place);
                Doing::Wall(vec![nearest_post(maze, place)])
            }
            (Tool::Erase, Kind::Line) => Doing::Erase(Paper::Lines(maze).touched(place)),
            (Tool::Erase, Kind::Wall) => Doing::Open(Paper::Walls(maze).touched(place)),
            (Tool::Start, _) => Doing::Start(put_start(maze, at)),
            (Tool::Finish, _) => self.press_finish(maze, at, press.finishing),
            (Tool::Move, _) => Doing::Pan,
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
                if is_near(spot.place, at, (maze.bounds().sw(), maze.bounds().ne()), NEAR_POINT) {
                    extend(path, at);
                }
            }
            Doing::Wall(path) => {
                let post = nearest_post(maze, spot.place);
                if place::is_near_post(maze, spot.place, post) {
                    extend(path, post);
                    if path.len() > 1 {
                        self.tap = None;
                    }
                }
            }
            Doing::Erase(cells) => Paper::Lines(maze).pass(cells, before.place, spot.place),
            Doing::Open(walls) => Paper::Walls(maze).pass(walls, before.place, spot.place),
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
        let tap = self.tap.take();
        match core::mem::take(&mut self.doing) {
            Doing::Line(path) => {
                let cells: Vec<_> = path.windows(2).flat_map(|leg| stroke(leg[0], leg[1])).collect();
                (!cells.is_empty()).then_some(Edit::Draw(cells))
            }
            Doing::Erase(cells) => (!cells.is_empty()).then_some(Edit::Erase(cells)),
            Doing::Wall(path) if path.len() > 1 => Some(Edit::Erase(sides(&path))),
            Doing::Wall(_) => tap,
            Doing::Open(found) => {
                let sides: Vec<_> = found.into_iter().map(walls::side).collect();
                (!sides.is_empty()).then_some(Edit::Draw(sides))
            }
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

/// The sides of squares along a path of posts.
fn sides(posts: &[Point]) -> Vec<(Point, Heading)> {
    posts.windows(2).flat_map(|leg| stroke(leg[0], leg[1])).map(walls::side).collect()
}

/// What a press on the side of a square, not at a post, would change there.
fn tapped(maze: &Maze, place: (f64, f64)) -> Option<Edit> {
    let (square, side) = walls::nearest(place.0, place.1);
    place::is_on_side(place, square, side).then(|| walls::toggle(maze, square, side)).flatten()
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
