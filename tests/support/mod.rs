//! What the native tests share.
#![allow(dead_code, unreachable_pub, clippy::unwrap_used, clippy::expect_used)]

use line_maze_lab::geometry::{Heading, Point};
use line_maze_lab::maze::{Bounds, Maze, Start};

pub mod random;

/// A maze of polylines, as the specifications write them.
pub fn maze(lines: &[&[(i32, i32)]], start: (i32, i32, Heading), finish: &[(i32, i32)]) -> Maze {
    let point = |&(x, y): &(i32, i32)| Point::new(x, y);
    let points = lines.iter().flat_map(|line| line.iter().map(point));
    let mut maze = Maze::new(Bounds::around(points).expect("a lattice"));
    for line in lines {
        for ends in line.windows(2) {
            let (mut at, to) = (point(&ends[0]), point(&ends[1]));
            while at != to {
                let heading = Heading::ALL
                    .into_iter()
                    .find(|&h| at.step(h).distance(to) < at.distance(to) && (at.x == to.x || at.y == to.y))
                    .expect("a line along an axis");
                assert!(maze.draw(at, heading) || maze.has_line(at, heading));
                at = at.step(heading);
            }
        }
    }
    assert!(maze.set_start(Some(Start { at: Point::new(start.0, start.1), heading: start.2 })));
    assert!(maze.set_finish(finish.iter().map(point).collect()));
    maze
}

/// The book's figure 3.1.
pub fn figure_3_1() -> Maze {
    maze(
        &[
            &[(0, 0), (0, 5), (6, 5), (6, 0), (7, 0)],
            &[(0, 1), (6, 1)],
            &[(0, 3), (2, 3), (2, 1)],
            &[(4, 1), (4, 2)],
            &[(3, 5), (3, 4)],
        ],
        (0, 0, Heading::North),
        &[(3, 4)],
    )
}

/// The book's figure 2.4.
pub fn figure_2_4() -> Maze {
    maze(&[&[(0, 0), (0, 2)], &[(-2, 2), (5, 2), (5, 0), (3, 0), (3, 2)]], (0, 0, Heading::North), &[(-2, 2)])
}
