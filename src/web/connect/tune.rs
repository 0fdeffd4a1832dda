//! The robot's settings: read when it is met, changed by hand, sent together.

use crate::web::erase::{event, part, sig, submit};
use leptos::html;
use leptos::prelude::*;

use super::wire;
use crate::link::form::Form;
use crate::link::page::{Command, State};
use crate::link::tune::Name;
use crate::web::browser;

/// Settings that stand in the card itself; the thresholds behind them are folded away.
const FIRST: usize = 7;

/// The card.
#[component]
pub fn Settings() -> impl IntoView {
    let wire = wire();
    let state = Memo::new(move |_| wire.snapshot().state);
    let told = Memo::new(move |_| wire.look(|link| Name::ALL.map(|name| link.setting(name))));
    let form = RwSignal::new(Form::default());
    let folded = NodeRef::<html::Details>::new();
    let (first, further) = Name::ALL.split_at(FIRST);
    let unsent = Memo::new(move |_| form.with(Form::unsent));
    let send = move |event: web_sys::SubmitEvent| {
        event.prevent_default();
        let sent = form.try_update(|form| form.send(&told.get_untracked()));
        match sent {
            Some(Ok(changes)) => {
                changes.into_iter().for_each(|(name, value)| wire.command(Command::Set(name, value)));
            }
            Some(Err(wrong)) => {
                // What is folded away cannot be focused.
                if let Some(folded) = folded.get_untracked().filter(|_| further.contains(&wrong)) {
                    let _ = folded.set_attribute("open", "");
                }
                browser::focus(&format!("tune-{}", wrong.word()));
            }
            None => {}
        }
    };
    let field = move |name: Name| {
        let id = format!("tune-{}", name.word());
        let wrong_id = format!("{id}-wrong");
        let described = wrong_id.clone();
        let wrong = Memo::new(move |_| form.with(|form| form.wrong(name)));
        let is_wrong = move || wrong.with(Option::is_some);
        view! {
            <label class="field" title=name.meaning()>
                <span>{name.word()}<span class="unit">{format!(" {}", name.unit())}</span></span>
                <input
                    class="input" class:unsent=sig(move || form.with(|form| form.is_unsent(name))) id=id inputmode="decimal" autocomplete="off"
                    aria-invalid=sig(move || is_wrong().to_string())
                    aria-describedby=sig(move || is_wrong().then(|| described.clone()))
                    disabled=sig(move || !state.get().is_connected())
                    prop:value=sig(move || form.with(|form| told.with(|told| form.text(name, told))))
                    on:input=event(move |event| {
                        let text = event_target_value(&event);
                        form.update(|form| told.with_untracked(|told| form.set(name, text, told)));
                    })
                />
            </label>
            {part(move || wrong.get().map(|why| view! { <p class="small wrong" id=wrong_id.clone() role="alert">{why}</p> }))}
        }
    };
    view! {
        <section class="card sett" aria-labelledby="sett-title">
            <h2 id="sett-title">"Settings"<span class="spacer"></span>{part(move || (unsent.get() > 0).then(|| view! { <span class="case">{format!("{} not sent", unsent.get())}</span> }))}</h2>
            <form class="pad settings" on:submit=submit(send)>
                {first.iter().map(|&name| field(name)).collect_view()}
                <details class="further" node_ref=folded>
                    <summary>"Sensor thresholds"</summary>
                    <div class="settings">{further.iter().map(|&name| field(name)).collect_view()}</div>
                </details>
                <button class="btn primary send" id="tune-send" disabled=sig(move || state.get() != State::Ready || unsent.get() == 0)>"Send settings"</button>
            </form>
        </section>
    }
}
