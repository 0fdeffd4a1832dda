//! Running other programs: where they are, what they print, how they end.

use std::env;
use std::ffi::{OsStr, OsString};
use std::io::{BufRead, BufReader};
use std::path::{Path, PathBuf};
use std::process::{Command, Stdio};
use std::thread::sleep;
use std::time::{Duration, Instant};

use anyhow::{Context, Result, anyhow, bail};

/// The workspace's folder and a search path that begins with the tools kept in `target/tools`.
#[derive(Debug)]
pub(crate) struct Shell {
    pub(crate) root: PathBuf,
    path: OsString,
}

/// How a program ended and what it wrote to its standard output.
pub(crate) struct Finished {
    pub(crate) ok: bool,
    pub(crate) output: String,
}

impl Shell {
    pub(crate) fn at_workspace_root() -> Result<Self> {
        let root = Path::new(env!("CARGO_MANIFEST_DIR")).parent().context("xtask lies in no workspace")?;
        Ok(Self { path: search_path(root)?, root: root.to_path_buf() })
    }

    /// The folder for tools of this project that should not disturb the rest of the computer.
    pub(crate) fn tools(&self) -> PathBuf {
        self.root.join("target/tools")
    }

    /// Where cargo builds, and what this project builds goes too.
    pub(crate) fn target(&self) -> PathBuf {
        env::var_os("CARGO_TARGET_DIR")
            .map_or_else(|| self.root.join("target"), |target| self.root.join(target))
    }

    pub(crate) fn cargo(&self) -> Command {
        self.command(env::var_os("CARGO").unwrap_or_else(|| "cargo".into()))
    }

    pub(crate) fn command(&self, program: impl AsRef<OsStr>) -> Command {
        let mut command =
            Command::new(self.find(program.as_ref()).unwrap_or_else(|| program.as_ref().into()));
        command.current_dir(&self.root).env("PATH", &self.path);
        command
    }

    /// The full path of a program on the search path.
    pub(crate) fn find(&self, program: impl AsRef<OsStr>) -> Option<PathBuf> {
        let program = program.as_ref();
        let endings: &[&str] = if cfg!(windows) { &[".exe", ".cmd"] } else { &[""] };
        env::split_paths(&self.path)
            .flat_map(|folder| endings.iter().map(move |ending| (folder.clone(), ending)))
            .map(|(folder, ending)| {
                let mut name = program.to_owned();
                name.push(ending);
                folder.join(name)
            })
            .find(|path| path.is_file())
    }

    /// What a program prints, if it's there and content.
    pub(crate) fn ask(&self, program: &str, args: &[&str]) -> Option<String> {
        let output = self.command(program).args(args).stderr(Stdio::null()).output().ok()?;
        output.status.success().then(|| String::from_utf8_lossy(&output.stdout).trim().to_owned())
    }
}

fn search_path(root: &Path) -> Result<OsString> {
    let tools = root.join("target/tools");
    let ours = [tools.join("bin"), tools.join("node_modules/.bin")];
    let theirs = env::var_os("PATH").unwrap_or_default();
    Ok(env::join_paths(ours.into_iter().chain(env::split_paths(&theirs)))?)
}

/// What a person can do about an error.
pub(crate) trait Cure<T> {
    fn cure(self, cure: &str) -> Result<T>;
}

impl<T> Cure<T> for Result<T> {
    fn cure(self, cure: &str) -> Self {
        self.map_err(|error| anyhow!("{error:#}\n  cure: {cure}"))
    }
}

/// Runs a command in full view; an error unless it succeeds.
pub(crate) fn run(command: &mut Command) -> Result<()> {
    let status = command.status().with_context(|| format!("could not start {}", name(command)))?;
    if !status.success() {
        bail!("{} failed ({status})", line(command));
    }
    Ok(())
}

/// Like [`run`], but shows what the command writes only if it fails.
pub(crate) fn run_quietly(command: &mut Command) -> Result<()> {
    let output = command.output().with_context(|| format!("could not start {}", name(command)))?;
    if !output.status.success() {
        bail!("{} failed ({})\n{}", line(command), output.status, String::from_utf8_lossy(&output.stderr));
    }
    Ok(())
}

/// Like [`run`], but gives back what the command prints.
pub(crate) fn printed(command: &mut Command) -> Result<String> {
    command.stderr(Stdio::inherit());
    let output = command.output().with_context(|| format!("could not start {}", name(command)))?;
    if !output.status.success() {
        bail!("{} failed ({})", line(command), output.status);
    }
    Ok(String::from_utf8_lossy(&output.stdout).into_owned())
}

/// Like [`run`], but ends the command when it takes longer than `limit`.
pub(crate) fn run_within(command: &mut Command, limit: Duration) -> Result<()> {
    let mut child = command.spawn().with_context(|| format!("could not start {}", name(command)))?;
    let start = Instant::now();
    loop {
        match child.try_wait()? {
            Some(status) if status.success() => return Ok(()),
            Some(status) => bail!("{} failed ({status})", line(command)),
            None if start.elapsed() > limit => {
                child.kill()?;
                child.wait()?;
                bail!("{} gave no answer within {} s", line(command), limit.as_secs());
            }
            None => sleep(Duration::from_millis(50)),
        }
    }
}

/// Keeps a command's standard output, and shows at once those lines that `show` picks.
pub(crate) fn watch(command: &mut Command, mut show: impl FnMut(&str) -> bool) -> Result<Finished> {
    let mut child = command
        .stdout(Stdio::piped())
        .spawn()
        .with_context(|| format!("could not start {}", name(command)))?;
    let mut output = String::new();
    if let Some(stdout) = child.stdout.take() {
        for line in BufReader::new(stdout).split(b'\n') {
            let line = line?;
            let line = String::from_utf8_lossy(&line);
            if show(&line) {
                println!("{line}");
            }
            output.push_str(&line);
            output.push('\n');
        }
    }
    Ok(Finished { ok: child.wait()?.success(), output })
}

/// The command as a person would type it.
pub(crate) fn line(command: &Command) -> String {
    let args = command.get_args().map(|arg| arg.to_string_lossy().into_owned());
    std::iter::once(name(command)).chain(args).collect::<Vec<_>>().join(" ")
}

fn name(command: &Command) -> String {
    let program = Path::new(command.get_program());
    program.file_stem().unwrap_or(program.as_os_str()).to_string_lossy().into_owned()
}
