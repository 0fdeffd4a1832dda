//! Cornell: the grid of bytes with their bits, the byte of this square spelled out, and the base station's map.

use std::fmt::Write;

use super::changed;
use crate::explorer::cornell::Cornell;
use crate::explorer::squares::{Squares, VISITED, wall};
use crate::geometry::Heading;

/// A square's side in the drawing.
const SIDE: usize = 60;
/// Larger fields are shown as the base station's map alone.
const MOST: u32 = 12;

/// The grid, the byte, and the map.
pub fn markup(mind: &Cornell, before: Option<&Cornell>) -> String {
    let squares = mind.squares();
    let field = squares.field();
    let (x, y) = mind.position();
    let here = y.max(0) as usize * field.width as usize + x.max(0) as usize;
    let mut markup = String::new();
    if field.width <= MOST && field.height <= MOST {
        markup.push_str(&grid(squares, before.map(Cornell::squares), here));
    }
    let byte = squares.bytes().get(here).copied().unwrap_or(0);
    let _ = write!(
        markup,
        "<table class=\"bits\" aria-label=\"Byte of square {x},{y}\"><tr><th>bit</th><td>4</td><td>3</td><td>2</td><td>1</td><td>0</td></tr><tr><th></th><td>visited</td><td>N</td><td>E</td><td>S</td><td>W</td></tr><tr><th>{x},{y}</th>"
    );
    for bit in (0..5).rev() {
        let on = byte >> bit & 1;
        let was = before.map(|before| before.squares().bytes().get(here).map_or(0, |byte| byte >> bit & 1));
        let _ = write!(markup, "<td class=\"on{on}{}\">{on}</td>", changed(on, was));
    }
    let walls = Heading::ALL.into_iter().filter(|&heading| byte & wall(heading) != 0).count();
    let visited = if byte & VISITED == 0 { "not visited" } else { "visited" };
    let _ = write!(
        markup,
        "</tr></table><p class=\"small\"><code>maze[{x}][{y}]</code> = <code>0x{byte:02X}</code>: {visited}, {walls} of 4 walls. The robot faces {}.</p>",
        mind.orientation().word()
    );
    if !mind.route().is_empty() {
        let (tx, ty) = mind.target();
        let _ = write!(
            markup,
            "<p class=\"small{}\">On its route to <b>{tx},{ty}</b>: {} squares are left.</p>",
            changed(mind.route(), before.map(Cornell::route)),
            mind.route().len() + 1
        );
    }
    markup.push_str(&base(squares, here));
    markup
}

/// Walls of all squares as path data.
fn walls(squares: &Squares, side: usize) -> String {
    let width = squares.field().width as usize;
    let mut data = String::new();
    for (place, byte) in squares.bytes().iter().enumerate() {
        let (x, y) = (place % width * side, place / width * side);
        for heading in Heading::ALL.into_iter().filter(|&heading| byte & wall(heading) != 0) {
            let _ = match heading {
                Heading::North => write!(data, "M{x} {y}h{side}"),
                Heading::East => write!(data, "M{} {y}v{side}", x + side),
                Heading::South => write!(data, "M{x} {}h{side}", y + side),
                Heading::West => write!(data, "M{x} {y}v{side}"),
            };
        }
    }
    data
}

/// The visited squares as path data.
fn visited(squares: &Squares, side: usize) -> String {
    let width = squares.field().width as usize;
    let mut data = String::new();
    for (place, _) in squares.bytes().iter().enumerate().filter(|(_, byte)| **byte & VISITED != 0) {
        let _ = write!(data, "M{} {}h{side}v{side}h-{side}z", place % width * side, place / width * side);
    }
    data
}

fn grid(squares: &Squares, before: Option<&Squares>, here: usize) -> String {
    let (width, height) = (squares.field().width as usize, squares.field().height as usize);
    let mut markup = format!(
        "<svg class=\"mini grid\" viewBox=\"-24 -24 {} {}\" role=\"img\" aria-label=\"The byte of every square\"><path class=\"sq-visited\" d=\"{}\"/>",
        width * SIDE + 30,
        height * SIDE + 30,
        visited(squares, SIDE)
    );
    for x in 0..width {
        let _ = write!(markup, "<text class=\"axis\" x=\"{}\" y=\"-8\">{x}</text>", x * SIDE + SIDE / 2);
    }
    for y in 0..height {
        let _ = write!(markup, "<text class=\"axis\" x=\"-13\" y=\"{}\">{y}</text>", y * SIDE + SIDE / 2 + 4);
    }
    let (w, h) = (width * SIDE, height * SIDE);
    let _ = write!(
        markup,
        "<path class=\"sq-walls\" d=\"{}\"/><rect class=\"sq-edge\" width=\"{w}\" height=\"{h}\"/>",
        walls(squares, SIDE)
    );
    for (place, byte) in squares.bytes().iter().enumerate() {
        let (x, y) = (place % width * SIDE + SIDE / 2, place / width * SIDE + 26);
        let changed = changed(Some(byte), before.map(|before| before.bytes().get(place)));
        if byte & VISITED == 0 {
            let _ = write!(markup, "<text class=\"byte un\" x=\"{x}\" y=\"{y}\">0</text>");
        } else {
            let _ = write!(
                markup,
                "<text class=\"byte{changed}\" x=\"{x}\" y=\"{y}\">1 {:04b}</text><text class=\"hex\" x=\"{x}\" y=\"{}\">{byte:02X}</text>",
                byte & 0b1111,
                y + 18
            );
        }
    }
    let (x, y) = (here % width * SIDE + 3, here / width * SIDE + 3);
    let _ = write!(
        markup,
        "<rect class=\"sq-here\" x=\"{x}\" y=\"{y}\" width=\"{0}\" height=\"{0}\" rx=\"5\"/></svg>",
        SIDE - 6
    );
    markup
}

/// What the base station has been sent.
fn base(squares: &Squares, here: usize) -> String {
    const SMALL: usize = 20;
    let (width, height) = (squares.field().width as usize, squares.field().height as usize);
    let seen = squares.bytes().iter().filter(|byte| **byte & VISITED != 0).count();
    let (x, y) = (here % width * SMALL + SMALL / 2, here / width * SMALL + SMALL / 2);
    format!(
        "<figure class=\"base\"><svg class=\"mini\" viewBox=\"-4 -4 {} {}\" role=\"img\" aria-label=\"Base station’s map\"><path class=\"sq-visited\" d=\"{}\"/><rect class=\"sq-edge\" width=\"{}\" height=\"{}\"/><path class=\"sq-walls thin\" d=\"{}\"/><circle class=\"sq-bot\" cx=\"{x}\" cy=\"{y}\" r=\"6\"/></svg><figcaption class=\"small\">The base station’s map: {seen} of {} squares were sent.</figcaption></figure>",
        width * SMALL + 8,
        height * SMALL + 8,
        visited(squares, SMALL),
        width * SMALL,
        height * SMALL,
        walls(squares, SMALL),
        width * height
    )
}
