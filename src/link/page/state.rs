//! Where the page's end stands, and what it says about it: short plain sentences, and one cure for a failure.

use super::Alarm;

/// Where the page's end stands.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum State {
    /// The browser has no Web Serial, or the page is on no secure origin.
    Absent,
    /// No port is open.
    Closed,
    /// The browser shows its list of ports.
    Choosing,
    /// The port is being opened.
    Opening,
    /// The port is open, the robot has not said `ready` yet.
    Waiting,
    /// The robot is there and does what it is told.
    Ready,
    /// A turn list is on its way.
    Sending,
    /// The robot drives.
    Running,
    /// The robot was told to stop and has not answered yet.
    Stopping,
    /// It should stand, and may be driving.
    Alarm(Alarm),
    /// The port has just gone.
    Lost,
    /// The port is looked for.
    Reconnecting,
    /// It did not work.
    Failed(Trouble),
}

/// What went wrong.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Trouble {
    /// Nobody answered at this rate.
    NoAnswer {
        /// Bits a second.
        baud: u32,
        /// Whether anything came at all.
        heard: Heard,
    },
    /// The robot speaks another version of the protocol.
    Protocol {
        /// Its version.
        version: u16,
    },
    /// The robot was there, and no longer answers.
    Silent,
    /// The port did not come back.
    Gone,
    /// The port could not be opened.
    Open(OpenError),
}

/// What came while nobody answered.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Heard {
    /// Not a byte.
    Nothing,
    /// Bytes that make no sense.
    Rubbish,
}

/// Why a port could not be opened.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum OpenError {
    /// Something else has it open.
    InUse,
    /// The system does not allow it.
    NoPermission,
    /// In use or not allowed: browsers do not tell these apart.
    InUseOrNoPermission,
    /// It is not there any more.
    Unplugged,
    /// The browser or its administrator forbids it.
    Policy,
    /// Anything else.
    Other,
}

impl State {
    /// A word for it.
    #[must_use]
    pub const fn name(self) -> &'static str {
        match self {
            Self::Absent => "not available",
            Self::Closed => "not connected",
            Self::Choosing => "choosing a port",
            Self::Opening => "opening",
            Self::Waiting => "waiting for the robot",
            Self::Ready => "ready",
            Self::Sending => "sending",
            Self::Running => "running",
            Self::Stopping => "stopping",
            Self::Alarm(_) => "not stopped",
            Self::Lost => "lost",
            Self::Reconnecting => "reconnecting",
            Self::Failed(_) => "failed",
        }
    }

    /// What it means.
    #[must_use]
    pub const fn says(self) -> &'static str {
        match self {
            Self::Absent => "This browser cannot reach a serial port.",
            Self::Closed => "No robot is connected.",
            Self::Choosing => "Choose the robot’s port in the browser’s list.",
            Self::Opening => "The port is being opened.",
            Self::Waiting => "The port is open. The robot has not answered yet.",
            Self::Ready => "The robot is ready.",
            Self::Sending => "A turn list is being sent.",
            Self::Running => "The robot is driving.",
            Self::Stopping => "The robot was told to stop.",
            Self::Alarm(alarm) => alarm.says(),
            Self::Lost => "The connection is lost.",
            Self::Reconnecting => "The port is gone. It is being looked for.",
            Self::Failed(trouble) => trouble.cause(),
        }
    }

    /// What to do about it, if there is something to do.
    #[must_use]
    pub const fn cure(self) -> Option<&'static str> {
        match self {
            Self::Absent => Some(
                "Use Chrome, Edge or Firefox on a computer, with an https address; or try the demo robot.",
            ),
            Self::Lost | Self::Reconnecting => Some("Plug the cable in again."),
            Self::Failed(trouble) => Some(trouble.cure()),
            Self::Alarm(alarm) => Some(alarm.cure()),
            Self::Closed
            | Self::Choosing
            | Self::Opening
            | Self::Waiting
            | Self::Ready
            | Self::Sending
            | Self::Running
            | Self::Stopping => None,
        }
    }

    /// Whether a robot is there that answers.
    #[must_use]
    pub const fn is_connected(self) -> bool {
        matches!(self, Self::Ready | Self::Sending | Self::Running | Self::Stopping)
    }
}

impl Trouble {
    /// What happened.
    #[must_use]
    pub const fn cause(self) -> &'static str {
        match self {
            Self::NoAnswer { heard: Heard::Nothing, .. } => "No robot answered: not a byte came.",
            Self::NoAnswer { heard: Heard::Rubbish, .. } => {
                "No robot answered: what came makes no sense at this rate."
            }
            Self::Protocol { .. } => "The robot speaks another version of the protocol.",
            Self::Silent => "The robot no longer answers.",
            Self::Gone => "The port did not come back within 30 seconds.",
            Self::Open(OpenError::InUse) => "Another program or tab has the port open.",
            Self::Open(OpenError::NoPermission) => "The system does not let you use the port.",
            Self::Open(OpenError::InUseOrNoPermission) => "The port could not be opened.",
            Self::Open(OpenError::Unplugged) => "The port is not there any more.",
            Self::Open(OpenError::Policy) => "The browser’s settings or a policy forbid serial ports.",
            Self::Open(OpenError::Other) => "The port could not be opened.",
        }
    }

    /// What to do first.
    #[must_use]
    pub const fn cure(self) -> &'static str {
        match self {
            Self::NoAnswer { heard: Heard::Nothing, .. } => {
                "Check that the robot is switched on and its firmware speaks this protocol, or try the next rate."
            }
            Self::NoAnswer { heard: Heard::Rubbish, .. } => "Try the next rate.",
            Self::Protocol { .. } => "Load this page anew, or put firmware for version 1 on the robot.",
            Self::Silent => "Check its battery, then connect again.",
            Self::Gone => "Plug the cable in and connect again; a cable that only charges will not do.",
            Self::Open(OpenError::InUse) => "Close the other tab, serial monitor or IDE, then connect again.",
            Self::Open(OpenError::NoPermission) => {
                "On Linux, run: sudo usermod -aG dialout $USER, then log out and in."
            }
            Self::Open(OpenError::InUseOrNoPermission) => {
                "Close other tabs and serial monitors. On Linux, your user must be in the group dialout."
            }
            Self::Open(OpenError::Unplugged) => "Plug the cable in, then connect again.",
            Self::Open(OpenError::Policy) => {
                "Allow serial ports for this page in the browser’s site settings, or ask the administrator."
            }
            Self::Open(OpenError::Other) => "Unplug the cable, plug it in again, then connect.",
        }
    }
}
