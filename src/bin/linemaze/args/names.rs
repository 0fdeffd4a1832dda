//! How explorers are named.

use clap::builder::{PossibleValue, PossibleValuesParser, TypedValueParser};
use line_maze_lab::explorer::name::Name;

/// The explorers' names, each with its title in the help.
pub(super) fn names() -> impl TypedValueParser<Value = Name> {
    let name = |name: &Name| PossibleValue::new(name.text()).help(name.about().title);
    PossibleValuesParser::new(Name::ALL.iter().map(name)).try_map(|text| text.parse::<Name>())
}
