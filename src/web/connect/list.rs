//! The turn list: here and on the robot, sent and read back.

use crate::web::erase::{mouse, part, sig};
use leptos::prelude::*;

use super::wire;
use crate::link::page::{Command, Kept, Sent, State};
use crate::link::report::Origin;
use crate::web::state::{Room, lab};

/// Letters of a long list that are shown.
const SHOWN: usize = 60;

/// The card.
#[component]
pub fn TurnLists() -> impl IntoView {
    let (lab, wire) = (lab(), wire());
    let here = Memo::new(move |_| lab.own.with(|run| run.as_ref().ok().and_then(|run| run.list.clone())));
    let letters = Memo::new(move |_| here.with(|list| list.as_ref().map(ToString::to_string)));
    let kept = Memo::new(move |_| wire.look(|link| link.kept().clone()));
    let state = Memo::new(move |_| wire.snapshot().state);
    let sent = Memo::new(move |_| letters.with(|here| wire.look(|link| link.sent_beside(here.as_deref()))));
    let ready = move || state.get() == State::Ready;
    let same = move || match (letters.get(), kept.get()) {
        (Some(here), Kept::List(list)) => Some(here == list.letters),
        (_, Kept::Nothing) => Some(false),
        (None, Kept::List(_)) | (_, Kept::Unknown) => None,
    };
    let verdict = move || match same() {
        Some(true) => view! { <span class="case go" id="same">"same on both"</span> }.into_any(),
        Some(false) => view! { <span class="case" id="same">"not the same"</span> }.into_any(),
        None => ().into_any(),
    };
    let send = move |_| {
        if let Some(list) = here.get_untracked() {
            wire.command(Command::Send(list));
        }
    };
    view! {
        <section class="card turns" aria-labelledby="turns-title">
            <h2 id="turns-title">"Turn list"<span class="spacer"></span>{part(verdict)}</h2>
            <div class="pad stack">
                <dl class="readback">
                    <dt>"Here"</dt>
                    <dd id="list-here">{part(move || match letters.get() {
                        Some(letters) => row(&letters, None),
                        None => view! {
                            <span class="small">"The maze is not solved. "</span>
                            <button class="btn" on:click=mouse(move |_| crate::web::rooms::go(lab, Room::Draw))>"Draw"</button>
                        }.into_any(),
                    })}</dd>
                    <dt>"Robot"</dt>
                    <dd id="list-robot">{part(move || match kept.get() {
                        Kept::Unknown => view! { <span class="small">"not read yet"</span> }.into_any(),
                        Kept::Nothing => view! { <span class="small">"none"</span> }.into_any(),
                        Kept::List(list) => view! {
                            {row(&list.letters, letters.get().as_deref())}
                            <span class="small">{format!("{} · read back", match list.origin { Origin::Sent => "sent by a page", Origin::Learned => "learned by itself" })}</span>
                        }.into_any(),
                    })}</dd>
                </dl>
                {part(move || progress(sent.get()))}
                <p class="small" id="sent" role="status">{part(move || sent.get().says())}</p>
                <div class="row even">
                    <button class="btn primary" id="send" disabled=sig(move || !ready() || here.with(Option::is_none)) on:click=mouse(send)>
                        {part(move || if matches!(sent.get(), Sent::Nothing | Sent::Past) { "Send" } else { "Send again" })}
                    </button>
                    <button class="btn" id="read-back" disabled=sig(move || !ready()) on:click=mouse(move |_| wire.command(Command::ReadBack))>"Read back"</button>
                </div>
            </div>
        </section>
    }
}

/// A letter a turn; where the other list has another letter, it is marked.
fn row(letters: &str, other: Option<&str>) -> AnyView {
    if letters.is_empty() {
        return view! { <span class="small">"empty: no node on the way"</span> }.into_any();
    }
    let count = letters.chars().count();
    let other: Vec<char> = other.map(|other| other.chars().collect()).unwrap_or_default();
    let differs = |i: usize, letter: char| !other.is_empty() && other.get(i) != Some(&letter);
    let cells: Vec<(char, bool)> =
        letters.chars().enumerate().take(SHOWN).map(|(i, letter)| (letter, differs(i, letter))).collect();
    view! {
        <ol class="letters-row" aria-label=letters.to_owned()>
            {cells.into_iter().map(|(letter, differs)| view! { <li class:ne=differs title=if differs { "not the same" } else { "" }>{letter}</li> }).collect_view()}
            {(count > SHOWN).then(|| view! { <li class="more">{format!("+{}", count - SHOWN)}</li> })}
        </ol>
    }
    .into_any()
}

/// Begin, data, commit, read: those that the robot has acknowledged.
fn progress(sent: Sent) -> AnyView {
    let (done, steps) = match sent {
        Sent::Nothing | Sent::Unsure | Sent::Old | Sent::Differs | Sent::Past => return ().into_any(),
        Sent::Going { done, steps } => (done, steps),
        Sent::New => (4, 4),
    };
    // Data lines are one step of the picture.
    let at = match (done, steps) {
        (0, _) => 0,
        (done, steps) if done >= steps => 4,
        (done, steps) if done + 1 == steps => 3,
        (done, steps) if done + 2 == steps => 2,
        _ => 1,
    };
    view! {
        <ol class="progress" aria-label=format!("Upload: {done} of {steps} steps acknowledged")>
            {["begin", "data", "commit", "read"].into_iter().enumerate().map(|(step, name)| view! {
                <li class:done=step < at class:doing=step == at>{name}</li>
            }).collect_view()}
        </ol>
    }
    .into_any()
}
