//! Where the book slips or leaves something open, told at the stop, case or line where it matters.
//!
//! Code that is printed there is quoted as it stands; what is meant is written with the lab's names.

use super::Case;
use super::code::Line;
use crate::explorer::tell::Said;
use crate::trace::{Frame, State};

mod list;

pub use list::ERRATA;
use list::PLACES;

/// Notes that are shown at one moment, at most.
pub const AT_ONCE: usize = 2;

/// A note on the book.
#[derive(Debug, PartialEq, Eq)]
pub struct Erratum {
    /// Where in the book.
    pub section: &'static str,
    /// A few words.
    pub title: &'static str,
    /// What is wrong or open, and what the lab does; at most 40 words.
    pub text: &'static str,
    /// What the book prints.
    pub printed: Option<&'static str>,
    /// What is meant, with the lab's names.
    pub meant: Option<&'static str>,
    /// Which of both it is.
    pub kind: Kind,
    /// Where it applies; nowhere means in the list of all errata only.
    pub places: &'static [Place],
}

impl Erratum {
    /// What a source leaves open, and how the lab reads it.
    pub(in crate::explorer) const fn open(
        section: &'static str,
        title: &'static str,
        text: &'static str,
        places: &'static [Place],
    ) -> Self {
        Self { section, title, text, printed: None, meant: None, kind: Kind::Open, places }
    }
}

/// What a note is about.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Kind {
    /// The book slips here.
    Slip,
    /// The book leaves this open, or tells it only by example.
    Open,
}

/// A place in a run where a note applies.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Place {
    /// A stop of figure 3.1's walk, when it is over.
    Figure31 {
        /// From 1.
        stop: u32,
    },
    /// A stop of figure 2.4's walk, when it is over.
    Figure24 {
        /// From 1.
        stop: u32,
    },
    /// The stop or line that takes a coordinate beyond an Uno's `int`.
    Overflow,
    /// A stop of this case, when it is over.
    Case(Case),
    /// When this line ran last.
    Line(Line),
    /// A stop of the walk through figure 2 of Sakib and others, when it is over.
    SakibFigure2 {
        /// From 1.
        stop: u32,
    },
    /// A stop at which this line of another explorer's listing ran.
    Ran(u8),
    /// A stop of this case of another explorer, when it is over.
    Told(u8),
}

/// Which walk a trace is.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Walk {
    /// Figure 3.1 with the order straight, right, left: §3.1's own.
    Figure31,
    /// Figure 2.4 with that order: §2.6's own, but for the U-turn.
    Figure24,
    /// Figure 2 of Sakib and others, which their full mapping maps.
    SakibFigure2,
    /// Any other.
    Other,
}

/// The notes that apply at a moment, the most special first; at most [`AT_ONCE`].
pub fn at(frame: &Frame, walk: Walk) -> impl Iterator<Item = &'static Erratum> {
    numbers_at(frame, walk).map(|number| &ERRATA[number])
}

/// Their places in [`ERRATA`].
pub fn numbers_at(frame: &Frame, walk: Walk) -> impl Iterator<Item = usize> {
    let ranked = move |wanted| {
        PLACES
            .iter()
            .enumerate()
            .filter_map(move |(number, places)| (rank(places, frame, walk) == Some(wanted)).then_some(number))
    };
    (0..RANKS).flat_map(ranked).take(AT_ONCE)
}

/// The notes on another explorer's source that apply at a stop when it is over.
pub fn at_stop(
    errata: &'static [Erratum],
    walk: Walk,
    stop: u32,
    said: &Said,
) -> impl Iterator<Item = &'static Erratum> + use<> {
    let said = *said;
    let here = move |place: &Place| match *place {
        Place::SakibFigure2 { stop: there } => walk == Walk::SakibFigure2 && stop == there,
        Place::Ran(line) => said.lines().contains(&line),
        Place::Told(case) => said.case() == case,
        // The book's.
        Place::Figure31 { .. } | Place::Figure24 { .. } | Place::Overflow => false,
        Place::Case(_) | Place::Line(_) => false,
    };
    errata.iter().filter(move |erratum| erratum.places.iter().any(here))
}

const RANKS: u8 = 4;

/// How special a note is at this moment: 0 is most; none where it doesn't apply.
fn rank(places: &[Place], frame: &Frame, walk: Walk) -> Option<u8> {
    places.iter().filter_map(|place| place.rank(frame, walk)).min()
}

impl Place {
    fn rank(self, frame: &Frame, walk: Walk) -> Option<u8> {
        let whole = frame.moment.lines == frame.lines;
        let (here, rank) = match self {
            Self::Figure31 { stop } => (whole && walk == Walk::Figure31 && stop == frame.moment.stop, 0),
            Self::Figure24 { stop } => (whole && walk == Walk::Figure24 && stop == frame.moment.stop, 0),
            Self::Overflow => (overflows(&frame.state) && !overflows(&frame.before), 1),
            Self::Case(case) => (frame.case == Some(case), 2),
            Self::Line(line) => (frame.ran == Some(line), 3),
            // Not the book's.
            Self::SakibFigure2 { .. } | Self::Ran(_) | Self::Told(_) => return None,
        };
        here.then_some(rank)
    }
}

/// Whether an Uno's 16-bit `int` could not hold the coordinates.
fn overflows(state: &State) -> bool {
    let beyond = |coordinate: i32| i16::try_from(coordinate).is_err();
    beyond(state.cur_x) || beyond(state.cur_y)
}
