//! Share links: what goes in comes out, and a link that was cut, changed or invented is found out.
#![allow(clippy::unwrap_used, missing_docs)]

mod random;

use base64::Engine;
use base64::engine::general_purpose::URL_SAFE_NO_PAD;
use crc::{CRC_32_ISO_HDLC, Crc};
use line_maze_lab::explorer::name::Name;
use line_maze_lab::maze::generate::{Recipe, generate};
use line_maze_lab::maze::samples::{self, SAMPLES};
use line_maze_lab::settings::{Order, Pace, Preference, Rule, Search, Settings};
use line_maze_lab::share::{MAX_LINK, ShareError, Shared, decode, encode};
use proptest::prelude::*;

fn settings() -> impl Strategy<Value = Settings> {
    let order = prop_oneof![
        (0..6_usize).prop_map(|nth| Order::Fixed(Preference::ALL[nth])),
        any::<u64>().prop_map(Order::Random),
    ];
    let pace = prop_oneof![
        Just(Pace::default()),
        (0.1..1e6_f64, 0.0..9.0_f64).prop_map(|(speed_mm_s, turn_s)| Pace {
            speed_mm_s,
            turn_s,
            ..Pace::default()
        }),
    ];
    let rule = prop_oneof![Just(Rule::Basic), Just(Rule::Special1)];
    let search = prop_oneof![Just(Search::Dijkstra), Just(Search::AStar)];
    let numbers = (any::<Option<u32>>(), any::<u32>(), any::<Option<u32>>());
    (order, numbers, pace, rule, search).prop_map(
        |(order, (epsilon_ms, node_max, path_max), pace, rule, search)| Settings {
            order,
            epsilon_ms,
            node_max,
            pace,
            rule,
            path_max,
            search,
        },
    )
}

/// The book's explorer as often as all others.
fn explorer() -> impl Strategy<Value = Name> {
    prop_oneof![Just(Name::Book), (0..Name::ALL.len()).prop_map(|nth| Name::ALL[nth])]
}

fn shared() -> impl Strategy<Value = Shared> {
    (random::maze(200), settings(), explorer(), any::<u32>(), any::<bool>()).prop_map(
        |(maze, settings, explorer, stop, solved)| Shared { maze, settings, explorer, stop, solved },
    )
}

fn figure_3_1() -> String {
    encode(&Shared {
        maze: samples::figure_3_1(),
        settings: Settings::default(),
        explorer: Name::Book,
        stop: 13,
        solved: false,
    })
    .unwrap()
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(1000))]

    #[test]
    fn what_goes_in_comes_out(shared in shared()) {
        prop_assert_eq!(decode(&encode(&shared).unwrap()), Ok(shared));
    }

    /// Even a payload with a fitting checksum is refused, unless [`encode`] could have made it.
    #[test]
    fn whatever_opens_is_what_would_be_written(shared in shared(), at in any::<prop::sample::Index>(), byte: u8) {
        let mut bytes = URL_SAFE_NO_PAD.decode(encode(&shared).unwrap()).unwrap();
        let body = bytes.len() - 4;
        bytes[3..body][at.index(body - 3)] = byte;
        let checksum = Crc::<u32>::new(&CRC_32_ISO_HDLC).checksum(&bytes[..body]);
        bytes[body..].copy_from_slice(&checksum.to_be_bytes());
        let payload = URL_SAFE_NO_PAD.encode(bytes);
        if let Ok(shared) = decode(&payload) {
            prop_assert_eq!(encode(&shared), Ok(payload));
        }
    }
}

#[test]
fn every_cut_is_found() {
    let payload = figure_3_1();
    for got in 0..payload.len() {
        match decode(&payload[..got]) {
            Err(ShareError::CutOff { got: said, expected }) => {
                assert_eq!(said, got);
                assert_eq!(expected.is_none(), got < 4);
                assert!(expected.is_none_or(|expected| expected == payload.len()));
            }
            other => panic!("{got}: {other:?}"),
        }
    }
    assert_eq!(decode(&format!("{payload}A")), Err(ShareError::Damaged));
}

