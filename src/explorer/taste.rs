//! Where a preference order comes from: always the same, or drawn anew for each choice (book §3.1 recommends
//! a random one).

use crate::geometry::Turn;
use crate::settings::Order;

/// Source of preference orders.
#[derive(Clone, Debug)]
pub(super) enum Taste {
    Fixed([Turn; 3]),
    Random(oorandom::Rand32),
}

impl Taste {
    /// As it was set.
    pub(super) fn new(order: Order) -> Self {
        match order {
            Order::Fixed(preference) => Self::Fixed(preference.turns()),
            Order::Random(seed) => Self::Random(oorandom::Rand32::new(seed)),
        }
    }

    /// The order of the next choice.
    pub(super) fn order(&mut self) -> [Turn; 3] {
        match self {
            Self::Fixed(order) => *order,
            Self::Random(chance) => {
                let mut order = [Turn::Straight, Turn::Right, Turn::Left];
                order.swap(2, chance.rand_range(0..3) as usize);
                order.swap(1, chance.rand_range(0..2) as usize);
                order
            }
        }
    }
}
