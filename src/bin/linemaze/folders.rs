//! The files in folders, and in the folders in them: what the league runs over.

use std::collections::HashSet;
use std::fs;
use std::io;
use std::path::{Path, PathBuf};

use crate::{complain, why};

/// Files, in the order of their names, folder by folder.
#[derive(Default)]
pub(crate) struct Files {
    /// What was found.
    pub(crate) found: Vec<PathBuf>,
    /// How many folders could not be read or hold no file; they are named on standard error.
    pub(crate) unusable: usize,
    /// Folders by their true names: links can lead back to where they are.
    seen: HashSet<PathBuf>,
}

impl Files {
    /// The files that are named, and those in the folders that are.
    pub(crate) fn of(paths: &[PathBuf]) -> Self {
        let mut files = Self::default();
        for path in paths {
            // What is named twice runs twice.
            files.seen.clear();
            if !path.is_dir() {
                files.found.push(path.clone());
                continue;
            }
            let before = (files.found.len(), files.unusable);
            files.folder(path);
            if before == (files.found.len(), files.unusable) {
                files.unusable += 1;
                complain(&format!(
                    "{}: this folder holds no files, but for names that begin with a dot; name the files, or another \
                     folder",
                    path.display()
                ));
            }
        }
        files
    }

    fn folder(&mut self, path: &Path) {
        let inside = path
            .canonicalize()
            .and_then(|real| if self.seen.insert(real) { inside(path) } else { Ok(Vec::new()) });
        match inside {
            Ok(inside) => inside.iter().for_each(|path| self.entry(path)),
            Err(error) => {
                self.unusable += 1;
                complain(&format!("{}: {}", path.display(), why(&error)));
            }
        }
    }

    fn entry(&mut self, path: &Path) {
        if path.is_dir() {
            self.folder(path);
        } else if path.is_file() {
            self.found.push(path.to_owned());
        }
    }
}

/// What is in a folder, by name, but for what systems and editors hide there.
fn inside(folder: &Path) -> io::Result<Vec<PathBuf>> {
    let mut inside = Vec::new();
    for entry in fs::read_dir(folder)? {
        let entry = entry?;
        if !entry.file_name().to_string_lossy().starts_with('.') {
            inside.push(entry.path());
        }
    }
    inside.sort();
    Ok(inside)
}
