//! Moving through a run in time: play and pause, step by stop or by line, jump to events, scrub.
//!
//! Headless: a view sends [`Command`]s and ticks, and shows the [`Moment`] and how far the bot has driven
//! towards the next stop. Anything with stops can be played: a trace, or the drive of a solved maze.

use crate::trace::Moment;

/// What can be played.
pub trait Timeline {
    /// Stops after the start.
    fn stops(&self) -> u32;

    /// Lines of the algorithm that run at a stop, at least 1; the start counts as 1 whatever it says.
    fn lines(&self, stop: u32) -> u8;

    /// Milliseconds of driving towards a stop.
    fn drive_ms(&self, stop: u32) -> u32;

    /// What kind of event a stop is.
    fn mark(&self, stop: u32) -> Mark;
}

/// Kinds of stops, as the scrubber marks them.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Mark {
    /// A corner, or the start: nothing to mark.
    Plain,
    /// A node, for the first time.
    Node,
    /// A dead end.
    DeadEnd,
    /// A node met again on the way back.
    Known,
    /// A node met again by a new way.
    Unknown,
    /// The finish, or wherever the run ends.
    End,
}

impl Mark {
    /// The kinds that can be searched for, with their names.
    pub const NAMED: [(Self, &'static str); 5] = [
        (Self::Node, "new node"),
        (Self::DeadEnd, "dead end"),
        (Self::Known, "RETURN-KNOWN"),
        (Self::Unknown, "RETURN-UNKNOWN"),
        (Self::End, "end"),
    ];
}

/// What one step is.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Unit {
    /// From stop to stop.
    #[default]
    Stop,
    /// Line by line of the algorithm.
    Line,
}

/// Whether the bot is seen to drive.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Motion {
    /// It drives from stop to stop.
    #[default]
    Smooth,
    /// It is at one stop, then at the next.
    Reduced,
}

/// What a person asks for.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Command {
    /// Plays, or pauses.
    Toggle,
    /// Stops where it is.
    Pause,
    /// One step on, of the chosen unit.
    Forward,
    /// One step back.
    Back,
    /// One step on of this unit.
    ForwardBy(Unit),
    /// One step back of this unit.
    BackBy(Unit),
    /// To the start.
    ToStart,
    /// To the end.
    ToEnd,
    /// To a moment, at once.
    Seek(Moment),
    /// To the next stop of a kind; any kind if none is named.
    NextEvent(Option<Mark>),
    /// To the stop before of a kind.
    PreviousEvent(Option<Mark>),
    /// Chooses what a step is.
    StepBy(Unit),
    /// Chooses how fast it plays; 1 is the robot's own pace.
    Speed(f64),
}

/// The speeds that are offered; 1 is the robot's own pace.
pub const SPEEDS: [f64; 8] = [0.5, 1.0, 2.0, 4.0, 8.0, 32.0, 128.0, 512.0];

/// Seconds of rest at a stop while playing at speed 1, to read what happened.
const REST_S: f64 = 0.9;
/// Seconds of rest at a line.
const LINE_REST_S: f64 = 0.7;
/// No drive is shown for longer than this, in seconds at speed 1.
const LONGEST_DRIVE_S: f64 = 2.4;
/// A single step is shown within this, in seconds.
const STEP_S: f64 = 0.28;

/// What goes on.
#[derive(Clone, Copy, Debug, PartialEq)]
enum Going {
    /// Nothing.
    Still,
    /// On and on; this many seconds of rest are left at the stop.
    Playing { rest_s: f64 },
    /// To the next stop, then still, at this moment.
    On { to: Moment },
    /// Backwards to the stop that the words already show, from this moment.
    Home { from: Moment },
}

/// Where a run is played, and how.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Playback {
    moment: Moment,
    along: f64,
    going: Going,
    unit: Unit,
    motion: Motion,
    speed: f64,
}

impl Default for Playback {
    fn default() -> Self {
        Self {
            moment: Moment::default(),
            along: 0.0,
            going: Going::Still,
            unit: Unit::Stop,
            motion: Motion::Smooth,
            speed: 1.0,
        }
    }
}

