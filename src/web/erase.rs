//! The same few types for all views. Each closure in a view would otherwise bring its own copy of the
//! framework's machinery into the wasm; boxed behind these functions they share one, and the page stays
//! light to load.

use leptos::prelude::*;
use web_sys::{Event, FocusEvent, KeyboardEvent, MouseEvent, PointerEvent, SubmitEvent, WheelEvent};

/// A value that follows signals: for attributes, classes, styles and text.
pub fn sig<T: Clone + Send + Sync + 'static>(value: impl Fn() -> T + Send + Sync + 'static) -> Signal<T> {
    Signal::derive(value)
}

/// A part of a view that is made anew when a signal changes.
pub fn part<V: IntoAny>(make: impl Fn() -> V + Send + 'static) -> Box<dyn FnMut() -> AnyView + Send> {
    Box::new(move || make().into_any())
}

/// A handler that hears nothing any more once its view is gone: the browser tells some events later (scrolling,
/// losing the focus, a click on its way up), when the signals that they would be answered with are gone too.
fn while_shown<E: 'static>(mut handle: Box<dyn FnMut(E)>) -> Box<dyn FnMut(E)> {
    let shown = StoredValue::new(());
    Box::new(move |event| {
        if !shown.is_disposed() {
            handle(event);
        }
    })
}

macro_rules! handlers {
    ($($name:ident $event:ty;)*) => {$(
        #[doc = concat!("A handler of `", stringify!($event), "`.")]
        pub fn $name(handle: impl FnMut($event) + 'static) -> Box<dyn FnMut($event)> {
            while_shown(Box::new(handle))
        }
    )*};
}

handlers! {
    event Event;
    focus FocusEvent;
    key KeyboardEvent;
    mouse MouseEvent;
    pointer PointerEvent;
    submit SubmitEvent;
    wheel WheelEvent;
}
