//! Walls as they stand: between posts, wherever two squares have no opening and all round the outside.
//!
//! A post has the coordinates of the square to its north-east: post `x,y` is that square's south-west corner,
//! half a cell from its middle.

use alloc::vec::Vec;

use super::Maze;
use super::edit::walls::side;
use crate::geometry::{Heading, Point, Ways};

/// A straight wall between two posts, as long as it goes.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Run {
    /// Its southern or western post.
    pub from: Point,
    /// Its northern or eastern post.
    pub to: Point,
}

/// Every wall once: those from west to east, row by row from the south, then those from south to north.
///
/// ```
/// use line_maze_lab::maze::{Bounds, Maze, walls};
/// let square = Maze::new(Bounds::default());
/// assert_eq!(walls::runs(&square).len(), 4);
/// ```
#[must_use]
pub fn runs(maze: &Maze) -> Vec<Run> {
    let (sw, ne) = (maze.bounds().sw(), maze.bounds().ne());
    let mut runs = Vec::new();
    for y in sw.y..=ne.y + 1 {
        let row = (sw.x..=ne.x).map(|x| Point::new(x, y));
        join(maze, row, Heading::South, Heading::East, &mut runs);
    }
    for x in sw.x..=ne.x + 1 {
        let column = (sw.y..=ne.y).map(|y| Point::new(x, y));
        join(maze, column, Heading::West, Heading::North, &mut runs);
    }
    runs
}

/// Walls on this side of the squares, which follow each other `along`, joined where they touch.
fn join(
    maze: &Maze,
    squares: impl Iterator<Item = Point>,
    side: Heading,
    along: Heading,
    runs: &mut Vec<Run>,
) {
    let mut open: Option<Run> = None;
    for square in squares {
        // A square off the lattice has no openings.
        if maze.has_line(square, side) {
            runs.extend(open.take());
        } else {
            let from = open.map_or(square, |run| run.from);
            open = Some(Run { from, to: square.step(along) });
        }
    }
    runs.extend(open);
}

/// The walls at a post that can be opened: all but the outer wall.
///
/// ```
/// use line_maze_lab::geometry::Point;
/// use line_maze_lab::maze::{Bounds, Maze, walls};
/// let four = Maze::new(Bounds::new(Point::new(0, 0), Point::new(1, 1))?);
/// assert_eq!(walls::ways(&four, Point::new(1, 1)).count(), 4);
/// assert_eq!(walls::ways(&four, Point::new(1, 0)).count(), 1);
/// # Ok::<(), line_maze_lab::maze::BoundsError>(())
/// ```
#[must_use]
pub fn ways(maze: &Maze, post: Point) -> Ways {
    let bounds = maze.bounds();
    let stands = |&along: &Heading| {
        let (square, side) = side((post, along));
        bounds.contains(square) && bounds.contains(square.step(side)) && !maze.has_line(square, side)
    };
    Heading::ALL.into_iter().filter(stands).collect()
}

/// The posts that no wall touches, row by row from the south.
pub fn lone_posts(maze: &Maze) -> impl Iterator<Item = Point> {
    let (sw, ne) = (maze.bounds().sw(), maze.bounds().ne());
    let posts = (sw.y + 1..=ne.y).flat_map(move |y| (sw.x + 1..=ne.x).map(move |x| Point::new(x, y)));
    posts.filter(|&post| {
        let across = post.step(Heading::South).step(Heading::West);
        [Heading::South, Heading::West].into_iter().all(|side| maze.has_line(post, side))
            && [Heading::North, Heading::East].into_iter().all(|side| maze.has_line(across, side))
    })
}

#[cfg(test)]
#[allow(clippy::unwrap_used)]
mod tests {
    use super::*;
    use crate::maze::text;

    fn said(drawing: &str) -> Vec<alloc::string::String> {
        let maze = text::parse(&alloc::format!("line-maze: 1\nkind: wall\n\n{drawing}")).unwrap();
        let posts = lone_posts(&maze).map(|post| alloc::format!("post {post}"));
        runs(&maze).iter().map(|run| alloc::format!("{} to {}", run.from, run.to)).chain(posts).collect()
    }

    #[test]
    fn walls_stand_all_round_and_where_there_is_no_opening() {
        let sides = ["0,0 to 2,0", "0,1 to 1,1", "0,2 to 2,2", "0,0 to 0,2", "2,0 to 2,2"];
        assert_eq!(said("+---+\n    |\n+---+\n"), sides);
        assert_eq!(said("+   +\n"), ["0,0 to 2,0", "0,1 to 2,1", "0,0 to 0,1", "1,0 to 1,1", "2,0 to 2,1"]);
    }

    #[test]
    fn a_post_that_no_wall_touches_still_stands() {
        let all = ["0,0 to 2,0", "0,2 to 2,2", "0,0 to 0,2", "2,0 to 2,2", "post 1,1"];
        assert_eq!(said("+---+\n|   |\n+---+\n"), all);
    }
}
