//! The table of nodes: what a node is, what the algorithm asks of its table, and the table of a board.

use crate::geometry::{Heading, Ways};

/// What the bot remembers of a node; directions are the bot's own.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Node {
    /// `x_cor`, in milliseconds of driving east.
    pub x_cor: i32,
    /// `y_cor`, in milliseconds of driving north.
    pub y_cor: i32,
    /// `paths`: the ways there are.
    pub paths: Ways,
    /// `vpaths`: the ways already taken, or arrived by.
    pub vpaths: Ways,
    /// Where the bot first came from.
    pub back_path: Heading,
    /// The way last chosen here (ours; §3.2 needs it).
    pub last_path: Option<Heading>,
}

impl Node {
    /// `record_node()`: a node just met, its `back_path` visited.
    #[must_use]
    pub const fn new(x_cor: i32, y_cor: i32, paths: Ways, back_path: Heading) -> Self {
        Self { x_cor, y_cor, paths, vpaths: Ways::NONE.with(back_path), back_path, last_path: None }
    }

    /// The ways not yet taken.
    #[must_use]
    pub const fn unvisited(&self) -> Ways {
        self.paths.minus(self.vpaths)
    }

    /// `|dx| + |dy|` to a place, if both are below `epsilon`.
    #[must_use]
    pub(super) fn matches(&self, x: i32, y: i32, epsilon: u32) -> Option<u64> {
        let (dx, dy) = (self.x_cor.abs_diff(x), self.y_cor.abs_diff(y));
        (dx < epsilon && dy < epsilon).then_some(u64::from(dx) + u64::from(dy))
    }
}

/// A table of nodes, numbered from 1 in the order that they were met; the last is forgotten first.
pub trait NodeStore {
    /// How many nodes it can hold.
    fn capacity(&self) -> u32;

    /// How many it holds.
    fn len(&self) -> u32;

    /// Whether it holds none.
    fn is_empty(&self) -> bool {
        self.len() == 0
    }

    /// Node `m`, from 1 to [`NodeStore::len`].
    fn node(&self, m: u32) -> &Node;

    /// Appends a node and returns its number, or nothing where the table is full.
    fn push(&mut self, node: Node) -> Option<u32>;

    /// Sets `vpaths[way]` of node `m`.
    fn visit(&mut self, m: u32, way: Heading);

    /// Sets `last_path` of node `m`.
    fn leave(&mut self, m: u32, way: Heading);

    /// Forgets every node above `len`.
    fn truncate(&mut self, len: u32);

    /// `match_cur_node()`: the node nearer than `epsilon` on both axes; of several, the nearest by
    /// `|dx| + |dy|`, then the lowest number.
    fn find(&mut self, x: i32, y: i32, epsilon: u32) -> Option<u32>;

    /// `unvisited(m, ptr − 1)`: whether node `m` or a later one has a way not yet taken.
    fn any_unvisited_from(&mut self, m: u32) -> bool;
}

/// A board's table: `N` places, no heap, found by scanning.
#[derive(Clone, Debug)]
pub struct FixedStore<const N: usize> {
    nodes: [Node; N],
    len: usize,
}

impl<const N: usize> FixedStore<N> {
    /// An empty table.
    #[must_use]
    pub const fn new() -> Self {
        Self { nodes: [Node::new(0, 0, Ways::NONE, Heading::North); N], len: 0 }
    }
}

impl<const N: usize> Default for FixedStore<N> {
    fn default() -> Self {
        Self::new()
    }
}

impl<const N: usize> NodeStore for FixedStore<N> {
    fn capacity(&self) -> u32 {
        N as u32
    }

    fn len(&self) -> u32 {
        self.len as u32
    }

    fn node(&self, m: u32) -> &Node {
        &self.nodes[m as usize - 1]
    }

    fn push(&mut self, node: Node) -> Option<u32> {
        *self.nodes.get_mut(self.len)? = node;
        self.len += 1;
        Some(self.len as u32)
    }

    fn visit(&mut self, m: u32, way: Heading) {
        let node = &mut self.nodes[m as usize - 1];
        node.vpaths = node.vpaths.with(way);
    }

    fn leave(&mut self, m: u32, way: Heading) {
        self.nodes[m as usize - 1].last_path = Some(way);
    }

    fn truncate(&mut self, len: u32) {
        self.len = self.len.min(len as usize);
    }

    fn find(&mut self, x: i32, y: i32, epsilon: u32) -> Option<u32> {
        let near = |(i, node): (usize, &Node)| Some((node.matches(x, y, epsilon)?, i as u32 + 1));
        self.nodes[..self.len].iter().enumerate().filter_map(near).min().map(|(_, m)| m)
    }

    fn any_unvisited_from(&mut self, m: u32) -> bool {
        self.nodes[m as usize - 1..self.len].iter().any(|node| !node.unvisited().is_empty())
    }
}
