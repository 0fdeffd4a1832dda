//! Any executed line of any stop: the mind is fed up to the stop before, and watched while it decides.

use super::{Recording, Stop};
use crate::explorer::book::narrate::Narration;
use crate::explorer::mind::Mind;
use crate::explorer::tell::Ran;
use crate::explorer::tell::line::RanLine;
use crate::trace::Moment;

/// A stop when so many of its lines have run.
#[derive(Clone, Debug)]
pub struct At {
    /// The stop as it is when it is over.
    pub stop: Stop,
    /// How many lines have run.
    pub lines: u8,
    /// How the last of them ran; none when the stop is over.
    pub ran: Option<Ran>,
    /// The mind at the moment.
    pub mind: Mind,
    /// The mind one line earlier, or one stop earlier when the stop is over: what differs has changed.
    /// None at the start.
    pub before: Option<Mind>,
}

impl At {
    /// Whether all lines of the stop have run.
    #[must_use]
    pub const fn is_whole(&self) -> bool {
        self.ran.is_none()
    }

    /// The lines that have run, in order.
    #[must_use]
    pub fn ran_lines(&self) -> &[u8] {
        let lines = self.stop.said.lines();
        lines.get(..usize::from(self.lines)).unwrap_or(lines)
    }

    /// The line that runs next at this stop.
    #[must_use]
    pub fn next(&self) -> Option<u8> {
        self.stop.said.lines().get(usize::from(self.lines)).copied()
    }
}

impl Recording {
    /// What is to be known of a moment; past the stop's lines, it is over, and past the end, it is the last one.
    /// The start has no lines: it is always over.
    ///
    /// ```
    /// use line_maze_lab::explorer::mind::Mind;
    /// use line_maze_lab::explorer::name::Name;
    /// use line_maze_lab::run::{self, AnyRun};
    /// use line_maze_lab::{maze::samples, settings::Settings, trace::Moment};
    /// let run = run::record(&samples::figure_2_4(), &Settings::default(), Name::LeftHand)?;
    /// let AnyRun::Other(recording) = run else { panic!("not the book's") };
    /// let letters = |lines| match recording.moment(Moment { stop: 1, lines }).mind {
    ///     Mind::Hand(hand) => hand.path().len(),
    ///     other => panic!("{other:?}"),
    /// };
    /// // The stop's last two lines add a letter and look whether three can become one.
    /// assert_eq!((letters(4), letters(5), letters(6)), (0, 1, 1));
    /// # Ok::<(), line_maze_lab::world::CannotStart>(())
    /// ```
    #[must_use]
    pub fn moment(&self, moment: Moment) -> At {
        let stop = moment.stop.min(self.stops());
        let all = self.step(stop).lines();
        let Some(last) = stop.checked_sub(1) else {
            let stop = self.at(0);
            return At { lines: all, ran: None, mind: stop.mind.clone(), before: None, stop };
        };
        let ready = self.at(last).mind;
        let over = self.replay(stop, ready.clone(), stop);
        let seen = |lines: u8| ready.clone().watched(over.look, lines).1.filter(|_| lines < all);
        let lines = moment.lines.clamp(1, all.max(1));
        match seen(lines) {
            None => At { lines: all, ran: None, mind: over.mind.clone(), before: Some(ready), stop: over },
            Some(now) => {
                let before = seen(lines - 1).map(|seen| seen.mind);
                At { lines, ran: Some(now.ran), mind: now.mind, before: before.or(Some(ready)), stop: over }
            }
        }
    }

    /// The sentences about a moment.
    #[must_use]
    pub fn tell(&self, at: &At) -> Narration {
        let (Some(ran), Some(&line)) = (at.ran, at.ran_lines().last()) else { return self.narrate(&at.stop) };
        let about = self.name().about();
        RanLine { line, ran, look: at.stop.look, listing: about.listing, section: about.source }.narrate()
    }
}
