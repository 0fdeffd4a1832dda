//! A run of any explorer but the book's, stop by stop: small enough to keep millions of stops, quick to
//! enter at any of them.
//!
//! Minds are deterministic: fed with the same looks, a mind is in the same state. So a [`Step`] of 8 bytes
//! keeps what was seen, where, and how the robot turned, and copies of the mind stand at even distances as
//! keyframes. Entering a stop means feeding a copy with the few looks since ([`Recording::at`]); a
//! [`Cursor`] that moves forward goes on from where it was. Counts of the drive are kept every
//! [`TALLY_EVERY`] stops, so that distance, turns and seconds are known at any stop at once.

use alloc::vec::Vec;

use crate::event::{Decision, Look, Outcome};
use crate::explorer::book::narrate::Narration;
use crate::explorer::mind::Mind;
use crate::explorer::name::Name;
use crate::explorer::tell::{Case, Said, Told};
use crate::geometry::{Heading, Point};
use crate::maze::{Bounds, Start};
use crate::playback::{Mark, Timeline};
use crate::route::tally::Tally;

pub mod driven;
mod keys;
pub mod moment;
mod step;

use keys::Keys;
pub use step::Step;

/// Stops between two counts of the drive.
pub const TALLY_EVERY: usize = 64;

/// A whole run.
#[derive(Clone, Debug)]
pub struct Recording {
    name: Name,
    bounds: Bounds,
    start: Start,
    cell_ms: u32,
    steps: Vec<Step>,
    tallies: Vec<Tally>,
    keys: Keys,
    outcome: Outcome,
    last: Mind,
}

/// A stop of a recording, with the mind as it was when the stop was over.
#[derive(Clone, Debug)]
pub struct Stop {
    /// 0 is the start.
    pub stop: u32,
    /// The lattice point.
    pub at: Point,
    /// The drawing's heading with which the robot arrived.
    pub heading: Heading,
    /// What it saw.
    pub look: Look,
    /// What it did.
    pub decision: Decision,
    /// The lines that ran, and which case it was.
    pub said: Said,
    /// Its state.
    pub mind: Mind,
}

impl Recording {
    /// Who drove.
    #[must_use]
    pub const fn name(&self) -> Name {
        self.name
    }

    /// Where the robot was put down, and how it faced.
    #[must_use]
    pub const fn start(&self) -> Start {
        self.start
    }

    /// Milliseconds for a cell.
    #[must_use]
    pub const fn cell_ms(&self) -> u32 {
        self.cell_ms
    }

    /// A lattice point as seen from the start, in the robot's own frame.
    #[must_use]
    pub fn from_start(&self, at: Point) -> Point {
        let Start { at: start, heading } = self.start;
        Point::new(at.x - start.x, at.y - start.y).in_frame_of(heading)
    }

    /// Stops after the start.
    #[must_use]
    pub const fn stops(&self) -> u32 {
        self.steps.len() as u32 - 1
    }

    /// The steps; the first is stop 0.
    #[must_use]
    pub fn steps(&self) -> &[Step] {
        &self.steps
    }

    /// How the run ended.
    #[must_use]
    pub const fn outcome(&self) -> Outcome {
        self.outcome
    }

    /// The mind at the end.
    #[must_use]
    pub const fn last(&self) -> &Mind {
        &self.last
    }

    /// A step; past the end, the last.
    #[must_use]
    pub fn step(&self, stop: u32) -> Step {
        self.steps[(stop.min(self.stops())) as usize]
    }

    /// Where a stop is.
    #[must_use]
    pub fn place(&self, stop: u32) -> Point {
        self.point(self.step(stop))
    }

    /// Every place in order, the start included.
    pub fn places(&self) -> impl ExactSizeIterator<Item = Point> {
        self.steps.iter().map(|&step| self.point(step))
    }

    const fn point(&self, step: Step) -> Point {
        let sw = self.bounds.sw();
        let from_sw = step.at();
        Point::new(sw.x + from_sw.x, sw.y + from_sw.y)
    }

    /// Cells from the stop before.
    #[must_use]
    pub fn cells(&self, stop: u32) -> u32 {
        if stop == 0 || stop > self.stops() { 0 } else { self.step(stop).cells_from(self.step(stop - 1)) }
    }

    /// What the robot saw at a stop.
    #[must_use]
    pub fn look(&self, stop: u32) -> Look {
        self.step(stop).look(self.cells(stop) * self.cell_ms)
    }

    /// What it did there.
    #[must_use]
    pub fn decision(&self, stop: u32) -> Decision {
        self.step(stop).turn().map_or(Decision::End(self.outcome), Decision::Go)
    }

