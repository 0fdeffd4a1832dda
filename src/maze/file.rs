//! Any readable maze file: what it holds decides the format, not what it is called.

use alloc::format;
use alloc::string::{String, ToString};
use alloc::vec::Vec;
use core::fmt;

use super::text::Place;
use super::{Lines, Maze, Reading, Remark, json, micromouse, svg, text};

mod seems;

pub use seems::Seems;

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
        /// What it seems to be instead.
        seems: Option<Seems>,
    },
    /// It begins like JSON.
    Json(json::JsonError),
    /// It looks like a micromouse file.
    Micromouse(micromouse::MicromouseError),
    /// It looks like a `.maze` file.
    Text(text::ParseError),
    /// It looks like no format.
    Unknown {
        /// Where that is seen.
        place: Place,
        /// What it seems to be.
        seems: Option<Seems>,
    },
}

/// Reads a maze from a file's bytes.
///
/// ```
/// use line_maze_lab::maze::file;
/// let reading = file::read(b"My maze:\n\n  o---o---o\n  | S   G |\n  o---o---o\n")?;
/// let said: Vec<String> = reading.remarks.iter().map(ToString::to_string).collect();
/// assert_eq!(said[0], "The maze begins in line 3; what stands before it was left out.");
/// assert_eq!(said[1], "The maze is indented by 2 columns, which were left out.");
/// # Ok::<(), file::ReadError>(())
/// ```
///
/// # Errors
/// Those of the format that the file seems to have.
pub fn read(bytes: &[u8]) -> Result<Reading, ReadError> {
    // Too much is said before it is looked at.
    if bytes.len() > json::MAX_BYTES {
        return Err(ReadError::TooLarge);
    }
    if let Some(seems) = Seems::of_bytes(bytes) {
        return Err(ReadError::NotText { at: 0, seems: Some(seems) });
    }
    let text = match core::str::from_utf8(bytes) {
        Ok(text) => text.strip_prefix('\u{feff}').unwrap_or(text),
        Err(error) => {
            let not_text = || Err(ReadError::NotText { at: error.valid_up_to(), seems: None });
            return micromouse::read(bytes).map_or_else(not_text, |read| read.map_err(ReadError::Micromouse));
        }
    };
    match text.trim_start().bytes().next() {
        None => return Err(ReadError::Empty),
        Some(b'{') => {
            let maze = json::parse(text).map_err(ReadError::Json)?;
            return Ok(Reading { maze, remarks: Vec::new() });
        }
        Some(b'[') => return json::read_list(text).map_err(ReadError::Json),
        Some(_) => {}
    }
    if let Some(own) = Own::find(text) {
        return own.read().map_err(ReadError::Text);
    }
    match micromouse::read(bytes) {
        Some(Ok(reading)) => Ok(reading),
        // Both kinds of drawings may begin alike.
        Some(Err(_)) if Seems::is_lines(text) => Err(unknown(text)),
        Some(Err(error)) => Err(ReadError::Micromouse(error)),
        None => Err(unknown(text)),
    }
}

/// What is said of a text in no format: what it is by its beginning, or that its header has no first line.
fn unknown(text: &str) -> ReadError {
    let first = Lines::of(text).find(|(_, line)| !line.trim().is_empty());
    let (line, words) = first.unwrap_or((1, ""));
    if text::is_field(words)
        && let Err(error) = text::parse(text)
    {
        return ReadError::Text(error);
    }
    let blanks = words.chars().take_while(|c| c.is_whitespace()).count();
    ReadError::Unknown { place: Place { line, column: blanks as u32 + 1 }, seems: Seems::of_text(text) }
}

/// A `.maze` file in a text, perhaps further down or to the right.
struct Own<'t> {
    text: &'t str,
    /// The first line's blanks.
    indent: &'t str,
    /// Lines before it.
    before: u32,
    /// Whether something stands in them.
    has_before: bool,
}

impl<'t> Own<'t> {
    fn find(text: &'t str) -> Option<Self> {
        let mut has_before = false;
        for (line, words) in Lines::of(text) {
            let header = words.trim_start_matches([' ', '\t']);
            let found = header.starts_with(if has_before { "line-maze: " } else { "line-maze" });
            if found {
                let indent = &words[..words.len() - header.len()];
                return Some(Self { text, indent, before: line - 1, has_before });
            }
            // What is a drawing from its beginning on is one, whatever follows it.
            if !has_before && micromouse::begins(words) {
                return None;
            }
            has_before |= !words.trim().is_empty();
        }
        None
    }

    fn read(&self) -> Result<Reading, text::ParseError> {
        if self.before == 0 && self.indent.is_empty() {
            return Ok(Reading { maze: text::parse(self.text)?, remarks: Vec::new() });
        }
        let mut own = String::with_capacity(self.text.len());
        for (line, words) in Lines::of(self.text).skip(self.before as usize) {
            if line > self.before + 1 {
                own.push('\n');
            }
            let blanks = words.len() - words.trim_start_matches([' ', '\t']).len();
            // A line that begins further to the left keeps what it has.
            own.push_str(words.strip_prefix(self.indent).unwrap_or(&words[blanks..]));
        }
        let columns = self.indent.chars().count() as u32;
        let maze = text::parse(&own).map_err(|error| error.moved(self.before, columns))?;
        let line = self.before + 1;
        let before = self.has_before.then_some(Remark::Before { line });
        let indented = (columns > 0).then_some(Remark::Indented { columns, line });
        Ok(Reading { maze, remarks: before.into_iter().chain(indented).collect() })
    }
}

impl ReadError {
    /// What it says about a file in no format, without the place; else all that it says.
    #[must_use]
    pub fn what(&self) -> String {
        match self {
            Self::Unknown { seems, .. } => seems::Told(*seems).to_string(),
            Self::Empty
            | Self::TooLarge
            | Self::NotText { .. }
            | Self::Json(_)
            | Self::Micromouse(_)
            | Self::Text(_) => self.to_string(),
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
            Self::NotText { at, seems: None } => write!(
                f,
                "Byte {at}: this is not text in UTF-8. A maze file is text; save it as UTF-8, or choose another file."
            ),
            Self::NotText { at, seems: Some(seems) } => write!(f, "Byte {at}: {seems}."),
            Self::Json(error) => error.fmt(f),
            Self::Micromouse(error) => error.fmt(f),
            Self::Text(error) => error.fmt(f),
            Self::Unknown { place: Place { line, column }, seems } => {
                write!(f, "Line {line}, column {column}: {}.", seems::Told(*seems))
            }
        }
    }
}

impl core::error::Error for ReadError {
    fn source(&self) -> Option<&(dyn core::error::Error + 'static)> {
        match self {
            Self::Empty | Self::TooLarge | Self::NotText { .. } | Self::Unknown { .. } => None,
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
