//! A browser with a fresh profile, told what a test needs before the page is opened.

use std::path::PathBuf;
use std::sync::Arc;

use anyhow::{Context, Result};
use fantoccini::wd::WebDriverCompatibleCommand;
use fantoccini::{Client, ClientBuilder};
use http::Method;
use hyper_util::client::legacy::connect::HttpConnector;
use serde_json::{Value, json};
use url::{ParseError, Url};

use crate::driver::Driver;
use crate::named;
use crate::screen::{SIZE, Screen};
use crate::serial::{Bench, preload};
use crate::site::Site;

/// As the tests' Chromium starts everywhere, also as root in a container.
const FLAGS: &[&str] = &[
    "--no-sandbox",
    "--disable-gpu",
    "--disable-dev-shm-usage",
    "--disable-quic",
    "--no-first-run",
    "--disable-background-networking",
    "--disable-component-update",
    "--disable-sync",
];

/// As it starts where nobody looks.
const UNSEEN: &[&str] = &["--headless"];
/// As it starts on a screen.
const SEEN: &[&str] = &["--ozone-platform=x11", "--window-position=0,0"];

/// What a test wants of its browser.
#[derive(Clone, Debug)]
pub struct Setup {
    pub(crate) size: (u32, u32),
    pub(crate) features: Vec<(&'static str, &'static str)>,
    pub(crate) touch: bool,
    pub(crate) scripts: Vec<String>,
    pub(crate) hash: String,
    pub(crate) expected: Vec<&'static str>,
    pub(crate) arrives: bool,
    pub(crate) scripting: bool,
    pub(crate) serial: Option<Serial>,
    pub(crate) display: Option<String>,
}

/// A browser with a mocked serial port: what it is started with.
#[derive(Clone, Debug)]
pub(crate) struct Serial {
    variables: Vec<(&'static str, PathBuf)>,
    profile: PathBuf,
}

impl Default for Setup {
    /// A laptop, with reduced motion, so that a step is over at once.
    fn default() -> Self {
        Self {
            size: (1440, 900),
            features: vec![("prefers-reduced-motion", "reduce")],
            touch: false,
            scripts: Vec::new(),
            hash: String::new(),
            expected: Vec::new(),
            arrives: true,
            scripting: true,
            serial: None,
            display: None,
        }
    }
}

impl Setup {
    /// With the bot driving smoothly.
    #[must_use]
    pub fn with_motion(mut self) -> Self {
        self.features.retain(|(name, _)| *name != "prefers-reduced-motion");
        self
    }

    /// With a viewport of this size.
    #[must_use]
    pub const fn size(mut self, width: u32, height: u32) -> Self {
        self.size = (width, height);
        self
    }

    /// With a media feature, such as `prefers-color-scheme`.
    #[must_use]
    pub fn media(mut self, name: &'static str, value: &'static str) -> Self {
        self.features.push((name, value));
        self
    }

    /// On a device that is touched.
    #[must_use]
    pub const fn touch(mut self) -> Self {
        self.touch = true;
        self
    }

    /// With a script that runs before the page's own, at every load.
    #[must_use]
    pub fn script(mut self, script: impl Into<String>) -> Self {
        self.scripts.push(script.into());
        self
    }

    /// With something in the browser's storage before the page is first opened.
    #[must_use]
    pub fn stored(self, key: &str, value: &str) -> Self {
        let (key, value) = (json!(format!("line-maze-lab/{key}")), json!(value));
        self.script(format!(
            "if (!sessionStorage[{key}]) {{ sessionStorage[{key}] = 1; localStorage.setItem({key}, {value}); }}"
        ))
    }

    /// At an address that ends in `#` and this.
    #[must_use]
    pub fn at(mut self, hash: impl Into<String>) -> Self {
        self.hash = hash.into();
        self
    }

    /// Where the console has to complain with these words, and may.
    #[must_use]
    pub fn expect_console(mut self, words: &'static str) -> Self {
        self.expected.push(words);
        self
    }

    /// With a mocked serial port, and the permission to open it where it is on USB.
    pub(crate) fn with_serial(mut self, bench: &Bench, site: &Site) -> Result<Self> {
        let profile = bench.folder().join("profile");
        let default = profile.join("Default");
        std::fs::create_dir_all(&default)?;
        std::fs::write(default.join("Preferences"), bench.preferences(&site.origin()).to_string())?;
        let library = preload().context("no umockdev")?;
        let variables = vec![("LD_PRELOAD", library), ("UMOCKDEV_DIR", bench.mocked.clone())];
        self.serial = Some(Serial { variables, profile });
        Ok(self)
    }

    /// On a screen, with all that the browser shows beside the page.
    #[must_use]
    pub fn on(mut self, screen: &Screen) -> Self {
        self.display = Some(screen.display().to_owned());
        self
    }

