//! Splits the program at its lazy functions: a first visit loads the main part, the others follow when they are
//! needed.

use std::fs;
use std::path::{Path, PathBuf};
use std::process::Command;
use std::sync::{Mutex, PoisonError};

use anyhow::{Context, Result, anyhow, ensure};

use crate::join::{Exports, Program, join};
use crate::page::hash;
use crate::shell::{Shell, printed, run_quietly};

/// How the splitter's loader starts a part.
const STREAMING: &str = "WebAssembly.instantiateStreaming(src, imports)";
/// How ours does: also from a server that does not call wasm by its name, as the main part can too.
const ANYHOW: &str = "instantiate(src, imports)";
const INSTANTIATE: &str = include_str!("instantiate.js");

/// The program in parts, out of the one wasm that cargo left.
pub(crate) fn split(shell: &Shell, whole: &Path) -> Result<Program> {
    let work = shell.target().join("split");
    let _ = fs::remove_dir_all(&work);
    fs::create_dir_all(&work)?;
    let plain = Program::plain();
    let mut splitter = press(shell, "split");
    let parts = printed(splitter.arg(whole).arg(&work).args([plain.script(), plain.parts()]))?;
    let mut program = join(shell, &work.join("main.wasm"), Exports::Linker)?;
    let main = work.join("main.joined");
    fs::write(&main, program.files.0.get(&program.wasm()).context("the program has no wasm")?)?;

    let parts: Vec<&str> = parts.lines().collect();
    let light = |part: &Path| part.with_extension("light");
    let heavy = parts.iter().map(|part| work.join(part)).chain([main.clone()]);
    optimize_all(shell, heavy.map(|part| (part.clone(), light(&part))).collect())?;

    program.files.0.insert(program.wasm(), fs::read(light(&main))?);
    let mut loader = fs::read_to_string(work.join(plain.parts())).context("the split left no loader")?;
    for part in parts {
        let content = fs::read(light(&work.join(part)))?;
        let stem = part.trim_end_matches(".wasm");
        let name =
            format!("{}-{}.wasm", stem.trim_start_matches("split_").replace('_', "-"), hash([&content]));
        loader = loader.replace(&format!("\"./{part}\""), &format!("\"./{name}\""));
        program.files.0.insert(name, content);
    }
    program.files.0.insert(plain.parts(), lenient(&loader)?.into_bytes());
    Ok(program)
}

/// The loader of the parts, made to take them from any server.
fn lenient(loader: &str) -> Result<String> {
    ensure!(
        loader.contains(STREAMING),
        "the loader of the parts does not say {STREAMING}; did the splitter change?"
    );
    Ok(loader.replace(STREAMING, ANYHOW) + INSTANTIATE)
}

/// A tool that only publishing needs; cargo compiles it when it is first called.
pub(crate) fn press(shell: &Shell, tool: &str) -> Command {
    let mut press = shell.cargo();
    press.args(["run", "--quiet", "--package", "press", "--", tool]);
    press
}

/// The largest, which is the last, takes as long as many small ones: all processors share the list.
fn optimize_all(shell: &Shell, jobs: Vec<(PathBuf, PathBuf)>) -> Result<()> {
    let jobs = Mutex::new(jobs);
    let next = || jobs.lock().unwrap_or_else(PoisonError::into_inner).pop();
    let work = || std::iter::from_fn(next).try_for_each(|(from, to)| optimize(shell, &from, &to));
    std::thread::scope(|scope| {
        let workers = std::thread::available_parallelism().map_or(1, usize::from);
        let workers: Vec<_> = (0..workers).map(|_| scope.spawn(work)).collect();
        workers.into_iter().try_for_each(|worker| {
            worker.join().unwrap_or_else(|_| Err(anyhow!("wasm-opt's thread broke off")))
        })
    })
}

fn optimize(shell: &Shell, from: &Path, to: &Path) -> Result<()> {
    // The features that Rust's wasm target has by itself.
    let features = [
        "--enable-bulk-memory",
        "--enable-bulk-memory-opt",
        "--enable-call-indirect-overlong",
        "--enable-multivalue",
        "--enable-mutable-globals",
        "--enable-nontrapping-float-to-int",
        "--enable-reference-types",
        "--enable-sign-ext",
    ];
    // It takes the names of the parts' functions for something to warn of, and leaves them out.
    run_quietly(shell.command("wasm-opt").args(features).arg("-Oz").arg(from).arg("-o").arg(to))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn parts_come_from_any_server() {
        let loader =
            format!("return async (imports) => ({STREAMING});\nreturn async (imports) => ({STREAMING});\n");
        let lenient = lenient(&loader).unwrap();
        let calls = lenient.matches(ANYHOW).count();
        assert_eq!((calls, lenient.matches(STREAMING).count()), (2, 0), "{lenient}");
        assert!(lenient.contains("async function instantiate("), "{lenient}");
        assert!(super::lenient("import.source(x)").is_err());
    }
}
