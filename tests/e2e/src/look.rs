//! What a person sees on the page.

use anyhow::{Context, Result};
use serde_json::{Value, json};

use crate::Page;

impl Page {
    /// An element's text as it is shown, once it is there.
    ///
    /// # Errors
    /// If there's no such element.
    pub async fn text(&self, css: &str) -> Result<String> {
        self.wait_for(css).await?;
        let text = self.call("(css) => document.querySelector(css)?.innerText", &[json!(css)]).await?;
        Ok(text.as_str().with_context(|| format!("there's no {css}"))?.to_owned())
    }

    /// The texts of all such elements.
    ///
    /// # Errors
    /// If the browser doesn't tell.
    pub async fn texts(&self, css: &str) -> Result<Vec<String>> {
        let all = "(css) => [...document.querySelectorAll(css)].map((found) => found.innerText)";
        let texts = self.call(all, &[json!(css)]).await?;
        let text = |value: &Value| value.as_str().unwrap_or_default().to_owned();
        Ok(texts.as_array().into_iter().flatten().map(text).collect())
    }

    /// An element's attribute, once the element is there.
    ///
    /// # Errors
    /// If there's no such element or attribute.
    pub async fn attribute(&self, css: &str, name: &str) -> Result<String> {
        self.wait_for(css).await?;
        let get = "(css, name) => document.querySelector(css)?.getAttribute(name)";
        let value = self.call(get, &[json!(css), json!(name)]).await?;
        Ok(value.as_str().with_context(|| format!("there's no {name} at {css}"))?.to_owned())
    }

    /// How many such elements there are.
    ///
    /// # Errors
    /// If the browser doesn't tell.
    pub async fn count(&self, css: &str) -> Result<u64> {
        let count = self.call("(css) => document.querySelectorAll(css).length", &[json!(css)]).await?;
        count.as_u64().context("no number")
    }

    /// Whether an element is there and can be seen.
    ///
    /// # Errors
    /// If the browser doesn't tell.
    pub async fn sees(&self, css: &str) -> Result<bool> {
        let visible = "(css) => !!document.querySelector(css)?.checkVisibility()";
        Ok(self.call(visible, &[json!(css)]).await? == json!(true))
    }

    /// What a field holds.
    ///
    /// # Errors
    /// If there's no such field.
    pub async fn value(&self, css: &str) -> Result<String> {
        self.wait_for(css).await?;
        let value = self.call("(css) => document.querySelector(css)?.value", &[json!(css)]).await?;
        Ok(value.as_str().with_context(|| format!("there's no field {css}"))?.to_owned())
    }

    /// The focused element: its name, or else its text.
    ///
    /// # Errors
    /// If the browser doesn't tell.
    pub async fn focused(&self) -> Result<String> {
        let name = "(document.activeElement?.ariaLabel ?? document.activeElement?.innerText ?? '').trim()";
        Ok(self.eval(name).await?.as_str().unwrap_or_default().to_owned())
    }
}
