//! Entering any executed line of any stop, with the memory as it was when that line had run.

use std::collections::{BTreeMap, BTreeSet};

use line_maze_lab::explorer::mind::Mind;
use line_maze_lab::explorer::name::Name;
use line_maze_lab::explorer::tell::Ran;
use line_maze_lab::maze::samples;
use line_maze_lab::playback::Timeline as _;
use line_maze_lab::recording::Recording;
use line_maze_lab::recording::moment::At;
use line_maze_lab::run::{AnyRun, record};
use line_maze_lab::settings::{Rule, Settings};
use line_maze_lab::trace::Moment;
use proptest::prelude::*;

use crate::support::random::{orders, recipes, roomy};

/// How a line of a listing begins, and the fields that it may change.
type Effect = (&'static str, &'static [&'static str]);

/// What each line may change, as far as it does something. A line that only asks changes nothing, and is not here.
/// What a drive has changed (`here`, `at`, `square`) is there before a stop's first line.
const EFFECTS: &[(&str, &[Effect])] = &[
    (
        "hand",
        &[
            ("if finish", &[]),
            ("else if dead end", &[]),
            ("else if corner", &[]),
            ("else:", &[]),
            ("path[n] = letter", &["path", "peak"]),
            ("x B y becomes", &["path"]),
        ],
    ),
    (
        "sum",
        &[
            ("if finish", &[]),
            ("else if at the start", &[]),
            ("else if dead end", &["j"]),
            ("else if corner", &[]),
            ("j = j + 1", &["j", "a", "peak"]),
            ("take the first", &[]),
            ("a[j] =", &["a"]),
            ("j = j - 2", &["j", "a"]),
        ],
    ),
    (
        "mapping",
        &[
            ("point = the one", &[]),
            ("if there is none: point", &["points", "places"]),
            ("one column more", &["visits"]),
            ("join it", &["points", "visits"]),
            ("if it drives to a point", &["route", "here"]),
            ("else if it has unexplored", &["target", "here"]),
            ("else find the nearest", &["target", "route", "here"]),
            ("if there is none: stop", &["target"]),
        ],
    ),
    (
        "parex",
        &[
            ("CSIP = CSIP + 1", &["path", "places", "below", "peak"]),
            ("Path(CSIP) = Path(CSIP - 1) = 0", &["path"]),
            ("Path(P + 1 .. CSIP) = 0", &["path", "places", "below"]),
            ("if finish", &[]),
            ("first way of", &["heading"]),
        ],
    ),
    (
        "cornell",
        &[
            ("maze[xpos]", &["squares", "finishes"]),
            ("1: first open", &["heading"]),
            ("2, 3: first open", &["heading"]),
            ("2: if there is none", &["heading"]),
            ("3: if there is a route", &["heading", "route"]),
            ("3: else breadth first", &[]),
            ("if there is none: stop", &[]),
            ("route = the squares", &["heading", "route"]),
        ],
    ),
    (
        "tremaux",
        &[
            ("if finish", &[]),
            ("else if the start", &[]),
            ("else if dead end", &["here"]),
            ("else if corner", &["here"]),
            ("else: one mark more", &["nodes", "places", "way", "node"]),
            ("if there were other marks", &["nodes", "here"]),
            ("else take the first way", &["nodes", "here", "taste"]),
            ("if there is none: the way", &["nodes", "here", "way"]),
            ("if there is none (at the start)", &[]),
        ],
    ),
    (
        "depth",
        &[
            ("if finish", &[]),
            ("else if the start", &[]),
            ("else if dead end", &["here"]),
            ("else if corner", &["here"]),
            ("else if the node is new", &["nodes", "places", "way", "node"]),
            ("else if it came by an unused", &["nodes", "node", "here"]),
            ("else:", &["node"]),
            ("take the first unused", &["nodes", "here", "taste"]),
            ("if there is none: back", &["way", "here"]),
            ("if there is none (at the start)", &[]),
        ],
    ),
    (
        "flood",
        &[
            ("note its walls", &["squares"]),
            ("if finish", &[]),
            ("number[goal] = 0", &["numbers"]),
            ("if its own", &[]),
            ("go to the open", &["heading"]),
        ],
    ),
];

fn effects(name: Name, line: &str) -> &'static [&'static str] {
    let name = name.text();
    let (_, lines) = EFFECTS.iter().find(|(kind, _)| name.contains(kind)).unwrap_or_else(|| panic!("{name}"));
    let text = line.trim();
    let (_, fields) = lines
        .iter()
        .filter(|(start, _)| text.starts_with(start))
        .max_by_key(|(start, _)| start.len())
        .unwrap_or_else(|| panic!("{name}: “{text}” did something that is not listed"));
    fields
}

/// The fields of a mind, by name.
fn fields(mind: &Mind) -> BTreeMap<String, String> {
    let text = format!("{mind:#?}");
    let mut fields = BTreeMap::<String, String>::new();
    let mut depth = None;
    let mut name = String::new();
    for line in text.lines() {
        let indent = line.len() - line.trim_start().len();
        // The innermost struct whose fields are the memory: `Hand(Hand {`, `Tremaux(Tremaux(Searched {`.
        if depth.is_none() && line.ends_with(" {") {
            depth = Some(indent + 4);
            continue;
        }
        if Some(indent) == depth
            && let Some((field, _)) = line.trim_start().split_once(": ")
        {
            name = field.to_owned();
        }
        if depth.is_some() {
            fields.entry(name.clone()).or_default().push_str(line.trim_end_matches(','));
        }
    }
    assert!(fields.len() > 2, "{text}");
    fields
}

fn changed(before: &Mind, after: &Mind) -> BTreeSet<String> {
    let (before, after) = (fields(before), fields(after));
    assert_eq!(before.len(), after.len());
    after.into_iter().filter(|(name, value)| before[name] != *value).map(|(name, _)| name).collect()
}

fn moment(run: &Recording, stop: u32, lines: u8) -> At {
    run.moment(Moment { stop, lines })
}

fn text(mind: &Mind) -> String {
    format!("{mind:?}")
}

fn other(maze: &line_maze_lab::maze::Maze, settings: &Settings, name: Name) -> Recording {
    match record(maze, settings, name).unwrap() {
        AnyRun::Other(run) => run,
        AnyRun::Book(_) => unreachable!(),
    }
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(24))]

    #[test]
    fn a_line_changes_what_it_says_and_the_last_one_leaves_the_stop(recipe in recipes(6), order in orders(), special in any::<bool>()) {
        let maze = recipe.maze();
        let rule = if special { Rule::Special1 } else { Rule::Basic };
        let settings = Settings { rule, ..roomy(order) };
        for &name in &Name::ALL[1..] {
            let run = other(&maze, &settings, name);
            for stop in 1..=run.stops().min(60) {
                let over = run.at(stop);
                let ready = run.at(stop - 1).mind;
                let mut last = ready.clone();
                for (count, &line) in (1u8..).zip(over.said.lines()) {
                    let (said, seen) = ready.clone().watched(over.look, count);
                    prop_assert_eq!(said, over.said, "{}", name);
                    let seen = seen.unwrap();
                    let mut changed = changed(&last, &seen.mind);
                    if count == 1 {
                        // The drive.
                        changed.retain(|field| !["here", "at", "square"].contains(&field.as_str()));
                    }
                    let listed = run.name().about().listing[usize::from(line)];
                    let may: &[&str] = match seen.ran {
                        Ran::Did => effects(name, listed),
                        Ran::Yes | Ran::No => &[],
                        // Who looks for a way by a random order draws one.
                        Ran::Nothing => &["taste"],
                    };
                    prop_assert!(changed.iter().all(|field| may.contains(&field.as_str())), "{} “{}” changed {:?}", name, listed, changed);
                    last = seen.mind;
                }
                prop_assert_eq!(text(&last), text(&over.mind), "{} stop {}", name, stop);
                prop_assert!(!over.said.lines().is_empty());
            }
        }
    }

    #[test]
    fn a_line_is_reached_the_same_forwards_and_backwards(recipe in recipes(6)) {
        for &name in &Name::ALL[1..] {
            let run = other(&recipe.maze(), &Settings::default(), name);
            let moments: Vec<(u32, u8)> = (1..=run.stops().min(40))
                .flat_map(|stop| (1..=run.lines(stop)).map(move |lines| (stop, lines)))
                .collect();
            let told = |&(stop, lines): &(u32, u8)| {
                let at = moment(&run, stop, lines);
                prop_assert_eq!((at.stop.stop, at.lines), (stop, lines));
                prop_assert_eq!(at.is_whole(), lines == run.lines(stop));
                prop_assert_eq!(at.ran_lines(), &at.stop.said.lines()[..usize::from(lines)]);
                Ok(format!("{:?} {:?} {:?} {:?}", at.mind, at.before, at.ran, run.tell(&at)))
            };
            let forwards: Vec<String> = moments.iter().map(told).collect::<Result<_, _>>()?;
            let mut backwards: Vec<String> = moments.iter().rev().map(told).collect::<Result<_, _>>()?;
            backwards.reverse();
            prop_assert_eq!(&forwards, &backwards, "{}", name);
            // What was before a line is what the line before it left; of a whole stop, the stop before.
            for pair in moments.windows(2) {
                let [here, next] = [pair[0], pair[1]].map(|(stop, lines)| moment(&run, stop, lines));
                let before = if next.is_whole() { run.at(next.stop.stop - 1).mind } else { here.mind };
                prop_assert_eq!(text(&next.before.unwrap()), text(&before), "{}", name);
            }
        }
    }

    #[test]
    fn a_line_tells_no_outcome_before_it_is_decided(recipe in recipes(5)) {
        for &name in &Name::ALL[1..] {
            let run = other(&recipe.maze(), &Settings::default(), name);
            let cases: Vec<&str> = name.about().cases.iter().map(|case| case.name).collect();
            for stop in 1..=run.stops().min(40) {
                for lines in 1..run.lines(stop) {
                    let at = moment(&run, stop, lines);
                    let told = run.tell(&at);
                    let text = told.text();
                    prop_assert!(!cases.contains(&told.case), "{}: {}", name, told.case);
                    let line = at.ran_lines().last().unwrap() + 1;
                    prop_assert!(text.contains(&format!(" Line {line} ")), "{}: {}", name, text);
                    let hole = ["{", "}", "*", "  ", "``"].iter().any(|hole| text.contains(hole));
                    prop_assert!(!hole && text.ends_with('.'), "{}: {}", name, text);
                    prop_assert!(text.split_whitespace().count() <= 45, "{}: {}", name, text);
                }
            }
        }
    }
}

