//! The turn-list lab: what can be done with letters on paper. A dead end between two turns is one turn: after
//! `xBy`, the three become the turns' sum modulo 360° (`LBL` is `S`, `SBS` is `B`).

use alloc::vec::Vec;

use super::turn_list::TurnList;
use crate::geometry::Turn;

/// One reduction: three letters become one.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Reduction {
    /// Where the three stood in the list before, from 0.
    pub at: usize,
    /// The three; the middle one is `B`.
    pub three: [Turn; 3],
    /// What they become.
    pub one: Turn,
}

/// The first `xBy` of a list, if there is one.
///
/// ```
/// use line_maze_lab::route::{lab, letters};
/// let reduction = lab::first(letters::read("SLBLR")?.turns()).map(|first| (first.at, first.one.letter()));
/// assert_eq!(reduction, Some((1, 'S')));
/// # Ok::<(), line_maze_lab::route::letters::Misread>(())
/// ```
#[must_use]
pub fn first(turns: &[Turn]) -> Option<Reduction> {
    let at = turns.windows(3).position(|three| three[1] == Turn::Back)?;
    let three = [turns[at], turns[at + 1], turns[at + 2]];
    Some(Reduction { at, three, one: sum(three) })
}

/// The turns one after another, as one turn.
#[must_use]
pub fn sum(turns: [Turn; 3]) -> Turn {
    Turn::from_index(turns.iter().map(|&turn| turn as u8).sum())
}

/// Every reduction in order, and the list that is left: at each step the first `xBy` goes. In all it takes
/// as long as the list is, not its square.
#[must_use]
pub fn reductions(list: &TurnList) -> (Vec<Reduction>, TurnList) {
    let mut left: Vec<Turn> = Vec::with_capacity(list.turns().len());
    let mut steps = Vec::new();
    for &turn in list.turns() {
        left.push(turn);
        // What came before has none, and one reduction may make the next.
        while let [.., x, Turn::Back, y] = left[..] {
            let at = left.len() - 3;
            let three = [x, Turn::Back, y];
            let one = sum(three);
            left.truncate(at);
            left.push(one);
            steps.push(Reduction { at, three, one });
        }
    }
    (steps, left.into_iter().collect())
}

/// The list after so many of its reductions.
#[must_use]
pub fn after(list: &TurnList, steps: &[Reduction]) -> TurnList {
    let mut turns = list.turns().to_vec();
    for &Reduction { at, one, .. } in steps {
        if at + 3 <= turns.len() {
            turns.splice(at..at + 3, [one]);
        }
    }
    turns.into_iter().collect()
}

/// The way back: the same nodes in the other order, left where it was right.
///
/// ```
/// use line_maze_lab::route::{lab::reverse, letters::read};
/// assert_eq!(reverse(&read("SSRL")?).to_string(), "RLSS");
/// # Ok::<(), line_maze_lab::route::letters::Misread>(())
/// ```
#[must_use]
pub fn reverse(list: &TurnList) -> TurnList {
    // Coming back through a node, the turn is the one that undoes the way there.
    list.turns().iter().rev().map(|&turn| Turn::from_index(4 - turn as u8)).collect()
}
