//! A screen that nobody sees, for what the browser shows outside the page: its list of serial ports. It has a
//! window manager, without which no window has the keyboard; and hands of its own, as the driver's end at the page.

use std::io::{BufRead, BufReader};
use std::process::{Child, Command, Stdio};
use std::time::{Duration, Instant};

use anyhow::{Context, Result, bail, ensure};

use crate::serial::{end, on_ci};

/// A browser's window, in pixels.
pub(crate) const SIZE: (u32, u32) = (1440, 1100);
const PATIENCE: Duration = Duration::from_secs(30);

/// A screen with a window manager.
#[derive(Debug)]
pub struct Screen {
    server: Child,
    manager: Option<Child>,
    display: String,
}

impl Screen {
    /// A screen, or a word that the test is left out.
    ///
    /// # Errors
    /// On CI without its programs, and where they do not start.
    pub fn start() -> Result<Option<Self>> {
        // When its last client goes, an X server begins anew, and throws out who is just coming.
        let server = Command::new("Xvfb")
            .args(["-displayfd", "1", "-noreset", "-screen", "0", "1600x1200x24", "-nolisten", "tcp"])
            .stdout(Stdio::piped())
            .stderr(Stdio::null())
            .spawn();
        let server = match server {
            Ok(server) => server,
            Err(error) => {
                ensure!(!on_ci(), "there's no Xvfb ({error}); `cargo xtask test e2e` installs it on Debian");
                eprintln!("LEFT OUT: there's no Xvfb here, so the browser's own windows can't be shown");
                return Ok(None);
            }
        };
        let mut screen = Self { server, manager: None, display: String::from(":") };
        // It says its number when it is ready.
        let said = screen.server.stdout.take().context("Xvfb is mute")?;
        BufReader::new(said).read_line(&mut screen.display)?;
        screen.display.truncate(screen.display.trim_end().len());
        let manager = Command::new("openbox")
            .env("DISPLAY", &screen.display)
            .stdout(Stdio::null())
            .stderr(Stdio::null())
            .spawn();
        screen.manager = Some(manager.context("starting openbox")?);
        // Desktops are what a window manager has.
        let begin = Instant::now();
        while !screen.hands(&["get_desktop"])? {
            if begin.elapsed() > PATIENCE {
                bail!("openbox does not manage {}", screen.display);
            }
            std::thread::sleep(Duration::from_millis(20));
        }
        Ok(Some(screen))
    }

    /// Presses keys one after the other in whichever window has the keyboard, in X's names: `Tab`, `Return`.
    ///
    /// # Errors
    /// If there's no such key.
    pub fn press(&self, keys: &[&str]) -> Result<()> {
        let done = self.hands(&[&["key", "--delay", "60"], keys].concat())?;
        ensure!(done, "xdotool does not press {keys:?}");
        Ok(())
    }

    /// Clicks in a window that begins in the screen's corner, low in its middle: below all that the page shows there.
    ///
    /// # Errors
    /// If there's no mouse.
    pub fn click_low(&self) -> Result<()> {
        let (x, y) = (SIZE.0 / 2, SIZE.1 - 30);
        let done = self.hands(&["mousemove", &x.to_string(), &y.to_string(), "click", "1"])?;
        ensure!(done, "xdotool does not click");
        Ok(())
    }

    /// What programs know the screen by.
    pub(crate) fn display(&self) -> &str {
        &self.display
    }

    fn hands(&self, what: &[&str]) -> Result<bool> {
        let mut command = Command::new("xdotool");
        command.args(what).env("DISPLAY", &self.display).stdout(Stdio::null()).stderr(Stdio::null());
        Ok(command.status().context("starting xdotool")?.success())
    }
}

impl Drop for Screen {
    fn drop(&mut self) {
        end(self.manager.take());
        let _ = self.server.kill();
        let _ = self.server.wait();
    }
}
