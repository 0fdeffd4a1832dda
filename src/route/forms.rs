//! Turn lists for other programs and for boards: letters, JSON, CSV, and a C array for an Arduino sketch.

use alloc::format;
use alloc::string::{String, ToString};
use core::fmt::Write;

use super::turn_list::{Corners, TurnList};
use crate::geometry::Turn;

/// A form of turn list.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Form {
    /// `SSR`
    #[default]
    Letters,
    /// One object: the maze's title, whether corners are listed, and the letters.
    Json,
    /// A line a turn: its number, letter and word.
    Csv,
    /// `const char turns[] = "SSR";`
    C,
}

impl Form {
    /// All of them.
    pub const ALL: [Self; 4] = [Self::Letters, Self::Json, Self::Csv, Self::C];

    /// What its files are called, without the dot.
    #[must_use]
    pub const fn extension(self) -> &'static str {
        match self {
            Self::Letters => "txt",
            Self::Json => "json",
            Self::Csv => "csv",
            Self::C => "h",
        }
    }
}

/// Writes a turn list; `corners` says what kind of list it is, which JSON repeats.
///
/// ```
/// use line_maze_lab::route::forms::{Form, write};
/// use line_maze_lab::route::Corners;
/// let list = "SR".parse()?;
/// let csv = write(&list, Form::Csv, Corners::LeftOut, "A maze");
/// assert_eq!(csv, "number,letter,turn\n1,S,straight\n2,R,right\n");
/// let json = write(&list, Form::Json, Corners::LeftOut, "A maze");
/// assert_eq!(json, "{\"maze\":\"A maze\",\"corners\":false,\"turns\":\"SR\"}\n");
/// # Ok::<(), line_maze_lab::route::NotATurn>(())
/// ```
#[must_use]
pub fn write(list: &TurnList, form: Form, corners: Corners, title: &str) -> String {
    match form {
        Form::Letters => format!("{list}\n"),
        Form::Json => {
            let corners = match corners {
                Corners::LeftOut => false,
                Corners::Listed => true,
            };
            let title = serde_json::Value::from(title).to_string();
            format!("{{\"maze\":{title},\"corners\":{corners},\"turns\":\"{list}\"}}\n")
        }
        Form::Csv => {
            let mut text = String::from("number,letter,turn\n");
            for (number, &turn) in (1..).zip(list.turns()) {
                // Writing to a string cannot fail.
                let _ = writeln!(text, "{number},{},{}", turn.letter(), word(turn));
            }
            text
        }
        Form::C => format!("{}\n", c_array(list, title)),
    }
}

const fn word(turn: Turn) -> &'static str {
    match turn {
        Turn::Straight => "straight",
        Turn::Right => "right",
        Turn::Back => "back",
        Turn::Left => "left",
    }
}

/// A C array with the maze's title in a comment.
pub(super) fn c_array(list: &TurnList, title: &str) -> String {
    // Nothing in the comment may end the line, join it with the next, or show another order than there is.
    let title: String = title.chars().map(|c| if c.is_control() || is_format(c) { ' ' } else { c }).collect();
    // `??/` is a backslash to old compilers.
    let comment = title.trim_end_matches(|c: char| matches!(c, '\\' | '/' | '?') || c.is_whitespace());
    let array = format!("const char turns[] = \"{list}\";");
    match comment.trim_start() {
        "" => array,
        comment => format!("{array} // {comment}"),
    }
}

/// Line and paragraph separators, and characters that turn the direction of writing.
const fn is_format(c: char) -> bool {
    matches!(c, '\u{200e}' | '\u{200f}' | '\u{2028}'..='\u{202e}' | '\u{2066}'..='\u{2069}' | '\u{feff}')
}

#[cfg(test)]
#[allow(clippy::unwrap_used)]
mod tests {
    use super::*;

    #[test]
    fn nothing_in_a_title_gets_out_of_its_comment() {
        let list: TurnList = "SLB".parse().unwrap();
        let array = |title: &str| write(&list, Form::C, Corners::LeftOut, title);
        assert_eq!(array("Figure 3.1"), "const char turns[] = \"SLB\"; // Figure 3.1\n");
        assert_eq!(array("  "), "const char turns[] = \"SLB\";\n");
        assert_eq!(array("a\n#include <b>\r\\"), "const char turns[] = \"SLB\"; // a #include <b>\n");
        for title in ["end \\", "end??/", "end\\\u{2028}", "\u{202e}dne\u{2066}", "a\u{85}b", "*/ end"] {
            let array = array(title);
            assert_eq!(array.lines().count(), 1);
            let line = array.trim_end();
            assert!(!line.ends_with('\\') && !line.ends_with("??/"), "{line}");
            assert!(!line.chars().any(|c| c.is_control() || is_format(c)), "{line}");
        }
    }

    #[test]
    fn json_is_sound_whatever_the_title() {
        let list: TurnList = "RB".parse().unwrap();
        let json = write(&list, Form::Json, Corners::Listed, "“a\"\\\n");
        let value: serde_json::Value = serde_json::from_str(&json).unwrap();
        assert_eq!(value["maze"], "“a\"\\\n");
        assert_eq!((&value["corners"], &value["turns"]), (&true.into(), &"RB".into()));
    }
}
