//! A serial port with a robot at its other end: `umockdev` shows the browser a port that is not there, and its
//! bytes are those of a pseudo-terminal that `linemaze robot` speaks on. The browser uses its real Web Serial.

use std::io::{BufRead, BufReader, Write};
use std::path::{Path, PathBuf};
use std::process::{Child, ChildStdin, Command, Stdio};
use std::sync::atomic::{AtomicU32, Ordering};
use std::sync::mpsc::{Receiver, channel};
use std::time::{Duration, Instant};

use anyhow::{Context, Result, bail, ensure};
use serde_json::{Value, json};

use crate::{named, root};

const PATIENCE: Duration = Duration::from_secs(30);

/// Where the port is.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Bus {
    /// An Arduino Uno on USB, which the page may open without asking.
    Usb,
    /// The same, but the browser asks.
    UsbUnknown,
    /// A port without USB ids; the browser asks.
    Other,
}

/// A mocked port and its robot.
#[derive(Debug)]
pub struct Bench {
    robot: Option<Child>,
    board: Child,
    orders: ChildStdin,
    answers: Receiver<String>,
    pty: PathBuf,
    folder: PathBuf,
    pub(crate) mocked: PathBuf,
    pub(crate) bus: Bus,
}

/// The library that mocks devices, where it is installed.
pub(crate) fn preload() -> Option<PathBuf> {
    let folders = std::fs::read_dir("/usr/lib").ok()?.flatten().map(|entry| entry.path());
    let mut libraries = folders.map(|folder| folder.join("libumockdev-preload.so.0"));
    libraries.find(|library| library.exists())
}

/// Whether a test must not be left out.
pub(crate) fn on_ci() -> bool {
    std::env::var_os("CI").is_some_and(|value| value == "true")
}

/// A test's bench, or a word that it is left out.
///
/// # Errors
/// On CI without `umockdev`, and where a program does not start.
pub fn bench(bus: Bus, robot: &[&str]) -> Result<Option<Bench>> {
    if preload().is_none() {
        ensure!(!on_ci(), "there's no umockdev; `cargo xtask test e2e` installs it on Debian");
        eprintln!("LEFT OUT: there's no umockdev here, so no serial port can be mocked");
        return Ok(None);
    }
    Bench::start(bus, robot).map(Some)
}

impl Bench {
    fn start(bus: Bus, robot: &[&str]) -> Result<Self> {
        static COUNT: AtomicU32 = AtomicU32::new(0);
        let number = COUNT.fetch_add(1, Ordering::Relaxed);
        let folder = std::env::temp_dir().join(format!("line-maze-bench-{}-{number}", std::process::id()));
        std::fs::create_dir_all(&folder)?;
        let pty = folder.join("robot");
        let running = run_robot(&pty, robot)?;
        let library = preload().context("no umockdev")?;
        let mut command = Command::new("/usr/bin/python3");
        command.arg(Path::new(env!("CARGO_MANIFEST_DIR")).join("serial/board.py")).arg(&pty);
        if bus == Bus::Other {
            command.arg("--off-usb");
        }
        // What it mocks goes with the bench.
        command
            .env("LD_PRELOAD", library)
            .env("TMPDIR", &folder)
            .stdin(Stdio::piped())
            .stdout(Stdio::piped());
        let mut board = command.spawn().context("starting board.py")?;
        let orders = board.stdin.take().context("board.py is deaf")?;
        let answers = lines_of(board.stdout.take().context("board.py is mute")?);
        let mocked = PathBuf::from(answers.recv_timeout(PATIENCE).context("board.py says no folder")?);
        Ok(Self { robot: Some(running), board, orders, answers, pty, folder, mocked, bus })
    }

    fn order(&mut self, word: &str) -> Result<()> {
        writeln!(self.orders, "{word}")?;
        let answer = self.answers.recv_timeout(PATIENCE).with_context(|| format!("no answer to {word}"))?;
        ensure!(answer == format!("done {word}"), "board.py answered {answer}");
        Ok(())
    }

