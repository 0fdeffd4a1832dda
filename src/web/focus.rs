//! The keyboard's focus never falls to the page's body because what had it is gone: a button that vanishes when it
//! is pressed, or can't be pressed for a while, hands it to its neighbour; a dialog gives it back to what opened
//! it; another room gets it at its beginning.

use std::cell::RefCell;
use std::time::Duration;

use leptos::prelude::*;
use wasm_bindgen::JsCast;
use wasm_bindgen::prelude::*;
use web_sys::{
    AddEventListenerOptions, Element, HtmlElement, KeyboardEvent, MutationObserver, MutationObserverInit,
    Node,
};

/// What can have the focus by Tab.
const CONTROLS: &str = "a[href], button:not(:disabled):not([tabindex='-1']), input:not(:disabled), \
    select:not(:disabled), textarea:not(:disabled), summary, [tabindex='0']";
/// What has the focus itself where no control is left in it, if it has a name.
const REGION: &str = "section, form, nav, header, footer, [role=dialog], [role=region]";

/// A place in the page, which outlives the element that is there.
#[derive(Clone)]
pub struct Place {
    element: Element,
    /// What is around it, from the inside out, each with the number of the child that leads here.
    around: Vec<(Element, u32)>,
}

/// What is known of the focus.
#[derive(Default)]
struct Known {
    /// Where it is, or was; none once somebody has clicked beside it, or chosen from a list that lets it go.
    at: Option<Place>,
    /// Where it was before, outside of the region that has it now.
    before: Option<Place>,
    /// What gave it to a neighbour because it could not be pressed, and the neighbour: it gets the focus back as
    /// soon as it can be pressed again, unless somebody used a key meanwhile.
    lent: Option<(Element, Element)>,
    /// Where Enter went down.
    pressed: Option<Element>,
    /// Whether it came by a pointer.
    by_pointer: bool,
    /// A region that can have the focus only while it has it.
    region: Option<Element>,
    /// The room that is to get it, by its heading.
    wanted: Option<&'static str>,
}

thread_local! {
    static KNOWN: RefCell<Known> = RefCell::default();
}

fn known<T>(of: impl FnOnce(&mut Known) -> T) -> T {
    KNOWN.with_borrow_mut(of)
}

impl Place {
    fn of(element: &Element) -> Self {
        let mut around = Vec::new();
        let mut child = element.clone();
        while let Some(parent) = child.parent_element() {
            let mut number = 0;
            let mut before = child.previous_element_sibling();
            while let Some(sibling) = before {
                number += 1;
                before = sibling.previous_element_sibling();
            }
            around.push((parent.clone(), number));
            child = parent;
        }
        Self { element: element.clone(), around }
    }

    /// What had the focus here, or its neighbour in the same region, or the region.
    fn nearest(&self) -> Option<Element> {
        if usable(&self.element) {
            return Some(self.element.clone());
        }
        for (around, number) in &self.around {
            // What stands in no room has no neighbours.
            if around.matches(".app, body, .toasts").unwrap_or(true) {
                return None;
            }
            if !around.is_connected() {
                continue;
            }
            if let Some(control) = neighbour(around, *number) {
                return Some(control);
            }
            // A region that has a name can be told.
            let named = around.has_attribute("aria-labelledby") || around.has_attribute("aria-label");
            if named && around.matches(REGION).unwrap_or(false) && is_shown(around) {
                return Some(around.clone());
            }
        }
        None
    }

    fn is_in(&self, region: Option<&Element>) -> bool {
        region.is_some_and(|region| region.contains(Some(&self.element)))
    }
}

/// The first control at a child of this number or after it, or else the last one before.
fn neighbour(around: &Element, number: u32) -> Option<Element> {
    let boundary = around.children().item(number);
    let found = around.query_selector_all(CONTROLS).ok()?;
    let controls = (0..found.length()).filter_map(|nth| found.item(nth)?.dyn_into::<Element>().ok());
    let mut before = None;
    for control in controls.filter(is_shown) {
        let after = boundary.as_ref().is_some_and(|boundary| {
            let there = boundary.compare_document_position(&control);
            boundary.contains(Some(&control)) || there & Node::DOCUMENT_POSITION_FOLLOWING != 0
        });
        if after {
            return Some(control);
        }
        before = Some(control);
    }
    before
}

fn is_shown(element: &Element) -> bool {
    element.get_bounding_client_rect().width() > 0.0
}

/// Whether an element is there to have the focus.
fn usable(element: &Element) -> bool {
    element.is_connected() && !element.matches(":disabled").unwrap_or(false) && is_shown(element)
}

/// What has the focus; the page's body counts as nothing.
fn focused() -> Option<Element> {
    document()
        .active_element()
        .filter(|element| element.parent_element().is_some_and(|p| p.parent_element().is_some()))
}

/// Gives an element the focus.
fn focus(element: &Element) {
    if !element.matches(CONTROLS).unwrap_or(true) && !element.has_attribute("tabindex") {
        let _ = element.set_attribute("tabindex", "-1");
        known(|known| known.region = Some(element.clone()));
    }
    let _ = element.unchecked_ref::<HtmlElement>().focus();
}

