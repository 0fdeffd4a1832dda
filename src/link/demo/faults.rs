//! What goes wrong on real wires, on purpose and reproducibly: bytes lost, flipped, doubled or late, resets,
//! silence, floods of rubbish.

use alloc::collections::VecDeque;

use oorandom::Rand32;

/// One byte in so many is struck.
const STRIKE: u32 = 300;
/// A spell (reset, silence, flood) begins about so often.
const SPELL_EVERY_MS: u32 = 9_000;
/// Bytes a millisecond in a flood: 1 MB/s.
const FLOOD: u64 = 1_000;

/// A source of faults.
#[derive(Clone, Debug)]
pub struct Faults {
    chance: Rand32,
    spell: Spell,
    next_spell_ms: Option<u64>,
    last_ms: u64,
}

#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Spell {
    None,
    Reset,
    Silence { until_ms: u64 },
    Flood { until_ms: u64 },
}

impl Faults {
    /// The same seed and the same traffic bring the same faults.
    #[must_use]
    pub fn new(seed: u64) -> Self {
        Self { chance: Rand32::new(seed), spell: Spell::None, next_spell_ms: None, last_ms: 0 }
    }

    fn once_in(&mut self, times: u32) -> bool {
        self.chance.rand_range(0..times) == 0
    }

    /// A byte on the way to the robot: it, nothing, another, or twice.
    pub(super) fn towards_robot(&mut self, byte: u8, now_ms: u64) -> [Option<u8>; 2] {
        if matches!(self.spell, Spell::Silence { until_ms } if now_ms < until_ms) {
            return [None, None];
        }
        self.strike(byte)
    }

    fn strike(&mut self, byte: u8) -> [Option<u8>; 2] {
        if !self.once_in(STRIKE) {
            return [Some(byte), None];
        }
        match self.chance.rand_range(0..3) {
            0 => [None, None],
            1 => [Some(byte ^ 1 << self.chance.rand_range(0..8)), None],
            _ => [Some(byte), Some(byte)],
        }
    }

    /// A byte on the way to the page.
    pub(super) fn towards_page(&mut self, byte: u8, now_ms: u64, way: &mut VecDeque<(u64, u8)>) {
        if matches!(self.spell, Spell::Silence { until_ms } if now_ms < until_ms) {
            return;
        }
        // Bytes never overtake each other: one that is late holds up all behind it.
        let held_up = way.back().map_or(0, |&(due_ms, _)| due_ms);
        let late = if self.once_in(4 * STRIKE) { u64::from(self.chance.rand_range(50..700)) } else { 0 };
        let due_ms = held_up.max(now_ms + late);
        way.extend(self.strike(byte).into_iter().flatten().map(|byte| (due_ms, byte)));
    }

    /// Whether the robot resets now.
    pub(super) fn resets(&mut self, now_ms: u64) -> bool {
        let due_ms = *self.next_spell_ms.get_or_insert(now_ms + u64::from(SPELL_EVERY_MS));
        if now_ms >= due_ms {
            self.next_spell_ms = Some(now_ms + u64::from(self.chance.rand_range(1..2 * SPELL_EVERY_MS)));
            let for_ms = u64::from(self.chance.rand_range(100..1_500));
            self.spell = match self.chance.rand_range(0..4) {
                0 => Spell::Reset,
                1 => Spell::Flood { until_ms: now_ms + for_ms / 4 },
                _ => Spell::Silence { until_ms: now_ms + for_ms },
            };
        }
        if self.spell == Spell::Reset {
            self.spell = Spell::None;
            return true;
        }
        false
    }

    /// Rubbish for the page, while a flood lasts.
    pub(super) fn flood(&mut self, now_ms: u64, way: &mut VecDeque<(u64, u8)>) {
        let since_ms = core::mem::replace(&mut self.last_ms, now_ms);
        if matches!(self.spell, Spell::Flood { until_ms } if now_ms < until_ms) {
            let held_up = way.back().map_or(0, |&(due_ms, _)| due_ms).max(now_ms);
            for _ in 0..FLOOD * (now_ms - since_ms).min(100) {
                way.push_back((held_up, self.chance.rand_u32() as u8));
            }
        }
    }
}
