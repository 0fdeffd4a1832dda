//! What the robot says, and what that changes.

use alloc::string::String;
use alloc::vec::Vec;

use super::super::PROTOCOL;
use super::super::fields::Tag;
use super::super::frame::{self, Decoder, LineError, Sum};
use super::super::live::{Errand, Fold, LiveRun, is_first};
use super::super::monitor::Mark;
use super::super::report::{Code, End, Ended, NodeLine, Origin, Reached, Ready, Report, Said};
use super::super::request::Upload;
use super::super::tune::Name;
use super::upload::Next;
use super::{Action, DEADLINE_MS, Heard, Identity, Job, Kept, KeptList, Link, LostBefore, News};
use super::{Left, Pending, Phase, Placed, TRIES, Trouble};

/// Two `ready` lines nearer than this are one restart.
const RESTART_MS: u64 = 500;
/// A `hi` explains a `ready` for so long.
const HI_MS: u64 = 1_000;
/// More rows of a node table than any robot has.
const MOST_NODES: usize = 4_096;

/// An answer of many lines, as far as it has come.
#[derive(Debug, Default)]
pub(super) struct Coming {
    list: Option<(Upload, Origin, String)>,
    nodes: Vec<NodeLine>,
}

/// A reading that is over.
enum Read {
    Whole,
    Broken,
}

impl Link {
    /// Takes bytes from the port.
    pub fn bytes_in(&mut self, bytes: &[u8], now_ms: u64) -> Vec<Action> {
        for &byte in bytes {
            // After a `Close` what still comes in is nobody's.
            if !matches!(self.phase, Phase::Waiting { .. } | Phase::Ready | Phase::Running) {
                break;
            }
            self.byte_in(byte, now_ms);
        }
        self.go_on(now_ms)
    }

    fn byte_in(&mut self, byte: u8, now_ms: u64) {
        if let Phase::Waiting { heard, .. } = &mut self.phase {
            *heard = Heard::Rubbish;
        }
        self.monitor.byte_in(byte, now_ms);
        let mut decoder: Decoder = core::mem::take(&mut self.decoder);
        let mark = match decoder.push(byte) {
            frame::Heard::Nothing => None,
            frame::Heard::Bad(error) => Some(Mark::Bad(error)),
            frame::Heard::Line(line) => match (line.sum, Report::parse(line.body)) {
                (Sum::Right, Some(report)) => {
                    self.session.heard(line.body, now_ms);
                    Some(self.take(report, now_ms))
                }
                (Sum::Right | Sum::Missing, _) => Some(Mark::Strange),
            },
        };
        self.decoder = decoder;
        match mark {
            // Said in the middle of the line; the monitor has not ended it yet.
            Some(mark @ Mark::Bad(LineError::TooLong)) => self.monitor.end_line(mark),
            Some(mark) => self.monitor.mark_last(mark),
            None => {}
        }
    }

    /// A good line.
    fn take(&mut self, report: Report<'_>, now_ms: u64) -> Mark {
        self.heard_ms = now_ms;
        if let Phase::Waiting { .. } = self.phase {
            // Until it is known who is there, nothing else counts.
            match report {
                Report::Ready(ready) => self.meet(&ready, now_ms),
                Report::Ok(tag, said) if self.is_stopping() => self.answered(tag, Ok(said), now_ms),
                _ => {}
            }
            return Mark::Plain;
        }
        self.watch_clock(&report, now_ms);
        match report {
            Report::Ready(_) => self.met_again(now_ms),
            Report::Ok(tag, said) => self.answered(tag, Ok(said), now_ms),
            Report::Err(tag, code) => self.answered(tag, Err(code), now_ms),
            Report::At(at) => self.reached(at, now_ms),
            Report::Do(chose) => {
                if let Some(live) = &mut self.live
                    && live.chose(chose) == Fold::Differs
                {
                    return Mark::Differs;
                }
            }
            Report::End(Ended { end, .. }) => self.ended(end, now_ms),
            Report::Ir(ir) => self.plot.push(ir, now_ms),
            Report::Beat(beat) => self.millivolts = Some(beat.millivolts),
            Report::TurnsHave { id, len, crc, origin } => {
                self.coming.list = Some((Upload { id, len, crc }, origin, String::new()));
                self.wait_longer(now_ms);
            }
            Report::TurnsData { id, offset, letters } => {
                if let Some((upload, _, text)) = &mut self.coming.list
                    && upload.id == id
                    && text.len() == usize::from(offset)
                {
                    text.push_str(letters.as_str());
                }
                self.wait_longer(now_ms);
            }
            Report::Node(node) => {
                if self.coming.nodes.len() < MOST_NODES {
                    self.coming.nodes.push(node);
                }
                self.wait_longer(now_ms);
            }
        }
        Mark::Plain
    }

