//! The league as CSV, a line a run or a line an explorer; empty where there is nothing to say.

use alloc::format;
use alloc::string::{String, ToString};

use super::{CourseResult, League, Quartiles, Standing};
use crate::compare::score::Column;
use crate::compare::sheet;
use crate::csv::Csv;

/// A line for each run, with a head.
#[must_use]
pub fn results_csv(league: &League, results: &[CourseResult]) -> String {
    let mut csv = Csv::new(&format!("course,{}", sheet::RUN));
    for result in results {
        let Some(course) = league.courses.get(result.course) else { continue };
        let cell_mm = course.scale().cell_mm();
        for entry in &result.entries {
            csv.text(&course.name());
            let why = entry.score.as_ref().err().map(ToString::to_string).unwrap_or_default();
            let score = entry.score.as_ref().map_err(|_| why.as_str());
            sheet::run(&mut csv, entry.name, score, cell_mm);
            csv.end_row();
        }
    }
    csv.finish()
}

/// A line for each explorer, with a head: how many courses it ran and solved, and five numbers a column.
#[must_use]
pub fn standings_csv(standings: &[Standing]) -> String {
    let mut head = String::from("explorer,runs,not_started,solvable,solved,solved_percent");
    for column in Column::ALL {
        for part in ["least", "lower", "median", "upper", "most"] {
            head.push_str(&format!(",{}_{part}", key(column)));
        }
    }
    let mut csv = Csv::new(&head);
    for standing in standings {
        csv.text(standing.name.text());
        for count in [standing.runs, standing.absent, standing.solvable(), standing.solved] {
            csv.number(Some(count as f64));
        }
        csv.number(standing.share_solved().map(|share| share * 100.0));
        for column in Column::ALL {
            let five = |q: Quartiles| [q.least, q.lower, q.median, q.upper, q.most].map(Some);
            for number in standing.quartiles(column).map_or([None; 5], five) {
                csv.number(number);
            }
        }
        csv.end_row();
    }
    csv.finish()
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
