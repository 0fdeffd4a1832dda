//! What the floor looks like at a moment of a recorded run: where the robot is, and what it knows by place:
//! numbered points, marks on ways, numbers of squares.

use alloc::string::{String, ToString};
use alloc::vec::Vec;

use super::{Drive, NodeMark, Pose, Shown};
use crate::explorer::flood_fill::INFINITE;
use crate::explorer::mind::{Field, Mind, Plan, Robot};
use crate::explorer::node_search::Searched;
use crate::geometry::{Heading, Point};
use crate::recording::Recording;
use crate::trace::Moment;

/// The robot where a run is shown. While lines of a stop still run it faces where it came; after them, where it
/// goes on to.
#[must_use]
pub fn pose(recording: &Recording, shown: Shown) -> Pose {
    let stop = shown.moment.stop.min(recording.stops());
    if shown.along <= 0.0 || stop == recording.stops() {
        return Drive::none(recording.place(stop), faces(recording, shown.moment)).pose(0.0);
    }
    let drive = Drive {
        from: recording.place(stop),
        to: recording.place(stop + 1),
        faces: recording.step(stop).faces(),
        settles: faces(recording, Moment { stop: stop + 1, ..shown.bound }),
    };
    drive.pose(shown.along)
}

/// The drawing's heading that the robot faces at a moment.
#[must_use]
pub fn faces(recording: &Recording, moment: Moment) -> Heading {
    let step = recording.step(moment.stop);
    if moment.stop > 0 && moment.lines < step.lines() { step.heading() } else { step.faces() }
}

/// A place in the robot's own frame, in cells from the start, on the floor.
#[must_use]
pub fn on_floor(recording: &Recording, from_start: Point) -> Point {
    let start = recording.start();
    let off = from_start.out_of_frame_of(start.heading);
    Point::new(start.at.x + off.x, start.at.y + off.y)
}

/// Coordinates in milliseconds on the floor.
fn reckoned(recording: &Recording, (x, y): (i32, i32)) -> Point {
    let cell_ms = recording.cell_ms().max(1) as i32;
    let cells = |ms: i32| (ms + cell_ms / 2).div_euclid(cell_ms);
    on_floor(recording, Point::new(cells(x), cells(y)))
}

/// The places that a mind has numbered, in the order of their numbers.
#[must_use]
pub fn nodes(recording: &Recording, mind: &Mind) -> Vec<NodeMark> {
    match mind {
        Mind::Mapping(map) => (0..map.total_points())
            .map(|number| NodeMark { number, at: on_floor(recording, map.cell(number)) })
            .collect(),
        Mind::Tremaux(mind) => searched(recording, mind.memory()),
        Mind::DepthFirst(mind) => searched(recording, mind.memory()),
        Mind::Hand(_) | Mind::Sums(_) | Mind::Parex(_) | Mind::Cornell(_) | Mind::FloodFill(_) => Vec::new(),
    }
}

fn searched<N, W>(recording: &Recording, memory: &Searched<N, W>) -> Vec<NodeMark> {
    let mark = |node| NodeMark { number: node + 1, at: reckoned(recording, memory.coordinates(node)) };
    (0..memory.nodes().len() as u32).map(mark).collect()
}

/// Trémaux's marks on the floor: node, way, and how many.
#[must_use]
pub fn marks(recording: &Recording, mind: &Mind) -> Vec<(Point, Heading, u8)> {
    let Mind::Tremaux(mind) = mind else { return Vec::new() };
    let north = recording.start().heading;
    let mut marks = Vec::new();
    for (place, node) in (0u32..).zip(mind.memory().nodes()) {
        let at = reckoned(recording, mind.memory().coordinates(place));
        for way in node.ways.iter().filter(|way| node.marks[usize::from(way.index())] > 0) {
            marks.push((at, way.out_of_frame_of(north), node.marks[usize::from(way.index())]));
        }
    }
    marks
}

/// The path that a mind keeps square by square, on the floor.
#[must_use]
pub fn path(recording: &Recording, mind: &Mind) -> Vec<Point> {
    let Mind::Parex(mind) = mind else { return Vec::new() };
    match mind.plan() {
        Some(Plan::Places(places)) => places.into_iter().map(|at| on_floor(recording, at)).collect(),
        Some(Plan::Letters(_)) | None => Vec::new(),
    }
}

/// What a square explorer calls a lattice point of the floor, or the number that it has there.
#[must_use]
pub fn square_name(recording: &Recording, mind: &Mind, at: Point) -> Option<String> {
    match mind {
        Mind::Parex(mind) => Some(mind.numbering().number(recording.from_start(at)).to_string()),
        Mind::Cornell(mind) => {
            let (x, y) = square(recording, mind.squares().field(), at);
            Some(alloc::format!("{x},{y}"))
        }
        Mind::FloodFill(mind) => {
            let field = mind.squares().field();
            let (x, y) = square(recording, field, at);
            // Row by row from the north.
            let place = usize::try_from(y).ok()? * field.width as usize + usize::try_from(x).ok()?;
            let number = *mind.numbers().get(place)?;
            Some(if number == INFINITE { "∞".to_string() } else { number.to_string() })
        }
        Mind::Hand(_) | Mind::Sums(_) | Mind::Mapping(_) | Mind::Tremaux(_) | Mind::DepthFirst(_) => None,
    }
}

/// A lattice point in a field whose 0,0 is the north-west corner.
const fn square(recording: &Recording, field: Field, at: Point) -> (i32, i32) {
    let start = recording.start().at;
    let (x, y) = (field.start.x + at.x - start.x, field.start.y + at.y - start.y);
    (x, field.height as i32 - 1 - y)
}
