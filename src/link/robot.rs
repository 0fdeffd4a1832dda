//! The robot's end: driven by bytes and milliseconds, over any body and any memory, without a heap.
//!
//! It drives the very explorer that the page steps through. A firmware gives it a [`Body`] and a
//! [`Memory`], calls [`Robot::hear`] for every byte that comes in and [`Robot::tick`] in its loop, and sends
//! what [`Robot::speak`] gives.

use super::PROTOCOL;
use super::Tag;
use super::frame::{Decoder, Heard, Line, LineError};
use super::keep::{Keep, Memory};
use super::report::{Beat, Code, End, Ended, Ir, Ready, Report, Said};
use super::request::{Asked, Level, NotAsked, Request};
use super::tune::Tune;
use crate::event::Sighting;
use crate::explorer::book::Book;
use crate::explorer::book::store::{FixedStore, NodeStore};
use crate::geometry::Turn;
use crate::settings::{Order, Preference};

mod drive;
mod output;
mod reading;

use drive::Going;
use output::Output;
use reading::Reading;

/// At most one `err` in this time.
pub const ERR_EVERY_MS: u32 = 100;
/// Time between two `beat` lines.
pub const BEAT_EVERY_MS: u32 = 1_000;
/// Time between two `ir` lines.
pub const IR_EVERY_MS: u32 = 10;
/// An `end` line is told this often in all, a beat apart: noise may swallow one.
pub const END_TIMES: u8 = 3;

/// What a robot is made of besides its mind.
pub trait Body {
    /// Firmware's name and version, a word of at most 16 letters.
    const FIRMWARE: &'static str;
    /// The board, a word of at most 16 letters.
    const BOARD: &'static str;

    /// New settings, and those at the beginning.
    fn tuned(&mut self, tune: &Tune);

    /// Somebody says that the robot stands at the start now.
    fn placed(&mut self);

    /// Turn, then follow the line to the next stop.
    fn drive(&mut self, turn: Turn, now_ms: u32);

    /// How the drive goes.
    fn progress(&mut self, now_ms: u32) -> Progress;

    /// Motors off, at once.
    fn halt(&mut self, now_ms: u32);

    /// Sensors and motors now.
    fn senses(&mut self, now_ms: u32) -> Ir;

    /// The battery.
    fn millivolts(&mut self, now_ms: u32) -> u16;
}

/// How a drive goes.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Progress {
    /// On the line.
    Driving,
    /// At a stop; its `time_diff` is the time that it drove, without the turn.
    Stop(Sighting),
    /// There is no line where the robot turned to.
    NoLine,
}

/// The robot's end of the link, with a table of `NODES` nodes.
#[derive(Debug)]
pub struct Robot<B, M, const NODES: usize> {
    body: B,
    keep: Keep<M>,
    tune: Tune,
    book: Book<FixedStore<NODES>>,
    going: Going,
    placed: Placed,
    decoder: Decoder,
    output: Output,
    level: Level,
    reading: Reading,
    /// The number of the run's request, as long as no other came: it may be asked again.
    run_tag: Option<Tag>,
    last_err_ms: Option<u32>,
    last_beat_ms: u32,
    last_ir_ms: u32,
    ended: Option<(Ended, u8)>,
}

/// Whether the robot knows that it stands at the start.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Placed {
    /// It was switched on somewhere, or has driven.
    Somewhere,
    /// Somebody said so.
    AtStart,
}

impl<B: Body, M: Memory, const NODES: usize> Robot<B, M, NODES> {
    /// A robot after a reset; it says `ready`.
    #[must_use]
    pub fn boot(mut body: B, memory: M, now_ms: u32) -> Self {
        let keep = Keep::open(memory);
        let tune = keep.tune();
        body.tuned(&tune);
        let mut robot = Self {
            body,
            keep,
            tune,
            book: Book::new(FixedStore::new(), Order::Fixed(Preference::SRL), 0),
            going: Going::Idle,
            placed: Placed::Somewhere,
            decoder: Decoder::new(),
            output: Output::new(),
            level: Level::default(),
            reading: Reading::Nothing,
            run_tag: None,
            last_err_ms: None,
            last_beat_ms: now_ms,
            last_ir_ms: now_ms,
            ended: None,
        };
        robot.say_ready();
        robot
    }

