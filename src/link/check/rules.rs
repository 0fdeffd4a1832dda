//! The rules of `PROTOCOL.md`, each with how it is tried.

use alloc::format;
use alloc::string::String;
use alloc::vec::Vec;

use super::super::frame::Writer;
use super::super::monitor::readable;
use super::super::report::Report;
use super::super::request::{Level, Request};
use super::super::tune::Name;
use super::drives::{place, run, stop};
use super::uploads::{again, room, upload, whole};
use super::wrong::silence;
use super::{Broken, Rule, Talk, quoted};

pub(super) type Done = Result<(), Broken>;

/// Every rule, in the order in which they are tried.
pub const RULES: &[Rule] = &[
    Rule {
        name: "hi",
        says: "hi is answered by ready, then ok, also after half a line and an LF",
        check: hi,
    },
    Rule {
        name: "typed",
        says: "hi, get and the like are taken without a checksum and number",
        check: typed,
    },
    Rule {
        name: "ends",
        says: "CR LF ends a line as LF does, and an empty line is nothing; CR alone should end one too",
        check: ends,
    },
    Rule { name: "help", says: "help should be answered by what may be typed", check: help },
    Rule { name: "sealed", says: "what changes something is refused without a checksum", check: sealed },
    Rule {
        name: "damaged",
        says: "a damaged line gives err sum or err byte and changes nothing",
        check: damaged,
    },
    Rule { name: "long", says: "a line over 80 bytes gives err long once and is dropped", check: long },
    Rule {
        name: "quiet",
        says: "at most one err in 100 ms, and no answer to err, ok or ready",
        check: quiet,
    },
    Rule { name: "unknown", says: "unknown verbs, names and arguments are refused", check: unknown },
    Rule {
        name: "settings",
        says: "every setting is told; set keeps a value within its range",
        check: settings,
    },
    Rule { name: "upload", says: "begin, data, commit keep a list, and read gives it back", check: upload },
    Rule { name: "again", says: "a repeated begin, data or commit is answered ok again", check: again },
    Rule {
        name: "whole",
        says: "until a right commit the old list is kept; gaps and wrong sums are refused",
        check: whole,
    },
    Rule { name: "room", says: "a list that is too long is refused", check: room },
    Rule { name: "nodes", says: "nodes read tells every row, then ok with their number", check: nodes },
    Rule { name: "watch", says: "off is silent, events beats once a second, all tells ir", check: watch },
    Rule { name: "place", says: "no run without place; stop is answered when nothing runs", check: place },
    Rule {
        name: "run",
        says: "a run tells at and do for each stop, each drive along its heading; meanwhile changes are refused",
        check: run,
    },
    Rule { name: "stop", says: "stop ends a run: ok, then end … stopped, told three times", check: stop },
    Rule { name: "lines", says: "every line is whole, sealed and known", check: lines },
];

pub(super) fn broken<T>(words: String) -> Result<T, Broken> {
    Err(Broken::Rule(words))
}

fn hi(talk: &mut Talk<'_>) -> Done {
    // An Uno resets when the port is opened; whatever it says until then is not its fault.
    talk.listen(100)?;
    for _ in 0..8 {
        let (tag, bytes) = talk.sealed(Request::Hi);
        let mut said = b"watch al\n".to_vec();
        said.extend(bytes);
        talk.say(&said)?;
        let answered = match talk.answer(&format!("#{}", tag.number()), "hi") {
            Ok(answered) => answered,
            Err(Broken::Gone) => return Err(Broken::Gone),
            Err(_) => continue,
        };
        if let Err(code) = answered {
            return broken(format!("“hi” was answered err {code}"));
        }
        let mut odd = talk.strange[talk.strange_before..].iter();
        let odd = odd.clone().find(|line| line.starts_with("“ready")).or_else(|| odd.next()).cloned();
        talk.strange.clear();
        talk.strange_before = 0;
        talk.listen(200)?;
        let first = talk.came.iter().position(|line| line.body.starts_with("ready "));
        let ok = talk.came.iter().position(|line| line.body.starts_with(&format!("ok #{}", tag.number())));
        return match (first, ok) {
            (Some(first), Some(ok)) if first < ok => ready(talk),
            _ => {
                let odd = odd.unwrap_or_else(|| "ready comes first, then ok".into());
                broken(format!("hi was answered ok, but no ready line came before it: {odd}"))
            }
        };
    }
    broken(format!("no answer within 4 s: {}", silence(&talk.first, &talk.sent)))
}

