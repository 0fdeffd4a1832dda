//! `cargo xtask dist`: the page as a folder for any static web server, sealed and within its budgets.

use std::fs;
use std::path::{Path, PathBuf};
use std::process::Command;

use anyhow::{Context, Result};

use crate::shell::{Shell, run};
use crate::tools::{self, say};
use crate::{budget, csp, offline, split};

/// Stands in `index.html` until the page gets its version here.
const DEVELOPMENT: &str = "<meta name=\"version\" content=\"development\"";

pub(crate) fn dist(shell: &Shell) -> Result<()> {
    tools::for_release(shell)?;
    say("Building the page to publish (some minutes the first time)");
    let folder = folder(shell);
    let mut build = trunk(shell, "build");
    build.args(["--release", "--public-url", "./"]).arg("--dist").arg(&folder);
    run(build.env("CARGO_TARGET_WASM32_UNKNOWN_UNKNOWN_RUSTFLAGS", split::rustflags(shell)))?;
    split::split(shell, &folder)?;
    seal(&folder)?;
    offline::fill_in(&folder)?;
    budget::check(&folder)?;
    say(&format!("The page is in {}: put that folder on any web server", folder.display()));
    Ok(())
}

pub(crate) fn folder(shell: &Shell) -> PathBuf {
    shell.root.join("dist")
}

/// Trunk, told to look for nothing on the network: what it needs is installed by us.
pub(crate) fn trunk(shell: &Shell, chore: &str) -> Command {
    let mut trunk = shell.command("trunk");
    trunk.arg(chore).env("TRUNK_OFFLINE", "true").env("TRUNK_SKIP_VERSION_CHECK", "true");
    // Trunk takes NO_COLOR=1, as other programs write it, for an error.
    trunk.env_remove("NO_COLOR");
    trunk
}

/// Gives the page its version and its Content Security Policy.
fn seal(folder: &Path) -> Result<()> {
    let path = folder.join("index.html");
    let html = fs::read_to_string(&path).context("trunk left no dist/index.html")?;
    let released = format!("<meta name=\"version\" content=\"{}\"", env!("CARGO_PKG_VERSION"));
    let html = html.replacen(DEVELOPMENT, &released, 1);
    fs::write(&path, csp::seal(&html)?).context("writing dist/index.html")
}

/// Every file below a folder by its relative address, in alphabetical order.
pub(crate) fn files(folder: &Path) -> Result<Vec<(String, Vec<u8>)>> {
    fn walk(folder: &Path, prefix: &str, found: &mut Vec<(String, Vec<u8>)>) -> Result<()> {
        for entry in fs::read_dir(folder).with_context(|| format!("reading {}", folder.display()))? {
            let entry = entry?;
            let address = format!("{prefix}{}", entry.file_name().to_string_lossy());
            if entry.file_type()?.is_dir() {
                walk(&entry.path(), &format!("{address}/"), found)?;
            } else {
                found.push((address, fs::read(entry.path())?));
            }
        }
        Ok(())
    }
    let mut found = Vec::new();
    walk(folder, "", &mut found)?;
    found.sort();
    Ok(found)
}
