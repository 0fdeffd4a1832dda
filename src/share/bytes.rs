//! Bytes in and out: numbers of any size in as few bytes as they need (LEB128), texts with their length.

use alloc::string::String;
use alloc::vec::Vec;

/// There are fewer bytes than there should be, or they are no number or text.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) struct Malformed;

/// Bytes that are still to be read.
pub(super) struct Reader<'a>(pub(super) &'a [u8]);

impl<'a> Reader<'a> {
    pub(super) fn byte(&mut self) -> Result<u8, Malformed> {
        let (&first, rest) = self.0.split_first().ok_or(Malformed)?;
        self.0 = rest;
        Ok(first)
    }

    pub(super) fn take(&mut self, count: usize) -> Result<&'a [u8], Malformed> {
        let (taken, rest) = self.0.split_at_checked(count).ok_or(Malformed)?;
        self.0 = rest;
        Ok(taken)
    }

    pub(super) fn long(&mut self) -> Result<u64, Malformed> {
        let mut value = 0;
        for shift in (0..64).step_by(7) {
            let byte = self.byte()?;
            let part = u64::from(byte & 0x7f);
            if part << shift >> shift != part {
                return Err(Malformed);
            }
            value |= part << shift;
            if byte & 0x80 == 0 {
                return Ok(value);
            }
        }
        Err(Malformed)
    }

    pub(super) fn number(&mut self) -> Result<u32, Malformed> {
        u32::try_from(self.long()?).map_err(|_| Malformed)
    }

    /// A number that may be absent: 0 then, otherwise one more.
    pub(super) fn maybe(&mut self) -> Result<Option<u32>, Malformed> {
        match self.long()? {
            0 => Ok(None),
            more => u32::try_from(more - 1).map(Some).map_err(|_| Malformed),
        }
    }

    /// A number of either sign: 0, −1, 1, −2, … are 0, 1, 2, 3, …
    pub(super) fn signed(&mut self) -> Result<i32, Malformed> {
        let folded = self.number()?;
        Ok((folded >> 1).cast_signed() ^ -(folded & 1).cast_signed())
    }

    pub(super) fn float(&mut self) -> Result<f64, Malformed> {
        let bytes = self.take(8)?.try_into().map_err(|_| Malformed)?;
        Ok(f64::from_be_bytes(bytes))
    }

    pub(super) fn text(&mut self) -> Result<String, Malformed> {
        let length = self.number()? as usize;
        let text = core::str::from_utf8(self.take(length)?).map_err(|_| Malformed)?;
        Ok(String::from(text))
    }
}

/// Bytes that are written.
#[derive(Default)]
pub(super) struct Writer(pub(super) Vec<u8>);

impl Writer {
    pub(super) fn byte(&mut self, byte: u8) {
        self.0.push(byte);
    }

    pub(super) fn long(&mut self, mut value: u64) {
        while value > 0x7f {
            self.byte(value as u8 | 0x80);
            value >>= 7;
        }
        self.byte(value as u8);
    }

    pub(super) fn number(&mut self, value: u32) {
        self.long(u64::from(value));
    }

    pub(super) fn signed(&mut self, value: i32) {
        self.number((value << 1 ^ value >> 31).cast_unsigned());
    }

    pub(super) fn float(&mut self, value: f64) {
        self.0.extend(value.to_be_bytes());
    }

    pub(super) fn text(&mut self, text: &str) {
        // Longer texts make a link too big, which is found out before anyone reads this.
        self.long(text.len() as u64);
        self.0.extend(text.as_bytes());
    }
}