    /// Which case a stop was.
    #[must_use]
    pub fn case(&self, stop: u32) -> &'static Case {
        let cases = self.name.about().cases;
        &cases[usize::from(self.step(stop).case()).min(cases.len() - 1)]
    }

    /// What was driven up to the arrival at a stop: the turns of the stops before it are in it, its own is
    /// not. Seconds follow from that and the pace.
    ///
    /// ```
    /// use line_maze_lab::explorer::name::Name;
    /// use line_maze_lab::{maze::samples, run, settings::Settings};
    /// let settings = Settings::default();
    /// let run = run::record(&samples::figure_2_4(), &settings, Name::LeftHand)?;
    /// assert_eq!((run.tally(1).cells, run.tally(1).stops), (2, 1));
    /// assert_eq!(run.tally(1).seconds(200.0, &settings.pace), 0.8);
    /// # Ok::<(), line_maze_lab::world::CannotStart>(())
    /// ```
    #[must_use]
    pub fn tally(&self, stop: u32) -> Tally {
        let stop = stop.min(self.stops()) as usize;
        let key = stop / TALLY_EVERY;
        self.steps[key * TALLY_EVERY..=stop]
            .windows(2)
            .fold(self.tallies[key], |tally, pair| on(tally, pair[0]).driven(pair[1].cells_from(pair[0])))
    }

    /// A stop, with the mind as it was when the stop was over; past the end, the last stop.
    #[must_use]
    pub fn at(&self, stop: u32) -> Stop {
        let stop = stop.min(self.stops());
        let (from, mind) = self.keys.before(stop);
        self.replay(from, mind.clone(), stop)
    }

    /// Feeds a mind that is ready for stop `from` with all up to `stop`.
    fn replay(&self, from: u32, mut mind: Mind, stop: u32) -> Stop {
        let mut said = Said::default();
        for now in from..=stop {
            said = Said::default();
            mind.decide(self.look(now), &mut said);
        }
        let (at, heading) = (self.place(stop), self.step(stop).heading());
        Stop { stop, at, heading, look: self.look(stop), decision: self.decision(stop), said, mind }
    }

    /// The sentences about a stop.
    #[must_use]
    pub fn narrate(&self, stop: &Stop) -> Narration {
        let told = Told {
            case: self.case(stop.stop),
            look: stop.look,
            decision: stop.decision,
            cells: self.cells(stop.stop),
            section: self.name.about().source,
        };
        told.narrate(stop.mind.robot())
    }

    /// Bytes that the recording takes in memory.
    #[must_use]
    pub fn bytes(&self) -> usize {
        size_of_val(self.steps.as_slice()) + size_of_val(self.tallies.as_slice()) + self.keys.bytes()
    }
}

/// A drive with the turn of a stop.
fn on(tally: Tally, step: Step) -> Tally {
    step.turn().map_or(tally, |turn| tally.turned(turn))
}

/// A place in a recording that remembers the mind: going forward costs one decision a stop, going elsewhere
/// what [`Recording::at`] costs.
#[derive(Clone, Debug, Default)]
pub struct Cursor(Option<Stop>);

impl Cursor {
    /// Goes to a stop of a recording; always the same recording.
    pub fn seek(&mut self, recording: &Recording, stop: u32) -> &Stop {
        let stop = stop.min(recording.stops());
        let (key, _) = recording.keys.before(stop);
        let next = match self.0.take() {
            Some(here) if here.stop == stop => here,
            Some(here) if here.stop < stop && here.stop >= key => {
                recording.replay(here.stop + 1, here.mind, stop)
            }
            _ => recording.at(stop),
        };
        self.0.insert(next)
    }
}

impl Timeline for Recording {
    fn stops(&self) -> u32 {
        self.stops()
    }

    fn lines(&self, stop: u32) -> u8 {
        self.step(stop).lines()
    }

    fn drive_ms(&self, stop: u32) -> u32 {
        self.cells(stop) * self.cell_ms
    }

    fn mark(&self, stop: u32) -> Mark {
        if stop > 0 && stop == self.stops() { Mark::End } else { self.case(stop).mark }
    }
}

/// Writes a recording while a run goes on.
#[derive(Debug)]
pub(crate) struct Recorder {
    name: Name,
    bounds: Bounds,
    start: Start,
    cell_ms: u32,
    steps: Vec<Step>,
    tallies: Vec<Tally>,
    tally: Tally,
    keys: Keys,
}

impl Recorder {
    pub(crate) const fn new(name: Name, bounds: Bounds, start: Start, cell_ms: u32) -> Self {
        Self {
            name,
            bounds,
            start,
            cell_ms,
            steps: Vec::new(),
            tallies: Vec::new(),
            tally: Tally::NONE,
            keys: Keys::new(),
        }
    }

    /// A stop begins with this mind.
    pub(crate) fn begin(&mut self, mind: &Mind) {
        self.keys.offer(self.steps.len(), mind);
    }

    /// It ends with this: what the robot meant to do, and what came of it.
    pub(crate) fn end(
        &mut self,
        look: Look,
        at: Point,
        heading: Heading,
        decisions: [Decision; 2],
        said: &Said,
    ) {
        let sw = self.bounds.sw();
        let at = Point::new(at.x - sw.x, at.y - sw.y);
        let step = Step::new(look, at, heading, decisions, said);
        if let Some(&before) = self.steps.last() {
            self.tally = on(self.tally, before).driven(step.cells_from(before));
        }
        if self.steps.len().is_multiple_of(TALLY_EVERY) {
            self.tallies.push(self.tally);
        }
        self.steps.push(step);
    }

    /// The stop that goes on; 0 is the start.
    pub(crate) const fn next(&self) -> u32 {
        self.steps.len() as u32
    }

    pub(crate) fn finish(mut self, outcome: Outcome, last: Mind) -> Recording {
        self.steps.shrink_to_fit();
        let Self { name, bounds, start, cell_ms, steps, tallies, keys, .. } = self;
        Recording { name, bounds, start, cell_ms, steps, tallies, keys, outcome, last }
    }
}
