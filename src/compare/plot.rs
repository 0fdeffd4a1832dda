//! The comparison's plots: pure layout, numbers in, SVG markup out. Colours and hatching are the style sheet's.

use alloc::format;
use alloc::string::String;
use core::fmt::Write;

use super::league::{Quartiles, Standing};
use super::orders::{Bar, Draws};
use super::score::Column;
use super::words::escaped;

/// Units of a plot's width; the picture scales to its box.
const WIDTH: f64 = 412.0;
/// Room for the bars of a histogram.
const BARS: f64 = 128.0;
/// Room for a number over a bar, or under it.
const LINE: f64 = 18.0;

/// Which bars are marked.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Marked {
    /// The shortest of the maze.
    pub shortest: Option<u32>,
    /// Where the order that is set lands.
    pub own: Option<u32>,
}

/// A histogram of route lengths.
///
/// ```
/// use line_maze_lab::compare::orders::Bar;
/// use line_maze_lab::compare::plot::{Marked, histogram};
/// let bars = [Bar { from: 9, to: 9, count: 3 }, Bar { from: 10, to: 10, count: 1 }];
/// let svg = histogram(&bars, Marked { shortest: Some(9), own: Some(10) });
/// assert_eq!(svg.matches("<rect class=\"bar").count(), 2);
/// assert!(svg.contains("class=\"bar best\"") && svg.contains("class=\"bar own\""));
/// ```
#[must_use]
pub fn histogram(bars: &[Bar], marked: Marked) -> String {
    let most = bars.iter().map(|bar| bar.count).max().unwrap_or(0).max(1) as f64;
    let slot = (WIDTH / bars.len().max(1) as f64).min(72.0);
    let left = (WIDTH - slot * bars.len() as f64) / 2.0;
    let floor = LINE + BARS;
    let mut svg = open(floor + LINE + 4.0);
    for (nth, bar) in bars.iter().enumerate() {
        let holds = |cells: Option<u32>| cells.is_some_and(|cells| (bar.from..=bar.to).contains(&cells));
        let class = match (holds(marked.shortest), holds(marked.own)) {
            (true, _) => "bar best",
            (false, true) => "bar own",
            (false, false) => "bar",
        };
        let (x, middle) = (left + slot * nth as f64, left + slot * (nth as f64 + 0.5));
        let height = if bar.count == 0 { 0.0 } else { (BARS * bar.count as f64 / most).max(2.0) };
        let top = floor - height;
        // Writing to a string cannot fail.
        let _ = write!(
            svg,
            "<rect class=\"{class}\" x=\"{:.1}\" y=\"{top:.1}\" width=\"{:.1}\" height=\"{height:.1}\" rx=\"2\"/>\
             <text class=\"n\" x=\"{middle:.1}\" y=\"{:.1}\">{}</text>",
            x + 2.5,
            slot - 5.0,
            top - 5.0,
            bar.count
        );
        let label =
            if bar.from == bar.to { format!("{}", bar.from) } else { format!("{}–{}", bar.from, bar.to) };
        // Wide labels stand under every other bar.
        if label.len() < 5 || slot > 48.0 || nth % 2 == 0 {
            let _ = write!(
                svg,
                "<text class=\"x\" x=\"{middle:.1}\" y=\"{:.1}\">{label}</text>",
                floor + LINE - 3.0
            );
        }
    }
    let _ = write!(svg, "<path class=\"axis\" d=\"M0 {floor}H{WIDTH}\"/></svg>");
    svg
}

/// What a histogram shows, in words.
#[must_use]
pub fn histogram_words(bars: &[Bar]) -> String {
    let mut words = String::from("Histogram of route length: ");
    for (nth, bar) in bars.iter().filter(|bar| bar.count > 0).enumerate() {
        let _ = write!(words, "{}{} at {}", if nth > 0 { ", " } else { "" }, bar.count, bar.from);
        if bar.to > bar.from {
            let _ = write!(words, " to {}", bar.to);
        }
    }
    words + " cells"
}

