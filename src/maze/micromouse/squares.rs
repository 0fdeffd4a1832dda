//! Squares that each name their own walls, as the forms without a drawing do: every inner wall is said twice.

use alloc::vec;
use alloc::vec::Vec;

use super::error::Problem;
use crate::geometry::{Heading, Point, Ways};
use crate::maze::{Bounds, Kind, Maze};

/// The walls of every square.
pub(in crate::maze) struct Squares {
    bounds: Bounds,
    /// Row by row from the south-west; the walls as a set of sides.
    walls: Vec<Ways>,
}

impl Squares {
    /// Squares that are all closed.
    pub(in crate::maze) fn new(bounds: Bounds) -> Self {
        Self { bounds, walls: vec![Ways::ALL; bounds.len()] }
    }

    /// Says what walls a square has.
    pub(in crate::maze) fn set(&mut self, square: Point, walls: Ways) {
        if let Some(index) = self.bounds.index(square) {
            self.walls[index] = walls;
        }
    }

    fn walls(&self, square: Point) -> Option<Ways> {
        self.bounds.index(square).map(|index| self.walls[index])
    }

    /// The maze, if neighbours agree and the outside is closed; else the square and its problem.
    pub(in crate::maze) fn maze(&self) -> Result<Maze, (Point, Problem)> {
        let mut maze = Maze::new(self.bounds);
        maze.kind = Kind::Wall;
        for (square, &walls) in self.bounds.points().zip(&self.walls) {
            for side in Heading::ALL {
                let wall = walls.has(side);
                let next = square.step(side);
                match self.walls(next).map(|walls| walls.has(side.opposite())) {
                    None if wall => {}
                    None => return Err((square, Problem::Open { square, side })),
                    Some(other) if other == wall => {
                        if !wall {
                            maze.draw(square, side);
                        }
                    }
                    Some(_) if wall => return Err((square, Problem::Disagree { walled: square, side })),
                    Some(_) => {
                        return Err((square, Problem::Disagree { walled: next, side: side.opposite() }));
                    }
                }
            }
        }
        Ok(maze)
    }
}

/// The walls of a square: every side without an opening.
pub(super) fn walls(maze: &Maze, square: Point) -> Ways {
    Ways::ALL.minus(maze.ways(square))
}
