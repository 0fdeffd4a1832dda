//! The tools that build a page, and how each is installed when it's missing.
//!
//! What cargo does not build goes into `target/tools`; other versions on this computer stay as they are.

use std::fs;
use std::time::Duration;

use anyhow::{Result, anyhow};

use crate::shell::{Cure, Shell, run_within};

pub(crate) const WASM: &str = "wasm32-unknown-unknown";
pub(crate) const BOARD: &str = "thumbv6m-none-eabi";

/// Debian's wasm-opt 108 makes pages that die silently: this one, and no other.
const BINARYEN: &str = "132.0.0";
const DOWNLOAD_LIMIT: Duration = Duration::from_secs(300);
const NO_NETWORK: &str = "is this computer connected to the internet? \
     Once it is, run the same again; what is already installed stays";

/// Everything that a page to publish needs.
pub(crate) fn for_release(shell: &Shell) -> Result<()> {
    target(shell, WASM)?;
    wasm_opt(shell)
}

/// The standard library for another machine.
pub(crate) fn target(shell: &Shell, target: &str) -> Result<()> {
    let folder = shell.ask("rustc", &["--print", "target-libdir", "--target", target]);
    if folder.is_some_and(|folder| fs::read_dir(folder).is_ok_and(|mut files| files.next().is_some())) {
        return Ok(());
    }
    if shell.find("rustup").is_none() {
        return Err(anyhow!("this Rust can't build for {target}, and there's no rustup to add that"))
            .cure("install Rust as https://rustup.rs says, or your distribution's package for that target");
    }
    say(&format!("Adding {target} to Rust (some seconds)"));
    run_within(shell.command("rustup").args(["target", "add", target]), DOWNLOAD_LIMIT).cure(NO_NETWORK)
}

/// A part of the Rust toolchain, such as clippy.
pub(crate) fn component(shell: &Shell, component: &str, asks: &[&str]) -> Result<()> {
    if shell.ask("cargo", asks).is_some() {
        return Ok(());
    }
    say(&format!("Adding {component} to Rust (some seconds)"));
    run_within(shell.command("rustup").args(["component", "add", component]), DOWNLOAD_LIMIT).cure(NO_NETWORK)
}

fn wasm_opt(shell: &Shell) -> Result<()> {
    let major = BINARYEN.split('.').next().unwrap_or(BINARYEN);
    if has_version(shell.ask("wasm-opt", &["--version"]).as_deref(), major) {
        return Ok(());
    }
    npm_package(shell, "binaryen", BINARYEN, "which makes the wasm small")
}

/// Installs a package of npm's into `target/tools`.
pub(crate) fn npm_package(shell: &Shell, package: &str, version: &str, purpose: &str) -> Result<()> {
    crate::browser::node(shell)?;
    say(&format!("Fetching {package} {version}, {purpose} (some seconds)"));
    let mut npm = shell.command("npm");
    npm.args(["install", "--no-audit", "--no-fund", "--loglevel=error", "--save-exact", "--prefix"]);
    npm.arg(shell.tools()).arg(format!("{package}@{version}"));
    fs::create_dir_all(shell.tools())?;
    run_within(&mut npm, DOWNLOAD_LIMIT).cure(NO_NETWORK)
}

pub(crate) fn say(what: &str) {
    println!("→ {what}");
}

/// `wasm-opt version 132 (version_132)` names the version 132.
fn has_version(printed: Option<&str>, version: &str) -> bool {
    printed.is_some_and(|printed| printed.split_whitespace().any(|word| word == version))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_version_is_a_whole_word() {
        assert!(has_version(Some("wasm-opt version 132 (version_132)"), "132"));
        assert!(!has_version(Some("wasm-opt version 108"), "132"));
        assert!(!has_version(Some("wasm-opt version 1321"), "132"));
        assert!(!has_version(None, "132"));
    }
}
