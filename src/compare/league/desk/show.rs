//! What the desk shows: standings, box plots, and the runs in a chosen order, as markup.

use alloc::string::{String, ToString};
use alloc::vec::Vec;
use core::cmp::Ordering;
use core::fmt::Write;

use serde::{Deserialize, Serialize};

use super::super::{Absence, CourseResult, Entry, League, Standing, absences, absent_runs, standings};
use crate::compare::plot::{boxes, number};
use crate::compare::score::{Column, Score};
use crate::compare::words::{End, escaped, figure};

/// Which runs are shown, and in which order.
#[derive(Clone, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
pub struct View {
    /// Only this explorer's; everybody's if empty.
    pub explorer: String,
    /// By this column of [`Column::ALL`]; by course and explorer if none.
    pub column: Option<usize>,
    /// The greatest first; those without a number come first too.
    pub descending: bool,
    /// Besides the first 100, so many hundreds more.
    pub more: usize,
}

/// Markup for the page.
#[derive(Clone, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
pub struct Shown {
    /// A table's rows, one an explorer.
    pub standings: String,
    /// Box plots of route by shortest route.
    pub boxes: String,
    /// A table's rows, one a run.
    pub rows: String,
    /// Runs that are in `rows`.
    pub listed: usize,
    /// Runs that could be, with those that could not start.
    pub runs: usize,
    /// How many of them there are of either kind.
    pub title: String,
    /// How many runs could not start; empty where all could.
    pub absent: String,
    /// A list of them, by maze.
    pub absences: String,
}

/// Mazes whose absences are listed; the table of runs has them all.
const MOST_ABSENCES: usize = 200;

impl View {
    /// The columns of the table of runs.
    pub const COLUMNS: [Column; 5] =
        [Column::Distance, Column::Seconds, Column::Route, Column::RatioShortest, Column::RatioFastest];

    pub(super) fn of(&self, league: &League, results: &[CourseResult]) -> Shown {
        let all = standings(&league.names, results);
        let mut runs: Vec<(usize, &Entry)> = results
            .iter()
            .flat_map(|result| result.entries.iter().map(|entry| (result.course, entry)))
            .filter(|(_, entry)| self.explorer.is_empty() || entry.name.text() == self.explorer)
            .collect();
        if let Some(&column) = self.column.and_then(|nth| Column::ALL.get(nth)) {
            runs.sort_by(|(_, a), (_, b)| {
                let order = order(column, a, b);
                if self.descending { order.reverse() } else { order }
            });
        }
        let listed = runs.len().min(100 * (self.more + 1));
        let mut rows = String::new();
        for (course, entry) in &runs[..listed] {
            push_run(&mut rows, league, *course, entry);
        }
        let mut table = String::new();
        for standing in &all {
            push_shares(&mut table, standing);
            for column in [Column::RatioShortest, Column::RatioFastest, Column::Distance, Column::Memory] {
                let _ = match standing.quartiles(column) {
                    Some(q) => {
                        let [lower, median, upper] =
                            [q.lower, q.median, q.upper].map(|value| number(value, column));
                        write!(
                            table,
                            "<td class=\"num\"><b>{median}</b> <span class=\"small\">{lower}–{upper}</span></td>"
                        )
                    }
                    None => write!(table, "<td class=\"num\">–</td>"),
                };
            }
            table.push_str("</tr>");
        }
        let absences = absences(results);
        Shown {
            standings: table,
            boxes: boxes(&all, Column::RatioShortest),
            rows,
            listed,
            runs: runs.len(),
            title: title(&runs),
            absent: if absences.is_empty() { String::new() } else { absent_runs(&absences) },
            absences: list(league, &absences),
        }
    }
}

/// “108 runs, and 2 that could not start”.
fn title(runs: &[(usize, &Entry)]) -> String {
    let started = runs.iter().filter(|(_, entry)| entry.score.is_ok()).count();
    let title = alloc::format!("{started} run{}", if started == 1 { "" } else { "s" });
    match runs.len() - started {
        0 => title,
        absent => alloc::format!("{title}, and {absent} that could not start"),
    }
}

/// Who, in how many mazes, and how many of those that could be solved were.
fn push_shares(table: &mut String, standing: &Standing) {
    // Writing to a string cannot fail.
    let _ = write!(
        table,
        "<tr><th scope=\"row\">{}</th><td class=\"num\">{}",
        escaped(standing.name.about().title),
        standing.runs
    );
    if standing.absent > 0 {
        let _ = write!(table, " <span class=\"small\">of {}</span>", standing.runs + standing.absent);
    }
    let _ = match standing.percent_solved() {
        Some(percent) => write!(
            table,
            "</td><td class=\"num\"><b>{percent} %</b> <span class=\"small\">{} of {}</span></td>",
            standing.solved,
            standing.solvable()
        ),
        None => write!(table, "</td><td class=\"num\">–</td>"),
    };
}

/// Who could not start, maze by maze.
fn list(league: &League, absences: &[Absence]) -> String {
    let mut list = String::new();
    for absence in absences.iter().take(MOST_ABSENCES) {
        let maze = league.courses.get(absence.course).map(super::Course::title).unwrap_or_default();
        // Writing to a string cannot fail.
        let _ = write!(
            list,
            "<li><b>{}</b><br /><span class=\"small\">{}</span></li>",
            escaped(&maze),
            escaped(&absence.words(league))
        );
    }
    if absences.len() > MOST_ABSENCES {
        let more = absences.len() - MOST_ABSENCES;
        let _ = write!(list, "<li class=\"small\">And {more} more: the CSV of all runs has them.</li>");
    }
    list
}

/// Those that could not start come last.
fn order(column: Column, a: &Entry, b: &Entry) -> Ordering {
    match (&a.score, &b.score) {
        (Ok(a), Ok(b)) => column.order(a, b),
        (Ok(_), Err(_)) => Ordering::Less,
        (Err(_), Ok(_)) => Ordering::Greater,
        (Err(_), Err(_)) => Ordering::Equal,
    }
}

fn push_run(rows: &mut String, league: &League, course: usize, entry: &Entry) {
    let name = league.courses.get(course).map(super::Course::title).unwrap_or_default();
    let explorer = entry.name.text();
    let failed = !entry.score.as_ref().is_ok_and(Score::is_solved);
    // Writing to a string cannot fail.
    let _ = write!(
        rows,
        "<tr{} data-course=\"{course}\" data-explorer=\"{explorer}\"><td><button class=\"open\" title=\"Open this run in Step\">{}</button></td><td>{}</td>",
        if failed { " class=\"failed\"" } else { "" },
        escaped(&name),
        escaped(entry.name.about().title)
    );
    match &entry.score {
        Ok(score) => {
            let reason = score.reason().unwrap_or_default();
            let class = End::of(score.outcome).class();
            let _ = write!(
                rows,
                "<td title=\"{}\"><span class=\"end {class}\">{}</span></td>",
                escaped(&reason),
                score.ended()
            );
            for column in View::COLUMNS {
                let digits = match column {
                    Column::RatioShortest | Column::RatioFastest => 2,
                    Column::Seconds | Column::RouteSeconds => 1,
                    Column::Distance | Column::Stops | Column::Turns | Column::Memory | Column::Route => 0,
                };
                let _ = write!(rows, "<td class=\"num\">{}</td>", figure(score.number(column), digits));
            }
        }
        Err(why) => {
            let _ = write!(rows, "<td colspan=\"6\">could not start: {}</td>", escaped(&why.to_string()));
        }
    }
    rows.push_str("</tr>");
}
