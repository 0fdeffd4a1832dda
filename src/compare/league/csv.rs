//! The league as CSV (RFC 4180), a line a run or a line an explorer; empty where there is nothing to say.

use alloc::string::{String, ToString};
use core::fmt::Write;

use super::{CourseResult, League, Quartiles, Standing};
use crate::compare::score::{Column, Score};
use crate::report::{CANNOT_START, tidy};

const RESULTS: &str = "course,explorer,outcome,reason,stops,distance_cells,distance_mm,right_turns,left_turns,\
u_turns,seconds,memory_bytes,route_cells,route_s,shortest_cells,shortest_s,fastest_cells,fastest_s,\
ratio_shortest,ratio_fastest\n";

/// A line for each run, with a head.
#[must_use]
pub fn results_csv(league: &League, results: &[CourseResult]) -> String {
    let mut text = String::from(RESULTS);
    for result in results {
        let Some(course) = league.courses.get(result.course) else { continue };
        let cell_mm = course.scale().cell_mm();
        for entry in &result.entries {
            cell(&mut text, &course.name());
            cell(&mut text, entry.name.text());
            match &entry.score {
                Ok(score) => run(&mut text, score, cell_mm),
                Err(why) => {
                    cell(&mut text, CANNOT_START);
                    cell(&mut text, &why.to_string());
                    // The other columns stay empty.
                    let left = RESULTS.matches(',').count() - 3;
                    (0..left).for_each(|_| text.push(','));
                }
            }
            end_line(&mut text);
        }
    }
    text
}

fn run(text: &mut String, score: &Score, cell_mm: f64) {
    cell(text, score.outcome.name());
    cell(text, &score.reason().unwrap_or_default());
    let tally = &score.tally;
    let (shortest, fastest) = (score.bests.shortest, score.bests.fastest);
    let route = score.route.ok();
    for number in [
        Some(f64::from(tally.stops)),
        Some(f64::from(tally.cells)),
        Some(f64::from(tally.cells) * cell_mm),
        Some(f64::from(tally.right_turns)),
        Some(f64::from(tally.left_turns)),
        Some(f64::from(tally.u_turns)),
        Some(score.seconds),
        Some(f64::from(score.memory_bytes)),
        route.map(|route| f64::from(route.cells)),
        route.map(|route| route.seconds),
        shortest.map(|best| f64::from(best.cells)),
        shortest.map(|best| best.seconds),
        fastest.map(|best| f64::from(best.cells)),
        fastest.map(|best| best.seconds),
        score.ratio_shortest(),
        score.ratio_fastest(),
    ] {
        number_cell(text, number);
    }
}

/// A line for each explorer, with a head: how many courses it ran and solved, and five numbers a column.
#[must_use]
pub fn standings_csv(standings: &[Standing]) -> String {
    let mut text = String::from("explorer,runs,solved,share_solved,");
    for column in Column::ALL {
        for part in ["least", "lower", "median", "upper", "most"] {
            // Writing to a string cannot fail.
            let _ = write!(text, "{}_{part},", key(column));
        }
    }
    end_line(&mut text);
    for standing in standings {
        cell(&mut text, standing.name.text());
        number_cell(&mut text, Some(standing.runs as f64));
        number_cell(&mut text, Some(standing.solved as f64));
        number_cell(&mut text, standing.share_solved());
        for column in Column::ALL {
            let five = |q: Quartiles| [q.least, q.lower, q.median, q.upper, q.most].map(Some);
            for number in standing.quartiles(column).map_or([None; 5], five) {
                number_cell(&mut text, number);
            }
        }
        end_line(&mut text);
    }
    text
}

/// A column's name for programs, as the reports have it.
const fn key(column: Column) -> &'static str {
    match column {
        Column::Distance => "distance_cells",
        Column::Stops => "stops",
        Column::Turns => "turns",
        Column::Seconds => "seconds",
        Column::Memory => "memory_bytes",
        Column::Route => "route_cells",
        Column::RouteSeconds => "route_s",
        Column::RatioShortest => "ratio_shortest",
        Column::RatioFastest => "ratio_fastest",
    }
}

/// A text and a comma, in quotes where it needs them.
fn cell(text: &mut String, value: &str) {
    if value.contains([',', '"', '\n', '\r']) {
        text.push('"');
        text.push_str(&value.replace('"', "\"\""));
        text.push('"');
    } else {
        text.push_str(value);
    }
    text.push(',');
}

fn number_cell(text: &mut String, number: Option<f64>) {
    if let Some(number) = number {
        // Writing to a string cannot fail.
        let _ = write!(text, "{}", tidy(number));
    }
    text.push(',');
}

/// Takes the last comma away.
fn end_line(text: &mut String) {
    text.pop();
    text.push('\n');
}
