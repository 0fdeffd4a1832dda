//! Maze files: what is written can be read again, and what is wrong is named with its place.
#![allow(clippy::unwrap_used, missing_docs)]

mod random;

use line_maze_lab::geometry::Point;
use line_maze_lab::maze::{Maze, file, json, text};
use proptest::prelude::*;

/// The maze of a file that needs no remark but where it begins.
fn opened(text: &str) -> Result<Maze, file::ReadError> {
    file::read(text.as_bytes()).map(|reading| reading.maze)
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(1000))]

    #[test]
    fn any_maze_survives_text(maze in random::maze(300)) {
        let written = text::write(&maze);
        prop_assert_eq!(text::parse(&written), Ok(maze.clone()), "{}", written);
        let drawn = text::write_drawing(&maze);
        prop_assert_eq!(text::parse(&drawn), Ok(maze.clone()), "{}", drawn);
        prop_assert!(written.len() <= drawn.len(), "{written}\nis larger than\n{drawn}");
        let windows = format!("\u{feff}{}", drawn.trim_end().replace('\n', "  \r\n"));
        for ends in ["\n", "\r", "\r\r\n"] {
            let other = windows.replace("\r\n", ends);
            prop_assert_eq!(opened(&other), Ok(maze.clone()), "{:?}", ends);
        }
        let quoted: String = drawn.lines().map(|line| format!("    {line}\n")).collect();
        prop_assert_eq!(opened(&format!("As a quotation:\n\n{quoted}")), Ok(maze.clone()), "{}", quoted);
        prop_assert_eq!(opened(&windows), Ok(maze), "{}", windows);
    }

    #[test]
    fn any_maze_survives_json(maze in random::maze(300)) {
        let written = json::write(&maze);
        prop_assert_eq!(opened(&written), Ok(maze.clone()), "{}", written);
        prop_assert_eq!(opened(&written.replace('\n', "\r")), Ok(maze), "{}", written);
    }

    #[test]
    fn no_text_is_too_odd_to_be_refused(
        bytes in prop::collection::vec(any::<u8>(), 0..200),
        rest in "[ -+.|F^>v<0-9,\nlines:]{0,80}",
        walls in "([o+O.*#][-# ]{1,4}){1,4}[o+#]\n([|#] {1,3}[SG@]?){1,4}[|#\n]\n",
        list in "\\[(\\[([01369],? ?){1,4}\\],?){1,4}\\]",
    ) {
        let _ = file::read(walls.repeat(2).as_bytes());
        let _ = file::read(list.as_bytes());
        let _ = file::read(&bytes);
        let _ = file::read(format!("{rest}\n{}", String::from_utf8_lossy(&bytes)).as_bytes());
        let _ = text::parse(&format!("line-maze: 1\n\n{rest}"));
        let _ = text::parse(&format!("line-maze: 1\nbounds: 0,0 9,9\n\nlines:\n{rest}"));
    }
}

