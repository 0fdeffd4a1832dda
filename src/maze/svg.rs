//! A maze as a picture: SVG in millimetres, so that a print at 100 % is the maze in its true size.

use alloc::string::String;
use core::fmt::{self, Write};

use super::{Kind, Maze, Start, polyline, walls};
use crate::geometry::Point;

/// Writes the picture. A line is as wide as the scale says, the finish is a black block, the start a green
/// disc with an arrow; one cell of white is left around the lattice. Colours are fixed: it is for paper.
///
/// ```
/// use line_maze_lab::maze::{samples, svg};
/// let picture = svg::write(&samples::figure_3_1());
/// assert!(picture.starts_with("<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"1800mm\" height=\"1400mm\""));
/// ```
#[must_use]
pub fn write(maze: &Maze) -> String {
    written(maze, None)
}

/// A drive on the floor.
#[derive(Clone, Copy, Debug)]
pub struct Way<'a> {
    /// From where to where, turning point by turning point.
    pub points: &'a [Point],
    /// Whose it is.
    pub title: &'a str,
}

/// Writes the picture with a drive: a green line with white sides, half as wide as the maze's lines.
#[must_use]
pub fn write_way(maze: &Maze, way: &Way<'_>) -> String {
    written(maze, Some(way))
}

fn written(maze: &Maze, way: Option<&Way<'_>>) -> String {
    let floor = Floor::of(maze);
    let mut out = String::new();
    // Writing to a string cannot fail.
    let _ = draw(&mut out, maze, way, &floor);
    out
}

/// Where lattice points are on the paper.
struct Floor {
    cell_um: i64,
    line_um: i64,
    sw: Point,
    /// Micrometres to the lowest points from the top.
    south_um: i64,
    width_um: i64,
    height_um: i64,
}

impl Floor {
    fn of(maze: &Maze) -> Self {
        let (cell_um, line_um) = (i64::from(maze.scale.cell_um()), i64::from(maze.scale.line_um()));
        let bounds = maze.bounds();
        Self {
            cell_um,
            line_um,
            sw: bounds.sw(),
            south_um: i64::from(bounds.height()) * cell_um,
            width_um: (i64::from(bounds.width()) + 1) * cell_um,
            height_um: (i64::from(bounds.height()) + 1) * cell_um,
        }
    }

    /// Micrometres from the left and from the top.
    fn point(&self, at: Point) -> (i64, i64) {
        let (east, north) = (i64::from(at.x) - i64::from(self.sw.x), i64::from(at.y) - i64::from(self.sw.y));
        ((east + 1) * self.cell_um, self.south_um - north * self.cell_um)
    }

    fn at(&self, at: Point) -> Pair {
        let (x, y) = self.point(at);
        Pair(Mm(x), Mm(y))
    }
}

/// Micrometres, written as millimetres.
#[derive(Clone, Copy)]
struct Mm(i64);

struct Pair(Mm, Mm);

impl fmt::Display for Mm {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let (whole, mut rest) = (self.0.unsigned_abs() / 1000, self.0.unsigned_abs() % 1000);
        let mut digits = 3;
        while digits > 0 && rest % 10 == 0 {
            rest /= 10;
            digits -= 1;
        }
        f.write_str(if self.0 < 0 { "-" } else { "" })?;
        if digits == 0 { write!(f, "{whole}") } else { write!(f, "{whole}.{rest:0digits$}") }
    }
}

impl fmt::Display for Pair {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{} {}", self.0, self.1)
    }
}

