//! Links that hold a maze, the settings and the moment that is looked at: everything in the address, nothing
//! on a server.
//!
//! A payload is base64url without padding. Its bytes: version, length of the whole in two bytes, title, source,
//! note, kind, sizes in micrometres, bounds, start, finish, two bits a point for the lines north and east of it,
//! settings, stop, CRC-32. Version 2 adds, before the CRC-32, the explorer, PAReX's rule and longest path, and
//! the search of full mapping; where all these are as they are at first, version 1 is written, so that old
//! links stay as they are. Version 3 holds what version 2 does, and its stop is one of round 2. There is one payload for each content, and no other is accepted.

mod bytes;

use alloc::string::String;
use alloc::vec::Vec;
use core::fmt;

use base64::Engine;
use base64::engine::general_purpose::URL_SAFE_NO_PAD;
use crc::{CRC_32_ISO_HDLC, Crc, NoTable};

use crate::explorer::name::Name;
use crate::geometry::{Heading, Point};
use crate::grouped::Grouped;
use crate::maze::{Bounds, Kind, Maze, Scale, Start};
use crate::settings::{Order, Pace, Preference, Rule, Search, Settings};
use bytes::{Malformed, Reader, Writer};

/// The most characters of a payload: what browsers and messengers still pass on whole.
pub const MAX_LINK: usize = 8_000;

/// What a link holds.
#[derive(Clone, Debug, PartialEq)]
pub struct Shared {
    /// The maze with all that is written about it.
    pub maze: Maze,
    /// How the robot was set.
    pub settings: Settings,
    /// Who drives.
    pub explorer: Name,
    /// The stop that was looked at.
    pub stop: u32,
    /// Whether it is one of round 2, the drive by the turn list.
    pub solved: bool,
}

/// Why there is no link, or why a link cannot be opened.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum ShareError {
    /// The payload has, or would have, more than [`MAX_LINK`] characters.
    TooBig {
        /// How many.
        characters: usize,
    },
    /// Not the characters of a payload.
    NotALink,
    /// A payload of a later version.
    Version(u8),
    /// The end is missing.
    CutOff {
        /// Characters that are there.
        got: usize,
        /// Characters that there should be, as far as the payload can tell.
        expected: Option<usize>,
    },
    /// Characters were changed or added.
    Damaged,
}

/// The book's explorer, with the settings that it has.
const BOOK: u8 = 1;
/// Any explorer.
const ANY: u8 = 2;
/// The same in round 2.
const SOLVED: u8 = 3;
/// Version and length.
const HEAD: usize = 3;
/// The checksum.
const TAIL: usize = 4;
const CRC: Crc<u32, NoTable> = Crc::<u32, NoTable>::new(&CRC_32_ISO_HDLC);

/// Makes the payload of a link.
///
/// ```
/// use line_maze_lab::{maze::samples, settings::Settings, share};
/// use line_maze_lab::explorer::name::Name;
/// let (maze, settings) = (samples::figure_3_1(), Settings::default());
/// let shared = share::Shared { maze, settings, explorer: Name::Mapping, stop: 13, solved: false };
/// let payload = share::encode(&shared)?;
/// assert_eq!(share::decode(&payload)?, shared);
/// # Ok::<(), share::ShareError>(())
/// ```
///
/// # Errors
/// [`ShareError::TooBig`] for a maze that does not fit.
pub fn encode(shared: &Shared) -> Result<String, ShareError> {
    let mut out = Writer::default();
    let version = match shared.solved {
        true => SOLVED,
        false if has_extras(shared) => ANY,
        false => BOOK,
    };
    out.0.extend([version, 0, 0]);
    write_maze(&mut out, &shared.maze);
    write_settings(&mut out, &shared.settings);
    out.number(shared.stop);
    if version != BOOK {
        write_extras(&mut out, shared);
    }
    let length = out.0.len() + TAIL;
    let characters = characters(length);
    let length = match u16::try_from(length) {
        Ok(length) if characters <= MAX_LINK => length,
        _ => return Err(ShareError::TooBig { characters }),
    };
    out.0[1..HEAD].copy_from_slice(&length.to_be_bytes());
    let checksum = CRC.checksum(&out.0);
    out.0.extend(checksum.to_be_bytes());
    Ok(URL_SAFE_NO_PAD.encode(&out.0))
}