    /// Where no script runs.
    #[must_use]
    pub const fn without_scripts(mut self) -> Self {
        self.scripting = false;
        self.never_arrives()
    }

    /// Where the page can't be expected to start.
    #[must_use]
    pub const fn never_arrives(mut self) -> Self {
        self.arrives = false;
        self
    }
}

/// A command of the browser's driver.
#[derive(Debug)]
struct Command {
    path: &'static str,
    method: Method,
    body: Value,
}

impl WebDriverCompatibleCommand for Command {
    fn endpoint(&self, base: &Url, session: Option<&str>) -> Result<Url, ParseError> {
        base.join(&format!("session/{}/{}", session.unwrap_or_default(), self.path))
    }

    fn method_and_body(&self, _: &Url) -> (Method, Option<String>) {
        (self.method.clone(), (self.method != Method::GET).then(|| self.body.to_string()))
    }
}

/// A browser; its end is the session's.
#[derive(Debug)]
pub(crate) struct Session {
    pub(crate) client: Client,
    id: String,
    driver: Arc<Driver>,
}

impl Session {
    pub(crate) async fn start(setup: &Setup) -> Result<Self> {
        let mut variables = setup.serial.as_ref().map_or_else(Vec::new, |serial| serial.variables.clone());
        variables.extend(setup.display.as_ref().map(|display| ("DISPLAY", PathBuf::from(display))));
        let driver =
            if variables.is_empty() { Driver::shared()? } else { Arc::new(Driver::start(&variables)?) };
        let looks = if setup.display.is_some() { SEEN } else { UNSEEN };
        let mut flags: Vec<String> = [FLAGS, looks].concat().into_iter().map(str::to_owned).collect();
        if setup.display.is_some() {
            flags.push(format!("--window-size={},{}", SIZE.0, SIZE.1));
        }
        if let Some(serial) = &setup.serial {
            flags.push(format!("--user-data-dir={}", serial.profile.display()));
            // The library that mocks the port has a lock on opening files. A process that the browser starts for the
            // network opens one before it is a program of its own: now and then it waited for a lock that a thread
            // held in the browser only, for ever, and no page was loaded.
            flags.push("--enable-features=NetworkServiceInProcess2".to_owned());
        }
        let mut options = json!({ "args": flags });
        if let Some(chromium) = named("CHROMIUM") {
            options["binary"] = json!(chromium);
        }
        let Value::Object(capabilities) = json!({
            "goog:chromeOptions": options,
            "goog:loggingPrefs": { "browser": "ALL" },
            "unhandledPromptBehavior": "ignore",
        }) else {
            unreachable!("it's an object")
        };
        let client = ClientBuilder::new(HttpConnector::new())
            .capabilities(capabilities)
            .connect(&driver.address())
            .await
            .context("starting Chromium")?;
        let id = client.session_id().await?.context("no session")?;
        Ok(Self { client, id, driver })
    }

    /// A name that no other session has.
    pub(crate) fn id(&self) -> &str {
        &self.id
    }

    /// Tells the driver.
    pub(crate) async fn tell(&self, path: &'static str, body: Value) -> Result<Value> {
        let command = Command { path, method: Method::POST, body };
        self.client.issue_cmd(command).await.with_context(|| format!("the driver's {path}"))
    }

    /// Speaks the protocol of Chromium's developer tools.
    pub(crate) async fn tools(&self, method: &str, params: Value) -> Result<Value> {
        self.tell("goog/cdp/execute", json!({ "cmd": method, "params": params }))
            .await
            .with_context(|| format!("{method} {params}"))
    }

    /// Prepares the browser for a test.
    pub(crate) async fn prepare(&self, setup: &Setup) -> Result<()> {
        let (width, height) = setup.size;
        let metrics = json!({ "width": width, "height": height, "deviceScaleFactor": 1, "mobile": false });
        self.tools("Emulation.setDeviceMetricsOverride", metrics).await?;
        let features: Vec<Value> =
            setup.features.iter().map(|(name, value)| json!({ "name": name, "value": value })).collect();
        self.tools("Emulation.setEmulatedMedia", json!({ "features": features })).await?;
        if setup.touch {
            let touch = json!({ "enabled": true, "maxTouchPoints": 5 });
            self.tools("Emulation.setTouchEmulationEnabled", touch).await?;
            // What is touched has scroll bars that take no room.
            self.tools("Emulation.setScrollbarsHidden", json!({ "hidden": true })).await?;
        }
        if !setup.scripting {
            self.tools("Emulation.setScriptExecutionDisabled", json!({ "value": true })).await?;
        }
        for script in &setup.scripts {
            self.tools("Page.addScriptToEvaluateOnNewDocument", json!({ "source": script })).await?;
        }
        Ok(())
    }
}

impl Drop for Session {
    fn drop(&mut self) {
        self.driver.tell("DELETE", &format!("/session/{}", self.id));
    }
}
