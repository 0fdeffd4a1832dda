//! A maze as a drawing of posts and walls.

use alloc::string::String;

use super::super::Form;
use super::top::USUAL;
use crate::geometry::{Heading, Point};
use crate::maze::Maze;

/// The drawing of a maze.
pub(in crate::maze::micromouse) fn write(maze: &Maze, form: Form) -> String {
    let bounds = maze.bounds();
    let post = if form == Form::Online { 'o' } else { '+' };
    let (width, height) = (bounds.width().cast_signed(), bounds.height().cast_signed());
    let mut text = String::with_capacity((width as usize * USUAL + 2) * (height as usize * 2 + 1));
    let square = |x, y| Point::new(bounds.sw().x + x, bounds.sw().y + y);
    for y in (-1..height).rev() {
        for x in 0..width {
            text.push(post);
            text.push_str(if maze.has_line(square(x, y), Heading::North) { "   " } else { "---" });
        }
        text.push(post);
        text.push('\n');
        if y < 0 {
            break;
        }
        for x in 0..width {
            let at = square(x, y);
            text.push(if maze.has_line(at, Heading::West) { ' ' } else { '|' });
            text.push_str(match maze.start() {
                _ if form == Form::Map => "   ",
                Some(start) if start.at == at => " S ",
                _ if maze.is_finish(at) => " G ",
                _ => "   ",
            });
        }
        text.push_str("|\n");
    }
    text
}
