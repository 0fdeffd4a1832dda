//! What the Compare room knows: who is compared, all their runs, and the one time that they share. It outlives
//! the room, so that a line-up and a league are still there when one comes back.

use std::cell::OnceCell;

use leptos::prelude::*;

use super::league::LeagueDesk;
use super::orders::OrdersDesk;
use crate::compare::abreast::{self, Clock, Position};
use crate::compare::floor::Floor;
use crate::compare::forks::{Fork, forks};
use crate::compare::score::{Bests, Column};
use crate::compare::{Entrant, Lineup};
use crate::explorer::name::Name;
use crate::maze::Maze;
use crate::run::AnyRun;
use crate::settings::Pace;
use crate::web::browser;
use crate::web::run_view::Same;
use crate::web::state::{Lab, ToastTone};

/// One maze, or many.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Page {
    /// The page's maze.
    Maze,
    /// The league.
    League,
}

/// What runs are held equal by.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum By {
    /// Cells driven.
    Distance,
    /// Seconds.
    Time,
}

/// On or back.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Towards {
    /// Back.
    Start,
    /// On.
    End,
}

/// What the table is sorted by.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Key {
    /// The line-up's order.
    Lineup,
    /// How it ended.
    Outcome,
    /// A number.
    Number(Column),
}

/// All runs in the page's maze.
pub struct Field {
    /// The maze.
    pub maze: Same<Maze>,
    /// The robots' cost model.
    pub pace: Pace,
    /// Each explorer, or why it could not be put down.
    pub entrants: Vec<(Name, Result<Racer, String>)>,
    /// Where they part.
    pub forks: Vec<Fork>,
    /// What the maze has at best.
    pub bests: Bests,
}

/// An explorer that runs.
pub struct Racer {
    /// Its run and score.
    pub entrant: Entrant,
    /// What it leaves on the floor.
    pub floor: Floor,
}

impl Field {
    /// The runs that there are.
    pub fn runs(&self) -> impl Iterator<Item = &AnyRun> {
        self.entrants.iter().filter_map(|(_, racer)| Some(&racer.as_ref().ok()?.entrant.run))
    }

    /// Such an explorer.
    pub fn racer(&self, nth: usize) -> Option<&Racer> {
        self.entrants.get(nth)?.1.as_ref().ok()
    }

    /// Where an explorer is.
    pub fn position(&self, nth: usize, clock: Clock) -> Option<Position> {
        abreast::at(&self.maze, &self.racer(nth)?.entrant.run, &self.pace, clock)
    }

    /// How long a run is on this clock.
    pub fn length(&self, run: &AnyRun, by: By) -> f64 {
        let (cells, seconds) = abreast::total(&self.maze, run, &self.pace);
        match by {
            By::Distance => cells,
            By::Time => seconds,
        }
    }

    /// The clock at a fork.
    pub fn fork_time(&self, fork: &Fork, by: By) -> f64 {
        let stop_time = |(who, side): &(usize, crate::compare::parting::Side)| {
            let run = &self.racer(*who)?.entrant.run;
            Some(by.clock(0.0).at_stop(&self.maze, run, &self.pace, side.stop).value())
        };
        match by {
            By::Distance => f64::from(fork.cells),
            By::Time => fork.sides.iter().filter_map(stop_time).fold(0.0, f64::max),
        }
    }
}

impl By {
    /// A clock of this kind.
    pub const fn clock(self, value: f64) -> Clock {
        match self {
            Self::Distance => Clock::Cells(value),
            Self::Time => Clock::Seconds(value),
        }
    }
}

/// The desk; cheap to copy.
#[derive(Clone, Copy)]
pub struct Desk {
    /// The page's state.
    pub lab: Lab,
    /// One maze, or many.
    pub page: Memo<Page>,
    /// Who.
    pub names: RwSignal<Vec<Name>>,
    /// Their runs.
    pub field: Memo<Same<Field>>,
    /// By what they are held equal.
    pub by: RwSignal<By>,
    /// Cells or seconds since the start.
    pub now: RwSignal<f64>,
    /// Whether time passes.
    pub playing: RwSignal<bool>,
    /// How fast.
    pub speed: RwSignal<f64>,
    /// How the table is sorted, and whether the greatest are first.
    pub sort: RwSignal<(Key, bool)>,
    /// Random orders.
    pub orders: OrdersDesk,
    /// The league.
    pub league: LeagueDesk,
}

thread_local! {
    static DESK: OnceCell<Desk> = const { OnceCell::new() };
}

/// The room's desk.
pub fn desk() -> Desk {
    expect_context::<Desk>()
}

impl Desk {
    /// The page's one desk.
    pub fn of(lab: Lab) -> Self {
        DESK.with(|desk| {
            *desk.get_or_init(|| {
                // It belongs to the page, not to the room that asks for it first.
                let room = Owner::current();
                let owner = Owner::new_root(None);
                let desk = owner.with(|| Self::new(lab));
                std::mem::forget(owner);
                // A new root makes itself the current owner.
                if let Some(room) = room {
                    room.set();
                }
                desk
            })
        })
    }

