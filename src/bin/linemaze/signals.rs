//! The signals that end a command which has something to put away first.

use std::io;
use std::sync::Arc;
use std::sync::atomic::{AtomicUsize, Ordering};

use signal_hook::consts::{SIGINT, SIGTERM};
use signal_hook::{flag, low_level};

/// A number that is no signal's.
const NONE: usize = 0;

/// Keeps the signals that end a process, until it is ready for them.
pub(crate) struct Signals(Arc<AtomicUsize>);

impl Signals {
    /// From now on an interrupt (Ctrl-C) and a request to end are only noted.
    pub(crate) fn held() -> io::Result<Self> {
        let came = Arc::new(AtomicUsize::new(NONE));
        for signal in [SIGINT, SIGTERM] {
            flag::register_usize(signal, Arc::clone(&came), signal as usize)?;
        }
        Ok(Self(came))
    }

    /// Whether one came.
    pub(crate) fn came(&self) -> bool {
        self.0.load(Ordering::SeqCst) != NONE
    }

    /// Ends the process as the signal that came would have, so that whoever started it can tell; nothing else
    /// happens where none came.
    pub(crate) fn obey(&self) -> io::Result<()> {
        match self.0.load(Ordering::SeqCst) {
            NONE => Ok(()),
            signal => low_level::emulate_default_handler(signal as i32),
        }
    }
}
