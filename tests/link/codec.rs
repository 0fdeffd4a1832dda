//! Lines and messages: cut anywhere, damaged anywhere, made of anything.

use line_maze_lab::geometry::{Heading, Turn, Ways};
use line_maze_lab::link::frame::{Decoder, Heard, Line, LineError, MAX_LINE, Sum};
use line_maze_lab::link::report::{
    Beat, Chose, Code, End, Ended, Ir, Kind, NodeLine, Origin, Reached, Ready, Report, Said, TYPED,
};
use line_maze_lab::link::request::{Asked, Level, Request, Upload};
use line_maze_lab::link::tune::Name;
use line_maze_lab::link::{Letters, Tag};
use proptest::prelude::*;

use crate::support::random::orders;

/// What a decoder makes of bytes.
fn heard(bytes: &[u8]) -> Vec<Result<(String, Sum), LineError>> {
    let mut decoder = Decoder::new();
    let mut heard = Vec::new();
    for &byte in bytes {
        match decoder.push(byte) {
            Heard::Nothing => {}
            Heard::Line(line) => heard.push(Ok((line.body.to_owned(), line.sum))),
            Heard::Bad(error) => heard.push(Err(error)),
        }
    }
    heard
}

fn names() -> impl Strategy<Value = Name> {
    proptest::sample::select(&Name::ALL[..])
}

fn letters() -> impl Strategy<Value = String> {
    "[SRLB]{1,40}"
}

/// Every kind of request; the letters are leaked, as requests borrow them.
fn requests() -> impl Strategy<Value = Request<'static>> {
    prop_oneof![
        proptest::sample::select(vec![
            Request::Hi,
            Request::Help,
            Request::TurnsRead,
            Request::RunRoute,
            Request::Stop,
            Request::Place,
            Request::NodesRead,
            Request::Watch(Level::Off),
            Request::Watch(Level::Events),
            Request::Watch(Level::All),
        ]),
        (1u16.., any::<(u16, u16)>()).prop_map(|(id, (len, crc))| Request::TurnsBegin(Upload {
            id,
            len,
            crc
        })),
        (1u16.., any::<u16>(), letters()).prop_map(|(id, offset, letters)| {
            let letters = Letters::new(Box::leak(letters.into_boxed_str())).unwrap();
            Request::TurnsData { id, offset, letters }
        }),
        (1u16..).prop_map(|id| Request::TurnsCommit { id }),
        orders().prop_map(Request::Explore),
        names().prop_map(Request::Get),
        (names(), any::<i32>()).prop_map(|(name, value)| Request::Set(name, value)),
    ]
}

fn tags() -> impl Strategy<Value = Option<Tag>> {
    proptest::option::of((0u32..100).prop_map(Tag::new))
}

fn ways() -> impl Strategy<Value = Ways> {
    (0u8..16).prop_map(Ways::from_bits)
}

fn turns() -> impl Strategy<Value = Option<Turn>> {
    proptest::option::of((0u8..4).prop_map(Turn::from_index))
}

fn reports() -> impl Strategy<Value = Report<'static>> {
    let kinds = vec![Kind::New, Kind::Known, Kind::Unknown, Kind::Corner, Kind::DeadEnd, Kind::Finish];
    let ends = vec![End::Finish, End::NoFinishReachable, End::TableFull, End::Lost, End::Stopped];
    let origins = proptest::sample::select(vec![Origin::Sent, Origin::Learned]);
    let said = prop_oneof![
        Just(Said::Nothing),
        Just(Said::Typed),
        any::<u16>().prop_map(Said::Nodes),
        (names(), any::<i32>()).prop_map(|(name, value)| Said::Setting(name, value)),
    ];
    prop_oneof![
        any::<(u16, u16)>().prop_map(|(nodes, turns)| {
            Report::Ready(Ready { protocol: 1, firmware: "lab-0.1.0", board: "demo", nodes, turns })
        }),
        (tags(), said).prop_map(|(tag, said)| Report::Ok(tag, said)),
        (tags(), proptest::sample::select(&Code::ALL[..])).prop_map(|(tag, code)| Report::Err(tag, code)),
        (any::<(u32, u16, i32, i32)>(), proptest::sample::select(kinds), ways()).prop_map(
            |((ms, node, x, y), kind, ways)| {
                Report::At(Reached { ms, kind, node, ways: ways.without(Heading::South), x, y })
            }
        ),
        (any::<(u32, u16, bool)>(), turns()).prop_map(|((ms, ptr, returning), turn)| Report::Do(Chose {
            ms,
            turn,
            ptr,
            returning
        })),
        (any::<u32>(), proptest::sample::select(ends)).prop_map(|(ms, end)| Report::End(Ended { ms, end })),
        any::<(u32, u16, [u16; 5], i16, i16, i16)>().prop_map(|(ms, line, sensors, error, left, right)| {
            Report::Ir(Ir { ms, line, sensors, error, left, right })
        }),
        any::<(u32, u16)>().prop_map(|(ms, millivolts)| Report::Beat(Beat { ms, millivolts })),
        (any::<(u16, u16, u16)>(), origins).prop_map(|((id, len, crc), origin)| Report::TurnsHave {
            id,
            len,
            crc,
            origin
        }),
        (1u16.., any::<u16>(), letters()).prop_map(|(id, offset, letters)| {
            let letters = Letters::new(Box::leak(letters.into_boxed_str())).unwrap();
            Report::TurnsData { id, offset, letters }
        }),
        (any::<(u16, i32, i32)>(), ways(), ways(), 0u8..4, proptest::option::of(0u8..4)).prop_map(
            |((node, x, y), paths, vpaths, back, last)| {
                Report::Node(NodeLine {
                    node,
                    x,
                    y,
                    paths,
                    vpaths,
                    back_path: Heading::from_index(back),
                    last_path: last.map(Heading::from_index),
                })
            }
        ),
    ]
}

