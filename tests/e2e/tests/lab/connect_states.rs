//! Every state of the connection, in words and as a picture, on a port that does what the test wants.

use anyhow::Result;
use e2e::{Page, Setup, lab};

use crate::connect::{HURRY, demo, state};

/// Web Serial with one known port, an Uno. `port.refuses` is the error with which it opens, `port.says` what
/// comes when it is open; `list` is what becomes of the browser's list of ports.
const SERIAL: &str = r"
    class Port extends EventTarget {
        connected = true;
        readable = null;
        writable = null;
        getInfo() { return { usbVendorId: 0x2341, usbProductId: 0x0043 }; }
        async open() {
            if (this.refuses === 'never') await new Promise(() => {});
            if (this.refuses) throw new DOMException('', this.refuses);
            this.readable = new ReadableStream({ start: (stream) => { this.stream = stream; } });
            this.writable = new WritableStream({ write: () => {
                if (this.says) this.stream.enqueue(new TextEncoder().encode(this.says));
            } });
        }
        async close() { this.readable = this.writable = null; }
        pull() {
            this.connected = false;
            const { stream } = this;
            this.readable = this.writable = null;
            stream.error(new DOMException('', 'NetworkError'));
        }
    }
    const serial = new EventTarget();
    window.port = new Port();
    window.list = () => Promise.reject(new DOMException('', 'NotFoundError'));
    serial.getPorts = async () => [window.port];
    serial.requestPort = () => window.list();
    Object.defineProperty(Navigator.prototype, 'serial', { get: () => serial, configurable: true });
";

fn setup() -> Setup {
    Setup::default().at("connect").script(HURRY)
}

/// The state is there, says this, and is kept as a picture.
async fn shows(page: &Page, name: &str, word: &str, says: &str) -> Result<()> {
    state(page, word).await?;
    page.wait_for_text(".link-card", says).await?;
    page.picture(".link-card", &format!("connect-{name}")).await
}

/// Opens the known port again, which does this now.
async fn again(page: &Page, now: &str) -> Result<()> {
    page.run(now).await?;
    page.wait_for(".known button").await?;
    page.click_css(".known button").await
}

#[tokio::test]
async fn every_state_says_what_it_is_and_what_cures_it() -> Result<()> {
    lab(setup().script(SERIAL), async |page| {
        page.wait_for(".known button").await?;
        shows(page, "closed", "not connected", "No robot is connected").await?;

        page.run("window.list = () => new Promise((_, cancel) => { window.cancel = cancel; })").await?;
        page.click("Connect…").await?;
        shows(page, "choosing", "choosing a port", "Choose the robot’s port").await?;
        page.run("window.cancel(new DOMException('', 'NotFoundError'))").await?;
        shows(page, "cancelled", "not connected", "No port was chosen").await?;

        again(page, "port.refuses = 'never'").await?;
        shows(page, "opening", "opening", "The port is being opened").await?;
        page.click("Disconnect").await?;

        again(page, "port.refuses = 'NetworkError'").await?;
        shows(page, "refused", "failed", "must be in the group dialout").await?;
        again(page, "port.refuses = 'InvalidStateError'").await?;
        shows(page, "in-use", "failed", "Close the other tab, serial monitor or IDE").await?;
        again(page, "port.refuses = 'SecurityError'").await?;
        shows(page, "policy", "failed", "ask the administrator").await?;
        again(page, "port.refuses = 'NetworkError'; port.connected = false").await?;
        shows(page, "unplugged", "failed", "Plug the cable in, then connect again").await?;

        again(page, "port.refuses = null; port.connected = true").await?;
        shows(page, "waiting", "waiting for the robot", "has not answered yet").await?;
        page.run("window.hurry(20)").await?;
        shows(page, "silent", "failed", "not a byte came").await?;
        again(page, "port.says = '\\xF8\\x80~~\\x1C\\n'").await?;
        shows(page, "rubbish", "failed", "makes no sense at this rate").await?;
        page.wait_for("#next-rate").await?;
        again(page, "window.hurry(1); port.says = 'ready 2 later-1 uno 30 400*2B\\n'").await?;
        shows(page, "protocol", "failed", "another version of the protocol").await?;

        again(page, "port.says = 'ready 1 mine-1 uno 30 400*52\\n'").await?;
        state(page, "ready").await?;
        page.run("port.pull()").await?;
        shows(page, "lost", "lost", "Plug the cable in again").await?;
        shows(page, "reconnecting", "reconnecting", "is being looked for").await?;
        page.run("window.hurry(20)").await?;
        shows(page, "gone", "failed", "did not come back within 30 seconds").await
    })
    .await
}

#[tokio::test]
async fn the_demo_robot_s_states_are_shown_too() -> Result<()> {
    lab(setup(), async |page| {
        demo(page).await?;
        shows(page, "ready", "ready", "Demo robot").await?;
        // The list is on its way, and time stands still.
        page.run("window.hurry(0); document.querySelector('#send').click()").await?;
        shows(page, "sending", "sending", "Demo robot").await?;
        page.picture(".turns", "connect-sending-list").await?;
        page.run("window.hurry(1)").await?;
        page.wait_for_text("#sent", "read back and compared").await?;
        page.picture(".turns", "connect-sent-list").await?;
        page.click("I put it back").await?;
        page.wait_until("!document.querySelector('#explore').disabled").await?;
        page.click("Explore").await?;
        shows(page, "running", "running", "battery").await
    })
    .await
}

#[tokio::test]
async fn without_web_serial_the_panel_says_so_and_the_demo_robot_works() -> Result<()> {
    lab(setup().script("delete Navigator.prototype.serial;"), async |page| {
        shows(page, "absent", "not available", "Use Chrome, Edge or Firefox").await?;
        page.wait_for_no("#choose-port").await?;
        demo(page).await
    })
    .await
}
