//! A real browser uses the page: [`lab`] opens it in a fresh profile from a server of its own, lets a test act
//! on the [`Page`] as a person would, and fails the test where the browser's console complains.
//!
//! `cargo xtask test e2e` builds the page and calls these tests with:
//!
//! - `LINE_MAZE_DIST`: the folder with the page; `dist` if not set,
//! - `CHROMEDRIVER` and `CHROMIUM`: the programs; looked up on the `PATH` if not set,
//! - `AXE_CORE`: the script that looks for barriers.
//!
//! Screenshots, also of every test that fails, are in `target/screenshots`.

mod console;
mod driver;
mod files;
mod input;
mod look;
mod page;
mod screen;
mod serial;
mod session;
mod site;

use std::panic::{AssertUnwindSafe, resume_unwind};
use std::path::{Path, PathBuf};

use anyhow::Result;
use futures_util::FutureExt;

pub use files::Downloads;
pub use input::{Button, Place};
pub use page::Page;
pub use screen::Screen;
pub use serial::{Bench, Bus, bench};
pub use session::Setup;
pub use site::Site;

/// Opens the page, lets the test act, then asks the browser's console whether all went well.
///
/// # Errors
/// What the test's body says, or what stands in the console.
pub async fn lab(setup: Setup, body: impl AsyncFnOnce(&Page) -> Result<()>) -> Result<()> {
    let site = Site::start().await?;
    lab_at(&site, setup, body).await
}

/// The same, with a server that the test keeps in its hands.
///
/// # Errors
/// What the test's body says, or what stands in the console.
pub async fn lab_at(site: &Site, setup: Setup, body: impl AsyncFnOnce(&Page) -> Result<()>) -> Result<()> {
    let page = Page::open(site, setup).await?;
    let ended = AssertUnwindSafe(body(&page)).catch_unwind().await;
    if !matches!(ended, Ok(Ok(()))) {
        let name = std::thread::current().name().unwrap_or("test").replace("::", "-");
        let _ = page.screenshot(&format!("failed-{name}")).await;
        if let Ok(complaints) = page.complaints().await {
            complaints.iter().for_each(|complaint| eprintln!("console: {complaint}"));
        }
    }
    match ended {
        Ok(result) => result?,
        Err(panic) => resume_unwind(panic),
    }
    let complaints = page.complaints().await?;
    assert!(complaints.is_empty(), "the console complains:\n{}", complaints.join("\n"));
    Ok(())
}

/// The page in a browser that has this bench's serial port; the test may pull its cable.
///
/// # Errors
/// What the test's body says, or what stands in the console.
pub async fn lab_on(
    bench: &mut Bench,
    setup: Setup,
    body: impl AsyncFnOnce(&Page, &mut Bench) -> Result<()>,
) -> Result<()> {
    let site = Site::start().await?;
    let setup = setup.with_serial(bench, &site)?;
    lab_at(&site, setup, async |page| body(page, bench).await).await
}

/// The repository's folder.
#[must_use]
pub fn root() -> &'static Path {
    Path::new(concat!(env!("CARGO_MANIFEST_DIR"), "/../.."))
}

/// A path that an environment variable names.
fn named(variable: &str) -> Option<PathBuf> {
    std::env::var_os(variable).filter(|value| !value.is_empty()).map(PathBuf::from)
}
