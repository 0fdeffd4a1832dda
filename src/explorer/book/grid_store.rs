//! The host's table of nodes: found by place, and asked for unvisited ways without scanning.
//!
//! Places are sorted into buckets as wide as two `epsilon`, so that a node's place and everything that
//! matches it lie in at most two by two of them; for coordinates on the lattice it is a single one. Buckets
//! live in tiles of 8 × 8, and the tile last used is kept at hand, as a bot moves from neighbour to
//! neighbour.

use alloc::vec::Vec;
use core::ops::RangeInclusive;

use hashbrown::HashMap;

use super::store::{Node, NodeStore};
use crate::geometry::Heading;

/// Buckets along a tile's side, as a power of two.
const TILE_SHIFT: u32 = 3;
const TILE_MASK: i32 = (1 << TILE_SHIFT) - 1;
const TILE_LEN: usize = 1 << (2 * TILE_SHIFT);

/// A node's bucket, as a place in `heads`, and the node below it there, or 0.
#[derive(Clone, Copy, Debug)]
struct Link {
    head: u32,
    below: u32,
}

/// A growing table with an index by place.
#[derive(Clone, Debug)]
pub struct GridStore {
    capacity: u32,
    epsilon: u32,
    nodes: Vec<Node>,
    /// For each node, where its bucket is and who was there before.
    links: Vec<Link>,
    /// Numbers of nodes with unvisited ways, ascending; closed and forgotten ones are dropped when they
    /// come to the end.
    open: Vec<u32>,
    /// The highest node of each bucket, or 0; 8 × 8 buckets together.
    heads: Vec<u32>,
    /// The numbers of the tiles that there are.
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
            links: Vec::new(),
            open: Vec::new(),
            heads: Vec::new(),
            tile_at: HashMap::new(),
            at_hand: None,
        }
    }

    /// The column (or row) of a coordinate, and those of the least and the greatest coordinate that match it.
    /// Buckets are centred on multiples of their width, where the lattice points of an ideal world are.
    fn along(&self, coordinate: i32) -> (i32, RangeInclusive<i32>) {
        let epsilon = i64::from(self.epsilon.max(1));
        let from_edge = i64::from(coordinate) + epsilon;
        let (column, inside) = (from_edge.div_euclid(2 * epsilon) as i32, from_edge.rem_euclid(2 * epsilon));
        let least = if inside < epsilon - 1 { column - 1 } else { column };
        let greatest = if inside > epsilon { column + 1 } else { column };
        (column, least..=greatest)
    }

    /// The number of the tile that a bucket is in, if there is one.
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

    /// Where in `heads` a bucket of a tile is.
    const fn place(tile: u32, (column, row): Bucket) -> u32 {
        (tile << (2 * TILE_SHIFT)) | ((row & TILE_MASK) << TILE_SHIFT | (column & TILE_MASK)) as u32
    }

    /// The highest node of a bucket, or 0.
    fn head(&mut self, bucket: Bucket) -> u32 {
        self.tile(bucket).map_or(0, |tile| self.heads[Self::place(tile, bucket) as usize])
    }

    /// Where in `heads` a bucket is; makes its tile if there is none.
    fn make(&mut self, bucket: Bucket) -> u32 {
        let tile = self.tile(bucket).unwrap_or_else(|| {
            let tile = (self.heads.len() / TILE_LEN) as u32;
            self.heads.resize(self.heads.len() + TILE_LEN, 0);
            self.tile_at.insert((bucket.0 >> TILE_SHIFT, bucket.1 >> TILE_SHIFT), tile);
            tile
        });
        Self::place(tile, bucket)
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
        let head = self.make((self.along(node.x_cor).0, self.along(node.y_cor).0));
        let below = core::mem::replace(&mut self.heads[head as usize], m);
        self.links.push(Link { head, below });
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
            self.nodes.pop();
            if let Some(Link { head, below }) = self.links.pop() {
                self.heads[head as usize] = below;
            }
        }
    }

    fn find(&mut self, x: i32, y: i32, epsilon: u32) -> Option<u32> {
        debug_assert_eq!(epsilon, self.epsilon, "the index is made for one epsilon");
        let mut nearest: Option<(u64, u32)> = None;
        let columns = self.along(x).1;
        for row in self.along(y).1 {
            for column in columns.clone() {
                let mut m = self.head((column, row));
                while m != 0 {
                    if let Some(distance) = self.nodes[m as usize - 1].matches(x, y, epsilon) {
                        nearest = Some(nearest.map_or((distance, m), |best| best.min((distance, m))));
                    }
                    m = self.links[m as usize - 1].below;
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
