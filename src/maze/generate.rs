//! Mazes from a seed: a spanning tree of the lattice, some of the missing links as loops, some dead ends cut
//! back. The same recipe gives the same maze on every machine: no floating point, no pointer-sized numbers.
//!
//! The tree grows from a list of points, mostly from its last one and sometimes from any (“growing tree”,
//! Jamis Buck), and prefers to go straight on: long lines with branches all along them.

use alloc::format;
use alloc::vec;
use alloc::vec::Vec;
use core::fmt;

use oorandom::Rand32;

use super::{Bounds, Kind, MAX_SIDE, Maze, Start};
use crate::geometry::{Heading, Point, Ways};

/// What a generated maze should be like.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Recipe {
    /// Points from west to east, 1 to [`MAX_SIDE`].
    pub width: u32,
    /// Points from south to north, 1 to [`MAX_SIDE`].
    pub height: u32,
    /// How many of the links that the tree leaves out become loops, in per cent.
    pub loops_percent: u8,
    /// How many of the dead ends are cut back to the next node, in per cent.
    pub dead_ends_cut_percent: u8,
    /// Another seed, another maze.
    pub seed: u64,
    /// Drawn as lines or as walls.
    pub kind: Kind,
}

impl Default for Recipe {
    fn default() -> Self {
        Self { width: 9, height: 6, loops_percent: 25, dead_ends_cut_percent: 80, seed: 1, kind: Kind::Line }
    }
}

/// Why there is no such maze.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum RecipeError {
    /// Fewer than two points: no room for start and finish.
    TooSmall,
    /// More than [`MAX_SIDE`] points along a side.
    TooLarge,
    /// `loops_percent` is more than 100.
    Loops,
    /// `dead_ends_cut_percent` is more than 100.
    DeadEnds,
}

impl fmt::Display for RecipeError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::TooSmall => f.write_str("A maze needs two points at least; make it wider or higher."),
            Self::TooLarge => write!(f, "A maze has at most {MAX_SIDE} points along a side."),
            Self::Loops => f.write_str("Loops go from 0 to 100 %."),
            Self::DeadEnds => f.write_str("Dead ends cut back go from 0 to 100 %."),
        }
    }
}

impl core::error::Error for RecipeError {}

/// Makes a maze. Its start is the south-west corner, a line's end, facing along the line; its finish is the
/// point that is furthest from there.
///
/// ```
/// use line_maze_lab::maze::checks;
/// use line_maze_lab::maze::generate::{Recipe, generate};
/// let maze = generate(&Recipe { seed: 1924, ..Recipe::default() })?;
/// assert_eq!(maze.about.title, "Generated 9 × 6, seed 1924");
/// assert!(checks::check(&maze).is_empty());
/// # Ok::<(), line_maze_lab::maze::generate::RecipeError>(())
/// ```
///
/// # Errors
/// Where a size or a share is out of its range.
pub fn generate(recipe: &Recipe) -> Result<Maze, RecipeError> {
    let bounds = bounds(recipe)?;
    let mut maze = Maze::new(bounds);
    let mut random = Rand32::new(recipe.seed);
    let start = start(bounds);
    maze.draw(start.at, start.heading);
    grow_tree(&mut maze, start.at.step(start.heading), &mut random);
    add_loops(&mut maze, start.at, recipe.loops_percent, &mut random);
    maze.set_start(Some(start));
    maze.set_finish(vec![furthest(&maze, start.at)]);
    cut_dead_ends(&mut maze, recipe.dead_ends_cut_percent, &mut random);
    maze.kind = recipe.kind;
    maze.about.title = format!("Generated {} × {}, seed {}", recipe.width, recipe.height, recipe.seed);
    maze.about.source = format!(
        "Line Maze Lab’s generator: loops {} %, dead ends cut back {} %",
        recipe.loops_percent, recipe.dead_ends_cut_percent
    );
    Ok(maze)
}

fn bounds(recipe: &Recipe) -> Result<Bounds, RecipeError> {
    let Recipe { width, height, loops_percent, dead_ends_cut_percent, .. } = *recipe;
    if width > MAX_SIDE || height > MAX_SIDE {
        Err(RecipeError::TooLarge)
    } else if width * height < 2 {
        Err(RecipeError::TooSmall)
    } else if loops_percent > 100 {
        Err(RecipeError::Loops)
    } else if dead_ends_cut_percent > 100 {
        Err(RecipeError::DeadEnds)
    } else {
        let ne = Point::new(width.cast_signed() - 1, height.cast_signed() - 1);
        Bounds::new(Point::new(0, 0), ne).map_err(|_| RecipeError::TooLarge)
    }
}

