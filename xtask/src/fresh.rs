//! `cargo xtask fresh`: what happens to a person who tries the project on a computer that has only Rust. A clone in
//! an empty folder, an empty cargo home, an empty home; the README's two commands.

use std::env;
use std::ffi::OsStr;
use std::fs;
use std::io::{BufRead, BufReader};
use std::path::{Path, PathBuf};
use std::process::{Child, Command, Stdio};
use std::sync::mpsc::{RecvTimeoutError, channel};
use std::thread;
use std::time::{Duration, Instant};

use anyhow::{Context, Result, bail, ensure};

use crate::fetch::fetch;
use crate::shell::{Cure, Shell, line, printed, run};
use crate::summary::Counts;
use crate::tools::say;

/// From the first command to the page. On two idle cores it takes half of this.
const LIMIT: Duration = Duration::from_secs(6 * 60);
/// The program without its optimizations is larger by far; a page of the server's own is smaller.
const SMALLEST_WASM: usize = 500_000;
/// What begins the line with the address.
const ADDRESS: &str = "http://localhost:";

/// Tries both commands; each counts one.
pub(crate) fn fresh(shell: &Shell) -> Result<Counts> {
    let place = Place::new(shell)?;
    let readme = fs::read_to_string(place.clone.join("README.md")).context("the clone has no README.md")?;
    let [first, second] = commands(&readme)?;
    say(&format!("The first command, `{}`, with nothing downloaded and nothing built", first.join(" ")));
    let start = Instant::now();
    let wasm = first_command(&place, &first)?;
    let took = start.elapsed().as_secs();
    println!("  the page answers after {took} s, with {} kB of wasm", wasm / 1000);
    say(&format!("The second, `{} native`", second.join(" ")));
    let start = Instant::now();
    run(place.command(&second).arg("native"))?;
    println!("  done after {} s", start.elapsed().as_secs());
    Ok(Counts { passed: 2, ..Counts::default() })
}

/// The first two commands that the README shows, in words.
fn commands(readme: &str) -> Result<[Vec<String>; 2]> {
    let words = |line: &str| {
        let command = line.split('#').next().unwrap_or_default();
        command.split_whitespace().map(str::to_owned).collect::<Vec<_>>()
    };
    let block = readme.split("```").nth(1).context("the README shows no command")?;
    let mut commands = block.lines().skip(1).map(words).filter(|words| !words.is_empty());
    match (commands.next(), commands.next()) {
        (Some(first), Some(second)) => Ok([first, second]),
        _ => bail!("the README's first block of commands has to show two"),
    }
}

/// Runs the server until its page answers; the size of its wasm.
fn first_command(place: &Place, words: &[String]) -> Result<usize> {
    let mut command = place.command(words);
    let mut server = Server::start(&mut command)?;
    let port = server.port()?;
    // Who reads the address opens it at once: there is no second try.
    let index = String::from_utf8_lossy(&fetch(port, "")?).into_owned();
    let script = String::from_utf8_lossy(&fetch(port, named(&index, ".js")?)?).into_owned();
    ensure!(script.contains("WebAssembly"), "the page's script is something else");
    let wasm = fetch(port, named(&index, "_bg.wasm")?)?;
    ensure!(wasm.starts_with(b"\0asm"), "the page's wasm is something else");
    ensure!(wasm.len() > SMALLEST_WASM, "the page's wasm has only {} bytes", wasm.len());
    Ok(wasm.len())
}

/// The program's file with this ending, as the page names it.
fn named<'a>(index: &'a str, ending: &str) -> Result<&'a str> {
    let mut names = index.split('"').filter(|name| name.contains("line-maze-lab") && name.ends_with(ending));
    names
        .next()
        .map(|name| name.trim_start_matches("./"))
        .with_context(|| format!("the page names no {ending}"))
}

/// A folder with a clone and a home, both gone in the end.
struct Place {
    folder: PathBuf,
    clone: PathBuf,
    home: PathBuf,
}

impl Place {
    /// Outside of the repository: cargo reads the settings of all folders above it.
    fn new(shell: &Shell) -> Result<Self> {
        let folder = env::temp_dir().join(format!("line-maze-lab-fresh-{}", std::process::id()));
        let place = Self { clone: folder.join("lab"), home: folder.join("home"), folder };
        fs::create_dir_all(&place.home).with_context(|| format!("making {}", place.home.display()))?;
        say(&format!("Cloning into {}", place.clone.display()));
        let git = || shell.command("git");
        run(git().args(["clone", "--quiet", "--no-hardlinks", "."]).arg(&place.clone))
            .cure("this chore needs git, and a repository")?;
        let changes = printed(git().args(["diff", "HEAD", "--binary"]))?;
        if !changes.is_empty() {
            say("With the changes that are not committed yet");
            let patch = place.folder.join("changes");
            fs::write(&patch, changes)?;
            run(git().current_dir(&place.clone).arg("apply").arg(&patch))?;
        }
        place.keep_the_way_to_the_registry()?;
        Ok(place)
    }

    /// How this computer reaches a registry is its own affair.
    fn keep_the_way_to_the_registry(&self) -> Result<()> {
        let Some(home) = home_of("CARGO_HOME", ".cargo") else { return Ok(()) };
        for name in ["config.toml", "config"] {
            let config = home.join(name);
            if config.is_file() {
                fs::create_dir_all(self.home.join(".cargo"))?;
                fs::copy(config, self.home.join(".cargo").join(name))?;
            }
        }
        Ok(())
    }

