//! How an explorer writes down its pseudo-code and its cases: once, in order, with a name for each.

/// Makes `LISTING`, the lines of the pseudo-code (indented by two spaces a level; what follows `#` is a
/// comment), and in `line` a name for the number of each. `lab` before a line says that it is, in part at least, the
/// lab's reading: the source leaves it open or says otherwise.
macro_rules! listing {
    ($($name:ident $($whose:ident)? $text:literal)*) => {
        /// The pseudo-code in our own words, in order; lines are numbered from 1.
        pub const LISTING: &[&str] = &[$($text),*];
        /// Which of its lines are the lab's reading.
        pub const OURS: &[bool] = &[$(ours!($($whose)?)),*];
        mod line {
            numbered!(0u8; $($name)*);
        }
    };
}

/// Makes `CASES`, what a stop can be, and in `case` a name for the number of each.
macro_rules! cases {
    ($($name:ident $word:literal $tone:ident $mark:ident $told:literal)*) => {
        /// What a stop can be, with the words for it.
        pub static CASES: &[$crate::explorer::tell::Case] = &[$($crate::explorer::tell::Case {
            name: $word,
            shown: {
                const SHOWN: [u8; $word.len()] = $crate::explorer::tell::spaced($word);
                $crate::explorer::tell::text(&SHOWN)
            },
            tone: $crate::explorer::book::narrate::Tone::$tone,
            mark: $crate::playback::Mark::$mark,
            told: $told,
        }),*];
        mod case {
            numbered!(0u8; $($name)*);
        }
    };
}

/// Whether a line is the lab's reading.
macro_rules! ours {
    (lab) => {
        true
    };
    () => {
        false
    };
}

/// Constants that count on.
macro_rules! numbered {
    ($n:expr; $name:ident $($rest:ident)*) => {
        #[allow(dead_code)] // Heads of functions and empty lines never run.
        pub(super) const $name: u8 = $n;
        numbered!($n + 1; $($rest)*);
    };
    ($n:expr;) => {};
}