fn draw(out: &mut String, maze: &Maze, way: Option<&Way<'_>>, floor: &Floor) -> fmt::Result {
    let (width, height) = (Mm(floor.width_um), Mm(floor.height_um));
    writeln!(
        out,
        "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"{width}mm\" height=\"{height}mm\" \
         viewBox=\"0 0 {width} {height}\">"
    )?;
    if !maze.about.title.is_empty() {
        writeln!(out, "<title>{}</title>", Escaped(&maze.about.title))?;
    }
    writeln!(out, "<path fill=\"#fff\" d=\"M0 0H{width}V{height}H0z\"/>")?;
    if let Some(start) = maze.start() {
        draw_start(out, floor, start)?;
    }
    match maze.kind {
        Kind::Line => draw_lines(out, maze, floor)?,
        Kind::Wall => draw_walls(out, maze, floor)?,
    }
    if let Some(way) = way {
        draw_way(out, floor, way)?;
    }
    draw_finish(out, maze, floor)?;
    out.write_str("</svg>\n")
}

/// Begins a path with square ends and mitred corners: a corner of tape is as sharp as tape.
fn begin_stroke(out: &mut String, floor: &Floor) -> fmt::Result {
    let width = Mm(floor.line_um);
    write!(out, "<path fill=\"none\" stroke=\"#111\" stroke-width=\"{width}\" stroke-linecap=\"square\" d=\"")
}

fn draw_lines(out: &mut String, maze: &Maze, floor: &Floor) -> fmt::Result {
    begin_stroke(out, floor)?;
    for polyline in polyline::trace(maze) {
        for (nth, pair) in polyline.windows(2).enumerate() {
            if nth == 0 {
                write!(out, "M{}", floor.at(pair[0]))?;
            }
            let Pair(x, y) = floor.at(pair[1]);
            if pair[0].y == pair[1].y { write!(out, "H{x}")? } else { write!(out, "V{y}")? }
        }
    }
    out.write_str("\"/>\n")
}

/// Walls stand half a cell from the middles of squares; a lone post is a stroke of no length.
fn draw_walls(out: &mut String, maze: &Maze, floor: &Floor) -> fmt::Result {
    begin_stroke(out, floor)?;
    let half = floor.cell_um / 2;
    let post = |at: Point| {
        let (x, y) = floor.point(at);
        (x - half, y + half)
    };
    for run in walls::runs(maze) {
        let (from, to) = (post(run.from), post(run.to));
        write!(out, "M{}", Pair(Mm(from.0), Mm(from.1)))?;
        if from.1 == to.1 { write!(out, "H{}", Mm(to.0))? } else { write!(out, "V{}", Mm(to.1))? }
    }
    for at in walls::lone_posts(maze) {
        let (x, y) = post(at);
        write!(out, "M{}h0", Pair(Mm(x), Mm(y)))?;
    }
    out.write_str("\"/>\n")
}

/// In print without colours it is a light line in a dark one.
fn draw_way(out: &mut String, floor: &Floor, way: &Way<'_>) -> fmt::Result {
    writeln!(out, "<g fill=\"none\" stroke-linejoin=\"round\"><title>{}</title>", Escaped(way.title))?;
    for (colour, width_um) in [("#fff", floor.line_um * 3 / 4), ("#157347", floor.line_um / 2)] {
        write!(out, "<path stroke=\"{colour}\" stroke-width=\"{}\" d=\"", Mm(width_um))?;
        for (nth, &point) in way.points.iter().enumerate() {
            write!(out, "{}{}", if nth == 0 { "M" } else { "L" }, floor.at(point))?;
        }
        out.write_str("\"/>\n")?;
    }
    out.write_str("</g>\n")
}

/// A disc of half a cell under the line; the arrow is in its rear half, which the line leaves free.
fn draw_start(out: &mut String, floor: &Floor, start: Start) -> fmt::Result {
    let (at, radius) = (floor.at(start.at), floor.cell_um / 4);
    let degrees = u32::from(start.heading.index()) * 90;
    let (side, tip, base) = (Mm(radius * 2 / 5), Mm(radius * 3 / 10), Mm(radius * 4 / 5));
    writeln!(
        out,
        "<g transform=\"translate({at}) rotate({degrees})\"><circle fill=\"#157347\" r=\"{}\"/>\
         <path fill=\"#fff\" d=\"M-{side} {base}H{side}L0 {tip}z\"/></g>",
        Mm(radius)
    )
}

