//! The page's end: driven by commands, bytes, what happens to the port, and milliseconds; it answers with
//! what to do to the port. Whoever moves the bytes needs to know nothing else.

use alloc::collections::VecDeque;
use alloc::vec::Vec;

use super::fields::Tag;
use super::frame::{Decoder, crc8};
use super::live::{Errand, LiveRun};
use super::monitor::Monitor;
use super::plot::Plot;
use super::report::NodeLine;
use super::request::Level;
use super::session::Recorder;
use super::tune::Name;
use crate::settings::Pace;

mod alarm;
mod asking;
mod connection;
mod hearing;
mod job;
mod state;
mod upload;
mod view;
mod words;

pub use alarm::{Alarm, LOST_WRITE_MS, OLD_RUN_MS, STOP_EVERY_MS};
use alarm::{Left, Wedged, Writing};
use hearing::Coming;
use job::Pending;
pub use job::{DEADLINE_MS, Job, News, Note, TRIES};
pub use state::{Heard, OpenError, State, Trouble};
use upload::Sending;
pub use upload::{Kept, KeptList, Sent};
pub use view::Snapshot;
pub use words::{Action, Command, Identity, Port, PortEvent};

/// The rates that are offered, in the order in which they are tried: an Uno's, then a Bluetooth module's.
pub const RATES: [u32; 6] = [115_200, 9_600, 57_600, 38_400, 19_200, 230_400];
/// A reset robot is given so long to say `ready`.
pub const BOOT_WAIT_MS: u64 = 3_000;
/// Then `hi` is said so often, a second apart.
pub const HIS: u8 = 3;
/// Without a good line for so long, the robot is asked whether it is there.
pub const SILENCE_MS: u64 = 2_500;
/// A lost port is looked for every second, so often.
pub const LOOKS: u8 = 30;
const SECOND_MS: u64 = 1_000;
/// Requests that may wait.
const MOST_JOBS: usize = 64;
/// Notes that are kept.
const MOST_NOTES: usize = 32;

/// Where the page's end stands, with what it needs to go on.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Phase {
    Absent,
    Closed,
    Choosing,
    Opening,
    /// The last `hi` was said then, after so many others.
    Waiting {
        hi_ms: u64,
        his: u8,
        heard: Heard,
    },
    Ready,
    Running,
    Lost {
        since_ms: u64,
        looks: u8,
        opening: Attempt,
    },
    Failed(Trouble),
}

/// While a lost port is looked for.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Attempt {
    None,
    Opening,
}

/// The page's end of the link.
///
/// ```
/// use line_maze_lab::link::page::{Action, Command, Link, Port, PortEvent, State};
/// let mut link = Link::new(0, 0);
/// assert_eq!(link.command(Command::Use(Port::Serial(None)), 0), [Action::Open { baud: 115_200 }]);
/// let said = link.port_event(PortEvent::Opened, 5);
/// assert_eq!(said, [Action::Write(b"\nhi #0*04\n".to_vec())]);
/// link.bytes_in(b"ready 1 lab-1 uno 50 400*E0\n", 9);
/// assert_eq!(link.state(), State::Ready);
/// ```
#[derive(Debug)]
pub struct Link {
    phase: Phase,
    port: Option<Port>,
    baud: u32,
    decoder: Decoder,
    monitor: Monitor,
    plot: Plot,
    session: Recorder,
    actions: Vec<Action>,
    queue: VecDeque<Job>,
    pending: Option<Pending>,
    next_tag: u32,
    level: Level,
    robot: Option<Identity>,
    tune: [Option<i32>; Name::COUNT],
    nodes: Vec<NodeLine>,
    coming: Coming,
    kept: Kept,
    sending: Option<Sending>,
    /// An upload that was cut off, until the robot's list is read.
    unsure: Option<Sending>,
    /// When reading the robot's list was given up last.
    reading_failed_ms: Option<u64>,
    sent: Sent,
    live: Option<LiveRun>,
    starting: Option<LiveRun>,
    pace: Pace,
    placed: Placed,
    lost_before: LostBefore,
    notes: VecDeque<Note>,
    heard_ms: u64,
    restarted_ms: Option<u64>,
    /// When `hi` was said last, or a line typed that may be one.
    hi_ms: Option<u64>,
    /// How often a long answer was asked for anew, as lines of it were lost.
    rereads: u8,
    robot_ms: Option<u32>,
    millivolts: Option<u16>,
    alarm: Option<Alarm>,
    left: Left,
    writing: Writing,
    /// When a run was asked for last.
    run_ms: u64,
}

/// Whether the robot stands at the start, as far as the page was told.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Placed {
    /// It has driven, or was switched on somewhere: it has to be put back, and told so.
    Somewhere,
    /// At the start.
    AtStart,
}

