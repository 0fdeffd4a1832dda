//! Stopping for sure: a `stop` is repeated until it is confirmed, and while it is not, the robot counts as driving.
//!
//! A robot that fell silent in a run, and a line that does not leave the computer, are told to stop too. Nothing
//! else is sent meanwhile, and nothing that waited is sent afterwards: a robot that comes back must never get an
//! old `run`.

use super::super::live::Errand;
use super::super::monitor::Mark;
use super::{Action, DEADLINE_MS, Job, Kept, Link, News, Pending, Phase, SILENCE_MS};
use crate::event::Cut;
use crate::link::tune::Name;

/// A `stop` without an answer is said again after so long.
pub const STOP_EVERY_MS: u64 = 250;
/// A write that does not end in so long is lost.
pub const LOST_WRITE_MS: u64 = 1_000;
/// A `run` that could not be sent within so long is not what anybody wants any more.
pub const OLD_RUN_MS: u64 = 2_000;
/// What a tick counts at most: a page that slept has not seen how long a write took.
const MOST_TICK_MS: u64 = 250;

/// Why the robot may be driving though it should not.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Alarm {
    /// It was told to stop and has not confirmed it.
    Unconfirmed,
    /// It fell silent while it drove.
    Silent,
    /// What is sent does not leave the computer.
    Stalled,
}

impl Alarm {
    /// What happened.
    #[must_use]
    pub const fn says(self) -> &'static str {
        match self {
            Self::Unconfirmed => "The robot has not confirmed the stop. It may still be driving.",
            Self::Silent => "The robot fell silent while it drove. It may still be driving.",
            Self::Stalled => {
                "What the page sends does not leave the computer. The robot may still be driving."
            }
        }
    }

    /// What to do with one's hands, and what the page does meanwhile.
    #[must_use]
    pub const fn cure(self) -> &'static str {
        "Lift the robot off the floor and switch it off. Until it answers, it is told to stop four times a second."
    }
}

/// How far what was last written is.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub(super) enum Writing {
    /// It has left the page.
    #[default]
    Nothing,
    /// So many writes have not ended.
    Going { writes: u32, waited_ms: u64, seen_ms: u64 },
    /// They are being thrown away.
    Aborting { waited_ms: u64, seen_ms: u64 },
}

/// What is known of a robot whose connection has ended.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Left {
    /// It stands, or nothing says otherwise.
    Standing,
    /// It was driving, or had not confirmed its stop.
    Driving,
}

impl Link {
    /// `stop` overtakes everything; what only asks is asked afterwards.
    pub(super) fn stop(&mut self, now_ms: u64) {
        if !self.is_open() {
            return;
        }
        if let Some(pending) = self.pending.as_mut().filter(|pending| pending.job == Job::Stop) {
            // Once more, at once.
            pending.deadline_ms = now_ms;
            return self.stop_again(now_ms);
        }
        let waiting = self.pending.take().map(|pending| pending.job);
        let jobs: alloc::vec::Vec<Job> = waiting.into_iter().chain(self.queue.drain(..)).collect();
        for job in jobs {
            if job.only_asks() {
                self.queue.push_back(job);
            } else {
                self.note(News::Overtaken(job), now_ms);
            }
        }
        if self.sending.is_some() {
            self.cut_upload();
            self.queue.push_front(Job::ReadTurns);
        }
        self.starting = None;
        self.put(Job::Stop, now_ms);
    }

    /// Says `stop` again while it is not confirmed; what lasts longer than any answer is an alarm.
    pub(super) fn stop_again(&mut self, now_ms: u64) {
        let Some(Pending { job: Job::Stop, asked_ms, deadline_ms, .. }) = self.pending else { return };
        if now_ms >= asked_ms + DEADLINE_MS {
            self.raise(Alarm::Unconfirmed, now_ms);
        }
        if now_ms >= deadline_ms {
            self.put_again(now_ms);
        }
    }

    /// Whether a `stop` is on its way or not confirmed.
    pub(super) fn is_stopping(&self) -> bool {
        self.pending.is_some_and(|pending| pending.job == Job::Stop)
    }

    /// Nothing that waits is sent any more, and that is told.
    fn raise(&mut self, alarm: Alarm, now_ms: u64) {
        if self.alarm.is_some() {
            return;
        }
        self.alarm = Some(alarm);
        self.throw_away(now_ms);
    }

    fn throw_away(&mut self, now_ms: u64) {
        for job in core::mem::take(&mut self.queue) {
            if job.is_told() {
                self.note(News::ThrownAway(job), now_ms);
            }
        }
    }

    /// A robot that drives and says nothing, not even when it is asked.
    pub(super) fn is_silent_in_run(&self, pending: &Pending, now_ms: u64) -> bool {
        self.phase == Phase::Running
            && pending.job != Job::Stop
            && pending.tries > 0
            && now_ms >= pending.deadline_ms
            && now_ms >= self.heard_ms + SILENCE_MS
    }

    /// It is told to stop, as if somebody had pressed the button.
    pub(super) fn silent_in_run(&mut self, now_ms: u64) {
        self.stop(now_ms);
        self.raise(Alarm::Silent, now_ms);
    }