fn ready(talk: &Talk<'_>) -> Done {
    match talk.lines("ready").next().and_then(Report::parse) {
        Some(Report::Ready(ready)) if ready.protocol == super::super::PROTOCOL => Ok(()),
        Some(Report::Ready(ready)) => broken(format!("protocol {}, expected 1", ready.protocol)),
        _ => broken("the ready line is not understood".into()),
    }
}

fn typed(talk: &mut Talk<'_>) -> Done {
    for line in ["hi\n", "get kp\n", "watch events\n", "stop\n"] {
        talk.listen(120)?;
        talk.say(line.as_bytes())?;
        match talk.answer("#-", line)? {
            Ok(_) => {}
            Err(code) => return broken(format!("“{}” was answered err {code}", line.trim())),
        }
    }
    Ok(())
}

fn ends(talk: &mut Talk<'_>) -> Done {
    talk.listen(120)?;
    talk.say(b"\n\r\n\n")?;
    talk.listen(200)?;
    if let Some(line) = talk.lines("err").chain(talk.lines("ok")).next() {
        return broken(format!("empty lines were answered “{line}”"));
    }
    talk.say(b"get kp\r\n")?;
    talk.listen(300)?;
    let answers: Vec<String> = talk.lines("ok").chain(talk.lines("err")).map(Into::into).collect();
    if answers.len() != 1 || !answers.iter().all(|line| line.starts_with("ok #- ")) {
        let came = quoted(&answers);
        return broken(format!("“get kp” with CR LF must be answered by one ok #-, but {came} came"));
    }
    talk.listen(120)?;
    talk.say(b"get kp\r")?;
    talk.listen(300)?;
    if talk.lines("ok").any(|line| line.starts_with("ok #- ")) {
        return Ok(());
    }
    // What it holds is half a line to it.
    talk.say(b"\n")?;
    talk.listen(200)?;
    Err(Broken::Remark(
        "“get kp” with CR alone was not answered: screen, PuTTY and others end lines so".into(),
    ))
}

fn help(talk: &mut Talk<'_>) -> Done {
    talk.listen(120)?;
    talk.say(b"help\n")?;
    match talk.answer("#-", "help") {
        Ok(Ok(words)) if !words.is_empty() => Ok(()),
        Ok(Ok(_)) => Err(Broken::Remark("help was answered ok, without a word".into())),
        Ok(Err(code)) => Err(Broken::Remark(format!("help was answered err {code}"))),
        Err(Broken::Rule(words)) => Err(Broken::Remark(words)),
        Err(other) => Err(other),
    }
}

fn get(talk: &mut Talk<'_>, name: Name) -> Result<i64, Broken> {
    let rest = talk.must(Request::Get(name))?;
    let value = rest.strip_prefix(name.word()).and_then(|value| value.trim().parse().ok());
    value.map_or_else(
        || broken(format!("“get {0}” was answered “ok {rest}”, without {0} and its value", name.word())),
        Ok,
    )
}

/// Sends a line and expects this `err`, and that `kp` stays.
fn refused(talk: &mut Talk<'_>, line: &[u8], codes: &[&str]) -> Done {
    let before = get(talk, Name::Kp)?;
    talk.listen(120)?;
    talk.say(line)?;
    talk.listen(300)?;
    let answers: Vec<String> = talk.lines("err").chain(talk.lines("ok")).map(Into::into).collect();
    let code = |line: &String| line.strip_prefix("err ")?.split(' ').nth(1).map(String::from);
    let fits = |line: &String| code(line).is_some_and(|code| codes.contains(&code.as_str()));
    if answers.len() != 1 || !answers.iter().all(fits) {
        let (line, came) = (shown(line), quoted(&answers));
        let codes = codes.join(" or ");
        return broken(format!("“{line}” must be answered by one err {codes}, but {came} came"));
    }
    if get(talk, Name::Kp)? == before { Ok(()) } else { broken("a refused line changed kp".into()) }
}

/// A line without its end; a long one is cut.
fn shown(line: &[u8]) -> String {
    let text = readable(line.strip_suffix(b"\n").unwrap_or(line));
    if text.len() > 80 { format!("{}…", &text[..40]) } else { text }
}

fn sealed(talk: &mut Talk<'_>) -> Done {
    refused(talk, b"set kp 1\n", &["sum"])?;
    refused(talk, b"set kp 1 #3\n", &["sum"])?;
    refused(talk, b"run explore SRL\n", &["sum"])
}

