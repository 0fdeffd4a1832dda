//! Who is compared: two to six of all explorers.

use crate::web::erase::{event, part, sig};
use leptos::prelude::*;

use super::desk::desk;
use crate::compare::Lineup as Rules;
use crate::explorer::name::Name;
use crate::web::dialogs::Modal;

/// The dialog; changes count at once.
#[component]
pub fn Lineup() -> impl IntoView {
    let desk = desk();
    let count = move || desk.names.with(Vec::len);
    view! {
        <Modal title="Explorers side by side">
            <p role="status">{part(move || match count() {
                Rules::MOST => format!("{} of {}: take one out to put in another.", Rules::MOST, Rules::MOST),
                Rules::LEAST => format!("{} of {}; there are at least {}.", Rules::LEAST, Rules::MOST, Rules::LEAST),
                count => format!("{count} of {}.", Rules::MOST),
            })}</p>
            <Choices is_in=sig_in(move |name| desk.names.with(|names| names.contains(&name)))
                locked=sig_in(move |name| match desk.names.with(|names| names.contains(&name)) {
                    true => count() <= Rules::LEAST,
                    false => count() >= Rules::MOST,
                })
                change={move |name, there| {
                    let mut names = desk.names.get_untracked();
                    names.retain(|&other| other != name);
                    if there {
                        names.push(name);
                    }
                    desk.line_up(names);
                }} />
        </Modal>
    }
}

/// Something about each explorer.
pub type About = std::sync::Arc<dyn Fn(Name) -> bool + Send + Sync>;

/// Boxes it.
pub fn sig_in(of: impl Fn(Name) -> bool + Send + Sync + 'static) -> About {
    std::sync::Arc::new(of)
}

/// A box to tick for every explorer.
#[component]
pub fn Choices(is_in: About, locked: About, change: impl Fn(Name, bool) + Copy + 'static) -> impl IntoView {
    let choice = |&name: &Name| {
        let (is_in, locked) = (is_in.clone(), locked.clone());
        let about = name.about();
        view! {
            <li><label class="choice">
                <input type="checkbox" value=name.text() prop:checked=sig(move || is_in(name)) disabled=sig(move || locked(name))
                    on:change=event(move |event| change(name, event_target_checked(&event))) />
                <span><b>{about.title}</b><span class="small">{about.idea}</span></span>
            </label></li>
        }
    };
    view! { <ul class="choices">{Name::ALL.iter().map(choice).collect_view()}</ul> }
}
