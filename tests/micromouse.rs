//! Micromouse files: the four forms say the same maze, and what is written is read back the same.
#![allow(clippy::unwrap_used, missing_docs)]

mod random;

use line_maze_lab::geometry::{Heading, Point};
use line_maze_lab::maze::micromouse::{CannotSay, Form, read, write};
use line_maze_lab::maze::{Bounds, Kind, Maze, Start, file, text};
use proptest::prelude::*;

/// Three squares by two: an open ring, and a wall between the two squares in the north-west.
const DRAWN: &str = "o---o---o---o\n|   | G   G |\no   o---o   o\n| S         |\no---o---o---o\n";

fn maze(text: &str) -> Maze {
    read(text.as_bytes()).unwrap().unwrap_or_else(|error| panic!("{error}\n{text}")).maze
}

fn points(points: &[(i32, i32)]) -> Vec<Point> {
    points.iter().map(|&(x, y)| Point::new(x, y)).collect()
}

/// The same maze in the lab's own words: openings are lines between the middles of squares.
#[test]
fn an_opening_is_a_line_between_two_squares() {
    let own = "line-maze: 1\nkind: wall\nstart: 0,0 N\nfinish: 1,1 2,1\n\n+   +---+\n|       |\n+---+---+\n";
    assert_eq!(maze(DRAWN), text::parse(own).unwrap());
}

#[test]
fn all_forms_say_the_same_walls() {
    let map = "+---+---+---+\n|   |       |\n+   +---+   +\n|           |\n+---+---+---+\n";
    let num = "0 0 0 0 1 1\n0 1 1 1 0 1\n1 0 1 0 1 0\n1 1 1 0 1 1\n2 0 0 1 1 0\n2 1 1 1 0 0\n";
    let lines = |maze: &Maze| maze.lines().collect::<Vec<_>>();
    let (drawn, map, num) = (maze(DRAWN), maze(map), maze(num));
    assert_eq!([lines(&map), lines(&num)], [lines(&drawn), lines(&drawn)]);
    for maze in [&drawn, &map, &num] {
        assert_eq!(maze.kind, Kind::Wall);
        assert_eq!(maze.start(), Some(Start { at: Point::new(0, 0), heading: Heading::North }));
    }
    assert_eq!(drawn.finish(), points(&[(1, 1), (2, 1)]));
    assert_eq!(map.finish(), points(&[(1, 0), (1, 1)]), "the simulator's goal is the centre");
    assert_eq!(num.finish(), [], "a file without a goal has none");
}

#[test]
fn a_byte_is_a_square_column_by_column_from_the_south_west() {
    let mut bytes = [15_u8; 256];
    // The start opens to the north, and that square to the south and east.
    (bytes[0], bytes[1], bytes[17]) = (14, 9, 7);
    let maze = file::read(&bytes).unwrap().maze;
    let lines: Vec<_> = maze.lines().collect();
    assert_eq!(lines, [(Point::new(0, 0), Heading::North), (Point::new(0, 1), Heading::East)]);
    assert_eq!(maze.bounds().ne(), Point::new(15, 15));
    assert_eq!(write(&maze, Form::Binary), Ok(bytes.to_vec()));
    let num = write(&maze, Form::Num).unwrap();
    assert_eq!(file::read(&num).unwrap().maze, maze, "an old .maz file may be .num text");
}

#[test]
fn odd_but_sound_files_are_read() {
    let same = |text: &str| assert_eq!(maze(text), maze(DRAWN), "{text}");
    same(&DRAWN.replace('o', "+"));
    same(&DRAWN.replace('\n', "\r\n"));
    same(&format!("\u{feff}\n{DRAWN}"));
    same(&DRAWN.replace("|\n", "|   \n"));
    same(&format!("{DRAWN}\nAll Japan 1980; 16 x 16\no dear\n"));
    same(DRAWN.trim_end());
    let dots = maze("+###+===+\n#   :   !\n+-+-+-- +\n");
    assert_eq!((dots.cells(), dots.finish()), (0, &points(&[(0, 0), (1, 0)])[..]), "any character is a wall");
    assert_eq!(read(b"origin of all things"), None);
    assert_eq!(read(b"line-maze: 1\n\n+---+\n"), None);
    assert_eq!(read(b""), None);
}

