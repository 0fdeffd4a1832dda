//! Where the names of start and finish stand, so that neither line nor robot nor the picture's edge hides them.

use crate::geometry::{Heading, Point, Ways};
use crate::maze::Bounds;

/// Where a name stands, seen from its lattice point.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct NamePlace {
    /// The side of the point.
    pub side: Heading,
    /// How the text runs from there: on to the east (1), to both sides (0), or up to there from the west (−1).
    pub runs: i8,
}

/// The place of the name of a point with lines that way, on a lattice of these bounds.
#[must_use]
pub fn name_place(bounds: Bounds, ways: Ways, at: Point) -> NamePlace {
    const SIDES: [Heading; 4] = [Heading::East, Heading::West, Heading::South, Heading::North];
    let (sw, ne) = (bounds.sw(), bounds.ne());
    let at_edge = |side: Heading| !bounds.contains(at.step(side));
    // At a line's end the robot looks out over the point, to the side where there is no line.
    let aside = |side: Heading| !ways.has(side) && !ways.has(side.opposite());
    let choose = |fits: &dyn Fn(Heading) -> bool| SIDES.into_iter().find(|&side| fits(side));
    let side = choose(&|side| aside(side) && !at_edge(side))
        .or_else(|| choose(&aside))
        .or_else(|| choose(&|side| !ways.has(side)))
        .unwrap_or(Heading::East);
    let runs = match side {
        Heading::East => 1,
        Heading::West => -1,
        Heading::North | Heading::South => i8::from(at.x == sw.x) - i8::from(at.x == ne.x),
    };
    NamePlace { side, runs }
}

#[cfg(test)]
mod tests {
    use super::*;
    use Heading::{East, North, South, West};

    fn place(at: (i32, i32), ways: &[Heading]) -> (Heading, i8) {
        let bounds = Bounds::new(Point::new(0, 0), Point::new(6, 4)).expect("bounds");
        let ways = ways.iter().copied().fold(Ways::NONE, Ways::with);
        let NamePlace { side, runs } = name_place(bounds, ways, Point::new(at.0, at.1));
        (side, runs)
    }

    #[test]
    fn a_name_stands_beside_the_line_that_ends_there() {
        assert_eq!(place((3, 2), &[North]), (East, 1));
        assert_eq!(place((3, 2), &[South]), (East, 1));
        assert_eq!(place((3, 2), &[East]), (South, 0));
        assert_eq!(place((3, 2), &[West]), (South, 0));
        assert_eq!(place((3, 2), &[]), (East, 1));
    }

    #[test]
    fn at_an_edge_a_name_stays_on_the_lattice() {
        assert_eq!(place((6, 2), &[North]), (West, -1));
        assert_eq!(place((6, 2), &[West]), (South, -1));
        assert_eq!(place((0, 0), &[East]), (North, 1));
        assert_eq!(place((6, 0), &[West]), (North, -1));
        assert_eq!(place((3, 4), &[West]), (South, 0));
    }

    #[test]
    fn where_lines_meet_a_name_takes_a_side_without_one() {
        assert_eq!(place((3, 2), &[North, East]), (West, -1));
        assert_eq!(place((3, 2), &[North, West]), (East, 1));
        assert_eq!(place((3, 2), &[East, West, North]), (South, 0));
        assert_eq!(place((3, 2), &[East, West, North, South]), (East, 1));
    }
}
