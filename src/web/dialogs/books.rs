//! What can be read: all keys.

use leptos::prelude::*;

use super::Modal;
use crate::web::keys::HELP;

/// All keys.
#[component]
pub fn Keys() -> impl IntoView {
    let key = |keys: &'static str| keys.split(' ').map(|key| view! { <kbd>{key}</kbd>" " }).collect_view();
    view! {
        <Modal title="Keys">
            <div class="keycols">
                {HELP.iter().map(|(group, keys)| view! {
                    <dl>
                        <dt>{*group}</dt>
                        {keys.iter().map(|(keys, what)| view! { <dd><span>{key(keys)}</span><span>{*what}</span></dd> }).collect_view()}
                    </dl>
                }).collect_view()}
            </div>
        </Modal>
    }
}
