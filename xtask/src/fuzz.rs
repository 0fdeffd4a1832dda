//! Random input against everything that reads foreign bytes, with the stable compiler and no extra tool.
//!
//! `cargo fuzz` passes the same flags; it wants a nightly compiler only for the address sanitizer, which code without
//! `unsafe` can do without.

use std::fs;
use std::path::{Path, PathBuf};
use std::process::Stdio;

use anyhow::{Context, Result, bail};
use serde_json::Value;

use crate::shell::Shell;
use crate::summary::Counts;
use crate::tools::say;

const FLAGS: &str = "--cfg fuzzing -Cpasses=sancov-module -Cllvm-args=-sanitizer-coverage-level=4 \
    -Cllvm-args=-sanitizer-coverage-inline-8bit-counters -Cllvm-args=-sanitizer-coverage-pc-table \
    -Cdebug-assertions -Ccodegen-units=1";
/// The same seed every time: a failure comes from the change at hand, and comes again.
const BOUNDS: [&str; 5] =
    ["-runs=20000", "-max_total_time=20", "-timeout=5", "-rss_limit_mb=2048", "-seed=1"];

/// Runs every target for some seconds, each counts one.
pub(crate) fn fuzz(shell: &Shell) -> Result<Counts> {
    let mut counts = Counts::default();
    for (target, program) in build(shell)? {
        counts += run_one(shell, &target, &program)?;
    }
    Ok(counts)
}

/// The targets' names and programs.
fn build(shell: &Shell) -> Result<Vec<(String, PathBuf)>> {
    let host =
        shell.ask("rustc", &["--print", "host-tuple"]).context("rustc doesn't name this computer's kind")?;
    let mut cargo = shell.cargo();
    // Naming the target keeps the flags away from build scripts, which would not link with them.
    cargo.args(["build", "--manifest-path", "fuzz/Cargo.toml", "--release", "--bins", "--target", &host]);
    cargo.arg("--message-format=json-render-diagnostics");
    cargo.env("RUSTFLAGS", FLAGS).stderr(Stdio::inherit());
    let output = cargo.output().context("could not start cargo")?;
    if !output.status.success() {
        bail!("the fuzz targets don't build");
    }
    let programs = programs(&String::from_utf8_lossy(&output.stdout));
    if programs.is_empty() {
        bail!("fuzz/Cargo.toml has no [[bin]]");
    }
    Ok(programs)
}

/// The binaries among the messages of `cargo build`.
fn programs(messages: &str) -> Vec<(String, PathBuf)> {
    let mut programs: Vec<_> = messages
        .lines()
        .filter_map(|line| serde_json::from_str::<Value>(line).ok())
        .filter(|message| message["target"]["kind"][0] == "bin")
        .filter_map(|message| {
            Some((message["target"]["name"].as_str()?.to_owned(), message["executable"].as_str()?.into()))
        })
        .collect();
    programs.sort();
    programs
}

fn run_one(shell: &Shell, target: &str, program: &Path) -> Result<Counts> {
    say(&format!("Fuzzing {target} (at most 20 seconds)"));
    let corpus = fresh_corpus(shell, target)?;
    let artifacts = shell.root.join("fuzz/artifacts").join(target);
    fs::create_dir_all(&artifacts)?;
    let mut fuzzer = shell.command(program);
    fuzzer.args(BOUNDS).arg(format!("-artifact_prefix={}/", artifacts.display())).arg(&corpus);
    // Later folders are only read.
    fuzzer.args(Some(shell.root.join("tests/fixtures/bad")).filter(|folder| folder.is_dir()));
    let output = fuzzer.output().with_context(|| format!("could not start {target}"))?;
    let log = String::from_utf8_lossy(&output.stderr);
    if output.status.success() {
        println!("  {}", log.lines().rev().find(|line| line.starts_with("Done ")).unwrap_or("done"));
        return Ok(Counts::PASSED);
    }
    println!("{}{log}", String::from_utf8_lossy(&output.stdout));
    println!("  {target} failed. Its input is in {}; to see it again:", artifacts.display());
    println!("  {} {}/crash-…", program.display(), artifacts.display());
    Ok(Counts::FAILED)
}

/// A copy of the kept inputs, because the fuzzer writes what it finds into the first folder.
fn fresh_corpus(shell: &Shell, target: &str) -> Result<PathBuf> {
    let copy = shell.root.join("target/tmp/fuzz").join(target);
    if copy.exists() {
        fs::remove_dir_all(&copy)?;
    }
    fs::create_dir_all(&copy)?;
    let kept = shell.root.join("fuzz/corpus").join(target);
    if kept.is_dir() {
        for entry in fs::read_dir(kept)? {
            let entry = entry?;
            fs::copy(entry.path(), copy.join(entry.file_name()))?;
        }
    }
    Ok(copy)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn programs_are_read_from_cargos_messages() {
        let messages = r#"{"reason":"compiler-artifact","target":{"kind":["lib"],"name":"arbitrary"},"executable":null}
{"reason":"compiler-artifact","target":{"kind":["custom-build"],"name":"build-script-build"},"executable":null}
{"reason":"compiler-artifact","target":{"kind":["bin"],"name":"maze"},"executable":"/t/maze"}
{"reason":"build-finished","success":true}"#;
        assert_eq!(programs(messages), [("maze".to_owned(), PathBuf::from("/t/maze"))]);
    }
}
