//! Free text in a header: title, source and note. Long values go on in indented lines, joined by a space;
//! what a line cannot hold is escaped with a backslash.

use alloc::format;
use alloc::string::String;

use super::error::{ParseError, Place, Problem};

/// Characters after which a value goes on in the next line.
const WIDTH: usize = 96;

/// Adds a line to a value: joined by a space, unless the value is empty or ends with a line break.
/// `place` is that of the line's first character.
pub(super) fn read(value: &mut String, line: &str, place: Place) -> Result<(), ParseError> {
    if !value.is_empty() && !value.ends_with('\n') {
        value.push(' ');
    }
    let mut chars = line.chars().zip(place.column..);
    while let Some((char, column)) = chars.next() {
        if char == '\\' {
            let unescaped = escape(chars.by_ref().map(|(char, _)| char));
            value.push(unescaped.ok_or(Place { column, ..place }.error(Problem::Escape))?);
        } else {
            value.push(char);
        }
    }
    Ok(())
}

/// What the characters after a backslash stand for.
fn escape(mut chars: impl Iterator<Item = char>) -> Option<char> {
    match chars.next()? {
        '\\' => Some('\\'),
        'n' => Some('\n'),
        'r' => Some('\r'),
        't' => Some('\t'),
        's' => Some(' '),
        'u' if chars.next()? == '{' => {
            let mut code = 0_u32;
            for digits in 0..=6 {
                match chars.next()? {
                    '}' if digits > 0 => return char::from_u32(code),
                    digit => code = code * 16 + digit.to_digit(16)?,
                }
            }
            None
        }
        _ => None,
    }
}

/// Writes `key: value` and as many indented lines as it takes; nothing for an empty value.
pub(super) fn write(text: &mut String, key: &str, value: &str) {
    if value.is_empty() {
        return;
    }
    text.push_str(key);
    text.push(':');
    let mut column = key.chars().count() + 1;
    for (nth, paragraph) in value.split_inclusive('\n').enumerate() {
        for (nth_word, word) in words(paragraph).enumerate() {
            let word = escaped(word);
            let length = word.chars().count();
            if nth_word == 0 && nth > 0 || nth_word > 0 && column + 1 + length > WIDTH {
                text.push_str("\n ");
                column = 1;
            }
            text.push(' ');
            text.push_str(&word);
            column += 1 + length;
        }
    }
    text.push('\n');
}

/// The pieces of a paragraph between single spaces: a line may end there, and reading puts the space back.
fn words(paragraph: &str) -> impl Iterator<Item = &str> {
    let mut rest = Some(paragraph);
    core::iter::from_fn(move || {
        let (text, bytes) = (rest?, rest?.as_bytes());
        let single = |&at: &usize| bytes[at] == b' ' && bytes[at - 1] != b' ' && bytes[at + 1] != b' ';
        let end = (1..bytes.len().saturating_sub(1)).find(single);
        rest = end.map(|end| &text[end + 1..]);
        Some(&text[..end.unwrap_or(text.len())])
    })
}

/// A word as it is written; spaces at its ends or side by side would be lost otherwise.
fn escaped(word: &str) -> String {
    let mut out = String::with_capacity(word.len());
    for char in word.chars() {
        match char {
            ' ' => out.push_str("\\s"),
            '\\' => out.push_str("\\\\"),
            '\n' => out.push_str("\\n"),
            '\r' => out.push_str("\\r"),
            '\t' => out.push_str("\\t"),
            control if control.is_control() => out.push_str(&format!("\\u{{{:x}}}", u32::from(control))),
            other => out.push(other),
        }
    }
    out
}

#[cfg(test)]
#[allow(clippy::unwrap_used)]
mod tests {
    use super::*;

    fn back(text: &str) -> String {
        let mut value = String::new();
        for (nth, line) in text.lines().enumerate() {
            let line = if nth == 0 { line.split_once(':').unwrap().1 } else { line };
            read(&mut value, line.trim(), Place::START).unwrap();
        }
        value
    }

    #[test]
    fn a_long_note_goes_on_in_indented_lines_and_comes_back() {
        let note = "The robot turns right. ".repeat(9) + "\n\nA new paragraph, \\ and  two spaces ";
        let mut text = String::new();
        write(&mut text, "note", &note);
        assert!(text.lines().all(|line| line.chars().count() <= WIDTH), "{text}");
        assert!(text.lines().skip(1).all(|line| line.starts_with("  ") && !line.ends_with(' ')), "{text}");
        assert_eq!(back(&text), note);
    }

    #[test]
    fn any_text_comes_back() {
        for value in [
            "a",
            " ",
            "  ",
            " a",
            "a ",
            "\n",
            "\n\n",
            "a\n b",
            "a \nb",
            "\\",
            "\\n",
            "\u{0}\u{feff}",
            "ä\tö\r\n",
        ] {
            let mut text = String::new();
            write(&mut text, "title", value);
            assert_eq!(back(&text), value, "{text}");
        }
    }

    #[test]
    fn a_bad_escape_is_named_by_its_column() {
        let place = Place { line: 3, column: 8 };
        for (line, column) in
            [("\\x", 8), ("ab\\", 10), ("\\u{110000}", 8), ("ä\\u{}", 9), ("\\u{1234567}", 8)]
        {
            let error = read(&mut String::new(), line, place).unwrap_err();
            assert_eq!(error, Place { line: 3, column }.error(Problem::Escape), "{line}");
        }
    }
}
