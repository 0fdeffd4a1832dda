//! The browser's real Web Serial, with a mocked port and `linemaze robot` at its other end.

use anyhow::Result;
use e2e::{Bench, Bus, Page, Setup, bench, lab_on};
use serde_json::Value;

use crate::connect::{explore, state};

mod cable;
mod chooser;
mod wire;

/// Writes down which states the page shows, and which stops of the live run while the robot drives: what lasts only
/// for a moment may be over before a test looks.
const WITNESS: &str = "window.seen = []; window.stops = [];
    const look = () => {
        const state = document.querySelector('#state')?.textContent.trim();
        if (state && state !== seen.at(-1)) seen.push(state);
        const { stop, crossed } = document.querySelector('.live .maze[data-stop]')?.dataset ?? {};
        if (state === 'running' && stop && stop !== stops.at(-1)?.[0]) stops.push([stop, crossed]);
    };
    addEventListener('DOMContentLoaded', () => new MutationObserver(look).observe(document, {
        subtree: true, childList: true, characterData: true, attributes: true, attributeFilter: ['data-stop'],
    }));";

fn setup() -> Setup {
    Setup::default().at("connect").script(WITNESS)
}

/// Opens the port that was allowed before.
async fn connect(page: &Page) -> Result<()> {
    page.click_css(".known button").await
}

/// The states that the page has shown, one after the other.
async fn states(page: &Page) -> Result<String> {
    Ok(page.eval("seen.join(', ')").await?.as_str().unwrap_or_default().to_owned())
}

/// A test on a bench with a robot; where no port can be mocked, it is left out.
async fn with(robot: &[&str], body: impl AsyncFnOnce(&Page, &mut Bench) -> Result<()>) -> Result<()> {
    with_setup(Bus::Usb, robot, setup(), body).await
}

/// The same for a port somewhere, with more that the test wants.
async fn with_setup(
    bus: Bus,
    robot: &[&str],
    setup: Setup,
    body: impl AsyncFnOnce(&Page, &mut Bench) -> Result<()>,
) -> Result<()> {
    match bench(bus, robot)? {
        Some(mut bench) => lab_on(&mut bench, setup, body).await,
        None => Ok(()),
    }
}

#[tokio::test]
async fn a_list_is_sent_to_a_granted_port_and_read_back() -> Result<()> {
    with(&[], async |page, _| {
        connect(page).await?;
        state(page, "ready").await?;
        page.wait_for_text("#port", "Arduino Uno").await?;
        page.wait_for_text("#port", "2341:0043").await?;
        page.click("Send").await?;
        page.wait_for_text("#sent", "read back and compared").await?;
        page.wait_for_text("#same", "same on both").await?;
        page.click("Disconnect").await?;
        state(page, "not connected").await?;
        // The port is free again.
        connect(page).await?;
        state(page, "ready").await?;
        page.wait_for_text("#same", "same on both").await
    })
    .await
}

#[tokio::test]
async fn figure_3_1_is_explored_live() -> Result<()> {
    with(&["--hurry", "6"], async |page, _| {
        connect(page).await?;
        state(page, "ready").await?;
        explore(page).await?;
        page.wait_for_text(".note.guest", "25 stops, finish reached").await?;
        assert_eq!(page.attribute(".live .maze[data-stop]", "data-crossed").await?, "20");
        // It was followed while it drove, and what it crossed out too.
        let stops = page.eval("stops.map(([stop]) => Number(stop))").await?;
        let stops: Vec<u64> = stops.as_array().into_iter().flatten().filter_map(Value::as_u64).collect();
        assert!(stops.len() > 3 && stops.is_sorted(), "{stops:?}");
        assert!(page.eval("new Set(stops.map(([, crossed]) => crossed)).size > 1").await? == true);
        page.press("2").await?;
        page.press_times("ArrowLeft", 9).await?;
        page.wait_until("document.querySelector('.maze[data-stop]').dataset.stop === '16'").await?;
        assert_eq!(page.text("[data-var=ptr] span").await?, "7");
        assert_eq!(page.text("[data-var=returning] span").await?, "true");
        assert_eq!(page.count(".nodes tr[data-node]").await?, 6);
        Ok(())
    })
    .await
}

#[tokio::test]
async fn what_a_robot_said_is_kept_as_a_log_and_as_a_session() -> Result<()> {
    with(&["--hurry", "6"], async |page, _| {
        let downloads = page.allow_downloads().await?;
        connect(page).await?;
        state(page, "ready").await?;
        explore(page).await?;
        page.wait_for_text(".note.guest", "finish reached").await?;
        page.click("Disconnect").await?;
        page.click("Download the log").await?;
        let log = downloads.file("robot-log.txt").await?;
        assert!(log.contains(" > hi #") && log.contains(" < ready 1 "), "{log}");
        assert!(log.contains(" > run explore ") && log.contains(" < at "), "{log}");
        page.click("Save").await?;
        downloads.file("robot-session.txt").await?;
        page.reload().await?;
        page.wait_for("#session-file").await?;
        page.choose_file("#session-file", &downloads.path("robot-session.txt")).await?;
        page.wait_for_text(".note.guest", "25 stops, finish reached").await?;
        page.press("Home").await?;
        page.press("ArrowRight").await?;
        page.wait_until("document.querySelector('.live .maze[data-stop]').dataset.stop === '1'").await
    })
    .await
}

#[tokio::test]
async fn a_wrong_rate_is_told_and_the_next_one_tried() -> Result<()> {
    with(&["--baud", "9600"], async |page, _| {
        connect(page).await?;
        state(page, "failed").await?;
        page.wait_for_text("#link-says", "no robot answered").await?;
        page.click("Try the next rate").await?;
        state(page, "ready").await?;
        page.wait_for_text("#port", "9600 baud").await
    })
    .await
}

#[tokio::test]
async fn a_robot_that_says_ready_late_is_met() -> Result<()> {
    // Not to the first `hi`, nor to the one after the time that an Uno needs, but to the next.
    with(&["mute", "3"], async |page, _| {
        connect(page).await?;
        state(page, "ready").await?;
        page.wait_for_text("#port", "late-1").await?;
        let states = states(page).await?;
        assert!(states.ends_with("waiting for the robot, ready"), "{states}");
        Ok(())
    })
    .await
}

#[tokio::test]
async fn a_robot_that_never_answers_is_told_with_a_cure() -> Result<()> {
    with(&["mute"], async |page, _| {
        connect(page).await?;
        state(page, "failed").await?;
        page.wait_for_text("#link-says", "not a byte came").await?;
        page.wait_for_text("#cure", "switched on").await?;
        page.wait_for_text(".log", "hi #").await
    })
    .await
}

#[tokio::test]
async fn one_port_in_two_tabs_is_refused_with_a_cure() -> Result<()> {
    with(&[], async |page, _| {
        connect(page).await?;
        state(page, "ready").await?;
        page.another_tab("connect").await?;
        connect(page).await?;
        state(page, "failed").await?;
        page.wait_for_text("#cure", "close other tabs").await?;
        // The cure helps.
        page.close_tab().await?;
        state(page, "ready").await?;
        page.click("Disconnect").await?;
        state(page, "not connected").await?;
        page.another_tab("connect").await?;
        connect(page).await?;
        state(page, "ready").await
    })
    .await
}
