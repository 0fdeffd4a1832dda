//! When it goes wrong: storage, broken files, panics, missing pieces.

use anyhow::Result;
use e2e::{Page, Setup, Site, lab, lab_at};

use crate::figure_3_1::steps_to_the_end;

/// Storage that a browser forbids: even asking for it throws.
const FORBIDDEN: &str = "Object.defineProperty(window, 'localStorage', { get() { throw new DOMException('no', 'SecurityError') } });";
/// Storage without any room.
const FULL: &str =
    "Storage.prototype.setItem = () => { throw new DOMException('full', 'QuotaExceededError') };";

#[tokio::test]
async fn without_storage_the_lab_works_and_says_so() -> Result<()> {
    for storage in [FORBIDDEN, FULL] {
        lab(Setup::default().script(storage), async |page| {
            steps_to_the_end(page).await?;
            page.press("1").await?;
            page.wait_for_text(".note.warn", "doesn’t keep your drawing").await?;
            page.screenshot("not-kept").await?;
            page.click("Theme: by system").await?;
            page.wait_for("[aria-label='Theme: light']").await
        })
        .await?;
    }
    Ok(())
}

#[tokio::test]
async fn a_broken_stored_maze_is_no_trouble() -> Result<()> {
    for stored in ["", "nonsense", "line-maze: 1\n\n+--", "line-maze: 9\n"] {
        let setup = Setup::default().stored("maze", stored).stored("settings", "order=XYZ\nnode_max=-1\n=");
        lab(setup, async |page| steps_to_the_end(page).await).await?;
    }
    Ok(())
}

#[tokio::test]
async fn a_broken_file_is_told_with_its_place() -> Result<()> {
    lab(Setup::default(), async |page| {
        page.paste("line-maze: 1\ncell_mm: wide\n\n+---+\n").await?;
        page.wait_for_text(".toast[role=alert]", "Line 2").await?;
        let toast = page.text(".toast").await?;
        assert!(toast.contains("Can’t read the pasted maze") && toast.contains("column"), "{toast}");
        page.screenshot("broken-file").await?;
        page.press("Escape").await?;
        page.wait_for_no(".toast").await?;
        page.drop_file("bad.json", b"{ \"line_maze\": ").await?;
        page.wait_for_text(".toast[role=alert]", "Can’t read bad.json").await?;
        assert!(page.text(".toast").await?.contains("Line 1"), "{}", page.text(".toast").await?);
        page.drop_file("picture.maze", &[0x89, b'P', b'N', b'G', 0xff]).await?;
        page.wait_for_text(".toast[role=alert]", "seems to be a picture").await?;
        page.drop_file("empty.maze", b"").await?;
        page.wait_for_text(".toast[role=alert]", "empty").await?;
        steps_to_the_end(page).await
    })
    .await
}

#[tokio::test]
async fn a_good_file_is_opened_by_drop_and_paste() -> Result<()> {
    const MAZE: &str = "line-maze: 1\ntitle: Dropped\n\n+---F\n|    \n^   .\n";
    lab(Setup::default(), async |page| {
        page.drop_file("dropped.maze", MAZE.as_bytes()).await?;
        page.wait_for_text(".stage .bar", "Dropped").await?;
        page.press("Control+z").await?;
        page.wait_for_text(".stage .bar", "The run of the book").await?;
        page.paste(MAZE).await?;
        page.wait_for_text(".stage .bar", "Dropped").await?;
        page.press("End").await?;
        page.wait_for_text("#said", "FINISH").await
    })
    .await
}

/// The screen for the worst case, with the maze to download and a way to go on.
async fn is_rescued(page: &Page, words: &str) -> Result<()> {
    page.wait_until("!document.getElementById('rescue').hidden").await?;
    assert_eq!(page.focused().await?, page.text("#rescue-title").await?);
    let detail = page.text("#rescue-detail").await?;
    assert!(detail.contains(words) && detail.contains("version"), "{detail}");
    page.screenshot("rescue").await
}

#[tokio::test]
async fn a_panic_shows_a_way_out() -> Result<()> {
    let setup = Setup::default()
        .expect_console("panicked")
        .expect_console("RuntimeError")
        .expect_console("on purpose");
    lab(setup, async |page| {
        page.allow_downloads().await?;
        page.press_times("PageDown", 3).await?;
        // The page can make no new element, which the views take for granted.
        page.eval("Document.prototype.createElement = () => { throw new Error('on purpose') }").await?;
        page.press("g").await?;
        is_rescued(page, "panicked").await?;
        assert!(page.complained("panicked").await?);
        page.click_css("#rescue-restart").await?;
        page.wait_until("!document.getElementById('loading') && document.getElementById('rescue').hidden")
            .await?;
        steps_to_the_end(page).await
    })
    .await
}

#[tokio::test]
async fn the_rescue_screen_saves_the_maze() -> Result<()> {
    lab(Setup::default(), async |page| {
        let downloads = page.allow_downloads().await?;
        page.wait_until("!!localStorage.getItem('line-maze-lab/maze')").await?;
        page.eval("dispatchEvent(new CustomEvent('linemaze:panic', { detail: 'panicked at the disco' }))")
            .await?;
        is_rescued(page, "panicked at the disco").await?;
        page.click("Download maze").await?;
        let maze = downloads.file("my.maze").await?;
        assert!(maze.starts_with("line-maze: 1\ntitle: The run of the book\n"), "{maze}");
        page.click("Copy report").await?;
        page.wait_until("document.getElementById('rescue-status').innerText.includes('report is')").await?;
        page.click("Start again").await?;
        page.wait_until("!document.getElementById('loading') && document.getElementById('rescue').hidden")
            .await
    })
    .await
}

#[tokio::test]
async fn a_missing_part_is_told_and_can_be_asked_for_again() -> Result<()> {
    let site = Site::start().await?;
    site.lose("draw-");
    let setup = Setup::default().expect_console("404").expect_console("wasm").expect_console("WebAssembly");
    lab_at(&site, setup, async |page| {
        page.press("1").await?;
        page.wait_for_text(".arriving[role=alert]", "could not be loaded").await?;
        page.screenshot("missing-part").await?;
        site.find_all();
        page.click("Try again").await?;
        page.wait_for("#drawing").await?;
        page.press("2").await?;
        steps_to_the_end(page).await
    })
    .await
}

#[tokio::test]
async fn a_strangers_error_stops_nobody() -> Result<()> {
    lab(Setup::default().expect_console("an extension"), async |page| {
        page.eval("setTimeout(() => { throw new Error('an extension broke') })").await?;
        page.eval("void Promise.reject(new Error('an extension broke'))").await?;
        steps_to_the_end(page).await
    })
    .await
}
