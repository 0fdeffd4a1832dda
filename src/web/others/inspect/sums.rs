//! Direction sums: `j` and the array `a[]`; what lies past `j` waits for its junction to be met again.

use std::fmt::Write;

use super::{SHOWN, changed, earlier, row};
use crate::explorer::sums::{Sums, turn};

/// The array.
pub fn markup(mind: &Sums, before: Option<&Sums>) -> String {
    let mut markup = earlier(mind.a().len());
    let j = mind.j();
    let first = mind.a().len().saturating_sub(SHOWN);
    let shown = || mind.a().iter().enumerate().skip(first).map(|(i, sum)| (i as i32 + 1, *sum));
    let class = move |i: i32| match i.cmp(&j) {
        std::cmp::Ordering::Less => "",
        std::cmp::Ordering::Equal => "now",
        std::cmp::Ordering::Greater => "next",
    };
    let _ = write!(
        markup,
        "<p><code>j</code> = <b class=\"{}\">{j}</b> <span class=\"small\">· 1 right, 2 front, 3 left, 0 down</span></p>",
        changed(j, before.map(Sums::j))
    );
    let sum = |mind: &Sums, i: i32| mind.a().get(i as usize - 1).copied();
    let cell = move |i: i32| [class(i), changed(sum(mind, i), before.map(|before| sum(before, i)))];
    markup.push_str("<table class=\"cols\" aria-label=\"a\">");
    row(&mut markup, "j", shown().map(|(i, _)| ([class(i), ""], i.to_string())));
    row(&mut markup, "a[j]", shown().map(|(i, sum)| (cell(i), sum.to_string())));
    row(&mut markup, "turn", shown().map(|(i, sum)| (cell(i), turn(sum).letter().to_string())));
    markup.push_str("</table>");
    if mind.a().is_empty() {
        markup.push_str("<p class=\"small\">No junction on the way here: the next one gives a[1].</p>");
    } else if mind.a().len() as i32 > j.max(0) {
        markup.push_str(
            "<p class=\"small\">Hatched: its junction is met again on the way back, and the sum goes on.</p>",
        );
    }
    markup
}
