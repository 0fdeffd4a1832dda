//! What can be done about a finding at once, as edits with the words for their buttons.

use alloc::format;
use alloc::string::{String, ToString};
use alloc::vec;
use alloc::vec::Vec;

use super::Finding;
use super::words::cells;
use crate::geometry::{Heading, Point, Ways};
use crate::maze::edit::Edit;
use crate::maze::{Kind, Maze, Start};

/// An edit that cures a finding.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Cure {
    /// What a button calls it.
    pub label: String,
    /// What is said when it is done.
    pub done: String,
    /// The edit.
    pub edit: Edit,
}

impl Finding {
    /// What would cure it, the likeliest first; nothing where only its author knows what the maze should be.
    ///
    /// ```
    /// use line_maze_lab::maze::{checks, file};
    /// let maze = file::read(b"0 0 1 0 1 1\n1 0 1 0 1 0\n2 0 1 1 1 0\n").unwrap().maze;
    /// let labels: Vec<String> = checks::check(&maze)[0].cures(&maze).into_iter().map(|cure| cure.label).collect();
    /// assert_eq!(labels, ["Put it in the centre"]);
    /// ```
    #[must_use]
    pub fn cures(&self, maze: &Maze) -> Vec<Cure> {
        match self {
            Self::NoStart => put_start(maze, maze.bounds().sw(), "Put it at").into_iter().collect(),
            Self::StartOffLine(start) => put_start(maze, start.at, "Move it to").into_iter().collect(),
            Self::StartNotAtEnd { start, .. } => close_others(maze, *start)
                .into_iter()
                .chain(put_start(maze, start.at, "Move it to"))
                .collect(),
            Self::StartFacesAway { start, along } => vec![turn(*start, *along)],
            Self::StartFacesWall { start, open } => open.iter().map(|way| turn(*start, way)).collect(),
            Self::NoFinish => centre(maze).into_iter().collect(),
            Self::FinishOnStart(at) => leave_out(maze, *at).into_iter().collect(),
            Self::Apart(piece) => vec![erase(maze.kind, &piece.cells)],
            Self::NoLines | Self::FinishOffLine(_) | Self::FinishUnreachable { .. } => Vec::new(),
        }
    }
}

/// What to say of a maze that was just opened: a contest's finish that no file names, or a start that keeps the robot
/// from starting, each with its likeliest cure. The rest is told in the checks.
#[must_use]
pub fn offered(maze: &Maze) -> Option<(Finding, Cure)> {
    let mut findings = super::check(maze);
    findings.retain(|finding| match finding {
        Finding::NoFinish
        | Finding::StartNotAtEnd { .. }
        | Finding::StartFacesAway { .. }
        | Finding::StartFacesWall { .. }
        | Finding::FinishOnStart(_) => true,
        Finding::NoLines
        | Finding::NoStart
        | Finding::StartOffLine(_)
        | Finding::FinishOffLine(_)
        | Finding::FinishUnreachable { .. }
        | Finding::Apart(_) => false,
    });
    // Without a finish a run says little.
    findings.sort_by_key(|finding| *finding != Finding::NoFinish);
    findings.into_iter().find_map(|finding| {
        let cure = finding.cures(maze).into_iter().next()?;
        Some((finding, cure))
    })
}

fn turn(start: Start, heading: Heading) -> Cure {
    Cure {
        label: format!("Turn it {}", heading.word()),
        done: format!("Start turned {}.", heading.word()),
        edit: Edit::Start(Some(Start { heading, ..start })),
    }
}

/// The start at the nearest point that has one way out and is no finish.
fn put_start(maze: &Maze, near: Point, verb: &str) -> Option<Cure> {
    let ends = maze.joined_points().filter_map(|(at, ways)| Some((at, ways.only()?)));
    let usable = ends.filter(|&(at, _)| !maze.is_finish(at));
    let (at, heading) = usable.min_by_key(|&(at, _)| (at.distance(near), at))?;
    Some(Cure {
        label: format!("{verb} {at}"),
        done: format!("Start at {at}, facing {}.", heading.word()),
        edit: Edit::Start(Some(Start { at, heading })),
    })
}

