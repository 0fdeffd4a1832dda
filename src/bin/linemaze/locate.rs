//! Where in a JSON text a value is, for a path such as `lines[3][1]`: what a message needs to name line and
//! column. The text is known to be JSON.

use line_maze_lab::maze::text::Place;

/// The place of a value; of the innermost one around it that there is.
pub(crate) fn value(text: &str, path: &str) -> Place {
    let mut scan = Scan { text, at: 0 };
    let mut found = scan.here();
    for step in path.split(['.', '[', ']']).filter(|step| !step.is_empty()) {
        if !scan.enter(step) {
            break;
        }
        found = scan.here();
    }
    Place::after(&text[..found])
}

/// A reading place in a text.
struct Scan<'t> {
    text: &'t str,
    at: usize,
}

impl Scan<'_> {
    /// The next byte that is not blank.
    fn peek(&mut self) -> u8 {
        let blank = |c: char| c.is_ascii_whitespace() || c == '\u{feff}';
        let rest = &self.text[self.at..];
        self.at += rest.len() - rest.trim_start_matches(blank).len();
        self.text.as_bytes().get(self.at).copied().unwrap_or(0)
    }

    fn here(&mut self) -> usize {
        self.peek();
        self.at
    }

    /// Goes to the value of a key, or to the element with this number; false where there is none.
    fn enter(&mut self, step: &str) -> bool {
        let keyed = match self.peek() {
            b'{' => true,
            b'[' => false,
            _ => return false,
        };
        self.at += 1;
        for number in 0usize.. {
            if matches!(self.peek(), b'}' | b']' | 0) {
                return false;
            }
            let mut wanted = number.to_string() == step;
            if keyed {
                let from = self.at;
                self.skip();
                wanted = self.text[from..self.at].trim_matches('"') == step;
                self.peek();
                self.at += 1;
            }
            self.peek();
            if wanted {
                return true;
            }
            self.skip();
            if self.peek() == b',' {
                self.at += 1;
            }
        }
        false
    }

    /// Goes past a value.
    fn skip(&mut self) {
        self.peek();
        let mut depth = 0usize;
        let mut quoted = false;
        let mut bytes = self.text.bytes().enumerate().skip(self.at);
        while let Some((at, byte)) = bytes.next() {
            self.at = at;
            match byte {
                b'\\' if quoted => {
                    bytes.next();
                }
                b'"' => quoted = !quoted,
                _ if quoted => {}
                b'{' | b'[' => depth += 1,
                b',' | b':' | b'}' | b']' if depth == 0 => return,
                b'}' | b']' => depth -= 1,
                _ => {}
            }
        }
        self.at = self.text.len();
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn values_are_found_by_their_path() {
        let text = "{\"note\": \"a, \\\"b\\\" [\",\n \"start\": {\"at\": [0, 7], \"heading\": \"N\"},\n \"lines\": [[[0, 0],\n   [0, 5]], [[1, 1], [2, 2]]]}";
        for (path, line, column) in [
            ("note", 1, 10),
            ("start", 2, 11),
            ("start.at", 2, 18),
            ("start.at[1]", 2, 22),
            ("lines", 3, 11),
            ("lines[0][1]", 4, 4),
            ("lines[1][1]", 4, 22),
            ("lines[1][9]", 4, 13),
            ("bounds", 1, 1),
        ] {
            assert_eq!(value(text, path), Place { line, column }, "{path}");
        }
    }
}
