//! Reading what test runners print.

use std::ops::AddAssign;

/// How many tests passed, failed, or were set aside by their author.
#[derive(Debug, Default, Clone, Copy, PartialEq, Eq)]
pub(crate) struct Counts {
    pub(crate) passed: usize,
    pub(crate) failed: usize,
    pub(crate) ignored: usize,
}

impl Counts {
    pub(crate) const PASSED: Self = Self { passed: 1, failed: 0, ignored: 0 };
    pub(crate) const FAILED: Self = Self { passed: 0, failed: 1, ignored: 0 };

    /// What `cargo test` printed and how it ended. One that failed without a failed test did not even build, or broke.
    pub(crate) fn of_cargo_test(ok: bool, output: &str) -> Self {
        let mut counts = Self::default();
        output.lines().filter_map(result_line).for_each(|part| counts += part);
        if !ok && counts.failed == 0 {
            counts.failed = 1;
        }
        counts
    }
}

impl AddAssign for Counts {
    fn add_assign(&mut self, other: Self) {
        self.passed += other.passed;
        self.failed += other.failed;
        self.ignored += other.ignored;
    }
}

/// `test result: ok. 3 passed; 0 failed; 1 ignored; 0 measured; 0 filtered out; finished in 0.00s`
fn result_line(line: &str) -> Option<Counts> {
    let (_, parts) = line.trim().strip_prefix("test result: ")?.split_once(". ")?;
    let count = |what: &str| {
        let mut words = parts.split("; ").filter_map(|part| part.split_once(' '));
        words.find(|(_, name)| *name == what).and_then(|(number, _)| number.parse().ok())
    };
    Some(Counts {
        passed: count("passed")?,
        failed: count("failed")?,
        ignored: count("ignored").unwrap_or(0),
    })
}

/// Whether a line of `cargo test` says more than that one more test passed.
pub(crate) fn worth_showing(line: &str) -> bool {
    let passed = line.starts_with("test ") && (line.ends_with(" ... ok") || line.contains(" ... ignored"));
    let heading = line.starts_with("running ") && (line.ends_with(" tests") || line.ends_with(" test"));
    let empty = line.trim().is_empty() || line.starts_with("test result: ok. 0 passed");
    !(passed || heading || empty)
}

#[cfg(test)]
mod tests {
    use super::*;

    const OUTPUT: &str = "
running 3 tests
test a ... ok
test b ... FAILED
test result: FAILED. 1 passed; 1 failed; 1 ignored; 0 measured; 0 filtered out; finished in 0.01s

running 4 tests
test result: ok. 4 passed; 0 failed; 0 ignored; 0 measured; 0 filtered out; finished in 0.00s
";

    #[test]
    fn results_add_up() {
        assert_eq!(Counts::of_cargo_test(false, OUTPUT), Counts { passed: 5, failed: 1, ignored: 1 });
    }

    #[test]
    fn the_short_line_of_browser_tests_is_read_too() {
        let line = "test result: ok. 2 passed; 0 failed; 0 ignored; 0 filtered out; finished in 0.1s\n";
        assert_eq!(Counts::of_cargo_test(true, line), Counts { passed: 2, failed: 0, ignored: 0 });
    }

    #[test]
    fn a_failed_build_is_a_failure() {
        assert_eq!(Counts::of_cargo_test(false, "error: could not compile"), Counts::FAILED);
        let aborted =
            "test result: ok. 4 passed; 0 failed; 0 ignored; 0 measured\nprocess didn't exit successfully";
        assert_eq!(Counts::of_cargo_test(false, aborted), Counts { passed: 4, failed: 1, ignored: 0 });
        assert_eq!(Counts::of_cargo_test(true, ""), Counts::default());
    }

    #[test]
    fn passing_tests_are_quiet_and_failing_ones_are_not() {
        for quiet in ["test a ... ok", "test b ... ignored, slow", "running 1 test", "running 12 tests", ""] {
            assert!(!worth_showing(quiet), "{quiet}");
        }
        let result = "test result: ok. 4 passed; 0 failed; 0 ignored";
        for shown in ["test b ... FAILED", "failures:", "running late", result] {
            assert!(worth_showing(shown), "{shown}");
        }
    }
}
