//! Tables as CSV (RFC 4180) that a spreadsheet shows as they are: no text in them is taken for a formula.

use alloc::string::String;
use core::fmt::Write;

use crate::report::tidy;

/// A table that is being written, cell by cell.
#[derive(Debug)]
pub(crate) struct Csv(String);

impl Csv {
    /// A table with this head: names with commas between them.
    pub(crate) fn new(head: &str) -> Self {
        let mut csv = Self(String::from(head));
        csv.0.push('\n');
        csv
    }

    /// A cell of text, in quotes where it needs them.
    pub(crate) fn text(&mut self, value: &str) {
        let guard = if is_formula(value) { "'" } else { "" };
        if value.contains([',', '"', '\n', '\r']) {
            self.0.push('"');
            self.0.push_str(guard);
            self.0.push_str(&value.replace('"', "\"\""));
            self.0.push('"');
        } else {
            self.0.push_str(guard);
            self.0.push_str(value);
        }
        self.0.push(',');
    }

    /// A cell with a number; empty where there is none.
    pub(crate) fn number(&mut self, number: Option<f64>) {
        if let Some(number) = number {
            // Writing to a string cannot fail.
            let _ = write!(self.0, "{}", tidy(number));
        }
        self.0.push(',');
    }

    /// The row is complete.
    pub(crate) fn end_row(&mut self) {
        // The last comma has no cell after it.
        self.0.pop();
        self.0.push('\n');
    }

    /// The file.
    pub(crate) fn finish(self) -> String {
        self.0
    }
}

/// Whether spreadsheets would work a text out instead of showing it (OWASP, *CSV Injection*); a number is what it
/// is either way.
fn is_formula(text: &str) -> bool {
    text.starts_with(['=', '+', '-', '@', '\t', '\r', '\n', '＝', '＋', '－', '＠'])
        && !text.parse::<f64>().is_ok_and(f64::is_finite)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn no_text_is_a_formula_and_numbers_stay_numbers() {
        for (value, cell) in [
            ("=1+1", "'=1+1"),
            ("+A1", "'+A1"),
            ("-A1", "'-A1"),
            ("@SUM(A1)", "'@SUM(A1)"),
            ("\t=1", "'\t=1"),
            ("\r=1", "\"'\r=1\""),
            ("=HYPERLINK(\"a\",\"b\")", "\"'=HYPERLINK(\"\"a\"\",\"\"b\"\")\""),
            ("-", "'-"),
            ("-inf", "'-inf"),
            ("-5", "-5"),
            ("+1.5e3", "+1.5e3"),
            ("a=b", "a=b"),
            ("mazes/a-b.maze", "mazes/a-b.maze"),
        ] {
            let mut csv = Csv::new("text,number");
            csv.text(value);
            csv.number(Some(-0.5));
            csv.end_row();
            assert_eq!(csv.finish(), alloc::format!("text,number\n{cell},-0.5\n"));
        }
    }
}
