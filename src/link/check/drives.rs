//! The rules about driving: tried only where the robot may drive.

use alloc::format;
use alloc::vec::Vec;

use super::super::live::{Errand, LiveRun};
use super::super::report::{End, Report};
use super::super::request::Request;
use super::super::tune::Name;
use super::rules::{Done, broken};
use super::{Broken, Driving, Talk};
use crate::event::{Cut, Outcome};
use crate::settings::{Order, Pace, Preference};

const EXPLORE: Request<'static> = Request::Explore(Order::Fixed(Preference::SRL));

/// A robot that breaks these rules would drive off.
fn allowed(talk: &Talk<'_>) -> Done {
    match talk.driving {
        Driving::Allowed => Ok(()),
        Driving::Forbidden => Err(Broken::NotTried("only with --drive")),
    }
}

pub(super) fn place(talk: &mut Talk<'_>) -> Done {
    allowed(talk)?;
    talk.must(Request::Stop)?;
    talk.must(Request::Place)?;
    talk.must(Request::Place)?;
    talk.must(EXPLORE)?;
    talk.must(Request::Stop)?;
    talk.must_not(EXPLORE, "place")?;
    talk.must_not(Request::RunRoute, "place")
}

pub(super) fn run(talk: &mut Talk<'_>) -> Done {
    allowed(talk)?;
    talk.must(Request::Place)?;
    let (tag, bytes) = talk.sealed(EXPLORE);
    for _ in 0..2 {
        // The same request again is answered again, and starts nothing.
        talk.say(&bytes)?;
        talk.answer(&format!("#{}", tag.number()), "run explore SRL")?
            .or_else(|code| broken(format!("“run explore SRL” was answered err {code}")))?;
    }
    talk.must_not(Request::Set(Name::Kp, 500), "busy")?;
    talk.must_not(Request::Place, "busy")?;
    talk.came.clear();
    for _ in 0..400 {
        talk.listen(50)?;
        let told = |verb| talk.lines(verb).count();
        if told("at") > 1 && told("do") > 1 || told("end") > 0 {
            return order(talk).and_then(|()| along(talk));
        }
    }
    broken("not two stops within 20 s".into())
}

/// `at` and `do` take turns.
fn order(talk: &Talk<'_>) -> Done {
    let verbs = talk.came.iter().filter_map(|line| line.body.split(' ').next());
    let told: Vec<&str> = verbs.filter(|verb| matches!(*verb, "at" | "do")).collect();
    if told.chunks(2).all(|pair| pair == ["at", "do"] || pair == ["at"]) {
        Ok(())
    } else {
        broken(format!("at and do must take turns, but these came: {}", told.join(" ")))
    }
}

/// Each drive goes along the heading that the turns before it left, within the tolerance; and what is met fits
/// the ways that are told. Judged by what the page makes of a run.
fn along(talk: &Talk<'_>) -> Done {
    let mut run = LiveRun::new(Errand::Unasked, Pace::default());
    for line in &talk.came {
        match Report::parse(&line.body) {
            Some(Report::At(at)) => run.reached(at),
            Some(Report::Do(chose)) => drop(run.chose(chose)),
            _ => {}
        }
        match run.end() {
            Some(Outcome::Cut(Cut::Misfit)) => {
                return broken(format!(
                    "“{}” does not fit the drive before it: along the heading one coordinate moves, the other by at most an eighth of that; a corner has one way, a dead end none, a node two or more",
                    line.body
                ));
            }
            Some(Outcome::Cut(Cut::Gap)) => {
                return broken(format!("“{}” does not fit the lines before it", line.body));
            }
            Some(_) | None => {}
        }
    }
    Ok(())
}

pub(super) fn stop(talk: &mut Talk<'_>) -> Done {
    allowed(talk)?;
    talk.must(Request::Stop)?;
    talk.listen(2_500)?;
    let ended =
        |line: &&str| matches!(Report::parse(line), Some(Report::End(ended)) if ended.end == End::Stopped);
    match talk.lines("end").filter(ended).count() {
        3 => Ok(()),
        times => broken(format!("end … stopped came {times} times in 2.5 s")),
    }
}
