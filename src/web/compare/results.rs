//! The table: what each run came to in this maze.

use std::fmt::Write;

use crate::web::erase::{mouse, part, sig};
use leptos::prelude::*;
use wasm_bindgen::JsCast;

use super::desk::{Desk, Field, Key, desk};
use super::pictures::called;
use super::{Tabs, open_in_stepper};
use crate::compare::forks::letter;
use crate::compare::score::{Column, Score};
use crate::compare::words::{End, ended, escaped, figure};
use crate::web::browser;
use crate::web::state::Dialog;

/// The columns of numbers; the style sheet hides those that a small screen has no room for.
const COLUMNS: [(Column, &str, &str); 8] = [
    (Column::Distance, "Explored", ""),
    (Column::Stops, "Stops", "c-s"),
    (Column::Turns, "Turns", "c-s"),
    (Column::Seconds, "Seconds", "c-s"),
    (Column::Memory, "Bytes", "c-s"),
    (Column::Route, "Route", ""),
    (Column::RatioShortest, "÷ shortest", ""),
    (Column::RatioFastest, "÷ fastest", "c-s"),
];

/// The card.
#[component]
pub fn Results() -> impl IntoView {
    let desk = desk();
    let open = move |event: web_sys::MouseEvent| {
        let nth = event.target().and_then(|target| target.dyn_into::<web_sys::Element>().ok());
        let nth = nth.and_then(|element| element.closest("[data-open]").ok().flatten());
        let nth = nth.and_then(|element| element.get_attribute("data-open")?.parse::<usize>().ok());
        let Some(nth) = nth else { return };
        let clock = untrack(|| desk.clock());
        let found = desk
            .field
            .with_untracked(|field| Some((field.entrants.get(nth)?.0, field.position(nth, clock)?.stop)));
        if let Some((name, stop)) = found {
            open_in_stepper(desk.lab, name, stop);
        }
    };
    view! {
        <section class="card results" aria-label="Results in this maze">
            <h2 class="bare">
                <Tabs />
                <span class="spacer"></span>
                <button class="btn" on:click=mouse(move |_| desk.lab.dialog.set(Some(Dialog::Lineup)))>
                    {part(move || format!("{} explorers…", desk.names.with(Vec::len)))}
                </button>
                <button class="btn" title="Speed and seconds for turns and stops" on:click=mouse(move |_| desk.lab.dialog.set(Some(Dialog::Settings)))>"Cost model…"</button>
                <button class="btn" aria-label="Save the table as CSV" on:click=mouse(move |_| save(desk))>"CSV"</button>
            </h2>
            <div class="scroll">
                <table class="sort">
                    <thead><tr>
                        <Head key=Key::Lineup name="Explorer" class="" />
                        <Head key=Key::Outcome name="Ended" class="c-e" />
                        {COLUMNS.map(|(column, name, class)| view! { <Head key=Key::Number(column) name=name class=class /> }).into_iter().collect_view()}
                    </tr></thead>
                    <tbody inner_html=sig(move || desk.field.with(|field| rows(desk, field))) on:click=mouse(open)></tbody>
                </table>
            </div>
            <p class="small bests">{part(move || desk.field.with(|field| bests(field)))}</p>
        </section>
    }
}

#[component]
fn Head(key: Key, name: &'static str, class: &'static str) -> impl IntoView {
    let desk = desk();
    let number = matches!(key, Key::Number(_));
    let sorted = move || match desk.sort.get() {
        (by, false) if by == key => Some("ascending"),
        (by, true) if by == key => Some("descending"),
        _ => None,
    };
    let arrow = move || match sorted() {
        Some("ascending") => " ▲",
        Some(_) => " ▼",
        None => "",
    };
    let press = move |_| desk.sort.update(|(by, down)| (*by, *down) = (key, *by == key && !*down));
    view! {
        <th scope="col" class=class class:num=number aria-sort=sig(sorted)><button on:click=mouse(press)>{name}<span aria-hidden="true">{part(arrow)}</span></button></th>
    }
}

