//! The program as cargo compiles it for the page, and why it did not.

use std::collections::BTreeSet;
use std::fmt::{self, Display, Formatter};
use std::fs;
use std::io::{BufRead, BufReader, IsTerminal, stderr};
use std::path::{Path, PathBuf};
use std::process::{Command, Stdio};

use anyhow::{Context, Error, anyhow};
use serde_json::Value;

use crate::join::NAME;
use crate::shell::{Shell, line};
use crate::tools::WASM;

/// How it is compiled.
#[derive(Debug, Default, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Kind {
    /// Quickly.
    #[default]
    Development,
    /// Small and fast.
    Release,
    /// The same, with what the splitter wants to know.
    Split,
}

/// Why there is no page. Each says so in one line, with the cure.
#[derive(Debug)]
pub(crate) enum NotBuilt {
    /// The code is wrong: what the compiler says.
    Code(String),
    /// Cargo did not come so far, and has said why.
    Cargo,
    Other(Error),
}

impl Display for NotBuilt {
    fn fmt(&self, f: &mut Formatter<'_>) -> fmt::Result {
        match self {
            Self::Code(_) => f.write_str(
                "the page is not built, because the code does not compile; correct what the compiler says above",
            ),
            Self::Cargo => f.write_str(
                "the page is not built, cargo says above why; if it could not download something, see to the \
                 connection to the internet, then run the same again: what is already there stays",
            ),
            Self::Other(error) => write!(f, "the page is not built: {error:#}"),
        }
    }
}

impl std::error::Error for NotBuilt {}

impl From<Error> for NotBuilt {
    fn from(error: Error) -> Self {
        Self::Other(error)
    }
}

/// Compiles the program into a wasm. Cargo shows its progress; the compiler's messages are shown, and kept for the
/// caller.
pub(crate) fn compile(shell: &Shell, kind: Kind) -> Result<PathBuf, NotBuilt> {
    let mut cargo = shell.cargo();
    cargo.args(["build", "--target", WASM, "--features", "web", "--bin", NAME]);
    match kind {
        Kind::Development => {}
        Kind::Release => {
            cargo.arg("--release");
        }
        Kind::Split => {
            cargo.arg("--release").env("CARGO_TARGET_WASM32_UNKNOWN_UNKNOWN_RUSTFLAGS", split_flags(shell));
        }
    }
    let ansi = stderr().is_terminal() && std::env::var_os("NO_COLOR").is_none();
    cargo.arg(if ansi { "--message-format=json-diagnostic-rendered-ansi" } else { "--message-format=json" });
    let mut told = Told::default();
    let ok = follow(&mut cargo, |message| told.hear(message))?;
    told.result(ok)
}

/// What the compiler has to know to leave a wasm that can be split; added to the flags of `.cargo/config.toml`.
fn split_flags(shell: &Shell) -> String {
    let mut flags = "--cfg split -Clink-arg=--emit-relocs".to_owned();
    // The places of panics are in the wasm: no need to tell everybody where this computer keeps its files.
    let homes = [("CARGO_HOME", ".cargo"), ("RUSTUP_HOME", ".rustup")].map(|(variable, folder)| {
        std::env::var(variable).ok().or_else(|| Some(format!("{}/{folder}", std::env::var("HOME").ok()?)))
    });
    let sources = homes.into_iter().flatten().chain([shell.root.to_string_lossy().into_owned()]);
    for source in sources.filter(|source| !source.contains(char::is_whitespace)) {
        flags += &format!(" --remap-path-prefix={source}=");
    }
    flags
}

/// The folders and files of the repository that the program is made of, by their first names: `src`, `mazes`.
pub(crate) fn sources(shell: &Shell, wasm: &Path) -> anyhow::Result<BTreeSet<PathBuf>> {
    let list = wasm.with_extension("d");
    let list = fs::read_to_string(&list).with_context(|| format!("reading {}", list.display()))?;
    Ok(first_names(&shell.root, &list))
}

/// Cargo writes `PROGRAM: FILE FILE …`, with a `\` before a blank that belongs to a name.
fn first_names(root: &Path, list: &str) -> BTreeSet<PathBuf> {
    let files = list.split_once(": ").map_or("", |(_, files)| files).trim_end().replace("\\ ", "\0");
    files
        .split(' ')
        .map(|file| file.replace('\0', " "))
        .filter_map(|file| Path::new(&file).strip_prefix(root).ok()?.iter().next().map(PathBuf::from))
        .collect()
}