/// What the reader says about each file in `tests/fixtures/bad`.
#[rustfmt::skip]
const BAD: &[(&str, &str)] = &[
    ("another-program.maze", "Line 1, column 1: this seems to be a drawing of “_” and “|”; draw walls with “+”, “-” and “|”, or a grid with “#”."),
    ("archive.maze", "Byte 0: this seems to be an archive; take the files out of it first."),
    ("bad-escape.maze", "Line 2, column 20: a backslash stands only in \\\\, \\n, \\r, \\t, \\s (a space) and \\u{…}."),
    ("bounds-one-point.maze", "Line 2, column 9: a pair of points (south-west and north-east corner) was expected, not “5,5”."),
    ("bounds-swapped.json", "bounds: the first corner is the south-west one, the second the north-east one."),
    ("bounds-swapped.maze", "Line 2, column 9: the first corner is the south-west one, the second the north-east one."),
    ("bounds-too-large.maze", "Line 2, column 9: a maze has at most 1,000 × 1,000 points."),
    ("box-drawing.maze", "Line 3, column 2: “-” or a space was expected, not “─”."),
    ("box-letters.txt", "Line 1, column 1: this seems to be a drawing in line or block characters; draw walls with “+”, “-” and “|”, or a grid with “#”."),
    ("cell-too-long.maze", "Line 2, column 10: a cell is 1 to 10,000 mm long."),
    ("columns-3.maze", "Line 2, column 10: “4” or “2” (columns of text for a cell) was expected, not “3”."),
    ("cr-only.json", "Line 3, column 7: `size` is not a key here; there is one of `format`, `title`, `source`, `note`, `kind`, `cell_mm`, `line_mm`, `bounds`, `start`, `finish`, `lines`."),
    ("cr-only.maze", "Line 4, column 4: “-” (a line goes from point to point) was expected, not “x”."),
    ("cut-off.json", "Line 1, column 60: the text ends in the middle of the maze."),
    ("drawing-off-bounds.maze", "Line 4, column 9: the point 2,0 is off the lattice, which goes from 0,0 to 1,0; move it, or set wider “bounds”."),
    ("drawing-too-far-away.maze", "Line 2, column 9: coordinates go from −1,000,000 to 1,000,000."),
    ("empty.maze", "The file is empty; a maze file begins with “line-maze: 1”."),
    ("finish-not-a-point.maze", "Line 2, column 13: a point such as 3,4 was expected, not “here”."),
    ("finish-off-lattice.json", "finish[1]: the point 6,0 is off the lattice, which goes from 0,0 to 5,0; move it, or set wider “bounds”."),
    ("finish-off-lattice.maze", "Line 2, column 13: the finish point 1,1 is off the lattice, which goes from 0,0 to 1,0; move it, or set wider “bounds”."),
    ("foreign-character.maze", "Line 5, column 5: “|” or a space was expected, not “x”."),
    ("foreign-point.maze", "Line 3, column 9: a point (“+”, “.”, “F”, “^”, “>”, “v” or “<”) was expected, not “o”."),
    ("gap-in-line.maze", "Line 3, column 3: “-” (a line goes from point to point) was expected, not a space."),
    ("grid-corner.txt", "Line 1, column 5: the outer wall is open here; close it, a maze has walls all round."),
    ("grid-gap.txt", "Line 2, column 5: the outer wall is open here; close it, a maze has walls all round."),
    ("grid-of-walls.txt", "Line 1, column 1: there is no square between the walls; draw three places at least each way."),
    ("grid-open.json", "[1][2]: in a grid of 0 (open) and 1 (closed), the outer wall is open here; close it, a maze has walls all round."),
    ("grid-open.txt", "Line 2, column 5: this line has 4 columns and the first one 5; make them equal."),
    ("grid-short.txt", "Line 2, column 3: this line has 2 columns and the first one 5; make them equal."),
    ("grid-sign.txt", "Line 2, column 3: “#” (a wall), a space, “S” or “G” was expected, not “=”."),
    ("grid-two-starts.txt", "Line 2, column 2: there is another start besides; leave one “S”."),
    ("half-a-cell.json", "Line 1, column 125: a whole number was expected, not floating point `0.5`."),
    ("indented-number.maze", "Line 3, column 3: a line that is not indented (only title, source and note go on in the next line) was expected, not “50”."),
    ("key-twice.json", "Line 2, column 7: the key `kind` is there twice."),
    ("key-twice.maze", "Line 4, column 1: “title” is given in line 2 already."),
    ("letter.txt", "Line 1, column 1: no maze file begins like this; begin with “line-maze: 1”, or give a drawing of walls (posts “o” or “+”), a grid of “#”, a .num or .maz file, or JSON."),
    ("line-too-wide.maze", "Line 3, column 10: a line is at least 0.1 mm wide, and not wider than a cell is long."),
    ("line-without-beginning.maze", "Line 3, column 3: a line that begins at a point was expected, not “-”."),
    ("line-without-end.maze", "Line 3, column 6: this line has no point at its end; put a “+” there."),
    ("lines-without-header.maze", "Line 1, column 1: this seems to be a drawing of lines without a header; put “line-maze: 1” and a blank line above it."),
    ("list-and-number.json", "[1]: a list of numbers was expected, as the others are."),
    ("list-cut-off.json", "Line 2, column 1: the text ends in the middle of the maze."),
    ("list-disagrees.json", "[1][1]: the numbers (north 1, east 2, south 4, west 8) make no maze in any order; as rows from the north, the outer wall south of square 1,0 is open; close it, a maze has walls all round."),
    ("list-of-two.json", "This seems to be a list of walls, but its 2 numbers make no square maze; write a list for each row, or a number for each square (256 for 16 × 16)."),
    ("list-sixteen.json", "[1][1]: in a list of walls a square is a number from 0 to 15 (north 1, east 2, south 4, west 8)."),
    ("list-two-ways.json", "[0]: the numbers can be read as rows or as columns, and make different mazes; write a .num file instead."),
    ("list-uneven.json", "[1]: this list has 1 number and the first one 2; make them equal."),
    ("list-words.json", "[1][1]: in a list of walls a square is a number from 0 to 15 (north 1, east 2, south 4, west 8)."),
    ("missing-key.json", "Line 1, column 99: the key `start` is missing."),
    ("mouse-255-bytes.maz", "This looks like a binary .maz file, which has a byte for each square of a square maze (256 for 16 × 16, 1,024 for 32 × 32); this one has 255."),
    ("mouse-cr-only.num", "Line 2, column 11: 0 (open) or 1 (wall) was expected, not “2”."),
    ("mouse-cr-only.txt", "Line 3, column 3: a wall of three dashes or three spaces was expected, not “x”."),
    ("mouse-cut-off.txt", "Line 5, column 1: a line of posts and walls was expected, but there is nothing."),
    ("mouse-disagree-6x6.maz", "Byte 15: square 2,3 has a wall to the east, but 3,3 has none to the west; make the two agree."),
    ("mouse-disagree.maz", "Byte 52: square 3,4 has a wall to the east, but 4,4 has none to the west; make the two agree."),
    ("mouse-disagree.num", "Line 2, column 1: square 0,1 has a wall to the east, but 1,1 has none to the west; make the two agree."),
    ("mouse-five-numbers.num", "Line 2, column 10: 0 (open) or 1 (wall) was expected, but there is nothing."),
    ("mouse-flag-2.num", "Line 2, column 9: 0 (open) or 1 (wall) was expected, not “2”."),
    ("mouse-half-wall.txt", "Line 3, column 4: a wall of three dashes or three spaces was expected, not a space."),
    ("mouse-high-bit.maz", "Byte 17: a square is a number from 0 to 15 (north 1, east 2, south 4, west 8), not 64; perhaps this is no .maz file."),
    ("mouse-margin.txt", "Line 3, column 1: the drawing begins after 2 blanks and this line further to the left; begin all lines alike."),
    ("mouse-mark-off-centre.txt", "Line 4, column 2: a space was expected, not “S”."),
    ("mouse-missing-line.txt", "Line 3, column 1: a post (“o” or “+”, at every fourth column) was expected, not “|”."),
    ("mouse-negative.num", "Line 2, column 3: a whole number from 0 to 999 (a line is X Y N E S W) was expected, not “-”."),
    ("mouse-open-east.txt", "Line 2, column 13: the outer wall east of square 2,1 is open; close it, a maze has walls all round."),
    ("mouse-open-north.txt", "Line 1, column 6: the outer wall north of square 1,1 is open; close it, a maze has walls all round."),
    ("mouse-open-south.txt", "Line 5, column 10: the outer wall south of square 2,0 is open; close it, a maze has walls all round."),
    ("mouse-open-west.txt", "Line 4, column 1: “|” (the outer wall) was expected, not a space."),
    ("mouse-open.maz", "Byte 15: the outer wall north of square 0,15 is open; close it, a maze has walls all round."),
    ("mouse-open.num", "Line 2, column 1: the outer wall north of square 0,1 is open; close it, a maze has walls all round."),
    ("mouse-posts-only.txt", "Line 2, column 1: a line of squares, beginning with “|”, was expected, but there is nothing."),
    ("mouse-ragged-long.txt", "Line 3, column 14: this line has 17 columns and the first one 13; make them equal."),
    ("mouse-ragged-short.txt", "Line 2, column 13: this line has 12 columns and the first one 13; make them equal."),
    ("mouse-seven-numbers.num", "Line 2, column 13: the end of the line after X Y N E S W was expected, not “1”."),
    ("mouse-square-missing.num", "Line 4, column 1: square 1,0 is missing; add a line for it, as in “1 0 0 0 0 0”."),
    ("mouse-square-twice.num", "Line 3, column 1: square 0,1 is given in line 2 already; leave one of them."),
    ("mouse-tab.map", "Line 2, column 2: a space was expected, not a tab."),
    ("mouse-three-columns.txt", "Line 3, column 4: a post (“o” or “+”, at every third column) was expected, not “x”."),
    ("mouse-too-far.num", "Line 5, column 1: a maze has at most 1,000 × 1,000 points."),
    ("mouse-too-large.txt", "Line 1, column 1: a maze has at most 1,000 × 1,000 points."),
    ("mouse-two-columns.maze", "Line 2, column 4: “S”, “G” or a space (the middle of a square) was expected, not “x”."),
    ("mouse-two-starts.txt", "Line 4, column 7: the start is given in line 4, column 3 already; leave one “S”."),
    ("mouse-unknown-mark.txt", "Line 4, column 3: “S”, “G” or a space (the middle of a square) was expected, not “s”."),
    ("mouse-unknown-post.txt", "Line 3, column 5: a post (“o” or “+”, at every fourth column) was expected, not “x”."),
    ("mouse-unknown-wall.txt", "Line 4, column 5: a wall (“|”) or a space was expected, not “X”."),
    ("mouse-width.txt", "Line 1, column 13: a line has four columns for each square and one more (5, 9, 13, …); this one has 12."),
    ("newer-version.maze", "Line 1, column 12: this file is of version “2”; only version 1 can be read."),
    ("no-blank-line.maze", "Line 3, column 1: “key: value” or a blank line (before the drawing) was expected, not “+---F”."),
    ("no-colon.maze", "Line 2, column 1: “key: value” or a blank line (before the drawing) was expected, not “title A maze”."),
    ("no-drawing.maze", "Line 4, column 1: a drawing or a list of polylines was expected, but there is nothing."),
    ("no-lines-no-bounds.json", "lines: a maze without lines needs “bounds”."),
    ("no-version.maze", "Line 1, column 1: “line-maze: 1” (the first line of a maze file) was expected, not “title: A maze”."),
    ("not-json.json", "Line 2, column 10: this is not JSON: expected value."),
    ("not-utf-8.maze", "Byte 23: this is not text in UTF-8. A maze file is text; save it as UTF-8, or choose another file."),
    ("number-in-quotes.json", "Line 2, column 17: a number was expected, not string \"200\"."),
    ("one-line-without-header.maze", "Line 1, column 1: this seems to be a drawing of lines without a header; put “line-maze: 1” and a blank line above it."),
    ("other-format.json", "format: “line-maze/1” was expected."),
    ("picture.maze", "Byte 0: this seems to be a picture; a maze cannot be read from one, draw it in the room Draw instead."),
    ("point-not-a-list.json", "Line 1, column 114: a point (two whole numbers such as [3, 4]) was expected, not integer `0`."),
    ("point-of-one.json", "Line 1, column 124: a point (two whole numbers such as [3, 4]) was expected, not a list of 1."),
    ("point-of-three.json", "Line 1, column 122: a point (two whole numbers such as [3, 4]) was expected, not a list of 3."),
    ("polyline-letters.maze", "Line 4, column 5: a point such as 3,4 was expected, not “0,five”."),
    ("polyline-off-bounds.json", "lines[0][1]: the point 0,4 is off the lattice, which goes from 0,0 to 3,3; move it, or set wider “bounds”."),
    ("polyline-off-bounds.maze", "Line 5, column 5: the point 0,6 is off the lattice, which goes from 0,0 to 5,5; move it, or set wider “bounds”."),
    ("polyline-one-point.json", "lines[1]: a polyline has two points or more."),
    ("polyline-one-point.maze", "Line 5, column 1: a polyline needs a second point."),
    ("polyline-same-point.json", "lines[0][1]: this point is the same as the one before it."),
    ("polyline-same-point.maze", "Line 4, column 9: this point is the same as the one before it."),
    ("polyline-semicolon.maze", "Line 4, column 1: a point such as 3,4 was expected, not “0,0;”."),
    ("polyline-slanted.json", "lines[0][2]: lines go along the axes, and 0,1 to 1,2 is slanted; add the corner between them."),
    ("polyline-slanted.maze", "Line 4, column 9: lines go along the axes, and 0,5 to 6,6 is slanted; add the corner between them."),
    ("polyline-too-long.maze", "Line 4, column 5: a maze has at most 1,000 × 1,000 points."),
    ("polylines-none.maze", "Line 3, column 1: a maze without lines needs “bounds” in its header."),
    ("polylines-with-columns.maze", "Line 2, column 10: “columns” is for drawings; a list of polylines does without it."),
    ("polylines-with-origin.maze", "Line 2, column 9: “origin” is for drawings; a list of polylines does without it."),
    ("program.maze", "Line 1, column 1: this seems to be a program; copy the maze alone into a file."),
    ("size-in-words.maze", "Line 2, column 10: a length in millimetres such as 180 or 19.5 was expected, not “20 cm”."),
    ("size-zero.json", "line_mm: a line is at least 0.1 mm wide, and not wider than a cell is long."),
    ("start-heading-in-words.maze", "Line 2, column 12: a heading (N, E, S or W) was expected, not “north”."),
    ("start-heading.json", "Line 1, column 68: one of `N`, `E`, `S`, `W` was expected, not `north`."),
    ("start-in-header-and-drawing.maze", "Line 4, column 1: the start is given in line 2, column 8 already."),
    ("start-off-lattice.json", "start.at: the point 0,1 is off the lattice, which goes from 0,0 to 5,0; move it, or set wider “bounds”."),
    ("start-off-lattice.maze", "Line 2, column 8: the start 5,0 is off the lattice, which goes from 0,0 to 1,0; move it, or set wider “bounds”."),
    ("start-twice.maze", "Line 3, column 9: the start is given in line 3, column 1 already."),
    ("start-without-heading.maze", "Line 2, column 8: a point and a heading such as 3,4 N was expected, not “0,0”."),
    ("tab.maze", "Line 4, column 2: a space (no point is above this place) was expected, not a tab."),
    ("too-far-away.json", "lines[0][1]: coordinates go from −1,000,000 to 1,000,000."),
    ("too-far-away.maze", "Line 2, column 9: coordinates go from −1,000,000 to 1,000,000."),
    ("too-long.json", "lines[0][1]: a maze has at most 1,000 × 1,000 points."),
    ("turn-list.txt", "Line 1, column 1: this seems to be a turn list, not a maze; the turn-list lab reads it."),
    ("two-objects.json", "Line 1, column 132: this is not JSON: trailing characters."),
    ("unknown-key.json", "Line 2, column 22: `colour` is not a key here; there is one of `format`, `title`, `source`, `note`, `kind`, `cell_mm`, `line_mm`, `bounds`, `start`, `finish`, `lines`."),
    ("unknown-key.maze", "Line 2, column 1: “colour” is not a key of a maze file; those are title, source, note, kind, cell_mm, line_mm, columns, origin, bounds, start and finish."),
    ("unknown-kind.json", "Line 1, column 41: `line` or `wall` was expected, not `hedge`."),
    ("unknown-kind.maze", "Line 2, column 7: “line” or “wall” was expected, not “maze”."),
    ("utf-16.maze", "Byte 0: this seems to be text in UTF-16; save it as UTF-8."),
    ("wall-at-the-bottom.maze", "Line 4, column 1: this line has no point at its end; put a “+” there."),
    ("wall-between-columns.maze", "Line 4, column 3: a space (no point is above this place) was expected, not “|”."),
    ("wall-without-end.maze", "Line 4, column 5: this line has no point at its end; put a “+” there."),
    ("web-page.maze", "Line 1, column 1: this seems to be a web page; save the maze alone, as a text file."),
];

