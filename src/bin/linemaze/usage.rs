//! What is said instead of obeying: help, the version, and what is wrong with the arguments.

use std::io::{self, Write};

use clap::error::{ContextKind, ContextValue};
use line_maze_lab::brief::brief;

use crate::{Failure, Status};

/// Longer than this is no option that there is: somebody typed it.
const LONGEST: usize = 40;

/// Prints it. Help that could not be written is a failure as any output is.
pub(crate) fn tell(mut told: clap::Error) -> Result<Status, Failure> {
    if told.use_stderr() {
        shorten(&mut told);
        // If standard error is closed too, there is nobody left to tell.
        let _ = told.print();
        return Ok(Status::Unusable);
    }
    told.print()?;
    io::stdout().flush()?;
    Ok(Status::Good)
}

/// Arguments are echoed at a length that one can read.
fn shorten(told: &mut clap::Error) {
    for kind in [
        ContextKind::InvalidValue,
        ContextKind::InvalidArg,
        ContextKind::InvalidSubcommand,
        ContextKind::TrailingArg,
    ] {
        let Some(ContextValue::String(text)) = told.get(kind) else { continue };
        if text.chars().count() > LONGEST {
            let short = brief(text);
            told.insert(kind, ContextValue::String(short));
            // It would be repeated there.
            told.remove(ContextKind::Suggested);
        }
    }
}
