//! Path mapping (Fred Swirbul, *Maze path mapping*, Phoenix Area Robotics eXperimenters, 2002): a hand on the
//! wall, and a list of the numbers of the squares, from which is cut what led back.
//!
//! | name | meaning |
//! |---|---|
//! | `Path(1..CSIP)` | the squares from the start to here |
//! | `CSIP` | current square in path |
//! | number | up is where the robot faced at the start: 1 more to the right, a field's width more upwards |
//! | `P` | a place in the path that is compared with the last |

use alloc::string::{String, ToString};
use alloc::vec::Vec;

use super::book::errata::{Erratum, Kind, Place};
use super::hand::Side;
use super::mind::{Field, Plan, Robot};
use super::tell::{Tell, many, tail};
use crate::event::{Decision, Finish, Home, Look, Outcome};
use crate::geometry::{Heading, Point};
use crate::settings::Rule;

listing! {
    ACT     "every new square:"
    PUSH    "  CSIP = CSIP + 1; Path(CSIP) = its number"
    BASIC   "  basic rule:"
    IF_TWO  "    if CSIP > 2 and Path(CSIP) == Path(CSIP - 2):   # two steps ago"
    CUT_TWO "      Path(CSIP) = Path(CSIP - 1) = 0; CSIP = CSIP - 2"
    SPECIAL "  special case 1:"
    IF_ANY lab "    for P = CSIP - 1 down to 1: if Path(P) == Path(CSIP):   # anywhere"
    CUT_ANY lab "      Path(P + 1 .. CSIP) = 0; CSIP = P"
    FINISH  "  if finish: stop                # Path is the way from the start"
    FOLLOW lab "  first way of: hand, ahead, other hand, back"
}

cases! {
    START "start" Info Plain "The robot stands on square {square}, the first of its path, and looks all round: with its {hand} hand on the wall, it *{turn}*."
    NEW "new-square" Now Node "Square {square} becomes `Path({csip})`. By the rule nothing is to be cut, so with its {hand} hand on the wall the robot *{turn}*."
    CUT "cut" Now Known "Square {square} is on the path already: what came after it *led back* and is zeroed. `CSIP` is {csip} again, and the robot *{turn}*."
    FINISH "finish" Go End "The robot stands on the *finish*, square {square}. Its path of {squares} is the way from the start: {path}."
    FULL "path-full" Bad End "The path has no room for another square: all {csip} places are *taken*."
}

/// Where the article's listings slip, and what it leaves open.
pub static ERRATA: &[Erratum] = &[
    Erratum {
        section: "Special case 1",
        title: "The loop has to count down",
        text: "A loop from CSIP to 2 that counts up ends before it begins. It has to count down.",
        printed: Some("For P = CSIP to 2"),
        meant: Some("For P = CSIP to 3 Step -1"),
        kind: Kind::Slip,
        places: &[Place::Ran(line::CUT_ANY)],
    },
    Erratum {
        section: "Special case 1",
        title: "Path(0)",
        text: "At P = 2 the listing reads Path(P - 2), which is Path(0); the path begins at 1.",
        printed: Some("Path(P-2)"),
        meant: None,
        kind: Kind::Slip,
        places: &[Place::Ran(line::IF_ANY)],
    },
    Erratum {
        section: "Special case 1",
        title: "The wrong variable",
        text: "The inner loop counts Q but clears Path(P), again and again. Everything above the new CSIP is meant.",
        printed: Some("Path(P) = 0"),
        meant: Some("Path(Q) = 0"),
        kind: Kind::Slip,
        places: &[Place::Ran(line::CUT_ANY)],
    },
    Erratum::open(
        "Mapping your maze",
        "What wall following is",
        "The article takes left or right wall following as known. The lab reads it as the first way of hand, ahead, other hand, back.",
        &[Place::Told(case::START)],
    ),
    Erratum::open(
        "Special case 1",
        "When the list is full",
        "The article assumes a path of 48 squares at most and does not say what happens beyond. The lab ends the run there.",
        &[Place::Told(case::FULL)],
    ),
];

/// How squares are numbered.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Numbering {
    /// The number of the start.
    pub start: i32,
    /// How much more the square above has.
    pub width: i32,
}

impl Numbering {
    /// The article's way out for a robot that nobody told its maze's size: in the middle of 24 by 24. Here every
    /// maze has its bounds, and [`Numbering::of`] is used.
    pub const UNKNOWN: Self = Self { start: 276, width: 24 };

    /// The numbers of a known field, from 1 in the lower left corner as the robot sees it.
    #[must_use]
    pub fn of(field: Field) -> Self {
        let far = Point::new(field.width as i32 - 1, field.height as i32 - 1);
        let (a, b) = (field.from_start(Point::new(0, 0)), field.from_start(far));
        let width = a.x.abs_diff(b.x) as i32 + 1;
        Self { start: 1 - a.x.min(b.x) - a.y.min(b.y) * width, width }
    }

    /// The number of a square, as seen from the start in the robot's own frame.
    #[must_use]
    pub const fn number(self, from_start: Point) -> i32 {
        self.start + from_start.x + from_start.y * self.width
    }
}

/// A robot that maps its path.
#[derive(Clone, Debug)]
pub struct Parex {
    side: Side,
    rule: Rule,
    numbering: Numbering,
    path_max: Option<u32>,
    path: Vec<i32>,
    /// For special case 1: one more than the place of a square in the path; 0 where it is not in it.
    places: Vec<u32>,
    /// The same for numbers below 0.
    below: Vec<u32>,
    square: i32,
    heading: Heading,
    peak: u32,
}

