//! The page's state: signals that views read, and the commands that change them.

use leptos::prelude::*;

mod shown;
mod toast;

use std::any::Any;
use std::sync::Arc;

use super::played::Played;
use super::run_view::{Guest, Run, Same};
use super::{browser, storage};
use crate::explorer::name::Name;
use crate::geometry::Heading;
use crate::maze::Maze;
use crate::maze::edit::{Edit, History};
use crate::playback::{Command, Motion, Playback, Timeline};
use crate::settings::Settings;
use crate::share::Shared;
use crate::trace::{Frame, Moment};
use crate::world::CannotStart;

pub use shown::{Dialog, Room};
pub use toast::{Toast, ToastAction, ToastTone};

/// What the stepper plays.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Round {
    /// Round 1: the exploration.
    Explore,
    /// Round 2: the drive by the turn list.
    Solved,
}

/// A view that a part of the page offers to others.
pub type Offer = fn(Lab) -> AnyView;

/// The state of the page; cheap to copy, reached by [`lab`].
#[derive(Clone, Copy)]
pub struct Lab {
    /// The maze and its past.
    pub history: RwSignal<History>,
    /// The maze itself.
    pub maze: Memo<Same<Maze>>,
    /// How the bot is set.
    pub settings: RwSignal<Settings>,
    /// Who drives.
    pub explorer: RwSignal<Name>,
    /// The run of an explorer that is not the book's, once its part of the page has made it.
    pub other: RwSignal<Option<Result<Arc<dyn Played>, CannotStart>>>,
    /// The round and stop of that run that are to be shown when it is there.
    pub awaited: RwSignal<Option<(Round, u32)>>,
    /// The page's own run through the maze.
    pub own: Memo<Result<Same<Run>, CannotStart>>,
    /// The run that is shown: a robot's, or the page's own.
    pub run: Memo<Result<Same<Run>, CannotStart>>,
    /// A robot's run, while one is shown.
    pub guest: RwSignal<Option<Same<Guest>>>,
    /// The maze of the run that is shown.
    pub stage: Memo<Same<Maze>>,
    /// The connection to a robot, made by the room *Connect*; it outlives the room.
    pub link: StoredValue<Option<Box<dyn Any>>, LocalStorage>,
    /// While a robot drives, its stop, for every room.
    pub halt: RwSignal<Option<Offer>>,
    /// The room that is open.
    pub room: RwSignal<Room>,
    /// Where round 1 is played.
    pub playback: RwSignal<Playback>,
    /// Where round 2 is played.
    pub solved: RwSignal<Playback>,
    /// Which of them.
    pub round: RwSignal<Round>,
    /// The moment of round 1 that the words show.
    pub moment: Memo<Moment>,
    /// What is to be shown at it.
    pub frame: Memo<Option<Frame>>,
    /// A node that the pointer is on, here or there.
    pub lit: RwSignal<Option<u32>>,
    /// Whether the maze is shown as the robot knows it.
    pub robots_eye: RwSignal<bool>,
    /// Large type: maze, sentence, controls.
    pub projector: RwSignal<bool>,
    /// The open dialog.
    pub dialog: RwSignal<Option<Dialog>>,
    /// The toast.
    pub toast: RwSignal<Option<Toast>>,
    /// A link that could not be opened: why.
    pub broken_link: RwSignal<Option<String>>,
    /// Whether a link is being opened.
    pub link_coming: RwSignal<bool>,
    /// Whether the maze came by a link and is not the user's own yet.
    pub borrowed: RwSignal<bool>,
    /// Whether the browser refuses to keep the drawing.
    pub not_kept: RwSignal<bool>,
    /// Light or dark.
    pub theme: RwSignal<storage::Theme>,
    /// Whether the bots are seen to drive.
    pub motion: RwSignal<Motion>,
    /// Whether the page is being printed.
    pub printed: ReadSignal<bool>,
}

/// The state of the page.
#[must_use]
pub fn lab() -> Lab {
    expect_context::<Lab>()
}

