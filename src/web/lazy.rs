//! Parts of the page that are loaded when they are first needed, so that a first visit loads only what it
//! shows. `cargo xtask dist` splits the wasm at the functions marked with [`lazy!`]; other builds hold all in
//! one piece, and the functions answer at once.

use std::future::{Future, poll_fn};
use std::pin::Pin;
use std::task::Poll;

use futures_util::FutureExt;
use leptos::prelude::*;
use leptos::reactive::computed::ScopedFuture;
pub use leptos::wasm_split::SplitLoaderError as NotLoaded;

use crate::web::erase::{mouse, part};
use crate::web::keeping::Kept;
use crate::web::state::{Lab, ToastTone};

/// Makes a function the door to a part of the page: `lazy! { part; fn name(…) -> Type { … } }` is an async
/// function with the result `Result<Type, NotLoaded>`. What only these functions use is in the part's file.
macro_rules! lazy {
    ($part:ident; $(#[$meta:meta])* $vis:vis fn $name:ident($($arg:ident: $type:ty),*) -> $out:ty $body:block) => {
        $(#[$meta])*
        #[cfg(split)]
        #[leptos::wasm_split::wasm_split($part, wasm_split_path = ::leptos::wasm_split, fallible)]
        $vis fn $name($($arg: $type),*) -> Result<$out, $crate::web::lazy::NotLoaded> {
            Ok($body)
        }
        $(#[$meta])*
        #[cfg(not(split))]
        $vis async fn $name($($arg: $type),*) -> Result<$out, $crate::web::lazy::NotLoaded> {
            Ok($body)
        }
    };
}
pub(crate) use lazy;

const TITLE: &str = "This part could not be loaded";

/// What to do about it; a maze that is not kept would be gone with the page.
fn cure(lab: Lab) -> &'static str {
    if lab.kept.with_untracked(|kept| *kept == Kept::Here) {
        "Try again; if that doesn’t help, reload the page. Your maze is kept."
    } else {
        "Try again. Reloading the page may help too, but this browser does not keep your maze."
    }
}

/// What stands in a part's place until it is here.
#[derive(Clone, Copy, PartialEq, Eq)]
enum Arrival {
    Awaited,
    Here,
    Failed,
}

/// A view from a part of the page: at once if the part is loaded, else when it comes.
pub fn view<F>(load: impl Fn() -> F + Send + 'static) -> AnyView
where
    F: Future<Output = Result<AnyView, NotLoaded>> + 'static,
{
    // Asked for again by a click, it still belongs to where it is shown.
    let owner = Owner::current().unwrap_or_default();
    let begin = move || Box::pin(owner.with(|| ScopedFuture::new_untracked(load())));
    let mut first = begin();
    if let Some(Ok(view)) = first.as_mut().now_or_never() {
        return view;
    }
    let lab = use_context::<Lab>();
    let arrival = RwSignal::new(Arrival::Awaited);
    let place = StoredValue::new_local(None);
    let wait = move |mut coming: Pin<Box<ScopedFuture<F>>>| {
        leptos::task::spawn_local(poll_fn(move |context| {
            // A part makes its view as soon as it is here. Where its place is gone meanwhile, nothing may be made:
            // the view would ask for what its owner no longer has.
            if place.is_disposed() {
                return Poll::Ready(());
            }
            coming.as_mut().poll(context).map(|loaded| {
                let state = if loaded.is_ok() { Arrival::Here } else { Arrival::Failed };
                place.set_value(loaded.ok());
                arrival.set(state);
            })
        }));
    };
    wait(first);
    let again = StoredValue::new_local(move || wait(begin()));
    part(move || match arrival.get() {
        Arrival::Here => place.try_update_value(Option::take).flatten().unwrap_or_else(|| ().into_any()),
        Arrival::Awaited => arriving(),
        Arrival::Failed => view! {
            <div class="arriving" role="alert">
                <p><b>{TITLE}</b></p>
                <p>{lab.map(cure)}</p>
                <button class="btn" on:click=mouse(move |_| {
                    arrival.set(Arrival::Awaited);
                    again.with_value(|again| again());
                })>"Try again"</button>
            </div>
        }
        .into_any(),
    })
    .into_any()
}

/// What is shown until something comes.
pub fn arriving() -> AnyView {
    view! { <p class="arriving" role="status">"Loading…"</p> }.into_any()
}

/// Does something that a part of the page can do; says so where the part cannot be loaded.
pub fn act(lab: Lab, deed: impl Future<Output = Result<(), NotLoaded>> + 'static) {
    leptos::task::spawn_local(async move {
        if deed.await.is_err() {
            lab.say(ToastTone::Error, TITLE, cure(lab));
        }
    });
}
