//! Which saved files make the page new.

use std::collections::BTreeSet;
use std::fs;
use std::path::{Path, PathBuf};
use std::sync::mpsc::{Receiver, RecvTimeoutError, channel};
use std::time::Duration;

use anyhow::{Context, Result, bail};
use notify::{Event, EventKind, RecommendedWatcher, RecursiveMode, Watcher};

use crate::shell::Shell;

/// Editors save in several steps, and people several files.
const QUIET: Duration = Duration::from_millis(40);

/// What has to be made anew.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
pub(crate) enum Change {
    /// Style sheets, scripts and the page around the program.
    Page,
    /// The program, which cargo has to compile.
    Program,
}

/// Sees every saved file of the repository, from the moment it begins.
pub(crate) struct Watch {
    root: PathBuf,
    events: Receiver<notify::Result<Event>>,
    /// It sees as long as it lives.
    _watcher: RecommendedWatcher,
}

impl Watch {
    pub(crate) fn begin(shell: &Shell) -> Result<Self> {
        let (sender, events) = channel();
        let mut watcher =
            notify::recommended_watcher(sender).context("this system tells of no saved files")?;
        let root = shell.root.canonicalize().context("the repository is gone")?;
        watcher.watch(&root, RecursiveMode::NonRecursive).context("watching the repository")?;
        for entry in fs::read_dir(&root)? {
            let entry = entry?;
            let name = entry.file_name();
            let built = ["target", "dist", "node_modules"].iter().any(|built| name == *built);
            let hidden = name.to_string_lossy().starts_with('.') && name != ".cargo";
            if entry.file_type()?.is_dir() && !built && !hidden {
                let watching = || format!("watching {}", entry.path().display());
                watcher.watch(&entry.path(), RecursiveMode::Recursive).with_context(watching)?;
            }
        }
        Ok(Self { root, events, _watcher: watcher })
    }

    /// Waits until something is saved that the page is made of. `sources` are the program's, by their first names.
    pub(crate) fn next(&self, sources: &BTreeSet<PathBuf>) -> Result<Change> {
        let mut change = None;
        loop {
            let event = match change {
                None => self.events.recv().map_err(|_| RecvTimeoutError::Disconnected),
                Some(_) => self.events.recv_timeout(QUIET),
            };
            match (event, change) {
                (Ok(event), _) => change = change.max(self.change(&event?, sources)),
                (Err(RecvTimeoutError::Timeout), Some(change)) => return Ok(change),
                (Err(RecvTimeoutError::Timeout), None) => {}
                (Err(RecvTimeoutError::Disconnected), _) => bail!("this system tells of saved files no more"),
            }
        }
    }

    fn change(&self, event: &Event, sources: &BTreeSet<PathBuf>) -> Option<Change> {
        // Cargo reads all of them.
        if matches!(event.kind, EventKind::Access(_)) {
            return None;
        }
        event.paths.iter().filter_map(|path| change_at(path.strip_prefix(&self.root).ok()?, sources)).max()
    }
}

fn change_at(path: &Path, sources: &BTreeSet<PathBuf>) -> Option<Change> {
    let first = path.iter().next()?;
    if first == "static" || path == Path::new("index.html") {
        return Some(Change::Page);
    }
    let cargos = [".cargo", "Cargo.lock", "Cargo.toml"].iter().any(|name| first == *name);
    (cargos || sources.contains(Path::new(first))).then_some(Change::Program)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn only_what_the_page_is_made_of_counts() {
        let sources = BTreeSet::from(["src".into(), "mazes".into()]);
        let at = |path: &str| change_at(Path::new(path), &sources);
        for page in ["static/app.css", "static/theme.js", "index.html"] {
            assert_eq!(at(page), Some(Change::Page), "{page}");
        }
        for program in ["src/web/app.rs", "mazes/new.maze", "Cargo.toml", "Cargo.lock", ".cargo/config.toml"]
        {
            assert_eq!(at(program), Some(Change::Program), "{program}");
        }
        for other in
            ["README.md", "tests/web.rs", "target/page/index.html", "docs/index.html", "xtask/src/main.rs"]
        {
            assert_eq!(at(other), None, "{other}");
        }
    }
}
