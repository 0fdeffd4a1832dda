//! The serial link between the page and a robot, as `PROTOCOL.md` tells it; nothing here moves a byte.
//!
//! Both ends are state machines driven by bytes and milliseconds. A board compiles [`frame`], [`request`],
//! [`report`], [`tune`], [`keep`] and [`robot`]: these need no heap. The rest is the page's end.

pub mod check;
pub mod demo;
pub mod ear;
pub mod fields;
pub mod floor;
pub mod form;
pub mod frame;
pub mod keep;
pub mod knobs;
pub mod live;
pub mod monitor;
pub mod page;
pub mod plot;
pub mod report;
pub mod request;
pub mod robot;
pub mod session;
pub mod sieve;
pub mod strips;
pub mod tune;
pub mod usb;
pub mod words;

pub use fields::{Letters, MAX_LETTERS, Tag};

/// The version of the protocol that this is.
pub const PROTOCOL: u16 = 1;
