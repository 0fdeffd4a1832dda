//! `cargo xtask serve`: the lab on this computer, built anew at every saved file.

use std::collections::BTreeSet;
use std::fs;
use std::path::{Path, PathBuf};
use std::process::ExitCode;
use std::sync::Arc;
use std::time::{Instant, SystemTime};

use anyhow::{Context, Result};

use crate::compile::{self, Kind, NotBuilt};
use crate::join::{Exports, Program, join};
use crate::page::{Naming, Page};
use crate::port;
use crate::server::{self, Desk};
use crate::shell::Shell;
use crate::tools::{self, WASM, say};
use crate::watch::{Change, Watch};

/// What a person chose on the command line.
#[derive(Debug, Default)]
pub(crate) struct Options {
    pub(crate) port: Option<u16>,
    pub(crate) kind: Kind,
}

/// Serves until the process is ended; comes back only with an error.
pub(crate) fn serve(shell: &Shell, options: &Options) -> Result<ExitCode> {
    // Taken before the long work: who opens it early waits, and sees the page as soon as it is there.
    let listener = port::take(options.port)?;
    let port = listener.local_addr()?.port();
    tools::target(shell, WASM)?;
    let watch = Watch::begin(shell)?;
    say("Building the lab (two minutes the first time, later some seconds); its address follows");
    let (mut bench, page) = Bench::start(shell, options.kind)?;
    let desk = Arc::new(Desk::new(page)?);
    server::start(listener, Arc::clone(&desk))?;
    println!("\n  Line Maze Lab is at  http://localhost:{port}/  (Ctrl+C ends it)\n");
    loop {
        let change = watch.next(&bench.sources)?;
        let start = Instant::now();
        match bench.build(change) {
            Ok(page) => {
                if desk.show(page)? {
                    say(&format!("The page is new ({:.1} s)", start.elapsed().as_secs_f32()));
                }
            }
            Err(error) => {
                eprintln!("error: {error}; the page stays as it was");
                desk.complain(&error);
            }
        }
    }
}

/// Builds the page once into a folder, as `serve` shows it.
pub(crate) fn page(shell: &Shell) -> Result<()> {
    tools::target(shell, WASM)?;
    let folder = shell.target().join("page");
    let (_, page) = Bench::start(shell, Kind::Development)?;
    page.write(&folder)?;
    say(&format!("The page is in {}", folder.display()));
    Ok(())
}

/// What of the page is kept from one build to the next.
struct Bench<'a> {
    shell: &'a Shell,
    kind: Kind,
    sources: BTreeSet<PathBuf>,
    /// When the wasm was written that the program was joined from. Someone else may build in the same folder.
    written: SystemTime,
    program: Program,
}

impl<'a> Bench<'a> {
    fn start(shell: &'a Shell, kind: Kind) -> Result<(Self, Page), NotBuilt> {
        let wasm = compile::compile(shell, kind)?;
        let (written, sources) = (written(&wasm)?, compile::sources(shell, &wasm)?);
        let program = join(shell, &wasm, Exports::Own)?;
        let page = Page::assemble(shell, &program, Naming::Plain)?;
        Ok((Self { shell, kind, sources, written, program }, page))
    }

    fn build(&mut self, change: Change) -> Result<Page, NotBuilt> {
        if change == Change::Program {
            let wasm = compile::compile(self.shell, self.kind)?;
            self.sources = compile::sources(self.shell, &wasm)?;
            let written = written(&wasm)?;
            if written != self.written {
                self.program = join(self.shell, &wasm, Exports::Own)?;
                self.written = written;
            }
        }
        Ok(Page::assemble(self.shell, &self.program, Naming::Plain)?)
    }
}

fn written(wasm: &Path) -> Result<SystemTime> {
    fs::metadata(wasm).and_then(|file| file.modified()).with_context(|| format!("reading {}", wasm.display()))
}
