//! What is in order in a maze and what is not, in sentences that name the place and the cure.

mod cures;
mod walls;
mod words;

pub use cures::{Cure, offered};

use alloc::vec;
use alloc::vec::Vec;

use super::{Bounds, Kind, Maze, Start};
use crate::geometry::{Heading, Point, Ways};

/// How much a finding matters.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum Severity {
    /// The book's explorer cannot be run.
    Error,
    /// It can, but the maze is perhaps not what was meant.
    Warning,
}

/// Something that is not in order.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Finding {
    /// Nothing is drawn.
    NoLines,
    /// The robot is not put down anywhere.
    NoStart,
    /// The start is beside the lines, or a square with walls all round.
    StartOffLine(Start),
    /// The start is on a line, but not at its end.
    StartNotAtEnd {
        /// The start.
        start: Start,
        /// Its ways out, 2 to 4.
        ways: u32,
    },
    /// The start is at a line's end and faces another way than along it.
    StartFacesAway {
        /// The start.
        start: Start,
        /// Along its line.
        along: Heading,
    },
    /// In a walled maze, the start has several ways out and faces none of them.
    StartFacesWall {
        /// The start.
        start: Start,
        /// Its ways out.
        open: Ways,
    },
    /// There is no finish.
    NoFinish,
    /// A finish point is beside the lines, or a square with walls all round.
    FinishOffLine(Point),
    /// No line leads from the start to the finish.
    FinishUnreachable {
        /// The finish points that are on a line.
        finish: Vec<Point>,
    },
    /// The start is part of the finish.
    FinishOnStart(Point),
    /// Lines that do not touch the start's; without a start, the longest.
    Apart(Piece),
}

/// Lines that touch each other, and no others.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Piece {
    /// Every cell once, by its southern or western end.
    pub cells: Vec<(Point, Heading)>,
    /// Its corners.
    pub place: Bounds,
    /// A point on it, about in its middle.
    pub near: Point,
}

/// Something that is as it should be.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum InOrder {
    /// The start is at a line's end and faces along it; in a walled maze it is in a square with one way out.
    Start(Start),
    /// A line leads from the start to the finish.
    Finish {
        /// The nearest finish point.
        at: Point,
        /// Cells of the shortest way to it.
        cells: u32,
    },
}

/// What was found.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Report {
    /// Errors first.
    pub findings: Vec<Finding>,
    /// What is in order.
    pub in_order: Vec<InOrder>,
}

/// Looks at everything; costs a few passes over the lattice.
///
/// ```
/// use line_maze_lab::maze::{checks, samples};
/// let report = checks::report(&samples::figure_3_1());
/// assert!(report.findings.is_empty());
/// assert_eq!(report.in_order[1].detail(), "3,4 · 9 cells from the start");
/// ```
#[must_use]
pub fn report(maze: &Maze) -> Report {
    let mut report = Report::default();
    let pieces = Pieces::of(maze);
    if pieces.sizes.is_empty() {
        report.findings.push(Finding::NoLines);
    }
    match start(maze) {
        Ok(start) => report.in_order.push(InOrder::Start(start)),
        Err(finding) => report.findings.push(finding),
    }
    report.findings.extend(faces_wall(maze));
    finish(maze, &mut report);
    report.findings.extend(pieces.apart(maze).into_iter().map(Finding::Apart));
    report.findings.sort_by_key(Finding::severity);
    report
}

/// What is not in order, errors first.
#[must_use]
pub fn check(maze: &Maze) -> Vec<Finding> {
    report(maze).findings
}

/// The start, if the book's explorer can be put down there: a run begins where this finds nothing, but for a finish
/// on the start.
fn start(maze: &Maze) -> Result<Start, Finding> {
    let start = maze.start().ok_or(Finding::NoStart)?;
    let ways = maze.ways(start.at);
    match ways.only() {
        Some(along) if along == start.heading => Ok(start),
        Some(along) => Err(Finding::StartFacesAway { start, along }),
        None if ways.is_empty() => Err(Finding::StartOffLine(start)),
        None => Err(Finding::StartNotAtEnd { start, ways: ways.count() }),
    }
}

/// A mouse that may start in any square, but looks at a wall there.
fn faces_wall(maze: &Maze) -> Option<Finding> {
    let start = maze.start().filter(|_| maze.kind == Kind::Wall)?;
    let open = maze.ways(start.at);
    (open.count() > 1 && !open.has(start.heading)).then_some(Finding::StartFacesWall { start, open })
}

