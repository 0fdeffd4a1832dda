//! A run of any explorer but the book's, with all that the views ask of it.

use crate::explorer::book::errata::{self, Erratum, Walk};
use crate::explorer::name::{About, Name};
use crate::maze::{Maze, samples};
use crate::playback::{Mark, Timeline};
use crate::recording::Recording;
use crate::recording::driven::Driven;
use crate::recording::moment::At;
use crate::route::best::{self, Best};
use crate::route::tally::Tally;
use crate::route::{Drive, Strayed, TurnList};
use crate::run::{self, AnyRun};
use crate::settings::{Pace, Settings};
use crate::web::played::Played;
use crate::web::run_view::{Same, is_figure};
use crate::world::CannotStart;

/// The run.
#[derive(Debug)]
pub struct OtherRun {
    /// The maze.
    pub maze: Same<Maze>,
    /// What the robot saw and did.
    pub recording: Recording,
    /// What it left on the floor.
    pub driven: Driven,
    /// What driving costs.
    pub pace: Pace,
    /// What was driven in all.
    pub total: Tally,
    /// The letters of round 2, if there are any.
    pub list: Option<TurnList>,
    /// Round 2, if the letters lead to the finish.
    pub drive: Option<Drive>,
    /// Where they lead instead.
    pub strayed: Option<Strayed>,
    /// The shortest way that the maze has.
    pub shortest: Option<Best>,
    /// The quickest.
    pub fastest: Option<Best>,
    /// Whether it is a figure's walk, on which its source has notes.
    pub walk: Walk,
    kinds: Vec<(Mark, &'static str)>,
}

impl OtherRun {
    /// Runs an explorer.
    ///
    /// # Errors
    /// Where the robot cannot be put down.
    pub fn of(maze: Same<Maze>, settings: &Settings, name: Name) -> Result<Self, CannotStart> {
        let any = run::record(&maze, settings, name)?;
        let (way, total) = (any.way(&maze), any.total());
        let AnyRun::Other(recording) = any else { return Err(CannotStart::NoStart) };
        let best = |of: fn(&Maze, _, &Pace) -> Option<Best>| of(&maze, recording.start(), &settings.pace);
        let (shortest, fastest) = (best(best::shortest), best(best::fastest));
        let cell_ms = recording.cell_ms();
        let (list, drive, strayed) = match way {
            None => (None, None, None),
            Some(way) => match way.route {
                Ok(route) => (Some(way.list), Some(Drive { route, cell_ms }), None),
                Err(strayed) => (Some(way.list), None, Some(strayed)),
            },
        };
        let driven = Driven::of(&recording);
        let (pace, kinds) = (settings.pace, kinds(recording.name().about()));
        let mapped = name == Name::Mapping && is_figure(&maze, &samples::SAKIB_2.maze());
        let walk = if mapped { Walk::SakibFigure2 } else { Walk::Other };
        Ok(Self {
            maze,
            recording,
            driven,
            pace,
            total,
            list,
            drive,
            strayed,
            shortest,
            fastest,
            walk,
            kinds,
        })
    }

    /// What is to be known about the explorer.
    pub fn about(&self) -> &'static About {
        self.recording.name().about()
    }
}

/// The marks that an explorer's stops can have, each by its first case's word.
fn kinds(about: &About) -> Vec<(Mark, &'static str)> {
    let mut kinds: Vec<(Mark, &'static str)> = Vec::new();
    for case in about.cases {
        let known = kinds.iter().any(|&(mark, _)| mark == case.mark);
        if case.mark != Mark::Plain && case.mark != Mark::End && !known {
            kinds.push((case.mark, case.shown));
        }
    }
    kinds.push((Mark::End, "end"));
    kinds
}

impl Played for Same<OtherRun> {
    fn title(&self) -> &'static str {
        self.about().title
    }

    fn line(&self) -> &dyn Timeline {
        &self.recording
    }

    fn drive(&self) -> Option<&Drive> {
        self.drive.as_ref()
    }

    fn list(&self) -> Option<&TurnList> {
        self.list.as_ref()
    }

    fn cells(&self, stop: u32) -> u64 {
        u64::from(self.recording.tally(stop).cells)
    }

    fn word(&self, stop: u32) -> String {
        self.recording.case(stop).shown.to_owned()
    }

    fn kinds(&self) -> &[(Mark, &'static str)] {
        &self.kinds
    }
}

/// The notes on the source that apply at a moment, when the stop is over.
pub fn errata(run: &OtherRun, at: &At) -> impl Iterator<Item = &'static Erratum> + use<> {
    let notes = errata::at_stop(run.about().errata, run.walk, at.stop.stop, &at.stop.said);
    at.is_whole().then_some(notes).into_iter().flatten()
}

/// Whether the run is over.
pub fn is_end(run: &OtherRun, at: &At) -> bool {
    at.is_whole() && at.stop.stop == run.recording.stops()
}
