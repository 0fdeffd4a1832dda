//! The service worker's list of files and its version: a hash over all of them.

use std::fmt::Write;
use std::fs;
use std::path::Path;

use anyhow::{Context, Result, ensure};
use sha2::{Digest, Sha256};

use crate::dist;

const WORKER: &str = "sw.js";
const VERSION: &str = "const VERSION = \"\";";
const FILES: &str = "const FILES = [];";

/// Fills in `dist/sw.js`; the empty template is what `serve` gives out.
pub(crate) fn fill_in(folder: &Path) -> Result<()> {
    let files = dist::files(folder)?;
    let template = fs::read_to_string(folder.join(WORKER)).context("the page has no sw.js")?;
    fs::write(folder.join(WORKER), worker(&template, &files)?).context("writing dist/sw.js")
}

fn worker(template: &str, files: &[(String, Vec<u8>)]) -> Result<String> {
    ensure!(template.contains(VERSION) && template.contains(FILES), "sw.js lost its two places to fill in");
    let addresses: Vec<&str> = files.iter().map(|(address, _)| &**address).filter(|a| *a != WORKER).collect();
    let list = serde_json::to_string_pretty(&addresses)?;
    Ok(template.replacen(VERSION, &format!("const VERSION = \"{}\";", version(files)), 1).replacen(
        FILES,
        &format!("const FILES = {list};"),
        1,
    ))
}

/// Sixteen digits that change when any file's name or content does.
fn version(files: &[(String, Vec<u8>)]) -> String {
    let mut hash = Sha256::new();
    for (address, content) in files {
        hash.update(Sha256::digest(address));
        hash.update(Sha256::digest(content));
    }
    hash.finalize().iter().take(8).fold(String::new(), |mut digits, byte| {
        let _ = write!(digits, "{byte:02x}");
        digits
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    fn files(pairs: &[(&str, &str)]) -> Vec<(String, Vec<u8>)> {
        pairs.iter().map(|(address, content)| ((*address).into(), (*content).into())).collect()
    }

    #[test]
    fn every_file_but_the_worker_is_listed() {
        let filled = worker(
            "const VERSION = \"\";\nconst FILES = [];\n",
            &files(&[("a/b.js", "1"), ("index.html", "2"), ("sw.js", "3")]),
        )
        .unwrap();
        assert!(filled.contains("const FILES = [\n  \"a/b.js\",\n  \"index.html\"\n];"), "{filled}");
        assert!(!filled.contains("const VERSION = \"\""), "{filled}");
    }

    #[test]
    fn the_version_follows_names_and_contents() {
        let one = version(&files(&[("a", "bc")]));
        assert_eq!(one.len(), 16);
        assert_eq!(one, version(&files(&[("a", "bc")])));
        assert_ne!(one, version(&files(&[("ab", "c")])));
        assert_ne!(one, version(&files(&[("a", "bd")])));
    }

    #[test]
    fn a_template_without_its_places_is_an_error() {
        assert!(worker("const FILES = [];", &[]).is_err());
    }
}
