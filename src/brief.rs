//! What a message echoes: as much of it as helps to find it again.

use alloc::string::String;

/// Characters that are echoed.
const SHOWN: usize = 24;

/// A text as messages repeat it: its beginning, where it is long.
///
/// ```
/// use line_maze_lab::brief::brief;
/// assert_eq!(brief("30x40"), "30x40");
/// assert_eq!(brief(&"9".repeat(300)), "999999999999999999999999…");
/// ```
#[must_use]
pub fn brief(text: &str) -> String {
    let mut shown: String = text.chars().take(SHOWN).collect();
    if text.chars().nth(SHOWN).is_some() {
        shown.push('…');
    }
    shown
}
