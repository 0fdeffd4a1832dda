//! Routes: the best ones from any start, turn lists and where they lead, and what the lab does with letters.
#![allow(clippy::unwrap_used, clippy::expect_used, missing_docs)]

mod random;

use line_maze_lab::geometry::{Heading, Point, Turn};
use line_maze_lab::maze::{Maze, Start, samples, text};
use line_maze_lab::route::follow::{End, Strayed, follow};
use line_maze_lab::route::{Corners, Route, TurnList, best, lab, letters};
use line_maze_lab::settings::Pace;
use proptest::prelude::*;

/// Seconds of the quickest way among those that `allowed` cells make, cell by cell, until nothing changes.
fn quickest(maze: &Maze, start: Start, pace: &Pace, allowed: u32) -> Option<f64> {
    let bounds = maze.bounds();
    let place = |at: Point, heading: Heading| bounds.index(at).unwrap() * 4 + heading as usize;
    let mut least = vec![f64::INFINITY; bounds.len() * 4];
    least[place(start.at, start.heading)] = 0.0;
    let arrived = |least: &[f64], cells: u32, arrival: &mut f64| {
        for &at in maze.finish() {
            for heading in Heading::ALL {
                let stop = if cells > 0 { pace.stop_s } else { 0.0 };
                *arrival = arrival.min(least[place(at, heading)] + stop);
            }
        }
    };
    let mut arrival = f64::INFINITY;
    arrived(&least, 0, &mut arrival);
    for cells in 1..=allowed {
        let mut next = vec![f64::INFINITY; least.len()];
        for at in bounds.points().filter(|&at| !maze.is_finish(at)) {
            for heading in Heading::ALL {
                let so_far = least[place(at, heading)];
                for way in maze.ways(at).iter().filter(|_| so_far.is_finite()) {
                    let turn = heading.turn_to(way);
                    let stops =
                        cells > 1 && (turn != Turn::Straight || maze.ways(at).count() > 2 || at == start.at);
                    let cost = so_far
                        + if stops { pace.stop_s } else { 0.0 }
                        + pace.seconds(turn)
                        + maze.scale.cell_mm() / pace.speed_mm_s;
                    let there = place(at.step(way), way);
                    next[there] = next[there].min(cost);
                }
            }
        }
        least = next;
        arrived(&least, cells, &mut arrival);
    }
    arrival.is_finite().then_some(arrival)
}

fn near(a: Option<f64>, b: Option<f64>) -> bool {
    match (a, b) {
        (Some(a), Some(b)) => (a - b).abs() < 1e-6,
        (a, b) => a == b,
    }
}

fn pace() -> impl Strategy<Value = Pace> {
    let seconds = || prop_oneof![Just(0.0), Just(0.4), 0.0..3.0];
    (50.0..1000.0, seconds(), seconds(), seconds()).prop_map(|(speed_mm_s, turn_s, uturn_s, stop_s)| Pace {
        speed_mm_s,
        turn_s,
        uturn_s,
        stop_s,
    })
}

/// A route is sound: it is along lines, its list leads to the same place by the same stops, with and without
/// corners.
fn is_sound(maze: &Maze, start: Start, route: &Route) -> Result<(), TestCaseError> {
    for corners in [Corners::LeftOut, Corners::Listed] {
        let list = route.list(corners);
        let followed = follow(maze, start, &list, corners);
        prop_assert_eq!(followed.end, End::Finish { left_over: 0 }, "{} {:?}", list, corners);
        let stops =
            |route: &Route| route.legs.iter().map(|leg| (leg.at, leg.heading, leg.turn)).collect::<Vec<_>>();
        prop_assert_eq!(stops(&followed.route), stops(route));
        prop_assert_eq!(followed.route.tally(), route.tally());
    }
    let points: Vec<Point> = [start.at].into_iter().chain(route.legs.iter().map(|leg| leg.at)).collect();
    let through = Route::through(maze, start, &points);
    prop_assert_eq!(through.as_ref(), Some(route));
    Ok(())
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 300, failure_persistence: None, ..ProptestConfig::default() })]

    #[test]
    fn the_best_routes_from_any_start_are_the_best(maze in random::maze(1), pace in pace()) {
        prop_assume!(maze.bounds().len() < 50);
        let Some(start) = maze.start() else { return Ok(()) };
        let all = maze.bounds().len() as u32 * 2;
        let shortest = best::shortest(&maze, start, &pace);
        let fastest = best::fastest(&maze, start, &pace);
        let least = (0..=all / 2).find(|&cells| quickest(&maze, start, &pace, cells).is_some());
        prop_assert_eq!(shortest.map(|best| best.cells), least);
        let slow = least.and_then(|cells| quickest(&maze, start, &pace, cells));
        prop_assert!(near(shortest.map(|best| best.seconds), slow), "{:?} {:?}", shortest, slow);
        let slow = quickest(&maze, start, &pace, all);
        prop_assert!(near(fastest.map(|best| best.seconds), slow), "{:?} {:?}", fastest, slow);
        for route in [best::shortest_route(&maze, start, &pace), best::fastest_route(&maze, start, &pace)] {
            if let Some(route) = route.filter(|route| !route.legs.is_empty()) {
                is_sound(&maze, start, &route)?;
            }
        }
    }

    #[test]
    fn reductions_take_the_first_dead_end_each_time(letters in "[LSRB]{0,60}") {
        let list: TurnList = letters.parse().unwrap();
        let (steps, end) = lab::reductions(&list);
        let mut by_hand = list.clone();
        for (nth, step) in steps.iter().enumerate() {
            prop_assert_eq!(lab::first(by_hand.turns()), Some(*step));
            by_hand = lab::after(&list, &steps[..=nth]);
            prop_assert_eq!(by_hand.turns().len(), letters.len() - 2 * (nth + 1));
        }
        prop_assert_eq!(&by_hand, &end);
        prop_assert_eq!(lab::first(end.turns()), None);
        let sum = |list: &TurnList| list.turns().iter().fold(Heading::North, |heading, &turn| heading.turned(turn));
        prop_assert_eq!(sum(&list), sum(&end), "no reduction changes where the robot faces");
        prop_assert_eq!(lab::reverse(&lab::reverse(&list)), list);
    }

    #[test]
    fn following_any_letters_ends_somewhere(maze in random::maze(1), letters in "[LSRB]{0,40}") {
        let list: TurnList = letters.parse().unwrap();
        let Some(start) = maze.start() else { return Ok(()) };
        for corners in [Corners::LeftOut, Corners::Listed] {
            let followed = follow(&maze, start, &list, corners);
            let here = followed.route.legs.last().map_or(start.at, |leg| leg.at);
            match followed.end {
                End::Finish { left_over } => prop_assert!(maze.is_finish(here) && left_over <= letters.len()),
                End::Strayed(
                    Strayed::NoWay { at } | Strayed::NoLine { at, .. } | Strayed::DeadEnd { at }
                    | Strayed::ListTooShort { at },
                ) => prop_assert_eq!(at, here),
                End::Strayed(strayed @ Strayed::CannotStart(_)) => prop_assert!(false, "{}", strayed),
            }
        }
    }
}

