//! How explorers are named, and what of them is the lab's reading of their source.

use std::ffi::OsStr;

use clap::builder::{PossibleValue, PossibleValuesParser, TypedValueParser};
use clap::error::ErrorKind;
use clap::{Arg, Command, Error};
use line_maze_lab::explorer::name::Name;

/// The explorers' names, each with its title in the help; blanks around them and capitals are no matter.
pub(super) fn names() -> impl TypedValueParser<Value = Name> {
    let name = |name: &Name| {
        let about = name.about();
        PossibleValue::new(name.text()).help(format!("{}; {}", about.title, about.reading.extent.words()))
    };
    Names(PossibleValuesParser::new(Name::ALL.iter().map(name)))
}

#[derive(Clone)]
struct Names(PossibleValuesParser);

impl TypedValueParser for Names {
    type Value = Name;

    fn parse_ref(&self, command: &Command, arg: Option<&Arg>, value: &OsStr) -> Result<Name, Error> {
        let plain = value.to_string_lossy().trim().to_lowercase();
        if plain.is_empty() {
            let arg = arg.map_or_else(String::new, |arg| format!("{arg}: "));
            let missing =
                format!("{arg}an explorer’s name is missing; write no comma before or after the list\n");
            return Err(Error::raw(ErrorKind::ValueValidation, missing).with_cmd(command));
        }
        let text = self.0.parse_ref(command, arg, OsStr::new(&plain))?;
        text.parse().map_err(|_| Error::new(ErrorKind::InvalidValue).with_cmd(command))
    }

    fn possible_values(&self) -> Option<Box<dyn Iterator<Item = PossibleValue> + '_>> {
        self.0.possible_values()
    }
}