    /// The body.
    pub const fn body(&mut self) -> &mut B {
        &mut self.body
    }

    /// What it keeps.
    #[must_use]
    pub const fn keep(&self) -> &Keep<M> {
        &self.keep
    }

    /// What is left when the power is gone.
    #[must_use]
    pub fn power_off(self) -> (B, M) {
        (self.body, self.keep.close())
    }

    /// The next byte to send.
    pub fn speak(&mut self) -> Option<u8> {
        self.output.pop()
    }

    /// Takes a byte.
    pub fn hear(&mut self, byte: u8, now_ms: u32) {
        // The decoder is taken out while its line is read, as the answer changes the robot.
        let mut decoder = core::mem::take(&mut self.decoder);
        match decoder.push(byte) {
            Heard::Nothing => {}
            Heard::Line(line) => self.obey(line, now_ms),
            Heard::Bad(error) => {
                let code = match error {
                    LineError::TooLong => Code::Long,
                    LineError::Byte(_) => Code::Byte,
                    LineError::Sum { .. } | LineError::Star => Code::Sum,
                };
                self.refuse(None, code, now_ms);
            }
        }
        self.decoder = decoder;
    }

    /// Lets time pass: the run, what is told unasked, and long answers as far as there is room.
    pub fn tick(&mut self, now_ms: u32) {
        self.go_on(now_ms);
        self.read_on();
        if now_ms.wrapping_sub(self.last_beat_ms) >= BEAT_EVERY_MS {
            self.last_beat_ms = now_ms;
            self.end_again();
            let millivolts = self.body.millivolts(now_ms);
            self.tell(Level::Events, &Report::Beat(Beat { ms: now_ms, millivolts }));
        }
        if now_ms.wrapping_sub(self.last_ir_ms) >= IR_EVERY_MS {
            self.last_ir_ms = now_ms;
            if self.level == Level::All && self.output.has_room_to_spare() {
                let ir = self.body.senses(now_ms);
                self.say(&Report::Ir(ir));
            }
        }
    }

    /// Whether it does not drive.
    #[must_use]
    pub fn stands(&self) -> bool {
        self.going == Going::Idle
    }

    /// Whether everything is said that it had to say.
    #[must_use]
    pub const fn is_silent(&self) -> bool {
        matches!(self.reading, Reading::Nothing) && self.output.is_empty()
    }

    /// Whether the answer to another request has room: who does not wait for answers waits for this.
    #[must_use]
    pub const fn has_room(&self) -> bool {
        matches!(self.reading, Reading::Nothing) && self.output.has_room_for_answer()
    }

    /// Says nothing unasked until it is told how much to tell.
    pub const fn hush(&mut self) {
        self.level = Level::Off;
    }

    fn obey(&mut self, line: Line<'_>, now_ms: u32) {
        // An answer is never answered: two ends that misunderstand each other would not find an end.
        if matches!(line.body.split(' ').next(), Some("err" | "ok" | "ready")) {
            return;
        }
        let (tag, done) = match Asked::parse(line) {
            Err(NotAsked { tag, code }) => (tag, Err(code)),
            Ok(Asked { tag, request }) => {
                let again = tag.is_some() && tag == self.run_tag;
                if !matches!(request, Request::Explore(_) | Request::RunRoute) {
                    self.run_tag = None;
                }
                match self.carry_out(tag, request, again, now_ms) {
                    Ok(Answer::Ok(said)) => (tag, Ok(said)),
                    Ok(Answer::Later) => return,
                    Err(code) => (tag, Err(code)),
                }
            }
        };
        match done {
            Ok(said) => self.say(&Report::Ok(tag, said)),
            Err(code) => self.refuse(tag, code, now_ms),
        }
        if let Going::Ending(end) = self.going {
            self.finish(end, now_ms);
        }
    }

