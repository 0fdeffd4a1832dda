//! The service worker's list of files and its version: a hash over all of them.

use std::fmt::Write;

use anyhow::{Result, ensure};
use sha2::{Digest, Sha256};

use crate::page::Page;

const WORKER: &str = "sw.js";
const VERSION: &str = "const VERSION = \"\";";
const FILES: &str = "const FILES = [];";

/// Fills in the page's `sw.js`; the empty template is what `serve` gives out.
pub(crate) fn fill_in(page: &mut Page) -> Result<()> {
    let filled = worker(page.text(WORKER)?, page)?;
    page.edit(WORKER, |_| Ok(filled))
}

fn worker(template: &str, page: &Page) -> Result<String> {
    ensure!(template.contains(VERSION) && template.contains(FILES), "sw.js lost its two places to fill in");
    let addresses: Vec<&str> =
        page.0.keys().map(String::as_str).filter(|address| *address != WORKER).collect();
    let list = serde_json::to_string_pretty(&addresses)?;
    Ok(template.replacen(VERSION, &format!("const VERSION = \"{}\";", version(page)), 1).replacen(
        FILES,
        &format!("const FILES = {list};"),
        1,
    ))
}

/// Sixteen digits that change when any file's name or content does.
fn version(page: &Page) -> String {
    let mut hash = Sha256::new();
    for (address, content) in &page.0 {
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

    fn files(pairs: &[(&str, &str)]) -> Page {
        Page(pairs.iter().map(|(address, content)| ((*address).into(), (*content).into())).collect())
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
        assert!(worker("const FILES = [];", &Page::default()).is_err());
    }
}