#[test]
fn every_bad_file_is_refused_with_place_and_expectation() {
    let folder = std::path::Path::new("tests/fixtures/bad");
    for (name, message) in BAD {
        let error = file::read(&std::fs::read(folder.join(name)).unwrap());
        let said = error.map(|reading| reading.maze).map_err(|error| error.to_string());
        assert_eq!(said, Err((*message).to_owned()), "{name}");
    }
    for entry in std::fs::read_dir(folder).unwrap() {
        let name = entry.unwrap().file_name().into_string().unwrap();
        assert!(BAD.iter().any(|(known, _)| *known == name), "{name} has no entry in the table");
    }
}

#[test]
fn limits_are_errors() {
    let says = |text: &str| text::parse(text).unwrap_err().to_string();
    let long = format!("line-maze: 1\nnote: {}\n\n+---F\n", "a".repeat(text::MAX_BYTES));
    assert_eq!(says(&long), "A maze file has at most 4,194,304 bytes (4 MiB); this one has 4,194,331.");
    let wide = format!("line-maze: 1\n\n{}\n", "+---".repeat(1001));
    assert_eq!(says(&wide), "Line 3, column 1: a maze has at most 1,000 × 1,000 points.");
    let high = format!("line-maze: 1\n\n{}", "+\n|\n".repeat(1001));
    assert_eq!(says(&high), "Line 2004, column 1: a maze has at most 1,000 × 1,000 points.");
    let blank = format!("line-maze: 1\n\n+---F{}", "\n".repeat(100_000));
    assert_eq!(text::parse(&blank).unwrap().cells(), 1, "blank lines at the end are no drawing");
    let polylines = format!("line-maze: 1\n\nlines:\n{}", "0,0 999,0\n".repeat(400_000));
    assert_eq!(text::parse(&polylines).unwrap().cells(), 999, "lines that overlap are one");
    let json = json::parse(&" ".repeat(json::MAX_BYTES + 1)).unwrap_err().to_string();
    assert_eq!(json, "A maze in JSON has at most 33,554,432 bytes (32 MiB); this one has 33,554,433.");
    let any = file::read(&vec![b'x'; json::MAX_BYTES + 1]).unwrap_err().to_string();
    assert_eq!(any, "The file is too large: a maze file has at most 32 MiB.");
}