#[test]
fn what_a_form_cannot_say_is_refused_in_words() {
    let says = |change: fn(&mut Maze), form| {
        let mut maze = maze(DRAWN);
        change(&mut maze);
        write(&maze, form).unwrap_err()
    };
    let all: [Case; 8] = [
        (|maze| maze.kind = Kind::Line, Form::Online, CannotSay::Lines),
        (|maze| assert!(maze.set_start(None)), Form::Online, CannotSay::NoStart),
        (
            |maze| turn(maze, (0, 0), Heading::East),
            Form::Online,
            CannotSay::StartHeading { faces: Heading::East, read: Heading::North },
        ),
        (|maze| turn(maze, (1, 1), Heading::East), Form::Online, CannotSay::StartOnFinish(Point::new(1, 1))),
        (|maze| turn(maze, (2, 0), Heading::North), Form::Map, CannotSay::StartAt(Point::new(2, 0))),
        (|_| {}, Form::Map, CannotSay::Finish),
        (|_| {}, Form::Num, CannotSay::Finish),
        (|maze| assert!(maze.set_finish(vec![])), Form::Binary, CannotSay::Size { width: 3, height: 2 }),
    ];
    for (change, form, expected) in all {
        let found = says(change, form);
        assert_eq!(found, expected, "{form:?}");
        assert!(found.to_string().contains(';'), "what is wrong; what to do: {found}");
    }
}

/// What is done to the maze, the form to write, and what is said then.
type Case = (fn(&mut Maze), Form, CannotSay);

fn turn(maze: &mut Maze, at: (i32, i32), heading: Heading) {
    assert!(maze.set_start(Some(Start { at: Point::new(at.0, at.1), heading })));
}

/// Any walls, with start and finish where the form can say them; what it leaves out is as it is on reading.
fn sayable(form: Form) -> impl Strategy<Value = Maze> {
    (1_usize..12, 1_usize..12, any::<u64>(), prop::collection::vec(any::<prop::sample::Index>(), 1..5))
        .prop_map(move |(width, height, seed, marks)| {
            let height = if form == Form::Binary { width } else { height };
            let ne = Point::new(width as i32 - 1, height as i32 - 1);
            let bounds = Bounds::new(Point::new(0, 0), ne).unwrap();
            let mut maze = Maze::new(bounds);
            maze.kind = Kind::Wall;
            let mut chance = oorandom::Rand32::new(seed);
            for at in bounds.points() {
                for heading in [Heading::North, Heading::East] {
                    if chance.rand_range(0..2) == 0 {
                        maze.draw(at, heading);
                    }
                }
            }
            let mut marks = marks.iter().map(|mark| bounds.point(mark.index(bounds.len())));
            let at = if form == Form::Online { marks.next().unwrap() } else { bounds.sw() };
            // Where there is one way only, no file has to say that the mouse faces it.
            let heading = maze.ways(at).only().unwrap_or(Heading::North);
            assert!(maze.set_start(Some(Start { at, heading })));
            match form {
                Form::Online => assert!(maze.set_finish(marks.filter(|&mark| mark != at).collect())),
                Form::Map => {
                    let middle = |side: i32| [(side - 1) / 2, side / 2];
                    let [xs, ys] = [middle(width as i32), middle(height as i32)];
                    let centre = xs.into_iter().flat_map(|x| ys.map(|y| Point::new(x, y)));
                    assert!(maze.set_finish(centre.collect()));
                }
                Form::Num | Form::Binary => {}
            }
            maze
        })
}

fn round_trip(form: Form) -> impl Strategy<Value = (Form, Maze)> {
    sayable(form).prop_map(move |maze| (form, maze))
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 400, failure_persistence: None, ..ProptestConfig::default() })]

    #[test]
    fn what_is_written_is_read_back(
        (form, maze) in prop_oneof![
            round_trip(Form::Online), round_trip(Form::Map), round_trip(Form::Num), round_trip(Form::Binary),
        ]
    ) {
        let written = write(&maze, form).unwrap();
        prop_assert_eq!(file::read(&written).map(|reading| reading.maze), Ok(maze), "{}", String::from_utf8_lossy(&written));
    }

    #[test]
    fn any_maze_is_written_whole_or_not_at_all(maze in random::maze(5)) {
        for form in Form::ALL {
            if let Ok(written) = write(&maze, form) {
                let back = file::read(&written).unwrap().maze;
                prop_assert_eq!(back.cells(), maze.cells());
                prop_assert_eq!(back.start().is_some(), maze.start().is_some());
            }
        }
    }

    #[test]
    fn what_is_wrong_in_a_damaged_file_has_its_place(
        (form, maze) in prop_oneof![round_trip(Form::Online), round_trip(Form::Map), round_trip(Form::Num)],
        place in any::<prop::sample::Index>(),
        byte in prop_oneof![Just(b' '), Just(b'|'), Just(b'S'), Just(b'\n'), any::<u8>()],
    ) {
        let mut bytes = write(&maze, form).unwrap();
        let at = place.index(bytes.len());
        bytes[at] = byte;
        if let Some(Err(error)) = read(&bytes) {
            let said = error.to_string();
            prop_assert!(said.starts_with("Line ") && said.contains(", column "), "{said}");
        }
    }
}
