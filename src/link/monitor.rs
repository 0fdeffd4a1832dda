//! The monitor: what went over the wire, both ways, as lines with wall-clock times; rubbish stays readable.

use alloc::boxed::Box;
use alloc::collections::VecDeque;
use alloc::string::String;
use alloc::vec::Vec;
use core::fmt::Write;

use super::frame::{LineError, is_end};

/// Lines that are kept.
pub const KEPT_LINES: usize = 10_000;
/// What has no end of line is cut into lines of so many bytes.
const LONGEST: usize = 160;

/// Which way a line went.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Way {
    /// From the robot.
    In,
    /// To the robot.
    Out,
}

/// What became of a line.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Mark {
    /// Understood, or sent.
    Plain,
    /// Not used: it is damaged.
    Bad(LineError),
    /// Not used: it is whole, but no line of the protocol, or has no checksum.
    Strange,
    /// Sent, but it did not leave the computer.
    Lost,
    /// Here the robot first decided otherwise than the page's explorer.
    Differs,
}

impl Mark {
    /// What the monitor says behind the line.
    #[must_use]
    pub const fn text(self) -> &'static str {
        match self {
            Self::Plain => "",
            Self::Bad(LineError::TooLong) => "too long, not used",
            Self::Bad(LineError::Byte(_)) => "strange bytes, not used",
            Self::Bad(LineError::Sum { .. } | LineError::Star) => "bad checksum, not used",
            Self::Strange => "not understood, not used",
            Self::Lost => "did not leave the computer, thrown away",
            Self::Differs => "the page decides otherwise",
        }
    }
}

/// A line as it went over the wire, without its end.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct LogLine {
    /// When, on the page's clock.
    pub ms: u64,
    /// Which way.
    pub way: Way,
    /// Its bytes.
    pub bytes: Box<[u8]>,
    /// What became of it.
    pub mark: Mark,
}

/// Which lines are shown.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Show {
    /// All.
    #[default]
    All,
    /// What the robot tells of its run, and answers: no sensors, no beats.
    Events,
    /// What was sent.
    Sent,
}

impl LogLine {
    /// The line, with everything that is not printable as `\x8A`.
    #[must_use]
    pub fn text(&self) -> String {
        readable(&self.bytes)
    }

    /// Whether it is shown: of this sort, and with these letters somewhere in it.
    #[must_use]
    pub fn matches(&self, show: Show, letters: &str) -> bool {
        let chatter = self.bytes.starts_with(b"ir ") || self.bytes.starts_with(b"beat ");
        let sort = match show {
            Show::All => true,
            Show::Events => self.way == Way::In && !chatter,
            Show::Sent => self.way == Way::Out,
        };
        sort && (letters.is_empty() || self.text().contains(letters))
    }
}

/// Bytes as text; printable ASCII but `\` stands for itself.
pub(super) fn readable(bytes: &[u8]) -> String {
    let mut text = String::with_capacity(bytes.len());
    for &byte in bytes {
        match byte {
            b'\\' => text.push_str("\\\\"),
            b' '..=b'~' => text.push(char::from(byte)),
            _ => {
                // Writing to a string cannot fail.
                let _ = write!(text, "\\x{byte:02X}");
            }
        }
    }
    text
}

/// The last [`KEPT_LINES`] lines.
#[derive(Debug)]
pub struct Monitor {
    lines: VecDeque<LogLine>,
    /// Lines that came before the first that is kept.
    dropped: u64,
    coming: Vec<u8>,
    coming_ms: u64,
    bad: u64,
    /// Add it to the page's clock for milliseconds since midnight.
    wall_offset_ms: i64,
}

impl Monitor {
    /// An empty one, at a moment of the page's clock that is so many milliseconds after midnight.
    #[must_use]
    pub const fn new(now_ms: u64, wall_ms: u64) -> Self {
        Self {
            lines: VecDeque::new(),
            dropped: 0,
            coming: Vec::new(),
            coming_ms: 0,
            bad: 0,
            wall_offset_ms: wall_ms as i64 - now_ms as i64,
        }
    }

