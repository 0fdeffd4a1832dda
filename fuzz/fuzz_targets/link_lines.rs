//! Any bytes on the wire: lines are cut out, and what is understood is written again as it was.
#![no_main]

use libfuzzer_sys::fuzz_target;
use line_maze_lab::link::frame::{Decoder, Heard, Line, MAX_LINE, Sum, crc8};
use line_maze_lab::link::report::Report;
use line_maze_lab::link::request::Asked;

fuzz_target!(|bytes: &[u8]| {
    let mut decoder = Decoder::new();
    for &byte in bytes {
        if let Heard::Line(line) = decoder.push(byte) {
            assert!(line.body.len() <= MAX_LINE);
            check(line);
        }
    }
    // A CR ends a line as an LF does.
    let with_lf: Vec<u8> = bytes.iter().map(|&byte| if byte == b'\r' { b'\n' } else { byte }).collect();
    assert_eq!(heard(bytes), heard(&with_lf));
    // Chance alone would hardly ever find a checksum.
    for line in bytes.split(|&byte| byte == b'\n').filter(|line| line.len() <= MAX_LINE - 3) {
        if let Ok(body) = core::str::from_utf8(line)
            && line.iter().all(|byte| matches!(byte, b' '..=b'~') && *byte != b'*')
            && !line.is_empty()
        {
            let mut decoder = Decoder::new();
            let sealed = format!("{body}*{:02X}\n", crc8(line));
            let mut heard = 0;
            for byte in sealed.bytes() {
                if let Heard::Line(line) = decoder.push(byte) {
                    assert_eq!(line, Line { body, sum: Sum::Right });
                    check(line);
                    heard += 1;
                }
            }
            assert_eq!(heard, 1);
        }
    }
});

/// What is made of bytes, in words.
fn heard(bytes: &[u8]) -> Vec<String> {
    let mut decoder = Decoder::new();
    bytes.iter().map(|&byte| format!("{:?}", decoder.push(byte))).collect()
}

/// What is understood survives a round trip.
fn check(line: Line<'_>) {
    if let Some(report) = Report::parse(line.body) {
        let again = report.write().seal().to_vec();
        assert_eq!(Report::parse(body(&again)), Some(report));
    }
    if let Ok(asked) = Asked::parse(line) {
        let again = asked.write().seal().to_vec();
        assert_eq!(Asked::parse(Line { body: body(&again), sum: Sum::Right }), Ok(asked));
    }
}

fn body(sealed: &[u8]) -> &str {
    core::str::from_utf8(sealed).ok().and_then(|line| line.split('*').next()).unwrap_or_default()
}
