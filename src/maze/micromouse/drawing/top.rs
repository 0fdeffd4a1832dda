//! The first line of a drawing: it tells which character the posts are, how far apart they stand, and so whether
//! this is a drawing at all.

use super::super::indented;

/// Columns of text for a square in the contests' files.
pub(super) const USUAL: usize = 4;
/// Other programs draw squares that are narrower or wider.
const PITCHES: [usize; 5] = [2, 3, USUAL, 5, 6];
/// Posts that files of contest programs have.
const POSTS: [char; 2] = ['o', '+'];
/// Posts that people draw instead.
const OTHER_POSTS: [char; 3] = ['O', '.', '*'];
/// What stands where nobody knows whether there is a wall.
pub(super) const UNKNOWN: [char; 3] = ['.', ':', '?'];

/// The first line of a drawing.
pub(in crate::maze::micromouse) struct Top<'t> {
    /// The blanks before it.
    pub(super) indent: &'t str,
    /// From the first post to the last.
    pub(super) line: &'t str,
    /// The first post.
    pub(super) post: char,
    /// Columns from post to post; the usual ones where the posts tell none.
    pub(super) pitch: usize,
    /// Whether all posts are where they should be.
    aligned: bool,
}

/// Who drew it, and so what a wall looks like.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Style {
    /// `---` and `|`.
    Strict,
    /// Any character, as in the mms simulator.
    Loose,
}

impl<'t> Top<'t> {
    /// A line that may be one: it begins with a post.
    pub(in crate::maze::micromouse) fn of(line: &'t str) -> Option<Self> {
        let (indent, rest) = indented(line);
        let rest = rest.trim_end();
        let post = rest.chars().next().filter(|c| POSTS.contains(c) || OTHER_POSTS.contains(c))?;
        let mut top = Self { indent, line: rest, post, pitch: USUAL, aligned: false };
        let columns = rest.chars().count();
        let posts_stand = |pitch: usize| {
            columns > pitch && columns % pitch == 1 && rest.chars().step_by(pitch).all(|c| top.is_post(c))
        };
        if let Some(pitch) = PITCHES.into_iter().find(|&pitch| posts_stand(pitch)) {
            (top.pitch, top.aligned) = (pitch, true);
        }
        Some(top)
    }

    /// Whether a file that begins so can be taken for a drawing, though the line may be damaged.
    pub(in crate::maze::micromouse) fn begins(&self) -> bool {
        let after = self.line.chars().nth(1);
        // A word may begin with o too.
        self.indent.is_empty()
            && (self.post == '+' || self.post == 'o' && !after.is_some_and(char::is_alphanumeric))
    }

    /// Whether this can be nothing else: posts and walls from end to end, and a wall below the first post.
    pub(in crate::maze::micromouse) fn is_sure(&self, next: &str) -> bool {
        let walls = self.line.chars().enumerate().filter(|(column, _)| column % self.pitch != 0);
        let below = next.strip_prefix(self.indent).and_then(|below| below.chars().next());
        self.aligned
            && walls.map(|(_, c)| c).all(|c| c == '-' || c == ' ' || UNKNOWN.contains(&c))
            && self.line.contains('-')
            && below.is_some_and(|c| c == '|' || UNKNOWN.contains(&c))
    }

    pub(super) fn is_post(&self, c: char) -> bool {
        if POSTS.contains(&self.post) { POSTS.contains(&c) } else { c == self.post }
    }

    /// Whether files of contest programs have such posts.
    pub(super) fn has_usual_posts(&self) -> bool {
        POSTS.contains(&self.post)
    }

    pub(super) const fn style(&self) -> Style {
        if self.post == '+' { Style::Loose } else { Style::Strict }
    }

    /// Its columns of text, without the blanks before it.
    pub(super) fn columns(&self) -> usize {
        self.line.chars().count()
    }

    /// Columns before it.
    pub(super) fn margin(&self) -> usize {
        self.indent.chars().count()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn pitch(line: &str) -> Option<(usize, bool)> {
        Top::of(line).map(|top| (top.pitch, top.aligned))
    }

    #[test]
    fn posts_tell_how_wide_a_square_is() {
        assert_eq!(pitch("o---o---o"), Some((4, true)));
        assert_eq!(pitch("  O---O"), Some((4, true)));
        assert_eq!(pitch("+-+-+"), Some((2, true)));
        assert_eq!(pitch("+--+--+--+"), Some((3, true)));
        assert_eq!(pitch("+###+===+"), Some((4, true)));
        assert_eq!(pitch("o---o---o---"), Some((4, false)), "the usual width");
        assert_eq!(pitch("line-maze: 1"), None);
    }

    #[test]
    fn what_is_sure_is_no_word_and_no_lone_line() {
        let sure = |line: &str, next: &str| Top::of(line).is_some_and(|top| top.is_sure(next));
        assert!(sure(".---.---.", "|       |") && sure("    o---o", "    |   |") && sure("+-+ +", "| | |"));
        assert!(
            !sure("o---o", "") && !sure("o   o", "|   |") && !sure("on", "|") && !sure("  o---o", "|   |")
        );
        let begins = |line: &str| Top::of(line).is_some_and(|top| top.begins());
        assert!(begins("o-x-o") && begins("+") && !begins("origin") && !begins(".---.") && !begins(" o---o"));
    }
}
