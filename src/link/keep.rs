//! What a robot keeps over a power loss: its turn list and its settings, each in two slots.
//!
//! The newer valid slot counts. A change is written into the other one: first its mark is wiped, then comes
//! the content with its checksum, and the mark last. So at every byte, even one that is cut in the middle, at
//! least one slot is whole: the old or the new. Marks count 0, 1, 2, 0, …: the newer of two is known.

use super::fields::Letters;
use super::frame::crc16;
use super::report::{Code, Origin};
use super::request::Upload;
use super::tune::{Name, Tune};
use crate::geometry::Turn;

/// Bytes that stay over a power loss, as an EEPROM has them. A byte that is cut while it is written may hold
/// anything.
pub trait Memory {
    /// How many bytes there are.
    fn len(&self) -> u16;

    /// Whether there is none.
    fn is_empty(&self) -> bool {
        self.len() == 0
    }

    /// A byte; those past the end are FF.
    fn read(&self, at: u16) -> u8;

    /// Writes a byte; past the end nothing happens.
    fn write(&mut self, at: u16, byte: u8);
}

/// A mark's upper half: neither fresh (FF) nor wiped (00) memory looks like it.
const MARK: u8 = 0xA0;
/// What wipes a mark.
const NO_MARK: u8 = 0;
/// Mark, settings, CRC.
const TUNE_SLOT: u16 = 1 + 4 * Name::COUNT as u16 + 2;
/// Mark, ID, length, CRC of the letters, origin, CRC of all this; then letters.
const LIST_HEAD: u16 = 10;

/// The memory, and which slots count.
#[derive(Debug)]
pub struct Keep<M> {
    memory: M,
    tune: Slot,
    list: Option<List>,
    list_slot: Slot,
    upload: Option<Coming>,
}

/// One of two, and the count in its mark.
#[derive(Clone, Copy, Debug)]
struct Slot {
    index: u16,
    count: u8,
}

impl Slot {
    /// Where the next content goes; before any content, into slot 0.
    const NONE: Self = Self { index: 1, count: 2 };

    const fn next(self) -> Self {
        Self { index: 1 - self.index, count: (self.count + 1) % 3 }
    }

    const fn mark(self) -> u8 {
        MARK | self.count
    }
}

/// The turn list that is kept.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct List {
    /// Its number, length and checksum.
    pub upload: Upload,
    /// Who made it.
    pub origin: Origin,
}

/// An upload that goes on.
#[derive(Clone, Copy, Debug)]
struct Coming {
    upload: Upload,
    received: u16,
}

impl<M: Memory> Keep<M> {
    /// Finds what is kept.
    #[must_use]
    pub fn open(memory: M) -> Self {
        let mut keep = Self { memory, tune: Slot::NONE, list: None, list_slot: Slot::NONE, upload: None };
        if let Some((slot, ())) = keep.newest(0, TUNE_SLOT, |keep, at, _| keep.tune_fits(at)) {
            keep.tune = slot;
        }
        if let Some((slot, list)) = keep.newest(2 * TUNE_SLOT, keep.list_slot_len(), Self::list_at) {
            (keep.list_slot, keep.list) = (slot, Some(list));
        }
        keep
    }

    /// The memory.
    #[must_use]
    pub const fn memory(&self) -> &M {
        &self.memory
    }

    /// The memory, when the power is gone.
    #[must_use]
    pub fn close(self) -> M {
        self.memory
    }

    /// Letters of a turn list that fit.
    #[must_use]
    pub fn capacity(&self) -> u16 {
        self.list_slot_len().saturating_sub(LIST_HEAD).min(9_999)
    }

    fn list_slot_len(&self) -> u16 {
        self.memory.len().saturating_sub(2 * TUNE_SLOT) / 2
    }

    fn list_slot_at(&self, slot: Slot) -> u16 {
        2 * TUNE_SLOT + slot.index * self.list_slot_len()
    }

