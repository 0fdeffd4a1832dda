//! The page. Data flows one way: views read [`state::Lab`]'s signals and send it commands.
//!
//! No algorithm lives here; what the views show is worked out in the core.

// The component macro makes a public struct of every component's props.
#![allow(missing_docs, unreachable_pub)]

pub mod aloud;
pub mod app;
pub mod bench;
pub mod browser;
pub mod clock;
pub mod compare;
pub mod connect;
pub mod dialogs;
pub mod draw;
pub mod erase;
pub mod focus;
pub mod header;
pub mod icons;
pub mod keeping;
pub mod keys;
pub mod lazy;
pub mod maze_view;
pub mod notes;
pub mod opening;
pub mod others;
pub mod past;
pub mod paths;
pub mod played;
pub mod projector;
pub mod rescue;
pub mod rooms;
pub mod run_view;
pub mod serial_port;
pub mod state;
pub mod step;
pub mod storage;
pub mod viewport;
