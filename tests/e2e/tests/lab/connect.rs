//! The room *Connect* with the demo robot: everything that needs no port.

use anyhow::{Context, Result};
use e2e::{Page, Setup, lab};
use serde_json::json;

/// Waits for a word in the connection's state.
pub(crate) async fn state(page: &Page, word: &str) -> Result<()> {
    page.wait_for_text("#state", word).await
}

/// The demo robot, met.
pub(crate) async fn demo(page: &Page) -> Result<()> {
    page.wait_for("#demo").await?;
    page.click("Demo robot").await?;
    state(page, "ready").await?;
    // The settings are asked for last.
    page.wait_until("document.querySelector('#tune-line4')?.value === '400'").await
}

/// At 100 times its pace the demo robot would be another one: its time runs as the page's does.
fn hurried() -> Setup {
    Setup::default().at("connect").script(format!("{HURRY} window.hurry(8);"))
}

/// The page's time runs at the pace that `window.hurry` is told.
pub(crate) const HURRY: &str = "
    const clock = performance.now.bind(performance);
    let pace = 1, seen = clock(), shown = seen;
    performance.now = () => { const now = clock(); shown += (now - seen) * pace; seen = now; return shown; };
    window.hurry = (times) => { performance.now(); pace = times; };";

/// Keeps hold of the page's wasm memory, to see how large it is.
const MEMORY: &str = "
    const instantiate = WebAssembly.instantiateStreaming;
    WebAssembly.instantiateStreaming = async (...from) => {
        const made = await instantiate.apply(WebAssembly, from);
        window.memory ??= made.instance.exports.memory;
        return made;
    };";

/// Bytes that the page holds: its wasm, and what its scripts hold once rubbish is collected.
async fn held(page: &Page) -> Result<(u64, u64)> {
    page.tools("HeapProfiler.collectGarbage", json!({})).await?;
    let wasm = page.eval("window.memory.buffer.byteLength").await?.as_u64();
    let scripts = page.tools("Runtime.getHeapUsage", json!({})).await?["usedSize"].as_f64();
    Ok((wasm.context("no wasm")?, scripts.context("no heap")? as u64))
}

/// Explores figure 3.1 to its end.
pub(crate) async fn explore(page: &Page) -> Result<()> {
    page.click("I put it back").await?;
    page.wait_until("!document.querySelector('#explore').disabled").await?;
    page.click("Explore").await?;
    state(page, "running").await
}

#[tokio::test]
async fn the_demo_robot_is_met_and_left() -> Result<()> {
    lab(Setup::default().at("connect"), async |page| {
        demo(page).await?;
        assert!(page.text("#port").await?.contains("Demo robot"));
        assert_eq!(page.value("#tune-kp").await?, "0.62");
        page.wait_for_text("#list-robot", "none").await?;
        page.click("Disconnect").await?;
        state(page, "not connected").await
    })
    .await
}

#[tokio::test]
async fn a_turn_list_is_sent_and_read_back() -> Result<()> {
    lab(Setup::default().at("connect"), async |page| {
        demo(page).await?;
        page.click("Send").await?;
        page.wait_for_text("#sent", "read back and compared").await?;
        page.wait_for_text("#same", "same on both").await?;
        let here = page.attribute("#list-here ol", "aria-label").await?;
        assert_eq!(page.attribute("#list-robot ol", "aria-label").await?, here);
        // It outlives the robot being switched off, and the room being left.
        page.click("Disconnect").await?;
        demo(page).await?;
        page.wait_for_text("#same", "same on both").await?;
        page.press("2").await?;
        page.wait_for(".transport .play").await?;
        page.press("4").await?;
        state(page, "ready").await
    })
    .await
}

#[tokio::test]
async fn a_run_is_followed_live_in_the_stepper() -> Result<()> {
    lab(hurried(), async |page| {
        demo(page).await?;
        explore(page).await?;
        page.wait_for_text(".note.guest", "live from the robot").await?;
        page.wait_for_text(".note.guest", "25 stops, finish reached").await?;
        state(page, "ready").await?;
        let stage = ".live .maze[data-stop]";
        assert_eq!(page.attribute(stage, "data-crossed").await?, "20");
        // The learned list is on the robot.
        page.click("Read back").await?;
        page.wait_for_text("#list-robot", "learned by itself").await?;
        // Back and forth, here and in the room Step.
        page.press_times("ArrowLeft", 2).await?;
        page.wait_until("document.querySelector('.live .maze[data-stop]').dataset.stop === '23'").await?;
        page.press("2").await?;
        page.wait_for_text(".note.guest", "live from the robot").await?;
        page.press("ArrowRight").await?;
        page.wait_until("document.querySelector('.maze[data-stop]').dataset.stop === '24'").await?;
        page.wait_for_text("#said", "return-known").await?;
        page.click("Back to the page’s own run").await?;
        page.wait_for_no(".note.guest").await
    })
    .await
}

#[tokio::test]
async fn where_robot_and_page_first_disagree_is_marked() -> Result<()> {
    lab(hurried(), async |page| {
        demo(page).await?;
        // The robot takes places a cell and a half apart for one; the page does not.
        page.fill("#tune-epsilon", "1000").await?;
        page.click("Send settings").await?;
        page.wait_for_text("#news", "epsilon = 1000: done").await?;
        explore(page).await?;
        page.wait_for_text(".note.guest", "At stop 2 the page decides otherwise").await?;
        page.wait_for_text(".diff", "node 2").await?;
        page.click("Go to stop 2").await?;
        page.wait_for(".live .maze .differs[data-stop='2']").await?;
        page.fill("#filter", "do ").await?;
        page.wait_for_text(".log .differs", "the page decides otherwise").await?;
        page.screenshot("connect-disagreement").await
    })
    .await
}

