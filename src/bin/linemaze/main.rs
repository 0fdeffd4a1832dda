//! The command line: run, trace, compare, check, generate and convert line mazes, print their turn lists, hold a
//! league over many; be a robot, or check one.

mod args;
mod check;
mod compare;
mod convert;
mod count;
mod explore;
mod files;
mod folders;
mod league;
mod link_check;
mod locate;
#[cfg(unix)]
mod lock;
mod progress;
#[cfg(unix)]
mod pty;
mod robot;
#[cfg(unix)]
mod signals;
mod table;
mod turns;
mod usage;

use std::io::{self, BufWriter, Write};
use std::path::Path;
use std::process::ExitCode;

use args::{Cli, Command};
use clap::Parser;

/// What a command comes to; the number is the exit status.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Status {
    /// Finish reached, maze clean, file written.
    Good = 0,
    /// No finish, or findings.
    Bad = 1,
    /// The input or the arguments make no sense.
    Unusable = 2,
}

/// Why a command could not be carried out.
enum Failure {
    /// For the person at the keyboard.
    Message(String),
    /// Standard output went away; nobody reads any more.
    Output(io::Error),
}

impl Failure {
    /// What went wrong with a file.
    fn at(path: &Path, error: &io::Error) -> Self {
        Self::Message(format!("{}: {}", files::name(path), why(error)))
    }
}

/// What the system says, without its number for it.
fn why(error: &io::Error) -> String {
    let text = error.to_string();
    text.split_once(" (os error").map_or(text.as_str(), |(text, _)| text).to_owned()
}

impl From<io::Error> for Failure {
    fn from(error: io::Error) -> Self {
        Self::Output(error)
    }
}

fn main() -> ExitCode {
    let done = match Cli::try_parse() {
        Ok(cli) => {
            let mut out = BufWriter::new(io::stdout().lock());
            obey(&cli.command, &mut out).and_then(|status| {
                out.flush()?;
                Ok(status)
            })
        }
        Err(told) => usage::tell(told),
    };
    let status = match done {
        Ok(status) => status,
        // `linemaze … | head` is no fault.
        Err(Failure::Output(error)) if error.kind() == io::ErrorKind::BrokenPipe => Status::Good,
        Err(Failure::Output(error)) => complain(&format!("standard output: {}", why(&error))),
        Err(Failure::Message(message)) => complain(&message),
    };
    ExitCode::from(status as u8)
}

fn obey(command: &Command, out: &mut impl Write) -> Result<Status, Failure> {
    match command {
        Command::Run(args) => explore::run(args, out),
        Command::Trace(args) => explore::trace(args, out),
        Command::Turns(args) => turns::turns(args, out),
        Command::Compare(args) => compare::compare(args, out),
        Command::League(args) => league::league(args, out),
        Command::Check(args) => check::check(args, out),
        Command::Generate(args) => files::generate(args, out),
        Command::Convert(args) => convert::convert(args, out),
        Command::Robot(args) => robot::robot(args, out),
        Command::LinkCheck(args) => link_check::link_check(args, out),
    }
}

fn complain(message: &str) -> Status {
    // If standard error is closed too, there is nobody left to tell.
    let _ = writeln!(io::stderr(), "{message}");
    Status::Unusable
}
