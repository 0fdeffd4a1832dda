//! The tools that build a page, and how each is installed when it's missing.
//!
//! A tool that this computer doesn't have goes where cargo puts programs. Where it has another version, ours goes
//! into `target/tools`, and the other one stays as it is.

use std::fs;
use std::process::Command;
use std::time::Duration;

use anyhow::{Context, Result, anyhow};

use crate::shell::{Cure, Shell, run, run_within};

pub(crate) const WASM: &str = "wasm32-unknown-unknown";
pub(crate) const BOARD: &str = "thumbv6m-none-eabi";

const TRUNK: &str = "0.21.14";
/// Equal to `[tools] wasm_opt` in `Trunk.toml`.
const BINARYEN: &str = "132.0.0";
const DOWNLOAD_LIMIT: Duration = Duration::from_secs(300);
const NO_NETWORK: &str = "is this computer connected to the internet? \
     Once it is, run the same again; what is already installed stays";

/// Everything that a debug page needs.
pub(crate) fn for_page(shell: &Shell) -> Result<()> {
    target(shell, WASM)?;
    trunk(shell)?;
    wasm_bindgen(shell)
}

/// Everything that a page to publish needs.
pub(crate) fn for_release(shell: &Shell) -> Result<()> {
    for_page(shell)?;
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

fn trunk(shell: &Shell) -> Result<()> {
    let found = shell.ask("trunk", &["--version"]);
    if has_version(found.as_deref(), TRUNK) {
        return Ok(());
    }
    say(&format!("Compiling trunk {TRUNK}, which builds the page (once, about 6 minutes)"));
    run(cargo_install(shell, "trunk", TRUNK, found.as_deref()).arg("--locked")).cure(NO_NETWORK)
}

/// The version has to be that of the library, so it's read from `Cargo.lock`.
pub(crate) fn wasm_bindgen(shell: &Shell) -> Result<()> {
    let lock = fs::read_to_string(shell.root.join("Cargo.lock")).context("reading Cargo.lock")?;
    let version = locked_version(&lock, "wasm-bindgen").context("Cargo.lock names no wasm-bindgen")?;
    let found = shell.ask("wasm-bindgen", &["--version"]);
    if has_version(found.as_deref(), version) {
        return Ok(());
    }
    say(&format!(
        "Compiling wasm-bindgen {version}, which joins wasm and JavaScript (once, about 2 minutes)"
    ));
    let install = || cargo_install(shell, "wasm-bindgen-cli", version, found.as_deref());
    if run(install().arg("--locked")).is_ok() {
        return Ok(());
    }
    say("That did not go with its own list of versions; trying with the newest ones that fit");
    run(&mut install()).cure(NO_NETWORK)
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

fn cargo_install(shell: &Shell, package: &str, version: &str, found: Option<&str>) -> Command {
    let mut install = shell.cargo();
    install.args(["install", package, "--version", version, "--force"]);
    if found.is_some() {
        install.arg("--root").arg(shell.tools());
    }
    install
}

/// `trunk 0.21.14` and `wasm-opt version 132 (version_132)` name the versions 0.21.14 and 132.
fn has_version(printed: Option<&str>, version: &str) -> bool {
    printed.is_some_and(|printed| printed.split_whitespace().any(|word| word == version))
}

fn locked_version<'a>(lock: &'a str, package: &str) -> Option<&'a str> {
    let (_, after) = lock.split_once(&format!("name = \"{package}\"\nversion = \""))?;
    after.split('"').next()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_version_is_a_whole_word() {
        assert!(has_version(Some("trunk 0.21.14"), "0.21.14"));
        assert!(has_version(Some("wasm-opt version 132 (version_132)"), "132"));
        assert!(!has_version(Some("trunk 0.21.1"), "0.21.14"));
        assert!(!has_version(Some("trunk 0.21.14"), "0.21.1"));
        assert!(!has_version(None, "132"));
    }

    #[test]
    fn the_lock_file_names_the_version() {
        let lock = "[[package]]\nname = \"wasm-bindgen-futures\"\nversion = \"0.4.80\"\n\n\
                    [[package]]\nname = \"wasm-bindgen\"\nversion = \"0.2.130\"\nsource = \"x\"\n";
        assert_eq!(locked_version(lock, "wasm-bindgen"), Some("0.2.130"));
        assert_eq!(locked_version(lock, "leptos"), None);
    }
}
