//! Plays the page's end against any robot and says of each rule of `PROTOCOL.md` whether it is kept.
//!
//! Nothing here drives the robot unless it is allowed to. What is changed on the robot (a setting, the turn
//! list) is put back, the turn list's number and origin excepted.

use alloc::format;
use alloc::string::{String, ToString};
use alloc::vec::Vec;

use super::fields::Tag;
use super::frame::{Decoder, Heard, Sum, is_end};
use super::report::Report;
use super::request::{Asked, Request};

mod drives;
mod rules;
mod uploads;
mod wrong;

pub use rules::RULES;
use wrong::wrong;

/// A wire to a robot, and time on it.
pub trait Wire {
    /// Sends bytes.
    ///
    /// # Errors
    /// Where the port has gone.
    fn send(&mut self, bytes: &[u8]) -> Result<(), Gone>;

    /// Waits so long; everything that came meanwhile.
    ///
    /// # Errors
    /// Where the port has gone.
    fn wait(&mut self, ms: u64) -> Result<Vec<u8>, Gone>;

    /// The time, from any beginning. A busy computer may wait longer than it was told.
    fn now_ms(&self) -> u64;
}

/// The port has gone: nothing can be said of the rules that were not tried yet.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Gone;

/// Whether a rule is kept.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Verdict {
    /// It is.
    Kept,
    /// It is, but something could be better: what.
    Remark(String),
    /// It is not: what was expected, and what came.
    Broken(String),
    /// It was not tried, and why.
    NotTried(&'static str),
}

/// Whether the robot may be driven.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Driving {
    /// It stays where it is.
    Forbidden,
    /// It stands at the start of a line maze, and there is room.
    Allowed,
}

/// A rule: its name, and what it says.
#[derive(Debug)]
pub struct Rule {
    /// A word for it, as in `PROTOCOL.md`.
    pub name: &'static str,
    /// What it says.
    pub says: &'static str,
    check: fn(&mut Talk<'_>) -> Result<(), Broken>,
}

/// What a rule's check ends with where the rule is not kept.
enum Broken {
    /// The rule is broken.
    Rule(String),
    /// It is kept, but this is to be said.
    Remark(String),
    /// It cannot be tried.
    NotTried(&'static str),
    /// The port has gone.
    Gone,
}

impl From<String> for Broken {
    fn from(words: String) -> Self {
        Self::Rule(words)
    }
}

impl From<Gone> for Broken {
    fn from(_: Gone) -> Self {
        Self::Gone
    }
}

/// A good line that came.
#[derive(Clone, Debug)]
struct Came {
    ms: u64,
    body: String,
}

/// What is kept of the bytes that came first, and of the lines that were sent first.
const MOST_KEPT: usize = 2_000;

/// A conversation with a robot.
struct Talk<'w> {
    wire: &'w mut dyn Wire,
    driving: Driving,
    decoder: Decoder,
    tag: u32,
    /// Good lines since the last question.
    came: Vec<Came>,
    /// Lines that no robot may say, and what is wrong with them.
    strange: Vec<String>,
    /// How many there were at the last question.
    strange_before: usize,
    line: Vec<u8>,
    /// The first bytes that came, and everything that was sent meanwhile.
    first: Vec<u8>,
    sent: Vec<u8>,
}

/// Checks every rule; tells each verdict as soon as it is known.
///
/// # Errors
/// Where the port goes meanwhile.
pub fn check(
    wire: &mut dyn Wire,
    driving: Driving,
    mut tell: impl FnMut(&Rule, &Verdict),
) -> Result<(), Gone> {
    let mut talk = Talk {
        wire,
        driving,
        decoder: Decoder::new(),
        tag: 0,
        came: Vec::new(),
        strange: Vec::new(),
        strange_before: 0,
        line: Vec::new(),
        first: Vec::new(),
        sent: Vec::new(),
    };
    let mut dead = false;
    for rule in RULES {
        let verdict = if dead {
            Verdict::NotTried("the robot does not answer")
        } else {
            match (rule.check)(&mut talk) {
                Ok(()) => Verdict::Kept,
                Err(Broken::Rule(words)) => Verdict::Broken(words),
                Err(Broken::Remark(words)) => Verdict::Remark(words),
                Err(Broken::NotTried(why)) => Verdict::NotTried(why),
                Err(Broken::Gone) => return Err(Gone),
            }
        };
        dead |= rule.name == RULES[0].name && verdict != Verdict::Kept;
        tell(rule, &verdict);
    }
    Ok(())
}

impl Talk<'_> {
    /// Takes what comes in so many milliseconds, or in more of them: how many it were.
    fn listen(&mut self, ms: u64) -> Result<u64, Gone> {
        let from_ms = self.wire.now_ms();
        loop {
            for byte in self.wire.wait(5)? {
                self.take(byte);
            }
            let passed_ms = self.wire.now_ms() - from_ms;
            if passed_ms >= ms {
                return Ok(passed_ms);
            }
        }
    }

