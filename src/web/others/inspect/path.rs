//! PAReX: `Path(1..CSIP)`, and what was cut at this stop.

use std::fmt::Write;

use super::{SHOWN, changed, earlier, row};
use crate::explorer::parex::Parex;
use crate::settings::Rule;

/// The path; squares that were cut stand struck out behind it.
pub fn markup(now: &Parex, before: Option<&Parex>) -> String {
    let csip = now.csip();
    let cut: Vec<i32> = before
        .filter(|before| before.csip() >= csip)
        .map(|before| {
            let gone = before.path()[csip..].iter().copied();
            // Before the stop, the square was not yet on the path.
            gone.chain(Some(now.square()).filter(|&here| before.square() != here)).collect()
        })
        .unwrap_or_default();
    let mut markup = String::new();
    let rule = match now.rule() {
        Rule::Basic => "basic rule",
        Rule::Special1 => "special case 1",
    };
    let _ = write!(
        markup,
        "<p><code>CSIP</code> = <b class=\"{}\">{csip}</b> <span class=\"small\">· {rule} · up is {} more</span></p>",
        changed(csip, before.map(Parex::csip)),
        now.numbering().width
    );
    markup.push_str(&earlier(csip));
    let first = csip.saturating_sub(SHOWN);
    let differs = |i: usize| changed(now.path().get(i), before.map(|before| before.path().get(i)));
    let class = |i: usize| [if i + 1 == csip { "now" } else { "" }, differs(i)];
    let kept = || now.path().iter().enumerate().skip(first);
    let places = kept().map(|(i, _)| (class(i), (i + 1).to_string()));
    let gone = (0..cut.len()).map(|i| (["cut", ""], (csip + i + 1).to_string()));
    markup.push_str("<table class=\"cols path\" aria-label=\"Path\">");
    row(&mut markup, "P", places.chain(gone));
    let squares = kept().map(|(i, square)| (class(i), square.to_string()));
    row(
        &mut markup,
        "Path(P)",
        squares.chain(cut.iter().map(|square| (["cut", ""], format!("<del>{square}</del> 0")))),
    );
    markup.push_str("</table>");
    markup
}
