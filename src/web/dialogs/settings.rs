//! The explorer and its settings: preference order, `epsilon`, `NODE_MAX`, rules, and what driving costs.

use crate::web::erase::{event, mouse, part, sig};
use leptos::prelude::*;

use super::{Modal, Width};
use crate::explorer::name::Setting;
use crate::settings::{NODE_MAX, Order, Pace, Preference, Rule, Search, Settings};
use crate::trace::MAX_NODES;
use crate::web::others::choose::ExplorerField;
use crate::web::state::lab;

/// The dialog; changes count at once.
#[component]
pub fn RunSettings() -> impl IntoView {
    let lab = lab();
    let heeds = move |setting: Setting| lab.explorer.get().heeds(setting);
    view! {
        <Modal title="Settings of the run" width=Width::Narrow>
            <ExplorerField />
            {part(move || heeds(Setting::Order).then(|| view! { <OrderFields /> }))}
            {part(move || heeds(Setting::Epsilon).then(|| view! { <EpsilonField /> }))}
            {part(move || heeds(Setting::NodeMax).then(|| view! { <NodeMaxField /> }))}
            {part(move || heeds(Setting::Rule).then(|| view! { <RuleField /> }))}
            {part(move || heeds(Setting::PathMax).then(|| view! { <PathMaxField /> }))}
            {part(move || heeds(Setting::Search).then(|| view! { <SearchField /> }))}
            <CostFields />
            <div class="row">
                <button class="btn" on:click=mouse(move |_| lab.set(|settings| *settings = Settings { pace: settings.pace, ..Settings::default() }))>
                    "As in the book"
                </button>
                <button class="btn" on:click=mouse(move |_| lab.set(|settings| settings.pace = Pace::default()))>
                    "Usual costs"
                </button>
            </div>
        </Modal>
    }
}

/// Two choices as a list.
fn choice(
    id: &'static str,
    label: &'static str,
    options: [(&'static str, &'static str); 2],
    second: Signal<bool>,
    set: impl Fn(bool) + 'static,
) -> AnyView {
    let [(first, first_name), (other, other_name)] = options;
    view! {
        <label class="field">
            {label}
            <select class="input" id=id on:change=event(move |event| set(event_target_value(&event) == other)) prop:value=sig(move || if second.get() { other } else { first })>
                <option value=first>{first_name}</option>
                <option value=other>{other_name}</option>
            </select>
        </label>
    }
    .into_any()
}

#[component]
fn RuleField() -> impl IntoView {
    let lab = lab();
    let options = [
        ("special-1", "special case 1: wherever it was on the path"),
        ("basic", "basic: only where it was two steps ago"),
    ];
    let basic = sig(move || lab.settings.with(|settings| settings.rule == Rule::Basic));
    choice("rule", "Rule: when the path is cut", options, basic, move |basic| {
        lab.set(|settings| settings.rule = if basic { Rule::Basic } else { Rule::Special1 });
    })
}

#[component]
fn SearchField() -> impl IntoView {
    let lab = lab();
    let options = [("dijkstra", "Dijkstra: by distance alone"), ("a-star", "A*: with the finish in sight")];
    let star = sig(move || lab.settings.with(|settings| settings.search == Search::AStar));
    choice("search-kind", "Path search", options, star, move |star| {
        lab.set(|settings| settings.search = if star { Search::AStar } else { Search::Dijkstra });
    })
}

#[component]
fn PathMaxField() -> impl IntoView {
    let lab = lab();
    let value =
        move || lab.settings.with(|settings| settings.path_max).map(|n| n.to_string()).unwrap_or_default();
    view! {
        <NumberField id="path-max" label="Squares that the path can hold; the article has 48" value=Signal::derive(value)
            placeholder=Signal::derive(|| "no limit".to_owned())
            hint="A whole number from 1 to 1,000,000; empty for no limit"
            read={|text: &str| if text.is_empty() { Some(None) } else { text.parse().ok().filter(|n: &u32| (1..=1_000_000).contains(n)).map(Some) }}
            set={move |squares| lab.set(|settings| settings.path_max = squares)} />
    }
}

/// What driving costs: heeded by all, as it says which way is the fastest.
#[component]
fn CostFields() -> impl IntoView {
    let lab = lab();
    let number = move |of: fn(&Pace) -> f64| {
        Signal::derive(move || lab.settings.with(|settings| of(&settings.pace).to_string()))
    };
    let checked = move |pace: Pace| lab.maze.with_untracked(|maze| pace.checked(maze.scale).ok());
    let read = move |change: fn(&mut Pace, f64)| {
        move |text: &str| {
            let mut pace = lab.settings.with_untracked(|settings| settings.pace);
            change(&mut pace, text.parse().ok()?);
            checked(pace)
        }
    };
    let set = move |pace: Pace| lab.set(|settings| settings.pace = pace);
    const SECONDS: &str = "A number of seconds from 0 to 60, as in 0.4";
    view! {
        <fieldset class="costs">
            <legend>"Cost model: what driving takes"</legend>
            <NumberField id="speed" label="Speed, mm/s" value=number(|pace| pace.speed_mm_s) hint="A number above 0 and up to 1,000,000; a cell may take 2,000 s at most" read=read(|pace, n| pace.speed_mm_s = n) set=set />
            <NumberField id="turn-s" label="Turn of 90°, s" value=number(|pace| pace.turn_s) hint=SECONDS read=read(|pace, n| pace.turn_s = n) set=set />
            <NumberField id="uturn-s" label="U-turn, s" value=number(|pace| pace.uturn_s) hint=SECONDS read=read(|pace, n| pace.uturn_s = n) set=set />
            <NumberField id="stop-s" label="Stop, s" value=number(|pace| pace.stop_s) hint=SECONDS read=read(|pace, n| pace.stop_s = n) set=set />
        </fieldset>
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
