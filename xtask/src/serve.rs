//! `cargo xtask serve`: the lab on this computer, built anew at every saved file.

use std::net::{Ipv4Addr, SocketAddr, TcpStream};
use std::process::{Command, ExitCode};
use std::thread::sleep;
use std::time::{Duration, Instant};

use anyhow::{Context, Result, bail};

use crate::shell::{self, Shell};
use crate::tools::{self, say};
use crate::{dist, port};

/// The chore behind the scenes that says when the page is there.
pub(crate) const ANNOUNCE: &str = "announce";
const PATIENCE: Duration = Duration::from_secs(30 * 60);

/// What a person chose on the command line.
#[derive(Debug, Default)]
pub(crate) struct Options {
    pub(crate) port: Option<u16>,
    pub(crate) release: bool,
}

pub(crate) fn serve(shell: &Shell, options: &Options) -> Result<ExitCode> {
    let port = port::choose(options.port)?;
    if options.release {
        tools::for_release(shell)?;
    } else {
        tools::for_page(shell)?;
    }
    let mut trunk = dist::trunk(shell, "serve");
    trunk.args(["--dist", "target/serve", "--address", "127.0.0.1", "--port", &port.to_string()]);
    if options.release {
        trunk.arg("--release");
    }
    say("Building the lab (a minute or two the first time, seconds later); its address follows");
    Command::new(std::env::current_exe()?).args([ANNOUNCE, &port.to_string()]).spawn()?;
    become_(trunk)
}

/// Waits until something answers on the port, and tells the address; ends when the server does.
pub(crate) fn announce(args: &[String]) -> Result<ExitCode> {
    let [port] = args else { bail!("{ANNOUNCE} wants a port") };
    let address = SocketAddr::from((Ipv4Addr::LOCALHOST, port.parse().context("no port")?));
    let (server, start) = (parent(), Instant::now());
    while parent() == server && start.elapsed() < PATIENCE {
        if TcpStream::connect_timeout(&address, Duration::from_secs(1)).is_ok() {
            println!("\n  Line Maze Lab is at  http://localhost:{port}/  (Ctrl+C ends it)\n");
            return Ok(ExitCode::SUCCESS);
        }
        sleep(Duration::from_millis(100));
    }
    Ok(ExitCode::FAILURE)
}

/// Trunk takes this process's place, so that whoever ends this one ends the server too.
#[cfg(unix)]
fn become_(mut trunk: Command) -> Result<ExitCode> {
    use std::os::unix::process::CommandExt;
    Err(trunk.exec()).with_context(|| format!("could not start {}", shell::line(&trunk)))
}

#[cfg(not(unix))]
fn become_(mut trunk: Command) -> Result<ExitCode> {
    shell::run(&mut trunk).map(|()| ExitCode::SUCCESS)
}

#[cfg(unix)]
fn parent() -> u32 {
    std::os::unix::process::parent_id()
}

#[cfg(not(unix))]
fn parent() -> u32 {
    0
}
