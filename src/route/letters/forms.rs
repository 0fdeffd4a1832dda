//! Where in a text the turns are: in a JSON object, in a column of CSV, in a line of C, or all over it.

use alloc::string::String;
use alloc::vec::Vec;

use serde_json::Value;

use super::{Misread, Problem, ends_line, is_turns, plain};
use crate::geometry::Turn;

/// What a text is.
pub(super) enum Form {
    /// A JSON object with `"turns"`.
    Json,
    /// A table with a column `letter`: these are its cells.
    Csv(Vec<(usize, usize)>),
    /// Code, or letters alone: these parts hold the turns.
    Code(Vec<(usize, usize)>),
    /// The sign here has turns on both sides.
    Unclear(usize),
}

/// Finds out.
pub(super) fn which(chars: &[char]) -> Form {
    let first = chars.iter().find(|c| !c.is_whitespace() && **c != '\u{feff}');
    if first == Some(&'{') && contains(chars, "\"turns\"") {
        return Form::Json;
    }
    if let Some(cells) = letter_column(chars) {
        return Form::Csv(cells);
    }
    let code = uncommented(chars);
    match statement(&code) {
        Ok(statement) => {
            // Comments are left out.
            let mut parts = Vec::new();
            for at in statement.0..statement.1 {
                match parts.last_mut() {
                    _ if code[at] != chars[at] => {}
                    Some((_, to)) if *to == at => *to += 1,
                    _ => parts.push((at, at + 1)),
                }
            }
            Form::Code(parts)
        }
        Err(at) => Form::Unclear(at),
    }
}

fn contains(chars: &[char], text: &str) -> bool {
    let text: Vec<char> = text.chars().collect();
    chars.windows(text.len()).any(|part| part == text)
}

/// The turns of an object.
pub(super) fn json(text: &str) -> Result<Vec<Turn>, Misread> {
    let chars: Vec<char> = text.chars().collect();
    let object: Value = serde_json::from_str(text.trim_start_matches('\u{feff}')).map_err(|error| {
        Misread { line: error.line(), column: error.column().max(1), ..Misread::at(&chars, 0, Problem::Json) }
    })?;
    let key: Vec<char> = "\"turns\"".chars().collect();
    let at = chars.windows(key.len()).position(|part| part == key).unwrap_or(0);
    let Some(turns) = object.get("turns").and_then(Value::as_str) else {
        return Err(Misread::at(&chars, at, Problem::NoList));
    };
    let turns: Vec<char> = turns.chars().collect();
    plain(&turns, &[(0, turns.len())]).map_err(|wrong| {
        // The list is the text after the key, as letters need no escapes.
        let from =
            chars[at + key.len()..].iter().position(|&c| c == '"').map_or(at, |quote| at + key.len() + quote);
        Misread::at(&chars, from + wrong.column, wrong.problem)
    })
}

/// The cells of the column `letter`, below a head that names it.
fn letter_column(chars: &[char]) -> Option<Vec<(usize, usize)>> {
    let mut rows = lines(chars).filter(|&(from, to)| chars[from..to].iter().any(|c| !c.is_whitespace()));
    let head = rows.next()?;
    let column = cells(chars, head).iter().position(|&(from, to)| {
        let name: String = chars[from..to].iter().collect();
        let bare = |c: char| c.is_whitespace() || matches!(c, '"' | '\u{feff}');
        name.trim_matches(bare).eq_ignore_ascii_case("letter")
    })?;
    Some(rows.filter_map(|row| cells(chars, row).get(column).copied()).collect())
}

fn lines(chars: &[char]) -> impl Iterator<Item = (usize, usize)> {
    let mut at = 0;
    chars.split(|&c| ends_line(c)).map(move |line| {
        let from = at;
        at += line.len() + 1;
        (from, from + line.len())
    })
}

fn cells(chars: &[char], (from, to): (usize, usize)) -> Vec<(usize, usize)> {
    let mut at = from;
    let cell = |cell: &[char]| {
        let begin = at;
        at += cell.len() + 1;
        (begin, begin + cell.len())
    };
    chars[from..to].split(|&c| matches!(c, ',' | ';' | '\t')).map(cell).collect()
}

/// The text with blanks in place of C’s comments.
fn uncommented(chars: &[char]) -> Vec<char> {
    let mut code = chars.to_vec();
    let (mut at, mut quoted) = (0, false);
    while at < chars.len() {
        let rest = &chars[at..];
        let length = match rest {
            ['/', '/', ..] if !quoted => rest.iter().take_while(|&&c| !ends_line(c)).count(),
            ['/', '*', ..] if !quoted => {
                rest.windows(2).skip(2).position(|end| end == ['*', '/']).map_or(rest.len(), |end| end + 4)
            }
            ['"', ..] => {
                quoted = !quoted;
                0
            }
            _ => 0,
        };
        code[at..at + length].iter_mut().filter(|c| !ends_line(**c)).for_each(|c| *c = ' ');
        at += length.max(1);
    }
    code
}

/// Where the turns of code stand: to the right of an `=`, up to a `;`. Without one, everywhere.
fn statement(code: &[char]) -> Result<(usize, usize), usize> {
    let mut found: Option<(usize, usize, bool)> = None;
    let mut from = 0;
    for statement in code.split(|&c| c == ';') {
        let to = from + statement.len();
        if let Some(sign) = statement.iter().position(|&c| c == '=') {
            let (left, right) = (&statement[..sign], &statement[sign + 1..]);
            if is_turns(left) {
                return Err(from + sign);
            }
            let is_text = right.iter().any(|c| matches!(c, '"' | '\'' | '{' | '['));
            // An array or text rather than a number.
            if found.is_none_or(|(_, _, text)| !text && is_text) {
                found = Some((from + sign + 1, to, is_text));
            }
        }
        from = to + 1;
    }
    Ok(found.map_or((0, code.len()), |(from, to, _)| (from, to)))
}
