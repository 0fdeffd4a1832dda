//! The header: `key: value` lines up to the first blank one.

use alloc::string::String;
use alloc::vec::Vec;

use super::error::{ParseError, Place, Problem};
use super::field::Field;
use super::{Lines, free, list};
use crate::geometry::Point;
use crate::maze::{About, Bounds, Kind, Maze, Scale, ScaleError, Start};

/// What a header says.
pub(super) struct Header {
    pub(super) about: About,
    pub(super) kind: Kind,
    pub(super) scale: Scale,
    /// Columns of text for a cell of the drawing; its place only where it is given.
    pub(super) pitch: (Pitch, Option<Place>),
    /// The lattice point of the drawing's lower left corner.
    pub(super) origin: Option<(Point, Place)>,
    pub(super) bounds: Option<Bounds>,
    pub(super) start: Option<(Start, Place)>,
    pub(super) finish: Vec<(Point, Place)>,
}

/// Columns of text that a cell of line takes in a drawing; it takes two rows.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) struct Pitch(u8);

impl Pitch {
    /// Looks square in most fonts.
    pub(super) const WIDE: Self = Self(4);
    /// For drawings that would not fit a screen.
    pub(super) const NARROW: Self = Self(2);

    pub(super) const fn columns(self) -> usize {
        self.0 as usize
    }

    /// Bytes of a drawing, blanks at the ends of lines included.
    pub(super) const fn size(self, bounds: Bounds) -> usize {
        let (columns, rows) = (bounds.width() as usize - 1, bounds.height() as usize - 1);
        (columns * self.columns() + 2) * (rows * 2 + 1)
    }
}

impl Header {
    /// Puts start and finish of the header on a maze that may have got some from its drawing.
    pub(super) fn place_marks(&self, maze: &mut Maze) -> Result<(), ParseError> {
        let bounds = maze.bounds();
        let off = |what, at, place: Place| place.error(Problem::Off { what, at, bounds });
        if let Some((start, place)) = self.start
            && !maze.set_start(Some(start))
        {
            return Err(off("the start", start.at, place));
        }
        let mut finish = maze.finish().to_vec();
        for &(at, place) in &self.finish {
            if !bounds.contains(at) {
                return Err(off("the finish point", at, place));
            }
            finish.push(at);
        }
        maze.set_finish(finish);
        Ok(())
    }
}

const KEYS: [&str; 11] = [
    "title", "source", "note", "kind", "cell_mm", "line_mm", "columns", "origin", "bounds", "start", "finish",
];

/// Whether a line stands in a header: it gives a key a value, the first one's or another.
pub(in crate::maze) fn is_field(line: &str) -> bool {
    line.trim().split_once(':').is_some_and(|(key, _)| key == VERSION || KEYS.contains(&key))
}

/// The key of the first line.
const VERSION: &str = "line-maze";

const UNINDENTED: &str = "a line that is not indented (only title, source and note go on in the next line)";

const FIELD: &str = "“key: value” or a blank line (before the drawing)";

/// Reads the header and the blank line after it.
pub(super) fn read(lines: &mut Lines<'_>) -> Result<Header, ParseError> {
    version(lines)?;
    let mut header = Header {
        about: About::default(),
        kind: Kind::default(),
        scale: Scale::default(),
        pitch: (Pitch::WIDE, None),
        origin: None,
        bounds: None,
        start: None,
        finish: Vec::new(),
    };
    let mut sizes = Sizes { cell: None, line: None };
    let mut seen = [0_u32; KEYS.len()];
    let mut key = "";
    let mut before = *lines;
    while let Some((number, line)) = lines.next().filter(|(_, line)| !line.is_empty()) {
        if line == list::TITLE {
            *lines = before;
            break;
        }
        before = *lines;
        if line.starts_with([' ', '\t']) {
            let more = Field::new(line, number, 0);
            let value = free_text(&mut header.about, key).ok_or_else(|| more.expected(UNINDENTED))?;
            free::read(value, more.text, more.place())?;
            continue;
        }
        let name = Field::new(line, number, 0);
        let colon = line.find(':').ok_or_else(|| name.expected(FIELD))?;
        let index = KEYS.iter().position(|&key| key == &line[..colon]).ok_or_else(|| {
            name.place().error(Problem::UnknownKey(line[..colon].chars().take(24).collect()))
        })?;
        key = KEYS[index];
        let first = core::mem::replace(&mut seen[index], number);
        if first > 0 {
            return Err(name.place().error(Problem::Repeated { key, first }));
        }
        read_value(key, Field::new(line, number, colon + 1), &mut header, &mut sizes)?;
    }
    header.scale = sizes.scale()?;
    Ok(header)
}