    fn new(lab: Lab) -> Self {
        let names = RwSignal::new(vec![Name::Book, Name::LeftHand, Name::Mapping]);
        let field = Memo::new(move |_| {
            let (maze, settings) = (lab.maze.get(), lab.settings.get());
            let bests = Bests::of(&maze, &settings);
            let race = |name: Name| {
                let entrant = Entrant::of(&maze, &settings, name, &bests).map_err(|why| why.to_string())?;
                Ok(Racer { floor: Floor::of(&maze, &entrant.run), entrant })
            };
            let entrants: Vec<_> = names.get().into_iter().map(|name| (name, race(name))).collect();
            let mut field = Field { maze, pace: settings.pace, entrants, forks: Vec::new(), bests };
            let runs: Vec<&AnyRun> = field.runs().collect();
            // Letters would be wrong where somebody is missing.
            if runs.len() == field.entrants.len() {
                field.forks = forks(&field.maze, &runs);
            }
            Same::new(field)
        });
        let page = Memo::new(move |_| if lab.league.get() { Page::League } else { Page::Maze });
        let desk = Self {
            lab,
            page,
            names,
            field,
            by: RwSignal::new(By::Distance),
            now: RwSignal::new(0.0),
            playing: RwSignal::new(false),
            speed: RwSignal::new(4.0),
            sort: RwSignal::new((Key::Number(Column::RatioShortest), false)),
            orders: OrdersDesk::new(lab),
            league: LeagueDesk::new(lab),
        };
        // Another maze, another race.
        Effect::new(move |_| {
            lab.maze.track();
            lab.settings.track();
            desk.playing.set(false);
            desk.now.set(0.0);
        });
        desk
    }

    /// Turns to one maze or to the league.
    pub fn turn_to(self, page: Page) {
        self.playing.set(false);
        self.lab.league.set(page == Page::League);
    }

    /// Why nobody can start.
    pub fn cannot(self) -> Option<String> {
        self.field.with(|field| match field.runs().next() {
            Some(_) => None,
            None => field.entrants.iter().find_map(|(_, racer)| racer.as_ref().err().cloned()),
        })
    }

    /// Puts others side by side.
    pub fn line_up(self, names: Vec<Name>) {
        if Lineup::new(names.clone()).is_ok() {
            self.playing.set(false);
            self.now.set(0.0);
            self.names.set(names);
        }
    }

    /// The clock.
    pub fn clock(self) -> Clock {
        self.by.get().clock(self.now.get())
    }

    /// The end of the longest run.
    pub fn most(self) -> f64 {
        let by = self.by.get();
        self.field.with(|field| field.runs().map(|run| field.length(run, by)).fold(0.0, f64::max))
    }

    /// Changes what runs are held equal by; the first of them stays where it is.
    pub fn hold_by(self, by: By) {
        let here = self.field.with_untracked(|field| {
            let stop = field.position(0, self.by.get_untracked().clock(self.now.get_untracked()))?.stop;
            let run = &field.racer(0)?.entrant.run;
            Some(by.clock(0.0).at_stop(&field.maze, run, &field.pace, stop).value())
        });
        self.playing.set(false);
        self.by.set(by);
        self.now.set(here.unwrap_or(0.0));
    }

    /// To a time.
    pub fn seek(self, to: f64) {
        self.playing.set(false);
        self.now.set(to.clamp(0.0, untrack(|| self.most())));
    }

    /// To the next stop of any run, or the one before.
    pub fn step(self, to: Towards) {
        let clock = untrack(|| self.clock());
        let to = self.field.with_untracked(|field| {
            if to == Towards::End {
                abreast::next(&field.maze, field.runs(), &field.pace, clock)
            } else {
                abreast::before(&field.maze, field.runs(), &field.pace, clock)
            }
        });
        self.playing.set(false);
        if let Some(to) = to {
            self.now.set(to.value());
        }
    }

    /// To the next parting, or the first after the last; says so where there is none.
    pub fn next_fork(self) {
        let (by, now) = (self.by.get_untracked(), self.now.get_untracked());
        let to = self.field.with_untracked(|field| {
            let times = || field.forks.iter().map(|fork| field.fork_time(fork, by));
            times()
                .filter(|&time| time > now)
                .min_by(f64::total_cmp)
                .or_else(|| times().min_by(f64::total_cmp))
        });
        match to {
            Some(to) => self.seek(to),
            None => self.lab.say(ToastTone::Info, "", "There is no parting: nobody drives another way."),
        }
    }

    /// Plays or pauses; at the end from the beginning.
    pub fn toggle(self) {
        let play = !self.playing.get_untracked();
        if play && self.now.get_untracked() >= untrack(|| self.most()) {
            self.now.set(0.0);
        }
        self.playing.set(play);
    }

    /// Lets time pass while something plays, as long as the room is open.
    pub fn run_clock(self) {
        let open = StoredValue::new(true);
        let ticking = StoredValue::new(false);
        Effect::new(move |_| {
            if self.playing.get() && !ticking.get_value() {
                ticking.set_value(true);
                self.next_frame(browser::now_s(), open, ticking);
            }
        });
        on_cleanup(move || self.playing.set(false));
    }

    fn next_frame(self, before_s: f64, open: StoredValue<bool>, ticking: StoredValue<bool>) {
        request_animation_frame(move || {
            if open.try_get_value().is_none() {
                return;
            }
            if !self.playing.get_untracked() {
                return ticking.set_value(false);
            }
            let now_s = browser::now_s();
            self.pass((now_s - before_s).clamp(0.0, 0.25) * self.speed.get_untracked());
            self.next_frame(now_s, open, ticking);
        });
    }

    fn pass(self, dt_s: f64) {
        let per_second = match self.by.get_untracked() {
            By::Time => 1.0,
            By::Distance => {
                self.field.with_untracked(|field| field.pace.speed_mm_s / field.maze.scale.cell_mm())
            }
        };
        let (to, most) = (self.now.get_untracked() + dt_s * per_second, untrack(|| self.most()));
        self.now.set(to.min(most));
        if to >= most {
            self.playing.set(false);
        }
    }
}
