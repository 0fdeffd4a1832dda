//! What runs came to as CSV, a line each; the names are those of `linemaze run --json`.

use alloc::string::String;

use super::score::Score;
use crate::csv::Csv;
use crate::explorer::name::Name;
use crate::report::CANNOT_START;

/// The columns of a run.
pub(super) const RUN: &str = "explorer,outcome,reason,stops,distance_cells,distance_mm,right_turns,left_turns,\
u_turns,seconds,memory_bytes,route_cells,route_s,shortest_cells,shortest_s,fastest_cells,fastest_s,\
ratio_shortest,ratio_fastest";

/// Those of them that hold numbers.
const NUMBERS: usize = 16;

/// A line for each explorer in a maze whose cells have this length, with a head; who could not start is there too,
/// with the reason.
///
/// ```
/// use line_maze_lab::compare::sheet::runs_csv;
/// use line_maze_lab::explorer::name::Name;
/// let absent = runs_csv([(Name::Book, Err("The maze has no start."))], 200.0);
/// assert!(absent.ends_with("\nbook,cannot-start,The maze has no start.,,,,,,,,,,,,,,,,\n"));
/// ```
pub fn runs_csv<'a>(
    runs: impl IntoIterator<Item = (Name, Result<&'a Score, &'a str>)>,
    cell_mm: f64,
) -> String {
    let mut csv = Csv::new(RUN);
    for (name, score) in runs {
        run(&mut csv, name, score, cell_mm);
        csv.end_row();
    }
    csv.finish()
}

/// The cells of a run.
pub(super) fn run(csv: &mut Csv, name: Name, score: Result<&Score, &str>, cell_mm: f64) {
    csv.text(name.text());
    let numbers = match score {
        Ok(score) => {
            csv.text(score.outcome.name());
            csv.text(&score.reason().unwrap_or_default());
            numbers(score, cell_mm)
        }
        Err(why) => {
            csv.text(CANNOT_START);
            csv.text(why);
            [None; NUMBERS]
        }
    };
    numbers.into_iter().for_each(|number| csv.number(number));
}

fn numbers(score: &Score, cell_mm: f64) -> [Option<f64>; NUMBERS] {
    let tally = &score.tally;
    let (shortest, fastest) = (score.bests.shortest, score.bests.fastest);
    let route = score.route.ok();
    [
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
    ]
}