    /// The robot stands: `stop` was answered, or its end was told. What was thrown away is asked anew.
    pub(super) fn stopped(&mut self, now_ms: u64) {
        self.left = Left::Standing;
        if self.phase == Phase::Running {
            self.phase = Phase::Ready;
            if let Some(live) = &mut self.live {
                live.cut(Cut::Stopped);
            }
        }
        let alarmed = self.alarm.take().is_some();
        if matches!(self.phase, Phase::Waiting { .. }) {
            // It answers: who is it?
            self.greet(now_ms);
            self.say_hi(now_ms);
        } else if alarmed && self.queue.is_empty() {
            self.ask_unknown();
        }
    }

    /// Asks for everything that is not known of the robot.
    pub(super) fn ask_unknown(&mut self) {
        self.queue.push_back(Job::Watch(self.level));
        if self.kept == Kept::Unknown {
            self.queue.push_back(Job::ReadTurns);
        }
        let unknown = |name: &Name| self.tune[*name as usize].is_none();
        let names: alloc::vec::Vec<Name> = Name::ALL.into_iter().filter(unknown).collect();
        self.queue.extend(names.into_iter().map(Job::Get));
    }

    /// The connection ends: whether the robot may drive on, so that it is told to stop when it is there again.
    pub(super) fn leave(&mut self) -> Left {
        let starts = self.pending.is_some_and(|pending| matches!(pending.job, Job::Run(_) | Job::Stop));
        if self.phase == Phase::Running || self.alarm.take().is_some() || starts {
            self.left = Left::Driving;
        }
        self.writing = Writing::Nothing;
        self.left
    }

    /// The port takes a line now, or a line before is still on its way.
    pub(super) const fn can_write(&self) -> bool {
        matches!(self.writing, Writing::Nothing)
    }

    /// A write was handed out.
    pub(super) fn writes_begin(&mut self, now_ms: u64) {
        let new = self.actions.iter().filter(|action| matches!(action, Action::Write(_))).count() as u32;
        if new == 0 || !self.is_open() {
            return;
        }
        self.writing = match self.writing {
            Writing::Nothing => Writing::Going { writes: new, waited_ms: 0, seen_ms: now_ms },
            Writing::Going { writes, waited_ms, seen_ms } => {
                Writing::Going { writes: writes + new, waited_ms, seen_ms }
            }
            aborting @ Writing::Aborting { .. } => aborting,
        };
    }

    /// A write has ended.
    pub(super) const fn written(&mut self, now_ms: u64) {
        if let Writing::Going { writes, .. } = self.writing {
            self.writing = match writes {
                0 | 1 => Writing::Nothing,
                _ => Writing::Going { writes: writes - 1, waited_ms: 0, seen_ms: now_ms },
            };
        }
    }

    /// What the system held is thrown away: the port takes lines again.
    pub(super) const fn aborted(&mut self) {
        if let Writing::Aborting { .. } = self.writing {
            self.writing = Writing::Nothing;
        }
    }

    /// Watches the write that has not ended; what cannot even be thrown away means that the port is gone.
    pub(super) fn watch_writing(&mut self, now_ms: u64) -> Wedged {
        let more =
            |waited_ms: u64, seen_ms: u64| waited_ms + now_ms.saturating_sub(seen_ms).min(MOST_TICK_MS);
        match self.writing {
            Writing::Nothing => {}
            Writing::Going { writes, waited_ms, seen_ms } => {
                let waited_ms = more(waited_ms, seen_ms);
                self.writing = Writing::Going { writes, waited_ms, seen_ms: now_ms };
                if waited_ms >= LOST_WRITE_MS {
                    self.lose_write(now_ms);
                }
            }
            Writing::Aborting { waited_ms, seen_ms } => {
                let waited_ms = more(waited_ms, seen_ms);
                self.writing = Writing::Aborting { waited_ms, seen_ms: now_ms };
                if waited_ms >= LOST_WRITE_MS {
                    return Wedged::Yes;
                }
            }
        }
        Wedged::No
    }

    /// The line and all that waited behind it are thrown away; the next that is sent is `stop`.
    fn lose_write(&mut self, now_ms: u64) {
        self.actions.push(Action::Abort);
        self.writing = Writing::Aborting { waited_ms: 0, seen_ms: now_ms };
        self.monitor.mark_last_sent(Mark::Lost);
        self.note(News::LostWrite, now_ms);
        let pending = self.pending.take();
        if let Some(Pending { job, .. }) = pending
            && job.is_told()
            && job != Job::Stop
        {
            self.note(News::ThrownAway(job), now_ms);
        }
        self.throw_away(now_ms);
        self.cut_upload();
        self.starting = None;
        // Until it is known who is there, nobody is told anything but `hi`; unless somebody has said `stop`.
        let waits = matches!(self.phase, Phase::Waiting { .. });
        if !waits || pending.is_some_and(|pending| pending.job == Job::Stop) {
            self.put(Job::Stop, now_ms);
            self.raise(Alarm::Stalled, now_ms);
        }
    }

    /// What the run that goes on is called.
    pub(super) fn run_job(&self) -> Job {
        Job::Run(self.live.as_ref().map_or(Errand::Unasked, super::LiveRun::errand))
    }
}

/// Whether a port neither sends what it was given nor lets go of it.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Wedged {
    No,
    Yes,
}
