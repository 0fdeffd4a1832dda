//! The book's algorithm as pseudo-code: §3.3 announces it and leaves it unwritten, this is §3.1 and §2.5 made
//! exact. The stepper shows these lines and marks the one that runs.

/// A line of [`LISTING`].
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct Line(u8);

/// A line as it is shown.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Listed {
    /// `1` to `30`; `+` for our own line between 3 and 4; empty between the functions.
    pub label: &'static str,
    /// The code, indented by two spaces a level; what follows `#` is a comment.
    pub text: &'static str,
}

macro_rules! listing {
    ($($name:ident $label:literal $text:literal)*) => {
        listing!(@constants 0u8; $($name)*);
        /// The pseudo-code, in order.
        pub const LISTING: &[Listed] = &[$(Listed { label: $label, text: $text }),*];
    };
    (@constants $n:expr; $name:ident $($rest:ident)*) => {
        impl Line {
            #[doc = concat!("The line `", stringify!($name), "` of the listing.")]
            pub const $name: Self = Self($n);
        }
        listing!(@constants $n + 1; $($rest)*);
    };
    (@constants $n:expr;) => {};
}

listing! {
    ACT            "1"  "act():"
    GET            "2"  "  get_coords(); get_paths()"
    FINISH         "3"  "  if finish_var:            finish()"
    EXHAUSTED      "+"  "  else if at the start, ptr == 1:  stop  # ours: nothing is left"
    DEAD_END       "4"  "  else if dead end:         uturn(); returning = true"
    CORNER         "5"  "  else if corner:           turn the only way there is"
    NODE           "6"  "  else:                     node()"
    GAP_1          ""   ""
    NODE_FN        "8"  "node():"
    MATCH          "9"  "  m = match_cur_node()"
    IF_NEW         "10" "  if m == 0:                # new"
    RECORD         "11" "    m = record_node(); ptr = ptr + 1"
    CHOOSE_NEW     "12" "    choose_path(m)"
    IF_RETURNING   "13" "  else if returning:        # RETURN-KNOWN"
    KNOWN_PTR      "14" "    ptr = m + 1"
    KNOWN_CHOOSE   "15" "    if not choose_path(m): take_return_path(m)"
    ELSE_UNKNOWN   "16" "  else:                     # RETURN-UNKNOWN"
    MARK_ARRIVAL   "17" "    nodes[m].vpaths[arrival] = true"
    IF_UNVISITED   "18" "    if unvisited(m, ptr - 1): uturn(); returning = true"
    ELSE_LOOP      "19" "    else:"
    LOOP_PTR       "20" "      ptr = m + 1"
    LOOP_CHOOSE    "21" "      if not choose_path(m): take_return_path(m)"
    GAP_2          ""   ""
    CHOOSE_FN      "23" "choose_path(m):"
    FIRST          "24" "  d = first of the order that exists at m, unvisited"
    NONE_LEFT      "25" "  if there is none: return false"
    TAKE           "26" "  nodes[m].vpaths[d] = true; last_path = d; returning = false; turn to d; return true"
    GAP_3          ""   ""
    RETURN_FN      "28" "take_return_path(m):"
    BACK           "29" "  turn to nodes[m].back_path; returning = true"
    FORGET         "30" "  ptr = ptr - 1             # node m is forgotten"
}

/// The lines that are the lab's reading, in part at least: the book leaves open what they do, or keeps silent. That it
/// leaves the whole of its pseudo-code unwritten (§3.3) is said beside it.
pub const OURS: &[Line] = &[Line::EXHAUSTED, Line::KNOWN_PTR, Line::MARK_ARRIVAL, Line::LOOP_PTR, Line::TAKE];

impl Line {
    /// Its place in [`LISTING`].
    #[must_use]
    pub const fn index(self) -> usize {
        self.0 as usize
    }

    /// As it is shown.
    #[must_use]
    pub const fn listed(self) -> Listed {
        LISTING[self.0 as usize]
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn labels_are_the_line_numbers() {
        let numbers = LISTING.iter().filter_map(|line| line.label.parse::<u32>().ok());
        let expected = (1..=30).filter(|n| ![7, 22, 27].contains(n));
        assert!(numbers.eq(expected));
        assert_eq!(Line::IF_UNVISITED.listed().label, "18");
        assert_eq!(Line::FORGET.index(), LISTING.len() - 1);
    }
}