#[tokio::test]
async fn a_session_is_saved_and_opened_without_the_robot() -> Result<()> {
    lab(hurried(), async |page| {
        let downloads = page.allow_downloads().await?;
        demo(page).await?;
        explore(page).await?;
        page.wait_for_text(".note.guest", "finish reached").await?;
        page.click("Save").await?;
        let session = downloads.file("robot-session.txt").await?;
        assert!(session.starts_with("line-maze-session: 1\n"), "{session}");
        page.reload().await?;
        page.wait_for("#session-file").await?;
        let path = std::env::temp_dir().join(format!("line-maze-session-{}.txt", std::process::id()));
        std::fs::write(&path, session)?;
        page.choose_file("#session-file", &path).await?;
        page.wait_for_text(".note.guest", "25 stops, finish reached").await?;
        page.press("Home").await?;
        page.press("ArrowRight").await?;
        page.wait_until("document.querySelector('.live .maze[data-stop]').dataset.stop === '1'").await?;
        page.click("Close the recording").await?;
        page.wait_for_no("[aria-label='Close the recording']").await?;
        std::fs::write(&path, "line-maze-session: 1\n5 < beat 1 2*00\n")?;
        page.choose_file("#session-file", &path).await?;
        page.wait_for_text(".toast", "line 2: the checksum does not fit").await?;
        std::fs::remove_file(path)?;
        Ok(())
    })
    .await
}

#[tokio::test]
async fn settings_are_checked_and_sent() -> Result<()> {
    lab(Setup::default().at("connect"), async |page| {
        demo(page).await?;
        page.fill("#tune-kp", "abc").await?;
        page.click("Send settings").await?;
        page.wait_for_text(".settings .wrong", "kp: a number from 0 to 1000").await?;
        page.fill("#tune-kp", "0.75").await?;
        page.click("Send settings").await?;
        page.wait_for_text("#news", "kp = 750: done").await?;
        assert_eq!(page.value("#tune-kp").await?, "0.75");
        Ok(())
    })
    .await
}

#[tokio::test]
async fn the_monitor_shows_sifts_sends_and_pauses() -> Result<()> {
    lab(Setup::default().at("connect"), async |page| {
        let downloads = page.allow_downloads().await?;
        demo(page).await?;
        // Newer lines push it out of sight.
        page.fill("#filter", "ready").await?;
        page.wait_for_text(".log", "ready 1 lab-1 demo").await?;
        page.fill("#filter", "").await?;
        page.click("Sent").await?;
        page.wait_until("document.querySelectorAll('.log li.in').length === 0").await?;
        page.fill("#filter", "get kp").await?;
        page.wait_until("document.querySelectorAll('.log li[data-line]').length === 1").await?;
        page.fill("#filter", "").await?;
        page.click("All").await?;
        page.fill("#line", "get speed").await?;
        page.click("Send line").await?;
        page.click("Pause the monitor").await?;
        let before = page.text(".log").await?;
        page.wait_until("!document.querySelector('#plot-waiting')").await?;
        assert_eq!(page.text(".log").await?, before);
        page.click("Download the log").await?;
        let log = downloads.file("robot-log.txt").await?;
        assert!(log.contains(" < ready 1 lab-1 demo"), "{log}");
        assert!(log.contains(" > get speed"), "{log}");
        Ok(())
    })
    .await
}

#[tokio::test]
async fn an_hour_of_telemetry_leaves_the_memory_flat() -> Result<()> {
    lab(Setup::default().at("connect").script(HURRY).script(MEMORY), async |page| {
        demo(page).await?;
        let minutes = async |minutes: f64| {
            // Requests want their answers at the usual pace; sensors come at any.
            page.run("window.hurry(100); window.until = performance.now()").await?;
            page.wait_until(&format!("performance.now() > window.until + {}", minutes * 60_000.0)).await?;
            page.run("window.hurry(1)").await
        };
        // The log, the plot and the recorder fill their places.
        minutes(10.0).await?;
        let (wasm, scripts) = held(page).await?;
        for _ in 0..5 {
            minutes(10.0).await?;
        }
        let (wasm_after, scripts_after) = held(page).await?;
        // 300,000 lines came meanwhile, 20 MB of them: a computer that stumbles takes many at once, and needs room.
        assert!(wasm_after <= wasm + (4 << 20), "wasm: {wasm} bytes became {wasm_after}");
        assert!(
            scripts_after <= scripts * 11 / 10 + (1 << 20),
            "scripts: {scripts} bytes became {scripts_after}"
        );
        // It is still the same connection, and it answers.
        state(page, "ready").await?;
        page.wait_for_text(".monitor h2", "0 bad").await?;
        page.click("Read back").await?;
        page.wait_for_text("#list-robot", "none").await
    })
    .await
}

#[tokio::test]
async fn leaving_while_it_drives_asks_first() -> Result<()> {
    lab(Setup::default().at("connect"), async |page| {
        demo(page).await?;
        let asks = "(() => { const event = new Event('beforeunload', { cancelable: true }); dispatchEvent(event); return event.defaultPrevented; })()";
        assert_eq!(page.eval(asks).await?, json!(false));
        explore(page).await?;
        assert_eq!(page.eval(asks).await?, json!(true));
        page.click("Stop").await?;
        page.wait_for_text(".note.guest", "stopped by hand").await?;
        assert_eq!(page.eval(asks).await?, json!(false));
        Ok(())
    })
    .await
}
