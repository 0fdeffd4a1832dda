//! When a moment is read aloud: a step that somebody made at once, and while something plays by itself at most one
//! sentence in [`PAUSE_S`], the newest, so that a listener hears whole sentences.

/// Seconds from one sentence to the next while something plays by itself.
pub const PAUSE_S: f64 = 3.0;

/// Who moves the run.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Mover {
    /// A person, step by step.
    Hand,
    /// Time: it plays, or a robot drives.
    Time,
}

/// What was said when.
///
/// ```
/// use line_maze_lab::playback::voice::{Mover, Voice};
/// let mut voice = Voice::default();
/// assert_eq!(voice.wait_s(10.0, Mover::Time), 0.0);
/// voice.spoke(10.0);
/// assert_eq!(voice.wait_s(11.0, Mover::Time), 2.0);
/// assert_eq!(voice.wait_s(11.0, Mover::Hand), 0.0);
/// ```
#[derive(Clone, Copy, Debug, Default)]
pub struct Voice {
    spoke_s: Option<f64>,
}

impl Voice {
    /// Seconds until something that is new now is to be spoken, or what is newest by then.
    #[must_use]
    pub fn wait_s(&self, now_s: f64, mover: Mover) -> f64 {
        match (mover, self.spoke_s) {
            (Mover::Hand, _) | (Mover::Time, None) => 0.0,
            (Mover::Time, Some(spoke_s)) => (spoke_s + PAUSE_S - now_s).max(0.0),
        }
    }

    /// Something was spoken.
    pub const fn spoke(&mut self, now_s: f64) {
        self.spoke_s = Some(now_s);
    }
}
