//! Trémaux: the marks on the ways of every node.

use std::fmt::Write;

use super::{SHOWN, changed, earlier};
use crate::explorer::node_search::Searched;
use crate::explorer::tremaux::Node;
use crate::geometry::Heading;

type Memory = Searched<Node, (u32, Heading)>;

/// The nodes, the newest last.
pub fn markup(mind: &Memory, before: Option<&Memory>, cell_ms: u32) -> String {
    let nodes = mind.nodes();
    if nodes.is_empty() {
        return "<p class=\"small\">No node yet: there is nothing to mark.</p>".to_owned();
    }
    let mut markup = earlier(nodes.len());
    markup.push_str(
        "<table class=\"nodes\"><thead><tr><th scope=\"col\">#</th><th scope=\"col\">x, y cells</th>",
    );
    for heading in Heading::ALL {
        let _ = write!(markup, "<th scope=\"col\">{heading}</th>");
    }
    markup.push_str("</tr></thead><tbody>");
    for (place, node) in (0u32..).zip(nodes).skip(nodes.len().saturating_sub(SHOWN)) {
        let (x, y) = mind.coordinates(place);
        let cells = |ms: i32| (f64::from(ms) / f64::from(cell_ms.max(1))).round();
        let here = if place == mind.node() { " class=\"here\" aria-current=\"true\"" } else { "" };
        let _ = write!(markup, "<tr{here}><td>{}</td><td>{}, {}</td>", place + 1, cells(x), cells(y));
        for heading in Heading::ALL {
            let count = node.marks[usize::from(heading.index())];
            let was = before.map(|before| {
                before.nodes().get(place as usize).map(|node| node.marks[usize::from(heading.index())])
            });
            let _ = match (node.ways.has(heading), count) {
                (false, _) => write!(markup, "<td>·</td>"),
                (true, count) => {
                    let changed = changed(Some(count), was);
                    let chalk = ["", "|", "||"][usize::from(count.min(2))];
                    write!(
                        markup,
                        "<td class=\"{changed}\"><b>{count}</b> <span class=\"chalked\" aria-hidden=\"true\">{chalk}</span></td>"
                    )
                }
            };
        }
        markup.push_str("</tr>");
    }
    markup.push_str("</tbody></table>");
    markup
}
