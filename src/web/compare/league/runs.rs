//! All runs of the league, in any order; each can be opened.

use crate::web::erase::{event, mouse, part, sig};
use leptos::prelude::*;
use wasm_bindgen::JsCast;

use crate::compare::league::desk::{Ask, Sheet, Shown, View};
use crate::compare::score::Column;
use crate::explorer::name::Name;
use crate::web::browser;
use crate::web::compare::desk::desk;
use crate::web::compare::office;

const HEADS: [&str; 5] = ["Explored, cells", "Seconds", "Route, cells", "÷\u{a0}shortest", "÷\u{a0}fastest"];

/// The card.
#[component]
pub fn Runs(shown: Shown) -> impl IntoView {
    let league = desk().league;
    let open = move |event: web_sys::MouseEvent| {
        let element = event.target().and_then(|target| target.dyn_into::<web_sys::Element>().ok());
        let Some(row) = element.and_then(|element| element.closest("[data-course]").ok().flatten()) else {
            return;
        };
        let course = row.get_attribute("data-course").and_then(|nth| nth.parse().ok());
        if let (Some(course), Some(explorer)) = (course, row.get_attribute("data-explorer")) {
            office::ask(league, Ask::Open { course, explorer });
        }
    };
    let filter = move |event: web_sys::Event| {
        browser::let_go(&event);
        let explorer = event_target_value(&event);
        league.look(|view| (view.explorer, view.more) = (explorer, 0));
    };
    let Shown { rows, listed, runs, title, .. } = shown;
    view! {
        <section class="card runs" aria-labelledby="runs-title">
            <h2 id="runs-title">{title}<span class="spacer"></span>
                <select class="input" id="runs-of" aria-label="Runs of" on:change=event(filter) prop:value=sig(move || league.view.with(|view| view.explorer.clone()))>
                    <option value="">"all explorers"</option>
                    {league.chosen.get_untracked().into_iter().map(|name: Name| view! { <option value=name.text()>{name.about().title}</option> }).collect_view()}
                </select>
                <button class="btn" aria-label="Save all runs as CSV" on:click=mouse(move |_| office::ask(league, Ask::Csv(Sheet::Results)))>"CSV"</button></h2>
            <div class="scroll" tabindex="0" role="region" aria-labelledby="runs-title"><table class="sort">
                <thead><tr>
                    <Head column=None name="Maze" /><th scope="col">"Explorer"</th><th scope="col">"Ended"</th>
                    {View::COLUMNS.into_iter().zip(HEADS).map(|(column, name)| view! { <Head column=Some(column) name=name /> }).collect_view()}
                </tr></thead>
                <tbody inner_html=rows on:click=mouse(open)></tbody>
            </table></div>
            {(listed < runs).then(|| view! {
                <div class="pad"><button class="btn" on:click=mouse(move |_| league.look(|view| view.more += 1))>{format!("Show more: {listed} of {runs} are here")}</button></div>
            })}
        </section>
    }
}

#[component]
fn Head(column: Option<Column>, name: &'static str) -> impl IntoView {
    let league = desk().league;
    let nth = column.and_then(|column| Column::ALL.iter().position(|&other| other == column));
    let sorted = move || {
        league.view.with(|view| match view.column == nth {
            true => Some(if view.descending { "descending" } else { "ascending" }),
            false => None,
        })
    };
    let arrow = move || match sorted() {
        Some("ascending") => " ▲",
        Some(_) => " ▼",
        None => "",
    };
    let press = move |_| {
        league.look(|view| {
            view.descending = view.column == nth && !view.descending && nth.is_some();
            view.column = nth;
        });
    };
    view! {
        <th scope="col" class:num=column.is_some() aria-sort=sig(sorted)><button on:click=mouse(press)>{name}<span aria-hidden="true">{part(arrow)}</span></button></th>
    }
}
