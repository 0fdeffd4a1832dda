//! What is wrong with a line that came: the line, one cause, one cure. And what nobody's answer means: the first
//! telling line of all that came.

use alloc::format;
use alloc::string::String;
use alloc::vec::Vec;

use super::super::ear::{Kind, kind};
use super::super::frame::{MAX_LINE, crc8, is_end};
use super::super::monitor::readable;
use super::super::report::Report;

/// What a robot's lines begin with.
const VERBS: [&str; 10] = ["ready", "ok", "err", "at", "do", "end", "ir", "beat", "turns", "node"];
/// A quoted line is no longer than this.
const MOST_QUOTED: usize = 60;

/// A checksum that is often taken for the right one: what it is, and how it is worked out.
type Mistaken = (&'static str, fn(&[u8]) -> u8);

const MISTAKEN: [Mistaken; 5] = [
    ("the XOR of the bytes", |body| body.iter().fold(0, |sum, byte| sum ^ byte)),
    ("the sum of the bytes", |body| body.iter().fold(0u8, |sum, byte| sum.wrapping_add(*byte))),
    ("a CRC-8 that counts the * too", |body| crc8(&[body, b"*"].concat())),
    ("a reflected CRC-8", |body| {
        body.iter().fold(0, |sum, byte| {
            (0..8).fold(sum ^ byte, |sum, _| if sum & 1 == 1 { sum >> 1 ^ 0x8C } else { sum >> 1 })
        })
    }),
    ("a CRC-8 that starts with FF", |body| {
        body.iter().fold(0xFF, |sum, byte| {
            (0..8).fold(sum ^ byte, |sum, _| if sum & 0x80 != 0 { sum << 1 ^ 7 } else { sum << 1 })
        })
    }),
];

/// What is wrong with a line of bytes.
enum Slip {
    /// It came back as it was sent.
    Echo,
    /// A line of the protocol without a checksum.
    NoSum,
    /// Its checksum is right, in lower-case hex.
    LowerCase,
    /// Its checksum is wrong.
    OtherSum,
    /// Its checksum is right, but its fields are none.
    Form,
    /// It is too long.
    Long,
    /// It is text, and nobody's protocol.
    Text,
    /// It holds bytes that no line has.
    Bytes,
}

/// What is wrong with a line, beside everything that was sent.
pub(super) fn wrong(line: &[u8], sent: &[u8]) -> String {
    let (body, sum) = halves(line);
    let right = crc8(body);
    let quoted = quote(line);
    match slip(line, sent) {
        Slip::Echo => format!(
            "“{quoted}” came back as it was sent: the other end echoes; turn its echo off, and say only what PROTOCOL.md says"
        ),
        Slip::NoSum => format!(
            "“{quoted}” has no checksum: the robot ends every line with * and two digits of upper-case hex, here *{right:02X}"
        ),
        Slip::LowerCase => format!(
            "“{quoted}” has its checksum in lower-case hex: it must be *{right:02X} (in C, %02X instead of %02x)"
        ),
        Slip::OtherSum => {
            let found = sum.and_then(value);
            let is = |(_, sum): &&Mistaken| found == Some(sum(body));
            match (MISTAKEN.iter().find(is), found) {
                (Some((name, _)), _) => format!(
                    "“{quoted}”: its checksum is {name}; it must be the CRC-8 with polynomial 07, here *{right:02X}"
                ),
                (None, Some(_)) => {
                    format!("“{quoted}” is damaged, or its checksum is wrong: here it must be *{right:02X}")
                }
                (None, None) => format!(
                    "“{quoted}”: a checksum is * and exactly two digits of upper-case hex, at the end of the line, here *{right:02X}"
                ),
            }
        }
        Slip::Form => format!(
            "“{quoted}” has the right checksum, but its fields are no line of PROTOCOL.md: compare number, order and single spaces"
        ),
        Slip::Long => format!("“{quoted}…” is longer than 80 bytes"),
        Slip::Text => format!(
            "“{quoted}” is text, but no line of this protocol: another sketch is on the board, or this one prints something of its own"
        ),
        Slip::Bytes => format!(
            "“{quoted}” holds bytes that no line has: the robot speaks at another rate, or the line is noisy"
        ),
    }
}

/// Why nobody answers: judged from all bytes that came, beside everything that was sent.
pub(super) fn silence(came: &[u8], sent: &[u8]) -> String {
    let lines: Vec<&[u8]> =
        came.split(|&byte| is_end(byte)).filter(|line| !line.iter().all(|&byte| byte == b' ')).collect();
    let Some(&first) = lines.first() else {
        return "not a byte came: is the robot switched on, is it this port, and does its sketch speak at all?"
            .into();
    };
    // The first line may be half a line, or what a reset leaves: one that tells more is better than the first, and
    // the answer to hi is best.
    let answers = lines.iter().copied().filter(|line| line.starts_with(b"ready") || line.starts_with(b"ok"));
    let mut ordered = answers.chain(lines.iter().copied());
    let good = ordered.clone().find(|line| is_good(line));
    let near = |slip: &Slip| matches!(slip, Slip::NoSum | Slip::LowerCase | Slip::OtherSum | Slip::Form);
    if let Some(line) = good {
        let line = quote(halves(line).0);
        let other = lines.iter().find(|line| is_good(line) && line.starts_with(b"ok"));
        return match other {
            Some(ok) => {
                format!("“{}” answers, but with another number than the request had", quote(halves(ok).0))
            }
            None => format!("“{line}” came, which is a line of this protocol: but hi is not answered by ok"),
        };
    }
    if let Some(line) = ordered.find(|line| near(&slip(line, sent))) {
        return wrong(line, sent);
    }
    let told = |wanted: fn(&Slip) -> bool| lines.iter().copied().find(|line| wanted(&slip(line, sent)));
    if let Some(line) = told(|slip| matches!(slip, Slip::Echo)) {
        return wrong(line, sent);
    }
    match kind(came) {
        Kind::Talks | Kind::Speaks => {
            let text = told(|slip| matches!(slip, Slip::Text | Slip::Long)).unwrap_or(first);
            wrong(text, sent)
        }
        Kind::Nothing | Kind::Noise => format!(
            "“{}” came, which is no text: the robot speaks at another rate; try --baud 9600, or the rate in its sketch's begin()",
            quote(first)
        ),
    }
}

fn is_good(line: &[u8]) -> bool {
    let (body, sum) = halves(line);
    let text = core::str::from_utf8(body).unwrap_or_default();
    sum == Some(format!("{:02X}", crc8(body)).as_bytes()) && Report::parse(text).is_some()
}

fn slip(line: &[u8], sent: &[u8]) -> Slip {
    let (body, sum) = halves(line);
    let text = core::str::from_utf8(body).unwrap_or_default();
    let known = VERBS.contains(&text.split(' ').next().unwrap_or_default());
    let right = format!("{:02X}", crc8(body));
    match sum {
        _ if !line.iter().all(|byte| matches!(byte, b' '..=b'~')) => Slip::Bytes,
        _ if sent.split(|&byte| is_end(byte)).any(|sent| !sent.is_empty() && sent == line) => Slip::Echo,
        _ if line.len() > MAX_LINE => Slip::Long,
        Some(sum) if sum == right.as_bytes() => Slip::Form,
        None if known => Slip::NoSum,
        Some(sum) if sum.eq_ignore_ascii_case(right.as_bytes()) => Slip::LowerCase,
        Some(_) if known => Slip::OtherSum,
        Some(_) | None => Slip::Text,
    }
}

/// What stands before the last `*`, and behind it.
fn halves(line: &[u8]) -> (&[u8], Option<&[u8]>) {
    match line.iter().rposition(|&byte| byte == b'*') {
        Some(at) => (&line[..at], Some(&line[at + 1..])),
        None => (line, None),
    }
}

/// Two digits of hex, in any case.
fn value(sum: &[u8]) -> Option<u8> {
    let text = core::str::from_utf8(sum).ok().filter(|text| text.len() == 2)?;
    u8::from_str_radix(text, 16).ok()
}

fn quote(line: &[u8]) -> String {
    readable(&line[..line.len().min(MOST_QUOTED)])
}
