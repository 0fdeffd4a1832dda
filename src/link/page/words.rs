//! What goes in and out of the page's end: commands, what happens to the port, what is to be done to it.

use alloc::string::String;
use alloc::vec::Vec;

use super::super::live::Mind;
use super::super::request::Level;
use super::super::tune::Name;
use super::OpenError;
use crate::route::TurnList;

/// What a person asks for.
#[derive(Clone, Debug, PartialEq)]
pub enum Command {
    /// Show the browser's list of ports.
    Choose,
    /// Open this port: a known one, or the demo robot.
    Use(Port),
    /// Close the port.
    Disconnect,
    /// The rate from the next opening on; at once, if nobody has answered.
    Baud(u32),
    /// After nobody has answered: the next of `RATES`.
    NextRate,
    /// Send a turn list, and read it back.
    Send(TurnList),
    /// Read the robot's turn list.
    ReadBack,
    /// Learn the maze.
    Explore(Mind),
    /// Drive by the list on the robot.
    RunRoute,
    /// Stop, before everything else.
    Stop,
    /// The robot was put back at the start.
    Place,
    /// Read the node table.
    ReadNodes,
    /// Read every setting.
    ReadSettings,
    /// Change a setting.
    Set(Name, i32),
    /// How much the robot tells.
    Watch(Level),
    /// A line typed in the monitor; without a checksum, it gets one.
    Line(String),
}

/// A port, as far as it can be told from others.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Port {
    /// A serial port; vendor and product, if it is on USB.
    Serial(Option<(u16, u16)>),
    /// The virtual robot in the page.
    Demo,
}

/// What happened to the port.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum PortEvent {
    /// There is no way to reach a port.
    NoSerial,
    /// A port was chosen in the browser's list.
    Chosen(Port),
    /// The list was closed without choosing.
    Cancelled,
    /// It is open.
    Opened,
    /// It could not be opened.
    OpenFailed(OpenError),
    /// It has gone: unplugged, or reading failed.
    Gone,
    /// The port that was lost is there again.
    Appeared,
    /// A write has ended, well or not: the port takes another.
    Written,
    /// What was still to be sent is thrown away: the port takes lines again.
    Aborted,
}

/// What is to be done to the port.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Action {
    /// Show the browser's list; answer with `Chosen` or `Cancelled`.
    Choose,
    /// Open the port; answer with `Opened` or `OpenFailed`.
    Open {
        /// Bits a second.
        baud: u32,
    },
    /// Send these bytes; answer with `Written` when the system has taken them.
    Write(Vec<u8>),
    /// Throw away what was written and has not left; answer with `Aborted`.
    Abort,
    /// Close the port.
    Close,
    /// Look whether the lost port is there again; if so, answer with `Appeared`.
    Look,
}

/// Who the robot is.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Identity {
    /// Its firmware.
    pub firmware: String,
    /// Its board.
    pub board: String,
    /// Nodes that it can remember.
    pub nodes: u16,
    /// Letters of a turn list that it can keep.
    pub turns: u16,
}
