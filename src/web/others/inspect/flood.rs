//! Flood fill: the numbers over the walls that are known.

use std::fmt::Write;

use super::changed;
use crate::explorer::flood_fill::{FloodFill, INFINITE};
use crate::explorer::squares::wall;
use crate::geometry::{Heading, Point};

/// Larger fields are not drawn: the maze shows the numbers.
const MOST: u32 = 16;
const SIDE: usize = 44;

/// The numbers.
pub fn markup(mind: &FloodFill, before: Option<&FloodFill>, here: Point) -> String {
    let squares = mind.squares();
    let field = squares.field();
    let number = match mind.number() {
        INFINITE => "∞".to_owned(),
        number => number.to_string(),
    };
    let mut markup = format!(
        "<p>Its own number: <b class=\"{}\">{number}</b></p>",
        changed(mind.number(), before.map(FloodFill::number))
    );
    if field.width > MOST || field.height > MOST {
        return markup
            + "<p class=\"small\">The field is large; the maze shows the numbers when it is zoomed in.</p>";
    }
    let (width, height) = (field.width as usize, field.height as usize);
    let _ = write!(
        markup,
        "<svg class=\"mini grid\" viewBox=\"-4 -4 {} {}\" role=\"img\" aria-label=\"Numbers of the flood\"><rect class=\"sq-edge\" width=\"{}\" height=\"{}\"/>",
        width * SIDE + 8,
        height * SIDE + 8,
        width * SIDE,
        height * SIDE
    );
    for (place, byte) in squares.bytes().iter().enumerate() {
        let (column, row) = (place % width, place / width);
        let (x, y) = (column * SIDE, row * SIDE);
        let at = Point::new(column as i32, height as i32 - 1 - row as i32);
        if field.from_start(at) == here {
            let (x, y, side) = (x + 3, y + 3, SIDE - 6);
            let _ = write!(
                markup,
                "<rect class=\"sq-here\" x=\"{x}\" y=\"{y}\" width=\"{side}\" height=\"{side}\" rx=\"5\"/>"
            );
        }
        for heading in Heading::ALL.into_iter().filter(|&heading| byte & wall(heading) != 0) {
            let data = match heading {
                Heading::North => format!("M{x} {y}h{SIDE}"),
                Heading::East => format!("M{} {y}v{SIDE}", x + SIDE),
                Heading::South => format!("M{x} {}h{SIDE}", y + SIDE),
                Heading::West => format!("M{x} {y}v{SIDE}"),
            };
            let _ = write!(markup, "<path class=\"sq-walls thin\" d=\"{data}\"/>");
        }
        let numbers = |mind: &FloodFill| mind.numbers().get(place).copied();
        let changed = changed(numbers(mind), before.map(numbers));
        let number = match mind.numbers().get(place) {
            None | Some(&INFINITE) => "∞".to_owned(),
            Some(number) => number.to_string(),
        };
        let _ = write!(
            markup,
            "<text class=\"byte{changed}\" x=\"{}\" y=\"{}\">{number}</text>",
            x + SIDE / 2,
            y + SIDE / 2 + 5
        );
    }
    markup
        + "</svg><p class=\"small\">Walls are drawn as far as they are known; every other side counts as open.</p>"
}
