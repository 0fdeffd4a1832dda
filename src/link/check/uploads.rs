//! The rules about turn lists: whole or not at all.

use alloc::format;
use alloc::string::String;

use super::super::fields::{Letters, MAX_LETTERS};
use super::super::frame::crc16;
use super::super::report::Report;
use super::super::request::{Request, Upload};
use super::rules::{Done, broken};
use super::{Broken, Talk};

/// A list that no maze asks for; a robot that keeps shorter lists gets as much of it as it keeps.
const LIST: &str = "BRLSRLSRLSRLSRLSRLSRLSRLSRLSRLSRLSRLSRLSRLSRLS";

/// The longest list that the robot keeps, in letters.
fn most(talk: &mut Talk<'_>) -> Result<u16, Broken> {
    talk.must(Request::Hi)?;
    match talk.lines("ready").next().and_then(Report::parse) {
        Some(Report::Ready(ready)) => Ok(ready.turns),
        _ => broken("hi without a ready line".into()),
    }
}

/// As much of the list as the robot keeps.
fn list(talk: &mut Talk<'_>) -> Result<&'static str, Broken> {
    Ok(&LIST[..LIST.len().min(usize::from(most(talk)?))])
}

fn announce(id: u16, letters: &str) -> Upload {
    Upload { id, len: letters.len() as u16, crc: crc16(letters.bytes()) }
}

/// The list on the robot, if it has one: number and letters.
fn read(talk: &mut Talk<'_>) -> Result<Option<(u16, String)>, Broken> {
    talk.listen(120)?;
    match talk.ask(Request::TurnsRead)? {
        Err(code) if code == "no-list" => return Ok(None),
        Err(code) => return broken(format!("turns read was answered err {code}")),
        Ok(_) => {}
    }
    let mut have = None;
    let mut letters = String::new();
    for line in talk.lines("turns") {
        match Report::parse(line) {
            Some(Report::TurnsHave { id, len, crc, .. }) => have = Some((id, len, crc)),
            Some(Report::TurnsData { offset, letters: piece, .. })
                if usize::from(offset) == letters.len() =>
            {
                letters.push_str(piece.as_str());
            }
            _ => return broken(format!("turns read: “{line}” does not fit")),
        }
    }
    match have {
        Some((id, len, crc)) if usize::from(len) == letters.len() && crc == crc16(letters.bytes()) => {
            Ok(Some((id, letters)))
        }
        Some(_) => broken("turns read: length or CRC does not fit the letters".into()),
        None => broken("turns read: no “turns have” line".into()),
    }
}

fn send(talk: &mut Talk<'_>, id: u16, letters: &str) -> Done {
    talk.must(Request::TurnsBegin(announce(id, letters)))?;
    data(talk, id, letters)?;
    talk.must(Request::TurnsCommit { id })?;
    Ok(())
}

fn data(talk: &mut Talk<'_>, id: u16, letters: &str) -> Done {
    for offset in (0..letters.len()).step_by(MAX_LETTERS) {
        let piece = &letters[offset..(offset + MAX_LETTERS).min(letters.len())];
        if let Some(letters) = Letters::new(piece) {
            talk.must(Request::TurnsData { id, offset: offset as u16, letters })?;
        }
    }
    Ok(())
}

/// A number that is not the robot's.
fn fresh(before: &Option<(u16, String)>) -> u16 {
    before.as_ref().map_or(17, |(id, _)| id % 9_000 + 1)
}

fn same(talk: &mut Talk<'_>, id: u16, letters: &str) -> Done {
    match read(talk)? {
        Some(list) if list == (id, letters.into()) => Ok(()),
        Some((other, kept)) => {
            broken(format!("the list must be {id} “{letters}”, but the robot has {other} “{kept}”"))
        }
        None => broken(format!("the list must be {id} “{letters}”, but the robot has none")),
    }
}

pub(super) fn upload(talk: &mut Talk<'_>) -> Done {
    let (list, before) = (list(talk)?, read(talk)?);
    let id = fresh(&before);
    send(talk, id, list)?;
    same(talk, id, list)?;
    restore(talk, id, before)
}

pub(super) fn again(talk: &mut Talk<'_>) -> Done {
    let (list, before) = (list(talk)?, read(talk)?);
    let id = fresh(&before);
    for _ in 0..2 {
        talk.must(Request::TurnsBegin(announce(id, list)))?;
    }
    for _ in 0..2 {
        data(talk, id, list)?;
    }
    for _ in 0..3 {
        talk.must(Request::TurnsCommit { id })?;
    }
    same(talk, id, list)?;
    restore(talk, id, before)
}

/// Puts back the list that was there, under another number.
fn restore(talk: &mut Talk<'_>, id: u16, before: Option<(u16, String)>) -> Done {
    let Some((_, letters)) = before else { return Ok(()) };
    send(talk, id + 1, &letters)?;
    same(talk, id + 1, &letters)
}

pub(super) fn whole(talk: &mut Talk<'_>) -> Done {
    let Some((kept, letters)) = read(talk)? else { return Err(Broken::NotTried("there is no list")) };
    let id = kept % 9_000 + 1;
    // The gap after the first letters has to fit.
    let most = most(talk)?;
    if most < 24 {
        return Err(Broken::NotTried("it keeps less than 24 letters"));
    }
    let other = "RRRRR";
    talk.must_not(Request::TurnsCommit { id: id + 1 }, "no-upload")?;
    // Half of it, then a gap.
    talk.must(Request::TurnsBegin(Upload { len: most.min(60), ..announce(id, other) }))?;
    data(talk, id, other)?;
    same(talk, kept, &letters)?;
    if let Some(piece) = Letters::new("LL") {
        talk.must_not(Request::TurnsData { id, offset: 20, letters: piece }, "no-upload")?;
    }
    talk.must_not(Request::TurnsCommit { id }, "crc")?;
    // The right length, but another sum.
    talk.must(Request::TurnsBegin(Upload { crc: !crc16(other.bytes()), ..announce(id, other) }))?;
    data(talk, id, other)?;
    talk.must_not(Request::TurnsCommit { id }, "crc")?;
    // A number that is taken.
    talk.must_not(Request::TurnsBegin(announce(kept, other)), "id")?;
    same(talk, kept, &letters)
}

pub(super) fn room(talk: &mut Talk<'_>) -> Done {
    let Some(len) = most(talk)?.checked_add(1) else { return Err(Broken::NotTried("it keeps any list")) };
    let id = fresh(&read(talk)?);
    talk.must_not(Request::TurnsBegin(Upload { id, len, crc: 0 }), "full")
}
