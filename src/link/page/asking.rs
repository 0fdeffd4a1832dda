//! One request at a time: sent, waited for, sent again, given up; and `stop`, which waits for none.

use super::super::live::{Errand, LiveRun};
use super::super::request::Request;
use super::job::sealed;
use super::{
    DEADLINE_MS, Job, Kept, Link, MOST_JOBS, News, OLD_RUN_MS, Pending, Phase, SECOND_MS, SILENCE_MS,
    STOP_EVERY_MS, Sending, Sent, TRIES,
};
use super::{Trouble, hearing::Coming};
use crate::route::TurnList;

impl Link {
    /// Asks, when those who came before are answered.
    pub(super) fn ask(&mut self, job: Job, now_ms: u64) {
        let at_work = matches!(self.phase, Phase::Ready | Phase::Running);
        // Nothing waits behind a stop that is not confirmed, but what only asks.
        let barred = self.alarm.is_some() || self.is_stopping() && !job.only_asks();
        if !at_work || barred || self.queue.len() >= MOST_JOBS {
            self.note(News::NotNow(job), now_ms);
        } else {
            self.queue.push_back(job);
        }
    }

    pub(super) fn run(&mut self, errand: Errand, now_ms: u64) {
        if self.phase == Phase::Ready && self.sending.is_none() {
            self.run_ms = now_ms;
            self.ask(Job::Run(errand), now_ms);
        } else {
            self.note(News::NotNow(Job::Run(errand)), now_ms);
        }
    }

    pub(super) fn send(&mut self, list: &TurnList, now_ms: u64) {
        // A number that the robot's list does not have, so that they can be told apart whatever happens.
        let taken = match &self.kept {
            Kept::List(list) => list.upload.id,
            Kept::Nothing | Kept::Unknown => 0,
        };
        let id = (taken.wrapping_add(now_ms as u16 % 9_000) % 9_999).wrapping_add(1);
        let id = if id == taken { id % 9_999 + 1 } else { id };
        match Sending::new(list, id) {
            Some(sending) if self.phase == Phase::Ready && self.sending.is_none() => {
                self.sent = sending.progress();
                self.sending = Some(sending);
                self.unsure = None;
                self.ask(Job::Send, now_ms);
            }
            Some(_) | None => self.note(News::NotNow(Job::Send), now_ms),
        }
    }

    /// Sends the next request, unless one is waited for.
    pub(super) fn ask_next(&mut self, now_ms: u64) {
        while self.pending.is_none()
            && let Some(job) = self.queue.pop_front()
        {
            if matches!(job, Job::Run(_)) && now_ms >= self.run_ms + OLD_RUN_MS {
                self.note(News::TooLate(job), now_ms);
            } else {
                self.put(job, now_ms);
            }
        }
    }

    pub(super) fn put(&mut self, job: Job, now_ms: u64) {
        let tag = self.tag();
        if let Job::Run(mut errand) = job {
            // The page's explorer is to be no cleverer than the robot can be.
            if let (Errand::Explore(mind), Some(robot)) = (&mut errand, &self.robot) {
                mind.node_max = mind.node_max.min(u32::from(robot.nodes));
            }
            self.starting = Some(LiveRun::new(errand, self.pace));
        }
        self.pending = Some(Pending { job, tag, tries: 0, asked_ms: now_ms, deadline_ms: now_ms });
        self.put_again(now_ms);
    }

    /// Sends it, unless a line before it is still on its way: then it is sent behind that.
    pub(super) fn put_again(&mut self, now_ms: u64) {
        let Some(Pending { job, tag, tries, asked_ms, .. }) = self.pending else { return };
        if !self.can_write() {
            return;
        }
        let bytes = match (job.request(), &mut self.sending) {
            (Some(request), _) => sealed(request, tag),
            (None, Some(sending)) => sealed(sending.request(), tag),
            // An upload that is no more.
            (None, None) => return self.pending = None,
        };
        if matches!(job, Job::ReadTurns | Job::ReadNodes) {
            self.coming = Coming::default();
        }
        let wait_ms = if job == Job::Stop { STOP_EVERY_MS } else { DEADLINE_MS };
        let (tries, deadline_ms) = (tries.saturating_add(1), now_ms + wait_ms);
        self.pending = Some(Pending { job, tag, tries, asked_ms, deadline_ms });
        if job == Job::Stop {
            // Half a line that was left behind cannot swallow it.
            self.write(alloc::vec![b'\n'], now_ms);
        }
        self.write(bytes, now_ms);
    }