/// The south-west corner, facing into the lattice: the rest of it hangs together without that point.
fn start(bounds: Bounds) -> Start {
    let heading = if bounds.height() > 1 { Heading::North } else { Heading::East };
    Start { at: bounds.sw(), heading }
}

/// Joins every point that has no line yet, starting from one that has.
fn grow_tree(maze: &mut Maze, from: Point, random: &mut Rand32) {
    let bounds = maze.bounds();
    let mut growing = vec![(from, Heading::North)];
    while let Some(last) = growing.len().checked_sub(1) {
        // One time in four any point grows, else the last.
        let place = if random.rand_range(0..4) == 0 { below(random, growing.len()) } else { last };
        let (at, along) = growing[place];
        let free: Ways = Heading::ALL
            .into_iter()
            .filter(|&heading| {
                let next = at.step(heading);
                bounds.contains(next) && maze.ways(next).is_empty()
            })
            .collect();
        if free.is_empty() {
            growing.swap_remove(place);
            continue;
        }
        let straight = free.has(along) && random.rand_range(0..2) == 0;
        let heading = if straight { along } else { any(free, random) };
        maze.draw(at, heading);
        growing.push((at.step(heading), heading));
    }
}

/// One of the ways; north if there is none.
fn any(ways: Ways, random: &mut Rand32) -> Heading {
    let nth = random.rand_range(0..ways.count().max(1)) as usize;
    ways.iter().nth(nth).unwrap_or_default()
}

/// Less than `count`, which is 1 to 2³².
fn below(random: &mut Rand32, count: usize) -> usize {
    random.rand_range(0..u32::try_from(count).unwrap_or(u32::MAX)) as usize
}

/// Draws a share of the links between neighbours that are not joined; the start stays a line's end.
fn add_loops(maze: &mut Maze, start: Point, percent: u8, random: &mut Rand32) {
    let bounds = maze.bounds();
    // A link is named by its southern or western end, and nothing is south or west of the start.
    let missing = |maze: &Maze, (at, heading): (Point, Heading)| {
        at != start && bounds.contains(at.step(heading)) && !maze.has_line(at, heading)
    };
    let links = || bounds.points().flat_map(|at| [(at, Heading::North), (at, Heading::East)]);
    let count = links().filter(|&link| missing(maze, link)).count();
    let mut choice = Choice::new(count, percent);
    for link in links() {
        if missing(maze, link) && choice.next(random) {
            maze.draw(link.0, link.1);
        }
    }
}

/// Chooses a share of the items that are shown to it one after another (Knuth's algorithm S).
struct Choice {
    left: u32,
    wanted: u32,
}

impl Choice {
    fn new(count: usize, percent: u8) -> Self {
        // A lattice has at most two million links.
        let left = u32::try_from(count).unwrap_or(u32::MAX);
        let wanted = (u64::from(left) * u64::from(percent) + 50) / 100;
        Self { left, wanted: u32::try_from(wanted).unwrap_or(left) }
    }

    fn next(&mut self, random: &mut Rand32) -> bool {
        let chosen = random.rand_range(0..self.left.max(1)) < self.wanted;
        self.left = self.left.saturating_sub(1);
        self.wanted -= u32::from(chosen);
        chosen
    }
}

/// The point with the longest shortest way; of several, the first that is found.
fn furthest(maze: &Maze, from: Point) -> Point {
    let bounds = maze.bounds();
    let mut seen = vec![false; bounds.len()];
    let mut todo = alloc::collections::VecDeque::from([from]);
    let mut last = from;
    while let Some(at) = todo.pop_front() {
        if let Some(index) = bounds.index(at)
            && !core::mem::replace(&mut seen[index], true)
        {
            last = at;
            todo.extend(maze.ways(at).iter().map(|heading| at.step(heading)));
        }
    }
    last
}

/// Cuts a share of the dead ends back to the next node. Start and finish stay.
fn cut_dead_ends(maze: &mut Maze, percent: u8, random: &mut Rand32) {
    let ends: Vec<Point> =
        maze.joined_points().filter(|(_, ways)| ways.count() == 1).map(|(at, _)| at).collect();
    let ends: Vec<Point> = ends.into_iter().filter(|&at| !stays(maze, at)).collect();
    let mut choice = Choice::new(ends.len(), percent);
    for end in ends {
        if choice.next(random) {
            let mut at = end;
            // It ends at a node: the finish is the furthest point, so no dead end lies behind it.
            while let Some(heading) = maze.ways(at).only() {
                maze.erase(at, heading);
                at = at.step(heading);
            }
        }
    }
}

fn stays(maze: &Maze, at: Point) -> bool {
    maze.is_finish(at) || maze.start().is_some_and(|start| start.at == at)
}
