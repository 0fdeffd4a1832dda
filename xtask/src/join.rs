//! Joins the wasm that cargo made with the JavaScript around it, as the command `wasm-bindgen` does.

use std::fs;
use std::path::Path;

use anyhow::{Context, Result, ensure};
use wasm_bindgen_cli_support::Bindgen;

use crate::page::{Page, hash};
use crate::shell::Shell;

/// The program's name in Cargo.toml, and in `index.html`.
pub(crate) const NAME: &str = "line-maze-lab";

/// The program's files: `STEM.js`, which loads `STEM_bg.wasm`, and what these two ask for.
#[derive(Debug, Clone)]
pub(crate) struct Program {
    pub(crate) stem: String,
    pub(crate) files: Page,
}

/// What a wasm shows to the outside.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Exports {
    /// What the page calls.
    Own,
    /// Also what the linker adds: other parts of a split wasm ask for it.
    Linker,
}

/// The program out of what cargo or the splitter left.
pub(crate) fn join(shell: &Shell, wasm: &Path, exports: Exports) -> Result<Program> {
    let folder = shell.target().join("tmp/joined");
    let _ = fs::remove_dir_all(&folder);
    let wasm = fs::read(wasm).with_context(|| format!("reading {}", wasm.display()))?;
    Bindgen::new()
        .input_bytes(NAME, wasm)
        .web(true)?
        .typescript(false)
        .keep_lld_exports(exports == Exports::Linker)
        .generate(&folder)
        .context("joining the wasm and its JavaScript")?;
    Ok(Program { stem: NAME.to_owned(), files: Page::read(&folder)? })
}

impl Program {
    /// Nothing yet, under the names that the repository uses.
    pub(crate) fn plain() -> Self {
        Self { stem: NAME.to_owned(), files: Page::default() }
    }

    pub(crate) fn script(&self) -> String {
        format!("{}.js", self.stem)
    }

    pub(crate) fn wasm(&self) -> String {
        format!("{}_bg.wasm", self.stem)
    }

    /// The loader of a split program's parts.
    pub(crate) fn parts(&self) -> String {
        format!("{}-parts.js", self.stem)
    }

    /// The names that `index.html` uses, with those that the files have.
    pub(crate) fn names(&self) -> impl Iterator<Item = (&'static str, String)> {
        [("line-maze-lab.js", self.script()), ("line-maze-lab_bg.wasm", self.wasm())].into_iter()
    }

    /// Puts a hash of all that is in the program into its files' names, so that no cache mixes two versions.
    pub(crate) fn named_by_content(mut self) -> Result<Self> {
        let plain = Self::plain();
        let named = Self { stem: format!("{NAME}-{}", hash(self.files.0.values())), files: Page::default() };
        let mut files = Page::default();
        let moved = [plain.script(), plain.wasm(), plain.parts()].into_iter().zip([
            named.script(),
            named.wasm(),
            named.parts(),
        ]);
        for (from, to) in moved {
            if let Some(content) = self.files.0.remove(&from) {
                files.0.insert(to, content);
            }
        }
        files.0.append(&mut self.files.0);
        // Where one script asks for the other by name. The names in the wasm's own list of imports stay.
        let script = |text: &str| renamed(text, &from(&plain.parts()), &from(&named.parts()));
        let parts = |text: &str| renamed(text, &from(&plain.script()), &from(&named.script()));
        files.edit(&named.script(), script)?;
        files.edit(&named.parts(), parts)?;
        Ok(Self { stem: named.stem, files })
    }
}

fn from(script: &str) -> String {
    format!("from \"./{script}\"")
}

fn renamed(text: &str, from: &str, to: &str) -> Result<String> {
    ensure!(text.contains(from), "the program's JavaScript does not say {from}; did wasm-bindgen change?");
    Ok(text.replace(from, to))
}

#[cfg(test)]
mod tests {
    use super::*;

    fn program(wasm: &str) -> Program {
        let files = [
            (
                "line-maze-lab.js",
                "import { draw } from \"./line-maze-lab-parts.js\";\nimports = { \"./line-maze-lab_bg.js\": 1 };",
            ),
            ("line-maze-lab_bg.wasm", wasm),
            ("line-maze-lab-parts.js", "import { initSync } from \"./line-maze-lab.js\";"),
            ("draw-12.wasm", "draw"),
        ];
        let files = files.into_iter().map(|(name, text)| (name.into(), text.into())).collect();
        Program { stem: NAME.into(), files: Page(files) }
    }

    #[test]
    fn files_find_each_other_under_their_new_names() {
        let named = program("x").named_by_content().unwrap();
        assert_ne!(named.stem, NAME);
        assert_eq!(
            named.names().map(|(plain, _)| plain).collect::<Vec<_>>(),
            ["line-maze-lab.js", "line-maze-lab_bg.wasm"]
        );
        let script = named.files.text(&named.script()).unwrap();
        assert!(script.contains(&format!("from \"./{}\"", named.parts())), "{script}");
        assert!(script.contains("\"./line-maze-lab_bg.js\""), "{script}");
        let parts = named.files.text(&named.parts()).unwrap();
        assert!(parts.contains(&format!("from \"./{}\"", named.script())), "{parts}");
        assert_eq!(named.files.text("draw-12.wasm").unwrap(), "draw");
        assert_eq!(named.files.0.len(), 4);
    }

    #[test]
    fn another_wasm_has_another_name() {
        let stem = |wasm: &str| program(wasm).named_by_content().unwrap().stem;
        assert_eq!(stem("x"), stem("x"));
        assert_ne!(stem("x"), stem("y"));
    }
}