    /// The answer is on its way: its deadline is taken anew.
    fn wait_longer(&mut self, now_ms: u64) {
        if let Some(pending) = &mut self.pending {
            pending.deadline_ms = now_ms + DEADLINE_MS;
        }
    }

    /// The robot says `ready` for the first time.
    fn meet(&mut self, ready: &Ready<'_>, now_ms: u64) {
        if ready.protocol != PROTOCOL {
            return self.fail(Trouble::Protocol { version: ready.protocol }, now_ms);
        }
        self.robot = Some(Identity {
            firmware: ready.firmware.into(),
            board: ready.board.into(),
            nodes: ready.nodes,
            turns: ready.turns,
        });
        self.phase = Phase::Ready;
        self.restarted_ms = Some(now_ms);
        self.tune = [None; Name::COUNT];
        self.plot.clear();
        self.ask_unknown();
        if core::mem::replace(&mut self.lost_before, LostBefore::No) == LostBefore::Yes {
            self.note(News::Reconnected, now_ms);
        }
    }

    /// The robot says `ready` though it was there: an answer, or a reset.
    fn met_again(&mut self, now_ms: u64) {
        let lately = |ms: Option<u64>, span_ms| ms.is_some_and(|ms| now_ms < ms + span_ms);
        if !self.asks_hi() && !lately(self.hi_ms, HI_MS) {
            self.restarted(now_ms);
        }
    }

    /// A robot's clock that runs backwards has been reset, even if its `ready` was swallowed.
    fn watch_clock(&mut self, report: &Report<'_>, now_ms: u64) {
        let ms = match report {
            Report::At(at) => at.ms,
            Report::Do(chose) => chose.ms,
            Report::Ir(ir) => ir.ms,
            Report::Beat(beat) => beat.ms,
            // An `end` is told again later, with its own time.
            Report::End(_)
            | Report::Ready(_)
            | Report::Ok(..)
            | Report::Err(..)
            | Report::TurnsHave { .. }
            | Report::TurnsData { .. }
            | Report::Node(_) => return,
        };
        let back = self.robot_ms.is_some_and(|last| ms != last && ms.wrapping_sub(last) > u32::MAX / 2);
        self.robot_ms = Some(ms);
        if back {
            self.restarted(now_ms);
        }
    }

    /// The robot was reset: it has forgotten its run, where it stands, what to tell, and half an upload.
    fn restarted(&mut self, now_ms: u64) {
        if self.restarted_ms.is_some_and(|ms| now_ms < ms + RESTART_MS) {
            return;
        }
        self.restarted_ms = Some(now_ms);
        self.robot_ms = None;
        self.plot.clear();
        self.placed = Placed::Somewhere;
        self.cut_run();
        if let Some(pending) = self.pending.take_if(|pending| matches!(pending.job, Job::Run(_) | Job::Place))
        {
            self.note(News::Refused(pending.job, Code::Place), now_ms);
        }
        self.queue.retain(|job| !matches!(job, Job::Run(_) | Job::Place));
        if let Some(sending) = &mut self.sending {
            sending.restart();
            self.sent = sending.progress();
        }
        if self.alarm.is_none() {
            self.queue.push_front(Job::Watch(self.level));
        }
        self.note(News::Restarted, now_ms);
    }

    /// An answer; to nothing that is asked now, it is no matter.
    fn answered(&mut self, tag: Option<Tag>, answer: Result<Said, Code>, now_ms: u64) {
        let fits = |pending: &mut Pending| tag == Some(pending.tag);
        let Some(Pending { job, .. }) = self.pending.take_if(fits) else { return };
        // The page's own stop of a robot that has already been greeted again.
        let back = job == Job::Stop && self.left == Left::Driving && self.phase == Phase::Ready;
        match (job, answer) {
            (Job::Send, answer) => return self.sent_step(answer, now_ms),
            (Job::ReadTurns, Ok(_)) => match self.take_list(now_ms) {
                Read::Whole => {}
                Read::Broken => return self.ask_again(job, now_ms),
            },
            (Job::ReadTurns, Err(Code::NoList)) => {
                let before = core::mem::replace(&mut self.kept, Kept::Nothing);
                self.settle(&before);
            }
            (Job::ReadNodes, Ok(said)) => match self.take_nodes(said) {
                Read::Whole => {}
                Read::Broken => return self.ask_again(job, now_ms),
            },
            (Job::Get(name) | Job::Set(name, _), Ok(Said::Setting(told, value))) if name == told => {
                self.tune[name as usize] = Some(value);
            }
            (Job::Run(_), Ok(_)) => self.set_off(),
            (Job::Run(_), Err(code)) => {
                self.starting = None;
                if code == Code::Place {
                    self.placed = Placed::Somewhere;
                }
            }
            (Job::Place, Ok(_)) => self.placed = Placed::AtStart,
            (Job::Stop, Ok(_)) => self.stopped(now_ms),
            (
                Job::Hi
                | Job::Watch(_)
                | Job::ReadTurns
                | Job::ReadNodes
                | Job::Get(_)
                | Job::Set(..)
                | Job::Stop
                | Job::Place,
                _,
            ) => {}
        }
        self.rereads = 0;
        match answer {
            Ok(_) if matches!(job, Job::Run(_)) => self.note(News::Accepted(job), now_ms),
            Ok(_) if job.is_told() => {
                self.note(News::Done(job), now_ms);
                if back {
                    // The last word is what is left to be done by hand.
                    self.notes.retain(|note| note.news != News::Reconnected);
                    self.note(News::Reconnected, now_ms);
                }
            }
            Ok(_) | Err(Code::NoList) if !job.is_told() => {}
            Err(code) => self.note(News::Refused(job, code), now_ms),
            Ok(_) => {}
        }
    }