    /// Takes a byte from the robot; at the end of a line it is logged.
    pub(super) fn byte_in(&mut self, byte: u8, now_ms: u64) {
        if self.coming.is_empty() {
            self.coming_ms = now_ms;
        }
        if is_end(byte) {
            return self.end_line(Mark::Plain);
        }
        self.coming.push(byte);
        if self.coming.len() >= LONGEST {
            self.end_line(Mark::Strange);
        }
    }

    /// What came so far is a line: the connection ends here.
    pub(super) fn end_line(&mut self, mark: Mark) {
        if !self.coming.is_empty() {
            let bytes = self.coming.as_slice().into();
            self.coming.clear();
            self.push(LogLine { ms: self.coming_ms, way: Way::In, bytes, mark });
        }
    }

    /// Says what became of the last line.
    pub(super) fn mark_last(&mut self, mark: Mark) {
        if matches!(mark, Mark::Bad(_) | Mark::Strange) {
            self.bad += 1;
        }
        if let Some(line) = self.lines.back_mut().filter(|line| line.way == Way::In) {
            line.mark = mark;
        }
    }

    /// Says what became of the line that was sent last.
    pub(super) fn mark_last_sent(&mut self, mark: Mark) {
        if let Some(line) = self.lines.iter_mut().rev().find(|line| line.way == Way::Out) {
            line.mark = mark;
        }
    }

    /// Logs what was sent, line by line.
    pub(super) fn sent(&mut self, bytes: &[u8], now_ms: u64) {
        for line in bytes.split(|&byte| is_end(byte)).filter(|line| !line.is_empty()) {
            self.push(LogLine { ms: now_ms, way: Way::Out, bytes: line.into(), mark: Mark::Plain });
        }
    }

    fn push(&mut self, line: LogLine) {
        if self.lines.len() == KEPT_LINES {
            self.lines.pop_front();
            self.dropped += 1;
        }
        self.lines.push_back(line);
    }

    /// The lines, oldest first, each with its number; numbers go on when old lines are dropped.
    pub fn lines(&self) -> impl DoubleEndedIterator<Item = (u64, &LogLine)> + ExactSizeIterator {
        self.lines.iter().enumerate().map(|(index, line)| (self.dropped + index as u64, line))
    }

    /// How many lines there were in all.
    #[must_use]
    pub fn total(&self) -> u64 {
        self.dropped + self.lines.len() as u64
    }

    /// The number of the oldest line that is kept.
    #[must_use]
    pub const fn first(&self) -> u64 {
        self.dropped
    }

    /// The line with this number, while it is kept.
    #[must_use]
    pub fn line(&self, number: u64) -> Option<&LogLine> {
        self.lines.get(usize::try_from(number.checked_sub(self.dropped)?).ok()?)
    }

    /// How many of them were not used.
    #[must_use]
    pub const fn bad(&self) -> u64 {
        self.bad
    }

    /// The newest lines that match, oldest first.
    #[must_use]
    pub fn newest(&self, count: usize, show: Show, letters: &str) -> Vec<(u64, &LogLine)> {
        let mut found: Vec<_> =
            self.lines().rev().filter(|(_, line)| line.matches(show, letters)).take(count).collect();
        found.reverse();
        found
    }

    /// A line's wall-clock time, as in `14:03:28.514`.
    #[must_use]
    pub fn time(&self, line: &LogLine) -> String {
        let ms = (line.ms as i64 + self.wall_offset_ms).rem_euclid(86_400_000);
        let (s, ms) = (ms / 1000, ms % 1000);
        alloc::format!("{:02}:{:02}:{:02}.{ms:03}", s / 3600, s / 60 % 60, s % 60)
    }

    /// Everything that is kept, for a file.
    #[must_use]
    pub fn download(&self) -> String {
        let mut text = String::new();
        for line in &self.lines {
            text.push_str(&self.time(line));
            text.push_str(match line.way {
                Way::In => " < ",
                Way::Out => " > ",
            });
            text.push_str(&line.text());
            if line.mark != Mark::Plain {
                text.push_str("    ");
                text.push_str(line.mark.text());
            }
            text.push('\n');
        }
        text
    }

    /// Bytes that the lines take in memory, about.
    #[must_use]
    pub fn bytes(&self) -> usize {
        self.lines.iter().map(|line| size_of::<LogLine>() + line.bytes.len()).sum()
    }
}
