//! Names in an inspector's markup lead to the explorer's glossary, as the book's do.

use std::fmt::Write;

use wasm_bindgen::JsCast;

use crate::explorer::glossary;
use crate::explorer::name::Name;

/// Around a name in the markup: heads of rows and columns, and code.
const PLACES: [(&str, &str); 3] =
    [("<th scope=\"row\">", "</th>"), ("<th scope=\"col\">", "</th>"), ("<code>", "</code>")];

/// The markup with a button for every name that the glossary has.
pub fn linked(explorer: Name, markup: &str) -> String {
    let mut out = String::with_capacity(markup.len() * 2);
    let mut rest = markup;
    while let Some((at, open, close)) = next(rest) {
        let (before, from) = rest.split_at(at + open.len());
        out.push_str(before);
        let Some((written, after)) = from.split_once(close) else {
            rest = from;
            continue;
        };
        match glossary::entry(explorer, written) {
            Some(entry) => {
                let name = entry.name;
                let _ = write!(out, "<button class=\"name\" data-name=\"{name}\">{written}</button>");
            }
            None => out.push_str(written),
        }
        out.push_str(close);
        rest = after;
    }
    out + rest
}

fn next(text: &str) -> Option<(usize, &'static str, &'static str)> {
    let places = PLACES.iter().filter_map(|&(open, close)| Some((text.find(open)?, open, close)));
    places.min_by_key(|place| place.0)
}

/// The name that was clicked.
pub fn clicked(explorer: Name, event: &web_sys::MouseEvent) -> Option<&'static str> {
    let element = event.target()?.dyn_into::<web_sys::Element>().ok()?;
    let name = element.closest("[data-name]").ok()??.get_attribute("data-name")?;
    glossary::entry(explorer, &name).map(|entry| entry.name)
}
