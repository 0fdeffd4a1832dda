//! What just happened: the case, its sentences, how the run ended, and where the source errs.

use leptos::prelude::*;

use super::Watched;
use crate::explorer::book::narrate::Narration;
use crate::web::erase::{part, sig};
use crate::web::state::{Round, lab};
use crate::web::step::now::{SaidSolved, piece, tone};
use crate::web::step::{ErratumNote, Length};

/// The case and the sentences, of either round.
pub fn said(watched: Watched, length: Length) -> AnyView {
    let lab = lab();
    let told = move || -> Option<Narration> { watched.at(|run, at| Some(run.recording.narrate(&at.stop))) };
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
    let playing_fast = move || lab.playing().with(|playback| playback.is_playing() && playback.speed() > 2.0);
    let over = Memo::new(move |_| lab.round.get() == Round::Explore && watched.at(|run, at| at.is_end(run)));
    view! {
        <section class="card" aria-labelledby="now-title">
            <h2 id="now-title">"What just happened"<span class="spacer"></span><span class="small">{part(move || watched.of(|run| run.about().title))}</span></h2>
            <div class="now" id="said" role="status" aria-live=sig(move || if playing_fast() { "off" } else { "polite" })>
                {said(watched, Length::Full)}
            </div>
            {part(move || over.get().then(|| super::result::card(watched)))}
            {errata(watched)}
        </section>
    }
    .into_any()
}

/// Where the source slips.
fn errata(watched: Watched) -> AnyView {
    part(move || {
        let errata = watched.of(|run| run.about().errata);
        (!errata.is_empty()).then(|| {
            let titles = errata.iter().map(|erratum| erratum.title).collect::<Vec<_>>().join(" · ");
            view! {
                <details class="errata-notes">
                    <summary>
                        <span class="mark info">{crate::web::icons::book()}</span>
                        <span>{titles}</span>
                    </summary>
                    {errata.iter().map(|erratum| view! { <ErratumNote erratum=erratum /> }).collect_view()}
                </details>
            }
        })
    })
    .into_any()
}