/// Walls around the start, but for the way that it faces, or its first.
fn close_others(maze: &Maze, start: Start) -> Option<Cure> {
    if maze.kind != Kind::Wall {
        return None;
    }
    let open = maze.ways(start.at);
    let kept = if open.has(start.heading) { start.heading } else { open.iter().next()? };
    let closed = open.minus(Ways::NONE.with(kept));
    let walls: Vec<(Point, Heading)> = closed.iter().map(|side| (start.at, side)).collect();
    Some(Cure {
        label: format!("Close all but its way {}", kept.word()),
        done: format!(
            "{} built.",
            if walls.len() == 1 { "1 wall".into() } else { format!("{} walls", walls.len()) }
        ),
        edit: Edit::Erase(walls),
    })
}

/// The finish in the centre, where contests have it; lines have it anywhere.
fn centre(maze: &Maze) -> Option<Cure> {
    if maze.kind != Kind::Wall {
        return None;
    }
    let mut finish = maze.bounds().centre();
    finish.retain(|&at| maze.start().is_none_or(|start| start.at != at));
    (!finish.is_empty()).then(|| Cure {
        label: "Put it in the centre".to_string(),
        done: "Finish put in the centre.".to_string(),
        edit: Edit::Finish(finish),
    })
}

/// The finish without the start, if anything is left of it.
fn leave_out(maze: &Maze, start: Point) -> Option<Cure> {
    let rest: Vec<Point> = maze.finish().iter().copied().filter(|&at| at != start).collect();
    (!rest.is_empty()).then(|| Cure {
        label: format!("Leave {start} out of the finish"),
        done: format!("{start} is no finish any more."),
        edit: Edit::Finish(rest),
    })
}

fn erase(kind: Kind, piece: &[(Point, Heading)]) -> Cure {
    let (label, done) = match (kind, piece.len()) {
        (Kind::Line, 1) => ("Erase it", format!("{} erased.", cells(1))),
        (Kind::Line, count) => ("Erase them", format!("{} erased.", cells(count))),
        (Kind::Wall, 1) => ("Close them off", "1 wall built.".to_string()),
        (Kind::Wall, count) => ("Close them off", format!("{count} walls built.")),
    };
    Cure { label: label.to_string(), done, edit: Edit::Erase(piece.to_vec()) }
}

#[cfg(test)]
#[allow(clippy::unwrap_used)]
mod tests {
    use super::*;
    use crate::maze::checks::check;
    use crate::maze::edit::History;
    use crate::maze::text;

    /// Every cure of every finding, and what is still not in order after it.
    fn cured(drawing: &str) -> Vec<(String, Vec<&'static str>)> {
        let maze = text::parse(&format!("line-maze: 1\n{drawing}")).unwrap();
        let cures = check(&maze).into_iter().flat_map(|finding| finding.cures(&maze)).collect::<Vec<_>>();
        let after = |cure: Cure| {
            let mut history = History::new(maze.clone());
            assert!(history.apply(cure.edit), "{}", cure.label);
            let left = check(history.maze()).iter().map(|finding| finding.title_in(maze.kind)).collect();
            (cure.label, left)
        };
        cures.into_iter().map(after).collect()
    }

    #[test]
    fn a_cure_cures() {
        let all = |cures: &[(&str, &[&'static str])]| -> Vec<(String, Vec<&'static str>)> {
            cures.iter().map(|(label, left)| ((*label).to_string(), left.to_vec())).collect()
        };
        assert_eq!(cured("\n^---F\n"), all(&[("Turn it east", &[])]));
        assert_eq!(cured("\n+---v---F\n"), all(&[("Move it to 0,0", &[])]));
        assert_eq!(cured("\n+---F\n"), all(&[("Put it at 0,0", &[])]));
        assert_eq!(cured("finish: 0,0\n\n>---F\n"), all(&[("Leave 0,0 out of the finish", &[])]));
        assert_eq!(cured("\n>---F---+   +---+\n"), all(&[("Erase it", &[])]));
        assert_eq!(cured("kind: wall\n\n>---+---+\n"), all(&[("Put it in the centre", &[])]));
        assert_eq!(cured("kind: wall\n\n^---+---F\n"), all(&[("Turn it east", &[])]));
        assert_eq!(
            cured("kind: wall\n\n+---+---^---F\n"),
            all(&[
                ("Close all but its way east", &["Start faces a wall", "Squares apart from the rest"]),
                ("Move it to 0,0", &[]),
                ("Turn it east", &["Start has several ways out"]),
                ("Turn it west", &["Start has several ways out"]),
            ])
        );
        assert_eq!(cured("\n.   .\n"), all(&[]), "nothing is drawn: only its author knows");
    }
}