/// What the page understands of bytes.
fn reported(bytes: &[u8]) -> Vec<String> {
    let line = |heard: Result<(String, Sum), LineError>| match heard {
        Ok((body, Sum::Right)) => Report::parse(&body).map(|report| format!("{report:?}")),
        Ok((_, Sum::Missing)) | Err(_) => None,
    };
    heard(bytes).into_iter().filter_map(line).collect()
}

/// What the robot understands of bytes.
fn asked(bytes: &[u8]) -> Vec<(String, bool)> {
    let mut decoder = Decoder::new();
    let mut asked = Vec::new();
    for &byte in bytes {
        if let Heard::Line(line) = decoder.push(byte)
            && let Ok(request) = Asked::parse(line)
        {
            asked.push((format!("{request:?}"), request.request.may_be_typed()));
        }
    }
    asked
}

#[test]
fn the_checksums_of_the_specification() {
    assert_eq!(heard(b"hi*45\r\n"), [Ok(("hi".to_owned(), Sum::Right))]);
    assert_eq!(heard(b"hi\n"), [Ok(("hi".to_owned(), Sum::Missing))]);
    assert_eq!(heard(b"hi*46\n"), [Err(LineError::Sum { found: 0x46, right: 0x45 })]);
    assert_eq!(heard(b"hi*4\nhi*455\nh*i*45\nhi*4f\n"), vec![Err(LineError::Star); 4]);
    assert_eq!(heard(b"\n\r\n\n\r\r\n\r"), []);
    assert_eq!(heard(b"h\x80i\n"), [Err(LineError::Byte(0x80))]);
}

#[test]
fn a_line_too_long_is_told_once_and_dropped() {
    let mut bytes = vec![b'a'; MAX_LINE];
    bytes.extend(b"\n");
    assert_eq!(heard(&bytes), [Ok(("a".repeat(MAX_LINE), Sum::Missing))]);
    let mut bytes = vec![b'a'; 10 * MAX_LINE];
    bytes.extend(b"\nhi\n");
    assert_eq!(heard(&bytes), [Err(LineError::TooLong), Ok(("hi".to_owned(), Sum::Missing))]);
}

#[test]
fn a_line_ends_as_programs_and_terminals_end_it() {
    for end in ["\n", "\r", "\r\n", "\n\r", "\r\r\n"] {
        let bytes = format!("hi*45{end}get kp{end}hi*46{end}{end}");
        let came = heard(bytes.as_bytes());
        let hi = Ok(("hi".to_owned(), Sum::Right));
        let bad = Err(LineError::Sum { found: 0x46, right: 0x45 });
        assert_eq!(came, [hi, Ok(("get kp".to_owned(), Sum::Missing)), bad], "{end:?}");
    }
    // A line is over at its CR, not at the LF that may never come.
    let mut decoder = Decoder::new();
    let came: Vec<bool> = b"hi\r\n".iter().map(|&byte| decoder.push(byte) != Heard::Nothing).collect();
    assert_eq!(came, [false, false, true, false]);
    // What is too long or spoilt ends there too.
    let long = [vec![b'a'; 200], b"\rhi\r".to_vec()].concat();
    assert_eq!(heard(&long), [Err(LineError::TooLong), Ok(("hi".to_owned(), Sum::Missing))]);
    assert_eq!(heard(b"h\x80\rhi\r"), [Err(LineError::Byte(0x80)), Ok(("hi".to_owned(), Sum::Missing))]);
}

#[test]
fn help_names_what_may_be_typed_and_nothing_else() {
    let verbs = TYPED.replace("NAME", "kp").replace("LEVEL", "all");
    for line in verbs.split(", ") {
        assert_eq!(asked(format!("{line}\r").as_bytes()).len(), 1, "{line}");
    }
    let names = |line: &str| TYPED.split(", ").any(|told| told.split(' ').next() == line.split(' ').next());
    for line in ["hi", "stop", "get kp", "watch all", "place", "turns read", "nodes read"] {
        assert!(names(line), "{line}");
    }
}

