//! Whether the program arrives, and what people read where it cannot.

use anyhow::Result;
use e2e::{Page, Setup, Site, lab, lab_at};
use serde_json::json;

use crate::figure_3_1::steps_to_the_end;

/// What the screen for the worst case says, once it is there.
async fn rescue(page: &Page) -> Result<String> {
    page.wait_until("!document.getElementById('rescue').hidden").await?;
    assert!(page.text("#rescue-detail").await?.contains("version"));
    assert_eq!(page.eval("document.getElementById('loading')").await?, json!(null), "it waits for nothing");
    page.text("#rescue-text").await
}

/// Where the browser's own words about it in the console are no surprise.
fn trouble() -> Setup {
    ["404", "wasm", "WebAssembly", "MIME", "imported module", "CompileError"]
        .into_iter()
        .fold(Setup::default().never_arrives(), Setup::expect_console)
}

#[tokio::test]
async fn a_server_that_does_not_know_wasm_serves_every_room() -> Result<()> {
    let site = Site::start().await?;
    site.call(".wasm", "application/octet-stream");
    // The program's own loader says that it would be quicker otherwise.
    lab_at(&site, Setup::default().expect_console("application/wasm"), async |page| {
        steps_to_the_end(page).await?;
        page.press("g").await?;
        page.wait_for("dialog #name-ptr").await?;
        page.leave_dialog().await?;
        page.press("o").await?;
        page.choose("#explorer-name", "Flood fill, goal told").await?;
        page.leave_dialog().await?;
        page.wait_until("document.querySelector('#explorer').ariaLabel.includes('Flood fill, goal told')")
            .await?;
        page.wait_for("#inspector").await?;
        page.press("1").await?;
        page.wait_for("#drawing").await?;
        page.press("3").await?;
        page.wait_for(".run[data-nth='2']").await?;
        page.press("4").await?;
        page.wait_for("#demo").await
    })
    .await
}

#[tokio::test]
async fn without_webassembly_the_page_says_what_is_missing() -> Result<()> {
    let setup = trouble().script("delete globalThis.WebAssembly").stored("maze", "line-maze: 1\n\n^   F\n");
    lab(setup, async |page| {
        let text = rescue(page).await?;
        assert!(text.contains("this browser has WebAssembly switched off"), "{text}");
        // What is there works: the maze can be saved.
        let downloads = page.allow_downloads().await?;
        page.click("Download maze").await?;
        downloads.file("my.maze").await?;
        page.screenshot("no-webassembly").await
    })
    .await
}

#[tokio::test]
async fn a_server_that_forbids_webassembly_is_told_from_a_missing_file() -> Result<()> {
    let site = Site::start().await?;
    site.forbid("script-src 'self'");
    lab_at(&site, trouble(), async |page| {
        let text = rescue(page).await?;
        assert!(text.contains("forbids WebAssembly") && text.contains("'wasm-unsafe-eval'"), "{text}");
        Ok(())
    })
    .await
}

#[tokio::test]
async fn a_missing_program_is_told_by_its_name() -> Result<()> {
    for (missing, name) in [("_bg.wasm", "_bg.wasm"), ("line-maze-lab", ".js"), ("start.js", "")] {
        let site = Site::start().await?;
        site.lose(missing);
        lab_at(&site, trouble(), async |page| {
            let text = rescue(page).await?;
            assert!(text.contains("did not arrive completely"), "{text}");
            if name.is_empty() {
                assert!(page.text("#rescue-detail").await?.contains("start.js is missing"));
            } else {
                assert!(text.contains("answers 404 for line-maze-lab") && text.contains(name), "{text}");
            }
            // Nothing was drawn here yet.
            assert!(!text.contains("safe"), "{text}");
            page.screenshot("missing-program").await
        })
        .await?;
    }
    Ok(())
}

#[tokio::test]
async fn a_kept_maze_is_said_to_be_safe() -> Result<()> {
    let site = Site::start().await?;
    site.lose(".wasm");
    let setup = trouble().stored("maze", "line-maze: 1\n\n^   F\n");
    lab_at(&site, setup, async |page| {
        assert!(rescue(page).await?.contains("Your maze is safe"));
        Ok(())
    })
    .await
}

#[tokio::test]
async fn something_else_under_the_programs_name_is_told() -> Result<()> {
    let site = Site::start().await?;
    site.stand_in("_bg.wasm", b"<!doctype html><title>Not found</title>");
    lab_at(&site, trouble(), async |page| {
        let text = rescue(page).await?;
        assert!(text.contains("_bg.wasm is something else"), "{text}");
        Ok(())
    })
    .await
}

#[tokio::test]
async fn a_script_under_a_wrong_type_is_told() -> Result<()> {
    let site = Site::start().await?;
    site.call("line-maze-lab", "text/plain");
    lab_at(&site, trouble(), async |page| {
        let text = rescue(page).await?;
        assert!(text.contains(".js is “text/plain”") && text.contains("text/javascript"), "{text}");
        Ok(())
    })
    .await
}

#[tokio::test]
async fn a_browser_that_does_not_understand_the_program_is_told_to_be_too_old() -> Result<()> {
    const OLD: &str = "WebAssembly.instantiateStreaming = WebAssembly.instantiate = async () => {
        throw new WebAssembly.CompileError('invalid opcode 0xfc');
    };";
    lab(trouble().script(OLD), async |page| {
        let text = rescue(page).await?;
        assert!(text.contains("too old for the lab"), "{text}");
        assert!(page.text("#rescue-detail").await?.contains("invalid opcode"));
        Ok(())
    })
    .await
}

/// What stands on the page for a person who looks at it.
const SEEN: &str =
    "[...document.querySelectorAll('body p')].filter((p) => p.checkVisibility({ visibilityProperty: true }))
    .map((p) => p.innerText).join('|')";

#[tokio::test]
async fn a_browser_without_modules_is_told_to_be_too_old() -> Result<()> {
    let site = Site::start().await?;
    // As such a browser reads the page: it takes `nomodule` for nothing, and understands no other script.
    site.change("index.html", "<script nomodule", "<script");
    site.change("index.html", "<script src=\"start.js\"", "<script type=\"unknown\" src=\"start.js\"");
    site.change("index.html", "<script src=\"rescue.js\"", "<script type=\"unknown\" src=\"rescue.js\"");
    lab_at(&site, trouble(), async |page| page.wait_for_text("#loading", "too old for Line Maze Lab").await)
        .await
}

#[tokio::test]
async fn without_scripts_one_notice_says_so() -> Result<()> {
    lab(Setup::default().without_scripts(), async |page| {
        page.wait_until(&format!("({SEEN}).includes('allow JavaScript')")).await?;
        let seen = page.eval(SEEN).await?;
        let seen = seen.as_str().unwrap_or_default();
        assert!(!seen.contains('|') && !seen.contains("Loading"), "{seen}");
        page.screenshot("no-javascript").await
    })
    .await
}

#[tokio::test]
async fn where_no_script_may_run_the_page_does_not_wait_in_silence() -> Result<()> {
    let site = Site::start().await?;
    site.forbid("script-src 'none'");
    lab_at(&site, trouble().expect_console("Content Security Policy"), async |page| {
        assert_eq!(page.eval(SEEN).await?, "Loading the lab…");
        page.tools("Animation.enable", json!({})).await?;
        page.tools("Animation.setPlaybackRate", json!({ "playbackRate": 1000 })).await?;
        page.wait_until(&format!("({SEEN}).includes('does not let the page’s scripts run')")).await?;
        page.screenshot("no-script-allowed").await
    })
    .await
}
