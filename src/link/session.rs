//! A recorded session: what was said on the wire, saved as a text file and opened again without the robot.
//!
//! The first line is `line-maze-session: 1`. Each line after it is milliseconds since the beginning, `<` for
//! what the robot said or `>` for what was sent, and the line with its checksum. Blank lines and those that
//! begin with `#` do not count.

use alloc::collections::VecDeque;
use alloc::string::String;
use alloc::vec::Vec;
use core::fmt::{self, Write};

use super::frame::{Line, Sum, crc8};
use super::live::{Errand, LiveRun, Mind, is_first};
use super::monitor::Way;
use super::report::{Report, Said};
use super::request::{Asked, Request};
use crate::event::Cut;
use crate::settings::Pace;

/// What every session begins with.
const HEADER: &str = "line-maze-session: 1";
/// Lines about runs, answers and requests that are kept.
pub const MOST_LINES: usize = 50_000;
/// Sensor lines and beats that are kept: the last ones.
pub const MOST_CHATTER: usize = 10_000;
/// A file may have so many bytes.
pub const MAX_BYTES: usize = 16 << 20;

/// A line of a session, without its checksum.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Utterance {
    /// Since the session's beginning.
    pub ms: u64,
    /// Which way.
    pub way: Way,
    /// What.
    pub body: String,
}

/// Records while the link is used: all that is said of runs, and the last of the sensors.
#[derive(Debug)]
pub struct Recorder {
    begin_ms: u64,
    lines: Vec<Utterance>,
    chatter: VecDeque<Utterance>,
    missed: u64,
}

impl Recorder {
    pub(super) const fn new(now_ms: u64) -> Self {
        Self { begin_ms: now_ms, lines: Vec::new(), chatter: VecDeque::new(), missed: 0 }
    }

    /// Takes a good line from the robot.
    pub(super) fn heard(&mut self, body: &str, now_ms: u64) {
        let line = Utterance { ms: now_ms.saturating_sub(self.begin_ms), way: Way::In, body: body.into() };
        if body.starts_with("ir ") || body.starts_with("beat ") {
            if self.chatter.len() == MOST_CHATTER {
                self.chatter.pop_front();
            }
            self.chatter.push_back(line);
        } else {
            self.push(line);
        }
    }

    /// Takes what was sent, line by line.
    pub(super) fn sent(&mut self, bytes: &[u8], now_ms: u64) {
        let text = core::str::from_utf8(bytes).unwrap_or_default();
        for line in text.split(['\n', '\r']).filter(|line| !line.is_empty()) {
            let body = line.rsplit_once('*').map_or(line, |(body, _)| body).into();
            self.push(Utterance { ms: now_ms.saturating_sub(self.begin_ms), way: Way::Out, body });
        }
    }

    fn push(&mut self, line: Utterance) {
        // The beginning of a run is worth more than its end.
        if self.lines.len() < MOST_LINES {
            self.lines.push(line);
        } else {
            self.missed += 1;
        }
    }

    /// Forgets everything: a new session begins.
    pub fn restart(&mut self, now_ms: u64) {
        *self = Self::new(now_ms);
    }

    /// Lines that are kept.
    #[must_use]
    pub fn len(&self) -> usize {
        self.lines.len() + self.chatter.len()
    }

    /// Whether nothing was said yet.
    #[must_use]
    pub fn is_empty(&self) -> bool {
        self.len() == 0
    }

    /// Lines that had no room any more.
    #[must_use]
    pub const fn missed(&self) -> u64 {
        self.missed
    }

    /// The session as a file.
    #[must_use]
    pub fn save(&self) -> String {
        let mut lines: Vec<&Utterance> = self.lines.iter().chain(&self.chatter).collect();
        lines.sort_by_key(|line| line.ms);
        write(lines.into_iter())
    }
}

fn write<'a>(lines: impl Iterator<Item = &'a Utterance>) -> String {
    let mut text = String::from(HEADER);
    text.push('\n');
    for Utterance { ms, way, body } in lines {
        let way = match way {
            Way::In => '<',
            Way::Out => '>',
        };
        // Writing to a string cannot fail.
        let _ = writeln!(text, "{ms} {way} {body}*{:02X}", crc8(body.as_bytes()));
    }
    text
}

/// A session that was opened.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Session {
    /// Its lines, in the order in which they were said.
    pub lines: Vec<Utterance>,
}

/// Why a text is no session.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct SessionError {
    /// The line, from 1.
    pub line: usize,
    /// What is wrong there.
    pub problem: Problem,
}

/// What is wrong with a line of a session.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Problem {
    /// The first line is another.
    Header,
    /// It does not begin with milliseconds and `<` or `>`.
    Form,
    /// Its checksum is wrong or missing.
    Sum,
    /// The file is too large.
    TooLarge,
}

