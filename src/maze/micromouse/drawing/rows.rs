//! Where a drawing ends: its lines, without the blanks before them.

use alloc::vec::Vec;

use super::super::error::{Expected, MicromouseError, Problem};
use super::top::{Style, Top, UNKNOWN};
use crate::maze::{BoundsError, MAX_SIDE};

/// A line of a drawing and its number.
pub(super) type Row<'t> = (u32, &'t str);

/// The lines from the top to the first that begins with neither post nor wall; an odd number of them.
pub(super) fn rows<'t>(lines: &[Row<'t>], top: &Top<'_>) -> Result<Vec<Row<'t>>, MicromouseError> {
    let mut rows: Vec<Row<'t>> = Vec::new();
    let mut end = lines.first().map_or(1, |&(line, _)| line);
    let error = |line, problem| Err(MicromouseError::text(line, top.margin() + 1, problem));
    for &(line, whole) in lines {
        end = line;
        let Some(row) = whole.strip_prefix(top.indent) else {
            let (margin, blank) = (top.margin(), whole.trim().is_empty());
            if blank || !whole.trim_start().starts_with(|c| top.is_post(c) || c == '|') {
                break;
            }
            return Err(MicromouseError::text(line, 1, Problem::Margin { columns: margin }));
        };
        let first = row.chars().next();
        let squares = rows.len() % 2 == 1;
        let other_wall = squares && is_other_wall(row, top);
        if !(other_wall || first.is_some_and(|c| top.is_post(c) || c == '|')) {
            if is_open_to_the_west(row, top) {
                return error(line, Problem::Expected { what: Expected::FirstBar, found: first });
            }
            break;
        }
        if rows.len() > 2 * MAX_SIDE as usize {
            return error(line, Problem::Bounds(BoundsError::TooLarge));
        }
        let (sound, what) = if squares {
            (other_wall || first == Some('|'), Expected::FirstBar)
        } else {
            (first.is_some_and(|c| top.is_post(c)), Expected::Post { columns: top.pitch })
        };
        if !sound {
            return error(line, Problem::Expected { what, found: first });
        }
        rows.push((line, row));
        end = line + 1;
    }
    match rows.len() {
        1 => error(end, Problem::Expected { what: Expected::SquareLine, found: None }),
        even if even % 2 == 0 => error(end, Problem::Expected { what: Expected::PostLine, found: None }),
        _ => Ok(rows),
    }
}

/// Whether a line belongs to the drawing although its first wall is missing; it would end the maze too early.
fn is_open_to_the_west(row: &str, top: &Top<'_>) -> bool {
    row.trim_end().chars().count() == top.columns() && row.starts_with(' ') && row.trim_end().ends_with('|')
}

/// Whether a line begins with another character as its wall: one of the simulator's, or an unknown wall. It is as
/// wide as the top.
fn is_other_wall(row: &str, top: &Top<'_>) -> bool {
    let wall = row.chars().next().is_some_and(|c| match top.style() {
        Style::Loose => !top.is_post(c) && !c.is_whitespace(),
        Style::Strict => !top.is_post(c) && UNKNOWN.contains(&c),
    });
    wall && row.trim_end().chars().count() == top.columns()
}