    /// The newer of two slots, of those whose content is whole.
    fn newest<T>(
        &self,
        from: u16,
        len: u16,
        whole: impl Fn(&Self, u16, u8) -> Option<T>,
    ) -> Option<(Slot, T)> {
        let read = |index: u16| {
            let at = from + index * len;
            let mark = self.memory.read(at);
            let count = mark & !MARK;
            let slot = Slot { index, count };
            if mark != slot.mark() || count > 2 { None } else { whole(self, at, mark).map(|it| (slot, it)) }
        };
        match (read(0), read(1)) {
            (Some(a), Some(b)) => Some(if a.0.next().count == b.0.count { b } else { a }),
            (a, b) => a.or(b),
        }
    }

    fn bytes(&self, at: u16, len: u16) -> impl Iterator<Item = u8> {
        (at..at + len).map(|at| self.memory.read(at))
    }

    fn word(&self, at: u16) -> u16 {
        u16::from_le_bytes([self.memory.read(at), self.memory.read(at + 1)])
    }

    fn put_word(&mut self, at: u16, word: u16) {
        let [low, high] = word.to_le_bytes();
        self.memory.write(at, low);
        self.memory.write(at + 1, high);
    }

    /// Whether a slot holds settings.
    fn tune_fits(&self, at: u16) -> Option<()> {
        let crc = at + TUNE_SLOT - 2;
        (crc16(self.bytes(at, TUNE_SLOT - 2)) == self.word(crc)).then_some(())
    }

    /// The settings that are kept; those out of their range, and before any were kept all, as they come.
    #[must_use]
    pub fn tune(&self) -> Tune {
        let at = self.tune.index * TUNE_SLOT;
        let mut tune = Tune::default();
        if self.memory.read(at) != self.tune.mark() {
            return tune;
        }
        for name in Name::ALL {
            let at = at + 1 + 4 * name as u16;
            let mut bytes = [0; 4];
            for (byte, at) in bytes.iter_mut().zip(at..) {
                *byte = self.memory.read(at);
            }
            tune = tune.with(name, i32::from_le_bytes(bytes)).unwrap_or(tune);
        }
        tune
    }

    /// Keeps settings.
    ///
    /// # Errors
    /// [`Code::Store`] where the memory does not hold what was written.
    pub fn set_tune(&mut self, tune: &Tune) -> Result<(), Code> {
        let slot = self.tune.next();
        let at = slot.index * TUNE_SLOT;
        self.memory.write(at, NO_MARK);
        for name in Name::ALL {
            for (byte, at) in tune.get(name).to_le_bytes().into_iter().zip(at + 1 + 4 * name as u16..) {
                self.memory.write(at, byte);
            }
        }
        let content = self.bytes(at + 1, TUNE_SLOT - 3);
        let crc = crc16([slot.mark()].into_iter().chain(content));
        self.put_word(at + TUNE_SLOT - 2, crc);
        self.memory.write(at, slot.mark());
        self.tune_fits(at).ok_or(Code::Store)?;
        self.tune = slot;
        Ok(())
    }

    /// The list in a slot, if it is whole.
    fn list_at(&self, at: u16, mark: u8) -> Option<List> {
        let origin = match self.memory.read(at + 7) {
            0 => Origin::Sent,
            1 => Origin::Learned,
            _ => return None,
        };
        let upload = Upload { id: self.word(at + 1), len: self.word(at + 3), crc: self.word(at + 5) };
        let head = crc16([mark].into_iter().chain(self.bytes(at + 1, LIST_HEAD - 3)));
        let fits = upload.len <= self.capacity()
            && head == self.word(at + LIST_HEAD - 2)
            && upload.crc == crc16(self.bytes(at + LIST_HEAD, upload.len));
        fits.then_some(List { upload, origin })
    }

    /// The list that is kept.
    #[must_use]
    pub const fn list(&self) -> Option<List> {
        self.list
    }

    /// A letter of it.
    #[must_use]
    pub fn letter(&self, index: u16) -> Option<Turn> {
        let list = self.list.filter(|list| index < list.upload.len)?;
        debug_assert!(list.upload.len <= self.capacity());
        let at = self.list_slot_at(self.list_slot) + LIST_HEAD + index;
        Turn::from_letter(char::from(self.memory.read(at)))
    }

