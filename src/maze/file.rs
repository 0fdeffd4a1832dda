//! Any readable maze file: what it holds decides the format, not what it is called.

use alloc::format;
use alloc::string::String;
use core::fmt;

use super::{Maze, json, text};

/// Why a file is no maze.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum ReadError {
    /// There is nothing in it.
    Empty,
    /// Not text; `at` is the first byte, from 0, that is not UTF-8.
    NotText {
        /// Offset from the file's beginning.
        at: usize,
    },
    /// It begins like JSON.
    Json(json::JsonError),
    /// It is none of the other formats, so it should be a `.maze` file.
    Text(text::ParseError),
}

/// Reads a maze from a file's bytes.
///
/// # Errors
/// Those of the format that the file seems to have.
pub fn read(bytes: &[u8]) -> Result<Maze, ReadError> {
    // Too much is said before it is looked at.
    if bytes.len() > json::MAX_BYTES {
        return Err(ReadError::Json(json::JsonError::TooLarge { bytes: bytes.len() }));
    }
    let text = core::str::from_utf8(bytes).map_err(|error| ReadError::NotText { at: error.valid_up_to() })?;
    match Format::of(text) {
        None => Err(ReadError::Empty),
        Some(Format::Json) => json::parse(text).map_err(ReadError::Json),
        Some(Format::Text) => text::parse(text).map_err(ReadError::Text),
    }
}

/// The formats that are told apart by content.
enum Format {
    Json,
    Text,
}

impl Format {
    fn of(text: &str) -> Option<Self> {
        let text = text.strip_prefix('\u{feff}').unwrap_or(text).trim_start();
        match text.bytes().next()? {
            b'{' => Some(Self::Json),
            _ => Some(Self::Text),
        }
    }
}

impl fmt::Display for ReadError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Empty => f.write_str("The file is empty; a maze file begins with “line-maze: 1”."),
            Self::NotText { at } => write!(
                f,
                "Byte {at}: this is not text in UTF-8. A maze file is text; save it as UTF-8, or choose another file."
            ),
            Self::Json(error) => error.fmt(f),
            Self::Text(error) => error.fmt(f),
        }
    }
}

impl core::error::Error for ReadError {
    fn source(&self) -> Option<&(dyn core::error::Error + 'static)> {
        match self {
            Self::Empty | Self::NotText { .. } => None,
            Self::Json(error) => Some(error),
            Self::Text(error) => Some(error),
        }
    }
}

/// A name for a maze's file: its title in characters that every file system takes.
///
/// ```
/// use line_maze_lab::maze::{file, samples};
/// assert_eq!(file::name(&samples::figure_3_1(), "maze"), "the-run-of-the-book.maze");
/// ```
#[must_use]
pub fn name(maze: &Maze, extension: &str) -> String {
    let mut name = String::new();
    for c in maze.about.title.chars().take(60) {
        if c.is_alphanumeric() {
            name.extend(c.to_lowercase());
        } else if !name.ends_with('-') && !name.is_empty() {
            name.push('-');
        }
    }
    let name = name.trim_end_matches('-');
    format!("{}.{extension}", if name.is_empty() { "maze" } else { name })
}