fn finish(maze: &Maze, report: &mut Report) {
    if maze.finish().is_empty() {
        report.findings.push(Finding::NoFinish);
    }
    let (on_line, off_line): (Vec<Point>, Vec<Point>) =
        maze.finish().iter().partition(|&&at| !maze.ways(at).is_empty());
    report.findings.extend(off_line.into_iter().map(Finding::FinishOffLine));
    let Some(start) = maze.start() else { return };
    if maze.is_finish(start.at) {
        report.findings.push(Finding::FinishOnStart(start.at));
    } else if on_line.is_empty() || maze.ways(start.at).is_empty() {
        // Said already: one of them is not on a line.
    } else if let Some((at, cells)) = nearest_finish(maze, start.at) {
        report.in_order.push(InOrder::Finish { at, cells });
    } else {
        report.findings.push(Finding::FinishUnreachable { finish: on_line });
    }
}

/// The finish point that the fewest cells lead to, and how many.
fn nearest_finish(maze: &Maze, from: Point) -> Option<(Point, u32)> {
    let bounds = maze.bounds();
    let mut seen = vec![false; bounds.len()];
    let mut ring = vec![from];
    let mut cells = 0;
    seen[bounds.index(from)?] = true;
    while !ring.is_empty() {
        if let Some(&at) = ring.iter().find(|&&at| maze.is_finish(at)) {
            return Some((at, cells));
        }
        let mut next_ring = Vec::new();
        for at in ring {
            for next in maze.ways(at).iter().map(|heading| at.step(heading)) {
                let index = bounds.index(next)?;
                if !core::mem::replace(&mut seen[index], true) {
                    next_ring.push(next);
                }
            }
        }
        ring = next_ring;
        cells += 1;
    }
    None
}

/// Which piece each point belongs to.
struct Pieces {
    /// 0 where there is no line, else the piece's number from 1.
    of: Vec<u32>,
    /// Points of each piece.
    sizes: Vec<u32>,
}

impl Pieces {
    fn of(maze: &Maze) -> Self {
        let bounds = maze.bounds();
        let mut pieces = Self { of: vec![0; bounds.len()], sizes: Vec::new() };
        let mut todo = Vec::new();
        let mut number = 0;
        for (first, _) in maze.joined_points() {
            let mut size = 0;
            todo.push(first);
            while let Some(at) = todo.pop() {
                let Some(index) = bounds.index(at) else { continue };
                if pieces.of[index] == 0 {
                    if size == 0 {
                        number += 1;
                    }
                    size += 1;
                    pieces.of[index] = number;
                    todo.extend(maze.ways(at).iter().map(|heading| at.step(heading)));
                }
            }
            if size > 0 {
                pieces.sizes.push(size);
            }
        }
        pieces
    }

    /// The pieces that are not the start's.
    fn apart(&self, maze: &Maze) -> Vec<Piece> {
        if self.sizes.len() < 2 {
            return Vec::new();
        }
        let bounds = maze.bounds();
        let number = |at| bounds.index(at).map_or(0, |index| self.of[index]);
        let longest = || (1..).zip(&self.sizes).max_by_key(|&(nth, size)| (size, core::cmp::Reverse(nth)));
        let own = match maze.start().map_or(0, |start| number(start.at)) {
            0 => longest().map_or(0, |(nth, _)| nth),
            own => own,
        };
        let mut cells = vec![Vec::new(); self.sizes.len()];
        for (at, heading) in maze.lines() {
            if number(at) != own {
                cells[number(at) as usize - 1].push((at, heading));
            }
        }
        cells.into_iter().filter_map(Piece::of).collect()
    }
}

impl Piece {
    fn of(cells: Vec<(Point, Heading)>) -> Option<Self> {
        let points = || cells.iter().flat_map(|&(at, heading)| [at, at.step(heading)]);
        let place = Bounds::around(points()).ok()?;
        let middle = Point::new(
            place.sw().x + (place.width() / 2).cast_signed(),
            place.sw().y + (place.height() / 2).cast_signed(),
        );
        let near = points().min_by_key(|at| (at.distance(middle), *at))?;
        Some(Self { cells, place, near })
    }
}

