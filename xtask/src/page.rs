//! The page: `index.html` with the names of what it loads, the program, and the files of `static/`.

use std::collections::BTreeMap;
use std::fs;
use std::path::Path;

use anyhow::{Context, Result, bail};
use sha2::{Digest, Sha256};

use crate::join::Program;
use crate::shell::Shell;

/// Where `index.html` says that a file comes from; in the page they all lie in one folder.
const STATIC: &str = "static/";
const INDEX: &str = "index.html";

/// A page's files by their addresses.
#[derive(Debug, Default, Clone, PartialEq, Eq)]
pub(crate) struct Page(pub(crate) BTreeMap<String, Vec<u8>>);

/// What style sheets are called. A published name changes with what is in the file, so that no cache holds an old
/// one.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Naming {
    Plain,
    ByContent,
}

impl Page {
    /// Puts the page together from the program and the repository's own files.
    pub(crate) fn assemble(shell: &Shell, program: &Program, naming: Naming) -> Result<Self> {
        let index = shell.root.join(INDEX);
        let html = fs::read_to_string(&index).with_context(|| format!("reading {}", index.display()))?;
        Self::of(&html, Self::read(&shell.root.join(STATIC))?, program, naming)
    }

    fn of(html: &str, statics: Self, program: &Program, naming: Naming) -> Result<Self> {
        let mut files = program.files.0.clone();
        let mut names: Vec<_> = program.names().map(|(plain, name)| (plain.to_owned(), name)).collect();
        for (address, content) in statics.0 {
            let name = match (naming, address.rsplit_once('.')) {
                (Naming::ByContent, Some((stem, "css"))) => format!("{stem}-{}.css", hash([&content])),
                _ => address.clone(),
            };
            names.push((format!("{STATIC}{address}"), name.clone()));
            files.insert(name, content);
        }
        files.insert(INDEX.to_owned(), fill_in(html, &names)?.into_bytes());
        Ok(Self(files))
    }

    /// Every file below a folder.
    pub(crate) fn read(folder: &Path) -> Result<Self> {
        let mut page = Self::default();
        page.walk(folder, "")?;
        Ok(page)
    }

    fn walk(&mut self, folder: &Path, prefix: &str) -> Result<()> {
        for entry in fs::read_dir(folder).with_context(|| format!("reading {}", folder.display()))? {
            let entry = entry?;
            let address = format!("{prefix}{}", entry.file_name().to_string_lossy());
            if entry.file_type()?.is_dir() {
                self.walk(&entry.path(), &format!("{address}/"))?;
            } else {
                self.0.insert(address, fs::read(entry.path())?);
            }
        }
        Ok(())
    }

    /// Makes the folder hold these files, and nothing else.
    pub(crate) fn write(&self, folder: &Path) -> Result<()> {
        let writing = || format!("writing {}", folder.display());
        if folder.exists() {
            fs::remove_dir_all(folder).with_context(writing)?;
        }
        fs::create_dir_all(folder).with_context(writing)?;
        for (address, content) in &self.0 {
            let path = folder.join(address);
            fs::create_dir_all(path.parent().unwrap_or(folder)).with_context(writing)?;
            fs::write(path, content).with_context(writing)?;
        }
        Ok(())
    }

    /// A text among the files.
    pub(crate) fn text(&self, address: &str) -> Result<&str> {
        let content = self.0.get(address).with_context(|| format!("the page has no {address}"))?;
        std::str::from_utf8(content).with_context(|| format!("{address} is no text"))
    }

    /// Changes a text among the files.
    pub(crate) fn edit(&mut self, address: &str, edit: impl FnOnce(&str) -> Result<String>) -> Result<()> {
        let text = edit(self.text(address)?)?;
        self.0.insert(address.to_owned(), text.into_bytes());
        Ok(())
    }

    pub(crate) fn edit_index(&mut self, edit: impl FnOnce(&str) -> Result<String>) -> Result<()> {
        self.edit(INDEX, edit)
    }
}

