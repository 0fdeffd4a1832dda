//! Sizes on the floor: how long a cell is and how wide the line, kept in whole micrometres so that every
//! file format gives back exactly what it was given.

use core::fmt;

/// Sizes on the floor, exact to a thousandth of a millimetre.
///
/// ```
/// use line_maze_lab::maze::Scale;
/// let scale = Scale::new(180.0, 19.05)?;
/// assert_eq!(scale.line_mm(), 19.05);
/// # Ok::<(), line_maze_lab::maze::ScaleError>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Scale {
    cell_um: u32,
    line_um: u32,
}

/// Why sizes on the floor make no sense.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum ScaleError {
    /// `cell_mm` is not between 1 and 10,000.
    Cell,
    /// `line_mm` is not between 0.1 and `cell_mm`.
    Line,
}

impl fmt::Display for ScaleError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(match self {
            Self::Cell => "a cell is 1 to 10,000 mm long",
            Self::Line => "a line is at least 0.1 mm wide, and not wider than a cell is long",
        })
    }
}

impl core::error::Error for ScaleError {}

impl Scale {
    /// A cell's length and a line's width, rounded to a thousandth of a millimetre.
    ///
    /// # Errors
    /// Where one of them is out of its range.
    pub fn new(cell_mm: f64, line_mm: f64) -> Result<Self, ScaleError> {
        if !(1.0..=10_000.0).contains(&cell_mm) {
            Err(ScaleError::Cell)
        } else if !(0.1..=cell_mm).contains(&line_mm) {
            Err(ScaleError::Line)
        } else {
            Ok(Self { cell_um: micrometres(cell_mm), line_um: micrometres(line_mm) })
        }
    }

    /// The same from whole micrometres.
    pub(crate) fn from_um(cell_um: u32, line_um: u32) -> Result<Self, ScaleError> {
        Self::new(f64::from(cell_um) / 1000.0, f64::from(line_um) / 1000.0)
    }

    /// Length of one cell, 1 to 10,000 mm.
    #[must_use]
    pub const fn cell_mm(self) -> f64 {
        self.cell_um as f64 / 1000.0
    }

    /// Width of the line, 0.1 mm to a cell.
    #[must_use]
    pub const fn line_mm(self) -> f64 {
        self.line_um as f64 / 1000.0
    }

    /// Length of one cell in micrometres.
    pub(crate) const fn cell_um(self) -> u32 {
        self.cell_um
    }

    /// Width of the line in micrometres.
    pub(crate) const fn line_um(self) -> u32 {
        self.line_um
    }
}

/// A length in millimetres such as `180` or `19.5`; none where the text is anything else. Digit by digit: the
/// standard library's parser brings a table of ten kilobytes into the page.
///
/// ```
/// use line_maze_lab::maze::millimetres;
/// assert_eq!(millimetres("19.5"), Some(19.5));
/// assert_eq!(millimetres("1e3"), None);
/// ```
#[must_use]
pub fn millimetres(text: &str) -> Option<f64> {
    let (whole, part) = text.split_once('.').unwrap_or((text, ""));
    let digits = |text: &str| text.bytes().all(|byte| byte.is_ascii_digit());
    if !digits(whole) || !digits(part) || whole.len() + part.len() == 0 {
        return None;
    }
    let value =
        |text: &str, start: f64| text.bytes().fold(start, |sum, byte| sum * 10.0 + f64::from(byte - b'0'));
    // Nothing is kept below a thousandth of a millimetre; nine digits are plenty.
    let part = &part[..part.len().min(9)];
    let unit = part.bytes().fold(1.0, |unit, _| unit * 10.0);
    Some(value(whole, 0.0) + value(part, 0.0) / unit)
}

/// Rounds; `f64::round` is not in `core`.
fn micrometres(mm: f64) -> u32 {
    (mm * 1000.0 + 0.5) as u32
}

impl Default for Scale {
    fn default() -> Self {
        Self { cell_um: 200_000, line_um: 20_000 }
    }
}
