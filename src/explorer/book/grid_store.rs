//! The host's table of nodes: found by place, and asked for unvisited ways without scanning.
//!
//! Places are sorted into buckets as wide as two `epsilon`, so that a node's place and everything that
//! matches it lie in at most two by two of them; for coordinates on the lattice it is a single one. Buckets
//! live in tiles of 8 × 8, and the tile last used is kept at hand, as a bot moves from neighbour to
//! neighbour.

use alloc::vec::Vec;

use hashbrown::HashMap;

use super::store::{Node, NodeStore};
use crate::geometry::Heading;

/// Buckets along a tile's side, as a power of two.
const TILE_SHIFT: u32 = 3;
const TILE_MASK: i32 = (1 << TILE_SHIFT) - 1;
const TILE_LEN: usize = 1 << (2 * TILE_SHIFT);

type Tile = [u32; TILE_LEN];

/// A growing table with an index by place.
#[derive(Clone, Debug)]
pub struct GridStore {
    capacity: u32,
    epsilon: u32,
    nodes: Vec<Node>,
    /// The node below in the same bucket, or 0.
    below: Vec<u32>,
    /// Numbers of nodes with unvisited ways, ascending; closed and forgotten ones are dropped when they
    /// come to the end.
    open: Vec<u32>,
    tiles: Vec<Tile>,
    tile_at: HashMap<(i32, i32), u32>,
    at_hand: Option<((i32, i32), u32)>,
}

/// A bucket's column and row.
type Bucket = (i32, i32);

impl GridStore {
    /// An empty table that holds at most `capacity` nodes, indexed for this `epsilon`.
    #[must_use]
    pub fn new(capacity: u32, epsilon: u32) -> Self {
        Self {
            capacity,
            epsilon,
            nodes: Vec::new(),
            below: Vec::new(),
            open: Vec::new(),
            tiles: Vec::new(),
            tile_at: HashMap::new(),
            at_hand: None,
        }
    }

    /// The bucket of a coordinate moved by `shift`. Buckets are centred on multiples of their width, where
    /// the lattice points of an ideal world are.
    fn along(&self, coordinate: i32, shift: i64) -> i32 {
        let epsilon = i64::from(self.epsilon.max(1));
        (i64::from(coordinate) + epsilon + shift).div_euclid(2 * epsilon) as i32
    }

    fn bucket(&self, x: i32, y: i32) -> Bucket {
        (self.along(x, 0), self.along(y, 0))
    }

    /// The tile of a bucket, if there is one.
    fn tile(&mut self, (column, row): Bucket) -> Option<u32> {
        let key = (column >> TILE_SHIFT, row >> TILE_SHIFT);
        match self.at_hand {
            Some((at, tile)) if at == key => Some(tile),
            _ => {
                let tile = *self.tile_at.get(&key)?;
                self.at_hand = Some((key, tile));
                Some(tile)
            }
        }
    }

    const fn place((column, row): Bucket) -> usize {
        ((row & TILE_MASK) << TILE_SHIFT | (column & TILE_MASK)) as usize
    }

    /// The highest node of a bucket, or 0.
    fn head(&mut self, bucket: Bucket) -> u32 {
        self.tile(bucket).map_or(0, |tile| self.tiles[tile as usize][Self::place(bucket)])
    }

    /// Where the highest node of a bucket is kept; makes the tile if there is none.
    fn head_mut(&mut self, bucket: Bucket) -> &mut u32 {
        let tile = self.tile(bucket).unwrap_or_else(|| {
            let tile = self.tiles.len() as u32;
            self.tiles.push([0; TILE_LEN]);
            self.tile_at.insert((bucket.0 >> TILE_SHIFT, bucket.1 >> TILE_SHIFT), tile);
            tile
        });
        &mut self.tiles[tile as usize][Self::place(bucket)]
    }

    fn pop(&mut self) {
        if let (Some(node), Some(below)) = (self.nodes.pop(), self.below.pop()) {
            let bucket = self.bucket(node.x_cor, node.y_cor);
            *self.head_mut(bucket) = below;
        }
    }
}

