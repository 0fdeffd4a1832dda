//! The monitor's lines that are shown: those of a sort and with some letters, found once each, so that a
//! filter over ten thousand lines costs nothing while lines come.

use alloc::collections::VecDeque;
use alloc::string::String;

use super::monitor::{LogLine, Monitor, Show};

/// Which lines are shown, and how far they were looked through.
#[derive(Clone, Debug, Default)]
pub struct Sieve {
    show: Show,
    letters: String,
    found: VecDeque<u64>,
    next: u64,
}

impl Sieve {
    /// For lines of a sort, with these letters somewhere.
    #[must_use]
    pub fn new(show: Show, letters: &str) -> Self {
        Self { show, letters: letters.into(), ..Self::default() }
    }

    /// Looks through the lines that came since; forgets those that the monitor has dropped.
    pub fn catch_up(&mut self, monitor: &Monitor) {
        let first = monitor.first();
        while self.found.front().is_some_and(|&number| number < first) {
            self.found.pop_front();
        }
        // What came last may still be marked: it is only shown, never judged, by its mark.
        for number in self.next.max(first)..monitor.total() {
            if monitor.line(number).is_some_and(|line| line.matches(self.show, &self.letters)) {
                self.found.push_back(number);
            }
        }
        self.next = self.next.max(monitor.total());
    }

    /// How many lines are shown.
    #[must_use]
    pub fn len(&self) -> usize {
        self.found.len()
    }

    /// Whether none is.
    #[must_use]
    pub fn is_empty(&self) -> bool {
        self.found.is_empty()
    }

    /// Some of the shown lines, oldest first; those that the monitor has dropped meanwhile are left out.
    pub fn lines<'a>(
        &'a self,
        monitor: &'a Monitor,
        from: usize,
        count: usize,
    ) -> impl Iterator<Item = (u64, &'a LogLine)> {
        let numbers = self.found.iter().skip(from).take(count);
        numbers.filter_map(|&number| Some((number, monitor.line(number)?)))
    }
}

#[cfg(test)]
mod tests {
    use alloc::vec::Vec;

    use super::*;
    use crate::link::monitor::KEPT_LINES;

    fn say(monitor: &mut Monitor, text: &str) {
        text.bytes().chain([b'\n']).for_each(|byte| monitor.byte_in(byte, 0));
    }

    #[test]
    fn lines_are_sifted_as_they_come() {
        let mut monitor = Monitor::new(0, 0);
        let mut sieve = Sieve::new(Show::Events, "at");
        for text in ["at 1", "ir 2", "do 3"] {
            say(&mut monitor, text);
        }
        sieve.catch_up(&monitor);
        sieve.catch_up(&monitor);
        assert_eq!(sieve.len(), 1);
        say(&mut monitor, "at 4");
        sieve.catch_up(&monitor);
        let numbers: Vec<u64> = sieve.lines(&monitor, 0, 9).map(|(number, _)| number).collect();
        assert_eq!(numbers, [0, 3]);
    }

    #[test]
    fn what_the_monitor_drops_goes_here_too() {
        let mut monitor = Monitor::new(0, 0);
        let mut sieve = Sieve::default();
        (0..KEPT_LINES + 10).for_each(|_| say(&mut monitor, "at"));
        sieve.catch_up(&monitor);
        assert_eq!(sieve.len(), KEPT_LINES);
        (0..5).for_each(|_| say(&mut monitor, "at"));
        // A monitor that is paused: nothing new is sifted, old lines go.
        assert_eq!(sieve.lines(&monitor, 0, 3).count(), 0);
        sieve.catch_up(&monitor);
        assert_eq!((sieve.len(), sieve.lines(&monitor, 0, 3).count()), (KEPT_LINES, 3));
    }
}
