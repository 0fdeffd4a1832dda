//! Names for programs (`next-way`, `left-hand`, `circling`) are not shown to people: they have names of their own.

use std::collections::BTreeSet;

use line_maze_lab::compare::Entrant;
use line_maze_lab::compare::league::desk::{Ask, Desk, Made, Plan, Tell, Terms, View};
use line_maze_lab::compare::score::Bests;
use line_maze_lab::compare::words::{ended, said};
use line_maze_lab::event::{Cut, Outcome, Seen};
use line_maze_lab::explorer::book::Case;
use line_maze_lab::explorer::book::narrate::narrate;
use line_maze_lab::explorer::name::Name;
use line_maze_lab::geometry::Heading;
use line_maze_lab::maze::samples::SAMPLES;
use line_maze_lab::playback::Timeline;
use line_maze_lab::report::CANNOT_START;
use line_maze_lab::run::AnyRun;
use line_maze_lab::settings::Settings;
use line_maze_lab::trace::Moment;

const OUTCOMES: [Outcome; 14] = [
    Outcome::Finish,
    Outcome::NoFinishReachable,
    Outcome::Mapped,
    Outcome::Circling { first: 1, again: 15 },
    Outcome::Stuck,
    Outcome::PathFull { capacity: 48 },
    Outcome::TableFull { capacity: 50 },
    Outcome::NoLine { node: 1, heading: Heading::South },
    Outcome::TooManyStops { limit: 96 },
    Outcome::Cut(Cut::Driving),
    Outcome::Cut(Cut::Stopped),
    Outcome::Cut(Cut::ConnectionLost),
    Outcome::Cut(Cut::Gap),
    Outcome::Cut(Cut::Misfit),
];

/// Whether a text is written as names for programs are: small letters and digits with hyphens between them.
fn is_slug(text: &str) -> bool {
    text.contains('-') && text.chars().all(|c| c.is_ascii_lowercase() || c.is_ascii_digit() || c == '-')
}

/// All of them that have a hyphen; those without are words.
fn slugs() -> BTreeSet<&'static str> {
    let seen = [Seen::Finish, Seen::DeadEnd, Seen::Corner, Seen::Straight, Seen::Node].map(Seen::name);
    let explorers = Name::ALL.iter().map(|name| name.text());
    let cases = Name::ALL.iter().flat_map(|name| name.about().cases).map(|case| case.name);
    let book = (0..10).filter_map(|index| Case::from_index(index).name());
    let all = explorers.chain(cases).chain(book).chain(seen).chain(OUTCOMES.map(Outcome::name));
    all.chain([CANNOT_START]).filter(|name| is_slug(name)).collect()
}

/// The first of them in a text, as a word of its own.
fn slug_in(text: &str) -> Option<&str> {
    let slugs = slugs();
    text.split(|c: char| !c.is_alphanumeric() && c != '-').find(|word| slugs.contains(word))
}

#[test]
fn every_name_for_programs_has_one_for_people() {
    assert!(slugs().len() > 30 && is_slug("next-way") && !is_slug("RETURN-KNOWN"));
    assert_eq!(slug_in("it ended: no-finish-reachable."), Some("no-finish-reachable"));
    let mut shown: Vec<String> = OUTCOMES.map(ended).to_vec();
    shown.extend(OUTCOMES.map(|outcome| outcome.shown().to_owned()));
    shown.extend([Seen::DeadEnd, Seen::Corner].map(|seen| seen.shown().to_owned()));
    for name in Name::ALL {
        shown.extend([name.about().title, name.short()].map(str::to_owned));
        for case in name.about().cases {
            assert_eq!(case.shown.replace(' ', "-"), case.name);
            shown.push(case.shown.to_owned());
        }
    }
    shown.extend((0..10).filter_map(|index| Case::from_index(index).shown()).map(str::to_owned));
    for text in shown {
        assert!(!text.is_empty() && slug_in(&text).is_none() && !is_slug(&text), "{text}");
        assert!(!text.contains(" = "), "{text} is no sum");
    }
}

#[test]
fn no_card_of_any_run_shows_a_name_for_programs() {
    let settings = Settings::default();
    let mut badges = BTreeSet::new();
    for sample in SAMPLES {
        let maze = sample.maze();
        let bests = Bests::of(&maze, &settings);
        for &name in Name::ALL {
            let Ok(Entrant { run, score }) = Entrant::of(&maze, &settings, name, &bests) else { continue };
            let reason = score.reason().unwrap_or_default();
            assert_eq!(slug_in(&reason), None, "{reason}");
            for stop in 0..=run.stops() {
                let told = match &run {
                    AnyRun::Book(book) => narrate(book.trace(), &book.trace().frame(Moment::after(stop))),
                    AnyRun::Other(run) => run.narrate(&run.at(stop)),
                };
                let text = format!("{} {}", told.text(), said(&run, stop));
                assert_eq!(slug_in(&text), None, "{}, {name}, stop {stop}: {text}", sample.file);
                badges.insert(told.case);
            }
        }
    }
    assert!(badges.contains("next way") && badges.contains("RETURN-KNOWN"), "{badges:?}");
    assert!(!badges.iter().any(|badge| is_slug(badge)), "{badges:?}");
}

/// What a person reads of markup.
fn read(markup: &str) -> String {
    let mut text = String::new();
    for piece in markup.split('<') {
        text.push(' ');
        text.push_str(piece.split_once('>').map_or(piece, |(_, text)| text));
    }
    text
}

#[test]
fn no_table_or_plot_of_the_league_shows_one() {
    let explorers = Name::ALL.iter().map(ToString::to_string).collect();
    let generated = Some(Made { count: 4, side: 6, loops_percent: 20, seed: 1 });
    let mut desk = Desk::default();
    let plan = Plan { explorers, terms: Terms::default(), samples: true, generated, files: vec![] };
    desk.hear(Ask::Begin(plan));
    while desk.is_busy() {
        desk.work();
    }
    let view = View { more: 9, ..View::default() };
    let Some(Tell::Shown(shown)) = desk.hear(Ask::Show(view)).pop() else { panic!() };
    assert_eq!(shown.listed, shown.runs);
    for markup in [&shown.standings, &shown.boxes, &shown.rows, &shown.absences, &shown.absent] {
        assert!(!markup.is_empty());
        let text = read(markup);
        assert_eq!(slug_in(&text), None, "{text}");
        // Samples have a label.
        let mut files = SAMPLES.iter().map(|sample| sample.file).filter(|file| is_slug(file));
        assert_eq!(files.find(|file| text.contains(file)), None, "{text}");
    }
}
