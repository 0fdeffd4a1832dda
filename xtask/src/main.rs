//! `cargo xtask`: the project's chores, from a fresh clone to a page that may be published.

mod browser;
mod budget;
mod checks;
mod compile;
mod csp;
mod dist;
mod fetch;
mod fresh;
mod fuzz;
mod join;
mod layers;
mod offline;
mod page;
mod port;
mod serve;
mod server;
mod shell;
mod split;
mod summary;
mod tools;
mod watch;

use std::process::ExitCode;

use anyhow::{Context, Result, bail};
use lexopt::{Arg, Parser, ValueExt};

use crate::compile::Kind;
use crate::layers::Layer;
use crate::shell::Shell;

const HELP: &str = "\
The chores of Line Maze Lab. Each installs what it needs and says what it does.

  cargo xtask serve    build the lab, open it on this computer, rebuild at every saved file
      --port N         use this port; otherwise the first free one from 8080 up
      --release        build it small and fast, as it would be published (slow to build)

  cargo xtask test     run every layer of tests; the last line says how many passed and failed
      LAYER…           only these layers, for example: cargo xtask test native board
                         native   unit, property and documentation tests on this computer
                         board    the core compiles for a microcontroller without an operating system
                         fuzz     random input against everything that reads foreign bytes
                         wasm     the tests that need a browser's own functions
                         dist     the page builds, is sealed, and is small enough
                         e2e      a real browser uses the published page

  cargo xtask ci       what the project's checks run: format, lints, documentation, every layer, then fresh
  cargo xtask fresh    try the README's two commands on a clone, with nothing downloaded and nothing built
  cargo xtask page     the page as serve shows it, once, in target/page/
  cargo xtask dist     make dist/, a folder for any static web server, at any address
  cargo xtask speed    measure the page in a real browser: a step, a scrub, opening a large maze

What is downloaded or compiled the first time is kept; README.md says what that is.
";

fn main() -> ExitCode {
    match run(Parser::from_env()) {
        Ok(code) => code,
        Err(error) => {
            eprintln!("error: {error:#}");
            ExitCode::FAILURE
        }
    }
}

fn run(mut args: Parser) -> Result<ExitCode> {
    let Some(first) = args.next()? else {
        print!("{HELP}");
        return Ok(ExitCode::SUCCESS);
    };
    let chore = match first {
        Arg::Value(chore) => chore.string()?,
        Arg::Long("help") | Arg::Short('h') => "help".into(),
        other => bail!("{}; `cargo xtask` alone lists the chores", other.unexpected()),
    };
    let shell = Shell::at_workspace_root()?;
    match chore.as_str() {
        "serve" => serve::serve(&shell, &serve_options(args)?),
        "test" => layers::test(&shell, &layers::chosen(&values(args)?)?),
        "ci" => no_more(args).and_then(|()| layers::test(&shell, &Layer::ALL)),
        "fresh" => no_more(args).and_then(|()| layers::test(&shell, &[Layer::Fresh])),
        "speed" => no_more(args).and_then(|()| checks::speed(&shell)).map(|()| ExitCode::SUCCESS),
        "dist" => no_more(args).and_then(|()| dist::dist(&shell)).map(|()| ExitCode::SUCCESS),
        "help" => {
            print!("{HELP}");
            Ok(ExitCode::SUCCESS)
        }
        "page" => no_more(args).and_then(|()| serve::page(&shell)).map(|()| ExitCode::SUCCESS),
        other => bail!("there's no chore “{other}”; `cargo xtask` alone lists them"),
    }
}

fn serve_options(mut args: Parser) -> Result<serve::Options> {
    let mut options = serve::Options::default();
    while let Some(arg) = args.next()? {
        match arg {
            Arg::Long("port") => {
                let port: u16 = args.value()?.parse().context("--port wants a number from 1 to 65535")?;
                options.port = Some(port);
            }
            Arg::Long("release") => options.kind = Kind::Release,
            other => return Err(other.unexpected().into()),
        }
    }
    Ok(options)
}

fn values(mut args: Parser) -> Result<Vec<String>> {
    let mut values = Vec::new();
    while let Some(arg) = args.next()? {
        match arg {
            Arg::Value(value) => values.push(value.string()?),
            other => return Err(other.unexpected().into()),
        }
    }
    Ok(values)
}

fn no_more(mut args: Parser) -> Result<()> {
    args.next()?.map_or(Ok(()), |extra| Err(extra.unexpected().into()))
}