impl Playback {
    /// The moment that the words show. Its lines may be more than the stop has, which means all.
    #[must_use]
    pub const fn moment(&self) -> Moment {
        self.moment
    }

    /// How much of the way to the next stop the bot has driven, 0 to 1.
    #[must_use]
    pub const fn along(&self) -> f64 {
        self.along
    }

    /// The moment at which the drive towards the next stop ends, or ended: whether the lines of that stop have run
    /// decides how the bot faces there.
    #[must_use]
    pub const fn bound(&self) -> Moment {
        match self.going {
            Going::On { to } => to,
            Going::Home { from } => from,
            Going::Still | Going::Playing { .. } => self.arrival(self.moment.stop + 1),
        }
    }

    /// Whether it plays on and on.
    #[must_use]
    pub const fn is_playing(&self) -> bool {
        matches!(self.going, Going::Playing { .. })
    }

    /// Whether time changes anything: views ask for ticks while it does.
    #[must_use]
    pub const fn is_moving(&self) -> bool {
        !matches!(self.going, Going::Still)
    }

    /// What a step is.
    #[must_use]
    pub const fn unit(&self) -> Unit {
        self.unit
    }

    /// How fast it plays.
    #[must_use]
    pub const fn speed(&self) -> f64 {
        self.speed
    }

    /// Chooses whether the bot is seen to drive. Without motion a drive that goes on is over.
    pub const fn set_motion(&mut self, motion: Motion) {
        self.motion = motion;
        match (motion, self.going) {
            (Motion::Smooth, _) => {}
            (Motion::Reduced, Going::On { to }) => self.jump(to),
            (Motion::Reduced, Going::Home { .. }) => self.jump(self.moment),
            // It waits at the stop that the words show, or goes on from there.
            (Motion::Reduced, Going::Still | Going::Playing { .. }) => self.along = 0.0,
        }
    }

    /// Back to the start, standing still; speed and steps stay as they were chosen.
    pub const fn rewind(&mut self) {
        self.jump(Moment { stop: 0, lines: 0 });
    }

    /// Does what a person asks for.
    pub fn apply(&mut self, command: Command, line: &dyn Timeline) {
        let stop = self.moment.stop;
        match command {
            Command::Toggle if self.is_playing() => self.going = Going::Still,
            Command::Toggle => {
                if self.at_end(line) {
                    self.jump(Moment::default());
                }
                self.going = Going::Playing { rest_s: 0.0 };
            }
            Command::Pause => self.going = Going::Still,
            Command::Forward => self.forward(self.unit, line),
            Command::Back => self.back(self.unit, line),
            Command::ForwardBy(unit) => self.forward(unit, line),
            Command::BackBy(unit) => self.back(unit, line),
            Command::ToStart => self.jump(Moment::default()),
            Command::ToEnd => self.jump(Moment::after(line.stops())),
            Command::Seek(to) => self.jump(Moment { stop: to.stop.min(line.stops()), ..to }),
            Command::NextEvent(kind) => {
                let next = (stop + 1..=line.stops()).find(|&stop| matches(kind, line.mark(stop)));
                self.jump(Moment::after(next.unwrap_or(if kind.is_none() { line.stops() } else { stop })));
            }
            Command::PreviousEvent(kind) => {
                let before = (1..stop).rev().find(|&stop| matches(kind, line.mark(stop)));
                self.jump(Moment::after(before.unwrap_or(if kind.is_none() { 0 } else { stop })));
            }
            Command::StepBy(unit) => self.unit = unit,
            Command::Speed(speed) => self.speed = speed,
        }
    }

    /// Lets time pass, in seconds.
    pub fn tick(&mut self, dt_s: f64, line: &dyn Timeline) {
        // After a pause of the page itself (a hidden tab), time goes on where it stood.
        let dt_s = dt_s.clamp(0.0, 0.25);
        match self.going {
            Going::Still => {}
            Going::Playing { rest_s } => self.play(dt_s * self.speed, rest_s, line),
            Going::On { to } => {
                self.along += dt_s / STEP_S;
                if self.along >= 1.0 {
                    self.jump(to);
                }
            }
            Going::Home { .. } => {
                self.along -= dt_s / STEP_S;
                if self.along <= 0.0 {
                    self.jump(self.moment);
                }
            }
        }
    }

