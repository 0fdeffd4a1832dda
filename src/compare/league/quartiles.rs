//! Median and quartiles: what is in the middle of many numbers, and how far they spread. Between two numbers they
//! are taken in proportion (Hyndman and Fan's type 7, as spreadsheets do).

use alloc::vec::Vec;

/// Five numbers about many.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Quartiles {
    /// How many there are.
    pub count: usize,
    /// The smallest.
    pub least: f64,
    /// A quarter is at most this.
    pub lower: f64,
    /// Half is at most this.
    pub median: f64,
    /// Three quarters are at most this.
    pub upper: f64,
    /// The greatest.
    pub most: f64,
}

impl Quartiles {
    /// Those of these numbers; none where there are none.
    ///
    /// ```
    /// use line_maze_lab::compare::league::Quartiles;
    /// let five = Quartiles::of([4.0, 1.0, 2.0, 3.0]).unwrap();
    /// assert_eq!([five.least, five.lower, five.median, five.upper, five.most], [1.0, 1.75, 2.5, 3.25, 4.0]);
    /// assert_eq!(Quartiles::of([]), None);
    /// ```
    #[must_use]
    pub fn of(numbers: impl IntoIterator<Item = f64>) -> Option<Self> {
        let mut numbers: Vec<f64> = numbers.into_iter().collect();
        numbers.sort_unstable_by(f64::total_cmp);
        let (&least, &most) = (numbers.first()?, numbers.last()?);
        let quarter = |quarters: usize| {
            // In quarters of a place, so that whole numbers do.
            let place = (numbers.len() - 1) * quarters;
            let (below, part) = (numbers[place / 4], place % 4);
            let above = numbers.get(place / 4 + 1).copied().unwrap_or(below);
            below + (above - below) * part as f64 / 4.0
        };
        Some(Self {
            count: numbers.len(),
            least,
            lower: quarter(1),
            median: quarter(2),
            upper: quarter(3),
            most,
        })
    }
}
