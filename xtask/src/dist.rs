//! `cargo xtask dist`: the page as a folder for any static web server, sealed and within its budgets.

use std::path::PathBuf;

use anyhow::{Result, ensure};

use crate::compile::{self, Kind};
use crate::page::{Naming, Page};
use crate::shell::Shell;
use crate::tools::{self, say};
use crate::{budget, csp, offline, split};

/// Stands in `index.html` until the page gets its version here.
const DEVELOPMENT: &str = "<meta name=\"version\" content=\"development\"";

pub(crate) fn dist(shell: &Shell) -> Result<()> {
    tools::for_release(shell)?;
    say("Compiling the page to publish (some minutes the first time)");
    let wasm = compile::compile(shell, Kind::Split)?;
    say("Splitting the program into what a first visit needs, and the rest");
    let program = split::split(shell, &wasm)?.named_by_content()?;
    let mut page = Page::assemble(shell, &program, Naming::ByContent)?;
    seal(&mut page)?;
    offline::fill_in(&mut page)?;
    let folder = folder(shell);
    page.write(&folder)?;
    budget::check(shell, &folder)?;
    say(&format!("The page is in {}: put that folder on any web server", folder.display()));
    Ok(())
}

pub(crate) fn folder(shell: &Shell) -> PathBuf {
    shell.root.join("dist")
}

/// Gives the page its version and its Content Security Policy.
fn seal(page: &mut Page) -> Result<()> {
    page.edit_index(|html| {
        ensure!(html.contains(DEVELOPMENT), "index.html lost its place for the version: {DEVELOPMENT}>");
        let released = format!("<meta name=\"version\" content=\"{}\"", env!("CARGO_PKG_VERSION"));
        csp::seal(&html.replacen(DEVELOPMENT, &released, 1))
    })
}
