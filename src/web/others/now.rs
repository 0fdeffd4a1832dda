//! What just happened: the case, its sentences, how the run ended, and where the source errs.

use leptos::prelude::*;

use super::Watched;
use crate::explorer::book::errata::Erratum;
use crate::explorer::book::narrate::Narration;
use crate::web::browser::is_open;
use crate::web::erase::{event, part, sig};
use crate::web::state::{Round, lab};
use crate::web::step::now::{SaidSolved, piece, tone};
use crate::web::step::{ErratumNote, Length};

/// The case and the sentences, of either round.
pub fn said(watched: Watched, length: Length) -> AnyView {
    let lab = lab();
    let told = move || -> Option<Narration> { watched.at(|run, at| Some(run.recording.tell(at))) };
    part(move || match lab.round.get() {
        Round::Solved => view! { <SaidSolved /> }.into_any(),
        Round::Explore => told()
            .map(|told| {
                let spans = if length == Length::Full { told.said } else { told.short };
                view! {
                    <span class=tone(told.tone)>{told.case}</span>
                    <p>{spans.into_iter().map(piece).collect_view()}</p>
                    {(length == Length::Full).then(|| view! { <p class="ref">{told.section}</p> })}
                }
            })
            .into_any(),
    })
    .into_any()
}

/// The card.
pub fn card(watched: Watched) -> AnyView {
    let lab = lab();
    let over = Memo::new(move |_| lab.round.get() == Round::Explore && watched.at(super::run::is_end));
    view! {
        <section class="card" aria-labelledby="now-title">
            <h2 id="now-title">"What just happened"<span class="spacer"></span><span class="small">{part(move || watched.of(|run| run.about().title))}</span></h2>
            <div class="told" id="said" data-told>
                {said(watched, Length::Full)}
            </div>
            {part(move || over.get().then(|| super::result::card(watched)))}
            {errata(watched)}
        </section>
    }
    .into_any()
}

/// Where the source slips: those notes first that apply at this stop.
fn errata(watched: Watched) -> AnyView {
    let here = Memo::new(move |_| {
        watched.at(|run, at| super::run::errata(run, at).map(|erratum| erratum.title).collect::<Vec<_>>())
    });
    let open = RwSignal::new(false);
    let told = move || match here.get().as_slice() {
        [] => "Where the source slips or is silent".to_owned(),
        titles => titles.join(" · "),
    };
    part(move || {
        let errata = watched.of(|run| run.about().errata);
        let sorted = move || {
            let applies = |erratum: &Erratum| here.with(|here| here.contains(&erratum.title));
            let (now, other): (Vec<_>, Vec<_>) = errata.iter().partition(|erratum| applies(erratum));
            now.into_iter()
                .chain(other)
                .map(|erratum| view! { <ErratumNote erratum=erratum /> })
                .collect_view()
        };
        (!errata.is_empty()).then(|| {
            view! {
                <details class="errata-notes" class:here=sig(move || here.with(|here| !here.is_empty()))
                    prop:open=open.get_untracked() on:toggle=event(move |event| open.set(is_open(&event)))>
                    <summary>
                        <span class="mark info">{crate::web::icons::book()}</span>
                        <span>{part(told)}</span>
                    </summary>
                    {part(sorted)}
                </details>
            }
        })
    })
    .into_any()
}