/// What the draws say, in a sentence or two.
///
/// ```
/// use line_maze_lab::compare::orders::{Draw, Draws};
/// use line_maze_lab::compare::plot::draws_words;
/// let draws: Draws = [9, 9, 12, 18].into_iter().zip(1..).map(|(cells, seed)| Draw { seed, route_cells: Some(cells) }).collect();
/// assert_eq!(
///     draws_words(&draws, Some(9)),
///     "Half are 9 cells or shorter. 2 of 4 random orders find the shortest; the worst route is 2.0\u{a0}× as long."
/// );
/// ```
#[must_use]
pub fn draws_words(draws: &Draws, shortest: Option<u32>) -> String {
    let (solved, failed) = draws.counts();
    let (Some(median), Some(worst)) = (draws.median_cells(), draws.worst().and_then(|draw| draw.route_cells))
    else {
        return String::from("No order leads to the finish.");
    };
    let mut words = format!("Half are {median} cells or shorter.");
    if let Some(shortest) = shortest.filter(|&cells| cells > 0) {
        let _ = write!(
            words,
            " {} of {} random orders find the shortest; the worst route is {:.1}\u{a0}× as long.",
            draws.at_most(shortest),
            solved + failed,
            f64::from(worst) / f64::from(shortest)
        );
    }
    if failed > 0 {
        let _ = write!(words, " {failed} left no route.");
    }
    words
}

/// Names stand left of a box plot's boxes.
const NAMES: f64 = 142.0;
/// Numbers stand right of them.
const NUMBERS: f64 = 40.0;
/// Units of a row.
const ROW: f64 = 25.0;

/// Box plots of a column, a row for each explorer that has numbers there.
#[must_use]
pub fn boxes(standings: &[Standing], column: Column) -> String {
    let rows = || standings.iter().filter_map(|standing| Some((standing, standing.quartiles(column)?)));
    let least = rows().map(|(_, q)| q.least).fold(f64::INFINITY, f64::min);
    let most = rows().map(|(_, q)| q.upper).fold(0.0, f64::max);
    if rows().next().is_none() {
        return String::new();
    }
    let most = if most > least { most } else { least + 1.0 };
    let room = WIDTH - NAMES - NUMBERS;
    let x = |number: f64| NAMES + ((number - least) / (most - least)).clamp(0.0, 1.0) * room;
    let count = rows().count() as f64;
    let mut svg = open(count * ROW + LINE + 2.0);
    for (nth, (standing, q)) in rows().enumerate() {
        let top = nth as f64 * ROW;
        let Quartiles { lower, median, upper, .. } = q;
        let part = if standing.solved < standing.solvable() { " part" } else { "" };
        // Writing to a string cannot fail.
        let _ = write!(
            svg,
            "<text class=\"who\" x=\"0\" y=\"{:.1}\">{}</text><path class=\"base\" d=\"M{NAMES} {:.1}H{:.1}\"/>\
             <rect class=\"box{part}\" x=\"{:.1}\" y=\"{:.1}\" width=\"{:.1}\" height=\"15\" rx=\"2.5\"/>\
             <rect class=\"median\" x=\"{:.1}\" y=\"{:.1}\" width=\"4\" height=\"19\" rx=\"2\"/>\
             <text class=\"value\" x=\"{WIDTH}\" y=\"{:.1}\">{}</text>",
            top + 16.0,
            escaped(standing.name.short()),
            top + 12.0,
            WIDTH - NUMBERS,
            x(lower),
            top + 4.5,
            (x(upper) - x(lower)).max(2.0),
            x(median) - 2.0,
            top + 2.5,
            top + 16.0,
            number(median, column),
        );
    }
    let foot = count * ROW + LINE - 4.0;
    for (at, class) in [(least, "from"), (f64::midpoint(least, most), "x"), (most, "to")] {
        let _ = write!(
            svg,
            "<text class=\"{class}\" x=\"{:.1}\" y=\"{foot:.1}\">{}</text>",
            x(at),
            number(at, column)
        );
    }
    svg + "</svg>"
}

/// A number of this column, as short as it makes sense.
#[must_use]
pub fn number(value: f64, column: Column) -> String {
    match column {
        Column::RatioShortest | Column::RatioFastest => format!("{value:.2}"),
        Column::Seconds | Column::RouteSeconds => format!("{value:.1}"),
        Column::Distance | Column::Stops | Column::Turns | Column::Memory | Column::Route => {
            format!("{value:.0}")
        }
    }
}

fn open(height: f64) -> String {
    format!(
        "<svg class=\"plot\" viewBox=\"0 0 {WIDTH} {height:.1}\" aria-hidden=\"true\">\
         <defs><pattern id=\"hatch\" width=\"7\" height=\"7\" patternUnits=\"userSpaceOnUse\" patternTransform=\"rotate(45)\">\
         <rect class=\"hatch-under\" width=\"7\" height=\"7\"/><rect class=\"hatch-over\" width=\"3.5\" height=\"7\"/></pattern>\
         <pattern id=\"hatch-part\" width=\"7\" height=\"7\" patternUnits=\"userSpaceOnUse\" patternTransform=\"rotate(45)\">\
         <rect class=\"part-under\" width=\"7\" height=\"7\"/><rect class=\"part-over\" width=\"3.5\" height=\"7\"/></pattern></defs>"
    )
}
