//! The heavy tools of `cargo xtask dist`, in a package of their own: nobody who only opens the lab waits until
//! they are compiled.
//!
//! - `press split WHOLE FOLDER MAIN.js PARTS.js` leaves `main.wasm`, the parts and their loader `PARTS.js` in
//!   the folder, and prints the parts' names.
//! - `press weigh FILE…` prints for each file how many bytes are left when it is compressed as web servers do it.

use std::fs;
use std::io::Write;
use std::path::Path;
use std::process::ExitCode;

use anyhow::{Context, Result, anyhow, bail};

fn main() -> ExitCode {
    match run(&std::env::args().skip(1).collect::<Vec<_>>()) {
        Ok(()) => ExitCode::SUCCESS,
        Err(error) => {
            eprintln!("error: {error:#}");
            ExitCode::FAILURE
        }
    }
}

fn run(args: &[String]) -> Result<()> {
    let args: Vec<&str> = args.iter().map(String::as_str).collect();
    match args.as_slice() {
        ["split", whole, folder, main, parts] => split(whole.as_ref(), folder.as_ref(), main, parts),
        ["weigh", files @ ..] => files.iter().try_for_each(|file| weigh(file.as_ref())),
        _ => bail!("this is a tool of `cargo xtask dist`; its first lines tell how to call it"),
    }
}

fn split(whole: &Path, folder: &Path, main: &str, parts: &str) -> Result<()> {
    let whole = fs::read(whole).with_context(|| format!("reading {}", whole.display()))?;
    let main_wasm = folder.join("main.wasm");
    let (main, parts) = (format!("./{main}"), format!("./{parts}"));
    let mut options = wasm_split_cli_support::Options::new(&whole);
    options.output_dir = folder;
    options.main_out_path = &main_wasm;
    options.main_module = &main;
    options.link_name = &parts;
    let split = wasm_split_cli_support::transform(options).map_err(|error| anyhow!("{error:#}"))?;
    for part in split.split_modules {
        println!("{}", part.file_name().context("a part has no name")?.to_string_lossy());
    }
    Ok(())
}

fn weigh(file: &Path) -> Result<()> {
    let content = fs::read(file).with_context(|| format!("reading {}", file.display()))?;
    println!("{}", brotli(&content)?);
    Ok(())
}

fn brotli(content: &[u8]) -> Result<usize> {
    let mut compressor = brotli::CompressorWriter::new(Vec::new(), 1 << 16, 11, 22);
    compressor.write_all(content)?;
    Ok(compressor.into_inner().len())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn repetition_compresses() {
        assert!(brotli(&[b'a'; 10_000]).unwrap() < 100);
    }
}