fn damaged(talk: &mut Talk<'_>) -> Done {
    refused(talk, b"set kp 1 #3*00\n", &["sum"])?;
    refused(talk, b"set kp* 1 #3*00\n", &["sum"])?;
    let (_, mut bytes) = talk.sealed(Request::Set(Name::Kp, 1));
    bytes[4] |= 0x80;
    refused(talk, &bytes, &["byte", "sum"])
}

fn long(talk: &mut Talk<'_>) -> Done {
    let mut line = alloc::vec![b'a'; 700];
    line.push(b'\n');
    refused(talk, &line, &["long"])
}

fn quiet(talk: &mut Talk<'_>) -> Done {
    talk.listen(200)?;
    talk.say(&b"nonsense*00\n".repeat(30))?;
    let passed_ms = talk.listen(90)?;
    let errs = talk.lines("err").count();
    if errs as u64 > 1 + passed_ms / 100 {
        return broken(format!("{errs} err lines within {passed_ms} ms"));
    }
    talk.listen(300)?;
    for line in ["err #4 sum checksum", "ok #4", "ready 1 x y 5 5"] {
        let mut writer = Writer::new();
        let bytes = writer.word(line).seal().to_vec();
        talk.say(&bytes)?;
        talk.listen(150)?;
        if let Some(answer) = talk.lines("err").chain(talk.lines("ok")).next() {
            return broken(format!("“{line}” was answered “{answer}”"));
        }
    }
    Ok(())
}

fn unknown(talk: &mut Talk<'_>) -> Done {
    for (line, code) in [
        ("dance #3", "verb"),
        ("get speeed #3", "name"),
        ("stop now #3", "args"),
        ("watch some #3", "args"),
        ("run explore SSR #3", "args"),
        ("turns data 1 0 XYZ #3", "args"),
        ("hi  #3", "args"),
        ("turns begin 0 0 FFFF #3", "range"),
        ("turns begin 65536 0 FFFF #3", "range"),
    ] {
        let mut writer = Writer::new();
        let bytes = writer.word(line).seal().to_vec();
        refused(talk, &bytes, &[code])?;
    }
    Ok(())
}

fn settings(talk: &mut Talk<'_>) -> Done {
    for name in Name::ALL {
        let before = get(talk, name)?;
        let (least, most) = name.range();
        let other = if before == i64::from(most) { least } else { most };
        talk.must(Request::Set(name, other))?;
        let now = get(talk, name)?;
        talk.must(Request::Set(name, i32::try_from(before).unwrap_or(least)))?;
        if now != i64::from(other) {
            return broken(format!("set {} {other}, but get says {now}", name.word()));
        }
        talk.must_not(Request::Set(name, most + 1), "range")?;
        talk.must_not(Request::Set(name, least - 1), "range")?;
    }
    Ok(())
}

fn nodes(talk: &mut Talk<'_>) -> Done {
    let rest = talk.must(Request::NodesRead)?;
    let rows = talk.lines("node").count();
    if rest == format!("nodes {rows}") { Ok(()) } else { broken(format!("{rows} rows, but ok {rest}")) }
}

/// Lines with this verb in so many milliseconds or a few more; how many, and in how many.
fn count(talk: &mut Talk<'_>, level: Level, verb: &str, ms: u64) -> Result<(u64, u64), Broken> {
    talk.must(Request::Watch(level))?;
    talk.listen(200)?;
    talk.came.clear();
    let passed_ms = talk.listen(ms)?;
    Ok((talk.lines(verb).count() as u64, passed_ms))
}

fn watch(talk: &mut Talk<'_>) -> Done {
    talk.must(Request::Watch(Level::Off))?;
    talk.listen(200)?;
    talk.came.clear();
    talk.listen(1_500)?;
    if let Some(line) = talk.came.first() {
        return broken(format!("watch off, but “{}” came", line.body));
    }
    let (beats, passed_ms) = count(talk, Level::Events, "beat", 3_000)?;
    if beats.abs_diff(passed_ms / 1_000) > 1 {
        return broken(format!("{beats} beat lines in {passed_ms} ms"));
    }
    if talk.lines("ir").next().is_some() {
        return broken("watch events, but ir lines came".into());
    }
    let (irs, _) = count(talk, Level::All, "ir", 1_000)?;
    talk.must(Request::Watch(Level::Events))?;
    if irs == 0 { broken("watch all, but no ir line came within 1 s".into()) } else { Ok(()) }
}

fn lines(talk: &mut Talk<'_>) -> Done {
    match talk.strange.first() {
        None => Ok(()),
        Some(line) => broken(format!("{} lines are not, the first: “{line}”", talk.strange.len())),
    }
}
