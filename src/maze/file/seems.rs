//! What a file that cannot be read seems to be, and what to do instead.

use core::fmt;

/// What people open by mistake, or have in another form than those that are read.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Seems {
    /// PNG, JPEG, GIF, SVG, PDF.
    Picture,
    /// ZIP, gzip.
    Archive,
    /// Text of two bytes a character.
    Utf16,
    /// HTML or XML.
    WebPage,
    /// C, C++, Python, JavaScript.
    Program,
    /// A drawing in line or block characters.
    Boxes,
    /// A drawing of `_` and `|`.
    Underlines,
    /// A drawing of lines as `.maze` files have it, without the header.
    LinesWithoutHeader,
    /// Letters of turns.
    TurnList,
}

impl Seems {
    /// Of bytes that begin no text.
    pub(super) fn of_bytes(bytes: &[u8]) -> Option<Self> {
        const BEGINNINGS: [(&[u8], Seems); 8] = [
            (b"\x89PNG", Seems::Picture),
            (b"\xff\xd8\xff", Seems::Picture),
            (b"GIF8", Seems::Picture),
            (b"%PDF", Seems::Picture),
            (b"PK\x03\x04", Seems::Archive),
            (b"\x1f\x8b", Seems::Archive),
            (b"\xff\xfe", Seems::Utf16),
            (b"\xfe\xff", Seems::Utf16),
        ];
        BEGINNINGS.into_iter().find(|(begin, _)| bytes.starts_with(begin)).map(|(_, seems)| seems)
    }

    /// Of a text in no format.
    pub(super) fn of_text(text: &str) -> Option<Self> {
        const BEGINNINGS: [(&str, Seems); 14] = [
            ("%pdf", Seems::Picture),
            ("<svg", Seems::Picture),
            ("<", Seems::WebPage),
            ("#include", Seems::Program),
            ("#define", Seems::Program),
            ("//", Seems::Program),
            ("/*", Seems::Program),
            ("const ", Seems::Program),
            ("static ", Seems::Program),
            ("unsigned ", Seems::Program),
            ("uint8_t ", Seems::Program),
            ("import ", Seems::Program),
            ("maze = [", Seems::Program),
            ("int ", Seems::Program),
        ];
        let words = text.trim();
        let start = words.get(..16).unwrap_or(words).to_ascii_lowercase();
        if let Some((_, seems)) = BEGINNINGS.into_iter().find(|(begin, _)| start.starts_with(begin)) {
            return Some(seems);
        }
        if words.chars().any(|c| matches!(c, '\u{2500}'..='\u{259f}')) {
            return Some(Self::Boxes);
        }
        let only = |some: &str| words.chars().all(|c| c.is_whitespace() || some.contains(c));
        if words.contains('_') && only("_|.SG") {
            return Some(Self::Underlines);
        }
        if Self::is_lines(words) {
            return Some(Self::LinesWithoutHeader);
        }
        (!words.contains('\n') && only("LRSBFUlrsbfu,;'\"{}")).then_some(Self::TurnList)
    }

    /// Whether a text is made of what `.maze` files draw lines with, start or finish among it.
    pub(super) fn is_lines(text: &str) -> bool {
        const MARKS: [char; 5] = ['F', '^', '>', 'v', '<'];
        text.contains(MARKS)
            && text.chars().all(|c| c.is_whitespace() || "+-|.".contains(c) || MARKS.contains(&c))
    }

    const fn words(self) -> &'static str {
        match self {
            Self::Picture => {
                "this seems to be a picture; a maze cannot be read from one, draw it in the room Draw instead"
            }
            Self::Archive => "this seems to be an archive; take the files out of it first",
            Self::Utf16 => "this seems to be text in UTF-16; save it as UTF-8",
            Self::WebPage => "this seems to be a web page; save the maze alone, as a text file",
            Self::Program => "this seems to be a program; copy the maze alone into a file",
            Self::Boxes => {
                "this seems to be a drawing in line or block characters; draw walls with “+”, “-” and “|”, or a \
                 grid with “#”"
            }
            Self::Underlines => {
                "this seems to be a drawing of “_” and “|”; draw walls with “+”, “-” and “|”, or a grid with “#”"
            }
            Self::LinesWithoutHeader => {
                "this seems to be a drawing of lines without a header; put “line-maze: 1” and a blank line above it"
            }
            Self::TurnList => "this seems to be a turn list, not a maze; the turn-list lab reads it",
        }
    }
}

impl fmt::Display for Seems {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(self.words())
    }
}

/// What is said of a text in no format; where it seems to be nothing either, what is read.
pub(super) struct Told(pub(super) Option<Seems>);

impl fmt::Display for Told {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self.0 {
            Some(seems) => seems.fmt(f),
            None => f.write_str(
                "no maze file begins like this; begin with “line-maze: 1”, or give a drawing of walls (posts “o” or \
                 “+”), a grid of “#”, a .num or .maz file, or JSON",
            ),
        }
    }
}
