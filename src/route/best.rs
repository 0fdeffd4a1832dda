//! The best routes that a maze has, for those who can see it: the shortest, and the quickest from where the robot
//! faces at the start.
//!
//! The shortest is a breadth-first search over cells; of all shortest ways the quickest is taken. The quickest is
//! an A* search over stops and the headings on arrival, as a turn costs time.

mod fastest;
mod shortest;

use super::{Route, Way};
use crate::geometry::Heading;
use crate::maze::{Maze, Start};
use crate::settings::Pace;

/// A best way.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Best {
    /// Its length.
    pub cells: u32,
    /// Its time.
    pub seconds: f64,
}

impl Best {
    fn of(route: &Route, maze: &Maze, pace: &Pace) -> Self {
        let tally = route.tally();
        Self { cells: tally.cells, seconds: tally.seconds(maze.scale.cell_mm(), pace) }
    }
}

/// The shortest way to the finish, and of several the quickest; none where no way leads there.
///
/// ```
/// use line_maze_lab::geometry::{Heading::North, Point};
/// use line_maze_lab::maze::{Bounds, Maze, Start};
/// use line_maze_lab::{route::best, settings::Pace};
/// let mut maze = Maze::new(Bounds::new(Point::new(0, 0), Point::new(0, 1))?);
/// maze.draw(Point::new(0, 0), North);
/// maze.set_finish(vec![Point::new(0, 1)]);
/// let start = Start { at: Point::new(0, 0), heading: North };
/// assert_eq!(best::shortest(&maze, start, &Pace::default()).map(|best| best.cells), Some(1));
/// # Ok::<(), line_maze_lab::maze::BoundsError>(())
/// ```
#[must_use]
pub fn shortest(maze: &Maze, start: Start, pace: &Pace) -> Option<Best> {
    shortest_route(maze, start, pace).map(|route| Best::of(&route, maze, pace))
}

/// The quickest way to the finish; none where no way leads there.
#[must_use]
pub fn fastest(maze: &Maze, start: Start, pace: &Pace) -> Option<Best> {
    fastest_route(maze, start, pace).map(|route| Best::of(&route, maze, pace))
}

/// [`shortest`] with every stop.
#[must_use]
pub fn shortest_route(maze: &Maze, start: Start, pace: &Pace) -> Option<Route> {
    let way = shortest::search(maze, start, pace)?;
    drive(maze, start, &way)
}

/// [`fastest`] with every stop.
#[must_use]
pub fn fastest_route(maze: &Maze, start: Start, pace: &Pace) -> Option<Route> {
    let way = fastest::search(maze, start, pace)?;
    drive(maze, start, &way)
}

/// The drive along these headings, a cell each.
fn drive(maze: &Maze, start: Start, headings: &[Heading]) -> Option<Route> {
    let mut way = Way::new(maze, start);
    for &heading in headings {
        way.cell(heading)?;
    }
    Some(way.end())
}
