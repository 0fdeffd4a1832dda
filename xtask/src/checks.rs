//! What the layers run that are made of cargo's own commands.

use std::fs;
use std::path::PathBuf;
use std::process::Command;

use anyhow::{Context, Result};

use crate::browser;
use crate::dist;
use crate::shell::{Shell, line, run, watch};
use crate::summary::{Counts, worth_showing};
use crate::tools::{self, BOARD, WASM, say};

const AXE_CORE: &str = "4.14.1";

/// Format, lints and documentation; warnings are errors, and each command counts one.
pub(crate) fn lint(shell: &Shell) -> Result<Counts> {
    tools::component(shell, "rustfmt", &["fmt", "--version"])?;
    tools::component(shell, "clippy", &["clippy", "--version"])?;
    tools::target(shell, WASM)?;
    let deny = ["--", "-D", "warnings"];
    let mut native = shell.cargo();
    native.args(["clippy", "--workspace", "--all-targets", "--features", "cli"]).args(deny);
    let mut wasm = shell.cargo();
    wasm.args(["clippy", "--target", WASM, "--features", "web", "--lib", "--bins"]);
    if shell.root.join("tests/web.rs").exists() {
        wasm.args(["--test", "web"]);
    }
    wasm.args(deny);
    let mut format = shell.cargo();
    format.args(["fmt", "--all", "--check"]);
    let mut doc = shell.cargo();
    doc.args(["doc", "--quiet", "--no-deps", "--lib"]).env("RUSTDOCFLAGS", "-D warnings");
    Ok([format, native, wasm, doc].into_iter().fold(Counts::default(), |mut counts, mut command| {
        counts += shown(&mut command);
        counts
    }))
}

/// Unit, property and documentation tests of the whole workspace, but those that drive a browser.
pub(crate) fn native(shell: &Shell) -> Result<Counts> {
    let mut command = shell.cargo();
    command.args(["test", "--workspace", "--features", "cli", "--no-fail-fast"]);
    if shell.root.join("tests/e2e").exists() {
        command.args(["--exclude", "e2e"]);
    }
    cargo_test(&mut command)
}

/// The core without any feature, for a microcontroller without an operating system.
pub(crate) fn board(shell: &Shell) -> Result<Counts> {
    tools::target(shell, BOARD)?;
    Ok(shown(shell.cargo().args(["build", "--lib", "--target", BOARD])))
}

/// The tests that need what only a browser has.
pub(crate) fn wasm(shell: &Shell) -> Result<Counts> {
    tools::target(shell, WASM)?;
    let browser = browser::browser(shell)?;
    say("Compiling the runner of these tests (the first time half a minute)");
    run(shell.cargo().args(["build", "--package", "wasm-runner"]))?;
    let temporary = Temporary::new(shell, "wasm")?;
    let mut command = shell.cargo();
    command.args([
        "test",
        "--target",
        WASM,
        "--features",
        "web",
        "--test",
        "web",
        "--test",
        "web_serial",
        "--no-fail-fast",
    ]);
    command.env("CHROMEDRIVER", browser.driver).env("TMPDIR", &temporary.0);
    cargo_test(&mut command)
}

/// A real browser uses the page in `dist/`.
pub(crate) fn e2e(shell: &Shell) -> Result<Counts> {
    let browser = browser::browser(shell)?;
    let axe = shell.tools().join("node_modules/axe-core/axe.min.js");
    if !axe.is_file() {
        tools::npm_package(shell, "axe-core", AXE_CORE, "which looks for barriers on the page")?;
    }
    browser::serial(shell)?;
    // The robot at the other end of a mocked serial port.
    run(shell.cargo().args(["build", "--features", "cli", "--bin", "linemaze"]))?;
    let temporary = Temporary::new(shell, "e2e")?;
    let mut command = shell.cargo();
    command.args(["test", "--package", "e2e", "--no-fail-fast"]).env("AXE_CORE", axe);
    cargo_test(in_browser(shell, &mut command, browser, &temporary))
}

/// Measures the page in `dist/` in a real browser, and prints what it finds.
pub(crate) fn speed(shell: &Shell) -> Result<()> {
    let browser = browser::browser(shell)?;
    dist::dist(shell)?;
    let temporary = Temporary::new(shell, "speed")?;
    let mut command = shell.cargo();
    command.args(["run", "--quiet", "--package", "e2e", "--example", "speed"]);
    run(in_browser(shell, &mut command, browser, &temporary))
}

fn in_browser<'a>(
    shell: &Shell,
    command: &'a mut Command,
    browser: browser::Browser,
    temporary: &Temporary,
) -> &'a mut Command {
    command.env("LINE_MAZE_DIST", dist::folder(shell)).env("TMPDIR", &temporary.0);
    command.env("CHROMIUM", browser.chromium).env("CHROMEDRIVER", browser.driver)
}

fn cargo_test(command: &mut Command) -> Result<Counts> {
    println!("{}", line(command));
    let finished = watch(command, worth_showing)?;
    Ok(Counts::of_cargo_test(finished.ok, &finished.output))
}

fn shown(command: &mut Command) -> Counts {
    println!("{}", line(command));
    match run(command) {
        Ok(()) => Counts::PASSED,
        Err(error) => {
            println!("FAILED: {error:#}");
            Counts::FAILED
        }
    }
}

/// A folder for the profiles that browsers leave behind; gone when the layer is through.
struct Temporary(PathBuf);

impl Temporary {
    fn new(shell: &Shell, name: &str) -> Result<Self> {
        let folder = shell.root.join("target/tmp").join(name);
        let _ = fs::remove_dir_all(&folder);
        fs::create_dir_all(&folder).with_context(|| format!("making {}", folder.display()))?;
        Ok(Self(folder))
    }
}

impl Drop for Temporary {
    fn drop(&mut self) {
        let _ = fs::remove_dir_all(&self.0);
    }
}
