//! The lab as people use it, in a real browser.

mod compare;
mod draw;
mod everyone;
mod figure_3_1;
mod offline;
mod share;
mod step;
mod trouble;