/// The table of the hand rule's simplification.
#[test]
fn three_letters_become_their_sum() {
    for (three, one) in [
        ("LBL", "S"),
        ("LBS", "R"),
        ("RBL", "B"),
        ("SBL", "R"),
        ("SBS", "B"),
        ("LBR", "B"),
        ("RBR", "S"),
        ("RBS", "L"),
        ("SBR", "L"),
    ] {
        let (steps, end) = lab::reductions(&three.parse().unwrap());
        assert_eq!((steps.len(), end.to_string().as_str()), (1, one), "{three}");
    }
}

#[test]
fn the_way_back_leads_home() {
    let maze = samples::figure_3_1();
    let start = maze.start().unwrap();
    let mut back = maze.clone();
    assert!(back.set_finish(vec![start.at]));
    let from = Start { at: maze.finish()[0], heading: Heading::North };
    let list = lab::reverse(&"SSR".parse().unwrap());
    assert_eq!(list.to_string(), "LSS");
    let route = Route::drive_from(&back, from, &list).unwrap();
    assert_eq!(route.cells(), Route::drive(&maze, &"SSR".parse().unwrap()).unwrap().cells());
}

/// On figure 3.1: where letters lead that do not lead to the finish.
#[test]
fn where_a_list_leads_is_said_with_its_place() {
    let maze = samples::figure_3_1();
    let ends = |letters: &str| {
        let list = letters::read(letters).unwrap();
        match follow(&maze, maze.start().unwrap(), &list, Corners::LeftOut).end {
            End::Finish { left_over } => format!("finish, {left_over} left"),
            End::Strayed(strayed) => strayed.to_string(),
        }
    };
    assert_eq!(ends("ssr"), "finish, 0 left");
    assert_eq!(ends("ssrs"), "finish, 1 left");
    assert_eq!(ends("l"), "the turn list leads off the line after letter 1, at 0,1");
    assert_eq!(ends(""), "the turn list has no letter for the node at 0,1");
    assert_eq!(ends("rsl"), "the turn list leads to the dead end 4,2");
    assert_eq!(ends("rslbl"), "the turn list has no letter for the node at 6,1");
}

/// A ring without nodes: each time it comes over its start, the robot wants a letter.
#[test]
fn the_start_takes_a_letter_each_time() {
    let ring = "line-maze: 1\n\n+---+---+\n|       |\n^---+---+\n";
    let maze = text::parse(ring).unwrap();
    let end = |letters: &str| {
        let followed = follow(&maze, maze.start().unwrap(), &letters.parse().unwrap(), Corners::LeftOut);
        (followed.route.cells(), followed.end)
    };
    let too_short = End::Strayed(Strayed::ListTooShort { at: Point::new(0, 0) });
    assert_eq!([end("S"), end("SR"), end("R")], [(6, too_short), (12, too_short), (6, too_short)]);
}

/// A staircase with a turn at every cell, and a longer way round it with two.
#[test]
fn the_quickest_need_not_be_the_shortest() {
    let text = "line-maze: 1\nstart: 0,0 N\nfinish: 4,4\n\nlines:\n0,0 0,5 4,5 4,4\n\
                0,1 1,1 1,2 2,2 2,3 3,3 3,4 4,4\n";
    let maze = text::parse(text).unwrap();
    let start = maze.start().unwrap();
    let both = |pace: Pace| {
        let list = |route: Option<Route>| {
            let route = route.unwrap();
            (route.cells(), route.list(Corners::LeftOut).to_string(), route.tally().right_turns)
        };
        (list(best::shortest_route(&maze, start, &pace)), list(best::fastest_route(&maze, start, &pace)))
    };
    let (shortest, fastest) = both(Pace::default());
    assert_eq!(shortest, (8, "R".to_owned(), 4));
    assert_eq!(fastest, (10, "S".to_owned(), 2));
    let (shortest, fastest) = both(Pace { turn_s: 0.1, ..Pace::default() });
    assert_eq!(shortest, fastest, "who turns quickly takes the stairs");
}
