//! Ports and links that one program has at a time: locked, and who has it is said.

use std::fs::{self, File, OpenOptions, TryLockError};
use std::io;
use std::os::unix::fs::MetadataExt;
use std::path::{Path, PathBuf};

/// Locks an open file or port; the lock ends with the file.
///
/// # Errors
/// Where another program has it: which.
pub(crate) fn lock(file: &File) -> io::Result<()> {
    file.try_lock().map_err(|error| match error {
        TryLockError::WouldBlock => {
            let words = match holder(file) {
                Some(holder) => format!("{holder} has it; end that first"),
                None => "another program has it; end that first".to_owned(),
            };
            io::Error::new(io::ErrorKind::ResourceBusy, words)
        }
        TryLockError::Error(error) => error,
    })
}

/// A name that one program has at a time, by a file beside it. The file goes with the lock; one that is left over
/// holds nothing.
pub(crate) struct Claim {
    path: PathBuf,
    // Held as long as the claim.
    _file: File,
}

impl Claim {
    /// Claims a name.
    pub(crate) fn on(name: &Path) -> io::Result<Self> {
        let mut beside = name.as_os_str().to_owned();
        beside.push(".lock");
        let path = PathBuf::from(beside);
        loop {
            let file = OpenOptions::new().create(true).truncate(false).write(true).open(&path)?;
            lock(&file)?;
            // Whoever had it before may have taken the file away between the two.
            let same =
                fs::metadata(&path).is_ok_and(|now| file.metadata().is_ok_and(|it| it.ino() == now.ino()));
            if same {
                return Ok(Self { path, _file: file });
            }
        }
    }
}

impl Drop for Claim {
    fn drop(&mut self) {
        // A file that stays is no lock.
        let _ = fs::remove_file(&self.path);
    }
}

/// The program that has locked a file, where the system tells: its name and number.
fn holder(file: &File) -> Option<String> {
    let it = file.metadata().ok()?;
    let (major, minor) = (rustix::fs::major(it.dev()), rustix::fs::minor(it.dev()));
    let place = format!("{major:02x}:{minor:02x}:{}", it.ino());
    let locks = fs::read_to_string("/proc/locks").ok()?;
    let line = locks.lines().find(|line| line.split_whitespace().any(|word| word == place))?;
    let process: u32 = line.split_whitespace().nth(4)?.parse().ok()?;
    let name = fs::read_to_string(format!("/proc/{process}/comm")).ok()?;
    Some(format!("{} (process {process})", name.trim()))
}