    fn carry_out(
        &mut self,
        tag: Option<Tag>,
        request: Request<'_>,
        again: bool,
        now_ms: u32,
    ) -> Result<Answer, Code> {
        let running = self.going != Going::Idle;
        match request {
            Request::Hi => self.say_ready(),
            Request::Help => return Ok(Answer::Ok(Said::Typed)),
            Request::Stop if running => {
                self.body.halt(now_ms);
                // The `ok` comes first, then the `end`.
                self.going = Going::Ending(End::Stopped);
            }
            Request::Stop => {}
            Request::Watch(level) => self.level = level,
            Request::Get(name) => return Ok(Answer::Ok(Said::Setting(name, self.tune.get(name)))),
            Request::TurnsRead => {
                self.reading = Reading::turns(self.keep.list().ok_or(Code::NoList)?, tag);
                self.read_on();
                return Ok(Answer::Later);
            }
            Request::NodesRead => {
                self.reading = Reading::Nodes { tag, next: 1 };
                self.read_on();
                return Ok(Answer::Later);
            }
            Request::Explore(_) | Request::RunRoute if again => {}
            Request::TurnsBegin(_)
            | Request::TurnsData { .. }
            | Request::TurnsCommit { .. }
            | Request::Explore(_)
            | Request::RunRoute
            | Request::Place
            | Request::Set(..)
                if running =>
            {
                return Err(Code::Busy);
            }
            Request::TurnsBegin(upload) => self.keep.begin(upload)?,
            Request::TurnsData { id, offset, letters } => self.keep.data(id, offset, letters)?,
            Request::TurnsCommit { id } => self.keep.commit(id)?,
            Request::Explore(order) => self.explore(order, tag, now_ms)?,
            Request::RunRoute => self.run_route(tag, now_ms)?,
            Request::Place => {
                self.placed = Placed::AtStart;
                self.body.placed();
            }
            Request::Set(name, value) => {
                let tune = self.tune.with(name, value).map_err(|_| Code::Range)?;
                self.keep.set_tune(&tune)?;
                self.tune = tune;
                self.body.tuned(&tune);
                return Ok(Answer::Ok(Said::Setting(name, value)));
            }
        }
        Ok(Answer::Ok(Said::Nothing))
    }

    fn say_ready(&mut self) {
        let (nodes, turns) = (self.book.nodes().capacity() as u16, self.keep.capacity());
        let ready = Ready { protocol: PROTOCOL, firmware: B::FIRMWARE, board: B::BOARD, nodes, turns };
        self.say(&Report::Ready(ready));
    }

    /// An error, unless there was one just now: whoever asks will ask again.
    fn refuse(&mut self, tag: Option<Tag>, code: Code, now_ms: u32) {
        let lately = |last: u32| now_ms.wrapping_sub(last) < ERR_EVERY_MS;
        if !self.last_err_ms.is_some_and(lately) {
            self.last_err_ms = Some(now_ms);
            self.say(&Report::Err(tag, code));
        }
    }

    /// Says it, if there is room; a request without an answer comes again.
    fn say(&mut self, report: &Report<'_>) {
        self.output.line(report.write().seal());
    }

    /// Says it, if somebody listens to this much.
    fn tell(&mut self, level: Level, report: &Report<'_>) {
        let told = match (self.level, level) {
            (Level::Off, Level::Events | Level::All) | (Level::Events, Level::All) => false,
            (Level::All, _) | (_, Level::Off) | (Level::Events, Level::Events) => true,
        };
        if told {
            self.say(report);
        }
    }
}

/// How a request is answered.
enum Answer {
    /// By this `ok`.
    Ok(Said),
    /// By lines, then an `ok`, as there is room.
    Later,
}
