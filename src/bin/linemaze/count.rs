//! Numbers of things, for people: 1 turn, 2 turns.

use std::fmt::Display;

/// A number and its thing, with an s where it is not one.
pub(crate) fn count(number: impl Display, thing: &str) -> String {
    let number = number.to_string();
    let s = if number == "1" { "" } else { "s" };
    format!("{number} {thing}{s}")
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn only_one_is_singular() {
        assert_eq!(
            [count(0, "stop"), count(1, "U-turn"), count(21, "cell")],
            ["0 stops", "1 U-turn", "21 cells"]
        );
    }
}
