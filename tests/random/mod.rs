//! Random mazes for property tests: any bounds, any lines, odd texts, with or without start and finish.

use line_maze_lab::geometry::{Heading, Point};
use line_maze_lab::maze::{About, Bounds, Kind, Maze, Scale, Start};
use proptest::prelude::*;

/// A maze whose texts are up to `longest` characters long.
pub(crate) fn maze(longest: usize) -> impl Strategy<Value = Maze> {
    (bounds(), about(longest), scale(), any::<bool>())
        .prop_flat_map(|(bounds, about, scale, wall)| {
            let ways = prop_oneof![
                prop::collection::vec(0_u8..4, bounds.len()),
                prop::collection::vec(Just(0), bounds.len()),
                prop::collection::vec(Just(3), bounds.len()),
            ];
            let start = prop::option::of((point(bounds), 0_u8..4));
            let finish = prop::collection::vec(point(bounds), 0..4);
            (Just((bounds, about, scale, wall)), ways, start, finish)
        })
        .prop_map(|((bounds, about, scale, wall), ways, start, finish)| {
            let mut maze = Maze::new(bounds);
            maze.about = about;
            maze.scale = scale;
            maze.kind = if wall { Kind::Wall } else { Kind::Line };
            for (at, ways) in bounds.points().zip(ways) {
                for (bit, heading) in [(1, Heading::North), (2, Heading::East)] {
                    if ways & bit != 0 {
                        maze.draw(at, heading);
                    }
                }
            }
            let start = start.map(|(at, index)| Start { at, heading: Heading::from_index(index) });
            assert!(maze.set_start(start));
            assert!(maze.set_finish(finish));
            maze
        })
}

fn bounds() -> impl Strategy<Value = Bounds> {
    let corner = prop_oneof![Just(0), -20..20_i32, Just(-1_000_000), Just(999_900)];
    let side = prop_oneof![4 => 0..12_i32, 1 => 35..50_i32];
    (corner.clone(), corner, side.clone(), side)
        .prop_map(|(x, y, w, h)| Bounds::new(Point::new(x, y), Point::new(x + w, y + h)).unwrap())
}

fn point(bounds: Bounds) -> impl Strategy<Value = Point> {
    (0..bounds.len()).prop_map(move |index| bounds.point(index))
}

fn scale() -> impl Strategy<Value = Scale> {
    prop_oneof![
        Just(Scale::default()),
        (1.0..10_000.0_f64, 0.0..1.0_f64)
            .prop_map(|(cell, share)| Scale::new(cell, (cell * share).max(0.1)).unwrap()),
    ]
}

fn about(longest: usize) -> impl Strategy<Value = About> {
    let text = || text(longest);
    (text(), text(), text()).prop_map(|(title, source, note)| About { title, source, note })
}

/// Nothing, plain words, or what could break a line: blanks, backslashes, control characters.
fn text(longest: usize) -> impl Strategy<Value = String> {
    let odd = prop_oneof![
        Just(' '),
        Just('\n'),
        Just('\r'),
        Just('\t'),
        Just('\\'),
        Just(':'),
        Just('n'),
        Just('"'),
        Just('\0'),
        Just('\u{feff}'),
        Just('\u{2028}'),
        any::<char>(),
    ];
    let words = "([a-zäé]{1,9}[ .,]{1,2}){0,40}".prop_map(move |text| text.chars().take(longest).collect());
    prop_oneof![
        Just(String::new()),
        words,
        prop::collection::vec(odd, 0..longest.min(40)).prop_map(String::from_iter),
    ]
}