impl Lab {
    /// The state at the beginning, with this maze and these settings.
    #[must_use]
    pub fn new(maze: Maze, settings: Settings, explorer: Name) -> Self {
        let history = RwSignal::new(History::new(maze));
        let settings = RwSignal::new(settings);
        let maze = Memo::new(move |_| Same::new(history.with(|history| history.maze().clone())));
        let own = Memo::new(move |_| settings.with(|settings| Run::of(maze.get(), settings).map(Same::new)));
        let guest = RwSignal::new(None::<Same<Guest>>);
        let run = Memo::new(move |_| {
            guest.with(|guest| guest.as_ref().map_or_else(|| own.get(), |g| Ok(g.run.clone())))
        });
        let stage = Memo::new(move |_| {
            guest.with(|guest| guest.as_ref().map_or_else(|| maze.get(), |g| g.run.maze.clone()))
        });
        let still = || RwSignal::new(Playback::default());
        let playback = still();
        let moment = Memo::new(move |_| playback.with(Playback::moment));
        let frame = Memo::new(move |_| run.with(|run| Some(run.as_ref().ok()?.trace.frame(moment.get()))));
        Self {
            history,
            maze,
            settings,
            explorer: RwSignal::new(explorer),
            other: RwSignal::new(None),
            awaited: RwSignal::new(None),
            own,
            run,
            guest,
            stage,
            link: StoredValue::new_local(None),
            halt: RwSignal::new(None),
            room: RwSignal::new(Room::Step),
            playback,
            solved: still(),
            round: RwSignal::new(Round::Explore),
            moment,
            frame,
            lit: RwSignal::new(None),
            robots_eye: RwSignal::new(false),
            projector: RwSignal::new(false),
            dialog: RwSignal::new(None),
            toast: RwSignal::new(None),
            broken_link: RwSignal::new(None),
            link_coming: RwSignal::new(false),
            borrowed: RwSignal::new(false),
            not_kept: RwSignal::new(false),
            theme: RwSignal::new(storage::theme()),
            motion: RwSignal::new(Motion::Smooth),
            printed: browser::media("print"),
        }
    }

    /// The playback that the controls move.
    #[must_use]
    pub fn playing(self) -> RwSignal<Playback> {
        match self.round.get() {
            Round::Explore => self.playback,
            Round::Solved => self.solved,
        }
    }

    /// Whether the book's explorer drives, which has a view of its own; a robot's run is the book's too.
    #[must_use]
    pub fn by_the_book(self) -> bool {
        self.guest.with(Option::is_some) || self.explorer.get() == Name::Book
    }

    /// Something about the run that is shown, whoever drives; none where there is no run.
    pub fn shown<T>(self, of: impl FnOnce(&dyn Played) -> T) -> Option<T> {
        if self.by_the_book() {
            self.run.with(|run| run.as_ref().ok().map(|run| of(&**run)))
        } else {
            self.other.with(|other| other.as_ref().and_then(|run| run.as_ref().ok()).map(|run| of(&**run)))
        }
    }

    /// Why there is no run.
    #[must_use]
    pub fn cannot(self) -> Option<CannotStart> {
        if self.by_the_book() {
            self.run.with(|run| run.as_ref().err().copied())
        } else {
            self.other.with(|other| other.as_ref().and_then(|run| run.as_ref().err().copied()))
        }
    }

    /// What is played of the run that is shown, and where.
    fn at_play(self, act: impl FnOnce(&mut Playback, &dyn Timeline)) {
        let round = self.round.get_untracked();
        untrack(|| {
            self.shown(|run| match (round, run.drive()) {
                (Round::Solved, Some(drive)) => self.solved.update(|playback| act(playback, drive)),
                _ => self.playback.update(|playback| act(playback, run.line())),
            })
        });
    }

    /// Moves the run that is shown.
    pub fn play(self, command: Command) {
        self.at_play(|playback, line| playback.apply(command, line));
    }

    /// Chooses whether the bots are seen to drive.
    pub fn set_motion(self, motion: Motion) {
        self.motion.set(motion);
        for playback in [self.playback, self.solved] {
            playback.update(|playback| playback.set_motion(motion));
        }
    }

