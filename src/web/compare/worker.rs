//! The worker's end of the league: questions come as messages, answers go as messages, and in between it works
//! a little at a time, so that it hears when it is to stop.

use std::cell::{Cell, RefCell};
use std::rc::Rc;

use wasm_bindgen::JsCast;
use wasm_bindgen::prelude::*;
use web_sys::{DedicatedWorkerGlobalScope, MessageEvent};

use crate::compare::league::desk::{Desk, Tell};

/// A slice of work, in seconds.
const SLICE_S: f64 = 0.08;

/// Works for so many seconds. Tells how far it is, and the results when all is done.
pub fn slice(desk: &mut Desk, now_s: impl Fn() -> f64, slice_s: f64) -> Vec<Tell> {
    if !desk.is_busy() {
        return Vec::new();
    }
    let begin = now_s();
    while desk.is_busy() && now_s() - begin < slice_s {
        desk.work();
    }
    let mut told = vec![desk.progress()];
    if !desk.is_busy() {
        told.push(desk.shown());
    }
    told
}

#[derive(Clone)]
struct Server {
    scope: DedicatedWorkerGlobalScope,
    desk: Rc<RefCell<Desk>>,
    working: Rc<Cell<bool>>,
}

/// Serves as long as the worker lives.
pub fn serve() {
    let scope = js_sys::global().unchecked_into::<DedicatedWorkerGlobalScope>();
    let server = Server { scope, desk: Rc::default(), working: Rc::default() };
    let hearing = server.clone();
    let hear = Closure::<dyn FnMut(MessageEvent)>::new(move |event: MessageEvent| {
        let ask = event.data().as_string().and_then(|json| serde_json::from_str(&json).ok());
        if let Some(ask) = ask {
            let told = hearing.desk.borrow_mut().hear(ask);
            hearing.tell(told);
            hearing.work();
        }
    });
    server.scope.set_onmessage(Some(hear.as_ref().unchecked_ref()));
    hear.forget();
    server.tell(vec![Tell::Ready]);
}

impl Server {
    fn tell(&self, told: Vec<Tell>) {
        for tell in told {
            if let Ok(json) = serde_json::to_string(&tell) {
                let _ = self.scope.post_message(&json.into());
            }
        }
    }

    fn work(&self) {
        if !self.desk.borrow().is_busy() || self.working.replace(true) {
            return;
        }
        let server = self.clone();
        let next = Closure::once_into_js(move || {
            server.working.set(false);
            let told = slice(&mut server.desk.borrow_mut(), || js_sys::Date::now() / 1000.0, SLICE_S);
            server.tell(told);
            server.work();
        });
        let _ = self.scope.set_timeout_with_callback(next.unchecked_ref());
    }
}
