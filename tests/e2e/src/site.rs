//! The page's web server: static files below a folder's address, so that relative addresses are proven. It can
//! be stopped, which is how a test cuts the network.

use std::path::{Path, PathBuf};
use std::sync::{Arc, Mutex, MutexGuard, PoisonError};

use anyhow::{Context, Result, ensure};
use tokio::io::{AsyncReadExt, AsyncWriteExt};
use tokio::net::{TcpListener, TcpStream};
use tokio::task::JoinHandle;

use crate::{named, root};

/// Where the page is below the server's root.
const FOLDER: &str = "/some/sub/folder/";

/// In what the server differs from the folder.
#[derive(Debug, Default)]
struct Faults {
    missing: Vec<&'static str>,
    changed: Vec<(&'static str, &'static str, &'static str)>,
    replaced: Vec<(&'static str, &'static [u8])>,
    called: Vec<(&'static str, &'static str)>,
    policy: Option<&'static str>,
    open: bool,
}

/// A running server.
#[derive(Debug)]
pub struct Site {
    port: u16,
    faults: Arc<Mutex<Faults>>,
    accepting: JoinHandle<()>,
}

impl Site {
    /// Serves the built page on a free port.
    ///
    /// # Errors
    /// Where the page isn't built.
    pub async fn start() -> Result<Self> {
        let dist = named("LINE_MAZE_DIST").unwrap_or_else(|| root().join("dist"));
        let built = dist.join("index.html").is_file();
        ensure!(built, "there's no page in {}; `cargo xtask test e2e` builds it", dist.display());
        let listener = TcpListener::bind(("localhost", 0)).await?;
        let port = listener.local_addr()?.port();
        let faults = Arc::new(Mutex::new(Faults::default()));
        let shared = Arc::clone(&faults);
        let accepting = tokio::spawn(async move {
            while let Ok((stream, _)) = listener.accept().await {
                let (dist, faults) = (dist.clone(), Arc::clone(&shared));
                tokio::spawn(async move { answer(stream, &dist, &faults).await });
            }
        });
        Ok(Self { port, faults, accepting })
    }

    /// The page's address.
    #[must_use]
    pub fn address(&self) -> String {
        format!("http://localhost:{}{FOLDER}", self.port)
    }

    /// The page's origin.
    #[must_use]
    pub fn origin(&self) -> String {
        format!("http://localhost:{}", self.port)
    }

    /// From now on, files with this in their names are not found.
    pub fn lose(&self, part: &'static str) {
        self.faults().missing.push(part);
    }

    fn faults(&self) -> MutexGuard<'_, Faults> {
        self.faults.lock().unwrap_or_else(PoisonError::into_inner)
    }

    /// From now on, one text stands for another in a file.
    pub fn change(&self, file: &'static str, from: &'static str, to: &'static str) {
        self.faults().changed.push((file, from, to));
    }

    /// From now on, something else stands for the files with this in their names.
    pub fn stand_in(&self, part: &'static str, body: &'static [u8]) {
        self.faults().replaced.push((part, body));
    }

    /// From now on, files with this in their names are said to be of this type.
    pub fn call(&self, part: &'static str, mime: &'static str) {
        self.faults().called.push((part, mime));
    }

    /// From now on, the server has a Content Security Policy of its own.
    pub fn forbid(&self, policy: &'static str) {
        self.faults().policy = Some(policy);
    }

    /// From now on, pages of other origins may read what is here, as many servers have it.
    pub fn let_strangers_in(&self) {
        self.faults().open = true;
    }

    /// Every file is found again.
    pub fn find_all(&self) {
        self.faults().missing.clear();
    }

    /// Cuts the network: nobody answers at this address any more.
    ///
    /// # Errors
    /// If somebody still does.
    pub async fn stop(&self) -> Result<()> {
        self.accepting.abort();
        while !self.accepting.is_finished() {
            tokio::task::yield_now().await;
        }
        ensure!(TcpStream::connect(("localhost", self.port)).await.is_err(), "the server still answers");
        Ok(())
    }
}

impl Faults {
    fn mime(&self, path: &str) -> &'static str {
        self.called.iter().find(|(part, _)| path.contains(part)).map_or_else(|| mime(path), |(_, mime)| mime)
    }

    fn apply(&self, path: &str, body: Vec<u8>) -> Option<Vec<u8>> {
        if self.missing.iter().any(|part| path.contains(part)) {
            return None;
        }
        if let Some((_, other)) = self.replaced.iter().find(|(part, _)| path.contains(part)) {
            return Some(other.to_vec());
        }
        Some(
            self.changed.iter().filter(|(file, ..)| *file == path).fold(body, |body, (_, from, to)| {
                String::from_utf8_lossy(&body).replace(from, to).into_bytes()
            }),
        )
    }
}

impl Drop for Site {
    fn drop(&mut self) {
        self.accepting.abort();
    }
}

async fn answer(mut stream: TcpStream, dist: &Path, faults: &Mutex<Faults>) -> Result<()> {
    let mut request = Vec::new();
    while !request.windows(4).any(|end| end == b"\r\n\r\n") {
        if stream.read_buf(&mut request).await? == 0 {
            return Ok(());
        }
    }
    let request = String::from_utf8(request)?;
    let target = request.split(' ').nth(1).context("no target")?;
    let found = file(dist, target).and_then(|(path, body)| {
        let faults = faults.lock().unwrap_or_else(PoisonError::into_inner);
        let policy = faults.policy.map(|policy| format!("Content-Security-Policy: {policy}\r\n"));
        Some((faults.mime(&path), policy.unwrap_or_default(), faults.apply(&path, body)?))
    });
    let strangers = faults.lock().unwrap_or_else(PoisonError::into_inner).open;
    let strangers = if strangers { "Access-Control-Allow-Origin: *\r\n" } else { "" };
    let (status, mime, policy, body) = match &found {
        Some((mime, policy, body)) => ("200 OK", *mime, policy.as_str(), body.as_slice()),
        None => ("404 Not Found", "text/plain", "", b"not found".as_slice()),
    };
    let head = format!(
        "HTTP/1.1 {status}\r\nContent-Type: {mime}\r\nContent-Length: {}\r\nCache-Control: no-cache\r\n{strangers}\
         {policy}Connection: close\r\n\r\n",
        body.len()
    );
    stream.write_all(head.as_bytes()).await?;
    stream.write_all(body).await?;
    Ok(stream.shutdown().await?)
}

/// A file by its address; the folder itself is `index.html`.
fn file(dist: &Path, target: &str) -> Option<(String, Vec<u8>)> {
    let path = target.split('?').next()?.strip_prefix(FOLDER)?;
    let path = if path.is_empty() { "index.html" } else { path };
    let inside = !path.split('/').any(|part| part == "..");
    let content = std::fs::read(inside.then(|| PathBuf::from(dist).join(path))?).ok()?;
    Some((path.to_owned(), content))
}

fn mime(path: &str) -> &'static str {
    match path.rsplit('.').next() {
        Some("html") => "text/html; charset=utf-8",
        Some("js") => "text/javascript; charset=utf-8",
        Some("css") => "text/css; charset=utf-8",
        Some("wasm") => "application/wasm",
        Some("svg") => "image/svg+xml",
        Some("png") => "image/png",
        Some("webmanifest") => "application/manifest+json",
        _ => "application/octet-stream",
    }
}
