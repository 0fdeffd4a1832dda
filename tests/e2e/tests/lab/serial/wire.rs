//! Bad wires: faults by seed, and a flood.

use std::time::Duration;

use anyhow::{Context, Result, bail};
use e2e::{Bus, Page};
use line_maze_lab::link::monitor::KEPT_LINES;

use super::{connect, setup, state, with, with_setup};

/// The robot's list is known: it is the new one and the page says so, or it is not and the page says that.
const SETTLED: &str = "(() => {
    const text = (css) => document.querySelector(css)?.innerText.toLowerCase() ?? '';
    return text('#sent').includes('holds the new list') && text('#same').includes('same on both')
        || text('#sent').includes('still holds its old list') && text('#list-robot').includes('none');
})()";
const FAILED: &str = "document.querySelector('#state')?.innerText.toLowerCase().includes('failed')";

/// Does what a person does who wants a list on a robot that has a bad wire: where the connection fails, connects
/// again; sends once.
async fn send_in_spite_of_all(page: &Page) -> Result<()> {
    let mut sent = false;
    for _ in 0..12 {
        let next = if sent { SETTLED } else { "document.querySelector('#send:enabled')" };
        page.wait_until(&format!("{FAILED} || {next}")).await?;
        if page.eval(&format!("!!({FAILED})")).await? == true {
            connect(page).await?;
            page.wait_until(&format!("!({FAILED})")).await?;
        } else if sent {
            return Ok(());
        } else {
            // It may be taken away at any moment.
            page.run("document.querySelector('#send')?.click()").await?;
            let said = "document.querySelector('#sent')?.innerText";
            sent = page.comes_true(said, Duration::from_secs(2)).await?;
        }
    }
    bail!("the connection failed too often: {}", page.text("main").await?)
}

#[tokio::test]
async fn a_bad_wire_never_leaves_half_a_list() -> Result<()> {
    for seed in ["1", "7", "42"] {
        with(&["--faults", seed], async |page, _| {
            connect(page).await?;
            send_in_spite_of_all(page).await
        })
        .await?;
    }
    Ok(())
}

/// Lets the test see how much memory the page's program has.
const MEMORY: &str = "const start = WebAssembly.instantiateStreaming;
    WebAssembly.instantiateStreaming = async (...all) => {
        const started = await start(...all);
        window.memory ??= started.instance.exports.memory;
        return started;
    };";
/// Lines that the monitor has counted.
const LINES: &str = "parseInt(document.querySelector('#monitor-count')?.innerText)";
const WAITING: &str = "document.querySelector('#state').innerText.toLowerCase().includes('waiting')";

/// Megabytes that the page's program has taken.
async fn megabytes(page: &Page) -> Result<f64> {
    page.eval("memory.buffer.byteLength / 1e6").await?.as_f64().context("no memory to be seen")
}

/// The flood is over, as there is no robot in it.
async fn given_up(page: &Page) -> Result<()> {
    state(page, "failed").await?;
    page.wait_for_text("#link-says", "no robot answered").await?;
    page.wait_for_text("#link-says", "makes no sense at this rate").await
}

#[tokio::test]
async fn a_megabyte_a_second_of_rubbish_leaves_the_page_usable() -> Result<()> {
    with_setup(Bus::Usb, &["flood"], setup().script(MEMORY), async |page, _| {
        let downloads = page.allow_downloads().await?;
        connect(page).await?;
        // Clicks and keys are answered while it pours.
        page.wait_until(&format!("{LINES} > 1000")).await?;
        page.click("Pause the monitor").await?;
        page.wait_until("document.querySelector('[aria-label=\"Pause the monitor\"][aria-pressed=true]')")
            .await?;
        page.press("2").await?;
        page.wait_for(".transport .play").await?;
        page.press("4").await?;
        page.wait_until(&format!("{LINES} > 1000 && {WAITING}")).await?;
        given_up(page).await?;
        // More has come than is kept, and neither the log nor the memory grows with what comes after.
        let first = megabytes(page).await?;
        assert!(page.eval(&format!("{LINES} > {KEPT_LINES}")).await? == true);
        page.click("Try the next rate").await?;
        page.wait_until(WAITING).await?;
        given_up(page).await?;
        let second = megabytes(page).await?;
        assert!(second <= first + 2.0, "{first} MB, then {second} MB");
        page.click("Download the log").await?;
        let lines = downloads.file("robot-log.txt").await?.lines().count();
        assert!((KEPT_LINES - 10..=KEPT_LINES + 10).contains(&lines), "{lines}");
        // And it can be left at any time.
        page.click("Try the next rate").await?;
        page.wait_until(&format!("{WAITING} && document.querySelector('#port').innerText.includes('57600')"))
            .await?;
        page.click("Disconnect").await?;
        state(page, "not connected").await
    })
    .await
}
