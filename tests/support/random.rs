//! Random mazes for property tests: drawn by a small generator of their own, so that a fault in the
//! library's generator cannot hide a fault in the explorer.
#![allow(dead_code, unreachable_pub, clippy::unwrap_used, clippy::expect_used)]

use line_maze_lab::geometry::{Heading, Point};
use line_maze_lab::maze::{Bounds, Maze, Start};
use line_maze_lab::settings::{Order, Preference, Settings};
use line_maze_lab::trace::MAX_NODES;
use oorandom::Rand32;
use proptest::prelude::*;

/// What a random maze is drawn from; prints as the maze's fixture.
#[derive(Clone, Debug)]
pub struct Recipe {
    pub width: u32,
    pub height: u32,
    /// Of a hundred lines that would close a loop, how many are drawn.
    pub loops: u32,
    /// Of a hundred lines, how many are erased again: loose pieces, finishes out of reach.
    pub gaps: u32,
    pub finishes: u32,
    /// How the robot faces; its line comes in from outside on the other side.
    pub heading: Heading,
    pub seed: u64,
}

impl Recipe {
    /// The maze. A spanning tree grows from the south-west; loops and gaps follow.
    pub fn maze(&self) -> Maze {
        let mut chance = Rand32::new(self.seed);
        let (w, h) = (self.width as i32, self.height as i32);
        let inner = Bounds::new(Point::new(0, 0), Point::new(w - 1, h - 1)).unwrap();
        let mut maze = Maze::new(Bounds::new(Point::new(-1, -1), Point::new(w, h)).unwrap());
        let mut todo = vec![Point::new(0, 0)];
        let mut met = vec![false; inner.len()];
        met[0] = true;
        while let Some(&at) = todo.last() {
            let fresh = |heading: &Heading| inner.index(at.step(*heading)).is_some_and(|i| !met[i]);
            let ways: Vec<Heading> = Heading::ALL.into_iter().filter(fresh).collect();
            if ways.is_empty() {
                todo.pop();
                continue;
            }
            let heading = ways[chance.rand_range(0..ways.len() as u32) as usize];
            maze.draw(at, heading);
            met[inner.index(at.step(heading)).unwrap()] = true;
            todo.push(at.step(heading));
            // Leaving off in the middle of a walk gives more nodes.
            if chance.rand_range(0..4) == 0 {
                let other = chance.rand_range(0..todo.len() as u32) as usize;
                let last = todo.len() - 1;
                todo.swap(other, last);
            }
        }
        for at in inner.points() {
            for heading in [Heading::North, Heading::East] {
                if inner.contains(at.step(heading)) {
                    if chance.rand_range(0..100) < self.loops {
                        maze.draw(at, heading);
                    }
                    if chance.rand_range(0..100) < self.gaps {
                        maze.erase(at, heading);
                    }
                }
            }
        }
        let (x, y) = (chance.rand_range(0..self.width) as i32, chance.rand_range(0..self.height) as i32);
        let at = match self.heading {
            Heading::North => Point::new(x, -1),
            Heading::East => Point::new(-1, y),
            Heading::South => Point::new(x, h),
            Heading::West => Point::new(w, y),
        };
        maze.draw(at, self.heading);
        assert!(maze.set_start(Some(Start { at, heading: self.heading })));
        let place = |_| inner.point(chance.rand_range(0..inner.len() as u32) as usize);
        assert!(maze.set_finish((0..self.finishes).map(place).collect()));
        maze
    }
}

/// Random recipes up to this many points along a side.
pub fn recipes(side: u32) -> impl Strategy<Value = Recipe> {
    let share = || prop_oneof![Just(0u32), 0u32..100];
    let gaps = prop_oneof![3 => Just(0u32), 1 => 0u32..40];
    (
        1..=side,
        1..=side,
        share(),
        gaps,
        prop_oneof![1 => Just(0u32), 3 => Just(1), 1 => 2u32..4],
        0u8..4,
        any::<u64>(),
    )
        .prop_map(|(width, height, loops, gaps, finishes, heading, seed)| Recipe {
            width,
            height,
            loops,
            gaps,
            finishes,
            heading: Heading::from_index(heading),
            seed,
        })
}

/// Any preference order.
pub fn orders() -> impl Strategy<Value = Order> {
    prop_oneof![
        3 => proptest::sample::select(&Preference::ALL[..]).prop_map(Order::Fixed),
        1 => any::<u64>().prop_map(Order::Random),
    ]
}

/// The default with this order, and room for every node.
pub fn roomy(order: Order) -> Settings {
    Settings { order, node_max: MAX_NODES, ..Settings::default() }
}