fn version(lines: &mut Lines<'_>) -> Result<(), ParseError> {
    let line = lines.next().map_or("", |(_, line)| line);
    let first = Field::new(line, 1, 0);
    let version = line.find(':').filter(|&colon| &line[..colon] == VERSION);
    match version.map(|colon| Field::new(line, 1, colon + 1)) {
        Some(version) if version.text == "1" => Ok(()),
        Some(version) if !version.text.is_empty() => {
            Err(version.place().error(Problem::Version(version.text.chars().take(24).collect())))
        }
        _ => Err(first.expected("“line-maze: 1” (the first line of a maze file)")),
    }
}

fn read_value(key: &str, value: Field<'_>, header: &mut Header, sizes: &mut Sizes) -> Result<(), ParseError> {
    match key {
        "kind" => {
            header.kind = match value.text {
                "line" => Kind::Line,
                "wall" => Kind::Wall,
                _ => return Err(value.expected("“line” or “wall”")),
            };
        }
        "cell_mm" => sizes.cell = Some((value.millimetres()?, value.place())),
        "line_mm" => sizes.line = Some((value.millimetres()?, value.place())),
        "columns" => {
            let pitch = match value.text {
                "4" => Pitch::WIDE,
                "2" => Pitch::NARROW,
                _ => return Err(value.expected("“4” or “2” (columns of text for a cell)")),
            };
            header.pitch = (pitch, Some(value.place()));
        }
        "origin" => {
            let [point] = value.exactly("one point such as 3,4")?;
            header.origin = Some((point.point()?, value.place()));
        }
        "bounds" => {
            let [sw, ne] = value.exactly("a pair of points (south-west and north-east corner)")?;
            let bounds = Bounds::new(sw.point()?, ne.point()?);
            header.bounds = Some(bounds.map_err(|error| value.place().error(Problem::Bounds(error)))?);
        }
        "start" => {
            let [at, heading] = value.exactly("a point and a heading such as 3,4 N")?;
            let start = Start { at: at.point()?, heading: heading.heading()? };
            header.start = Some((start, value.place()));
        }
        "finish" => {
            for word in value.words() {
                header.finish.push((word.point()?, word.place()));
            }
        }
        name => {
            if let Some(text) = free_text(&mut header.about, name) {
                free::read(text, value.text, value.place())?;
            }
        }
    }
    Ok(())
}

/// The text that belongs to a key, if the key has free text.
fn free_text<'a>(about: &'a mut About, key: &str) -> Option<&'a mut String> {
    match key {
        "title" => Some(&mut about.title),
        "source" => Some(&mut about.source),
        "note" => Some(&mut about.note),
        _ => None,
    }
}

/// The sizes on the floor; they are checked together.
struct Sizes {
    cell: Option<(f64, Place)>,
    line: Option<(f64, Place)>,
}

impl Sizes {
    fn scale(&self) -> Result<Scale, ParseError> {
        let default = Scale::default();
        let cell_mm = self.cell.map_or(default.cell_mm(), |(mm, _)| mm);
        let line_mm = self.line.map_or(default.line_mm(), |(mm, _)| mm);
        Scale::new(cell_mm, line_mm).map_err(|error| {
            let place = match error {
                ScaleError::Cell => self.cell,
                ScaleError::Line => self.line.or(self.cell),
            };
            place.map_or(Place::START, |(_, place)| place).error(Problem::Scale(error))
        })
    }
}
