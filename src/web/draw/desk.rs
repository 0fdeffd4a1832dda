//! What the Draw room knows besides the maze: tool, pointers, cursor, camera.

use leptos::html;
use leptos::prelude::*;

use super::rest::rests;
use crate::geometry::{Point, Turn};
use crate::gesture::{Doing, Finishing, Hand, Tool};
use crate::maze::checks::{self, Finding, Report};
use crate::maze::edit::Edit;
use crate::maze::{Kind, Maze, Start};
use crate::web::maze_view::{Camera, size_of};
use crate::web::state::Lab;

/// The state of the room; cheap to copy, reached by [`desk`].
#[derive(Clone, Copy)]
pub struct Desk {
    /// The page.
    pub lab: Lab,
    /// The drawing's frame.
    pub frame: NodeRef<html::Div>,
    /// What of the lattice is shown.
    pub camera: Camera,
    /// The chosen tool.
    pub tool: RwSignal<Tool>,
    /// Whether the finish tool puts further points.
    pub finishing: RwSignal<Finishing>,
    /// Whether the space bar is held, which moves the paper.
    pub holds_space: RwSignal<bool>,
    /// The pointers.
    pub hand: RwSignal<Hand>,
    /// What they do.
    pub doing: Memo<Doing>,
    /// The keyboard's place.
    pub cursor: RwSignal<Point>,
    /// Whether the keyboard moved it last.
    pub by_keyboard: RwSignal<bool>,
    /// Counts when the maze comes to rest after changes.
    pub rests: ReadSignal<u32>,
    /// What is in order, and what not, when it rests.
    pub report: Memo<Report>,
    /// The finding that is shown on the drawing, as long as it is one.
    pub shown: Memo<Option<Finding>>,
    wanted: RwSignal<Option<Finding>>,
    /// Whether the generator is open.
    pub generating: RwSignal<bool>,
}

/// The state of the room.
#[must_use]
pub fn desk() -> Desk {
    expect_context::<Desk>()
}

impl Desk {
    /// The room as it is entered.
    #[must_use]
    pub fn new(lab: Lab) -> Self {
        let bounds = Memo::new(move |_| lab.maze.with(|maze| maze.bounds()));
        let frame = NodeRef::new();
        let camera = Camera::new(size_of(frame), bounds, 72.0).with_edge(24.0);
        let hand = RwSignal::new(Hand::default());
        let rests = rests(lab);
        let report = Memo::new(move |_| {
            rests.track();
            lab.maze.with_untracked(|maze| checks::report(maze))
        });
        let wanted = RwSignal::new(None::<Finding>);
        let shown =
            Memo::new(move |_| wanted.get().filter(|it| report.with(|report| report.findings.contains(it))));
        let cursor =
            lab.maze.with_untracked(|maze| maze.start().map_or(maze.bounds().sw(), |start| start.at));
        let desk = Self {
            lab,
            frame,
            camera,
            tool: RwSignal::new(Tool::Line),
            finishing: RwSignal::new(Finishing::Only),
            holds_space: RwSignal::new(false),
            hand,
            doing: Memo::new(move |_| hand.with(|hand| hand.doing().clone())),
            cursor: RwSignal::new(cursor),
            by_keyboard: RwSignal::new(false),
            rests,
            report,
            shown,
            wanted,
            generating: RwSignal::new(false),
        };
        // Another lattice is shown from its beginning.
        Effect::new(move |before: Option<()>| {
            let bounds = bounds.get();
            if before.is_some() {
                camera.fit();
                desk.cursor.update(|cursor| *cursor = bounds.clamp(*cursor));
            }
        });
        desk
    }

    /// Whether there are lines or walls.
    #[must_use]
    pub fn kind(self) -> Kind {
        self.lab.maze.with(|maze| maze.kind)
    }

    /// The maze, without following its changes.
    pub fn with_maze<T>(self, of: impl FnOnce(&Maze) -> T) -> T {
        self.lab.maze.with_untracked(|maze| of(maze))
    }

    /// The tool that the main button has now.
    #[must_use]
    pub fn held_tool(self) -> Tool {
        if self.holds_space.get() { Tool::Move } else { self.tool.get() }
    }

    /// Chooses a tool.
    pub fn take(self, tool: Tool) {
        self.tool.set(tool);
    }

    /// Puts the start on a point; on a line's end it faces along the line.
    pub fn put_start(self, at: Point) {
        let start = self.with_maze(|maze| Start {
            at,
            heading: maze
                .ways(at)
                .only()
                .or(maze.start().map(|start| start.heading))
                .unwrap_or(crate::geometry::Heading::North),
        });
        self.lab.edit(Edit::Start(Some(start)));
    }

    /// Turns the start clockwise.
    pub fn turn_start(self) {
        if let Some(start) = self.with_maze(Maze::start) {
            let heading = start.heading.turned(Turn::Right);
            self.lab.edit(Edit::Start(Some(Start { heading, ..start })));
        }
    }

    /// Puts the finish on a point, or makes the point one more of the finish, or one less.
    pub fn put_finish(self, at: Point) {
        let finish = match self.finishing.get_untracked() {
            Finishing::Only => vec![at],
            Finishing::Further => self.with_maze(|maze| {
                let mut finish = maze.finish().to_vec();
                if maze.is_finish(at) {
                    finish.retain(|&other| other != at);
                } else {
                    finish.push(at);
                }
                finish
            }),
        };
        self.lab.edit(Edit::Finish(finish));
    }

    /// Shows a finding's place on the drawing, or no longer.
    pub fn toggle_shown(self, finding: Finding) {
        if self.shown.get_untracked().as_ref() == Some(&finding) {
            return self.wanted.set(None);
        }
        if let Some(place) = finding.place() {
            self.camera.show_all(place);
        }
        self.wanted.set(Some(finding));
    }

    /// Shows no finding any more; whether one was shown.
    pub fn hide_shown(self) -> bool {
        let shown = self.shown.get_untracked().is_some();
        self.wanted.set(None);
        shown
    }
}

/// `1 cell`, `3 cells`.
#[must_use]
pub fn many(count: usize, one: &str) -> String {
    format!("{count} {one}{}", if count == 1 { "" } else { "s" })
}