#[test]
fn a_number_out_of_its_range_is_told_apart_from_what_is_no_number() {
    fn code(body: &str) -> Result<Asked<'_>, Code> {
        Asked::parse(Line { body, sum: Sum::Right }).map_err(|no| no.code)
    }
    for line in [
        "turns begin 0 3 EA59 #1",
        "turns begin 65536 3 EA59 #1",
        "turns begin 1 65536 EA59 #1",
        "turns data 0 0 SRL #1",
        "turns commit 0 #1",
        "turns commit -1 #1",
        "set kp 4294967296 #1",
    ] {
        assert_eq!(code(line), Err(Code::Range), "{line}");
    }
    for line in ["turns begin x 3 EA59 #1", "turns begin 1 3 EA5 #1", "turns commit #1", "set kp 1e3 #1"] {
        assert_eq!(code(line), Err(Code::Args), "{line}");
    }
    assert!(code("turns begin 65535 0 FFFF #1").is_ok());
}

#[test]
fn what_is_typed_may_only_ask() {
    for line in ["hi", "help", "stop", "get kp", "watch all", "place", "turns read", "nodes read"] {
        assert_eq!(asked(format!("{line}\n").as_bytes()).len(), 1, "{line}");
    }
    for line in ["set kp 1", "run explore SRL", "run route", "turns begin 1 0 FFFF", "turns commit 1"] {
        assert_eq!(asked(format!("{line}\n").as_bytes()), [], "{line}");
    }
}

#[test]
fn names_of_more_than_16_letters_are_no_names() {
    assert!(Report::parse("ready 1 sixteen-letters1 uno 50 400").is_some());
    assert_eq!(Report::parse("ready 1 seventeen-letters uno 50 400"), None);
}

proptest! {
    #[test]
    fn requests_survive_a_round_trip(request in requests(), tag in tags()) {
        let written = Asked { tag, request };
        let bytes = written.write().seal().to_vec();
        prop_assert!(bytes.len() <= MAX_LINE + 1);
        prop_assert_eq!(asked(&bytes), [(format!("{written:?}"), request.may_be_typed())]);
    }

    #[test]
    fn reports_survive_a_round_trip(report in reports()) {
        let bytes = report.write().seal().to_vec();
        prop_assert!(bytes.len() <= MAX_LINE + 1);
        prop_assert_eq!(reported(&bytes), [format!("{report:?}")]);
    }

    /// The bytes before and after a cut give what the whole gives: a decoder knows nothing of pieces.
    #[test]
    fn rubbish_never_panics_and_a_good_line_after_it_is_heard(rubbish: Vec<u8>, report in reports()) {
        let mut bytes = rubbish;
        bytes.push(b'\n');
        bytes.extend(report.write().seal());
        prop_assert_eq!(reported(&bytes).pop(), Some(format!("{report:?}")));
    }

    /// Ends of line are all one, and more of them are no more lines.
    #[test]
    fn every_end_of_line_is_the_same(
        lines in proptest::collection::vec("[ -~]{0,90}", 0..6),
        ends in proptest::collection::vec(proptest::sample::select(vec!["\r", "\n", "\r\n", "\n\r", "\r\n\r\n"]), 6),
    ) {
        let with_lf: String = lines.iter().map(|line| format!("{line}\n")).collect();
        let with_any: String = lines.iter().zip(ends).map(|(line, end)| format!("{line}{end}")).collect();
        prop_assert_eq!(heard(with_any.as_bytes()), heard(with_lf.as_bytes()));
    }

    #[test]
    fn a_flipped_byte_is_found_by_the_page(report in reports(), at: prop::sample::Index, flip in 1u8..) {
        let mut bytes = report.write().seal().to_vec();
        let at = at.index(bytes.len());
        bytes[at] ^= flip;
        // A line that has lost its LF is a part of the next one.
        bytes.extend(b"\n");
        // An LF that has become a CR is an end of line all the same: then nothing is lost.
        let other = reported(&bytes).into_iter().find(|heard| *heard != format!("{report:?}"));
        prop_assert_eq!(other, None, "{:?}", String::from_utf8_lossy(&bytes));
    }

    #[test]
    fn a_flipped_byte_never_changes_a_robot(request in requests(), tag in tags(), at: prop::sample::Index, flip in 1u8..) {
        let written = Asked { tag, request };
        let mut bytes = written.write().seal().to_vec();
        let at = at.index(bytes.len());
        bytes[at] ^= flip;
        bytes.extend(b"\n");
        for (heard, harmless) in asked(&bytes) {
            prop_assert!(harmless || heard == format!("{written:?}"), "{} from {}", heard, String::from_utf8_lossy(&bytes));
        }
    }
}