impl NodeStore for GridStore {
    fn capacity(&self) -> u32 {
        self.capacity
    }

    fn len(&self) -> u32 {
        self.nodes.len() as u32
    }

    fn node(&self, m: u32) -> &Node {
        &self.nodes[m as usize - 1]
    }

    fn push(&mut self, node: Node) -> Option<u32> {
        if self.len() >= self.capacity {
            return None;
        }
        let m = self.len() + 1;
        // Numbers are used again: what an earlier node left at the end of `open` goes first.
        while self.open.pop_if(|&mut last| last >= m).is_some() {}
        self.open.push(m);
        let bucket = self.bucket(node.x_cor, node.y_cor);
        let below = core::mem::replace(self.head_mut(bucket), m);
        self.below.push(below);
        self.nodes.push(node);
        Some(m)
    }

    fn visit(&mut self, m: u32, way: Heading) {
        let node = &mut self.nodes[m as usize - 1];
        node.vpaths = node.vpaths.with(way);
    }

    fn leave(&mut self, m: u32, way: Heading) {
        self.nodes[m as usize - 1].last_path = Some(way);
    }

    fn truncate(&mut self, len: u32) {
        while self.len() > len {
            self.pop();
        }
    }

    fn find(&mut self, x: i32, y: i32, epsilon: u32) -> Option<u32> {
        debug_assert_eq!(epsilon, self.epsilon, "the index is made for one epsilon");
        let reach = i64::from(epsilon) - 1;
        let mut nearest: Option<(u64, u32)> = None;
        for row in self.along(y, -reach)..=self.along(y, reach) {
            for column in self.along(x, -reach)..=self.along(x, reach) {
                let mut m = self.head((column, row));
                while m != 0 {
                    if let Some(distance) = self.nodes[m as usize - 1].matches(x, y, epsilon) {
                        nearest = Some(nearest.map_or((distance, m), |best| best.min((distance, m))));
                    }
                    m = self.below[m as usize - 1];
                }
            }
        }
        nearest.map(|(_, m)| m)
    }

    fn any_unvisited_from(&mut self, m: u32) -> bool {
        let (nodes, len) = (&self.nodes, self.nodes.len() as u32);
        let closed = |last: &mut u32| *last > len || nodes[*last as usize - 1].unvisited().is_empty();
        while self.open.pop_if(closed).is_some() {}
        self.open.last().is_some_and(|&last| last >= m)
    }
}

#[cfg(test)]
mod tests {
    use super::super::store::FixedStore;
    use super::*;
    use crate::geometry::Ways;
    use proptest::prelude::*;

    proptest! {
        /// Both tables answer alike, whatever happens to them.
        #[test]
        fn agrees_with_the_scanned_table(
            epsilon in 0u32..90,
            steps in proptest::collection::vec((0u8..6, -60i32..60, -60i32..60, 0u8..16), 1..300),
        ) {
            let mut scanned = FixedStore::<40>::new();
            let mut indexed = GridStore::new(40, epsilon);
            for (what, x, y, bits) in steps {
                let m = if scanned.is_empty() { 0 } else { x.unsigned_abs() % scanned.len() + 1 };
                let way = Heading::from_index(bits);
                match what {
                    0 | 1 => {
                        let node = Node::new(x, y, Ways::from_bits(bits), way);
                        prop_assert_eq!(scanned.push(node), indexed.push(node));
                    }
                    2 if m > 0 => { scanned.visit(m, way); indexed.visit(m, way); }
                    3 => { scanned.truncate(m); indexed.truncate(m); }
                    4 if m > 0 => {
                        prop_assert_eq!(scanned.any_unvisited_from(m), indexed.any_unvisited_from(m));
                    }
                    _ => prop_assert_eq!(scanned.find(x, y, epsilon), indexed.find(x, y, epsilon)),
                }
                prop_assert_eq!(scanned.len(), indexed.len());
            }
        }
    }
}
