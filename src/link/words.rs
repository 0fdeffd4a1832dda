//! A robot's run in words: whose it is and how far it came; and the first disagreement of robot and page, what
//! either met, does, and remembers.

use alloc::string::{String, ToString};
use alloc::vec::Vec;

use super::live::{Difference, LiveRun, Opinion};
use crate::event::Outcome;
use crate::explorer::book::Case;
use crate::geometry::Turn;

/// Where a run is told from.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Source<'a> {
    /// The robot that is connected.
    Robot,
    /// The robot that was connected.
    Past,
    /// A recording with this name.
    Recording(&'a str),
}

impl LiveRun {
    /// Whose run it is, and how far it came: no full stop yet.
    #[must_use]
    pub fn told(&self, source: Source<'_>) -> String {
        let whose = match source {
            Source::Robot => "Live from the robot".into(),
            Source::Past => "The robot’s last run".into(),
            Source::Recording(name) => alloc::format!("From the recording {name}"),
        };
        let how = match (self.end(), source) {
            (None, Source::Robot | Source::Past) => "driving".into(),
            (None, Source::Recording(_)) => "the recording ends here".into(),
            (Some(Outcome::Cut(_)), _) if self.was_disconnected() => "then it was disconnected".into(),
            (Some(end), _) => end.to_string(),
        };
        let stops = self.stops();
        alloc::format!("{whose}: {stops} stop{}, {how}", if stops == 1 { "" } else { "s" })
    }
}

/// A row of the table that sets the two against each other.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Versus {
    /// What is compared.
    pub name: &'static str,
    /// The robot's.
    pub robot: String,
    /// The page's.
    pub page: String,
}

impl Difference {
    /// The rows; also those that are the same.
    #[must_use]
    pub fn rows(&self) -> Vec<Versus> {
        let row =
            |name, of: fn(&Opinion) -> String| Versus { name, robot: of(&self.robot), page: of(&self.page) };
        Vec::from([
            row("met", met),
            row("does", |opinion| does(opinion.turn).into()),
            row("ptr", |opinion| opinion.ptr.to_string()),
            row("returning", |opinion| opinion.returning.to_string()),
        ])
    }

    /// A plain sentence.
    #[must_use]
    pub fn says(&self) -> String {
        let (robot, page) = (met(&self.robot), met(&self.page));
        if robot == page {
            alloc::format!(
                "At stop {} robot and page take the place for the same, but decide differently: the robot’s program or its preference order is another.",
                self.stop
            )
        } else {
            alloc::format!(
                "At stop {} the robot takes the place for {robot}, the page for {page}. Compare epsilon on both sides, and how well the robot keeps its speed.",
                self.stop
            )
        }
    }
}

fn met(opinion: &Opinion) -> String {
    let node = opinion.node;
    match opinion.case {
        Case::Finish => "the finish".into(),
        Case::Start => "the start".into(),
        Case::DeadEnd => "a dead end".into(),
        Case::Corner => "a corner".into(),
        Case::New | Case::TableFull if node == 0 => "a new node".into(),
        Case::New | Case::TableFull => alloc::format!("node {node}, new"),
        Case::Known | Case::KnownBack => alloc::format!("node {node}, known"),
        Case::UnknownUturn | Case::UnknownBack => alloc::format!("node {node}, again"),
    }
}

const fn does(turn: Option<Turn>) -> &'static str {
    match turn {
        None => "stays",
        Some(Turn::Straight) => "S, straight on",
        Some(Turn::Right) => "R, turns right",
        Some(Turn::Left) => "L, turns left",
        Some(Turn::Back) => "B, turns round",
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn opinion(case: Case, node: u32, turn: Turn) -> Opinion {
        Opinion { case, node, turn: Some(turn), ptr: node + 1, returning: false }
    }

    #[test]
    fn a_disagreement_is_told_in_the_robots_terms() {
        let robot = opinion(Case::New, 7, Turn::Right);
        let page = opinion(Case::UnknownUturn, 2, Turn::Back);
        let difference = Difference { stop: 16, robot, page, at: (118, 2283) };
        assert_eq!(
            difference.rows()[..2],
            [
                Versus { name: "met", robot: "node 7, new".into(), page: "node 2, again".into() },
                Versus { name: "does", robot: "R, turns right".into(), page: "B, turns round".into() },
            ]
        );
        assert!(difference.says().contains("stop 16 the robot takes the place for node 7, new"));
        let same = Difference { page: opinion(Case::New, 7, Turn::Left), ..difference };
        assert!(same.says().contains("preference order"));
    }
}
