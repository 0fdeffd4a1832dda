//! `linemaze check`: what is not in order, where, and what to do.
//!
//! What keeps the book's explorer from starting is an error, as it is to `linemaze run`; everything else is a warning,
//! for a maze may be meant so.

use std::io::Write;

use line_maze_lab::maze::checks::{self, Finding, Severity};

use crate::args::Check;
use crate::{Failure, Status, files};

/// Prints what was found. Without errors it is good; with `--strict` only where there is nothing at all.
pub(crate) fn check(Check { maze: input, strict }: &Check, out: &mut impl Write) -> Result<Status, Failure> {
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
    let counts = |finding: &Finding| *strict || finding.severity() == Severity::Error;
    Ok(if report.findings.iter().any(counts) { Status::Bad } else { Status::Good })
}
