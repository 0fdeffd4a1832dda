//! What must be true of every run on any maze: laws that tie the explorers to the maze and to each other.

use std::collections::{BTreeMap, BTreeSet, VecDeque};

use line_maze_lab::event::Outcome;
use line_maze_lab::explorer::mapping::search::{Aim, Search};
use line_maze_lab::explorer::mind::Mind;
use line_maze_lab::explorer::name::Name;
use line_maze_lab::explorer::squares::{Aim as Sought, Squares, VISITED, wall};
use line_maze_lab::explorer::sums;
use line_maze_lab::geometry::{Heading, Point, Turn};
use line_maze_lab::maze::generate::{Recipe as Generated, generate};
use line_maze_lab::maze::{Maze, Start};
use line_maze_lab::recording::{Cursor, Recording};
use line_maze_lab::report::Report;
use line_maze_lab::route::{TurnList, best};
use line_maze_lab::run::{AnyRun, explore, record};
use line_maze_lab::settings::{self, Order, Settings};
use line_maze_lab::world::line_start;
use proptest::prelude::*;

use crate::hands::recording;
use crate::map::mapped;
use crate::support::random::{Recipe, orders, recipes, roomy};

/// Any maze of the recipe; in every second one the robot is put down anywhere, facing anywhere.
fn anywhere() -> impl Strategy<Value = Maze> {
    (recipes(9), any::<prop::sample::Index>(), 0u8..8).prop_map(|(recipe, place, heading)| {
        let mut maze = recipe.maze();
        if heading < 4 {
            let at = maze.bounds().point(place.index(maze.bounds().len()));
            maze.set_start(Some(Start { at, heading: Heading::from_index(heading) }));
        }
        maze
    })
}

/// Cells from the start to each point that can be reached.
fn distances(maze: &Maze) -> BTreeMap<Point, u32> {
    let start = maze.start().unwrap().at;
    let mut far = BTreeMap::from([(start, 0)]);
    let mut todo = VecDeque::from([start]);
    while let Some(at) = todo.pop_front() {
        for heading in maze.ways(at).iter() {
            let next = at.step(heading);
            if !far.contains_key(&next) {
                far.insert(next, far[&at] + 1);
                todo.push_back(next);
            }
        }
    }
    far
}

/// The graph that a map of this maze must be: points where a line robot stops, and the lines between them.
fn graph(maze: &Maze) -> BTreeMap<Point, BTreeSet<Point>> {
    let start = maze.start().unwrap().at;
    let is_point = |at: Point| {
        let ways = maze.ways(at);
        let straight = |h: Heading| ways.count() == 2 && ways.has(h) && ways.has(h.opposite());
        at == start || maze.is_finish(at) || !(straight(Heading::North) || straight(Heading::East))
    };
    let mut graph = BTreeMap::new();
    for (&at, _) in distances(maze).iter().filter(|&(&at, _)| is_point(at)) {
        let neighbours = maze.ways(at).iter().map(|heading| {
            let mut next = at.step(heading);
            while !is_point(next) {
                next = next.step(heading);
            }
            next
        });
        graph.insert(at, neighbours.collect());
    }
    graph
}

fn turns(run: &Recording) -> Vec<Option<Turn>> {
    run.steps().iter().map(|step| step.turn()).collect()
}

fn other(maze: &Maze, settings: &Settings, name: Name) -> Recording {
    match record(maze, settings, name).unwrap() {
        AnyRun::Other(run) => run,
        AnyRun::Book(_) => unreachable!(),
    }
}

fn tree(recipe: &Recipe) -> Maze {
    Recipe { loops: 0, gaps: 0, finishes: 1, ..recipe.clone() }.maze()
}

/// Breadth first over visited squares' openings, in so many words and with nothing left out: the ways to the
/// first unvisited square, as a robot sees them that stands at `from` facing `heading`.
fn plain_search(squares: &Squares, from: Point, heading: Heading) -> Option<Vec<Heading>> {
    let mut came = BTreeMap::from([(from, heading)]);
    let mut todo = VecDeque::from([from]);
    while let Some(at) = todo.pop_front() {
        for turn in [Turn::Straight, Turn::Left, Turn::Right, Turn::Back] {
            let way = came[&at].turned(turn);
            let mut next = at.step(way);
            if squares.byte(at) & wall(way) != 0 || came.contains_key(&next) {
                continue;
            }
            came.insert(next, way);
            if squares.byte(next) & VISITED != 0 {
                todo.push_back(next);
                continue;
            }
            let mut ways = Vec::new();
            while next != from {
                ways.push(came[&next]);
                next = next.step(came[&next].opposite());
            }
            ways.reverse();
            return Some(ways);
        }
    }
    None
}

