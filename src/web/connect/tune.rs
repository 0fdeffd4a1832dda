//! The robot's settings: read when it is met, changed by hand, sent together.

use crate::web::erase::{event, part, sig, submit};
use leptos::prelude::*;

use super::wire;
use crate::link::page::{Command, State};
use crate::link::tune::Name;

/// The card.
#[component]
pub fn Settings() -> impl IntoView {
    let wire = wire();
    let state = Memo::new(move |_| wire.snapshot().state);
    let told = Memo::new(move |_| wire.look(|link| Name::ALL.map(|name| link.setting(name))));
    // What was typed and not sent yet.
    let typed = RwSignal::new([const { None::<String> }; Name::COUNT]);
    let wrong = RwSignal::new(None::<(Name, String)>);
    let unsent = move || typed.with(|typed| typed.iter().flatten().count());
    let send = move |event: web_sys::SubmitEvent| {
        event.prevent_default();
        wrong.set(None);
        for name in Name::ALL {
            let Some(text) = typed.with_untracked(|typed| typed[name as usize].clone()) else { continue };
            match name.read(&text) {
                Ok(value) => {
                    typed.update(|typed| typed[name as usize] = None);
                    if told.get_untracked()[name as usize] != Some(value) {
                        wire.command(Command::Set(name, value));
                    }
                }
                Err(why) => {
                    wrong.set(Some((name, why)));
                    return;
                }
            }
        }
    };
    let field = move |name: Name| {
        let id = format!("tune-{}", name.word());
        let shown = move || {
            typed.with(|typed| typed[name as usize].clone()).unwrap_or_else(|| {
                told.with(|told| told[name as usize].map(|value| name.show(value)).unwrap_or_default())
            })
        };
        let bad = move || wrong.with(|wrong| wrong.as_ref().is_some_and(|(at, _)| *at == name));
        let changed = move || typed.with(|typed| typed[name as usize].is_some());
        view! {
            <label class="field" title=name.meaning()>
                <span>{name.word()}<span class="unit">{format!(" {}", name.unit())}</span></span>
                <input
                    class="input" class:unsent=sig(changed) id=id inputmode="decimal" autocomplete="off"
                    aria-invalid=sig(move || bad().to_string())
                    disabled=sig(move || !state.get().is_connected())
                    prop:value=sig(shown)
                    on:input=event(move |event| {
                        let text = event_target_value(&event);
                        let same = told.with_untracked(|told| told[name as usize].map(|value| name.show(value)).as_deref() == Some(text.as_str()));
                        typed.update(|typed| typed[name as usize] = (!same).then_some(text));
                    })
                />
            </label>
        }
    };
    let (first, further) = Name::ALL.split_at(7);
    view! {
        <section class="card sett" aria-labelledby="sett-title">
            <h2 id="sett-title">"Settings"<span class="spacer"></span>{part(move || (unsent() > 0).then(|| view! { <span class="case">{format!("{} not sent", unsent())}</span> }))}</h2>
            <form class="pad settings" on:submit=submit(send)>
                {first.iter().map(|&name| field(name)).collect_view()}
                <details class="further">
                    <summary>"Sensor thresholds"</summary>
                    <div class="settings">{further.iter().map(|&name| field(name)).collect_view()}</div>
                </details>
                {part(move || wrong.get().map(|(_, why)| view! { <p class="small wrong" role="alert">{why}</p> }))}
                <button class="btn primary send" id="tune-send" disabled=sig(move || state.get() != State::Ready || unsent() == 0)>"Send settings"</button>
            </form>
        </section>
    }
}