    /// A command in the clone, that knows of nothing else but Rust.
    fn command(&self, words: &[String]) -> Command {
        let mut words = words.iter();
        let mut command = Command::new(words.next().map_or("", |program| program));
        command.args(words).current_dir(&self.clone).env("HOME", &self.home);
        for (variable, _) in env::vars_os().filter(|(variable, _)| is_of_a_build(variable)) {
            command.env_remove(variable);
        }
        if let Some(rustup) = home_of("RUSTUP_HOME", ".rustup") {
            command.env("RUSTUP_HOME", rustup);
        }
        command
    }
}

impl Drop for Place {
    fn drop(&mut self) {
        let _ = fs::remove_dir_all(&self.folder);
    }
}

/// What a build is told by those who start it, but not how to reach a registry.
fn is_of_a_build(variable: &OsStr) -> bool {
    let name = variable.to_string_lossy();
    let reaches = ["CARGO_HTTP_", "CARGO_NET_", "CARGO_SOURCE_", "CARGO_REGISTRIES_", "CARGO_REGISTRY_"];
    let builds = ["CARGO", "RUSTC", "RUSTFLAGS", "RUSTDOCFLAGS"];
    builds.iter().any(|prefix| name.starts_with(prefix))
        && !reaches.iter().any(|prefix| name.starts_with(prefix))
}

fn home_of(variable: &str, folder: &str) -> Option<PathBuf> {
    env::var_os(variable).map(PathBuf::from).or_else(|| Some(Path::new(&env::var_os("HOME")?).join(folder)))
}

/// The server that a person started, and all that it started; it ends with this.
struct Server {
    child: Child,
    line: String,
}

impl Server {
    fn start(command: &mut Command) -> Result<Self> {
        #[cfg(unix)]
        std::os::unix::process::CommandExt::process_group(command, 0);
        let line = line(command);
        let child = command.stdout(Stdio::piped()).stdin(Stdio::null()).spawn();
        Ok(Self { child: child.with_context(|| format!("could not start {line}"))?, line })
    }

    /// The port in the address that it says, when it says it in time.
    fn port(&mut self) -> Result<u16> {
        let stdout = self.child.stdout.take().context("the command's output is taken")?;
        let (sender, lines) = channel();
        thread::spawn(move || {
            for line in BufReader::new(stdout).lines().map_while(Result::ok) {
                println!("  {line}");
                if let Some(port) = port(&line) {
                    let _ = sender.send(port);
                }
            }
        });
        match lines.recv_timeout(LIMIT) {
            Ok(port) => Ok(port),
            Err(RecvTimeoutError::Timeout) => {
                bail!("{} said no address within {} s", self.line, LIMIT.as_secs())
            }
            Err(RecvTimeoutError::Disconnected) => {
                bail!("{} ended ({}) and said no address", self.line, self.child.wait()?)
            }
        }
    }
}

impl Drop for Server {
    fn drop(&mut self) {
        #[cfg(unix)]
        let _ = Command::new("kill").args(["-TERM", "--", &format!("-{}", self.child.id())]).status();
        let _ = self.child.kill();
        let _ = self.child.wait();
    }
}

fn port(line: &str) -> Option<u16> {
    let (_, after) = line.split_once(ADDRESS)?;
    after.split(|c: char| !c.is_ascii_digit()).next()?.parse().ok()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_readme_says_what_is_tried() {
        let [first, second] = commands(include_str!("../../README.md")).unwrap();
        assert_eq!(
            (first.join(" "), second.join(" ")),
            ("cargo xtask serve".into(), "cargo xtask test".into())
        );
        assert!(commands("```\ncargo xtask serve # the lab\n```").is_err());
    }

    #[test]
    fn the_address_is_read_from_what_is_said() {
        assert_eq!(port("  Line Maze Lab is at  http://localhost:8083/  (Ctrl+C ends it)"), Some(8083));
        assert_eq!(port("→ Building the lab; its address follows"), None);
    }

    #[test]
    fn the_pages_files_are_found_by_their_endings() {
        let index = r#"<script src="theme.js"></script><link href="./line-maze-lab-12.js"><link href="line-maze-lab-12_bg.wasm">"#;
        assert_eq!(named(index, ".js").unwrap(), "line-maze-lab-12.js");
        assert_eq!(named(index, "_bg.wasm").unwrap(), "line-maze-lab-12_bg.wasm");
        assert!(named("<p>", ".js").is_err());
    }

    #[test]
    fn a_build_begins_with_nothing_but_a_way_to_the_registry() {
        for left_out in
            ["CARGO_HOME", "CARGO_TARGET_DIR", "CARGO", "RUSTC_WRAPPER", "RUSTFLAGS", "CARGO_PKG_NAME"]
        {
            assert!(is_of_a_build(OsStr::new(left_out)), "{left_out}");
        }
        for kept in ["PATH", "RUSTUP_HOME", "CARGO_HTTP_PROXY", "HTTPS_PROXY", "CARGO_NET_OFFLINE"] {
            assert!(!is_of_a_build(OsStr::new(kept)), "{kept}");
        }
    }
}
