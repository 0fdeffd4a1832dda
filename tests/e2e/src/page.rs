//! The page in a browser: opening it, and waiting until something holds.

use std::cell::RefCell;
use std::time::{Duration, Instant};

use anyhow::{Context, Result, bail};
use fantoccini::Locator;
use fantoccini::wd::WindowHandle;
use serde_json::{Value, json};

use crate::root;
use crate::session::{Session, Setup};
use crate::site::Site;

/// Nothing on this page takes longer, also on a busy computer.
const PATIENCE: Duration = Duration::from_secs(15);
/// Between two looks at the page.
const BLINK: Duration = Duration::from_millis(15);

/// The page in a browser of its own.
#[derive(Debug)]
pub struct Page {
    pub(crate) session: Session,
    pub(crate) expected: Vec<&'static str>,
    pub(crate) heard: RefCell<Vec<String>>,
    address: String,
}

impl Page {
    pub(crate) async fn open(site: &Site, setup: Setup) -> Result<Self> {
        let session = Session::start(&setup).await?;
        session.prepare(&setup).await?;
        let page = Self {
            session,
            expected: setup.expected,
            heard: RefCell::new(Vec::new()),
            address: site.address(),
        };
        let hash = if setup.hash.is_empty() { String::new() } else { format!("#{}", setup.hash) };
        page.session.client.goto(&format!("{}{hash}", page.address)).await?;
        if setup.arrives {
            page.wait_for_start().await?;
        }
        Ok(page)
    }

    /// The page's own address, without `#`.
    #[must_use]
    pub fn address(&self) -> &str {
        &self.address
    }

    /// Loads the page again, as F5 does.
    ///
    /// # Errors
    /// If it doesn't start.
    pub async fn reload(&self) -> Result<()> {
        self.eval("window.beforeReload = true").await?;
        self.session.client.refresh().await?;
        self.wait_until("!window.beforeReload").await?;
        self.wait_for_start().await
    }

    /// Goes back, as the browser's button does.
    ///
    /// # Errors
    /// If there's nowhere to go.
    pub async fn back(&self) -> Result<()> {
        Ok(self.session.client.back().await?)
    }

    /// Opens the page in another tab of the same browser, and stays there.
    ///
    /// # Errors
    /// If it doesn't start.
    pub async fn another_tab(&self, hash: &str) -> Result<()> {
        let tab = self.session.client.new_window(true).await?;
        self.session.client.switch_to_window(tab.handle).await?;
        self.session.client.goto(&format!("{}#{hash}", self.address)).await?;
        self.wait_for_start().await
    }

    /// This tab, to come back to.
    ///
    /// # Errors
    /// If the browser doesn't tell.
    pub async fn tab(&self) -> Result<WindowHandle> {
        Ok(self.session.client.window().await?)
    }

    /// Goes to a tab.
    ///
    /// # Errors
    /// If it's not there.
    pub async fn to_tab(&self, tab: &WindowHandle) -> Result<()> {
        Ok(self.session.client.switch_to_window(tab.clone()).await?)
    }

    /// Goes into the only frame of the page: from now on, that is the page.
    ///
    /// # Errors
    /// If there is none.
    pub async fn enter_frame(&self) -> Result<()> {
        Ok(self.session.client.enter_frame(0).await?)
    }

    /// Closes this tab, and goes to the one that is left.
    ///
    /// # Errors
    /// If none is left.
    pub async fn close_tab(&self) -> Result<()> {
        let client = &self.session.client;
        client.close_window().await?;
        let left = client.windows().await?.into_iter().next().context("no tab is left")?;
        Ok(client.switch_to_window(left).await?)
    }

    async fn wait_for_start(&self) -> Result<()> {
        self.wait_until("!document.getElementById('loading') && !!document.querySelector('main')").await
    }

    /// The value of an expression on the page.
    ///
    /// # Errors
    /// Where it throws.
    pub async fn eval(&self, expression: &str) -> Result<Value> {
        self.session
            .client
            .execute(&format!("return ({expression});"), vec![])
            .await
            .with_context(|| format!("evaluating {expression}"))
    }

    /// Runs a whole script on the page.
    ///
    /// # Errors
    /// Where it throws.
    pub async fn run(&self, script: &str) -> Result<()> {
        self.session.client.execute(script, vec![]).await.context("running a script")?;
        Ok(())
    }

