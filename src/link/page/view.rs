//! What a panel shows: everything of the page's end that can be looked at.

use super::super::live::LiveRun;
use super::super::monitor::Monitor;
use super::super::plot::Plot;
use super::super::report::NodeLine;
use super::super::session::Recorder;
use super::super::tune::Name;
use super::{Identity, Job, Kept, Link, Note, Phase, Placed, Port, Sent, State};
use crate::settings::Pace;

/// The few values that decide what a panel looks like; cheap to take and to compare.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Snapshot {
    /// Where the page's end stands.
    pub state: State,
    /// The port, if one was chosen.
    pub port: Option<Port>,
    /// Bits a second.
    pub baud: u32,
    /// The battery, as last told.
    pub millivolts: Option<u16>,
    /// Whether the robot stands at the start.
    pub placed: Placed,
    /// How the last upload went.
    pub sent: Sent,
    /// What is waited for.
    pub asked: Option<Job>,
    /// Lines of the monitor in all.
    pub lines: u64,
    /// Of them not used.
    pub bad_lines: u64,
    /// Stops of the live run.
    pub stops: u32,
    /// Notes so far; the newest are in [`Link::notes`].
    pub last_note: Option<Note>,
}

impl Link {
    /// Where the page's end stands.
    #[must_use]
    pub fn state(&self) -> State {
        if let Some(alarm) = self.alarm.filter(|_| self.is_open()) {
            return State::Alarm(alarm);
        }
        match self.phase {
            Phase::Absent => State::Absent,
            Phase::Closed => State::Closed,
            Phase::Choosing => State::Choosing,
            Phase::Opening => State::Opening,
            Phase::Ready | Phase::Running if self.is_stopping() => State::Stopping,
            Phase::Waiting { .. } => State::Waiting,
            Phase::Ready if self.sending.is_some() => State::Sending,
            Phase::Ready => State::Ready,
            Phase::Running => State::Running,
            Phase::Lost { looks: 0, .. } => State::Lost,
            Phase::Lost { .. } => State::Reconnecting,
            Phase::Failed(trouble) => State::Failed(trouble),
        }
    }

    /// What decides how a panel looks.
    #[must_use]
    pub fn snapshot(&self) -> Snapshot {
        Snapshot {
            state: self.state(),
            port: self.port,
            baud: self.baud,
            millivolts: self.millivolts,
            placed: self.placed,
            sent: self.sent,
            asked: self.pending.map(|pending| pending.job),
            lines: self.monitor.total(),
            bad_lines: self.monitor.bad(),
            stops: self.live.as_ref().map_or(0, LiveRun::stops),
            last_note: self.notes.back().copied(),
        }
    }

    /// Whether the port is open: what is said on it is recorded.
    #[must_use]
    pub const fn is_open(&self) -> bool {
        matches!(self.phase, Phase::Waiting { .. } | Phase::Ready | Phase::Running)
    }

    /// Whether the run that is kept is of a connection that is over.
    #[must_use]
    pub const fn shows_past(&self) -> bool {
        self.live.is_some() && !self.is_open()
    }

    /// How the last upload went, seen beside the list that the page has now.
    #[must_use]
    pub fn sent_beside(&self, here: Option<&str>) -> Sent {
        self.sent.beside(&self.kept, here)
    }

    /// Who the robot is, while one is there.
    #[must_use]
    pub const fn robot(&self) -> Option<&Identity> {
        self.robot.as_ref()
    }

    /// The turn list on the robot.
    #[must_use]
    pub const fn kept(&self) -> &Kept {
        &self.kept
    }

    /// A setting, as the robot told it last.
    #[must_use]
    pub const fn setting(&self, name: Name) -> Option<i32> {
        self.tune[name as usize]
    }

    /// The robot's node table, as it was read last.
    #[must_use]
    pub fn nodes(&self) -> &[NodeLine] {
        &self.nodes
    }

    /// The run that goes on, or the last one.
    #[must_use]
    pub const fn live(&self) -> Option<&LiveRun> {
        self.live.as_ref()
    }

    /// What became of what was asked, oldest first.
    pub fn notes(&self) -> impl DoubleEndedIterator<Item = &Note> {
        self.notes.iter()
    }

    /// What went over the wire.
    #[must_use]
    pub const fn monitor(&self) -> &Monitor {
        &self.monitor
    }

    /// What the sensors saw.
    #[must_use]
    pub const fn plot(&self) -> &Plot {
        &self.plot
    }

    /// What is recorded of the session.
    #[must_use]
    pub const fn session(&self) -> &Recorder {
        &self.session
    }

    /// Whether leaving the page now would cut something off.
    #[must_use]
    pub fn is_busy(&self) -> bool {
        matches!(self.state(), State::Sending) || self.may_drive()
    }

    /// Whether the robot drives, or may: its stop has to be at hand.
    #[must_use]
    pub fn may_drive(&self) -> bool {
        matches!(self.state(), State::Running | State::Stopping | State::Alarm(_))
    }

    /// How long the page takes the robot to turn: for the clock of live runs.
    pub const fn set_pace(&mut self, pace: Pace) {
        self.pace = pace;
    }
}
