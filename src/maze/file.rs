//! Any readable maze file: what it holds decides the format, not what it is called.

use alloc::format;
use alloc::string::String;
use alloc::vec::Vec;
use core::fmt;

use super::{Maze, json, micromouse, svg, text};

/// Why a file is no maze.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum ReadError {
    /// There is nothing in it.
    Empty,
    /// More than any format may have; what it is was not looked at.
    TooLarge,
    /// Not text; `at` is the first byte, from 0, that is not UTF-8.
    NotText {
        /// Offset from the file's beginning.
        at: usize,
    },
    /// It begins like JSON.
    Json(json::JsonError),
    /// It looks like a micromouse file.
    Micromouse(micromouse::MicromouseError),
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
        return Err(ReadError::TooLarge);
    }
    if let Some(maze) = micromouse::read(bytes) {
        return maze.map_err(ReadError::Micromouse);
    }
    let text = core::str::from_utf8(bytes).map_err(|error| ReadError::NotText { at: error.valid_up_to() })?;
    match TextFormat::of(text) {
        None => Err(ReadError::Empty),
        Some(TextFormat::Json) => json::parse(text).map_err(ReadError::Json),
        Some(TextFormat::Text) => text::parse(text).map_err(ReadError::Text),
    }
}

/// The text formats that are told apart by content.
enum TextFormat {
    Json,
    Text,
}

impl TextFormat {
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
            Self::TooLarge => {
                write!(f, "The file is too large: a maze file has at most {} MiB.", json::MAX_BYTES >> 20)
            }
            Self::NotText { at } => write!(
                f,
                "Byte {at}: this is not text in UTF-8. A maze file is text; save it as UTF-8, or choose another file."
            ),
            Self::Json(error) => error.fmt(f),
            Self::Micromouse(error) => error.fmt(f),
            Self::Text(error) => error.fmt(f),
        }
    }
}

impl core::error::Error for ReadError {
    fn source(&self) -> Option<&(dyn core::error::Error + 'static)> {
        match self {
            Self::Empty | Self::TooLarge | Self::NotText { .. } => None,
            Self::Json(error) => Some(error),
            Self::Micromouse(error) => Some(error),
            Self::Text(error) => Some(error),
        }
    }
}

/// A format that a maze can be written in.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Format {
    /// `.maze`, for people.
    Text,
    /// `.json`, for programs.
    Json,
    /// `.svg`, a picture in true size.
    Picture,
    /// `.txt`, `.map`, `.num` and `.maz`: walls only.
    Micromouse(micromouse::Form),
}

impl Format {
    /// All of them.
    pub const ALL: [Self; 7] = [
        Self::Text,
        Self::Json,
        Self::Picture,
        Self::Micromouse(micromouse::Form::Online),
        Self::Micromouse(micromouse::Form::Map),
        Self::Micromouse(micromouse::Form::Num),
        Self::Micromouse(micromouse::Form::Binary),
    ];

    /// What its files are called, without the dot.
    #[must_use]
    pub const fn extension(self) -> &'static str {
        match self {
            Self::Text => "maze",
            Self::Json => "json",
            Self::Picture => "svg",
            Self::Micromouse(form) => form.extension(),
        }
    }

    /// The format of files that end so; capitals are no matter.
    #[must_use]
    pub fn of_extension(extension: &str) -> Option<Self> {
        Self::ALL.into_iter().find(|format| format.extension().eq_ignore_ascii_case(extension))
    }
}

/// Writes a maze.
///
/// # Errors
/// Where the maze cannot be said in the format; only micromouse files have such limits.
pub fn write(maze: &Maze, format: Format) -> Result<Vec<u8>, micromouse::CannotSay> {
    match format {
        Format::Text => Ok(text::write(maze).into_bytes()),
        Format::Json => Ok(json::write(maze).into_bytes()),
        Format::Picture => Ok(svg::write(maze).into_bytes()),
        Format::Micromouse(form) => micromouse::write(maze, form),
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
            name.push(c.to_ascii_lowercase());
        } else if !name.ends_with('-') && !name.is_empty() {
            name.push('-');
        }
    }
    let name = name.trim_end_matches('-');
    format!("{}.{extension}", if name.is_empty() { "maze" } else { name })
}
