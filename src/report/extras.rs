//! What only some explorers have to report: squares, bytes, the path, and the map as a graph.

use alloc::string::{String, ToString};
use alloc::vec::Vec;

use serde::{Serialize, Serializer};

use crate::explorer::mapping::Mapping;
use crate::explorer::mind::Mind;
use crate::explorer::name::Stops;
use crate::geometry::Point;
use crate::maze::Maze;
use crate::recording::Recording;

/// A square as its source numbers it.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize)]
#[serde(untagged)]
pub enum Square {
    /// PAReX: a number.
    Number(i32),
    /// Cornell: x and y from the north-west corner, y downwards; flood fill: the drawing's x and y.
    Place([i32; 2]),
}

/// What only some explorers have; left out where there is none.
#[derive(Clone, Debug, Default, PartialEq, Eq, Serialize)]
pub struct Extras {
    /// Square explorers: every square, the start included.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub squares: Option<Vec<Square>>,
    /// Cornell: the map's bytes, rows from the north.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub bytes: Option<Vec<Vec<u8>>>,
    /// PAReX: `Path(1..CSIP)` at the end.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub path: Option<Vec<i32>>,
    /// Mapping: the points in the order visited, in the drawing's frame, the start included.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub points: Option<Vec<[i32; 2]>>,
    /// Mapping: the neighbours of each point.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub adjacency: Option<Adjacency>,
}

/// An adjacency list; as JSON an object from `"x,y"` to a list of `[x, y]`.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Adjacency(pub Vec<(Point, Vec<Point>)>);

impl Serialize for Adjacency {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        let lists = self.0.iter();
        serializer.collect_map(lists.map(|(at, list)| -> (String, Vec<[i32; 2]>) {
            (at.to_string(), list.iter().map(pair).collect())
        }))
    }
}

const fn pair(at: &Point) -> [i32; 2] {
    [at.x, at.y]
}

impl Extras {
    /// Of a run in this maze.
    pub(super) fn of(maze: &Maze, run: &Recording) -> Self {
        let squares = match run.name().about().stops {
            Stops::Square => Some(squares(maze, run)),
            Stops::Line => None,
        };
        let extras = Self { squares, ..Self::default() };
        match run.last() {
            Mind::Parex(mind) => Self { path: Some(mind.path().to_vec()), ..extras },
            Mind::Cornell(mind) => {
                let width = mind.squares().field().width as usize;
                let rows = mind.squares().bytes().chunks(width).map(<[u8]>::to_vec);
                Self { bytes: Some(rows.collect()), ..extras }
            }
            Mind::Mapping(mind) => Self {
                points: Some(run.places().map(|at| pair(&at)).collect()),
                adjacency: Some(adjacency(run, mind)),
                ..extras
            },
            Mind::Hand(_) | Mind::Sums(_) | Mind::Tremaux(_) | Mind::DepthFirst(_) | Mind::FloodFill(_) => {
                extras
            }
        }
    }
}

fn squares(maze: &Maze, run: &Recording) -> Vec<Square> {
    let bounds = maze.bounds();
    let square = |at: Point| match run.last() {
        Mind::Parex(mind) => Square::Number(mind.numbering().number(run.from_start(at))),
        Mind::Cornell(_) => Square::Place([at.x - bounds.sw().x, bounds.ne().y - at.y]),
        Mind::Hand(_)
        | Mind::Sums(_)
        | Mind::Mapping(_)
        | Mind::Tremaux(_)
        | Mind::DepthFirst(_)
        | Mind::FloodFill(_) => Square::Place([at.x, at.y]),
    };
    run.places().map(square).collect()
}

fn adjacency(run: &Recording, map: &Mapping) -> Adjacency {
    // Where each point was when it was recorded.
    let mut places: Vec<Point> = Vec::new();
    for (point, at) in map.visited().zip(run.places()) {
        if point as usize == places.len() {
            places.push(at);
        }
    }
    let lists = map.adjacency_list().into_iter();
    let on_floor = |list: Vec<u32>| list.into_iter().map(|point| places[point as usize]).collect();
    Adjacency(places.iter().copied().zip(lists.map(on_floor)).collect())
}
