//! Numbers with a few decimals, for pictures and tables. The standard library's own formatting of floats is a
//! tenth of what the page may weigh; these need no more than whole numbers do.

use core::fmt;

/// A number, written with at most so many decimals and without zeros at the end; `{:#}` keeps the zeros.
///
/// ```
/// use line_maze_lab::decimal::Decimal;
/// assert_eq!(Decimal(-2.504, 2).to_string(), "-2.5");
/// assert_eq!(format!("{:#}", Decimal(2.0, 2)), "2.00");
/// assert_eq!(Decimal(1.0 / 3.0, 3).to_string(), "0.333");
/// assert_eq!(Decimal(-0.001, 2).to_string(), "0");
/// assert_eq!(Decimal(f64::NAN, 2).to_string(), "0");
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Decimal(pub f64, pub u8);

impl fmt::Display for Decimal {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let digits = usize::from(self.1.min(9));
        let one = 10_u64.pow(digits as u32);
        let scaled = self.0 * one as f64;
        // Half away from zero; `as` takes NaN for 0 and stays within the type's bounds.
        let units = (if scaled < 0.0 { scaled - 0.5 } else { scaled + 0.5 }) as i64;
        let sign = if units < 0 { "-" } else { "" };
        let (whole, mut part) = (units.unsigned_abs() / one, units.unsigned_abs() % one);
        if digits == 0 || (part == 0 && !f.alternate()) {
            return write!(f, "{sign}{whole}");
        }
        let mut width = digits;
        while part % 10 == 0 && !f.alternate() {
            part /= 10;
            width -= 1;
        }
        write!(f, "{sign}{whole}.{part:0width$}")
    }
}
