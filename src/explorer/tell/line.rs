//! The line of a listing that just ran, in the middle of a stop: what the robot sees here, and what the line asked or
//! did. The case is not told before its line has run.

use super::Ran;
use crate::event::{Home, Look};
use crate::explorer::book::narrate::said::{Said, sight};
use crate::explorer::book::narrate::{Narration, Tone};

/// A line as it ran.
#[derive(Clone, Copy, Debug)]
pub struct RanLine {
    /// Its place in the listing.
    pub line: u8,
    /// How it ran.
    pub ran: Ran,
    /// What the robot saw at this stop.
    pub look: Look,
    /// The listing.
    pub listing: &'static [&'static str],
    /// Where the source tells of it.
    pub section: &'static str,
}

impl RanLine {
    /// The sentences.
    #[must_use]
    pub fn narrate(self) -> Narration {
        let place = match self.look.home {
            Home::Away => "The robot has stopped and sees ",
            Home::Back => "The robot is back at the start and sees ",
            Home::PutDown => "The robot stands at the start and sees ",
        };
        let seen = Said::default().text(place).text(sight(self.look.sighting.ways)).text(".");
        let said = self.told(seen).done();
        Narration {
            case: self.function(),
            tone: Tone::Info,
            short: said.clone(),
            said,
            section: self.section,
        }
    }

    /// The head under which the line stands: “every stop”, “explore()”.
    fn function(self) -> &'static str {
        let before = self.listing.get(..=usize::from(self.line)).unwrap_or_default();
        let head = before.iter().rev().find(|text| !text.is_empty() && !text.starts_with(' '));
        head.map_or("", |head| head.trim_end_matches(':'))
    }

    /// What the line asked or did.
    fn told(self, said: Said) -> Said {
        let Code { asks, does } =
            Code::of(self.listing.get(usize::from(self.line)).copied().unwrap_or_default());
        let said = said.text(" Line ").number(i64::from(self.line) + 1);
        match (self.ran, asks, does) {
            (Ran::Did, Some(asks), Some(does)) => {
                said.text(" asks ").code(asks).text(": it is so, and ").code(does).text(" is done.")
            }
            (Ran::Did, None, Some(does)) => said.text(" is done: ").code(does).text("."),
            (Ran::Did | Ran::Yes, Some(asks), _) => {
                said.text(" asks ").code(asks).text(": it ").strong("is").text(" so.")
            }
            (Ran::Yes, None, Some(does)) => said.text(" is next: ").code(does).text("."),
            (Ran::No, Some(asks), _) => {
                said.text(" asks ").code(asks).text(": it is ").strong("not").text(" so.")
            }
            (Ran::Nothing | Ran::No, _, Some(does)) => {
                said.text(" finds ").strong("nothing").text(": ").code(does).text(".")
            }
            (Ran::Did | Ran::Yes | Ran::No | Ran::Nothing, _, None) => said.text(" has run."),
        }
    }
}

/// A line of a listing, taken apart.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
struct Code {
    /// What it asks.
    asks: Option<&'static str>,
    /// What it does.
    does: Option<&'static str>,
}

impl Code {
    fn of(line: &'static str) -> Self {
        let code = line.split('#').next().unwrap_or_default().trim();
        // Who it is for: “2, 3: first open, …”; where the lines before have led: “else: …”.
        let version = |start: &str| start.chars().all(|c| c.is_ascii_digit() || matches!(c, ',' | ' '));
        let code = code.split_once(':').filter(|(start, _)| version(start)).map_or(code, |(_, code)| code);
        let code = code.trim().trim_start_matches("else").trim_start_matches([':', ' ']);
        let (asks, does) = match code.split_once("if ") {
            // “else if dead end: turn round”, “3: if there is none: stop”, “for P = …: if Path(P) == …:”
            Some((before, rest)) if before.is_empty() || before.ends_with([' ', ':']) => {
                let (asks, does) = rest.split_once(':').unwrap_or((rest, ""));
                (Some(asks.trim()), does)
            }
            _ => (None, code.trim_end_matches(':')),
        };
        let does = does.trim();
        Self { asks, does: (!does.is_empty()).then_some(does) }
    }
}
