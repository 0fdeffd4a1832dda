//! How explorers are named, and what of them is the lab's reading of their source.

use clap::builder::{PossibleValue, PossibleValuesParser, TypedValueParser};
use line_maze_lab::explorer::name::Name;

/// The explorers' names, each with its title in the help.
pub(super) fn names() -> impl TypedValueParser<Value = Name> {
    let name = |name: &Name| {
        let about = name.about();
        PossibleValue::new(name.text()).help(format!("{}; {}", about.title, about.reading.extent.words()))
    };
    PossibleValuesParser::new(Name::ALL.iter().map(name)).try_map(|text| text.parse::<Name>())
}