    /// Begins an upload into the slot that does not count.
    ///
    /// # Errors
    /// Where the list is too long, or its number belongs to another list that is kept.
    pub fn begin(&mut self, upload: Upload) -> Result<(), Code> {
        if self.upload.is_some_and(|coming| coming.upload == upload) {
            return Ok(());
        }
        if self.list.is_some_and(|list| list.upload.id == upload.id && list.upload != upload) {
            return Err(Code::Id);
        }
        if upload.len > self.capacity() {
            return Err(Code::Full);
        }
        let at = self.list_slot_at(self.list_slot.next());
        self.memory.write(at, NO_MARK);
        self.upload = Some(Coming { upload, received: 0 });
        Ok(())
    }

    /// Takes a piece of the upload. A piece that is there already is no matter.
    ///
    /// # Errors
    /// Where no such upload goes on, a piece is missing before this one, or it is longer than announced.
    pub fn data(&mut self, id: u16, offset: u16, letters: Letters<'_>) -> Result<(), Code> {
        let coming = self.upload.filter(|coming| coming.upload.id == id && offset <= coming.received);
        let coming = coming.ok_or(Code::NoUpload)?;
        let end = offset.saturating_add(letters.as_str().len() as u16);
        if end > coming.upload.len {
            return Err(Code::Range);
        }
        self.put_letters(offset, letters.as_str().bytes());
        self.upload = Some(Coming { received: coming.received.max(end), ..coming });
        Ok(())
    }

    fn put_letters(&mut self, offset: u16, letters: impl Iterator<Item = u8>) {
        let at = self.list_slot_at(self.list_slot.next()) + LIST_HEAD + offset;
        for (letter, at) in letters.zip(at..) {
            self.memory.write(at, letter);
        }
    }

    /// Checks the upload and makes it the list that is kept. What is kept already is no matter.
    ///
    /// # Errors
    /// Where no such upload goes on, its length or checksum is wrong, or the memory failed.
    pub fn commit(&mut self, id: u16) -> Result<(), Code> {
        let Some(Coming { upload, received }) = self.upload.filter(|coming| coming.upload.id == id) else {
            let kept = self.list.is_some_and(|list| list.upload.id == id);
            return if kept { Ok(()) } else { Err(Code::NoUpload) };
        };
        if received != upload.len {
            return Err(Code::Crc);
        }
        let kept = self.seal(List { upload, origin: Origin::Sent });
        // A list that does not fit its checksum must be sent anew from its beginning.
        self.upload = None;
        kept
    }

    /// Keeps a list that the robot found. An upload that went on is forgotten: its slot is taken.
    ///
    /// # Errors
    /// Where it is too long, or the memory failed.
    pub fn learn(&mut self, turns: impl Iterator<Item = Turn> + Clone) -> Result<(), Code> {
        let len = turns.clone().take(usize::from(self.capacity()) + 1).count() as u16;
        if len > self.capacity() {
            return Err(Code::Full);
        }
        let letters = turns.map(|turn| turn.letter() as u8);
        let id = self.list.map_or(1, |list| list.upload.id.checked_add(1).unwrap_or(1));
        let upload = Upload { id, len, crc: crc16(letters.clone()) };
        self.upload = None;
        self.memory.write(self.list_slot_at(self.list_slot.next()), NO_MARK);
        self.put_letters(0, letters);
        self.seal(List { upload, origin: Origin::Learned })
    }

    /// Writes the head of the slot that does not count, its mark last, and makes it the one that counts.
    fn seal(&mut self, list: List) -> Result<(), Code> {
        let slot = self.list_slot.next();
        let at = self.list_slot_at(slot);
        let Upload { id, len, crc } = list.upload;
        if crc16(self.bytes(at + LIST_HEAD, len)) != crc {
            return Err(Code::Crc);
        }
        self.put_word(at + 1, id);
        self.put_word(at + 3, len);
        self.put_word(at + 5, crc);
        self.memory.write(at + 7, list.origin as u8);
        let head = crc16([slot.mark()].into_iter().chain(self.bytes(at + 1, LIST_HEAD - 3)));
        self.put_word(at + LIST_HEAD - 2, head);
        self.memory.write(at, slot.mark());
        if self.list_at(at, slot.mark()) != Some(list) {
            return Err(Code::Store);
        }
        (self.list_slot, self.list) = (slot, Some(list));
        Ok(())
    }
}
