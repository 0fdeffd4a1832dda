//! Serial lines on this computer: a pseudo-terminal for the virtual robot, and a port as a program opens it.

use std::ffi::OsStr;
use std::fs::{self, File, OpenOptions};
use std::io::{self, Read, Write};
use std::os::fd::{AsFd, OwnedFd};
use std::os::unix::ffi::OsStrExt;
use std::os::unix::fs::symlink;
use std::path::{Path, PathBuf};
use std::time::{Duration, Instant};

use crate::lock::{Claim, lock};
use rustix::event::{PollFd, PollFlags, Timespec, poll};
use rustix::fs::{OFlags, fcntl_getfl, fcntl_setfl};
use rustix::pty::{OpenptFlags, grantpt, openpt, ptsname, unlockpt};
use rustix::termios::{OptionalActions, tcgetattr, tcsetattr};

/// The robot's side of a pseudo-terminal; the link to it goes away with it.
pub(crate) struct Pty {
    master: File,
    link: PathBuf,
    name: PathBuf,
    // The link is this robot's as long as it lives.
    _claim: Claim,
}

/// Whether somebody has the other side open.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Peer {
    Open,
    Gone,
}

impl Pty {
    /// A new pseudo-terminal, with a link to it at `link`; an old link is replaced, that of a robot that lives
    /// and any other file are not.
    pub(crate) fn new(link: &Path) -> io::Result<Self> {
        let claim = Claim::on(link)?;
        let master: OwnedFd = openpt(OpenptFlags::RDWR | OpenptFlags::NOCTTY)?;
        grantpt(&master)?;
        unlockpt(&master)?;
        let name = ptsname(&master, Vec::new())?;
        let name = PathBuf::from(OsStr::from_bytes(name.as_bytes()));
        if fs::symlink_metadata(link).is_ok_and(|file| file.is_symlink()) {
            fs::remove_file(link)?;
        }
        // Once open and closed, the master says whether anybody is there.
        let slave = OpenOptions::new().read(true).write(true).open(&name)?;
        raw(&slave, None)?;
        drop(slave);
        fcntl_setfl(&master, fcntl_getfl(&master)? | OFlags::NONBLOCK)?;
        symlink(&name, link)?;
        Ok(Self { master: File::from(master), link: link.to_owned(), name, _claim: claim })
    }

    /// The terminal's own name.
    pub(crate) fn name(&self) -> &Path {
        &self.name
    }

    /// Waits until something comes, at most so long.
    pub(crate) fn wait(&self, ms: u32) -> io::Result<Peer> {
        let (_, gone) = wait(&self.master, ms)?;
        if gone {
            // A terminal that nobody has open is always “ready”: wait all the same.
            std::thread::sleep(std::time::Duration::from_millis(ms.into()));
        }
        Ok(if gone { Peer::Gone } else { Peer::Open })
    }

    /// Somebody has opened the other side. Until it sets the terminal itself, nothing may be echoed.
    pub(crate) fn opened(&self) -> io::Result<()> {
        raw(&self.master, None)
    }

    /// The rate that the other side has set.
    pub(crate) fn baud(&self) -> io::Result<u32> {
        Ok(tcgetattr(&self.master)?.output_speed())
    }

    /// What has come.
    pub(crate) fn read(&mut self) -> io::Result<Vec<u8>> {
        match read(&mut self.master) {
            Err(error) if is_hung_up(&error) => Ok(Vec::new()),
            other => other,
        }
    }

    /// Sends as much as there is room for; returns how much.
    pub(crate) fn write(&mut self, bytes: &[u8]) -> io::Result<usize> {
        match self.master.write(bytes) {
            Err(error) if is_nothing(&error) || is_hung_up(&error) => Ok(0),
            other => other,
        }
    }
}

impl Drop for Pty {
    fn drop(&mut self) {
        // Another robot may have put its own link there.
        if fs::read_link(&self.link).is_ok_and(|name| name == self.name) {
            // Nobody can be told; a link that is left over is replaced next time.
            let _ = fs::remove_file(&self.link);
        }
    }
}

/// A serial port, as a program opens it. One program has it at a time, of those that ask.
pub(crate) struct Port(File);

/// A port that takes nothing for so long takes nothing any more.
const MOST_WRITING: Duration = Duration::from_secs(2);

