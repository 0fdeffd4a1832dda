//! The run that the stepper shows: the robot's, or one of a recording that is open.

use leptos::prelude::*;

use super::Wire;
use crate::link::live::{LiveRun, Mind};
use crate::link::words::Source;
use crate::web::connect::live;
use crate::web::connect::record::Recorded;

impl Wire {
    /// What the page's explorer decides with.
    pub fn mind(self) -> Mind {
        let scale = self.lab.maze.with_untracked(|maze| maze.scale);
        self.lab.settings.with_untracked(|settings| Mind {
            order: settings.order,
            epsilon_ms: settings.epsilon(scale),
            node_max: settings.node_max,
        })
    }

    /// Opens the runs of a recording; the last is shown.
    pub(in crate::web::connect) fn open_recording(self, name: String, runs: Vec<LiveRun>) {
        let open = Recorded::new(name, &runs);
        self.change(|inner| inner.runs = runs);
        self.recorded.set(Some(open));
        self.show_again();
    }

    /// Shows another run of the recording.
    pub(in crate::web::connect) fn choose_run(self, index: usize) {
        let difference = self.inner.with_value(|inner| inner.runs.get(index).and_then(LiveRun::difference));
        self.recorded.update(|open| {
            if let Some(open) = open {
                (open.chosen, open.difference) = (index, difference);
            }
        });
        self.show_again();
    }

    /// Back to the robot, or to the page's own run.
    pub(in crate::web::connect) fn close_recording(self) {
        self.recorded.set(None);
        self.change(|inner| inner.runs.clear());
        self.lab.rewind();
        self.show_again();
    }

    /// Shows the run again that was sent away.
    pub fn show_again(self) {
        self.change(|inner| inner.shown = None);
        self.show_run();
    }

    /// Shows the run in the stepper, if there is anything new in it.
    pub(super) fn show_run(self) {
        let chosen =
            self.recorded.with_untracked(|open| open.as_ref().map(|open| (open.chosen, open.name.clone())));
        let guest_there = self.lab.guest.with_untracked(Option::is_some);
        let coming = self.change(|inner| {
            let run = match &chosen {
                Some((index, _)) => inner.runs.get(*index),
                None => inner.link.live(),
            }?;
            let past = chosen.is_none() && inner.link.shows_past();
            let now = (run.stops(), run.end().is_some(), past);
            // Sent away by the user: only another run comes by itself.
            let dismissed = !guest_there
                && inner.shown.is_some_and(|(stops, over, _)| now.0 >= stops && (now.1 || !over));
            if inner.shown == Some(now) || dismissed {
                return None;
            }
            inner.shown = Some(now);
            Some((run.clone(), past))
        });
        if let Some((run, past)) = coming {
            let source = match &chosen {
                Some((_, name)) => Source::Recording(name),
                None if past => Source::Past,
                None => Source::Robot,
            };
            live::show(self.lab, &run, source);
        }
    }
}
