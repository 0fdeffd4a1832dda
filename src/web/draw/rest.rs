//! When the hands rest: what takes long in a large maze is worked out only then.

use std::time::Duration;

use leptos::leptos_dom::helpers::TimeoutHandle;
use leptos::prelude::*;

use crate::web::state::Lab;

/// Up to so many points everything is worked out at once.
const QUICK: usize = 10_000;
/// So long nothing must change in a larger maze.
const REST: Duration = Duration::from_millis(300);

/// Counts the times that the maze has changed and come to rest.
pub fn rests(lab: Lab) -> ReadSignal<u32> {
    let (count, set_count) = signal(0_u32);
    let waiting = StoredValue::new(None::<TimeoutHandle>);
    let stop = move || {
        if let Some(timeout) = waiting.try_update_value(Option::take).flatten() {
            timeout.clear();
        }
    };
    Effect::new(move |_| {
        let points = lab.maze.with(|maze| maze.bounds().len());
        stop();
        let rested = move || {
            set_count.try_update(|count| *count += 1);
        };
        if points <= QUICK {
            rested();
        } else {
            waiting.set_value(set_timeout_with_handle(rested, REST).ok());
        }
    });
    on_cleanup(stop);
    count
}
