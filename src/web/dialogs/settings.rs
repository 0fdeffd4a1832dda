//! The settings of a run: preference order, `epsilon`, `NODE_MAX`.

use crate::web::erase::{event, mouse, part, sig};
use leptos::prelude::*;

use super::{Modal, Width};
use crate::settings::{NODE_MAX, Order, Preference, Settings};
use crate::trace::MAX_NODES;
use crate::web::state::lab;

/// The dialog; changes count at once.
#[component]
pub fn RunSettings() -> impl IntoView {
    let lab = lab();
    view! {
        <Modal title="Settings of the run" width=Width::Narrow>
            <OrderFields />
            <EpsilonField />
            <NodeMaxField />
            <super::pace::PaceFields />
            <div class="row">
                <button class="btn" on:click=mouse(move |_| lab.set(|settings| *settings = Settings { pace: settings.pace, ..Settings::default() }))>
                    "As in the book"
                </button>
            </div>
        </Modal>
    }
}

#[component]
fn OrderFields() -> impl IntoView {
    let lab = lab();
    let seed = move || match lab.settings.with(|settings| settings.order) {
        Order::Random(seed) => Some(seed),
        Order::Fixed(_) => None,
    };
    let chosen = move || match lab.settings.with(|settings| settings.order) {
        Order::Fixed(preference) => preference.to_string(),
        Order::Random(_) => "random".to_owned(),
    };
    let choose = move |event: web_sys::Event| {
        let order = match event_target_value(&event).as_str() {
            "random" => Some(Order::Random(1)),
            fixed => fixed.parse().ok(),
        };
        if let Some(order) = order {
            lab.set(|settings| settings.order = order);
        }
    };
    let option = |preference: Preference| {
        let words = preference.turns().map(|turn| match turn.letter() {
            'S' => "straight",
            'R' => "right",
            _ => "left",
        });
        view! { <option value=preference.to_string()>{words.join(", ")}</option> }
    };
    view! {
        <label class="field">
            "Preference order at a node"
            <select class="input" id="order" on:change=event(choose) prop:value=chosen>
                {Preference::ALL.map(option).into_iter().collect_view()}
                <option value="random">"random at every choice"</option>
            </select>
        </label>
        {part(move || seed().is_some().then(|| view! {
            <NumberField id="seed" label="Seed: the same seed, the same choices" value=Signal::derive(move || seed().map(|seed| seed.to_string()).unwrap_or_default())
                hint="A whole number, 0 or more"
                read={|text: &str| text.parse::<u64>().ok()}
                set={move |seed| lab.set(|settings| settings.order = Order::Random(seed))} />
        }))}
    }
}

#[component]
fn EpsilonField() -> impl IntoView {
    let lab = lab();
    let usual = move || {
        let settings = Settings { epsilon_ms: None, ..lab.settings.get() };
        lab.maze.with(|maze| settings.epsilon(maze.scale))
    };
    let value = move || {
        lab.settings.with(|settings| settings.epsilon_ms).map(|ms| ms.to_string()).unwrap_or_default()
    };
    view! {
        <NumberField id="epsilon" label="epsilon, ms: nearer than this on both axes is the same node" value=Signal::derive(value)
            placeholder=Signal::derive(move || format!("{}: half a cell", usual()))
            hint="A whole number of milliseconds up to 1,000,000; empty for half a cell"
            read={|text: &str| if text.is_empty() { Some(None) } else { text.parse().ok().filter(|&ms: &u32| ms <= 1_000_000).map(Some) }}
            set={move |epsilon| lab.set(|settings| settings.epsilon_ms = epsilon)} />
    }
}

#[component]
fn NodeMaxField() -> impl IntoView {
    let lab = lab();
    view! {
        <NumberField id="node-max" label="NODE_MAX: nodes that the bot can remember at once" value=Signal::derive(move || lab.settings.with(|settings| settings.node_max).to_string())
            placeholder=Signal::derive(move || NODE_MAX.to_string())
            hint="A whole number from 1 to 1,048,575; the book has 50"
            read={|text: &str| text.parse().ok().filter(|n| (1..=MAX_NODES).contains(n))}
            set={move |nodes| lab.set(|settings| settings.node_max = nodes)} />
    }
}

/// A field for a number that says what it takes when it gets something else.
#[component]
pub fn NumberField<T: 'static>(
    id: &'static str,
    label: &'static str,
    #[prop(into)] value: Signal<String>,
    #[prop(optional, into)] placeholder: Option<Signal<String>>,
    hint: &'static str,
    read: impl Fn(&str) -> Option<T> + 'static,
    set: impl Fn(T) + 'static,
) -> impl IntoView {
    let wrong = RwSignal::new(false);
    let change = move |event: web_sys::Event| {
        let read = read(event_target_value(&event).trim());
        wrong.set(read.is_none());
        if let Some(value) = read {
            set(value);
        }
    };
    let hint_id = format!("{id}-hint");
    view! {
        <div class="field">
            <label for=id>{label}</label>
            <input class="input" id=id inputmode="numeric" autocomplete="off" prop:value=value
                placeholder=sig(move || placeholder.map(|text| text.get()))
                aria-invalid=sig(move || wrong.get().to_string()) aria-describedby=hint_id.clone() on:change=event(change) />
            <span class="small" id=hint_id.clone() role="status">{part(move || wrong.get().then_some(hint))}</span>
        </div>
    }
}
