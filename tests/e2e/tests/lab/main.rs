//! The lab as people use it, in a real browser.

mod compare;
mod connect;
mod connect_over;
mod connect_states;
mod draw;
mod draw_help;
mod drawing;
mod everyone;
mod figure_3_1;
mod files;
mod habits;
mod look;
mod offline;
mod others;
mod serial;
mod share;
mod step;
mod trouble;
mod truth;
mod walls;