/// Where the focus is now, to be given back later.
#[must_use]
pub fn here() -> Option<Place> {
    focused().as_ref().map(Place::of)
}

/// Gives the focus back, where nothing else has it meanwhile.
pub fn give_back(place: Option<&Place>) {
    let Some(place) = place else { return let_go() };
    if focused().is_none()
        && let Some(to) = place.nearest().or_else(main)
    {
        focus(&to);
    }
}

/// Whether somebody came by keys to what has the focus. `:focus-visible` does not tell: it begins to hold once any key
/// is pressed.
#[must_use]
pub fn by_keys() -> bool {
    known(|known| !known.by_pointer)
}

/// Nobody has the focus from now on, and that is meant.
pub fn let_go() {
    known(|known| known.at = None);
}

/// The room with this heading gets the focus, as soon as it is here.
pub fn enter(heading: &'static str) {
    known(|known| known.wanted = Some(heading));
    look();
}

/// Watches as long as the page lives.
pub fn watch() {
    let moved = window_event_listener(leptos::ev::focusin, |event| {
        if let Some(element) = event.target().and_then(|target| target.dyn_into::<Element>().ok()) {
            arrived(&element);
        }
    });
    // A part of the page that goes, or is made anew, takes the focus with it only after this event.
    let left = window_event_listener(leptos::ev::focusout, |_| set_timeout(look, Duration::ZERO));
    on_cleanup(move || {
        moved.remove();
        left.remove();
    });
    let changed = Closure::<dyn FnMut()>::new(look);
    if let (Ok(observer), Some(body)) =
        (MutationObserver::new(changed.as_ref().unchecked_ref()), document().body())
    {
        let what = MutationObserverInit::new();
        what.set_child_list(true);
        what.set_subtree(true);
        what.set_attribute_filter(&js_sys::Array::of2(&"disabled".into(), &"hidden".into()));
        let _ = observer.observe_with_options(&body, &what);
    }
    let pressed = Closure::<dyn FnMut(KeyboardEvent)>::new(|event: KeyboardEvent| key_down(&event));
    let pointed = Closure::<dyn FnMut()>::new(|| {
        let_go();
        known(|known| known.by_pointer = true);
    });
    first_to_hear("keydown", pressed.as_ref().unchecked_ref());
    first_to_hear("pointerdown", pointed.as_ref().unchecked_ref());
    // The page's own, as long as it is open.
    changed.forget();
    pressed.forget();
    pointed.forget();
}

/// Hears an event before anybody else does something about it.
fn first_to_hear(event: &str, handle: &js_sys::Function) {
    let options = AddEventListenerOptions::new();
    options.set_capture(true);
    let _ = window().add_event_listener_with_callback_and_add_event_listener_options(event, handle, &options);
}

fn arrived(element: &Element) {
    let place = Place::of(element);
    known(|known| {
        if let Some(region) = known.region.take_if(|region| region != element) {
            let _ = region.remove_attribute("tabindex");
        }
        if let Some(at) = known.at.take()
            && !at.is_in(element.closest(".toasts, dialog").ok().flatten().as_ref())
        {
            known.before = Some(at);
        }
        known.at = Some(place);
    });
}

/// Enter that is held down presses one button, not what gets the focus after it.
fn key_down(event: &KeyboardEvent) {
    known(|known| {
        known.lent = None;
        if event.key() == "Tab" {
            known.by_pointer = false;
        }
        if event.key() != "Enter" {
            return;
        }
        if !event.repeat() {
            known.pressed = focused();
        } else if known.pressed != focused() {
            event.prevent_default();
        }
    });
}

/// Looks whether somebody has the focus who can use it.
fn look() {
    if let Some(heading) = known(|known| known.wanted)
        && let Some(room) = room(heading)
    {
        known(|known| known.wanted = None);
        return focus(&room);
    }
    let focused = focused();
    if let Some((owner, neighbour)) = known(|known| known.lent.clone())
        && focused.as_ref() == Some(&neighbour)
        && usable(&owner)
    {
        known(|known| known.lent = None);
        return focus(&owner);
    }
    // Asked after every change of the page: where it stands must not matter, which would be worked out anew each time.
    if let Some(focused) = focused.filter(|focused| !focused.matches(":disabled").unwrap_or(false)) {
        return known(|known| {
            known.at.get_or_insert_with(|| Place::of(&focused));
        });
    }
    let Some(place) = known(|known| known.at.take()) else { return };
    let (nearest, before) = (place.nearest(), known(|known| known.before.clone()));
    let to = nearest.or_else(|| before?.nearest()).or_else(main);
    let Some(to) = to else {
        // A room is on its way.
        return known(|known| known.at = Some(place));
    };
    focus(&to);
    if place.element.is_connected() {
        known(|known| known.lent = Some((place.element, to)));
    }
}

fn main() -> Option<Element> {
    document().get_element_by_id("main")
}

/// The room with this heading, if it is here.
fn room(heading: &str) -> Option<Element> {
    let main = main()?;
    let title = main.query_selector("h1").ok().flatten()?;
    (title.text_content().as_deref() == Some(heading)).then_some(main)
}
