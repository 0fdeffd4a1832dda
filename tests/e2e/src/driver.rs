//! One chromedriver for all tests of a process; it ends with the last of them.

use std::io::{BufRead, BufReader, Read, Write};
use std::net::{Ipv4Addr, TcpStream};
use std::path::PathBuf;
use std::process::{Child, Command, Stdio};
use std::sync::{Arc, Mutex, PoisonError, Weak};
use std::time::Duration;

use anyhow::{Context, Result, bail};

use crate::named;

/// A running chromedriver.
#[derive(Debug)]
pub(crate) struct Driver {
    process: Child,
    port: u16,
}

static RUNNING: Mutex<Weak<Driver>> = Mutex::new(Weak::new());

impl Driver {
    /// The one that runs, or a new one.
    pub(crate) fn shared() -> Result<Arc<Self>> {
        let mut running = RUNNING.lock().unwrap_or_else(PoisonError::into_inner);
        if let Some(driver) = running.upgrade() {
            return Ok(driver);
        }
        let driver = Arc::new(Self::start(&[])?);
        *running = Arc::downgrade(&driver);
        Ok(driver)
    }

    /// It chooses a free port, and says which one when it's ready.
    pub(crate) fn start(variables: &[(&'static str, PathBuf)]) -> Result<Self> {
        let program = named("CHROMEDRIVER").unwrap_or_else(|| PathBuf::from("chromedriver"));
        let mut process = Command::new(&program)
            .args(["--port=0", "--log-level=SEVERE"])
            .envs(variables.iter().map(|(name, value)| (name, value)))
            .stdout(Stdio::piped())
            .stderr(Stdio::null())
            .spawn()
            .with_context(|| format!("starting {}; `cargo xtask test e2e` installs it", program.display()))?;
        let mut said = BufReader::new(process.stdout.take().context("chromedriver is mute")?);
        let port = port(&mut said).inspect_err(|_| end(&mut process))?;
        // Nobody listens further, but a full pipe would stop it.
        std::thread::spawn(move || std::io::copy(&mut said, &mut std::io::sink()));
        Ok(Self { process, port })
    }

    pub(crate) fn address(&self) -> String {
        format!("http://127.0.0.1:{}", self.port)
    }

    /// A request from a destructor, where nothing can be awaited; whether it succeeds matters to no test.
    pub(crate) fn tell(&self, method: &str, path: &str) {
        let Ok(mut stream) = TcpStream::connect((Ipv4Addr::LOCALHOST, self.port)) else { return };
        let _ = stream.set_read_timeout(Some(Duration::from_secs(5)));
        let host = format!("127.0.0.1:{}", self.port);
        let _ = write!(stream, "{method} {path} HTTP/1.1\r\nHost: {host}\r\nConnection: close\r\n\r\n");
        let _ = stream.read(&mut [0; 512]);
    }
}

impl Drop for Driver {
    fn drop(&mut self) {
        // Asked first, it ends its browsers too.
        self.tell("GET", "/shutdown");
        end(&mut self.process);
    }
}

fn end(process: &mut Child) {
    let _ = process.kill();
    let _ = process.wait();
}

/// The last number of “ChromeDriver was started successfully on port 41234.”
fn port(said: &mut impl BufRead) -> Result<u16> {
    for line in said.lines() {
        let line = line?;
        if let Some((_, port)) = line.split_once("successfully on port ") {
            return port.trim_end_matches('.').parse().with_context(|| format!("chromedriver said {line}"));
        }
    }
    bail!("chromedriver ended without a word about its port")
}