/// The examples in the documentation are what they say.
#[test]
fn the_documented_examples_can_be_read() {
    let page = include_str!("../docs/formats.md");
    let block = |fence: &str, nth: usize| {
        let block = page.split(fence).nth(nth).unwrap();
        block.split("```").next().unwrap().trim_start().to_owned()
    };
    let drawn = text::parse(&block("```text\n", 1)).unwrap();
    let listed = text::parse(&block("```text\n", 2)).unwrap();
    let json = json::parse(&block("```json\n", 1)).unwrap();
    assert_eq!((drawn.cells(), drawn.start(), drawn.finish()), (4, listed.start(), listed.finish()));
    let walls = file::read(block("```text\n", 4).as_bytes()).unwrap().maze;
    assert_eq!((walls.cells(), walls.finish().len()), (5, 2));
    let read = |fence, nth| file::read(block(fence, nth).as_bytes()).unwrap().maze;
    let (list, narrow, grid) = (read("```json\n", 2), read("```text\n", 5), read("```text\n", 6));
    assert!(list.lines().eq(walls.lines()), "a list of walls");
    assert_eq!((narrow.cells(), narrow.finish()), (5, &[Point::new(2, 1)][..]));
    assert_eq!((grid.cells(), grid.finish()), (6, &[Point::new(2, 1)][..]));
    assert_eq!(json::write(&json), block("```json\n", 1));
    assert_eq!(drawn.lines().collect::<Vec<_>>(), listed.lines().collect::<Vec<_>>());
    assert_eq!(drawn.lines().collect::<Vec<_>>(), json.lines().collect::<Vec<_>>());
}

