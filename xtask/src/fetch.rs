//! Fetching a file from a server on this computer.

use std::io::{Read, Write};
use std::net::{Ipv4Addr, TcpStream};
use std::time::Duration;

use anyhow::{Context, Result, ensure};

const PATIENCE: Duration = Duration::from_secs(20);

/// What a server on this computer gives out at an address.
pub(crate) fn fetch(port: u16, address: &str) -> Result<Vec<u8>> {
    ask(port, address).with_context(|| format!("fetching http://localhost:{port}/{address}"))
}

fn ask(port: u16, address: &str) -> Result<Vec<u8>> {
    let mut stream = TcpStream::connect((Ipv4Addr::LOCALHOST, port))?;
    stream.set_read_timeout(Some(PATIENCE))?;
    // The old version of HTTP: one answer in one piece.
    write!(stream, "GET /{address} HTTP/1.0\r\nHost: localhost:{port}\r\n\r\n")?;
    let mut answer = Vec::new();
    stream.read_to_end(&mut answer)?;
    let end = answer.windows(4).position(|end| end == b"\r\n\r\n").context("no HTTP came back")?;
    let head = String::from_utf8_lossy(&answer[..end]).into_owned();
    let status = head.lines().next().unwrap_or_default();
    ensure!(status.split(' ').nth(1) == Some("200"), "the server says {status}");
    Ok(answer.split_off(end + 4))
}
