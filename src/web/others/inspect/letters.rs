//! Hands: the letters, and how three of them became one at this stop.

use std::fmt::Write;

use super::{SHOWN, changed, earlier, row};
use crate::event::Decision;
use crate::explorer::hand::Hand;
use crate::geometry::Turn;

/// The list, and the reduction of this stop if there was one.
pub fn markup(now: &Hand, before: Option<&Hand>, decision: Decision) -> String {
    let mut markup = earlier(now.path().len());
    let first = now.path().len().saturating_sub(SHOWN);
    let last = now.path().len();
    let differs = |i: usize| changed(now.path().get(i), before.map(|before| before.path().get(i)));
    let class = |i: usize| [if i + 1 == last { "now" } else { "" }, differs(i)];
    let shown = || now.path().iter().enumerate().skip(first);
    markup.push_str("<table class=\"cols path\" aria-label=\"path\">");
    row(&mut markup, "n", shown().map(|(i, _)| (class(i), i.to_string())));
    row(&mut markup, "path[n]", shown().map(|(i, turn)| (class(i), turn.letter().to_string())));
    markup.push_str("</table>");
    if now.path().is_empty() {
        markup.push_str("<p class=\"small\">No letter yet: the first node or dead end gives one.</p>");
    }
    let added = match decision {
        Decision::Go(turn) => turn,
        Decision::End(_) => return markup,
    };
    if let Some(before) = before
        && now.path().len() + 1 == before.path().len()
        && let [.., x, Turn::Back] = before.path()
        && let Some(one) = now.path().last()
    {
        let (x, y, one) = (x.letter(), added.letter(), one.letter());
        let _ = write!(
            markup,
            "<p class=\"reduced\"><del>{x} B {y}</del> becomes <ins>{one}</ins> <span class=\"small\">the sum of the three turns, modulo 360°</span></p>"
        );
    }
    markup
}