#[test]
fn every_changed_character_is_found() {
    let payload = figure_3_1();
    let alphabet = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789-_";
    for at in 0..payload.len() {
        for character in alphabet.chars().filter(|&c| !payload[at..].starts_with(c)) {
            let mut changed = payload.clone();
            changed.replace_range(at..=at, &character.to_string());
            assert!(decode(&changed).is_err(), "{character} at {at}");
        }
        let mut foreign = payload.clone();
        foreign.replace_range(at..=at, "%");
        assert_eq!(decode(&foreign), Err(ShareError::NotALink));
    }
}

#[test]
fn all_samples_fit_a_link_and_the_largest_maze_does_not() {
    let with =
        |maze| Shared { maze, settings: Settings::default(), explorer: Name::Book, stop: 0, solved: false };
    for sample in SAMPLES {
        let payload = encode(&with(sample.maze())).unwrap();
        assert!(payload.len() < 1000, "{}: {} characters", sample.file, payload.len());
    }
    let recipe = Recipe { width: 150, height: 150, ..Recipe::default() };
    assert!(encode(&with(generate(&recipe).unwrap())).unwrap().len() <= MAX_LINK);
    let recipe = Recipe { width: 1000, height: 1000, ..Recipe::default() };
    let error = encode(&with(generate(&recipe).unwrap())).unwrap_err();
    assert!(matches!(error, ShareError::TooBig { characters: 333_000..334_000 }), "{error}");
    assert_eq!(decode(&"A".repeat(MAX_LINK + 1)), Err(ShareError::TooBig { characters: MAX_LINK + 1 }));
}

#[test]
fn errors_say_what_to_do() {
    let payload = figure_3_1();
    let says = |payload: &str| decode(payload).unwrap_err().to_string();
    assert_eq!(
        says(&payload[..100]),
        format!("This link breaks off after 100 of {} characters. Copy all of it.", payload.len())
    );
    assert_eq!(says("AQ"), "This link breaks off after 2 characters. Copy all of it.");
    assert_eq!(
        ShareError::CutOff { got: 1204, expected: Some(1377) }.to_string(),
        "This link breaks off after 1,204 of 1,377 characters. Copy all of it."
    );
    assert_eq!(
        says("https://example.org"),
        "This is not a link of Line Maze Lab: it has characters that none would have."
    );
    assert_eq!(
        says("BA____"),
        "This link is of version 4, and only versions 1 to 3 can be opened. Load the page anew to get the latest."
    );
    assert_eq!(
        says(&payload.replacen("VGhl", "VGhm", 1)),
        "This link is damaged: its checksum does not fit. Copy it again, or ask for it once more."
    );
    assert_eq!(
        ShareError::TooBig { characters: 1_333_512 }.to_string(),
        "A link holds at most 8,000 characters, and this one would need 1,333,512. Pass the maze on as a file instead."
    );
}

/// A payload is forever: links that were handed out must still open.
#[test]
fn old_links_open() {
    let shared = decode(include_str!("fixtures/share/figure-3-1.txt").trim()).unwrap();
    assert_eq!(shared.stop, 13);
    assert_eq!(shared.explorer, Name::Book);
    assert_eq!(shared.maze.finish(), samples::figure_3_1().finish());
    // And nothing new makes them longer.
    assert_eq!(figure_3_1(), include_str!("fixtures/share/figure-3-1.txt").trim());
}

/// Links of version 2 tell who drives; nothing that version 1 can tell is written so.
#[test]
fn a_link_tells_the_explorer() {
    for &explorer in Name::ALL {
        let settings = Settings { path_max: Some(48), rule: Rule::Basic, ..Settings::default() };
        let shared = Shared {
            maze: samples::figure_2_4(),
            settings,
            explorer,
            stop: 3,
            solved: explorer == Name::Mapping,
        };
        assert_eq!(decode(&encode(&shared).unwrap()), Ok(shared));
    }
    let mut bytes = URL_SAFE_NO_PAD.decode(figure_3_1()).unwrap();
    let body = bytes.len() - 4;
    bytes.splice(body.., [0, 0, 0, 0]);
    (bytes[0], bytes[2]) = (2, bytes[2] + 4);
    let checksum = Crc::<u32>::new(&CRC_32_ISO_HDLC).checksum(&bytes);
    bytes.extend(checksum.to_be_bytes());
    assert_eq!(decode(&URL_SAFE_NO_PAD.encode(bytes)), Err(ShareError::Damaged));
}
