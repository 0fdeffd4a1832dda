//! What a mind tells while it decides, and the words about it: of a whole stop the template of its case, with the
//! mind's numbers; of a line before the last one what it asked or did ([`mod@line`]).
//!
//! In a template, `*…*` is what matters, `` `…` `` a name of the source, and `{…}` a fact: `{turn}` and
//! `{cells}` of the stop, all others of the mind after it.

use alloc::borrow::Cow;
use alloc::string::{String, ToString};
use alloc::vec::Vec;

use super::book::narrate::said::act;
use super::book::narrate::{Narration, Span, Tone};
use super::mind::Robot;
use crate::event::{Decision, Look, Outcome};
use crate::geometry::Turn;
use crate::playback::Mark;

pub mod line;

/// What a stop can be.
#[derive(Clone, Copy, Debug)]
pub struct Case {
    /// The explorer's own word, as the trace report prints it.
    pub name: &'static str,
    /// The same as people read it: `next way` for `next-way`.
    pub shown: &'static str,
    /// The ground on which it is shown.
    pub tone: Tone,
    /// How the scrubber marks it.
    pub mark: Mark,
    /// The template of its sentences.
    pub told: &'static str,
}

/// A name for programs with blanks for its hyphens, as the bytes of a text.
pub(super) const fn spaced<const N: usize>(name: &str) -> [u8; N] {
    let mut bytes = [b' '; N];
    let mut at = 0;
    while at < N {
        if name.as_bytes()[at] != b'-' {
            bytes[at] = name.as_bytes()[at];
        }
        at += 1;
    }
    bytes
}

/// Those bytes as the text that they are.
pub(super) const fn text(bytes: &'static [u8]) -> &'static str {
    match core::str::from_utf8(bytes) {
        Ok(text) => text,
        // Only ASCII hyphens were replaced.
        Err(_) => "",
    }
}

/// The most lines that are noted at a stop; what runs after that is not.
pub const MAX_LINES: usize = 24;

/// What a mind tells of a stop: the lines that ran, and which case it was.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Said {
    lines: [u8; MAX_LINES],
    count: u8,
    case: u8,
}

impl Said {
    /// The lines of the listing that ran, in order, from 0.
    #[must_use]
    pub fn lines(&self) -> &[u8] {
        &self.lines[..usize::from(self.count)]
    }

    /// The case's place in the explorer's table.
    #[must_use]
    pub const fn case(&self) -> u8 {
        self.case
    }

    /// The same up to a line.
    #[must_use]
    pub fn until(self, lines: u8) -> Self {
        Self { count: self.count.min(lines), ..self }
    }

    fn note(&mut self, line: u8) {
        if let Some(place) = self.lines.get_mut(usize::from(self.count)) {
            *place = line;
            self.count += 1;
        }
    }
}

/// How a line ran.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Ran {
    /// It did what it says.
    Did,
    /// What it asks holds; nothing has changed.
    Yes,
    /// What it asks does not hold; nothing has changed.
    No,
    /// It looked for something and found nothing.
    Nothing,
}

/// Hears what a mind does while it decides.
///
/// A line has run when its effect is there: a mind does what the line says, then tells it.
pub trait Tell<M> {
    /// A line of the listing ran, and this is the mind with what it did.
    fn ran(&mut self, line: u8, ran: Ran, mind: &M);

    /// It is this case; the last word counts.
    fn is(&mut self, case: u8);

    /// A line did what it says.
    fn did(&mut self, line: u8, mind: &M) {
        self.ran(line, Ran::Did, mind);
    }

    /// What a line asks holds.
    fn yes(&mut self, line: u8, mind: &M) {
        self.ran(line, Ran::Yes, mind);
    }

    /// What a line asks does not hold.
    fn no(&mut self, line: u8, mind: &M) {
        self.ran(line, Ran::No, mind);
    }

    /// A line looked for something and found nothing.
    fn none(&mut self, line: u8, mind: &M) {
        self.ran(line, Ran::Nothing, mind);
    }
}

impl<M> Tell<M> for Said {
    fn ran(&mut self, line: u8, _: Ran, _: &M) {
        self.note(line);
    }

    fn is(&mut self, case: u8) {
        self.case = case;
    }
}

/// Looks into a mind when so many of its lines have run.
#[derive(Clone, Debug)]
pub struct Watch<M> {
    lines: u8,
    said: Said,
    seen: Option<Seen<M>>,
}

/// A mind in the middle of a stop.
#[derive(Clone, Debug)]
pub struct Seen<M> {
    /// How the last line ran.
    pub ran: Ran,
    /// What it left.
    pub mind: M,
}

impl<M> Watch<M> {
    /// Waits for so many lines.
    #[must_use]
    pub fn until(lines: u8) -> Self {
        Self { lines, said: Said::default(), seen: None }
    }

    /// All that was told, and what was seen.
    #[must_use]
    pub fn done(self) -> (Said, Option<Seen<M>>) {
        (self.said, self.seen)
    }
}

impl<M: Clone> Tell<M> for Watch<M> {
    fn ran(&mut self, line: u8, ran: Ran, mind: &M) {
        self.said.note(line);
        if self.said.count == self.lines && self.seen.is_none() {
            self.seen = Some(Seen { ran, mind: mind.clone() });
        }
    }

    fn is(&mut self, case: u8) {
        self.said.case = case;
    }
}

