//! The bytes that wait to be sent: whole lines or nothing.

use super::super::frame::MAX_LINE;

/// Room for four long lines.
const ROOM: usize = 4 * (MAX_LINE + 1);

/// A ring of bytes.
#[derive(Debug)]
pub(super) struct Output {
    bytes: [u8; ROOM],
    first: usize,
    len: usize,
}

impl Output {
    pub(super) const fn new() -> Self {
        Self { bytes: [0; ROOM], first: 0, len: 0 }
    }

    /// Whether another line fits, whatever its length.
    pub(super) const fn has_room(&self) -> bool {
        ROOM - self.len > MAX_LINE
    }

    /// Whether nothing waits.
    pub(super) const fn is_empty(&self) -> bool {
        self.len == 0
    }

    /// Whether a line and another before it fit.
    pub(super) const fn has_room_for_answer(&self) -> bool {
        self.len < ROOM / 2
    }

    /// Whether what may be left out should not be: half of the room is kept for answers and events.
    pub(super) const fn has_room_to_spare(&self) -> bool {
        self.len < ROOM / 4
    }

    /// Takes a line, if it fits.
    pub(super) fn line(&mut self, line: &[u8]) {
        if line.len() > ROOM - self.len {
            return;
        }
        for &byte in line {
            self.bytes[(self.first + self.len) % ROOM] = byte;
            self.len += 1;
        }
    }

    pub(super) fn pop(&mut self) -> Option<u8> {
        if self.len == 0 {
            return None;
        }
        let byte = self.bytes[self.first];
        self.first = (self.first + 1) % ROOM;
        self.len -= 1;
        Some(byte)
    }
}
