//! The findings in words: what is wrong, what to do about it, and where to look.

use alloc::format;
use alloc::string::{String, ToString};

use super::{Finding, InOrder, Severity};
use crate::geometry::{Point, Ways};
use crate::maze::Bounds;

impl Finding {
    /// Whether the book's explorer can be run all the same.
    #[must_use]
    pub const fn severity(&self) -> Severity {
        match self {
            Self::NoLines
            | Self::NoStart
            | Self::StartOffLine(_)
            | Self::StartNotAtEnd { .. }
            | Self::StartFacesAway { .. }
            | Self::FinishOnStart(_) => Severity::Error,
            Self::StartFacesWall { .. }
            | Self::NoFinish
            | Self::FinishOffLine(_)
            | Self::FinishUnreachable { .. }
            | Self::Apart(_) => Severity::Warning,
        }
    }

    /// What is wrong, in a few words, where there are lines.
    pub(super) const fn title(&self) -> &'static str {
        match self {
            Self::NoLines => "No lines yet",
            Self::NoStart => "No start",
            Self::StartOffLine(_) => "Start is not on a line",
            Self::StartNotAtEnd { .. } => "Start is not at a line’s end",
            Self::StartFacesAway { .. } => "Start faces off its line",
            Self::StartFacesWall { .. } => "Start faces a wall",
            Self::NoFinish => "No finish",
            Self::FinishOffLine(_) => "Finish is not on a line",
            Self::FinishUnreachable { .. } => "Finish can’t be reached",
            Self::FinishOnStart(_) => "Finish is on the start",
            Self::Apart(_) => "Lines apart from the rest",
        }
    }

    /// Where exactly, and what to do, where there are lines.
    pub(super) fn cure(&self) -> String {
        match self {
            Self::NoLines => "Draw a line from point to point.".to_string(),
            Self::NoStart => "Put the start at the end of a line.".to_string(),
            Self::StartOffLine(start) => {
                format!(
                    "No line touches {}. Draw one from there, or move the start to a line’s end.",
                    start.at
                )
            }
            Self::StartNotAtEnd { start, ways } => format!(
                "{} has {ways} ways out, so the robot could not know that it is back there. Move the start to a \
                 line’s end.",
                start.at
            ),
            Self::StartFacesAway { start, along } => format!(
                "The robot at {} faces {}, but its line leads {}. Turn the start {}.",
                start.at,
                start.heading.word(),
                along.word(),
                along.word()
            ),
            Self::StartFacesWall { start, open } => format!(
                "The mouse at {} faces {}, where a wall is; it can go {}. Turn it.",
                start.at,
                start.heading.word(),
                any_of(*open)
            ),
            Self::NoFinish => {
                "Without a finish the robot drives every line and comes back. Put one on a line.".to_string()
            }
            Self::FinishOffLine(at) => format!("No line touches {at}. Draw one to it, or move the finish."),
            Self::FinishUnreachable { finish } => {
                let more = if finish.len() > 1 { ", nor to the other finish points" } else { "" };
                let at = finish.first().copied().unwrap_or_default();
                format!("No line leads from the start to {at}{more}. Join the lines, or move the finish.")
            }
            Self::FinishOnStart(at) => {
                format!("Both are at {at}, so there is nothing to explore. Move one of them.")
            }
            Self::Apart(piece) => {
                let (count, them) =
                    (cells(piece.cells.len()), if piece.cells.len() == 1 { "it" } else { "them" });
                format!(
                    "{count} near {} can’t be reached. Join {them} to the rest, or erase {them}.",
                    piece.near
                )
            }
        }
    }

    /// The part of the lattice to look at; none where it is all of it.
    #[must_use]
    pub fn place(&self) -> Option<Bounds> {
        let around = |points: &[Point]| Bounds::around(points.iter().copied()).ok();
        match self {
            Self::NoLines | Self::NoStart | Self::NoFinish => None,
            Self::StartOffLine(start)
            | Self::StartNotAtEnd { start, .. }
            | Self::StartFacesAway { start, .. }
            | Self::StartFacesWall { start, .. } => around(&[start.at]),
            Self::FinishOffLine(at) | Self::FinishOnStart(at) => around(&[*at]),
            Self::FinishUnreachable { finish } => around(finish),
            Self::Apart(piece) => Some(piece.place),
        }
    }
}

impl InOrder {
    /// What is in order, where there are lines.
    pub(super) const fn title(&self) -> &'static str {
        match self {
            Self::Start(_) => "Start is at a line’s end",
            Self::Finish { .. } => "Finish can be reached",
        }
    }

    /// The numbers to it.
    #[must_use]
    pub fn detail(&self) -> String {
        match self {
            Self::Start(start) => format!("{} facing {}", start.at, start.heading.word()),
            Self::Finish { at, cells: far } => format!("{at} · {} from the start", cells(*far as usize)),
        }
    }
}

/// `north`, `north or east`, `north, east or west`.
fn any_of(ways: Ways) -> String {
    let mut words = String::new();
    let count = ways.count() as usize;
    for (nth, heading) in ways.iter().enumerate() {
        words.push_str(match nth {
            0 => "",
            last if last + 1 == count => " or ",
            _ => ", ",
        });
        words.push_str(heading.word());
    }
    words
}

/// `1 cell`, `3 cells`.
pub(super) fn cells(count: usize) -> String {
    format!("{count} cell{}", if count == 1 { "" } else { "s" })
}
