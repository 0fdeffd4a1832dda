//! Depth first: the stack of nodes from the start to here, and the used ways of every node.

use std::fmt::Write;

use super::{SHOWN, changed, earlier};
use crate::explorer::depth_first::Node;
use crate::explorer::node_search::Searched;
use crate::geometry::{Heading, Ways};

type Memory = Searched<Node, u32>;

/// Stack and nodes.
pub fn markup(mind: &Memory, before: Option<&Memory>, cell_ms: u32) -> String {
    let nodes = mind.nodes();
    if nodes.is_empty() {
        return "<p class=\"small\">No node yet: the stack is empty.</p>".to_owned();
    }
    let way = mind.way();
    let stack: Vec<String> =
        way.iter().skip(way.len().saturating_sub(SHOWN)).map(|node| (node + 1).to_string()).collect();
    let mut markup = format!(
        "<p>Stack: <span class=\"mono{}\">{}</span></p>",
        changed(way, before.map(Memory::way)),
        stack.join(" → ")
    );
    markup.push_str(&earlier(nodes.len()));
    markup.push_str("<table class=\"nodes\"><thead><tr><th scope=\"col\">#</th><th scope=\"col\">x, y cells</th><th scope=\"col\">ways</th><th scope=\"col\">first entry</th></tr></thead><tbody>");
    for (place, node) in (0u32..).zip(nodes).skip(nodes.len().saturating_sub(SHOWN)) {
        let (x, y) = mind.coordinates(place);
        let cells = |ms: i32| (f64::from(ms) / f64::from(cell_ms.max(1))).round();
        let before = before.map(|before| before.nodes().get(place as usize));
        let was = |of: fn(&Node) -> Ways| before.map(|node| node.map(of));
        let here = if place == mind.node() { " class=\"here\" aria-current=\"true\"" } else { "" };
        let _ = write!(
            markup,
            "<tr{here}><td>{}</td><td>{}, {}</td><td class=\"{}\">",
            place + 1,
            cells(x),
            cells(y),
            changed(Some(node.used), was(|node| node.used))
        );
        for heading in Heading::ALL {
            let word = heading.word();
            let _ = match (node.ways.has(heading), node.used.has(heading)) {
                (false, _) => write!(markup, "<span class=\"d no\" title=\"{word}: no path\">·</span>"),
                (true, false) => {
                    write!(markup, "<span class=\"d on\" title=\"{word}: unused\">{heading}</span>")
                }
                (true, true) => {
                    write!(markup, "<span class=\"d seen\" title=\"{word}: used\">{heading}</span>")
                }
            };
        }
        let entry = node.entry.map_or("–", Heading::word);
        let _ = write!(markup, "</td><td>{entry}</td></tr>");
    }
    markup.push_str("</tbody></table>");
    markup
}