/// The shortest and the fastest route of the maze: not always the same.
fn bests(field: &Field) -> String {
    let (Some(shortest), Some(fastest)) = (field.bests.shortest, field.bests.fastest) else {
        return match field.maze.start() {
            Some(_) => "No way leads to the finish.".to_owned(),
            None => "From where? The maze has no start.".to_owned(),
        };
    };
    let one = format!("Shortest route: {} cells, {:.1} s.", shortest.cells, shortest.seconds);
    if shortest.seconds > fastest.seconds + 1e-9 {
        format!(
            "{one} Fastest: {} cells, {:.1} s: longer, but with fewer turns.",
            fastest.cells, fastest.seconds
        )
    } else {
        format!("{one} No other is faster.")
    }
}

/// The rows, sorted, as markup of numbers and escaped words.
fn rows(desk: Desk, field: &Field) -> String {
    let (key, down) = desk.sort.get();
    let mut order: Vec<usize> = (0..field.entrants.len()).collect();
    let score = |nth: usize| field.racer(nth).map(|racer| &racer.entrant.score);
    order.sort_by(|&a, &b| {
        let by = match (key, score(a), score(b)) {
            (Key::Lineup, _, _) => a.cmp(&b),
            (_, None, other) => other.is_some().cmp(&false),
            (_, Some(_), None) => std::cmp::Ordering::Less,
            (Key::Outcome, Some(a), Some(b)) => a.outcome.name().cmp(b.outcome.name()),
            (Key::Number(column), Some(a), Some(b)) => column.order(a, b),
        };
        if down { by.reverse() } else { by }
    });
    let mut markup = String::new();
    for nth in order {
        let (name, racer) = &field.entrants[nth];
        let letter = letter(nth);
        let title = escaped(&called(desk, *name));
        let _ = write!(
            markup,
            "<tr{}><th scope=\"row\"><button class=\"open\" data-open=\"{nth}\" title=\"Open this run in Step\"><span class=\"who {}\">{letter}</span>{title}</button></th>",
            if racer.as_ref().is_ok_and(|racer| racer.entrant.score.is_solved()) {
                ""
            } else {
                " class=\"failed\""
            },
            letter.to_ascii_lowercase()
        );
        match racer {
            Ok(racer) => push_numbers(&mut markup, &racer.entrant.score),
            Err(why) => {
                let _ = write!(markup, "<td colspan=\"9\"><p class=\"why\">{}</p></td>", escaped(why));
            }
        }
        markup.push_str("</tr>");
    }
    markup
}

fn push_numbers(markup: &mut String, score: &Score) {
    let reason = score.reason().unwrap_or_default();
    let class = End::of(score.outcome).class();
    let _ = write!(
        markup,
        "<td class=\"c-e\" title=\"{}\"><span class=\"end {class}\">{}</span></td>",
        escaped(&reason),
        ended(score.outcome)
    );
    for (column, _, class) in COLUMNS {
        let digits = match column {
            Column::RatioShortest | Column::RatioFastest => 2,
            Column::Seconds | Column::RouteSeconds => 1,
            Column::Distance | Column::Stops | Column::Turns | Column::Memory | Column::Route => 0,
        };
        let number = match (column, score.number(column)) {
            (Column::Route, None) => "none".to_owned(),
            (_, number) => figure(number, digits),
        };
        let _ = write!(markup, "<td class=\"num {class}\">{number}</td>");
    }
}

fn save(desk: Desk) {
    let mut text = String::from(
        "explorer,outcome,reason,explored_cells,stops,turns,seconds,bytes,route_cells,ratio_shortest,ratio_fastest\n",
    );
    desk.field.with_untracked(|field| {
        for (name, racer) in &field.entrants {
            let Ok(racer) = racer else { continue };
            let score = &racer.entrant.score;
            let reason = score.reason().unwrap_or_default().replace('"', "\"\"");
            let _ = write!(text, "{name},{},\"{reason}\"", score.outcome.name());
            for (column, _, _) in COLUMNS {
                let _ = write!(
                    text,
                    ",{}",
                    score.number(column).map(|number| number.to_string()).unwrap_or_default()
                );
            }
            text.push('\n');
        }
    });
    browser::download("compare.csv", "text/csv", &text);
}