#[cfg(test)]
#[allow(clippy::unwrap_used)]
mod tests {
    use super::*;
    use crate::maze::text;
    use alloc::string::String;

    /// Every finding in one line each, for a drawing.
    fn found(drawing: &str) -> Vec<String> {
        let maze = text::parse(&alloc::format!("line-maze: 1\n{drawing}")).unwrap();
        let say = |finding: &Finding| {
            let severity = finding.severity();
            alloc::format!("{severity:?}: {}. {}", finding.title(), finding.cure())
        };
        report(&maze).findings.iter().map(say).collect()
    }

    #[test]
    fn findings_name_place_and_cure() {
        let cases: [(&str, &[&str]); 9] = [
            (
                "\n^---F\n",
                &[
                    "Error: Start faces off its line. The robot at 0,0 faces north, but its line leads east. Turn the start east.",
                ],
            ),
            (
                "\n>---F---+   +\n            |\n            +\n",
                &[
                    "Warning: Lines apart from the rest. 1 cell near 3,1 can’t be reached. Join it to the rest, or erase it.",
                ],
            ),
            (
                "\n+---v---F\n",
                &[
                    "Error: Start is not at a line’s end. 1,0 has 2 ways out, so the robot could not know that it is back there. Move the start to a line’s end.",
                ],
            ),
            (
                "\n>   +---F\n",
                &[
                    "Error: Start is not on a line. No line touches 0,0. Draw one from there, or move the start to a line’s end.",
                ],
            ),
            (
                "\n>---+   F\n",
                &[
                    "Warning: Finish is not on a line. No line touches 2,0. Draw one to it, or move the finish.",
                ],
            ),
            (
                "\n>---+   F---F\n",
                &[
                    "Warning: Finish can’t be reached. No line leads from the start to 2,0, nor to the other finish points. Join the lines, or move the finish.",
                    "Warning: Lines apart from the rest. 1 cell near 3,0 can’t be reached. Join it to the rest, or erase it.",
                ],
            ),
            (
                "\n+---+   .\n",
                &[
                    "Error: No start. Put the start at the end of a line.",
                    "Warning: No finish. Without a finish the robot drives every line and comes back. Put one on a line.",
                ],
            ),
            (
                "finish: 0,0\n\n>---+\n",
                &[
                    "Error: Finish is on the start. Both are at 0,0, so there is nothing to explore. Move one of them.",
                ],
            ),
            (
                "\n.   .\n",
                &[
                    "Error: No lines yet. Draw a line from point to point.",
                    "Error: No start. Put the start at the end of a line.",
                    "Warning: No finish. Without a finish the robot drives every line and comes back. Put one on a line.",
                ],
            ),
        ];
        for (drawing, findings) in cases {
            assert_eq!(found(drawing), findings, "{drawing}");
        }
    }

    #[test]
    fn errors_come_first() {
        let findings = found("finish: 0,0 2,0\n\n>---+   .\n");
        assert!(findings[0].starts_with("Error: Finish is on the start"), "{findings:?}");
        assert!(findings[1].starts_with("Warning: Finish is not on a line"), "{findings:?}");
    }

    #[test]
    fn a_piece_apart_has_its_cells_and_its_place() {
        let maze = text::parse("line-maze: 1\n\n>---F   +---+\n            |\n.   .   .   +\n").unwrap();
        let findings = check(&maze);
        let [finding @ Finding::Apart(piece)] = &findings[..] else { panic!("{findings:?}") };
        assert_eq!(piece.cells.len(), 2);
        assert_eq!(piece.near, Point::new(3, 1));
        let mut erased = maze.clone();
        for &(at, heading) in &piece.cells {
            assert!(erased.erase(at, heading));
        }
        assert!(check(&erased).is_empty());
        assert_eq!(finding.place(), Some(Bounds::new(Point::new(2, 0), Point::new(3, 1)).unwrap()));
    }

    #[test]
    fn without_a_start_the_longest_piece_is_the_maze() {
        let maze = text::parse("line-maze: 1\n\n+---F   +---+---+\n").unwrap();
        let apart: Vec<_> = check(&maze)
            .into_iter()
            .filter_map(
                |finding| if let Finding::Apart(piece) = finding { Some(piece.cells.len()) } else { None },
            )
            .collect();
        assert_eq!(apart, [1]);
    }
}
