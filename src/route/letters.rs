//! Turn lists as people have them: letters in either case, `F` for straight and `U` for back, with blanks, commas,
//! quotes and braces between them; words; arrows; and the lab's own JSON, CSV and C ([`super::forms`]).

use alloc::vec::Vec;
use core::fmt;

use super::turn_list::TurnList;
use crate::geometry::Turn;

mod forms;

/// Reads a turn list.
///
/// ```
/// use line_maze_lab::route::letters::read;
/// for text in ["LSRB", "l, f-R u", "{'L','S','R','B'}", "←↑→↓", "left straight right back"] {
///     assert_eq!(read(text)?.to_string(), "LSRB", "{text}");
/// }
/// assert_eq!(read("const char turns[] = \"SSR\"; // The run of the book")?.to_string(), "SSR");
/// let error = read("LSX").unwrap_err().to_string();
/// assert_eq!(error, "character 3 is “X”: write L, S or F (straight), R, or B or U (back)");
/// # Ok::<(), line_maze_lab::route::letters::Misread>(())
/// ```
///
/// # Errors
/// At the first place that means no turn, or not surely one.
pub fn read(text: &str) -> Result<TurnList, Misread> {
    let chars: Vec<char> = text.chars().collect();
    let turns = match forms::which(&chars) {
        forms::Form::Json => forms::json(text)?,
        forms::Form::Csv(cells) => plain(&chars, &cells)?,
        forms::Form::Code(statement) => plain(&chars, &statement)?,
        forms::Form::Unclear(at) => return Err(Misread::at(&chars, at, Problem::Equation)),
    };
    Ok(turns.into_iter().collect())
}

/// Where and why a text is no turn list.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Misread {
    /// The line, from 1.
    pub line: usize,
    /// The character in it, from 1.
    pub column: usize,
    /// Why.
    pub problem: Problem,
    /// Whether the text has other lines.
    several: bool,
}

/// Why a text is no turn list.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Problem {
    /// This means no turn.
    NoTurn(char),
    /// An arrow among letters: it may mean “becomes”.
    ArrowAmongLetters(char),
    /// Letters on both sides of a sign: which of them are the list?
    Equation,
    /// The text looks like JSON, and is none.
    Json,
    /// A JSON object without a list: the run left none.
    NoList,
}

impl Misread {
    fn at(chars: &[char], at: usize, problem: Problem) -> Self {
        let before = &chars[..at.min(chars.len())];
        let ends = before.iter().filter(|&&c| ends_line(c)).count();
        let line = ends - before.windows(2).filter(|two| **two == ['\r', '\n']).count() + 1;
        let column = before.iter().rev().take_while(|&&c| !ends_line(c)).count() + 1;
        let lines = chars.split(|&c| ends_line(c)).filter(|line| line.iter().any(|c| !c.is_whitespace()));
        Self { line, column, problem, several: lines.count() > 1 }
    }
}

impl fmt::Display for Problem {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::NoTurn(letter) => {
                write!(f, "“{}”: write L, S or F (straight), R, or B or U (back)", letter.escape_debug())
            }
            Self::ArrowAmongLetters(arrow) => {
                write!(f, "“{arrow}”, an arrow among letters: write letters only, or arrows only")
            }
            Self::Equation => {
                write!(f, "a sign with turns on both sides: keep one side, the list to be read")
            }
            Self::Json => write!(f, "where this stops being JSON: mend it, or give the letters alone"),
            Self::NoList => {
                write!(f, "an object without a list in “turns”: choose a run that left a route")
            }
        }
    }
}

impl fmt::Display for Misread {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        if self.several {
            write!(f, "line {}, ", self.line)?;
        }
        write!(f, "character {} is {}", self.column, self.problem)
    }
}

impl core::error::Error for Misread {}

