//! `linemaze check`: what is not in order, where, and what to do.

use std::io::Write;

use line_maze_lab::maze::checks::{self, Severity};

use crate::args::Input;
use crate::{Failure, Status, files};

/// Prints what was found; nothing found is good.
pub(crate) fn check(input: &Input, out: &mut impl Write) -> Result<Status, Failure> {
    let maze = files::open(input)?;
    let report = checks::report(&maze);
    let name = files::name(&input.path);
    for finding in &report.findings {
        let severity = match finding.severity() {
            Severity::Error => "error",
            Severity::Warning => "warning",
        };
        let place = finding.place().map_or(String::new(), |place| {
            let (sw, ne) = (place.sw(), place.ne());
            if sw == ne { format!(" at {sw}") } else { format!(" from {sw} to {ne}") }
        });
        writeln!(
            out,
            "{name}: {severity}{place}: {}. {}",
            finding.title_in(maze.kind),
            finding.cure_in(maze.kind)
        )?;
    }
    if report.findings.is_empty() {
        writeln!(out, "{name}: in order")?;
    }
    for fine in &report.in_order {
        writeln!(out, "  {}: {}", fine.title_in(maze.kind), fine.detail())?;
    }
    Ok(if report.findings.is_empty() { Status::Good } else { Status::Bad })
}