/// Every line of a stop, as the stepper tells it.
fn stop(name: Name, maze: &line_maze_lab::maze::Maze, stop: u32) -> String {
    let run = other(maze, &Settings::default(), name);
    (1..=run.lines(stop))
        .map(|lines| {
            let told = run.tell(&moment(&run, stop, lines));
            format!("{}: {}\n", told.case, told.text())
        })
        .collect()
}

#[test]
fn a_stop_is_told_line_by_line() {
    let maze = samples::figure_2_4();
    let told = [
        stop(Name::LeftHand, &maze, 1),
        stop(Name::Tremaux, &maze, 1),
        stop(Name::Mapping, &maze, 1),
        stop(Name::Cornell3, &maze, 3),
    ];
    expect_test::expect![[r#"
        every stop: The robot has stopped and sees ways to the left and to the right. Line 2 asks finish: it is not so.
        every stop: The robot has stopped and sees ways to the left and to the right. Line 3 asks dead end: it is not so.
        every stop: The robot has stopped and sees ways to the left and to the right. Line 4 asks corner: it is not so.
        every stop: The robot has stopped and sees ways to the left and to the right. Line 5 is done: first way of: hand, ahead, other hand, back; add(its letter).
        add(letter): The robot has stopped and sees ways to the left and to the right. Line 8 is done: path[n] = letter; n = n + 1.
        node: Of several ways the robot takes the one nearest to its left hand: it turns left, and adds that letter. Its path is L.

        every stop: The robot has stopped and sees ways to the left and to the right. Line 2 asks finish: it is not so.
        every stop: The robot has stopped and sees ways to the left and to the right. Line 3 asks the start, a dead end: it is not so.
        every stop: The robot has stopped and sees ways to the left and to the right. Line 4 asks dead end: it is not so.
        every stop: The robot has stopped and sees ways to the left and to the right. Line 5 asks corner: it is not so.
        every stop: The robot has stopped and sees ways to the left and to the right. Line 6 is done: one mark more for the way behind.
        every stop: The robot has stopped and sees ways to the left and to the right. Line 7 asks there were other marks, and it now has one: it is not so.
        new node: By its coordinates this node is new: no way here has a mark but the one behind, which gets its first. The robot turns right, into a way without a mark: east 1, south 1, west 0.

        every stop: The robot has stopped and sees ways to the left and to the right. Line 2 finds nothing: point = the one with these coordinates, within the tolerance.
        every stop: The robot has stopped and sees ways to the left and to the right. Line 3 asks there is none: it is so, and point = Total_points; Total_points = Total_points + 1 is done.
        every stop: The robot has stopped and sees ways to the left and to the right. Line 4 is done: one column more: Point, Type, CoOr_X, CoOr_Y.
        every stop: The robot has stopped and sees ways to the left and to the right. Line 5 is done: join it to the point before; Explored = its different neighbours.
        every stop: The robot has stopped and sees ways to the left and to the right. Line 6 asks it drives to a point: it is not so.
        new point: No point has these coordinates, 0,2, so this place becomes point 1, of type 2. The robot takes its first unexplored way, east: it turns right.

        every square: The robot has stopped and sees a way ahead. Line 2 is done: maze[xpos][ypos] |= walls; visited = 1.
        unvisited: On 1,0 the robot writes 1 1010. Of its open neighbours it takes the first that was never visited: it drives straight on.
    "#]].assert_eq(&told.join("\n"));
}
