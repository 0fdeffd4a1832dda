//! The lab as people use it, in a real browser.

mod connect;
mod draw;
mod everyone;
mod figure_3_1;
mod offline;
mod serial;
mod share;
mod step;
mod trouble;