    /// Whatever is waited for may be overdue, and so may any sign of life.
    pub(super) fn wait_for_answer(&mut self, now_ms: u64) {
        match self.pending {
            Some(Pending { job: Job::Stop, .. }) => self.stop_again(now_ms),
            Some(pending) if now_ms < pending.deadline_ms => {}
            // A request that has not left yet is not overdue.
            Some(pending) if pending.tries == 0 => {}
            Some(pending) if self.is_silent_in_run(&pending, now_ms) => self.silent_in_run(now_ms),
            // A page that slept must not wake a robot with what was wanted then.
            Some(Pending { job: job @ Job::Run(_), asked_ms, .. }) if now_ms >= asked_ms + OLD_RUN_MS => {
                self.give_up(job, now_ms);
            }
            Some(pending) if pending.tries < TRIES => self.put_again(now_ms),
            Some(pending) => self.give_up(pending.job, now_ms),
            None if now_ms >= self.heard_ms + SILENCE_MS => self.queue.push_front(Job::Hi),
            // The robot is there, and which list it holds is still to be told.
            None if self.owes_a_reading(now_ms) => self.queue.push_back(Job::ReadTurns),
            None => {}
        }
    }

    /// An upload was cut off, and the reading that was to settle it too: that is done again, now and then.
    fn owes_a_reading(&self, now_ms: u64) -> bool {
        self.unsure.is_some()
            && self.kept == Kept::Unknown
            && self.reading_failed_ms.is_some_and(|ms| now_ms >= ms + SECOND_MS)
    }

    pub(super) fn give_up(&mut self, job: Job, now_ms: u64) {
        self.pending = None;
        self.rereads = 0;
        match job {
            Job::Hi => return self.fail(Trouble::Silent, now_ms),
            Job::Send => {
                self.cut_upload();
                self.queue.push_front(Job::ReadTurns);
            }
            // It may have heard it all the same, and be driving.
            Job::Run(_) => {
                self.note(News::NoAnswer(job), now_ms);
                return self.stop(now_ms);
            }
            // Which list it holds stays open until it is read at last.
            Job::ReadTurns => {
                self.kept = Kept::Unknown;
                self.reading_failed_ms = Some(now_ms);
                self.cut_upload();
                self.forget_upload();
            }
            Job::Watch(_) | Job::ReadNodes | Job::Get(_) | Job::Set(..) | Job::Stop | Job::Place => {}
        }
        // What else waits would not be answered either: first of all, is anybody there?
        if now_ms >= self.heard_ms + SILENCE_MS {
            self.queue.push_front(Job::Hi);
        }
        self.note(News::NoAnswer(job), now_ms);
    }

    /// Starts the next step of the upload in the place of the one that was answered.
    pub(super) fn send_on(&mut self, now_ms: u64) {
        if let Some(sending) = &self.sending {
            self.sent = sending.progress();
        }
        self.put(Job::Send, now_ms);
    }

    /// The robot's list was read: that settles which one it holds.
    pub(super) fn settle(&mut self, before: &Kept) {
        if let Some(sending) = self.sending.take() {
            self.sent = sending.compare(&self.kept);
        } else if let Some(unsure) = self.unsure.take() {
            if self.sent == Sent::Unsure {
                self.sent = unsure.compare(&self.kept);
            }
        } else if !self.kept.is_still(before) {
            // What was said of the list before is not true of this one.
            self.sent = Sent::Nothing;
        }
    }

    /// The request that only asks whether anybody is there.
    pub(super) fn asks_hi(&self) -> bool {
        self.pending.is_some_and(|pending| pending.job.request() == Some(Request::Hi))
    }
}
