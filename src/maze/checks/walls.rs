//! The findings in the words of walls: squares, openings, and mice.

use alloc::format;
use alloc::string::String;

use super::{Finding, InOrder};
use crate::maze::Kind;

impl Finding {
    /// What is wrong, in a few words, for a maze that is drawn so.
    #[must_use]
    pub const fn title_in(&self, kind: Kind) -> &'static str {
        match (kind, self) {
            (Kind::Line, finding) => finding.title(),
            (Kind::Wall, Self::NoLines) => "No openings yet",
            (Kind::Wall, Self::StartOffLine(_)) => "Start is walled in",
            (Kind::Wall, Self::StartNotAtEnd { .. }) => "Start has several ways out",
            (Kind::Wall, Self::StartFacesAway { .. }) => "Start faces a wall",
            (Kind::Wall, Self::FinishOffLine(_)) => "Finish is walled in",
            (Kind::Wall, Self::Apart(_)) => "Squares apart from the rest",
            (
                Kind::Wall,
                same @ (Self::NoStart
                | Self::StartFacesWall { .. }
                | Self::NoFinish
                | Self::FinishUnreachable { .. }
                | Self::FinishOnStart(_)),
            ) => same.title(),
        }
    }

    /// Where exactly, and what to do, for a maze that is drawn so.
    #[must_use]
    pub fn cure_in(&self, kind: Kind) -> String {
        match (kind, self) {
            (Kind::Line, finding) => finding.cure(),
            (Kind::Wall, Self::NoLines) => "Every square is closed. Take a wall away.".into(),
            (Kind::Wall, Self::NoStart) => "Put the start in a square.".into(),
            (Kind::Wall, Self::StartOffLine(start)) => {
                format!("{} has walls all round. Open one, or move the start.", start.at)
            }
            (Kind::Wall, Self::StartNotAtEnd { start, ways }) => format!(
                "{} has {ways} ways out, so the book’s explorer could not know that it is back there. Close all but \
                 one, move the start, or choose another explorer.",
                start.at
            ),
            (Kind::Wall, Self::StartFacesAway { start, along }) => format!(
                "The mouse at {} faces {}, where a wall is; its only way leads {}. Turn it.",
                start.at,
                start.heading.word(),
                along.word()
            ),
            (Kind::Wall, Self::NoFinish) => {
                "Without a finish the mouse never arrives; mappers see everything. Put one in a square."
                    .into()
            }
            (Kind::Wall, Self::FinishOffLine(at)) => {
                format!("{at} has walls all round. Open one, or move the finish.")
            }
            (Kind::Wall, Self::FinishUnreachable { finish }) => {
                let more = if finish.len() > 1 { ", nor to the other finish squares" } else { "" };
                let at = finish.first().copied().unwrap_or_default();
                format!("No way leads from the start to {at}{more}. Open a wall, or move the finish.")
            }
            (Kind::Wall, Self::Apart(piece)) => {
                format!("Those near {} can’t be reached. Open a wall to them, or close them off.", piece.near)
            }
            (Kind::Wall, same @ (Self::StartFacesWall { .. } | Self::FinishOnStart(_))) => same.cure(),
        }
    }
}

impl InOrder {
    /// What is in order, for a maze that is drawn so.
    #[must_use]
    pub const fn title_in(&self, kind: Kind) -> &'static str {
        match (kind, self) {
            (Kind::Wall, Self::Start(_)) => "Start is in a square with one way out",
            (Kind::Line, Self::Start(_)) | (_, Self::Finish { .. }) => self.title(),
        }
    }
}

#[cfg(test)]
#[allow(clippy::unwrap_used)]
mod tests {
    use super::super::report;
    use crate::maze::{Kind, text};
    use alloc::string::String;
    use alloc::vec::Vec;

    fn found(drawing: &str) -> Vec<String> {
        let maze = text::parse(&alloc::format!("line-maze: 1\nkind: wall\n{drawing}")).unwrap();
        let report = report(&maze);
        let findings = report.findings.iter().map(|finding| {
            let severity = finding.severity();
            alloc::format!("{severity:?}: {}. {}", finding.title_in(Kind::Wall), finding.cure_in(Kind::Wall))
        });
        let fine = report
            .in_order
            .iter()
            .map(|fine| alloc::format!("{}: {}", fine.title_in(Kind::Wall), fine.detail()));
        findings.chain(fine).collect()
    }

    #[test]
    fn a_start_is_judged_as_the_run_judges_it() {
        let fine = [
            "Start is in a square with one way out: 0,0 facing east",
            "Finish can be reached: 2,0 · 2 cells from the start",
        ];
        assert_eq!(found("\n>---+---F\n"), fine);
        assert_eq!(
            found("\n^---+---F\n")[0],
            "Error: Start faces a wall. The mouse at 0,0 faces north, where a wall is; its only way leads east. Turn it."
        );
        assert_eq!(
            found("\n+---^---F\n")[..2],
            [
                "Error: Start has several ways out. 1,0 has 2 ways out, so the book’s explorer could not know that it is back there. Close all but one, move the start, or choose another explorer.",
                "Warning: Start faces a wall. The mouse at 1,0 faces north, where a wall is; it can go east or west. Turn it.",
            ]
        );
    }

    #[test]
    fn findings_speak_of_walls() {
        assert_eq!(
            found("\n^   +---F   F\n"),
            [
                "Error: Start is walled in. 0,0 has walls all round. Open one, or move the start.",
                "Warning: Finish is walled in. 3,0 has walls all round. Open one, or move the finish.",
            ]
        );
        assert_eq!(
            found("\n>---+   F---+\n"),
            [
                "Warning: Finish can’t be reached. No way leads from the start to 2,0. Open a wall, or move the finish.",
                "Warning: Squares apart from the rest. Those near 3,0 can’t be reached. Open a wall to them, or close them off.",
                "Start is in a square with one way out: 0,0 facing east",
            ]
        );
        assert_eq!(
            found("bounds: 0,0 1,0\nlines:\n"),
            [
                "Error: No openings yet. Every square is closed. Take a wall away.",
                "Error: No start. Put the start in a square.",
                "Warning: No finish. Without a finish the mouse never arrives; mappers see everything. Put one in a square.",
            ]
        );
    }
}
