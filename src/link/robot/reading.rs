//! Answers of many lines: told one by one, as there is room.

use super::super::fields::{Letters, MAX_LETTERS, Tag};
use super::super::keep::{List, Memory};
use super::super::report::{NodeLine, Report, Said};
use super::{Body, Robot};
use crate::explorer::book::store::NodeStore;

/// What is being read, and how far.
#[derive(Clone, Copy, Debug)]
pub(super) enum Reading {
    /// Nothing.
    Nothing,
    /// The turn list: first its head, then its letters.
    Turns { tag: Option<Tag>, list: List, next: Option<u16> },
    /// The node table; the next row.
    Nodes { tag: Option<Tag>, next: u32 },
}

impl Reading {
    pub(super) const fn turns(list: List, tag: Option<Tag>) -> Self {
        Self::Turns { tag, list, next: None }
    }
}

impl<B: Body, M: Memory, const NODES: usize> Robot<B, M, NODES> {
    pub(super) fn read_on(&mut self) {
        while self.output.has_room() {
            self.reading = match self.reading {
                Reading::Nothing => return,
                Reading::Turns { tag, list, next } => self.read_turns(tag, list, next),
                Reading::Nodes { tag, next } => self.read_node(tag, next),
            };
        }
    }

    fn read_turns(&mut self, tag: Option<Tag>, list: List, next: Option<u16>) -> Reading {
        let upload = list.upload;
        let Some(offset) = next else {
            let (id, len, crc) = (upload.id, upload.len, upload.crc);
            self.say(&Report::TurnsHave { id, len, crc, origin: list.origin });
            return Reading::Turns { tag, list, next: Some(0) };
        };
        let mut letters = [b'S'; MAX_LETTERS];
        let len = usize::from(upload.len - offset).min(MAX_LETTERS);
        for (letter, index) in letters[..len].iter_mut().zip(offset..) {
            *letter = self.keep.letter(index).map_or(b'?', |turn| turn.letter() as u8);
        }
        let text = core::str::from_utf8(&letters[..len]).unwrap_or_default();
        let Some(letters) = Letters::new(text) else {
            // Nothing is left, or the list has changed under the reader.
            self.say(&Report::Ok(tag, Said::Nothing));
            return Reading::Nothing;
        };
        self.say(&Report::TurnsData { id: upload.id, offset, letters });
        Reading::Turns { tag, list, next: Some(offset + len as u16) }
    }

    fn read_node(&mut self, tag: Option<Tag>, next: u32) -> Reading {
        let nodes = self.book.nodes();
        if next > nodes.len() {
            let count = nodes.len() as u16;
            self.say(&Report::Ok(tag, Said::Nodes(count)));
            return Reading::Nothing;
        }
        let node = *nodes.node(next);
        self.say(&Report::Node(NodeLine {
            node: next as u16,
            x: node.x_cor,
            y: node.y_cor,
            paths: node.paths,
            vpaths: node.vpaths,
            back_path: node.back_path,
            last_path: node.last_path,
        }));
        Reading::Nodes { tag, next: next + 1 }
    }
}
