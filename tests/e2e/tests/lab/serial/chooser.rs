//! The browser's own list of ports, answered as a person does: in a window on a screen, with the keyboard.

use std::time::Duration;

use anyhow::{Result, bail};
use e2e::{Bench, Bus, Page, Screen};

use super::{setup, state, with_setup};

const CHOOSING: &str = "document.querySelector('#state')?.innerText.toLowerCase().includes('choosing')";
/// The list takes no click and no Return in its first moments, lest one that was meant for the page falls into it,
/// and nothing says when they are over: so it is asked so often, so long apart.
const TIMES: usize = 12;
const APART: Duration = Duration::from_millis(700);

/// Keeps each port that is opened.
const OPENED: &str = "window.opened = new Set();
    const open = SerialPort.prototype.open;
    SerialPort.prototype.open = function (options) { opened.add(this); return open.call(this, options); };";

/// A test on a bench with a robot and a screen; where one of them cannot be had, it is left out.
async fn seen(
    bus: Bus,
    robot: &[&str],
    body: impl AsyncFnOnce(&Page, &mut Bench, &Screen) -> Result<()>,
) -> Result<()> {
    let Some(screen) = Screen::start()? else { return Ok(()) };
    let setup = setup().on(&screen).script(OPENED);
    with_setup(bus, robot, setup, async |page, bench| body(page, bench, &screen).await).await
}

/// Asks for the list, and waits until it has taken the keyboard from the page.
async fn ask(page: &Page, screen: &Screen) -> Result<()> {
    // At first the address bar has the keyboard; and the window may not be there yet.
    for _ in 0..TIMES {
        screen.click_low()?;
        if page.comes_true("document.hasFocus()", APART).await? {
            break;
        }
    }
    page.click_css("#choose-port").await?;
    page.wait_until("!document.hasFocus()").await
}

/// Chooses the only port of the list.
async fn choose(page: &Page, screen: &Screen) -> Result<()> {
    ask(page, screen).await?;
    screen.press(&["Tab", "Down"])?;
    for _ in 0..TIMES {
        screen.press(&["Return"])?;
        if page.comes_true(&format!("!({CHOOSING})"), APART).await? {
            return Ok(());
        }
    }
    bail!("the list does not close")
}

#[tokio::test]
async fn a_port_is_chosen_in_the_browsers_list_and_known_from_then_on() -> Result<()> {
    seen(Bus::UsbUnknown, &[], async |page, _, screen| {
        page.wait_for_no(".known").await?;
        choose(page, screen).await?;
        state(page, "ready").await?;
        page.wait_for_text("#port", "Arduino Uno").await?;
        page.reload().await?;
        page.wait_for_text(".known", "Use Arduino Uno").await
    })
    .await
}

#[tokio::test]
async fn a_list_that_is_closed_is_told_and_leaves_the_page_usable() -> Result<()> {
    seen(Bus::UsbUnknown, &[], async |page, _, screen| {
        ask(page, screen).await?;
        state(page, "choosing a port").await?;
        screen.press(&["Escape"])?;
        page.wait_for_text("#news", "no port was chosen").await?;
        state(page, "not connected").await?;
        choose(page, screen).await?;
        state(page, "ready").await
    })
    .await
}

#[tokio::test]
async fn a_port_without_usb_ids_is_met_at_9600_and_found_again() -> Result<()> {
    let robot = ["--quiet", "--baud", "9600"];
    seen(Bus::Other, &robot, async |page, bench, screen| {
        choose(page, screen).await?;
        state(page, "failed").await?;
        page.click("Try the next rate").await?;
        state(page, "ready").await?;
        page.wait_for_text("#port", "Serial port").await?;
        page.wait_for_text("#port", "9600 baud").await?;
        bench.unplug()?;
        page.wait_for_text("#cure", "plug the cable in again").await?;
        bench.plug(&robot)?;
        state(page, "ready").await?;
        assert!(page.eval("opened.size === 1").await? == true, "it is another port");
        Ok(())
    })
    .await
}
