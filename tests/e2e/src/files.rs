//! Files that go into the page and come out of it.

use std::path::PathBuf;
use std::time::{Duration, Instant};

use anyhow::{Result, bail};
use serde_json::json;

use crate::Page;

/// The folder where a page's downloads arrive.
#[derive(Debug)]
pub struct Downloads(PathBuf);

impl Downloads {
    /// A downloaded text, when it's there and whole.
    ///
    /// # Errors
    /// If it never comes.
    pub async fn file(&self, name: &str) -> Result<String> {
        Ok(String::from_utf8(self.bytes(name).await?)?)
    }

    /// A downloaded file, when it's there and whole.
    ///
    /// # Errors
    /// If it never comes.
    pub async fn bytes(&self, name: &str) -> Result<Vec<u8>> {
        let (path, start) = (self.0.join(name), Instant::now());
        while start.elapsed() < Duration::from_secs(10) {
            // Chromium holds the name with an empty file, and moves the whole one there in one go. The page
            // offers no empty files.
            match std::fs::read(&path) {
                Ok(content) if !content.is_empty() => return Ok(content),
                _ => tokio::time::sleep(Duration::from_millis(20)).await,
            }
        }
        let there: Vec<_> = std::fs::read_dir(&self.0)?.flatten().map(|entry| entry.file_name()).collect();
        bail!("{name} was not downloaded; there are {there:?}")
    }

    /// Where a file is, to be opened again.
    #[must_use]
    pub fn path(&self, name: &str) -> PathBuf {
        self.0.join(name)
    }
}

impl Drop for Downloads {
    fn drop(&mut self) {
        let _ = std::fs::remove_dir_all(&self.0);
    }
}

impl Page {
    /// Lets the page download, into a folder of its own.
    ///
    /// # Errors
    /// If the browser refuses.
    pub async fn allow_downloads(&self) -> Result<Downloads> {
        let folder = std::env::temp_dir().join(format!("line-maze-lab-{}", self.session.id()));
        std::fs::create_dir_all(&folder)?;
        let behavior = json!({ "behavior": "allow", "downloadPath": folder });
        self.tools("Browser.setDownloadBehavior", behavior).await?;
        Ok(Downloads(folder))
    }

    /// Drops a file on the page.
    ///
    /// # Errors
    /// If the browser refuses.
    pub async fn drop_file(&self, name: &str, content: &[u8]) -> Result<()> {
        let drop = "(name, content) => {
            const dataTransfer = new DataTransfer();
            dataTransfer.items.add(new File([new Uint8Array(content)], name));
            const event = (kind) => new DragEvent(kind, { dataTransfer, bubbles: true, cancelable: true });
            const target = document.querySelector('main');
            target.dispatchEvent(event('dragover'));
            target.dispatchEvent(event('drop'));
        }";
        self.call(drop, &[json!(name), json!(content)]).await.map(std::mem::drop)
    }

    /// Drops files or folders of the disk on the page, as a hand does.
    ///
    /// # Errors
    /// If the browser refuses.
    pub async fn drop_paths(&self, paths: &[&std::path::Path]) -> Result<()> {
        let (x, y) = self.middle("main").await?;
        let data = json!({ "items": [], "files": paths, "dragOperationsMask": 1 });
        for kind in ["dragEnter", "dragOver", "drop"] {
            let event = json!({ "type": kind, "x": x, "y": y, "data": data });
            self.tools("Input.dispatchDragEvent", event).await?;
        }
        Ok(())
    }

    /// Pastes a text into the page.
    ///
    /// # Errors
    /// If the browser refuses.
    pub async fn paste(&self, text: &str) -> Result<()> {
        let paste = "(text) => {
            const clipboardData = new DataTransfer();
            clipboardData.setData('text/plain', text);
            document.body.dispatchEvent(new ClipboardEvent('paste', { clipboardData, bubbles: true, cancelable: true }));
        }";
        self.call(paste, &[json!(text)]).await.map(std::mem::drop)
    }

    /// Chooses a file in a file field.
    ///
    /// # Errors
    /// If there's no such field.
    pub async fn choose_file(&self, css: &str, path: &std::path::Path) -> Result<()> {
        let document = self.tools("DOM.getDocument", json!({})).await?;
        let root = &document["root"]["nodeId"];
        let field = self.tools("DOM.querySelector", json!({ "nodeId": root, "selector": css })).await?;
        let files = json!({ "nodeId": field["nodeId"], "files": [path] });
        self.tools("DOM.setFileInputFiles", files).await.map(std::mem::drop)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[tokio::test]
    async fn a_download_is_read_when_it_is_whole() -> Result<()> {
        let folder = std::env::temp_dir().join(format!("line-maze-lab-whole-{}", std::process::id()));
        std::fs::create_dir_all(&folder)?;
        let downloads = Downloads(folder);
        std::fs::write(downloads.path("maze.txt"), "")?;
        let (part, whole) = (downloads.path("maze.txt.crdownload"), downloads.path("maze.txt"));
        std::fs::write(&part, "o---o")?;
        let arrives = async {
            tokio::task::yield_now().await;
            std::fs::rename(part, whole)
        };
        let (read, moved) = tokio::join!(downloads.file("maze.txt"), arrives);
        moved?;
        assert_eq!(read?, "o---o");
        Ok(())
    }
}
