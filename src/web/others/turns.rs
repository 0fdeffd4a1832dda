//! The turn-list lab: letters on paper. Reductions one at a time, the way back, and where a list leads in the maze
//! that is open.

use leptos::prelude::*;

use crate::route::follow::{End, Followed, follow};
use crate::route::letters::read;
use crate::route::{Corners, TurnList, lab as paper};
use crate::web::browser;
use crate::web::dialogs::Modal;
use crate::web::erase::{event, mouse, part, sig};
use crate::web::paths::{self, UNIT};
use crate::web::state::{Lab, lab};

/// The most letters that are worked on.
const MOST: usize = 2000;
/// No list of so many letters is longer in any form.
const MOST_CHARACTERS: usize = 32 * MOST;

/// The dialog; it begins with the letters of the run that is shown.
#[component]
pub fn TurnLab() -> impl IntoView {
    let lab = lab();
    let first =
        untrack(|| lab.shown(|run| run.list().map(ToString::to_string))).flatten().unwrap_or_default();
    let text = RwSignal::new(first);
    let steps = RwSignal::new(0_usize);
    let corners = RwSignal::new(false);
    let list = Memo::new(move |_| {
        let too_long = || format!("At most {MOST} letters; shorten the list.");
        let text = text.get();
        if text.len() > MOST_CHARACTERS {
            return Err(too_long());
        }
        let list = read(&text).map_err(|error| format!("{}.", capital(&error.to_string())))?;
        if list.turns().len() > MOST { Err(too_long()) } else { Ok(list) }
    });
    let ok = move || list.with(|list| list.as_ref().ok().cloned()).unwrap_or_default();
    let reductions = Memo::new(move |_| paper::reductions(&ok()).0);
    let shown =
        Memo::new(move |_| reductions.with(|all| paper::after(&ok(), &all[..steps.get().min(all.len())])));
    let put = move |letters: String| {
        steps.set(0);
        text.set(letters);
    };
    view! {
        <Modal title="Turn-list lab">
            <label class="field">
                "Letters: L left, S or F straight, R right, B or U back; arrows; or a list from a file, C, JSON or CSV"
                <textarea class="input mono" id="turns" rows="2" autocomplete="off" spellcheck="false" prop:value=sig(move || text.get()) aria-invalid=sig(move || list.with(Result::is_err).to_string()) aria-describedby="turns-hint"
                    on:input=event(move |event| put(event_target_value(&event)))></textarea>
                <span class="small" id="turns-hint" role="status">{part(move || list.with(|list| list.as_ref().err().cloned()))}</span>
            </label>
            <div class="row">
                <button class="btn" on:click=mouse(move |_| put(paper::reverse(&ok()).to_string()))>"Reverse"</button>
                <button class="btn" on:click=mouse(move |_| put("LBLLBSR".to_owned()))>"An example"</button>
                <button class="btn" on:click=mouse(move |_| browser::copy(shown.get_untracked().to_string(), move |ok| super::result::copied(lab, ok)))>"Copy"</button>
            </div>
            <h3>"Reductions: x B y becomes one turn"</h3>
            <ol class="reductions" id="reductions">
                {part(move || stages(&ok(), &reductions.get(), steps.get()))}
            </ol>
            <div class="row">
                <button class="btn" disabled=sig(move || steps.get() == 0) on:click=mouse(move |_| steps.update(|steps| *steps = steps.saturating_sub(1)))>"Back"</button>
                <button class="btn primary" disabled=sig(move || reductions.with(|all| steps.get() >= all.len())) on:click=mouse(move |_| steps.update(|steps| *steps += 1))>"Reduce once"</button>
                <button class="btn" disabled=sig(move || reductions.with(|all| steps.get() >= all.len())) on:click=mouse(move |_| steps.set(reductions.with_untracked(Vec::len)))>"Reduce all"</button>
                <span class="small" role="status">{part(move || reductions.with(|all| format!("{} of {} reductions", steps.get().min(all.len()), all.len())))}</span>
            </div>
            <h3>"Where it leads in this maze"</h3>
            <label class="switch"><input type="checkbox" prop:checked=sig(move || corners.get()) on:change=event(move |event| corners.set(event_target_checked(&event))) />"the list has corners too"</label>
            {part(move || leads(lab, &shown.get(), corners.get()))}
        </Modal>
    }
}

fn capital(text: &str) -> String {
    let mut letters = text.chars();
    letters.next().map_or_else(String::new, |first| first.to_uppercase().chain(letters).collect())
}

/// The list at first and after each reduction so far; the three that go next are marked.
fn stages(list: &TurnList, reductions: &[paper::Reduction], steps: usize) -> impl IntoView + use<> {
    /// Of many stages the last ones.
    const SHOWN: usize = 30;
    let steps = steps.min(reductions.len());
    (steps.saturating_sub(SHOWN)..=steps)
        .map(|done| {
            let turns = paper::after(list, &reductions[..done]);
            let three = reductions.get(done).map(|next| next.at..next.at + 3);
            let letter = |(i, turn): (usize, &crate::geometry::Turn)| {
                let marked = three.as_ref().is_some_and(|three| three.contains(&i));
                if marked {
                    view! { <mark>{turn.letter()}</mark> }.into_any()
                } else {
                    turn.letter().into_any()
                }
            };
            let letters = turns.turns().iter().enumerate().map(letter).collect_view();
            let note = reductions.get(done).map(|next| {
                let [x, b, y] = next.three.map(crate::geometry::Turn::letter);
                format!("{x}{b}{y} → {}", next.one.letter())
            });
            view! { <li><span class="mono">{letters}</span><span class="small">{note}</span></li> }
        })
        .collect_view()
}

/// The drive along a list, drawn and told.
fn leads(lab: Lab, list: &TurnList, corners: bool) -> AnyView {
    let corners = if corners { Corners::Listed } else { Corners::LeftOut };
    lab.maze.with(|maze| {
        let Some(start) = maze.start() else {
            return view! { <p class="small">"This maze has no start. Draw one, then its letters lead somewhere."</p> }.into_any();
        };
        let Followed { route, end } = follow(maze, start, list, corners);
        let bounds = maze.bounds();
        let told = match end {
            End::Finish { left_over: 0 } => format!("It leads to the finish, in {} cells.", route.cells()),
            End::Finish { left_over } => {
                format!("It leads to the finish, in {} cells, with letters left over: {left_over}.", route.cells())
            }
            End::Strayed(why) => format!("{}.", capital(&why.to_string())),
        };
        let reached = route.legs.last().map_or(route.start, |leg| leg.at);
        let (w, h) = (bounds.width() as i32 * UNIT, bounds.height() as i32 * UNIT);
        let (x, y) = (bounds.sw().x * UNIT - UNIT / 2, -bounds.ne().y * UNIT - UNIT / 2);
        let way = paths::line([route.start].into_iter().chain(route.legs.iter().map(|leg| leg.at)));
        let tape = paths::cells((bounds.sw(), bounds.ne()), |at, heading| maze.has_line(at, heading));
        let finish = maze.finish().to_vec();
        view! {
            <p id="leads" role="status">{told.clone()}</p>
            <svg class="maze led" viewBox=format!("{x} {y} {w} {h}") role="img" aria-label=told>
                <path class="tape" d=tape />
                <path class="route" d=way />
                {finish.into_iter().map(|at| view! { <rect class="finish" x=at.x * UNIT - 18 y=-at.y * UNIT - 14 width="36" height="28" rx="3" /> }).collect_view()}
                <circle class="bot-body" cx=reached.x * UNIT cy=-reached.y * UNIT r="18" />
            </svg>
        }
        .into_any()
    })
}