/// A stop, as its sentences need it.
#[derive(Clone, Copy, Debug)]
pub struct Told<'a> {
    /// The case.
    pub case: &'a Case,
    /// What was seen.
    pub look: Look,
    /// What was decided.
    pub decision: Decision,
    /// Cells driven to get here.
    pub cells: u32,
    /// Where the source tells of it.
    pub section: &'static str,
}

impl Told<'_> {
    /// The sentences, with the facts of the mind after the stop.
    #[must_use]
    pub fn narrate(&self, mind: &dyn Robot) -> Narration {
        let verdict = match self.decision {
            Decision::End(outcome) => self.verdict(outcome).map(|(tone, text)| (outcome.shown(), tone, text)),
            Decision::Go(_) => None,
        };
        let mut said = Vec::new();
        let (case, tone) = match verdict {
            Some((case, tone, text)) => {
                said.push(Span::Text(text.into()));
                (case, tone)
            }
            None => {
                self.fill(self.case.told, mind, &mut said);
                (self.case.shown, self.case.tone)
            }
        };
        let short = first_sentence(&said);
        Narration { case, tone, said, short, section: self.section }
    }

    /// What the referee says, who sees more than the robot; ends that the robot knows itself are cases.
    fn verdict(&self, outcome: Outcome) -> Option<(Tone, String)> {
        let text = match outcome {
            Outcome::Finish | Outcome::NoFinishReachable | Outcome::PathFull { .. } => return None,
            Outcome::Mapped if self.case.mark == Mark::End => return None,
            Outcome::Mapped => {
                let text =
                    "The robot goes on, but it has seen every square that it can reach: all is mapped.";
                return Some((Tone::Go, text.to_string()));
            }
            Outcome::Circling { first, again } => alloc::format!(
                "The robot stands as it stood at stop {first}. Nothing in its memory could make it decide otherwise now, at stop {again}: it would circle for ever."
            ),
            Outcome::Stuck => "No way leaves the start: the robot is stuck.".to_string(),
            Outcome::TableFull { .. }
            | Outcome::NoLine { .. }
            | Outcome::TooManyStops { .. }
            | Outcome::Cut(_) => {
                alloc::format!("The run ends here, {outcome}.")
            }
        };
        Some((Tone::Bad, text))
    }

    fn fill(&self, template: &'static str, mind: &dyn Robot, said: &mut Vec<Span>) {
        let mut rest = template;
        while let Some(at) = rest.find(['*', '`', '{']) {
            let (plain, marked) = rest.split_at(at);
            if !plain.is_empty() {
                said.push(Span::Text(Cow::Borrowed(plain)));
            }
            let close = match marked.as_bytes()[0] {
                b'*' => '*',
                b'`' => '`',
                _ => '}',
            };
            // A test reads every template: nothing stays open.
            let Some((inner, after)) = marked[1..].split_once(close) else { break };
            said.push(match close {
                '*' => Span::Strong(self.facts(inner, mind)),
                '`' => Span::Code(self.facts(inner, mind)),
                _ => Span::Text(self.fact(inner, mind)),
            });
            rest = after;
        }
        if !rest.is_empty() {
            said.push(Span::Text(Cow::Borrowed(rest)));
        }
    }

    /// A marked piece, which may hold facts.
    fn facts(&self, piece: &'static str, mind: &dyn Robot) -> Cow<'static, str> {
        if !piece.contains('{') {
            return Cow::Borrowed(piece);
        }
        let mut text = String::new();
        let mut rest = piece;
        while let Some((plain, marked)) = rest.split_once('{') {
            text.push_str(plain);
            let Some((key, after)) = marked.split_once('}') else { break };
            text.push_str(&self.fact(key, mind));
            rest = after;
        }
        text.push_str(rest);
        Cow::Owned(text)
    }

    fn fact(&self, key: &'static str, mind: &dyn Robot) -> Cow<'static, str> {
        match key {
            "turn" => Cow::Borrowed(match self.decision {
                Decision::Go(turn) => act(turn),
                Decision::End(_) => "stays",
            }),
            "cells" => Cow::Owned(self.cells.to_string()),
            _ => {
                let mut text = String::new();
                mind.fact(key, &mut text);
                Cow::Owned(text)
            }
        }
    }
}

/// Up to and with the first full stop.
fn first_sentence(said: &[Span]) -> Vec<Span> {
    let mut short = Vec::new();
    for span in said {
        if let Span::Text(text) = span
            && let Some(end) = text.find(". ")
        {
            short.push(Span::Text(text[..=end].to_string().into()));
            return short;
        }
        short.push(span.clone());
    }
    short
}

/// “1 square”, “2 squares”.
pub(super) fn many(count: usize, one: &str) -> String {
    alloc::format!("{count} {one}{}", if count == 1 { "" } else { "s" })
}

/// Turns as letters, the last ones of a long list.
pub(super) fn letters(turns: &[Turn], out: &mut String) {
    tail(turns, out, |turn, out| out.push(turn.letter()));
}

/// The end of a list, with an ellipsis before it where it is long.
pub(super) fn tail<T>(list: &[T], out: &mut String, mut write: impl FnMut(&T, &mut String)) {
    const SHOWN: usize = 12;
    if list.len() > SHOWN {
        out.push_str("… ");
    }
    for (i, item) in list.iter().skip(list.len().saturating_sub(SHOWN)).enumerate() {
        if i > 0 {
            out.push(' ');
        }
        write(item, out);
    }
}
