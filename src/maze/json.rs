//! The interchange form for programs: one JSON object, format `line-maze/1`. Keys and meaning are in
//! `docs/formats.md`.
//!
//! ```
//! use line_maze_lab::maze::json;
//! let maze = json::parse(r#"{"format": "line-maze/1", "kind": "line", "cell_mm": 200, "line_mm": 20,
//!     "start": {"at": [0, 0], "heading": "N"}, "finish": [[2, 1]],
//!     "lines": [[[0, 0], [0, 1], [2, 1]]]}"#)?;
//! assert_eq!(maze.cells(), 3);
//! assert_eq!(json::parse(&json::write(&maze))?, maze);
//! # Ok::<(), json::JsonError>(())
//! ```

mod error;
mod list;
mod model;

use alloc::format;
use alloc::string::String;
use alloc::vec::Vec;
use core::fmt::Write;

use error::value;
pub use error::{JsonError, Problem};
pub use list::{Bits, Layout, Lists, read as read_list};
use model::{Document, Pair, PointJson};

use super::polyline::{self, Segment, SegmentError};
use super::{About, Bounds, BoundsError, Kind, MAX_COORDINATE, Maze, Scale, ScaleError, Start};
use crate::geometry::Point;

/// The most bytes of a JSON maze: enough for any maze of 1,000 × 1,000 points.
pub const MAX_BYTES: usize = 32 << 20;

/// Reads a maze.
///
/// # Errors
/// Where the text is no JSON or has unknown or missing keys (line and column), or a value makes no sense
/// (its path).
pub fn parse(text: &str) -> Result<Maze, JsonError> {
    if text.len() > MAX_BYTES {
        return Err(JsonError::TooLarge { bytes: text.len() });
    }
    let text = text.strip_prefix('\u{feff}').unwrap_or(text);
    let document: Document = serde_json::from_str(text).map_err(|error| error::syntax(text, &error))?;
    if document.format != model::FORMAT {
        return Err(value("format", Problem::Format));
    }
    let scale = Scale::new(document.cell_mm.0, document.line_mm.0).map_err(|error| {
        let path = match error {
            ScaleError::Cell => "cell_mm",
            ScaleError::Line => "line_mm",
        };
        value(path, Problem::Scale(error))
    })?;
    let (bounds, segments) = lines(&document)?;
    let mut maze = Maze::new(bounds);
    polyline::lay(&mut maze, &segments);
    if let Some(start) = &document.start {
        let at = on(bounds, &start.at, || String::from("start.at"))?;
        maze.set_start(Some(Start { at, heading: start.heading.into() }));
    }
    let finish = document.finish.iter().enumerate();
    let finish: Result<Vec<Point>, _> =
        finish.map(|(nth, at)| on(bounds, at, || format!("finish[{nth}]"))).collect();
    maze.set_finish(finish?);
    maze.kind = document.kind.into();
    maze.scale = scale;
    maze.about = About { title: document.title, source: document.source, note: document.note };
    Ok(maze)
}

