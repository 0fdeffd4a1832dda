//! The serial link: codec, both ends, and everything that can happen between them, in simulated time.
#![allow(unreachable_pub, clippy::unwrap_used, clippy::expect_used, clippy::panic)]

#[path = "../support/mod.rs"]
mod support;

#[path = "../support/firmware.rs"]
mod firmware;

mod bench;
mod cable;
mod check;
mod codec;
mod connecting;
mod examples;
mod faults;
mod running;
mod session;
mod stopping;
mod typed;
mod upload;