/// A block of half a cell.
fn draw_finish(out: &mut String, maze: &Maze, floor: &Floor) -> fmt::Result {
    let half = floor.cell_um / 4;
    for &at in maze.finish() {
        let (x, y) = floor.point(at);
        let (left, top, side) = (Mm(x - half), Mm(y - half), Mm(half * 2));
        writeln!(out, "<path fill=\"#111\" d=\"M{left} {top}h{side}v{side}h-{side}z\"/>")?;
    }
    Ok(())
}

/// Text as XML holds it.
struct Escaped<'a>(&'a str);

impl fmt::Display for Escaped<'_> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        for char in self.0.chars() {
            match char {
                '&' => f.write_str("&amp;")?,
                '<' => f.write_str("&lt;")?,
                '>' => f.write_str("&gt;")?,
                // XML has no place for them.
                control if control.is_control() || matches!(control, '\u{fffe}' | '\u{ffff}') => {
                    f.write_char(' ')?;
                }
                other => f.write_char(other)?,
            }
        }
        Ok(())
    }
}

#[cfg(test)]
#[allow(clippy::unwrap_used)]
mod tests {
    use super::*;
    use crate::maze::text;

    fn picture(text: &str) -> String {
        write(&text::parse(&alloc::format!("line-maze: 1\n{text}")).unwrap())
    }

    #[test]
    fn a_picture_is_true_to_scale() {
        let expected = expect_test::expect![[r##"
            <svg xmlns="http://www.w3.org/2000/svg" width="301.5mm" height="301.5mm" viewBox="0 0 301.5 301.5">
            <title>&lt;A &amp; B&gt;</title>
            <path fill="#fff" d="M0 0H301.5V301.5H0z"/>
            <g transform="translate(100.5 201) rotate(0)"><circle fill="#157347" r="25.125"/><path fill="#fff" d="M-10.05 20.1H10.05L0 7.537z"/></g>
            <path fill="none" stroke="#111" stroke-width="19.05" stroke-linecap="square" d="M100.5 201V100.5H201"/>
            <path fill="#111" d="M175.875 75.375h50.25v50.25h-50.25z"/>
            </svg>
        "##]];
        expected.assert_eq(&picture(
            "title: <A & B>\ncell_mm: 100.5\nline_mm: 19.05\norigin: -1,-1\n\n+---F\n|\n^   .\n",
        ));
    }

    #[test]
    fn a_way_lies_on_the_lines_and_under_the_finish() {
        let maze = text::parse("line-maze: 1\ncell_mm: 100\nline_mm: 20\n\n+---F\n|\n^   .\n").unwrap();
        let points = [(0, 0), (0, 1), (1, 1)].map(|(x, y)| Point::new(x, y));
        let picture = write_way(&maze, &Way { points: &points, title: "A & B: 2 cells" });
        let way = "<g fill=\"none\" stroke-linejoin=\"round\"><title>A &amp; B: 2 cells</title>\n\
            <path stroke=\"#fff\" stroke-width=\"15\" d=\"M100 200L100 100L200 100\"/>\n\
            <path stroke=\"#157347\" stroke-width=\"10\" d=\"M100 200L100 100L200 100\"/>\n</g>\n";
        let (before, after) = picture.split_once(way).unwrap();
        assert_eq!(alloc::format!("{before}{after}"), write(&maze));
        assert!(before.contains("stroke=\"#111\"") && after.contains("<path fill=\"#111\""), "{picture}");
    }

    #[test]
    fn walls_stand_where_there_is_no_opening() {
        let walls = picture("kind: wall\ncell_mm: 100\nline_mm: 10\n\n>---F\n|   |\n+---+\n");
        let path = walls.lines().find(|line| line.contains("stroke")).unwrap();
        // A square room of two by two cells, and the post in its middle.
        assert!(path.ends_with("d=\"M50 250H250M50 50H250M50 250V50M250 250V50M150 150h0\"/>"), "{path}");
    }
}