    /// Pulls the cable: the bytes end, and the system says that the port has gone. One off USB stays where it is, as
    /// that of a Bluetooth module does whose robot is away; the permission for one that goes goes with it.
    ///
    /// # Errors
    /// If the bench does not obey.
    pub fn unplug(&mut self) -> Result<()> {
        end(self.robot.take());
        if self.bus == Bus::Other { Ok(()) } else { self.order("unplug") }
    }

    /// Plugs it in again, with a robot like this at its end.
    ///
    /// # Errors
    /// If the robot does not start.
    pub fn plug(&mut self, robot: &[&str]) -> Result<()> {
        end(self.robot.take());
        self.robot = Some(run_robot(&self.pty, robot)?);
        if self.bus == Bus::Other { Ok(()) } else { self.order("plug") }
    }

    /// What the browser's profile holds at the beginning: the permission for this origin; and an empty page, as the
    /// usual one asks the network for things, and the driver may wait for them in vain.
    pub(crate) fn preferences(&self, origin: &str) -> Value {
        let uno = json!({
            "name": "Arduino Uno", "product_id": 0x0043, "serial_number": "LAB0001", "vendor_id": 0x2341,
        });
        let granted = json!({ "last_modified": "13400000000000000", "setting": { "chosen-objects": [uno] } });
        let pattern = format!("{origin},*");
        let ports = if self.bus == Bus::Usb { json!({ pattern: granted }) } else { json!({}) };
        json!({
            "profile": { "content_settings": { "exceptions": { "serial_chooser_data": ports } } },
            "session": { "restore_on_startup": 4, "startup_urls": ["about:blank"] },
        })
    }

    /// A folder of this bench that goes with it.
    pub(crate) fn folder(&self) -> &Path {
        &self.folder
    }
}

impl Drop for Bench {
    fn drop(&mut self) {
        end(self.robot.take());
        let _ = self.board.kill();
        let _ = self.board.wait();
        for folder in [&self.folder, &self.mocked] {
            let _ = std::fs::remove_dir_all(folder);
        }
    }
}

pub(crate) fn end(child: Option<Child>) {
    if let Some(mut child) = child {
        let _ = child.kill();
        let _ = child.wait();
    }
}

fn lines_of(from: impl std::io::Read + Send + 'static) -> Receiver<String> {
    let (sender, receiver) = channel();
    std::thread::spawn(move || {
        BufReader::new(from).lines().map_while(Result::ok).try_for_each(|line| sender.send(line))
    });
    receiver
}

/// `linemaze robot` in figure 3.1 with these arguments; or `cut WORDS`, the same on a wire that is cut by a line, or
/// `mute` or `flood`, which are no robots. It is there once its terminal is.
fn run_robot(pty: &Path, arguments: &[&str]) -> Result<Child> {
    let program = named("LINEMAZE").unwrap_or_else(|| root().join("target/debug/linemaze"));
    let maze = root().join("mazes/book-3-1.maze");
    let scripts = Path::new(env!("CARGO_MANIFEST_DIR")).join("serial");
    let mut command = Command::new("/usr/bin/python3");
    match arguments {
        ["cut", words] => {
            command.arg(scripts.join("cut.py")).arg(pty).arg(words);
            command.arg(&program).args(["robot", "--stdio", "--maze"]).arg(maze);
        }
        [other @ ("mute" | "flood"), rest @ ..] => {
            command.arg(scripts.join(format!("{other}.py"))).arg(pty).args(rest);
        }
        _ => {
            command = Command::new(&program);
            command.args(["robot", "--pty"]).arg(pty).arg("--maze").arg(maze).args(arguments);
        }
    }
    command.stdout(Stdio::null());
    let _ = std::fs::remove_file(pty);
    let mut robot = command
        .spawn()
        .with_context(|| format!("starting {}; `cargo build --features cli` makes it", program.display()))?;
    let begin = Instant::now();
    while !pty.exists() {
        if begin.elapsed() > PATIENCE || robot.try_wait()?.is_some() {
            end(Some(robot));
            bail!("the robot has no terminal at {}", pty.display());
        }
        std::thread::sleep(Duration::from_millis(10));
    }
    Ok(robot)
}
