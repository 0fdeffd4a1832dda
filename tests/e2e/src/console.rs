//! What the browser's console complains about: errors, warnings, breaches of the content security policy.

use anyhow::Result;
use serde_json::{Value, json};

use crate::Page;

impl Page {
    /// Errors and warnings so far that the test doesn't expect.
    ///
    /// # Errors
    /// If the browser doesn't tell.
    pub async fn complaints(&self) -> Result<Vec<String>> {
        let entries = self.session.tell("se/log", json!({ "type": "browser" })).await?;
        let mut heard = self.heard.borrow_mut();
        heard.extend(
            entries.as_array().into_iter().flatten().filter(|entry| is_complaint(entry)).map(message),
        );
        let expected = |message: &String| self.expected.iter().any(|words| message.contains(words));
        Ok(heard.iter().filter(|message| !expected(message)).cloned().collect())
    }

    /// Whether the console said something like this, however bad.
    ///
    /// # Errors
    /// If the browser doesn't tell.
    pub async fn complained(&self, words: &str) -> Result<bool> {
        self.complaints().await?;
        Ok(self.heard.borrow().iter().any(|message| message.contains(words)))
    }
}

fn is_complaint(entry: &Value) -> bool {
    matches!(entry["level"].as_str(), Some("SEVERE" | "WARNING"))
}

fn message(entry: &Value) -> String {
    format!(
        "{}: {}",
        entry["level"].as_str().unwrap_or_default(),
        entry["message"].as_str().unwrap_or_default()
    )
}