/// Decisions of the format that a round trip cannot show.
#[test]
fn what_people_write_by_hand_is_understood() {
    let same = |text: &str, other: &str| {
        let read = |text: &str| {
            text::parse(&format!("line-maze: 1\n{text}")).unwrap_or_else(|e| panic!("{e}\n{text}"))
        };
        assert_eq!(read(text), read(other), "{text}\n{other}");
    };
    same("\n+---F\n|\n^\n", "\n+---F\n|\n^   .\n");
    same("\n\n\n.---F\n|\n^\n\n\n", "\n+---F\n|\n^   .\n");
    same("columns: 2\n\n+-F\n|\n^\n", "\n+---F\n|\n^\n");
    same(
        "bounds: -1,-1 5,5\norigin: 0,0\n\n>---F\n",
        "bounds: -1,-1 5,5\nstart: 0,0 E\nfinish: 1,0\n\nlines:\n0,0 1,0\n",
    );
    same("bounds: 0,0 1,0\nlines:\n0,0  1,0  \n\n  1,0 0,0", "\n+---+\n");
    same("title:   Two\n words\n\n+---F", "title:Two words\r\n\r\n+---F\r\n");
    same("note: a\\n\n  b\n\n+", "note: a\\nb\n\n+");
    same("finish: 1,0\n\n+---F", "finish:\n\n+---F");
    same("kind: line\ncell_mm: 200.0\nline_mm: 20.0004\n\n+", "\n+");
}