    fn take(&mut self, byte: u8) {
        if self.first.len() < MOST_KEPT {
            self.first.push(byte);
        }
        if !is_end(byte) {
            self.line.push(byte);
        }
        match self.decoder.push(byte) {
            Heard::Nothing => {}
            Heard::Line(line) if line.sum == Sum::Right && Report::parse(line.body).is_some() => {
                let body = line.body.into();
                self.came.push(Came { ms: self.wire.now_ms(), body });
            }
            Heard::Line(_) | Heard::Bad(_) => self.strange.push(wrong(&self.line, &self.sent)),
        }
        if is_end(byte) {
            self.line.clear();
        }
    }

    /// Sends bytes as they are.
    fn say(&mut self, bytes: &[u8]) -> Result<(), Gone> {
        self.came.clear();
        self.strange_before = self.strange.len();
        if self.sent.len() < MOST_KEPT {
            self.sent.extend(bytes);
        }
        self.wire.send(bytes)
    }

    fn sealed(&mut self, request: Request<'_>) -> (Tag, Vec<u8>) {
        let tag = Tag::new(self.tag);
        self.tag += 1;
        (tag, Asked { tag: Some(tag), request }.write().seal().to_vec())
    }

    /// Asks, and waits for the answer of this number: the rest of an `ok`, or the code of an `err`.
    fn ask(&mut self, request: Request<'_>) -> Result<Result<String, String>, Broken> {
        let (tag, bytes) = self.sealed(request);
        self.say(&bytes)?;
        self.answer(&format!("#{}", tag.number()), &words(request))
    }

    /// Waits for an `ok` or `err` with this number.
    fn answer(&mut self, tag: &str, asked: &str) -> Result<Result<String, String>, Broken> {
        let asked_ms = self.wire.now_ms();
        loop {
            let now_ms = self.wire.now_ms();
            if let Some(found) = self.came.iter().find_map(|line| answer(&line.body, tag)) {
                return Ok(found);
            }
            // A long answer may take longer than 500 ms in all, but not without a line; and not for ever.
            let last_ms = self.came.last().map_or(asked_ms, |line| line.ms);
            if now_ms > last_ms + 500 || now_ms > asked_ms + 5_000 {
                break;
            }
            self.listen(10)?;
        }
        let asked = asked.trim();
        let instead = self.instead();
        Err(format!("no answer {tag} to “{asked}” within 500 ms: {instead}").into())
    }

    /// What came instead of an answer.
    fn instead(&self) -> String {
        let other = self.came.iter().find(|line| line.body.starts_with("ok") || line.body.starts_with("err"));
        match (self.strange.get(self.strange_before), other) {
            (Some(line), _) => line.clone(),
            (None, Some(line)) => format!("“{}” came, which has another number", line.body),
            (None, None) => "nothing came that is an answer".into(),
        }
    }

    /// Asks what must be answered `ok`.
    fn must(&mut self, request: Request<'_>) -> Result<String, Broken> {
        match self.ask(request)? {
            Ok(rest) => Ok(rest),
            Err(code) => Err(format!("“{}” was answered err {code}", words(request)).into()),
        }
    }

    /// Asks what must be refused with this code.
    fn must_not(&mut self, request: Request<'_>, code: &str) -> Result<(), Broken> {
        // At most one `err` in 100 ms.
        self.listen(120)?;
        let came = match self.ask(request)? {
            Err(found) if found == code => return Ok(()),
            Err(found) => format!("err {found}"),
            Ok(_) => "ok".to_string(),
        };
        Err(format!("“{}” must be answered err {code}, but {came} came", words(request)).into())
    }

    /// The lines that came and begin with this word.
    fn lines<'a>(&'a self, verb: &'a str) -> impl Iterator<Item = &'a str> {
        self.came
            .iter()
            .map(|line| line.body.as_str())
            .filter(move |line| line.split(' ').next() == Some(verb))
    }
}

/// A request as it stands in the line, without number and checksum.
fn words(request: Request<'_>) -> String {
    let line = Asked { tag: None, request }.write().seal().to_vec();
    String::from_utf8_lossy(&line).rsplit_once('*').map_or_else(String::new, |(body, _)| body.into())
}

/// Lines as a person reads them.
fn quoted(lines: &[String]) -> String {
    let quoted: Vec<String> = lines.iter().map(|line| format!("“{line}”")).collect();
    if quoted.is_empty() { "nothing".into() } else { quoted.join(", ") }
}

/// The rest of an answer with this number.
fn answer(line: &str, tag: &str) -> Option<Result<String, String>> {
    let (verb, rest) = line.split_once(' ')?;
    let (found, rest) = rest.split_once(' ').unwrap_or((rest, ""));
    match verb {
        "ok" if found == tag => Some(Ok(rest.into())),
        "err" if found == tag => Some(Err(rest.split(' ').next().unwrap_or_default().into())),
        _ => None,
    }
}
