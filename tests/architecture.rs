//! What ARCHITECTURE.md promises, as far as a text can show it.
#![allow(clippy::unwrap_used, clippy::expect_used)]

use std::fs;
use std::path::{Path, PathBuf};

/// Every file below a folder of the project with this ending.
fn files(folder: &str, ending: &str) -> Vec<PathBuf> {
    let mut todo = vec![Path::new(env!("CARGO_MANIFEST_DIR")).join(folder)];
    let mut found = Vec::new();
    while let Some(path) = todo.pop() {
        if path.is_dir() {
            todo.extend(fs::read_dir(&path).unwrap().map(|entry| entry.unwrap().path()));
        } else if path.to_string_lossy().ends_with(ending) {
            found.push(path);
        }
    }
    assert!(!found.is_empty(), "no {ending} files in {folder}");
    found
}

/// The lines of code that hold one of the words, as `file:line: text`.
fn lines_with(files: &[PathBuf], words: &[&str]) -> Vec<String> {
    let mut found = Vec::new();
    for file in files {
        let text = fs::read_to_string(file).unwrap();
        for (number, line) in (1..).zip(text.lines()) {
            let code = !line.trim_start().starts_with("//");
            if code && words.iter().any(|word| line.contains(word)) {
                found.push(format!("{}:{number}: {}", file.display(), line.trim()));
            }
        }
    }
    found
}

#[test]
fn an_explorer_cannot_see_the_maze() {
    let mut explorers = files("src/explorer", ".rs");
    explorers.push(Path::new(env!("CARGO_MANIFEST_DIR")).join("src/explorer.rs"));
    explorers.retain(|file| {
        // The words about a run are told of a finished trace; they decide nothing.
        let path = file.to_string_lossy();
        !path.contains("narrate") && !path.contains("errata")
    });
    let none: Vec<String> = Vec::new();
    assert_eq!(lines_with(&explorers, &["crate::maze", "crate::world", "crate::route", "crate::run"]), none);
}

#[test]
fn the_robots_end_of_the_link_needs_no_heap() {
    let robot = |file: &PathBuf| {
        let path = file.to_string_lossy().replace('\\', "/");
        let own = ["fields", "frame", "keep", "report", "request", "robot", "tune"];
        own.iter().any(|name| {
            path.ends_with(&format!("src/link/{name}.rs")) || path.contains(&format!("src/link/{name}/"))
        })
    };
    let mut files = files("src/link", ".rs");
    files.retain(robot);
    files.push(Path::new(env!("CARGO_MANIFEST_DIR")).join("src/explorer/book/store.rs"));
    assert_eq!(files.len(), 13, "{files:?}");
    let none: Vec<String> = Vec::new();
    let heap =
        ["alloc", "Vec<", "vec!", "String", "Box<", "format!", "crate::world", "crate::maze", "crate::run"];
    assert_eq!(lines_with(&files, &heap), none);
}

#[test]
fn the_core_knows_no_browser_and_no_command_line() {
    let mut core = files("src", ".rs");
    core.retain(|file| {
        let path = file.to_string_lossy();
        !path.contains("/web") && !path.contains("/bin/") && !path.ends_with("main.rs")
    });
    let none: Vec<String> = Vec::new();
    assert_eq!(lines_with(&core, &["leptos", "web_sys", "wasm_bindgen", "clap"]), none);
}

#[test]
fn colours_stand_in_the_tokens_only() {
    let mut sheets = files("static", ".css");
    sheets.retain(|file| !file.ends_with("tokens.css"));
    let literal = |line: &String| {
        let text = line.split_once(": ").map_or("", |(_, text)| text);
        let hex = text.match_indices('#').any(|(at, _)| {
            let digits = text[at + 1..].chars().take_while(char::is_ascii_hexdigit).count();
            let ends = !text[at + 1 + digits..].starts_with(|c: char| c.is_alphanumeric() || c == '-');
            matches!(digits, 3 | 4 | 6 | 8) && ends
        });
        hex || text.contains("rgb(") || text.contains("hsl(")
    };
    let colours: Vec<String> =
        lines_with(&sheets, &["#", "rgb(", "hsl("]).into_iter().filter(literal).collect();
    assert_eq!(colours, Vec::<String>::new());
}

#[test]
fn views_use_no_inline_styles() {
    // The Content-Security-Policy would drop them.
    let none: Vec<String> = Vec::new();
    assert_eq!(lines_with(&files("src/web", ".rs"), &[" style=", "set_attribute(\"style\""]), none);
}