/// Sixteen digits that change when any content does.
pub(crate) fn hash<'a>(contents: impl IntoIterator<Item = &'a Vec<u8>>) -> String {
    let mut hash = Sha256::new();
    contents.into_iter().for_each(|content| hash.update(Sha256::digest(content)));
    hash.finalize().iter().take(8).map(|byte| format!("{byte:02x}")).collect()
}

/// Puts the names that files have in the page in the place of those that they have in the repository.
fn fill_in(html: &str, names: &[(String, String)]) -> Result<String> {
    let filled = names.iter().fold(without_comments(html), |html, (plain, name)| {
        html.replace(&format!("\"{plain}\""), &format!("\"{name}\""))
            .replace(&format!("\"./{plain}\""), &format!("\"./{name}\""))
    });
    if let Some((_, after)) = filled.split_once(&format!("=\"{STATIC}")) {
        let name = after.split('"').next().unwrap_or_default();
        bail!("index.html names {STATIC}{name}, and there's no such file; correct the name, or add the file");
    }
    Ok(filled)
}

/// What is told to those who read the source is no part of the page.
fn without_comments(html: &str) -> String {
    let mut kept = String::new();
    let mut rest = html;
    while let Some((before, comment)) = rest.split_once("<!--") {
        kept += before.trim_end_matches(' ');
        rest = comment.split_once("-->").map_or("", |(_, after)| after).trim_start_matches('\n');
    }
    kept + rest
}

#[cfg(test)]
mod tests {
    use super::*;

    const HTML: &str = "<!doctype html>\n  <!-- Colours\n  first. -->\n  <link href=\"static/a.css\">\n\
        <script src=\"static/b.js\"></script>\n<link href=\"line-maze-lab.js\">\n\
        <script>import start from \"./line-maze-lab.js\"; start(\"./line-maze-lab_bg.wasm\");</script>";

    fn files(pairs: &[(&str, &str)]) -> Page {
        Page(pairs.iter().map(|(name, text)| ((*name).into(), (*text).into())).collect())
    }

    fn program() -> Program {
        Program {
            stem: "line-maze-lab-77".into(),
            files: files(&[("line-maze-lab-77.js", ""), ("line-maze-lab-77_bg.wasm", "")]),
        }
    }

    #[test]
    fn the_page_names_what_it_has() {
        let statics = files(&[("a.css", "a{}"), ("b.js", "b()"), ("icon.png", "")]);
        let page = Page::of(HTML, statics.clone(), &program(), Naming::Plain).unwrap();
        let html = page.text(INDEX).unwrap();
        let expected = "<!doctype html>\n  <link href=\"a.css\">\n<script src=\"b.js\"></script>\n\
            <link href=\"line-maze-lab-77.js\">\n<script>import start from \"./line-maze-lab-77.js\"; \
            start(\"./line-maze-lab-77_bg.wasm\");</script>";
        assert_eq!(html, expected);
        let names: Vec<_> = page.0.keys().map(String::as_str).collect();
        assert_eq!(
            names,
            ["a.css", "b.js", "icon.png", "index.html", "line-maze-lab-77.js", "line-maze-lab-77_bg.wasm"]
        );
        let published = Page::of(HTML, statics, &program(), Naming::ByContent).unwrap();
        let name = format!("a-{}.css", hash([&b"a{}".to_vec()]));
        assert!(published.text(INDEX).unwrap().contains(&format!("<link href=\"{name}\">")));
        assert!(published.0.contains_key(&name) && !published.0.contains_key("a.css"));
        assert!(published.0.contains_key("b.js"));
    }

    #[test]
    fn a_file_that_is_not_there_is_told() {
        let error = Page::of(HTML, files(&[("b.js", "")]), &program(), Naming::Plain).unwrap_err();
        assert!(error.to_string().contains("index.html names static/a.css"), "{error}");
    }

    #[test]
    fn a_name_follows_the_content() {
        let (one, two) = (b"1".to_vec(), b"2".to_vec());
        assert_eq!(hash([&one]).len(), 16);
        assert_eq!(hash([&one, &two]), hash([&one, &two]));
        assert_ne!(hash([&one, &two]), hash([&two, &one]));
    }
}