    /// Lines of the answer were lost on the way: once more, but not for ever.
    fn ask_again(&mut self, job: Job, now_ms: u64) {
        self.rereads += 1;
        if self.rereads < TRIES {
            self.queue.push_front(job);
        } else {
            self.give_up(job, now_ms);
        }
    }

    fn sent_step(&mut self, answer: Result<Said, Code>, now_ms: u64) {
        let Some(sending) = &mut self.sending else { return };
        let next = match answer {
            Ok(_) => sending.acknowledged(),
            Err(code) => sending.refused(code),
        };
        match next {
            Next::Go => self.send_on(now_ms),
            Next::Read => {
                self.sent = sending.progress();
                self.note(News::Done(Job::Send), now_ms);
                self.queue.push_front(Job::ReadTurns);
            }
            Next::Failed => {
                self.cut_upload();
                self.queue.push_front(Job::ReadTurns);
                if let Err(code) = answer {
                    self.note(News::Refused(Job::Send, code), now_ms);
                }
            }
        }
    }

    fn take_list(&mut self, now_ms: u64) -> Read {
        let Some((upload, origin, letters)) = self.coming.list.take() else { return Read::Broken };
        if letters.len() != usize::from(upload.len) || frame::crc16(letters.bytes()) != upload.crc {
            return Read::Broken;
        }
        let list = KeptList { upload, origin, letters, read_ms: now_ms };
        let before = core::mem::replace(&mut self.kept, Kept::List(list));
        self.settle(&before);
        Read::Whole
    }

    fn take_nodes(&mut self, said: Said) -> Read {
        let nodes = core::mem::take(&mut self.coming.nodes);
        let whole = nodes.iter().zip(1..).all(|(node, number)| node.node == number);
        match said {
            Said::Nodes(count) if usize::from(count) == nodes.len() && whole => {
                self.nodes = nodes;
                Read::Whole
            }
            Said::Nodes(_) | Said::Nothing | Said::Setting(..) | Said::Typed => Read::Broken,
        }
    }

    /// The robot drives off.
    fn set_off(&mut self) {
        self.phase = Phase::Running;
        self.placed = Placed::Somewhere;
        if let Some(run) = self.starting.take() {
            self.live = Some(run);
        }
    }

    fn reached(&mut self, at: Reached, now_ms: u64) {
        self.plot.stop(at.ms);
        if self.phase == Phase::Ready {
            // The `ok` may be lost; or somebody started the robot by hand, and this is its first stop.
            if self.starting.is_none() && is_first(&at) && self.live_is_over() {
                self.starting = Some(LiveRun::new(Errand::Unasked, self.pace));
            }
            self.set_off();
        }
        if let Some(live) = &mut self.live {
            live.reached(at);
            if live.stops() == 0 && live.end().is_none() {
                self.note(News::Driving(self.run_job()), now_ms);
            }
        }
    }

    fn live_is_over(&self) -> bool {
        self.live.as_ref().is_none_or(|live| live.end().is_some())
    }

    fn ended(&mut self, end: End, now_ms: u64) {
        if self.phase != Phase::Running {
            return;
        }
        self.phase = Phase::Ready;
        self.note(News::Ended(self.run_job(), end), now_ms);
        // It stands: a stop that it has not confirmed in words is confirmed by that.
        if self.pending.take_if(|pending| pending.job == Job::Stop).is_some() {
            self.stopped(now_ms);
        }
        self.left = Left::Standing;
        if let Some(live) = &mut self.live {
            live.ended(end);
            if !matches!(live.errand(), Errand::Route) {
                // A run that found the finish has left a list, any run a node table.
                self.queue.extend([Job::ReadTurns, Job::ReadNodes]);
            }
        }
    }
}