/// Reads the payload of a link.
///
/// # Errors
/// Where it is not exactly what [`encode`] makes; nothing is guessed.
pub fn decode(payload: &str) -> Result<Shared, ShareError> {
    let got = payload.len();
    if got > MAX_LINK {
        return Err(ShareError::TooBig { characters: got });
    }
    if !payload.bytes().all(|byte| byte.is_ascii_alphanumeric() || byte == b'-' || byte == b'_') {
        return Err(ShareError::NotALink);
    }
    let head = payload.get(..4).ok_or(ShareError::CutOff { got, expected: None })?;
    let head = URL_SAFE_NO_PAD.decode(head).map_err(|_| ShareError::NotALink)?;
    let [version, high, low] = head[..] else { return Err(ShareError::NotALink) };
    if !matches!(version, BOOK | ANY | SOLVED) {
        return Err(ShareError::Version(version));
    }
    let expected = characters(usize::from(u16::from_be_bytes([high, low])));
    if got < expected {
        return Err(ShareError::CutOff { got, expected: Some(expected) });
    }
    let bytes = URL_SAFE_NO_PAD.decode(payload).map_err(|_| ShareError::Damaged)?;
    let (body, checksum) = bytes.split_last_chunk::<TAIL>().ok_or(ShareError::Damaged)?;
    if CRC.checksum(body) != u32::from_be_bytes(*checksum) {
        return Err(ShareError::Damaged);
    }
    let shared =
        read(version, body.get(HEAD..).unwrap_or_default()).map_err(|Malformed| ShareError::Damaged)?;
    // One content, one payload: whatever else could be read as the same is refused.
    if encode(&shared).as_deref() == Ok(payload) { Ok(shared) } else { Err(ShareError::Damaged) }
}

/// Base64 characters for so many bytes.
const fn characters(bytes: usize) -> usize {
    (bytes * 4).div_ceil(3)
}

fn read(version: u8, body: &[u8]) -> Result<Shared, Malformed> {
    let mut reader = Reader(body);
    let maze = read_maze(&mut reader)?;
    let settings = read_settings(&mut reader)?;
    let stop = reader.number()?;
    let mut shared = Shared { maze, settings, explorer: Name::Book, stop, solved: version == SOLVED };
    if version != BOOK {
        read_extras(&mut reader, &mut shared)?;
    }
    if reader.0.is_empty() { Ok(shared) } else { Err(Malformed) }
}

/// Whether there is something that version 1 cannot tell.
fn has_extras(shared: &Shared) -> bool {
    let Settings { rule, path_max, search, .. } = shared.settings;
    (shared.explorer, rule, path_max, search) != (Name::Book, Rule::default(), None, Search::default())
}

/// The explorer is its place in [`Name::ALL`]: new ones come at the end.
fn write_extras(out: &mut Writer, shared: &Shared) {
    let place = (0..).zip(Name::ALL).find(|&(_, &other)| other == shared.explorer);
    out.byte(place.map_or(0, |(place, _)| place));
    out.byte(match shared.settings.rule {
        Rule::Special1 => 0,
        Rule::Basic => 1,
    });
    out.long(shared.settings.path_max.map_or(0, |squares| u64::from(squares) + 1));
    out.byte(match shared.settings.search {
        Search::Dijkstra => 0,
        Search::AStar => 1,
    });
}

fn read_extras(reader: &mut Reader<'_>, shared: &mut Shared) -> Result<(), Malformed> {
    shared.explorer = *Name::ALL.get(usize::from(reader.byte()?)).ok_or(Malformed)?;
    shared.settings.rule = match reader.byte()? {
        0 => Rule::Special1,
        1 => Rule::Basic,
        _ => return Err(Malformed),
    };
    shared.settings.path_max = reader.maybe()?;
    shared.settings.search = match reader.byte()? {
        0 => Search::Dijkstra,
        1 => Search::AStar,
        _ => return Err(Malformed),
    };
    Ok(())
}

fn write_maze(out: &mut Writer, maze: &Maze) {
    let bounds = maze.bounds();
    let relative = |out: &mut Writer, at: Point| {
        out.number(at.x.abs_diff(bounds.sw().x));
        out.number(at.y.abs_diff(bounds.sw().y));
    };
    for text in [&maze.about.title, &maze.about.source, &maze.about.note] {
        out.text(text);
    }
    out.byte(match maze.kind {
        Kind::Line => 0,
        Kind::Wall => 1,
    });
    out.number(maze.scale.cell_um());
    out.number(maze.scale.line_um());
    out.signed(bounds.sw().x);
    out.signed(bounds.sw().y);
    relative(out, bounds.ne());
    match maze.start() {
        None => out.byte(4),
        Some(start) => {
            out.byte(start.heading.index());
            relative(out, start.at);
        }
    }
    out.long(maze.finish().len() as u64);
    for &at in maze.finish() {
        relative(out, at);
    }
    let mut points = bounds.points().map(|at| maze.ways(at).bits() & 0b11);
    while let Some(first) = points.next() {
        // Absent points at the end count as points without lines.
        let mut next = || points.next().unwrap_or(0);
        let (second, third, fourth) = (next(), next(), next());
        out.byte(first | second << 2 | third << 4 | fourth << 6);
    }
}