/// Whether the connection was lost before.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum LostBefore {
    No,
    Yes,
}

impl Link {
    /// Closed, at a moment of the page's clock that is `wall_ms` after midnight.
    #[must_use]
    pub fn new(now_ms: u64, wall_ms: u64) -> Self {
        Self {
            phase: Phase::Closed,
            port: None,
            baud: RATES[0],
            decoder: Decoder::new(),
            monitor: Monitor::new(now_ms, wall_ms),
            plot: Plot::default(),
            session: Recorder::new(now_ms),
            actions: Vec::new(),
            queue: VecDeque::new(),
            pending: None,
            next_tag: 0,
            level: Level::All,
            robot: None,
            tune: [None; Name::COUNT],
            nodes: Vec::new(),
            coming: Coming::default(),
            kept: Kept::Unknown,
            sending: None,
            unsure: None,
            reading_failed_ms: None,
            sent: Sent::Nothing,
            live: None,
            starting: None,
            pace: Pace::default(),
            placed: Placed::Somewhere,
            lost_before: LostBefore::No,
            notes: VecDeque::new(),
            heard_ms: now_ms,
            restarted_ms: None,
            hi_ms: None,
            rereads: 0,
            robot_ms: None,
            millivolts: None,
            alarm: None,
            left: Left::Standing,
            writing: Writing::Nothing,
            run_ms: now_ms,
        }
    }

    /// Does what a person asks for. What makes no sense now is told in a [`Note`].
    pub fn command(&mut self, command: Command, now_ms: u64) -> Vec<Action> {
        match command {
            Command::Choose if self.is_at_rest() => {
                self.phase = Phase::Choosing;
                self.actions.push(Action::Choose);
            }
            Command::Use(port) if self.is_at_rest() || self.phase == Phase::Absent && port == Port::Demo => {
                self.open(port);
            }
            Command::Choose | Command::Use(_) => {}
            Command::Disconnect => self.disconnect(now_ms),
            Command::Baud(baud) => self.change_rate(baud.max(1), now_ms),
            Command::NextRate => {
                let at = RATES.iter().position(|&rate| rate == self.baud).map_or(0, |at| at + 1);
                self.change_rate(RATES[at % RATES.len()], now_ms);
            }
            Command::Send(list) => self.send(&list, now_ms),
            Command::ReadBack => self.ask(Job::ReadTurns, now_ms),
            Command::Explore(mind) => self.run(Errand::Explore(mind), now_ms),
            Command::RunRoute => self.run(Errand::Route, now_ms),
            Command::Stop => self.stop(now_ms),
            Command::Place => self.ask(Job::Place, now_ms),
            Command::ReadNodes => self.ask(Job::ReadNodes, now_ms),
            Command::ReadSettings => Name::ALL.into_iter().for_each(|name| self.ask(Job::Get(name), now_ms)),
            Command::Set(name, value) => self.ask(Job::Set(name, value), now_ms),
            Command::Watch(level) => {
                self.level = level;
                if self.state().is_connected() {
                    self.ask(Job::Watch(level), now_ms);
                }
            }
            Command::Line(line) => self.type_line(&line, now_ms),
        }
        self.go_on(now_ms)
    }

    /// Takes what happened to the port.
    pub fn port_event(&mut self, event: PortEvent, now_ms: u64) -> Vec<Action> {
        match (event, self.phase) {
            (PortEvent::NoSerial, Phase::Closed | Phase::Choosing) => self.phase = Phase::Absent,
            (PortEvent::Chosen(port), Phase::Choosing) => self.open(port),
            (PortEvent::Cancelled, Phase::Choosing) => {
                self.phase = Phase::Closed;
                self.note(News::NothingChosen, now_ms);
            }
            (PortEvent::Opened, Phase::Opening | Phase::Lost { opening: Attempt::Opening, .. }) => {
                self.opened(now_ms);
            }
            // Somebody has disconnected meanwhile.
            (PortEvent::Opened, Phase::Closed | Phase::Failed(_)) => self.actions.push(Action::Close),
            (PortEvent::OpenFailed(error), Phase::Opening) => {
                self.phase = Phase::Failed(Trouble::Open(error));
            }
            (PortEvent::OpenFailed(_), Phase::Lost { since_ms, looks, .. }) => {
                self.phase = Phase::Lost { since_ms, looks, opening: Attempt::None };
            }
            (PortEvent::Appeared, Phase::Lost { since_ms, looks, opening: Attempt::None }) => {
                self.phase = Phase::Lost { since_ms, looks, opening: Attempt::Opening };
                self.actions.push(Action::Open { baud: self.baud });
            }
            (PortEvent::Gone, Phase::Waiting { .. } | Phase::Ready | Phase::Running | Phase::Opening) => {
                self.lose_port(now_ms);
            }
            (PortEvent::Written, _) => self.written(now_ms),
            (PortEvent::Aborted, _) => self.aborted(),
            (PortEvent::Gone, Phase::Lost { since_ms, looks, .. }) => {
                self.phase = Phase::Lost { since_ms, looks, opening: Attempt::None };
            }
            (
                PortEvent::NoSerial
                | PortEvent::Chosen(_)
                | PortEvent::Cancelled
                | PortEvent::Opened
                | PortEvent::OpenFailed(_)
                | PortEvent::Gone
                | PortEvent::Appeared,
                Phase::Absent
                | Phase::Closed
                | Phase::Choosing
                | Phase::Opening
                | Phase::Waiting { .. }
                | Phase::Ready
                | Phase::Running
                | Phase::Lost { .. }
                | Phase::Failed(_),
            ) => {}
        }
        self.go_on(now_ms)
    }