    /// Lets time pass.
    pub fn tick(self, dt_s: f64) {
        self.at_play(|playback, line| playback.tick(dt_s, line));
    }

    /// Chooses who drives; the run begins anew.
    pub fn choose(self, explorer: Name) {
        if self.explorer.get_untracked() != explorer {
            self.other.set(None);
            self.explorer.set(explorer);
            self.rewind();
        }
    }

    /// Shows a stop of an explorer's run through the maze that is open.
    pub fn watch(self, explorer: Name, round: Round, stop: u32) {
        self.choose(explorer);
        self.guest.set(None);
        let there = untrack(|| self.shown(|_| ()).is_some());
        self.awaited.set((!there).then_some((round, stop)));
        self.show(round, stop);
    }

    /// Shows a stop of the run that is there; of round 1 where there is no round 2.
    pub fn show(self, round: Round, stop: u32) {
        let drives = untrack(|| self.shown(|run| run.drive().is_some())) == Some(true);
        self.round.set(if drives { round } else { Round::Explore });
        self.play(Command::Seek(Moment::after(stop)));
    }

    /// Changes the maze. Returns whether anything changed.
    pub fn edit(self, edit: Edit) -> bool {
        let changed = self.history.try_update(|history| history.apply(edit)).unwrap_or(false);
        if changed {
            self.maze_changed();
        }
        changed
    }

    /// Takes the last edit back.
    pub fn undo(self) {
        if self.history.try_update(History::undo).unwrap_or(false) {
            self.maze_changed();
        }
    }

    /// Makes the last edit again.
    pub fn redo(self) {
        if self.history.try_update(History::redo).unwrap_or(false) {
            self.maze_changed();
        }
    }

    /// Opens another maze; the one before can be had back by undo.
    pub fn open(self, maze: Maze) {
        self.edit(Edit::Replace(Box::new(maze)));
    }

    /// Opens what a link holds. It is not kept as the user's own until it is changed.
    pub fn borrow(self, shared: Shared) {
        self.open(shared.maze);
        self.settings.set(shared.settings);
        self.borrowed.set(true);
        // Whatever run there is, it is of what was open before.
        self.other.set(None);
        self.watch(shared.explorer, if shared.solved { Round::Solved } else { Round::Explore }, shared.stop);
    }

    fn maze_changed(self) {
        self.borrowed.set(false);
        self.rewind();
    }

    /// Changes the settings; the run begins anew.
    pub fn set(self, change: impl FnOnce(&mut Settings)) {
        self.settings.update(change);
        self.rewind();
    }

    /// Shows a robot's run; at its end, where the user follows it.
    pub fn show_guest(self, guest: Guest) {
        let before = self.guest.with_untracked(|guest| guest.as_ref().map(|guest| guest.run.trace.stops()));
        let at = self.moment.get_untracked().stop;
        let stops = guest.run.trace.stops();
        // A moment that the new run does not have must never be shown.
        let grows = before.is_some_and(|before| before <= stops);
        if !grows {
            self.rewind();
        }
        self.guest.set(Some(Same::new(guest)));
        if !grows || before == Some(at) {
            self.round.set(Round::Explore);
            self.play(Command::Seek(Moment::after(stops)));
        }
    }

    /// Back to the start of round 1 of the page's own run.
    pub fn rewind(self) {
        self.awaited.set(None);
        self.round.set(Round::Explore);
        self.lit.set(None);
        self.playback.update(Playback::rewind);
        self.solved.update(Playback::rewind);
        if self.guest.with_untracked(Option::is_some) {
            self.guest.set(None);
        }
    }

    /// Begins round 2.
    pub fn drive_solved(self) {
        self.solved.update(Playback::rewind);
        self.round.set(Round::Solved);
        self.play(Command::Toggle);
    }

    /// The drawing's name of the bot's north.
    #[must_use]
    pub fn north(self) -> Heading {
        self.stage.with(|maze| maze.start().map_or(Heading::North, |start| start.heading))
    }
}