fn read_maze(reader: &mut Reader<'_>) -> Result<Maze, Malformed> {
    let (title, source, note) = (reader.text()?, reader.text()?, reader.text()?);
    let kind = match reader.byte()? {
        0 => Kind::Line,
        1 => Kind::Wall,
        _ => return Err(Malformed),
    };
    let scale = Scale::from_um(reader.number()?, reader.number()?).map_err(|_| Malformed)?;
    let sw = Point::new(reader.signed()?, reader.signed()?);
    let relative = |reader: &mut Reader<'_>| {
        let (x, y) = (reader.number()?, reader.number()?);
        let at = |from: i32, cells| from.checked_add_unsigned(cells).ok_or(Malformed);
        Ok(Point::new(at(sw.x, x)?, at(sw.y, y)?))
    };
    let bounds = Bounds::new(sw, relative(reader)?).map_err(|_| Malformed)?;
    let start = match reader.byte()? {
        4 => None,
        heading @ 0..4 => Some(Start { heading: Heading::from_index(heading), at: relative(reader)? }),
        _ => return Err(Malformed),
    };
    let mut finish = Vec::new();
    for _ in 0..reader.long()? {
        finish.push(relative(reader)?);
    }
    let lines = reader.take(bounds.len().div_ceil(4))?;
    let mut maze = Maze::new(bounds);
    for (index, at) in bounds.points().enumerate() {
        let ways = lines[index / 4] >> (index % 4 * 2);
        for heading in [Heading::North, Heading::East] {
            if ways >> heading.index() & 1 == 1 {
                maze.draw(at, heading);
            }
        }
    }
    if !maze.set_start(start) || !maze.set_finish(finish) {
        return Err(Malformed);
    }
    maze.kind = kind;
    maze.scale = scale;
    (maze.about.title, maze.about.source, maze.about.note) = (title, source, note);
    Ok(maze)
}

/// The byte for a random order; the fixed ones are their places in [`Preference::ALL`].
const RANDOM: u8 = 6;

fn write_settings(out: &mut Writer, settings: &Settings) {
    match settings.order {
        Order::Fixed(preference) => {
            let place = (0..).zip(Preference::ALL).find(|&(_, other)| other == preference);
            out.byte(place.map_or(0, |(place, _)| place));
        }
        Order::Random(seed) => {
            out.byte(RANDOM);
            out.long(seed);
        }
    }
    out.long(settings.epsilon_ms.map_or(0, |epsilon_ms| u64::from(epsilon_ms) + 1));
    out.number(settings.node_max);
    out.byte(u8::from(settings.pace != Pace::default()));
    if settings.pace != Pace::default() {
        let Pace { speed_mm_s, turn_s, uturn_s, stop_s } = settings.pace;
        for value in [speed_mm_s, turn_s, uturn_s, stop_s] {
            out.float(value);
        }
    }
}

fn read_settings(reader: &mut Reader<'_>) -> Result<Settings, Malformed> {
    let order = match reader.byte()? {
        RANDOM => Order::Random(reader.long()?),
        place => Order::Fixed(*Preference::ALL.get(usize::from(place)).ok_or(Malformed)?),
    };
    let epsilon_ms = reader.maybe()?;
    let node_max = reader.number()?;
    let pace = match reader.byte()? {
        0 => Pace::default(),
        _ => {
            let mut time =
                || reader.float().ok().filter(|&value| value.is_finite() && value >= 0.0).ok_or(Malformed);
            Pace { speed_mm_s: time()?, turn_s: time()?, uturn_s: time()?, stop_s: time()? }
        }
    };
    Ok(Settings { order, epsilon_ms, node_max, pace, ..Settings::default() })
}

impl fmt::Display for ShareError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match *self {
            Self::TooBig { characters } => write!(
                f,
                "A link holds at most {} characters, and this one would need {}. Pass the maze on as a file instead.",
                Grouped(MAX_LINK),
                Grouped(characters)
            ),
            Self::NotALink => {
                f.write_str("This is not a link of Line Maze Lab: it has characters that none would have.")
            }
            Self::Version(version) => write!(
                f,
                "This link is of version {version}, and only versions {BOOK} to {SOLVED} can be opened. Load the \
                 page anew to get the latest."
            ),
            Self::CutOff { got, expected: Some(expected) } => write!(
                f,
                "This link breaks off after {} of {} characters. Copy all of it.",
                Grouped(got),
                Grouped(expected)
            ),
            Self::CutOff { got, expected: None } => {
                write!(f, "This link breaks off after {got} characters. Copy all of it.")
            }
            Self::Damaged => f.write_str(
                "This link is damaged: its checksum does not fit. Copy it again, or ask for it once more.",
            ),
        }
    }
}

impl core::error::Error for ShareError {}
