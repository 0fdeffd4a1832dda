//! The connection's life: opened, `hi` said until somebody answers, given up, hung up.

use super::hearing::Coming;
use super::job::sealed;
use super::{Action, BOOT_WAIT_MS, HIS, Heard, Job, Kept, Link, LostBefore, News, Phase, Placed, Port};
use super::{Left, SECOND_MS, Sent, Trouble, Writing};
use crate::event::Cut;
use crate::link::frame::Decoder;
use crate::link::monitor::Mark;
use crate::link::request::Request;
use crate::link::tune::Name;

impl Link {
    pub(super) const fn is_at_rest(&self) -> bool {
        matches!(self.phase, Phase::Closed | Phase::Failed(_) | Phase::Choosing)
    }

    pub(super) fn open(&mut self, port: Port) {
        // What was told of the connection before is over.
        self.notes.clear();
        if self.port != Some(port) {
            self.left = Left::Standing;
        }
        self.port = Some(port);
        self.phase = Phase::Opening;
        self.lost_before = LostBefore::No;
        self.actions.push(Action::Open { baud: self.baud });
    }

    pub(super) fn opened(&mut self, now_ms: u64) {
        self.decoder = Decoder::new();
        self.robot_ms = None;
        self.writing = Writing::Nothing;
        self.greet(now_ms);
        if self.left == Left::Driving {
            // One behind a radio module was not reset by opening, and may drive on.
            self.put(Job::Stop, now_ms);
        }
        self.say_hi(now_ms);
    }

    /// Waits for a `ready` from now on; the first `hi` comes as soon as it can.
    pub(super) const fn greet(&mut self, now_ms: u64) {
        self.phase = Phase::Waiting { hi_ms: now_ms, his: 0, heard: Heard::Nothing };
    }

    /// An LF first: half a line of somebody else cannot swallow the `hi`.
    pub(super) fn say_hi(&mut self, now_ms: u64) {
        let mut bytes = alloc::vec![b'\n'];
        let tag = self.tag();
        bytes.extend(sealed(Request::Hi, tag));
        self.hi_ms = Some(now_ms);
        self.write(bytes, now_ms);
    }

    /// Each `hi` has its whole second, also where the page was not woken for a while.
    pub(super) fn wait_on(&mut self, hi_ms: u64, his: u8, heard: Heard, now_ms: u64) {
        if now_ms < hi_ms + if his == 0 { BOOT_WAIT_MS } else { SECOND_MS } || !self.can_write() {
            return;
        }
        if his < HIS {
            self.phase = Phase::Waiting { hi_ms: now_ms, his: his + 1, heard };
            self.say_hi(now_ms);
        } else {
            self.fail(Trouble::NoAnswer { baud: self.baud, heard }, now_ms);
        }
    }

    pub(super) fn fail(&mut self, trouble: Trouble, now_ms: u64) {
        self.hang_up(now_ms);
        self.actions.push(Action::Close);
        self.phase = Phase::Failed(trouble);
    }

    pub(super) fn disconnect(&mut self, now_ms: u64) {
        let open = self.is_open();
        if let Some(live) = &mut self.live {
            live.disconnected();
        }
        self.hang_up(now_ms);
        if open {
            self.actions.push(Action::Close);
        }
        if self.phase != Phase::Absent {
            self.phase = Phase::Closed;
        }
    }

    /// The connection ends: nothing waits any more, the run is kept as far as it was told, and what was told of
    /// this connection is over.
    pub(super) fn hang_up(&mut self, now_ms: u64) {
        self.queue.clear();
        self.notes.clear();
        let left = self.leave();
        if let Some(pending) = self.pending.take().filter(|pending| pending.job.is_told()) {
            self.note(News::Unanswered(pending.job), now_ms);
        }
        if left == Left::Driving {
            self.note(News::MayDrive, now_ms);
        }
        self.cut_upload();
        self.forget_upload();
        self.cut_run();
        self.monitor.end_line(Mark::Plain);
        self.coming = Coming::default();
        self.kept = Kept::Unknown;
        self.tune = [None; Name::COUNT];
        self.plot.end();
        self.robot = None;
        self.placed = Placed::Somewhere;
        self.millivolts = None;
    }

    pub(super) fn cut_run(&mut self) {
        self.starting = None;
        if let Some(live) = &mut self.live {
            live.cut(Cut::ConnectionLost);
        }
        if self.phase == Phase::Running {
            self.phase = Phase::Ready;
        }
    }

    pub(super) fn cut_upload(&mut self) {
        if let Some(sending) = self.sending.take() {
            self.sent = sending.cut();
            self.unsure = Some(sending);
        }
    }

    /// How the last upload went says nothing of a list that is not known; but one that was cut off is still to
    /// be settled.
    pub(super) fn forget_upload(&mut self) {
        if self.unsure.is_none() {
            self.sent = Sent::Nothing;
        }
    }

    pub(super) fn change_rate(&mut self, baud: u32, now_ms: u64) {
        let from = core::mem::replace(&mut self.baud, baud);
        if let (Phase::Failed(Trouble::NoAnswer { .. }), Some(port)) = (self.phase, self.port) {
            self.open(port);
            self.note(News::NextRate { from, to: baud }, now_ms);
        }
    }
}