    /// A function's value on the page, with arguments.
    ///
    /// # Errors
    /// Where it throws.
    pub async fn call(&self, function: &str, arguments: &[Value]) -> Result<Value> {
        self.session
            .client
            .execute(&format!("return ({function})(...arguments);"), arguments.to_vec())
            .await
            .with_context(|| format!("calling {function} with {arguments:?}"))
    }

    /// What a promise on the page comes to.
    ///
    /// # Errors
    /// Where it is rejected.
    pub async fn promised(&self, expression: &str) -> Result<Value> {
        let script = format!(
            "const done = arguments[arguments.length - 1];\
             ({expression}).then((value) => done({{ value }}), (error) => done({{ error: String(error) }}));"
        );
        let mut settled = self.session.client.execute_async(&script, vec![]).await?;
        match settled.get("error") {
            Some(error) => bail!("{error}"),
            None => Ok(settled["value"].take()),
        }
    }

    /// Waits until an expression holds on the page.
    ///
    /// # Errors
    /// If it never does.
    pub async fn wait_until(&self, expression: &str) -> Result<()> {
        let start = Instant::now();
        let mut value = Ok(Value::Null);
        while start.elapsed() < PATIENCE {
            // While a page is loading, there may be nobody to answer.
            value = self.eval(&format!("!!({expression})")).await;
            if matches!(value, Ok(Value::Bool(true))) {
                return Ok(());
            }
            tokio::time::sleep(BLINK).await;
        }
        value?;
        let text = self.eval("document.body.innerText").await.unwrap_or_default();
        let text: String = text.as_str().unwrap_or_default().chars().take(800).collect();
        bail!("it never happened that {expression}\nThe page says:\n{text}")
    }

    /// Whether an expression comes to hold within this time, for what may be tried again.
    ///
    /// # Errors
    /// If the browser doesn't tell.
    pub async fn comes_true(&self, expression: &str, within: Duration) -> Result<bool> {
        let start = Instant::now();
        loop {
            let value = self.eval(&format!("!!({expression})")).await?;
            if value == true || start.elapsed() > within {
                return Ok(value == true);
            }
            tokio::time::sleep(BLINK).await;
        }
    }

    /// Waits until an element's text contains words, whatever letters the style makes capital.
    ///
    /// # Errors
    /// If it never does.
    pub async fn wait_for_text(&self, css: &str, words: &str) -> Result<()> {
        let (css, words) = (json!(css), json!(words.to_lowercase()));
        self.wait_until(&format!("document.querySelector({css})?.innerText.toLowerCase().includes({words})"))
            .await
    }

    /// Waits until an element is there.
    ///
    /// # Errors
    /// If it never is.
    pub async fn wait_for(&self, css: &str) -> Result<()> {
        self.wait_until(&format!("document.querySelector({})", json!(css))).await
    }

    /// Waits until an element is gone.
    ///
    /// # Errors
    /// If it stays.
    pub async fn wait_for_no(&self, css: &str) -> Result<()> {
        self.wait_until(&format!("!document.querySelector({})", json!(css))).await
    }

    /// Settings of the browser, in the words of its developer tools.
    ///
    /// # Errors
    /// If it doesn't know them.
    pub async fn tools(&self, method: &str, params: Value) -> Result<Value> {
        self.session.tools(method, params).await
    }

    /// Keeps a picture of the viewport in `target/screenshots`.
    ///
    /// # Errors
    /// If it can't be taken or kept.
    pub async fn screenshot(&self, name: &str) -> Result<()> {
        keep(name, &self.session.client.screenshot().await?)
    }

    /// Keeps a picture of one element there.
    ///
    /// # Errors
    /// If there's no such element, or it can't be kept.
    pub async fn picture(&self, css: &str, name: &str) -> Result<()> {
        let element = self.session.client.find(Locator::Css(css)).await?;
        keep(name, &element.screenshot().await?)
    }
}

fn keep(name: &str, png: &[u8]) -> Result<()> {
    let folder = root().join("target/screenshots");
    std::fs::create_dir_all(&folder)?;
    std::fs::write(folder.join(format!("{name}.png")), png).context("keeping a picture")
}
