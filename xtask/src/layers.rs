//! The layers of tests, the innermost first, and the table of their results.

use std::process::ExitCode;
use std::time::{Duration, Instant};

use anyhow::{Result, bail};

use crate::shell::Shell;
use crate::summary::Counts;
use crate::{checks, dist, fresh, fuzz};

/// Checks of one kind. They run in this order.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Layer {
    Lint,
    Native,
    Board,
    Fuzz,
    Wasm,
    Dist,
    E2e,
    Fresh,
}

use Layer::{Board, Dist, E2e, Fresh, Fuzz, Lint, Native, Wasm};

impl Layer {
    pub(crate) const ALL: [Self; 8] = [Lint, Native, Board, Fuzz, Wasm, Dist, E2e, Fresh];
    /// Without the lints, which say nothing about what the code does, and without what tries these very commands.
    const TESTS: [Self; 6] = [Native, Board, Fuzz, Wasm, Dist, E2e];

    fn name(self) -> &'static str {
        match self {
            Lint => "lint",
            Native => "native",
            Board => "board",
            Fuzz => "fuzz",
            Wasm => "wasm",
            Dist => "dist",
            E2e => "e2e",
            Fresh => "fresh",
        }
    }

    /// The file that has to be there for the layer to have anything to run.
    fn needs(self) -> Option<&'static str> {
        match self {
            Lint | Native | Board | Dist | Fresh => None,
            Fuzz => Some("fuzz/Cargo.toml"),
            Wasm => Some("tests/web.rs"),
            E2e => Some("tests/e2e/Cargo.toml"),
        }
    }

    fn run(self, shell: &Shell) -> Result<Counts> {
        match self {
            Lint => checks::lint(shell),
            Native => checks::native(shell),
            Board => checks::board(shell),
            Fuzz => fuzz::fuzz(shell),
            Wasm => checks::wasm(shell),
            Dist => dist::dist(shell).map(|()| Counts::PASSED),
            E2e => checks::e2e(shell),
            Fresh => fresh::fresh(shell),
        }
    }
}

/// The layers that a person named, in their order; without names, all tests. A browser's tests want the page built.
pub(crate) fn chosen(names: &[String]) -> Result<Vec<Layer>> {
    if names.is_empty() {
        return Ok(Layer::TESTS.to_vec());
    }
    if let Some(name) = names.iter().find(|name| !Layer::ALL.iter().any(|layer| layer.name() == **name)) {
        bail!("there's no layer “{name}”; they are {}", Layer::ALL.map(Layer::name).join(", "));
    }
    let named = |layer: Layer| names.iter().any(|name| name == layer.name());
    Ok(Layer::ALL.into_iter().filter(|&layer| named(layer) || layer == Dist && named(E2e)).collect())
}

/// Runs the layers, prints their table, and ends with the line that counts all of them.
pub(crate) fn test(shell: &Shell, layers: &[Layer]) -> Result<ExitCode> {
    let mut results = Vec::new();
    for &layer in layers {
        let start = Instant::now();
        let outcome = outcome(shell, layer, &results);
        results.push(Report { layer, outcome, time: start.elapsed() });
    }
    println!("\n{}", table(&results));
    let all = total(&results);
    println!("{} passed, {} failed", all.passed, all.failed);
    Ok(if all.failed == 0 { ExitCode::SUCCESS } else { ExitCode::FAILURE })
}

#[derive(Debug)]
struct Report {
    layer: Layer,
    outcome: Outcome,
    time: Duration,
}

#[derive(Debug, Clone, Copy)]
enum Outcome {
    Ran(Counts),
    /// The repository doesn't have the file that the layer would run.
    Absent(&'static str),
}

fn outcome(shell: &Shell, layer: Layer, before: &[Report]) -> Outcome {
    println!("\n── {} ──", layer.name());
    if let Some(file) = layer.needs().filter(|file| !shell.root.join(file).exists()) {
        println!("Left out: there's no {file} yet.");
        return Outcome::Absent(file);
    }
    let no_page = |report: &Report| report.layer == Dist && report.counts().failed > 0;
    if layer == E2e && before.iter().any(no_page) {
        println!("FAILED: there's no page to try, because dist failed.");
        return Outcome::Ran(Counts::FAILED);
    }
    Outcome::Ran(layer.run(shell).unwrap_or_else(|error| {
        println!("FAILED: {error:#}");
        Counts::FAILED
    }))
}

impl Report {
    fn counts(&self) -> Counts {
        match self.outcome {
            Outcome::Ran(counts) => counts,
            Outcome::Absent(_) => Counts::default(),
        }
    }

    fn row(&self) -> String {
        let name = self.layer.name();
        match self.outcome {
            Outcome::Absent(file) => format!("{name:8} left out: there's no {file} yet\n"),
            Outcome::Ran(Counts { passed, failed, ignored }) => {
                let ignored = if ignored > 0 { format!("   ({ignored} ignored)") } else { String::new() };
                format!("{name:8} {passed:>6} {failed:>8} {:>7} s{ignored}\n", self.time.as_secs())
            }
        }
    }
}

fn total(results: &[Report]) -> Counts {
    let mut all = Counts::default();
    results.iter().for_each(|report| all += report.counts());
    all
}

fn table(results: &[Report]) -> String {
    let head = format!("{:8} {:>6} {:>8} {:>9}\n", "layer", "passed", "failed", "time");
    std::iter::once(head).chain(results.iter().map(Report::row)).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    fn names(names: &[&str]) -> Vec<String> {
        names.iter().map(|&name| name.into()).collect()
    }

    #[test]
    fn without_names_every_test_runs() {
        assert_eq!(chosen(&[]).unwrap(), Layer::TESTS);
    }

    #[test]
    fn named_layers_run_in_their_order() {
        assert_eq!(chosen(&names(&["board", "native"])).unwrap(), [Native, Board]);
        assert_eq!(chosen(&names(&["e2e"])).unwrap(), [Dist, E2e]);
        let error = chosen(&names(&["nativ"])).unwrap_err().to_string();
        assert!(error.contains("lint, native, board, fuzz, wasm, dist, e2e, fresh"), "{error}");
    }

    #[test]
    fn the_table_adds_up_and_hides_nothing() {
        let report = |layer, outcome| Report { layer, outcome, time: Duration::from_secs(61) };
        let results = [
            report(Native, Outcome::Ran(Counts { passed: 311, failed: 1, ignored: 2 })),
            report(Board, Outcome::Ran(Counts::PASSED)),
            report(E2e, Outcome::Absent("tests/e2e/Cargo.toml")),
        ];
        assert_eq!(total(&results), Counts { passed: 312, failed: 1, ignored: 2 });
        let expected = "\
layer    passed   failed      time
native      311        1      61 s   (2 ignored)
board         1        0      61 s
e2e      left out: there's no tests/e2e/Cargo.toml yet
";
        assert_eq!(table(&results), expected);
    }
}