/// Turns in these parts of a text.
fn plain(chars: &[char], parts: &[(usize, usize)]) -> Result<Vec<Turn>, Misread> {
    let mut turns = Vec::new();
    let (mut letters, mut arrow) = (false, None);
    for &(from, to) in parts {
        let mut at = from;
        while at < to {
            let (read, length) = piece(&chars[at..to]);
            match read {
                Piece::Between => {}
                Piece::Letter(turn) => {
                    letters = true;
                    turns.push(turn);
                }
                Piece::Arrow(turn) => {
                    arrow = arrow.or(Some(at));
                    turns.push(turn);
                }
                Piece::Nothing => return Err(Misread::at(chars, at, Problem::NoTurn(chars[at]))),
            }
            at += length;
        }
    }
    match arrow {
        Some(at) if letters => Err(Misread::at(chars, at, Problem::ArrowAmongLetters(chars[at]))),
        _ => Ok(turns),
    }
}

/// What a text begins with.
enum Piece {
    Between,
    Letter(Turn),
    Arrow(Turn),
    Nothing,
}

/// Words for turns; none of them can be read as letters.
const WORDS: [(&str, Turn); 9] = [
    ("left", Turn::Left),
    ("right", Turn::Right),
    ("straight", Turn::Straight),
    ("forward", Turn::Straight),
    ("front", Turn::Straight),
    ("ahead", Turn::Straight),
    ("back", Turn::Back),
    ("uturn", Turn::Back),
    ("u-turn", Turn::Back),
];

/// The first piece, and how many characters it has.
fn piece(chars: &[char]) -> (Piece, usize) {
    for (word, turn) in WORDS {
        let length = word.len();
        let same = chars.len() >= length
            && chars.iter().zip(word.chars()).all(|(c, letter)| c.to_ascii_lowercase() == letter);
        if same && !chars.get(length).is_some_and(|c| c.is_alphabetic()) {
            return (Piece::Letter(turn), length);
        }
    }
    // The end of an array of characters.
    if chars.starts_with(&['\\', '0']) {
        return (Piece::Between, 2);
    }
    let Some(&first) = chars.first() else { return (Piece::Between, 0) };
    let read = match letter(first) {
        Some(turn) => Piece::Letter(turn),
        None => match arrow(first) {
            Some(turn) => Piece::Arrow(turn),
            None if is_between(first) => Piece::Between,
            None => Piece::Nothing,
        },
    };
    (read, 1)
}

/// A turn's letter, in either case; `F` and `U` are what others call straight and back.
const fn letter(letter: char) -> Option<Turn> {
    match letter.to_ascii_uppercase() {
        'F' => Some(Turn::Straight),
        'U' => Some(Turn::Back),
        other => Turn::from_letter(other),
    }
}

const fn arrow(c: char) -> Option<Turn> {
    match c {
        '←' | '⇐' | '⬅' | '↰' => Some(Turn::Left),
        '→' | '⇒' | '➡' | '↱' => Some(Turn::Right),
        '↑' | '⇑' | '⬆' => Some(Turn::Straight),
        '↓' | '⇓' | '⬇' => Some(Turn::Back),
        _ => None,
    }
}

/// What stands between turns and means nothing.
fn is_between(c: char) -> bool {
    c.is_whitespace()
        || ",;.:|/_-–—·•'\"`´‘’‚“”„«»‹›()[]{}".contains(c)
        // Byte order mark, and how an arrow is to be drawn.
        || matches!(c, '\u{feff}' | '\u{200b}' | '\u{fe0e}' | '\u{fe0f}')
}

/// The end of a line, or half of it.
const fn ends_line(c: char) -> bool {
    matches!(c, '\n' | '\r')
}

/// Whether these characters are turns and what stands between them, with at least one turn.
fn is_turns(chars: &[char]) -> bool {
    plain(chars, &[(0, chars.len())]).is_ok_and(|turns| !turns.is_empty())
}

#[cfg(test)]
#[allow(clippy::unwrap_used)]
mod tests;
