//! A set of headings: the ways that leave a point.

use super::Heading;

/// Up to four ways out of a point: a set of [`Heading`]s, one bit each.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct Ways(u8);

impl Ways {
    /// No way at all.
    pub const NONE: Self = Self(0);
    /// All four.
    pub const ALL: Self = Self(0b1111);

    /// The set with these bits (bit 0 is north, clockwise); higher bits are dropped.
    #[must_use]
    pub const fn from_bits(bits: u8) -> Self {
        Self(bits & 0b1111)
    }

    /// Bit 0 is north, then clockwise.
    #[must_use]
    pub const fn bits(self) -> u8 {
        self.0
    }

    /// Whether there is a way in this direction.
    #[must_use]
    pub const fn has(self, heading: Heading) -> bool {
        self.0 & (1 << heading as u8) != 0
    }

    /// The same set and this way.
    #[must_use]
    pub const fn with(self, heading: Heading) -> Self {
        Self(self.0 | 1 << heading as u8)
    }

    /// The same set without this way.
    #[must_use]
    pub const fn without(self, heading: Heading) -> Self {
        Self(self.0 & !(1 << heading as u8))
    }

    /// The ways of this set that are not in the other.
    #[must_use]
    pub const fn minus(self, other: Self) -> Self {
        Self(self.0 & !other.0)
    }

    /// How many ways, 0 to 4.
    #[must_use]
    pub const fn count(self) -> u32 {
        self.0.count_ones()
    }

    /// Whether there is none.
    #[must_use]
    pub const fn is_empty(self) -> bool {
        self.0 == 0
    }

    /// The only way, if there is exactly one.
    #[must_use]
    pub const fn only(self) -> Option<Heading> {
        if self.count() == 1 { Some(Heading::from_index(self.0.trailing_zeros() as u8)) } else { None }
    }

    /// The same ways as the bot numbers them, when `north` is the drawing's name of the bot's north;
    /// with the bot's heading as `north`, the result is relative to the bot.
    #[must_use]
    pub const fn in_frame_of(self, north: Heading) -> Self {
        let n = north as u8;
        Self((self.0 >> n | self.0 << (4 - n)) & 0b1111)
    }

    /// The inverse of [`Ways::in_frame_of`].
    #[must_use]
    pub const fn out_of_frame_of(self, north: Heading) -> Self {
        let n = north as u8;
        Self((self.0 << n | self.0 >> (4 - n)) & 0b1111)
    }

    /// The ways, clockwise from north.
    pub fn iter(self) -> impl Iterator<Item = Heading> {
        Heading::ALL.into_iter().filter(move |&heading| self.has(heading))
    }
}

impl FromIterator<Heading> for Ways {
    fn from_iter<I: IntoIterator<Item = Heading>>(headings: I) -> Self {
        headings.into_iter().fold(Self::NONE, Self::with)
    }
}