/// The lattice and what is drawn on it.
fn lines(document: &Document) -> Result<(Bounds, Vec<Segment>), JsonError> {
    let bounds = match &document.bounds {
        None => None,
        Some(Pair(sw, ne)) => {
            let corners =
                [point(sw, || String::from("bounds[0]"))?, point(ne, || String::from("bounds[1]"))?];
            let bounds = Bounds::new(corners[0], corners[1]);
            Some(bounds.map_err(|error| value("bounds", Problem::Bounds(error)))?)
        }
    };
    let mut segments = Vec::new();
    let mut corners: Option<Bounds> = bounds;
    for (nth, polyline) in document.lines.iter().enumerate() {
        if polyline.len() < 2 {
            return Err(value(&format!("lines[{nth}]"), Problem::Short));
        }
        let mut before = None;
        for (mth, raw) in polyline.iter().enumerate() {
            let path = || format!("lines[{nth}][{mth}]");
            let wrong = |problem| value(&path(), problem);
            let to = match bounds {
                Some(bounds) => on(bounds, raw, path)?,
                None => point(raw, path)?,
            };
            if !corners.is_some_and(|corners| corners.contains(to)) {
                let known = corners.into_iter().flat_map(|corners| [corners.sw(), corners.ne()]);
                let wider = Bounds::around(known.chain([to]));
                corners = Some(wider.map_err(|error| wrong(Problem::Bounds(error)))?);
            }
            if let Some(from) = before.replace(to) {
                segments.push(Segment::new(from, to).map_err(|error| {
                    wrong(match error {
                        SegmentError::Empty => Problem::SamePoint,
                        SegmentError::Slanted => Problem::Slanted { from, to },
                    })
                })?);
            }
        }
    }
    Ok((corners.ok_or_else(|| value("lines", Problem::NoSize))?, segments))
}

/// A point that is near enough to the origin.
fn point(raw: &PointJson, path: impl Fn() -> String) -> Result<Point, JsonError> {
    let near = |whole: i64| {
        let whole = i32::try_from(whole).ok().filter(|whole| whole.unsigned_abs() <= MAX_COORDINATE as u32);
        whole.ok_or_else(|| value(&path(), Problem::Bounds(BoundsError::TooFar)))
    };
    Ok(Point::new(near(raw.0.0)?, near(raw.1.0)?))
}

/// A point of the lattice.
fn on(bounds: Bounds, raw: &PointJson, path: impl Fn() -> String) -> Result<Point, JsonError> {
    let at = point(raw, &path)?;
    if bounds.contains(at) { Ok(at) } else { Err(value(&path(), Problem::Off { at, bounds })) }
}

/// Writes a maze: a key a line, a polyline a line.
#[must_use]
pub fn write(maze: &Maze) -> String {
    let mut text = String::from("{\n");
    // Writing to a string cannot fail.
    let _ = writeln!(text, "  \"format\": {},", model::quoted(model::FORMAT));
    for (key, value) in
        [("title", &maze.about.title), ("source", &maze.about.source), ("note", &maze.about.note)]
    {
        if !value.is_empty() {
            let _ = writeln!(text, "  \"{key}\": {},", model::quoted(value));
        }
    }
    let (cell_mm, line_mm) = (maze.scale.cell_mm(), maze.scale.line_mm());
    let kind = match maze.kind {
        Kind::Line => "line",
        Kind::Wall => "wall",
    };
    let _ = writeln!(text, "  \"kind\": \"{kind}\",\n  \"cell_mm\": {cell_mm},\n  \"line_mm\": {line_mm},");
    let bounds = maze.bounds();
    if Bounds::around(maze.joined_points().map(|(at, _)| at)) != Ok(bounds) {
        let _ = writeln!(text, "  \"bounds\": {},", points(&[bounds.sw(), bounds.ne()]));
    }
    let _ = match maze.start() {
        None => writeln!(text, "  \"start\": null,"),
        Some(Start { at, heading }) => {
            writeln!(text, "  \"start\": {{\"at\": [{}, {}], \"heading\": \"{heading}\"}},", at.x, at.y)
        }
    };
    let _ = write!(text, "  \"finish\": {},\n  \"lines\": [", points(maze.finish()));
    for (nth, polyline) in polyline::trace(maze).iter().enumerate() {
        text.push_str(if nth == 0 { "\n    " } else { ",\n    " });
        text.push_str(&points(polyline));
    }
    text.push_str(if text.ends_with('[') { "]\n}\n" } else { "\n  ]\n}\n" });
    text
}

fn points(points: &[Point]) -> String {
    let mut text = String::from("[");
    for (nth, at) in points.iter().enumerate() {
        let _ = write!(text, "{}[{}, {}]", if nth == 0 { "" } else { ", " }, at.x, at.y);
    }
    text.push(']');
    text
}