impl Parex {
    /// A robot with this hand on the wall, before it has noted its first square.
    #[must_use]
    pub const fn new(side: Side, rule: Rule, numbering: Numbering, path_max: Option<u32>) -> Self {
        Self {
            side,
            rule,
            numbering,
            path_max,
            path: Vec::new(),
            places: Vec::new(),
            below: Vec::new(),
            square: numbering.start,
            heading: Heading::North,
            peak: 0,
        }
    }

    /// `Path(1..=CSIP)`.
    #[must_use]
    pub fn path(&self) -> &[i32] {
        &self.path
    }

    /// Current square in path: how many squares the path has.
    #[must_use]
    pub const fn csip(&self) -> usize {
        self.path.len()
    }

    /// The number of the square that the robot stands on.
    #[must_use]
    pub const fn square(&self) -> i32 {
        self.square
    }

    /// How squares are numbered.
    #[must_use]
    pub const fn numbering(&self) -> Numbering {
        self.numbering
    }

    /// How the path is cut.
    #[must_use]
    pub const fn rule(&self) -> Rule {
        self.rule
    }

    /// Where the place of a square in the path is kept; a wrong start or width can lead below 0.
    fn place(&mut self, square: i32) -> &mut u32 {
        let places = if square < 0 { &mut self.below } else { &mut self.places };
        let slot = square.unsigned_abs() as usize;
        if places.len() <= slot {
            places.resize(slot + 1, 0);
        }
        &mut places[slot]
    }

    /// The square that the robot drove onto.
    const fn arrive(&mut self, home: Home) {
        if matches!(home, Home::PutDown) {
            return;
        }
        let (dx, dy) = self.heading.vector();
        self.square += dx + dy * self.numbering.width;
    }

    /// Notes the square at the end of the path; its earlier place there, which special case 1 asks for; 0 is none.
    fn push(&mut self) -> usize {
        self.path.push(self.square);
        self.peak = self.peak.max(self.path.len() as u32);
        if self.rule == Rule::Basic {
            return 0;
        }
        let last = self.path.len() as u32;
        let place = self.place(self.square);
        let earlier = *place;
        if earlier == 0 {
            *place = last;
        }
        earlier as usize
    }

    /// Cuts what led back, by the rule; whether there was something.
    fn cut(&mut self, earlier: usize, tell: &mut impl Tell<Self>) -> bool {
        match self.rule {
            Rule::Basic => {
                tell.yes(line::BASIC, self);
                if !matches!(self.path[..], [.., before, _, last] if before == last) {
                    tell.no(line::IF_TWO, self);
                    return false;
                }
                tell.yes(line::IF_TWO, self);
                self.path.truncate(self.path.len() - 2);
                tell.did(line::CUT_TWO, self);
                true
            }
            Rule::Special1 => {
                tell.yes(line::SPECIAL, self);
                if earlier == 0 {
                    tell.no(line::IF_ANY, self);
                    return false;
                }
                tell.yes(line::IF_ANY, self);
                // The last square is the earlier one again; those between are forgotten.
                self.path.pop();
                while self.path.len() > earlier
                    && let Some(square) = self.path.pop()
                {
                    *self.place(square) = 0;
                }
                tell.did(line::CUT_ANY, self);
                true
            }
        }
    }
}

impl Robot for Parex {
    fn decide(&mut self, look: Look, tell: &mut impl Tell<Self>) -> Decision {
        self.arrive(look.home);
        if let Some(capacity) = self.path_max
            && self.path.len() as u64 >= u64::from(capacity)
        {
            tell.is(case::FULL);
            tell.none(line::PUSH, self);
            return Decision::End(Outcome::PathFull { capacity });
        }
        let earlier = self.push();
        tell.did(line::PUSH, self);
        let cut = self.cut(earlier, tell);
        if look.sighting.finish == Finish::Yes {
            tell.is(case::FINISH);
            tell.did(line::FINISH, self);
            return Decision::End(Outcome::Finish);
        }
        tell.no(line::FINISH, self);
        tell.is(match (look.home, cut) {
            (Home::PutDown, _) => case::START,
            (_, false) => case::NEW,
            (_, true) => case::CUT,
        });
        let turn = look.first_of(&self.side.order());
        self.heading = self.heading.turned(turn);
        tell.did(line::FOLLOW, self);
        Decision::Go(turn)
    }

    fn fact(&self, key: &str, out: &mut String) {
        match key {
            "hand" => out.push_str(self.side.word()),
            "square" => out.push_str(&self.square.to_string()),
            "csip" => out.push_str(&self.path.len().to_string()),
            "squares" => out.push_str(&many(self.path.len(), "square")),
            _ => tail(&self.path, out, |square, out| out.push_str(&square.to_string())),
        }
    }

    fn peak_bytes(&self) -> u32 {
        2 * self.peak
    }

    fn host_bytes(&self) -> usize {
        4 * (self.path.len() + self.places.len() + self.below.len())
    }

    fn plan(&self) -> Option<Plan> {
        let width = self.numbering.width;
        let mut at = Point::new(0, 0);
        let mut places = alloc::vec![at];
        for pair in self.path.windows(2) {
            // In a field that is one square wide, 1 more is up.
            at = at.step(match pair[1] - pair[0] {
                up if up == width => Heading::North,
                down if down == -width => Heading::South,
                1 => Heading::East,
                _ => Heading::West,
            });
            places.push(at);
        }
        Some(Plan::Places(places))
    }
}
