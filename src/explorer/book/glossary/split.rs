//! A line of the pseudo-code in pieces: what is bold, what is a link to the glossary, and the rest.

use super::SPELLINGS;

/// A piece of a line.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Token<'a> {
    /// `if`, `else`, `for`, `return`, `not`, `true` or `false`.
    Keyword(&'a str),
    /// A name, and how the glossary writes it.
    Name(&'a str, &'static str),
    /// From `#` to the end.
    Comment(&'a str),
    /// Everything else.
    Text(&'a str),
}

impl<'a> Token<'a> {
    /// As it stands in the line.
    #[must_use]
    pub const fn text(self) -> &'a str {
        match self {
            Self::Keyword(text) | Self::Name(text, _) | Self::Comment(text) | Self::Text(text) => text,
        }
    }
}

/// Splits a line; the pieces joined are the line. A function's name counts only before its bracket: “unvisited”
/// in plain words is no link.
///
/// ```
/// use line_maze_lab::explorer::book::glossary::{Token, split};
/// let line = "if unvisited(m, ptr - 1): uturn()";
/// let names = split(line).filter_map(|token| if let Token::Name(name, _) = token { Some(name) } else { None });
/// assert!(names.eq(["unvisited", "m", "ptr", "uturn"]));
/// assert_eq!(split(line).next(), Some(Token::Keyword("if")));
/// ```
pub fn split(line: &str) -> impl Iterator<Item = Token<'_>> {
    pieces(line, of_the_book)
}

/// The same with the names of another glossary: what `known` makes of a word, given what follows it.
pub fn pieces(
    line: &str,
    known: impl Fn(&str, &str) -> Option<&'static str>,
) -> impl Iterator<Item = Token<'_>> {
    Split { rest: line, known }
}

fn of_the_book(word: &str, rest: &str) -> Option<&'static str> {
    let named = SPELLINGS.iter().find(|name| name.name == word || name.aliases.contains(&word))?;
    named.kind.stands(rest).then_some(named.name)
}

struct Split<'a, F> {
    rest: &'a str,
    known: F,
}

impl<'a, F: Fn(&str, &str) -> Option<&'static str>> Iterator for Split<'a, F> {
    type Item = Token<'a>;

    fn next(&mut self) -> Option<Token<'a>> {
        let line = self.rest;
        let mut plain = 0;
        while plain < line.len() {
            let (before, tail) = line.split_at(plain);
            let word = word(tail);
            match token(tail, word, &self.known) {
                Some(_) if plain > 0 => {
                    self.rest = tail;
                    return Some(Token::Text(before));
                }
                Some(token) => {
                    self.rest = &tail[token.text().len()..];
                    return Some(token);
                }
                None => plain += word.len().max(tail.chars().next().map_or(1, char::len_utf8)),
            }
        }
        self.rest = "";
        (!line.is_empty()).then_some(Token::Text(line))
    }
}

/// The word that a text begins with.
fn word(text: &str) -> &str {
    let end = text.find(|c: char| !c.is_ascii_alphanumeric() && c != '_');
    &text[..end.unwrap_or(text.len())]
}

/// What `tail` begins with, if it is more than plain text; `word` is its first word.
fn token<'a>(
    tail: &'a str,
    word: &'a str,
    known: impl Fn(&str, &str) -> Option<&'static str>,
) -> Option<Token<'a>> {
    if tail.starts_with('#') {
        return Some(Token::Comment(tail));
    }
    if matches!(word, "if" | "else" | "for" | "return" | "not" | "true" | "false") {
        return Some(Token::Keyword(word));
    }
    known(word, &tail[word.len()..]).map(|name| Token::Name(word, name))
}
