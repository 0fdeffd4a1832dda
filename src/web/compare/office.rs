//! Where the league is worked out: in a worker, or in slices in the page where no worker can start.

use std::cell::RefCell;
use std::rc::Rc;
use std::time::Duration;

use leptos::prelude::*;
use wasm_bindgen::JsCast;
use wasm_bindgen::prelude::*;
use web_sys::{MessageEvent, Worker, WorkerOptions, WorkerType};

use super::league::LeagueDesk;
use super::worker::slice;
use crate::compare::league::desk::{Ask, Desk, Tell};
use crate::web::browser;

/// Longer than this no worker takes to load the page's program.
const PATIENCE: Duration = Duration::from_secs(20);
/// A slice of work in the page, in seconds.
const SLICE_S: f64 = 0.02;

/// The office.
pub enum Office {
    /// A worker, and what waits until it is there; once it is, nothing waits.
    Worker(Worker, Option<Vec<Ask>>),
    /// The page itself.
    Here(Rc<RefCell<Desk>>),
}

/// Asks the office; opens it first.
pub fn ask(league: LeagueDesk, ask: Ask) {
    if league.office.with_value(Option::is_none) {
        let office = open_worker(league).unwrap_or_else(|_| Office::Here(Rc::default()));
        league.office.set_value(Some(office));
    }
    league.office.update_value(|office| match office {
        Some(Office::Worker(_, Some(waiting))) => waiting.push(ask),
        Some(Office::Worker(worker, None)) => post(worker, &ask),
        Some(Office::Here(desk)) => here(league, Rc::clone(desk), ask),
        None => {}
    });
}

fn post(worker: &Worker, ask: &Ask) {
    if let Ok(json) = serde_json::to_string(ask) {
        let _ = worker.post_message(&json.into());
    }
}

/// A worker that loads the script that this page has loaded.
fn open_worker(league: LeagueDesk) -> Result<Office, JsValue> {
    let link =
        document().query_selector("link[rel=modulepreload][href*=line-maze-lab]")?.ok_or(JsValue::NULL)?;
    let script = link.get_attribute("href").ok_or(JsValue::NULL)?;
    let script = web_sys::Url::new_with_base(&script, &browser::address())?.href();
    let wasm = format!("{}_bg.wasm", script.strip_suffix(".js").ok_or(JsValue::NULL)?);
    let options = WorkerOptions::new();
    options.set_type(WorkerType::Module);
    let worker = Worker::new_with_options("worker.js", &options)?;
    let heard = Closure::<dyn FnMut(MessageEvent)>::new(move |event: MessageEvent| {
        let Some(tell) = event.data().as_string().and_then(|json| serde_json::from_str(&json).ok()) else {
            return;
        };
        if tell == Tell::Ready { flush(league) } else { league.hear(tell) }
    });
    worker.set_onmessage(Some(heard.as_ref().unchecked_ref()));
    // It lives as long as the page.
    heard.forget();
    let failed = Closure::<dyn FnMut()>::new(move || move_here(league));
    worker.set_onerror(Some(failed.as_ref().unchecked_ref()));
    failed.forget();
    set_timeout(move || move_here(league), PATIENCE);
    let first = js_sys::Object::new();
    js_sys::Reflect::set(&first, &"script".into(), &script.into())?;
    js_sys::Reflect::set(&first, &"wasm".into(), &wasm.into())?;
    worker.post_message(&first)?;
    Ok(Office::Worker(worker, Some(Vec::new())))
}

/// The worker is there: it gets what waited.
fn flush(league: LeagueDesk) {
    league.office.update_value(|office| {
        if let Some(Office::Worker(worker, waiting)) = office {
            waiting.take().into_iter().flatten().for_each(|ask| post(worker, &ask));
        }
    });
}

/// Does the work in the page where the worker never came.
fn move_here(league: LeagueDesk) {
    let waiting = league.office.try_update_value(|office| match office {
        Some(Office::Worker(worker, waiting @ Some(_))) => {
            worker.terminate();
            let waiting = waiting.take();
            *office = Some(Office::Here(Rc::default()));
            waiting
        }
        _ => None,
    });
    waiting.flatten().into_iter().flatten().for_each(|waited| ask(league, waited));
}

fn here(league: LeagueDesk, desk: Rc<RefCell<Desk>>, ask: Ask) {
    // Answers may ask again: not while the office is being used.
    set_timeout(
        move || {
            let (begins, told) = {
                let mut desk = desk.borrow_mut();
                let was_busy = desk.is_busy();
                let told = desk.hear(ask);
                (desk.is_busy() && !was_busy, told)
            };
            told.into_iter().for_each(|tell| league.hear(tell));
            if begins {
                work(league, desk);
            }
        },
        Duration::ZERO,
    );
}

fn work(league: LeagueDesk, desk: Rc<RefCell<Desk>>) {
    let next = move || {
        let told = slice(&mut desk.borrow_mut(), browser::now_s, SLICE_S);
        told.into_iter().for_each(|tell| league.hear(tell));
        if desk.borrow().is_busy() {
            work(league, desk);
        }
    };
    set_timeout(next, Duration::ZERO);
}
