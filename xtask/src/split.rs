//! Splits the wasm at its lazy functions: a first visit loads the main part, the others follow when they are
//! needed. Trunk can't do it, so this takes its place between cargo and wasm-bindgen.

use std::fs;
use std::path::{Path, PathBuf};
use std::sync::{Mutex, PoisonError};

use anyhow::{Context, Result, anyhow};
use sha2::{Digest, Sha256};

use crate::shell::{Shell, run, run_quietly};
use crate::tools::{WASM, say};

const NAME: &str = "line-maze-lab";

/// What the compiler has to know for it; added to the flags of `.cargo/config.toml`.
pub(crate) fn rustflags(shell: &Shell) -> String {
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

/// Puts the parts in the place of the one wasm that trunk left in `folder`.
pub(crate) fn split(shell: &Shell, folder: &Path) -> Result<()> {
    say("Splitting the wasm into what a first visit needs, and the rest");
    let work = target(shell).join("split");
    let _ = fs::remove_dir_all(&work);
    fs::create_dir_all(&work)?;
    let page = page_name(folder)?;
    let parts = format!("./{page}-parts.js");

    let whole = target(shell).join(WASM).join("release").join(format!("{NAME}.wasm"));
    let whole = fs::read(&whole).with_context(|| format!("reading {}", whole.display()))?;
    let main = work.join(format!("{page}.wasm"));
    let mut options = wasm_split_cli_support::Options::new(&whole);
    options.output_dir = &work;
    options.main_out_path = &main;
    options.link_name = &parts;
    let main_js = format!("./{page}.js");
    options.main_module = &main_js;
    let split = wasm_split_cli_support::transform(options).map_err(|error| anyhow!("{error:#}"))?;

    let mut bindgen = shell.command("wasm-bindgen");
    bindgen.args(["--target", "web", "--no-typescript", "--keep-lld-exports", "--out-name", &page]);
    run(bindgen.arg("--out-dir").arg(folder).arg(&main))?;
    let main = folder.join(format!("{page}_bg.wasm"));
    let light = |part: &Path| part.with_extension("light");
    let parts_to_main = split.split_modules.iter().map(|part| (part.clone(), light(part)));
    optimize_all(shell, parts_to_main.chain([(main.clone(), main)]).collect())?;

    let mut link = fs::read_to_string(work.join(&parts)).context("the split left no loader")?;
    for part in split.split_modules {
        let stem = part.file_stem().context("a part has no name")?.to_string_lossy().into_owned();
        let content = fs::read(light(&part))?;
        let name = format!("{}-{}.wasm", stem.trim_start_matches("split_").replace('_', "-"), hash(&content));
        link = link.replace(&format!("\"./{stem}.wasm\""), &format!("\"./{name}\""));
        fs::write(folder.join(name), content)?;
    }
    fs::write(folder.join(&parts), link).context("writing the loader of the parts")
}

/// The name that trunk gave the page's script and wasm, without their endings.
fn page_name(folder: &Path) -> Result<String> {
    for entry in fs::read_dir(folder)? {
        let name = entry?.file_name().to_string_lossy().into_owned();
        if let Some(page) = name.strip_suffix("_bg.wasm") {
            return Ok(page.to_owned());
        }
    }
    Err(anyhow!("trunk left no wasm in {}", folder.display()))
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

fn target(shell: &Shell) -> PathBuf {
    std::env::var_os("CARGO_TARGET_DIR").map_or_else(|| shell.root.join("target"), |t| shell.root.join(t))
}

fn hash(content: &[u8]) -> String {
    Sha256::digest(content).iter().take(8).map(|byte| format!("{byte:02x}")).collect()
}
