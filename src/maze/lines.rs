//! The lines of a text, however they end: with LF, with CRLF, or with CR alone, as old programs have it. Files that
//! went through several of them may hold all three.

/// Lines with their numbers from 1, without their ends.
///
/// ```
/// use line_maze_lab::maze::Lines;
/// let lines: Vec<_> = Lines::of("a\nb\r\nc\rd").collect();
/// assert_eq!(lines, [(1, "a"), (2, "b"), (3, "c"), (4, "d")]);
/// ```
#[derive(Clone, Copy, Debug)]
pub struct Lines<'a> {
    /// What is left up to the next LF, where CRs cut it.
    here: Option<&'a str>,
    /// What follows that LF.
    rest: Option<&'a str>,
    number: u32,
}

impl<'a> Lines<'a> {
    /// Those of a text; an end at its end begins a last, empty line.
    #[must_use]
    pub const fn of(text: &'a str) -> Self {
        Self { here: None, rest: Some(text), number: 0 }
    }

    /// The number of the last line that was told; 0 before the first.
    #[must_use]
    pub const fn number(&self) -> u32 {
        self.number
    }

    /// The text up to the next LF. CRs before it belong to it, also where a program put in one more.
    fn up_to_lf(&mut self) -> Option<&'a str> {
        let rest = self.rest.take()?;
        let Some((before, after)) = rest.split_once('\n') else { return Some(rest) };
        self.rest = Some(after);
        Some(before.trim_end_matches('\r'))
    }
}

impl<'a> Iterator for Lines<'a> {
    type Item = (u32, &'a str);

    fn next(&mut self) -> Option<Self::Item> {
        let piece = match self.here.take() {
            Some(piece) => piece,
            None => self.up_to_lf()?,
        };
        let line = match piece.split_once('\r') {
            Some((line, after)) => {
                self.here = Some(after);
                line
            }
            None => piece,
        };
        self.number += 1;
        Some((self.number, line))
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use alloc::string::String;
    use alloc::vec::Vec;

    fn told(text: &str) -> Vec<&str> {
        Lines::of(text).map(|(_, line)| line).collect()
    }

    #[test]
    fn every_end_ends_a_line_once() {
        for end in ["\n", "\r\n", "\r", "\r\r\n"] {
            assert_eq!(told(&["a", "", "b", ""].join(end)), ["a", "", "b", ""], "{end:?}");
        }
        assert_eq!(told(""), [""]);
        assert_eq!(told("\r"), ["", ""]);
    }

    #[test]
    fn many_ends_take_no_longer_than_they_are_long() {
        let text: String = core::iter::repeat_n('\r', 200_000).collect();
        assert_eq!(Lines::of(&text).count(), 200_001);
    }
}