impl fmt::Display for SessionError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "line {}: ", self.line)?;
        f.write_str(match self.problem {
            Problem::Header => {
                "a session begins with “line-maze-session: 1”; open a file that this page saved"
            }
            Problem::Form => {
                "expected milliseconds, < or >, and what was said, as in “514 < beat 3000 7409*76”"
            }
            Problem::Sum => {
                "the checksum does not fit: the line was changed; save the session again or delete the line"
            }
            Problem::TooLarge => "a session has at most 16 MB; cut the file after a line",
        })
    }
}

impl core::error::Error for SessionError {}

impl Session {
    /// Reads a file.
    ///
    /// # Errors
    /// Where it is no session; says the line.
    pub fn parse(text: &str) -> Result<Self, SessionError> {
        let at = |line, problem| SessionError { line, problem };
        if text.len() > MAX_BYTES {
            return Err(at(1, Problem::TooLarge));
        }
        let mut lines = text.trim_start_matches('\u{feff}').lines().zip(1..);
        if lines.next().is_none_or(|(line, _)| line.trim_end() != HEADER) {
            return Err(at(1, Problem::Header));
        }
        let mut session = Self::default();
        for (line, number) in lines {
            let line = line.trim_end();
            if !line.is_empty() && !line.starts_with('#') {
                session.lines.push(said(line).map_err(|problem| at(number, problem))?);
            }
        }
        Ok(session)
    }

    /// The same as a file.
    #[must_use]
    pub fn save(&self) -> String {
        write(self.lines.iter())
    }

    /// The runs, each as the stepper shows it; `mind` is what the page's explorer decides with, where the
    /// session does not say it. The last one may have no end: the session was saved while the robot drove.
    #[must_use]
    pub fn runs(&self, mind: Mind, pace: Pace) -> Vec<LiveRun> {
        let mut runs: Vec<LiveRun> = Vec::new();
        let mut mind = mind;
        for line in &self.lines {
            match line.way {
                Way::Out => {
                    let asked = Asked::parse(Line { body: &line.body, sum: Sum::Right });
                    let errand = match asked.map(|asked| asked.request) {
                        Ok(Request::Explore(order)) => Errand::Explore(Mind { order, ..mind }),
                        Ok(Request::RunRoute) => Errand::Route,
                        Ok(_) | Err(_) => continue,
                    };
                    // The same request may be sent again, until it is answered.
                    if runs.last().is_none_or(|run| run.stops() > 0 || run.end().is_some()) {
                        begin(&mut runs, errand, pace);
                    }
                }
                Way::In => fold(&mut runs, &line.body, &mut mind, pace),
            }
        }
        runs.retain(|run| run.stops() > 0);
        runs
    }
}

/// A line of a session file.
fn said(line: &str) -> Result<Utterance, Problem> {
    let (ms, rest) = line.split_once(' ').ok_or(Problem::Form)?;
    let (way, rest) = rest.split_once(' ').ok_or(Problem::Form)?;
    let ms = super::fields::number(ms).and_then(|ms| u64::try_from(ms).ok()).ok_or(Problem::Form)?;
    let way = match way {
        "<" => Way::In,
        ">" => Way::Out,
        _ => return Err(Problem::Form),
    };
    let (body, sum) = rest.rsplit_once('*').ok_or(Problem::Sum)?;
    let right = alloc::format!("{:02X}", crc8(body.as_bytes()));
    if sum == right { Ok(Utterance { ms, way, body: body.into() }) } else { Err(Problem::Sum) }
}

/// Another run begins; if the end of the one before was not heard, it is lost.
fn begin(runs: &mut Vec<LiveRun>, errand: Errand, pace: Pace) {
    if let Some(before) = runs.last_mut() {
        before.cut(Cut::Gap);
    }
    runs.push(LiveRun::new(errand, pace));
}

/// What the robot said, for the run that goes on.
fn fold(runs: &mut Vec<LiveRun>, body: &str, mind: &mut Mind, pace: Pace) {
    match Report::parse(body) {
        Some(Report::At(at)) => {
            if is_first(&at) && runs.last().is_none_or(|run| run.end().is_some()) {
                begin(runs, Errand::Unasked, pace);
            }
            if let Some(run) = runs.last_mut() {
                run.reached(at);
            }
        }
        Some(Report::Do(chose)) => {
            if let Some(run) = runs.last_mut() {
                run.chose(chose);
            }
        }
        Some(Report::End(ended)) => {
            if let Some(run) = runs.last_mut() {
                run.ended(ended.end);
            }
        }
        Some(Report::Ready(ready)) => {
            mind.node_max = u32::from(ready.nodes);
            if let Some(run) = runs.last_mut().filter(|run| run.stops() > 0) {
                run.cut(Cut::ConnectionLost);
            }
        }
        Some(Report::Ok(_, Said::Setting(..) | Said::Nodes(_) | Said::Nothing | Said::Typed))
        | Some(
            Report::Err(..)
            | Report::Ir(_)
            | Report::Beat(_)
            | Report::TurnsHave { .. }
            | Report::TurnsData { .. }
            | Report::Node(_),
        )
        | None => {}
    }
}
