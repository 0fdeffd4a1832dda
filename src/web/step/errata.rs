//! Notes at the stops and lines where the book errs. Their words are loaded when the first one is met.

use leptos::prelude::*;

use crate::explorer::book::errata::{self, ERRATA, Erratum, Kind};
use crate::web::browser::is_open;
use crate::web::erase::{event, mouse, part};
use crate::web::lazy::{self, lazy};
use crate::web::state::{Dialog, lab};

/// The notes of the moment, if there are any.
#[component]
pub fn Errata() -> impl IntoView {
    let lab = lab();
    let numbers = Memo::new(move |_| {
        lab.run.with(|run| {
            let Ok(run) = run else { return Vec::new() };
            lab.frame.with(|frame| {
                frame
                    .as_ref()
                    .map_or_else(Vec::new, |frame| errata::numbers_at(frame, run.walk).collect::<Vec<_>>())
            })
        })
    });
    let any = Memo::new(move |_| numbers.with(|numbers| !numbers.is_empty()));
    let open = RwSignal::new(false);
    part(move || any.get().then(|| lazy::view(move || notes(numbers, open))))
}

lazy! { errata;
    fn notes(numbers: Memo<Vec<usize>>, open: RwSignal<bool>) -> AnyView {
        let now = move || numbers.get().into_iter().filter_map(|number| ERRATA.get(number));
        let titles = move || now().map(|erratum| erratum.title).collect::<Vec<_>>().join(" · ");
        let lab = lab();
        view! {
            <details class="errata-notes" prop:open=open.try_get_untracked().unwrap_or_default() on:toggle=event(move |event| open.set(is_open(&event)))>
                <summary>
                    <span class="mark info">{crate::web::icons::book()}</span>
                    <span>{titles}</span>
                </summary>
                {part(move || now().map(|erratum| view! { <ErratumNote erratum=erratum /> }).collect_view())}
                <div class="row"><button class="btn" on:click=mouse(move |_| lab.dialog.set(Some(Dialog::Errata)))>"All errata"</button></div>
            </details>
        }
        .into_any()
    }
}

/// One note.
#[component]
pub fn ErratumNote(erratum: &'static Erratum) -> impl IntoView {
    let slip = |printed: &'static str, meant: &'static str| {
        view! {
            <dl class="slip">
                <div><dt>"printed"</dt><dd><del>{printed}</del></dd></div>
                <div><dt>"meant"</dt><dd><ins>{meant}</ins></dd></div>
            </dl>
        }
    };
    view! {
        <div class="note errata">
            <span class="mark info">{crate::web::icons::book()}</span>
            <div>
                <p class="small">{match erratum.kind { Kind::Slip => "The source slips here", Kind::Open => "The source leaves this open" }}</p>
                <p><b>{erratum.title}</b></p>
                <p class="small">{erratum.section}": "{erratum.text}</p>
                {erratum.printed.zip(erratum.meant).map(|(printed, meant)| slip(printed, meant))}
            </div>
        </div>
    }
}
