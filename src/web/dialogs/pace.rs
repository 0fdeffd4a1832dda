//! The robot's cost model: what makes the fastest route differ from the shortest.

use leptos::prelude::*;

use super::settings::NumberField;
use crate::settings::{Pace, limits};
use crate::web::state::lab;

/// Speed, and seconds for turns and stops.
#[component]
pub fn PaceFields() -> impl IntoView {
    let lab = lab();
    let value = move |of: fn(&Pace) -> f64| {
        Signal::derive(move || lab.settings.with(|settings| of(&settings.pace).to_string()))
    };
    let set = move |change: fn(&mut Pace, f64)| {
        move |number: f64| lab.set(|settings| change(&mut settings.pace, number))
    };
    // What one field takes may still be too slow for this maze's cells.
    let fits = move |pace: Pace| lab.maze.with_untracked(|maze| pace.checked(maze.scale).is_ok());
    let speed = move |text: &str| {
        let speed_mm_s = limits::speed(text.parse().ok()?).ok()?;
        let pace = lab.settings.with_untracked(|settings| settings.pace);
        fits(Pace { speed_mm_s, ..pace }).then_some(speed_mm_s)
    };
    let seconds = |text: &str| limits::seconds(text.parse().ok()?).ok();
    view! {
        <fieldset class="pace">
            <legend>"Cost model: what a drive takes"</legend>
            <div class="pair">
                <NumberField id="speed" label="Speed, mm a second" value=value(|pace| pace.speed_mm_s) hint="A number above 0, not too slow for a cell" read=speed set=set(|pace, mm_s| pace.speed_mm_s = mm_s) />
                <NumberField id="turn-s" label="A turn, s" value=value(|pace| pace.turn_s) hint="Seconds, 0 or more" read=seconds set=set(|pace, s| pace.turn_s = s) />
                <NumberField id="uturn-s" label="A U-turn, s" value=value(|pace| pace.uturn_s) hint="Seconds, 0 or more" read=seconds set=set(|pace, s| pace.uturn_s = s) />
                <NumberField id="stop-s" label="A stop, s" value=value(|pace| pace.stop_s) hint="Seconds, 0 or more" read=seconds set=set(|pace, s| pace.stop_s = s) />
            </div>
        </fieldset>
    }
}
