//! Round 2 in words: what the bot does at each stop of its way, letter by letter.

use alloc::format;
use alloc::string::String;

use super::Route;
use crate::explorer::book::narrate::Tone;
use crate::geometry::Turn;

/// What is told of a stop of round 2.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Told {
    /// What kind of stop it is.
    pub case: &'static str,
    /// The ground on which that is shown.
    pub tone: Tone,
    /// In a sentence or two.
    pub text: String,
}

/// Tells of a stop; 0 is the start. `letters` is how many the turn list has.
#[must_use]
pub fn told(route: &Route, letters: usize, stop: u32) -> Told {
    let Some(leg) = route.leg(stop) else {
        let list = if letters == 1 { "1 letter" } else { &format!("{letters} letters") };
        let first = route.start_letter.map_or_else(String::new, |letter| {
            format!(" Letter {letter} is {}: it {}.", route.start_turn.letter(), goes(route.start_turn))
        });
        let text = format!(
            "The bot is back at the start and knows its turn list of {list}. It explores nothing now.{first}"
        );
        return Told { case: "ROUND 2", tone: Tone::Info, text };
    };
    let (case, tone, text) = match (leg.turn, leg.letter) {
        (None, _) => ("FINISH", Tone::Go, arrived(route)),
        (Some(turn), Some(letter)) => {
            let text =
                format!("Letter {letter} of {letters} is {}, so the bot {}.", turn.letter(), goes(turn));
            ("TURN LIST", Tone::Now, text)
        }
        (Some(Turn::Straight), None) => {
            ("STRAIGHT", Tone::Info, String::from("Nothing is to be decided here: the bot goes straight on."))
        }
        (Some(turn), None) => {
            ("CORNER", Tone::Info, format!("A corner needs no letter: the bot {}.", goes(turn)))
        }
    };
    Told { case, tone, text }
}

fn arrived(route: &Route) -> String {
    let tally = route.tally();
    let cells = if tally.cells == 1 { "1 cell" } else { &format!("{} cells", tally.cells) };
    match tally.u_turns {
        0 => format!("There: {cells}, and no U-turn."),
        1 => format!("There: {cells}, with a U-turn."),
        many => format!("There: {cells}, with {many} U-turns."),
    }
}

const fn goes(turn: Turn) -> &'static str {
    match turn {
        Turn::Straight => "goes straight on",
        Turn::Right => "turns right",
        Turn::Left => "turns left",
        Turn::Back => "turns round",
    }
}