/// Every search of this run of Cornell's third found what the plain one finds; how many there were.
fn holds_to_the_plain_search(run: &Recording) -> Result<usize, TestCaseError> {
    let mut cursor = Cursor::default();
    let mut searches = 0;
    for stop in 0..=run.stops() {
        let here = cursor.seek(run, stop);
        let Mind::Cornell(mind) = &here.mind else { unreachable!() };
        let (x, y) = mind.position();
        let at = Point::new(x, mind.squares().field().height as i32 - 1 - y);
        let route =
            || std::iter::once(mind.orientation()).chain(mind.route().iter().rev().copied()).collect();
        let found: Option<Vec<_>> = match run.case(stop).name {
            "search" => Some(route()),
            "mapped" => None,
            _ => continue,
        };
        searches += 1;
        prop_assert_eq!(&plain_search(mind.squares(), at, here.heading), &found, "stop {}", stop);
        prop_assert_eq!(mind.squares().search(at, here.heading, Sought::Unvisited), found, "stop {}", stop);
    }
    Ok(searches)
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(300))]

    #[test]
    fn mapping_finds_exactly_the_graph_and_the_shortest_and_quickest_way(maze in anywhere()) {
        let run = recording(&maze, Name::Mapping);
        let expected = if maze.ways(maze.start().unwrap().at).is_empty() { Outcome::Stuck } else { Outcome::Mapped };
        prop_assert_eq!(run.outcome(), expected);
        let report = Report::of_run(&maze, &Settings::default(), &AnyRun::Other(run.clone()));
        let found: BTreeMap<Point, BTreeSet<Point>> = report.extras.adjacency.unwrap().0.into_iter()
            .map(|(at, list)| (at, list.into_iter().collect())).collect();
        prop_assert_eq!(found, graph(&maze));
        let far = distances(&maze);
        let nearest = maze.finish().iter().filter_map(|at| far.get(at)).min().copied();
        prop_assert_eq!(report.route_cells, nearest);
        let map = mapped(&run);
        let pace = Settings::default().pace;
        let quickest = best::fastest(&maze, maze.start().unwrap(), &pace).map(|best| best.seconds);
        for search in [settings::Search::Dijkstra, settings::Search::AStar] {
            for aim in [Aim::Shortest, Aim::Quickest] {
                let mut search = Search::new(map, aim, search);
                let mut last = None;
                while let Some(step) = search.step() {
                    last = Some(step);
                }
                let cost = last.filter(|step| map.is_finish(step.point)).map(|step| step.cost);
                let expected = match aim {
                    Aim::Shortest => nearest.map(|cells| u64::from(cells) * 400),
                    Aim::Quickest => quickest.map(|s| (s * 1e9).round() as u64),
                };
                prop_assert_eq!(cost, expected, "{:?}", aim);
                prop_assert_eq!(search.path().is_some(), expected.is_some());
            }
        }
    }

    #[test]
    fn cornell_3_visits_every_square_that_can_be_reached(maze in anywhere()) {
        let run = recording(&maze, Name::Cornell3);
        let visited: BTreeSet<Point> = run.places().collect();
        prop_assert_eq!(visited, distances(&maze).into_keys().collect::<BTreeSet<_>>());
        if run.stops() > 0 {
            prop_assert_eq!(run.outcome(), Outcome::Mapped);
        }
        let report = Report::of_run(&maze, &Settings::default(), &AnyRun::Other(run));
        prop_assert_eq!(report.route_cells, report.shortest_cells);
    }

    #[test]
    fn cornell_3_goes_to_what_a_plain_search_finds(maze in anywhere()) {
        holds_to_the_plain_search(&recording(&maze, Name::Cornell3))?;
    }

    #[test]
    fn on_trees_all_hands_and_the_book_agree_with_the_only_path(recipe in recipes(9), order in orders()) {
        let maze = tree(&recipe);
        let shortest = best::shortest(&maze, maze.start().unwrap(), &Settings::default().pace).unwrap().cells;
        let book = TurnList::of(&explore(&maze, &roomy(order)).unwrap()).unwrap();
        let settings = roomy(order);
        for name in Name::ALL {
            let run = record(&maze, &settings, *name).unwrap();
            let maps = matches!(name, Name::Cornell1 | Name::Cornell2);
            match run.way(&maze) {
                Some(way) => {
                    prop_assert_eq!(&way.list, &book, "{}", name);
                    prop_assert_eq!(way.route.unwrap().cells(), shortest);
                }
                None => prop_assert!(maps, "{} finds no way in a tree", name),
            }
        }
    }

    #[test]
    fn the_sums_are_the_simplified_letters(maze in anywhere()) {
        for (hand, sum) in [(Name::LeftHand, Name::DirectionSumLeft), (Name::RightHand, Name::DirectionSumRight)] {
            let (hand, sum) = (recording(&maze, hand), recording(&maze, sum));
            // Only the sums know when to give up, back at the start.
            let both = sum.stops().min(hand.stops());
            prop_assert_eq!(&turns(&hand)[..both as usize], &turns(&sum)[..both as usize]);
            for stop in 0..=both {
                let (Mind::Hand(hand), Mind::Sums(sums)) = (hand.at(stop).mind, sum.at(stop).mind) else {
                    unreachable!()
                };
                let mut letters = hand.path().to_vec();
                // A B at the end is on its way back to the letter before; a start may be left by B.
                while letters.last() == Some(&Turn::Back) && !(letters.len() == 1 && sums.j() == 1) {
                    letters.pop();
                    letters.pop();
                }
                let array: Vec<Turn> = sums.sums().iter().map(|&sum| sums::turn(sum)).collect();
                prop_assert_eq!(array, letters, "stop {}", stop);
            }
            prop_assert_eq!(hand.outcome() == Outcome::Finish, sum.outcome() == Outcome::Finish);
        }
    }

    #[test]
    fn tremaux_drives_as_depth_first_does(maze in anywhere(), order in orders()) {
        let settings = roomy(order);
        let [chalk, depth] = [Name::Tremaux, Name::DepthFirst].map(|name| other(&maze, &settings, name));
        prop_assert_eq!(turns(&chalk), turns(&depth));
        prop_assert_eq!(chalk.outcome(), depth.outcome());
        let [chalk, depth] = [chalk, depth].map(|run| AnyRun::Other(run).way(&maze));
        prop_assert_eq!(&chalk, &depth);
        let reachable = maze.finish().iter().any(|at| distances(&maze).contains_key(at));
        prop_assert_eq!(chalk.is_some(), reachable);
        if let Some(way) = chalk {
            prop_assert!(way.route.is_ok(), "{:?}", way);
        }
    }

    #[test]
    fn every_run_ends_and_says_why(maze in anywhere(), order in orders(), basic in any::<bool>()) {
        let rule = if basic { settings::Rule::Basic } else { settings::Rule::Special1 };
        let settings = Settings { rule, ..roomy(order) };
        let far = distances(&maze);
        let reachable = maze.finish().iter().any(|at| far.contains_key(at));
        for &name in &Name::ALL[1..] {
            let run = other(&maze, &settings, name);
            match run.outcome() {
                Outcome::Finish => prop_assert!(maze.is_finish(run.place(run.stops()))),
                Outcome::Mapped => {}
                Outcome::Stuck => prop_assert!(far.len() == 1),
                Outcome::Circling { first, again } => {
                    prop_assert!(first < again && again == run.stops());
                    prop_assert_eq!(run.place(first), run.place(again), "{}", name);
                    prop_assert_eq!(run.step(first).heading(), run.step(again).heading());
                    if name == Name::Cornell2 {
                        let before: BTreeSet<Point> = run.places().take(first as usize + 1).collect();
                        prop_assert!(run.places().all(|at| before.contains(&at)));
                    }
                }
                Outcome::NoFinishReachable => prop_assert!(!reachable && far.len() > 1, "{}", name),
                outcome => prop_assert!(false, "{}: {}", name, outcome),
            }
            let report = Report::of_run(&maze, &settings, &AnyRun::Other(run.clone()));
            if report.outcome == "finish" {
                prop_assert!(report.route_cells.is_some(), "{}: {:?}", name, report.reason);
            }
            // Flood fill with the goal told always gets there.
            if name == Name::FloodFill && reachable {
                prop_assert_eq!(run.outcome(), Outcome::Finish);
            }
            let cells: u32 = (0..=run.stops()).map(|stop| run.cells(stop)).sum();
            prop_assert_eq!(run.tally(run.stops()).cells, cells);
        }
    }

    #[test]
    fn counts_at_any_stop_are_those_of_the_drive_so_far(recipe in recipes(9), order in orders(), pick in any::<prop::sample::Index>()) {
        let maze = recipe.maze();
        prop_assume!(line_start(&maze).is_ok());
        for &name in Name::ALL {
            let run = record(&maze, &roomy(order), name).unwrap();
            use line_maze_lab::playback::Timeline as _;
            let stop = pick.index(run.stops() as usize + 1) as u32;
            let slow = (1..=stop).fold(line_maze_lab::route::tally::Tally::NONE, |tally, stop| {
                let tally = run.turn(stop - 1).map_or(tally, |turn| tally.turned(turn));
                tally.driven(run.drive_ms(stop) / 400)
            });
            prop_assert_eq!(run.tally(stop), slow, "{}", name);
            prop_assert!(run.tally(run.stop_at_cells(slow.cells)).cells == slow.cells);
        }
    }
}

#[test]
fn an_order_is_heeded() {
    let maze = line_maze_lab::maze::samples::figure_3_1();
    let run = |order: &str| {
        let order: Order = order.parse().unwrap();
        turns(&other(&maze, &roomy(order), Name::DepthFirst))
    };
    assert_ne!(run("SRL"), run("RSL"));
}

#[test]
fn cornell_3_searches_far_as_a_plain_search_does() {
    for (seed, loops_percent) in [(1, 3), (2, 10), (3, 40)] {
        let maze =
            generate(&Generated { width: 40, height: 30, seed, loops_percent, ..Generated::default() });
        let searches = holds_to_the_plain_search(&recording(&maze.unwrap(), Name::Cornell3)).unwrap();
        assert!(searches > 50, "{searches} searches");
    }
}
