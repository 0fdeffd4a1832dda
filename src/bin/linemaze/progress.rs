//! How far a long job is, on standard error; nothing where that is no terminal.

use indicatif::{ProgressBar, ProgressStyle};

/// A bar for so many pieces of work.
pub(crate) fn bar(pieces: u64) -> ProgressBar {
    let style = ProgressStyle::with_template("{bar:40} {pos}/{len}  {eta} left");
    let bar = ProgressBar::new(pieces);
    style.map_or(bar.clone(), |style| bar.with_style(style))
}
