//! A robot's memory, as large as an ATmega328P's, that can lose its power at any byte.

use super::super::keep::Memory;

/// Bytes of an ATmega328P's EEPROM.
pub const SIZE: u16 = 1024;

/// Bytes that stay. For tests, the power can go after a number of writes: later ones are lost, and the byte
/// that is written just then holds something else.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Eeprom {
    bytes: alloc::vec::Vec<u8>,
    writes_left: Option<u32>,
    writes: u32,
    torn: u8,
}

impl Default for Eeprom {
    fn default() -> Self {
        Self { bytes: alloc::vec![0xFF; SIZE as usize], writes_left: None, writes: 0, torn: 0xFF }
    }
}

impl Eeprom {
    /// Loses its power after so many more writes; the byte written then holds `torn` instead.
    #[must_use]
    pub const fn dies_after(mut self, writes: u32, torn: u8) -> Self {
        self.writes_left = Some(writes);
        self.torn = torn;
        self
    }

    /// With its power back.
    #[must_use]
    pub const fn alive(mut self) -> Self {
        self.writes_left = None;
        self
    }

    /// Whether its power is gone.
    #[must_use]
    pub fn is_dead(&self) -> bool {
        self.writes_left == Some(0)
    }

    /// How many bytes were written so far.
    #[must_use]
    pub const fn writes(&self) -> u32 {
        self.writes
    }

    /// What it holds.
    #[must_use]
    pub fn bytes(&self) -> &[u8] {
        &self.bytes
    }
}

impl Memory for Eeprom {
    fn len(&self) -> u16 {
        SIZE
    }

    fn read(&self, at: u16) -> u8 {
        self.bytes.get(usize::from(at)).copied().unwrap_or(0xFF)
    }

    fn write(&mut self, at: u16, byte: u8) {
        let Some(place) = self.bytes.get_mut(usize::from(at)) else { return };
        match &mut self.writes_left {
            Some(0) => {}
            Some(1) => {
                self.writes_left = Some(0);
                *place = self.torn;
            }
            Some(left) => {
                *left -= 1;
                *place = byte;
            }
            None => *place = byte,
        }
        self.writes += 1;
    }
}