    /// Lets time pass. To be called a few times a second, more often while something is sent.
    pub fn tick(&mut self, now_ms: u64) -> Vec<Action> {
        if self.watch_writing(now_ms) == Wedged::Yes {
            self.actions.push(Action::Close);
            self.lose_port(now_ms);
        }
        match self.phase {
            Phase::Waiting { .. } if self.is_stopping() => self.stop_again(now_ms),
            Phase::Waiting { hi_ms, his, heard } => self.wait_on(hi_ms, his, heard, now_ms),
            Phase::Lost { since_ms, looks, opening } => {
                let due_ms = since_ms + SECOND_MS * (u64::from(looks) + 1);
                if now_ms >= due_ms && looks >= LOOKS {
                    self.phase = Phase::Failed(Trouble::Gone);
                } else if now_ms >= due_ms {
                    self.phase = Phase::Lost { since_ms, looks: looks + 1, opening };
                    if opening == Attempt::None {
                        self.actions.push(Action::Look);
                    }
                }
            }
            Phase::Ready | Phase::Running => self.wait_for_answer(now_ms),
            Phase::Absent | Phase::Closed | Phase::Choosing | Phase::Opening | Phase::Failed(_) => {}
        }
        self.go_on(now_ms)
    }

    /// Sends the next request, if it is time, and gives what is to be done.
    fn go_on(&mut self, now_ms: u64) -> Vec<Action> {
        // What waited for a write before it.
        if self.is_open() && self.can_write() && self.pending.is_some_and(|pending| pending.tries == 0) {
            self.put_again(now_ms);
        }
        if matches!(self.phase, Phase::Ready | Phase::Running) {
            self.ask_next(now_ms);
        }
        self.writes_begin(now_ms);
        core::mem::take(&mut self.actions)
    }

    fn lose_port(&mut self, now_ms: u64) {
        self.hang_up(now_ms);
        self.phase = Phase::Lost { since_ms: now_ms, looks: 0, opening: Attempt::None };
        self.lost_before = LostBefore::Yes;
    }

    /// A line from the monitor, with a checksum if it has none.
    fn type_line(&mut self, line: &str, now_ms: u64) {
        if !matches!(self.phase, Phase::Waiting { .. } | Phase::Ready | Phase::Running) {
            return;
        }
        if !self.can_write() {
            return self.note(News::LineNotNow, now_ms);
        }
        // Several lines may be pasted at once.
        for line in line.split(['\n', '\r']).map(str::trim).filter(|line| !line.is_empty()) {
            let mut bytes = line.as_bytes().to_vec();
            if !line.contains('*') {
                bytes.extend(alloc::format!("*{:02X}", crc8(line.as_bytes())).into_bytes());
            }
            bytes.push(b'\n');
            self.write(bytes, now_ms);
        }
        self.hi_ms = Some(now_ms);
    }

    fn write(&mut self, bytes: Vec<u8>, now_ms: u64) {
        self.monitor.sent(&bytes, now_ms);
        self.session.sent(&bytes, now_ms);
        // What is said in one breath is one write.
        match self.actions.last_mut() {
            Some(Action::Write(before)) => before.extend(bytes),
            Some(_) | None => self.actions.push(Action::Write(bytes)),
        }
    }

    fn note(&mut self, news: News, now_ms: u64) {
        if self.notes.len() == MOST_NOTES {
            self.notes.pop_front();
        }
        self.notes.push_back(Note { ms: now_ms, news });
    }

    fn tag(&mut self) -> Tag {
        let tag = Tag::new(self.next_tag);
        self.next_tag = (self.next_tag + 1) % 100;
        tag
    }
}