/// Starts cargo and reads its messages; whether it was content.
fn follow(cargo: &mut Command, mut hear: impl FnMut(&Value)) -> anyhow::Result<bool> {
    let starting = || format!("could not start {}", line(cargo));
    let mut child = {
        let starting = starting();
        cargo.stdout(Stdio::piped()).spawn().context(starting)?
    };
    if let Some(stdout) = child.stdout.take() {
        for line in BufReader::new(stdout).lines() {
            if let Ok(message) = serde_json::from_str(&line?) {
                hear(&message);
            }
        }
    }
    Ok(child.wait()?.success())
}

#[derive(Debug, Default)]
struct Told {
    wasm: Option<PathBuf>,
    errors: String,
}

impl Told {
    fn hear(&mut self, message: &Value) {
        let text = |value: &Value| value.as_str().unwrap_or_default().to_owned();
        if message["reason"] == "compiler-message" {
            let rendered = text(&message["message"]["rendered"]);
            show(&rendered);
            if message["message"]["level"] == "error" {
                self.errors += &without_colours(&rendered);
            }
        }
        let ours = message["target"]["name"] == NAME && message["target"]["kind"][0] == "bin";
        if message["reason"] == "compiler-artifact" && ours {
            let mut files = message["filenames"].as_array().into_iter().flatten().map(text);
            self.wasm = files.find(|file| file.ends_with(".wasm")).map(PathBuf::from);
        }
    }

    fn result(self, ok: bool) -> Result<PathBuf, NotBuilt> {
        match self.wasm.filter(|_| ok) {
            Some(wasm) => Ok(wasm),
            None if !self.errors.is_empty() => Err(NotBuilt::Code(self.errors)),
            None if !ok => Err(NotBuilt::Cargo),
            None => Err(NotBuilt::Other(anyhow!("cargo was content, but left no {NAME}.wasm"))),
        }
    }
}

/// In a terminal cargo's progress may stand on the line.
fn show(rendered: &str) {
    let clear = if stderr().is_terminal() { "\r\x1b[K" } else { "" };
    eprint!("{clear}{rendered}");
}

/// Takes out what sets a terminal's colours: `ESC [ … m`.
fn without_colours(text: &str) -> String {
    let mut parts = text.split("\x1b[");
    let first = parts.next().unwrap_or_default().to_owned();
    parts.fold(first, |plain, part| plain + part.split_once('m').map_or(part, |(_, after)| after))
}

#[cfg(test)]
mod tests {
    use super::*;

    fn told(messages: &str) -> Told {
        let mut told = Told::default();
        messages.lines().for_each(|line| told.hear(&serde_json::from_str(line).unwrap()));
        told
    }

    const ARTIFACT: &str = r#"{"reason":"compiler-artifact","target":{"kind":["lib"],"name":"leptos"},"filenames":["/t/leptos.rlib"],"fresh":true}
{"reason":"compiler-artifact","target":{"kind":["bin"],"name":"line-maze-lab"},"filenames":["/t/line-maze-lab.wasm"],"fresh":false}"#;
    const ERROR: &str = r#"{"reason":"compiler-message","message":{"level":"error","rendered":"\u001b[1merror\u001b[0m: no such name\n"}}"#;

    #[test]
    fn the_wasm_is_where_cargo_says() {
        assert_eq!(told(ARTIFACT).result(true).unwrap(), PathBuf::from("/t/line-maze-lab.wasm"));
    }

    #[test]
    fn wrong_code_is_told_from_a_cargo_that_fails() {
        match told(ERROR).result(false) {
            Err(NotBuilt::Code(words)) => assert_eq!(words, "error: no such name\n"),
            other => panic!("{other:?}"),
        }
        assert!(matches!(told("").result(false), Err(NotBuilt::Cargo)));
        assert!(matches!(told(ARTIFACT).result(false), Err(NotBuilt::Cargo)));
        assert!(matches!(told("").result(true), Err(NotBuilt::Other(_))));
    }

    #[test]
    fn every_failure_is_one_line() {
        for error in [NotBuilt::Code("a\nb".into()), NotBuilt::Cargo, NotBuilt::Other(anyhow!("no room"))] {
            let line = error.to_string();
            assert!(line.starts_with("the page is not built") && !line.contains('\n'), "{line}");
        }
    }

    #[test]
    fn what_the_program_is_made_of_is_in_cargos_list() {
        let list =
            "/p r/target/x.wasm: /p\\ r/src/a.rs /p\\ r/src/b/c.rs /p\\ r/mazes/my\\ own.maze /else/d.rs\n";
        let names: Vec<_> = first_names(Path::new("/p r"), list).into_iter().collect();
        assert_eq!(names, [PathBuf::from("mazes"), PathBuf::from("src")]);
    }
}
