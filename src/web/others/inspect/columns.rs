//! Full mapping: the arrays by columns as in the paper's figure 3, then the adjacency list.

use std::fmt::Write;

use super::{SHOWN, changed, earlier, row};
use crate::explorer::mapping::{Column, Mapping};

/// The arrays; at the end the adjacency list too.
pub fn markup(mind: &Mapping, before: Option<&Mapping>, over: bool) -> String {
    let visits = mind.visits();
    let mut markup = earlier(visits);
    let columns: Vec<Column> =
        (visits.saturating_sub(SHOWN)..visits).filter_map(|visit| mind.column(visit)).collect();
    let here = columns.last().map(|column| column.point);
    let last = columns.len();
    let class = |i: usize, column: &Column| match () {
        () if i + 1 == last => "now",
        () if Some(column.point) == here => "same",
        () if !mind.unexplored(column.point).is_empty() => "open",
        () => "",
    };
    let line = |markup: &mut String, name: &str, of: &dyn Fn(&Column) -> i32| {
        row(
            markup,
            name,
            columns.iter().enumerate().map(|(i, column)| {
                let was = before.map(|before| before.column(visits - last + i).as_ref().map(of));
                ([class(i, column), changed(Some(of(column)), was)], of(column).to_string())
            }),
        );
    };
    markup.push_str("<table class=\"cols\" aria-label=\"Arrays, one column a visit\">");
    line(&mut markup, "Point", &|column| column.point as i32);
    line(&mut markup, "Type", &|column| column.kind);
    line(&mut markup, "Explored", &|column| column.explored as i32);
    line(&mut markup, "CoOr_X", &|column| mind.cell(column.point).x);
    line(&mut markup, "CoOr_Y", &|column| mind.cell(column.point).y);
    markup.push_str("</table><p class=\"keys small\"><span><i class=\"now\"></i>this visit</span><span><i class=\"same\"></i>the same point before</span><span><i class=\"open\"></i>ways left</span></p>");
    let _ = write!(
        markup,
        "<p class=\"small\"><code>Total_points</code> <b class=\"{}\">{}</b>; coordinates in cells</p>",
        changed(mind.total_points(), before.map(Mapping::total_points)),
        mind.total_points()
    );
    if over {
        adjacency(&mut markup, mind);
    }
    markup
}

fn adjacency(markup: &mut String, mind: &Mapping) {
    markup.push_str("<h3>Adjacency list</h3><table class=\"adjacency\"><tbody>");
    for (point, list) in mind.adjacency_list().into_iter().enumerate().take(4 * SHOWN) {
        let list: Vec<String> = list.iter().map(ToString::to_string).collect();
        let finish = if mind.is_finish(point as u32) { " finish" } else { "" };
        let _ = write!(markup, "<tr><th scope=\"row\">{point}{finish}</th><td>{}</td></tr>", list.join(" "));
    }
    markup.push_str("</tbody></table>");
}
