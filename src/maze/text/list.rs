//! Lines as a list of polylines, one a line of text: `0,0 0,5 6,5`.

use alloc::string::String;
use alloc::vec::Vec;
use core::fmt::Write;

use super::error::{ParseError, Place, Problem};
use super::field::Field;
use super::header::Header;
use super::{Lines, marks};
use crate::geometry::Point;
use crate::maze::polyline::{self, Segment, SegmentError};
use crate::maze::{Bounds, Maze};

/// The line that begins a list.
pub(super) const TITLE: &str = "lines:";

/// Reads the polylines after the title.
pub(super) fn read(lines: &mut Lines<'_>, header: &Header) -> Result<Maze, ParseError> {
    if let Some((_, place)) = header.origin {
        return Err(place.error(Problem::DrawingOnly("origin")));
    }
    if let Some(place) = header.pitch.1 {
        return Err(place.error(Problem::DrawingOnly("columns")));
    }
    let title = Place { line: lines.number(), column: 1 };
    let mut segments = Vec::new();
    let mut corners: Option<Bounds> = header.bounds;
    for (number, line) in lines {
        let polyline = Field::new(line, number, 0);
        let mut before = None;
        for word in polyline.words() {
            let at = word.point()?;
            corners = Some(inside(at, word.place(), header, corners)?);
            if let Some(from) = before {
                segments.push(Segment::new(from, at).map_err(|error| {
                    word.place().error(match error {
                        SegmentError::Empty => Problem::SamePoint,
                        SegmentError::Slanted => Problem::Slanted { from, to: at },
                    })
                })?);
            } else if polyline.text.len() == word.text.len() {
                return Err(word.place().error(Problem::OnePoint));
            }
            before = Some(at);
        }
    }
    let mut maze = Maze::new(corners.ok_or(title.error(Problem::NoSize))?);
    polyline::lay(&mut maze, &segments);
    Ok(maze)
}

/// The lattice with this point on it: it grows unless the header says how large it is.
fn inside(at: Point, place: Place, header: &Header, corners: Option<Bounds>) -> Result<Bounds, ParseError> {
    match (header.bounds, corners) {
        (Some(bounds), _) if bounds.contains(at) => Ok(bounds),
        (Some(bounds), _) => Err(place.error(Problem::Off { what: "the point", at, bounds })),
        (None, Some(corners)) if corners.contains(at) => Ok(corners),
        (None, corners) => Bounds::around(corners.into_iter().flat_map(|c| [c.sw(), c.ne()]).chain([at]))
            .map_err(|error| place.error(Problem::Bounds(error))),
    }
}

/// What the header has to say for a list.
pub(super) fn keys(maze: &Maze) -> String {
    let mut text = String::new();
    let corners = maze.joined_points().map(|(at, _)| at);
    if Bounds::around(corners) != Ok(maze.bounds()) {
        // Writing to a string cannot fail.
        let _ = writeln!(text, "bounds: {} {}", maze.bounds().sw(), maze.bounds().ne());
    }
    text + &marks(maze.start(), maze.finish())
}

/// Writes the title and the polylines.
pub(super) fn write(maze: &Maze) -> String {
    let mut text = String::from(TITLE);
    text.push('\n');
    for polyline in polyline::trace(maze) {
        for (nth, at) in polyline.iter().enumerate() {
            let _ = write!(text, "{}{at}", if nth == 0 { "" } else { " " });
        }
        text.push('\n');
    }
    text
}