impl Port {
    /// Opens a port, raw, at this rate.
    pub(crate) fn open(path: &Path, baud: u32) -> io::Result<Self> {
        let flags = (OFlags::NOCTTY | OFlags::NONBLOCK).bits();
        let mut options = OpenOptions::new();
        options.read(true).write(true);
        std::os::unix::fs::OpenOptionsExt::custom_flags(&mut options, flags as i32);
        let file = options.open(path)?;
        lock(&file)?;
        raw(&file, Some(baud))?;
        Ok(Self(file))
    }

    /// Sends all bytes.
    pub(crate) fn write(&mut self, mut bytes: &[u8]) -> io::Result<()> {
        let until = Instant::now() + MOST_WRITING;
        while !bytes.is_empty() {
            match self.0.write(bytes) {
                Ok(written) => bytes = &bytes[written..],
                Err(error) if is_nothing(&error) && Instant::now() < until => {
                    std::thread::sleep(Duration::from_millis(1));
                }
                Err(error) if is_nothing(&error) => {
                    return Err(io::Error::new(
                        io::ErrorKind::TimedOut,
                        "the port takes nothing any more: nobody reads at its other end",
                    ));
                }
                Err(error) if is_hung_up(&error) => return Err(gone()),
                Err(error) => return Err(error),
            }
        }
        Ok(())
    }

    /// What comes within so many milliseconds.
    pub(crate) fn wait(&mut self, ms: u32) -> io::Result<Vec<u8>> {
        let (ready, hung_up) = wait(&self.0, ms)?;
        if !ready {
            return if hung_up { Err(gone()) } else { Ok(Vec::new()) };
        }
        let mut bytes = vec![0; 4096];
        match self.0.read(&mut bytes) {
            // Ready, and nothing there: the end.
            Ok(0) => Err(gone()),
            Ok(count) => {
                bytes.truncate(count);
                Ok(bytes)
            }
            Err(error) if is_nothing(&error) => Ok(Vec::new()),
            Err(error) if is_hung_up(&error) => Err(gone()),
            Err(error) => Err(error),
        }
    }
}

/// The other end is not there any more.
fn gone() -> io::Error {
    let words = "the port has gone: its cable was pulled, or the program at its other end is over";
    io::Error::new(io::ErrorKind::UnexpectedEof, words)
}

/// Waits for a file; whether there is something to read, and whether the other side has gone.
fn wait(file: &File, ms: u32) -> io::Result<(bool, bool)> {
    let mut files = [PollFd::new(file, PollFlags::IN)];
    let timeout = Timespec { tv_sec: (ms / 1000).into(), tv_nsec: (ms % 1000 * 1_000_000).into() };
    match poll(&mut files, Some(&timeout)) {
        Ok(_) => {}
        Err(rustix::io::Errno::INTR) => return Ok((false, false)),
        Err(error) => return Err(error.into()),
    }
    let flags = files[0].revents();
    Ok((flags.contains(PollFlags::IN), flags.intersects(PollFlags::HUP | PollFlags::ERR)))
}

fn read(file: &mut File) -> io::Result<Vec<u8>> {
    let mut bytes = vec![0; 4096];
    match file.read(&mut bytes) {
        Ok(count) => bytes.truncate(count),
        Err(error) if is_nothing(&error) => bytes.clear(),
        Err(error) => return Err(error),
    }
    Ok(bytes)
}

/// Nothing there now.
fn is_nothing(error: &io::Error) -> bool {
    matches!(error.kind(), io::ErrorKind::WouldBlock | io::ErrorKind::Interrupted)
}

/// What Linux says at one end of a terminal when nobody has the other: for the robot's end that is the rule, for
/// the page's end it is over.
fn is_hung_up(error: &io::Error) -> bool {
    error.raw_os_error() == Some(rustix::io::Errno::IO.raw_os_error())
}

/// No echo, no line editing, no translation.
fn raw(file: impl AsFd, baud: Option<u32>) -> io::Result<()> {
    let mut settings = tcgetattr(&file)?;
    settings.make_raw();
    if let Some(baud) = baud {
        settings.set_speed(baud)?;
    }
    Ok(tcsetattr(&file, OptionalActions::Now, &settings)?)
}