    /// Plays for `left_s` seconds at speed 1; that may be many stops.
    fn play(&mut self, mut left_s: f64, mut rest_s: f64, line: &dyn Timeline) {
        loop {
            let pause = rest_s.min(left_s);
            rest_s -= pause;
            left_s -= pause;
            if rest_s > 0.0 {
                break;
            }
            if self.unit == Unit::Line && self.along == 0.0 && self.lines_left(line) {
                self.moment.lines += 1;
                rest_s = LINE_REST_S;
                continue;
            }
            if self.moment.stop >= line.stops() {
                self.going = Going::Still;
                return;
            }
            // Who drives off has done all lines of the stop.
            if self.along == 0.0 {
                self.moment = Moment::after(self.moment.stop);
            }
            let next = self.moment.stop + 1;
            let drive_s = (f64::from(line.drive_ms(next)) / 1000.0).clamp(0.05, LONGEST_DRIVE_S);
            let way_left = if self.motion == Motion::Smooth { (1.0 - self.along) * drive_s } else { 0.0 };
            if way_left > left_s {
                self.along += left_s / drive_s;
                break;
            }
            left_s -= way_left;
            self.moment = self.arrival(next);
            self.along = 0.0;
            rest_s = if self.unit == Unit::Line { LINE_REST_S } else { REST_S };
        }
        self.going = Going::Playing { rest_s };
    }

    /// The moment at which a stop begins for this unit of steps.
    const fn arrival(&self, stop: u32) -> Moment {
        match self.unit {
            Unit::Stop => Moment::after(stop),
            Unit::Line => Moment { stop, lines: 1 },
        }
    }

    fn forward(&mut self, unit: Unit, line: &dyn Timeline) {
        if let Going::On { to } = self.going {
            self.jump(to);
        }
        if unit == Unit::Line && self.lines_left(line) {
            return self.jump(Moment { lines: self.moment.lines + 1, ..self.moment });
        }
        if self.lines_left(line) {
            return self.jump(Moment::after(self.moment.stop));
        }
        let stop = self.moment.stop + 1;
        if stop > line.stops() {
            return self.jump(self.moment);
        }
        let to = if unit == Unit::Line { Moment { stop, lines: 1 } } else { Moment::after(stop) };
        match self.motion {
            Motion::Smooth => self.going = Going::On { to },
            Motion::Reduced => self.jump(to),
        }
    }

    fn back(&mut self, unit: Unit, line: &dyn Timeline) {
        if self.along > 0.0 && !matches!(self.going, Going::Home { .. }) {
            // In the middle of a drive: back to where it began.
            match self.motion {
                Motion::Smooth => self.going = Going::Home { from: self.bound() },
                Motion::Reduced => self.jump(self.moment),
            }
            return;
        }
        let here = self.moment.lines.min(line.lines(self.moment.stop));
        if unit == Unit::Line && here > 1 && self.moment.stop > 0 {
            return self.jump(Moment { lines: here - 1, ..self.moment });
        }
        if self.moment.stop == 0 {
            return self.jump(self.moment);
        }
        let from = self.moment;
        self.jump(Moment::after(from.stop - 1));
        if self.motion == Motion::Smooth {
            self.along = 1.0;
            self.going = Going::Home { from };
        }
    }

    /// At a moment, standing still.
    const fn jump(&mut self, to: Moment) {
        self.moment = to;
        self.along = 0.0;
        self.going = Going::Still;
    }

    fn lines_left(&self, line: &dyn Timeline) -> bool {
        self.moment.stop > 0 && self.moment.lines < line.lines(self.moment.stop)
    }

    fn at_end(&self, line: &dyn Timeline) -> bool {
        self.moment.stop >= line.stops() && !self.lines_left(line)
    }
}

fn matches(kind: Option<Mark>, mark: Mark) -> bool {
    kind.map_or(mark != Mark::Plain, |kind| kind == mark)
}

#[cfg(test)]
mod tests;
