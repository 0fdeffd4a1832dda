//! What the browser keeps is never overwritten unseen, and nothing is promised that is not so.

use anyhow::Result;
use e2e::{Page, Setup, Site, lab, lab_at};

use crate::drawing::kept;
use crate::figure_3_1::steps_to_the_end;

const UNREADABLE: &str = "line-maze: 9\ntitle: From the future\n\n+---F\n|    \n^   .\n";

fn maze(title: &str) -> String {
    format!("line-maze: 1\ntitle: {title}\n\n+---F\n|    \n^   .\n")
}

/// Opens a maze of this title, as somebody does who pastes it.
async fn open(page: &Page, title: &str) -> Result<()> {
    page.paste(&maze(title)).await?;
    page.wait_for_text(".stage .bar", title).await
}

async fn keeps(page: &Page, title: &str) -> Result<()> {
    page.wait_until(&format!("localStorage.getItem('line-maze-lab/maze').includes('title: {title}\\n')"))
        .await
}

#[tokio::test]
async fn a_kept_maze_that_cannot_be_read_is_put_aside_and_offered_as_a_file() -> Result<()> {
    lab(Setup::default().stored("maze", UNREADABLE), async |page| {
        let downloads = page.allow_downloads().await?;
        page.wait_for_text(".note.warn", "can’t be read").await?;
        page.wait_for_text(".note.warn", "version").await?;
        page.screenshot("kept-aside").await?;
        open(page, "Drawn since").await?;
        keeps(page, "Drawn since").await?;
        // Also another day.
        page.reload().await?;
        page.wait_for_text(".stage .bar", "Drawn since").await?;
        page.click("Save it as a file").await?;
        assert_eq!(downloads.file("kept-aside.maze").await?, UNREADABLE);
        page.run("document.querySelectorAll('.note .btn')[1].focus()").await?;
        page.press("Enter").await?;
        page.wait_for_no(".note.warn").await?;
        page.wait_until("document.activeElement !== document.body").await?;
        page.reload().await?;
        page.wait_for_text(".stage .bar", "Drawn since").await?;
        assert_eq!(page.count(".note.warn").await?, 0);
        Ok(())
    })
    .await
}

#[tokio::test]
async fn a_second_one_does_not_take_the_place_of_the_first() -> Result<()> {
    let second = UNREADABLE.replace("future", "far future");
    let setup = Setup::default().stored("maze", &second).stored("aside-1", UNREADABLE);
    lab(setup, async |page| {
        page.wait_for_text(".note.warn", "can’t be read").await?;
        let aside = "[1, 2].map((nth) => localStorage.getItem(`line-maze-lab/aside-${nth}`))";
        assert_eq!(page.eval(aside).await?, serde_json::json!([UNREADABLE, second]));
        page.click("Throw it away").await?;
        // The other one is still there.
        page.wait_for_text(".note.warn", "can’t be read").await?;
        page.wait_until("!localStorage.getItem('line-maze-lab/aside-1')").await?;
        page.click("Throw it away").await?;
        page.wait_for_no(".note.warn").await
    })
    .await
}

#[tokio::test]
async fn another_tabs_change_is_told_and_not_overwritten() -> Result<()> {
    lab(Setup::default(), async |page| {
        open(page, "First tab").await?;
        let first = page.tab().await?;
        page.another_tab("step").await?;
        page.wait_for_text(".stage .bar", "First tab").await?;
        assert_eq!(page.count(".note.warn").await?, 0);
        open(page, "Second tab").await?;
        keeps(page, "Second tab").await?;
        let second = page.tab().await?;

        page.to_tab(&first).await?;
        page.wait_for_text(".note.warn", "Another tab has changed the maze").await?;
        page.wait_for_text(".note.warn", "“Second tab”").await?;
        page.screenshot("other-tab").await?;
        // What is drawn here meanwhile takes nothing away from there.
        open(page, "First tab again").await?;
        keeps(page, "Second tab").await?;
        page.click("Take the other tab’s").await?;
        page.wait_for_text(".stage .bar", "Second tab").await?;
        page.wait_for_no(".note.warn").await?;
        page.press("Control+z").await?;
        page.wait_for_text(".stage .bar", "First tab again").await?;
        keeps(page, "First tab again").await?;

        page.to_tab(&second).await?;
        page.wait_for_text(".note.warn", "“First tab again”").await?;
        page.click("Keep this one").await?;
        page.wait_for_no(".note.warn").await?;
        keeps(page, "Second tab").await?;
        page.to_tab(&first).await?;
        page.wait_for_text(".note.warn", "“Second tab”").await
    })
    .await
}

#[tokio::test]
async fn what_a_sleeping_tab_did_not_hear_of_is_not_overwritten_either() -> Result<()> {
    lab(Setup::default(), async |page| {
        open(page, "Here").await?;
        keeps(page, "Here").await?;
        // The same tab hears nothing of what it writes: just so it would be if it had slept.
        page.call(
            "(text) => localStorage.setItem('line-maze-lab/maze', text)",
            &[serde_json::json!(maze("Elsewhere"))],
        )
        .await?;
        open(page, "Here, later").await?;
        page.wait_for_text(".note.warn", "“Elsewhere”").await?;
        assert!(kept(page).await?.contains("title: Elsewhere"));
        Ok(())
    })
    .await
}

/// Puts the page into a frame that may run scripts and nothing else.
async fn in_a_sandbox(page: &Page) -> Result<()> {
    let frame = format!(
        "document.body.innerHTML = '<iframe sandbox=\"allow-scripts\" src=\"{}\" width=\"1200\" height=\"700\"></iframe>'",
        page.address()
    );
    page.run(&frame).await?;
    page.enter_frame().await
}

#[tokio::test]
async fn a_sandboxed_frame_promises_nothing() -> Result<()> {
    // Such a frame is a stranger, also to its own server: most give their programs to no stranger.
    let setup = Setup::default().expect_console("CORS").expect_console("net::ERR_FAILED");
    lab(setup, async |page| {
        in_a_sandbox(page).await?;
        page.wait_until("!document.getElementById('rescue').hidden").await?;
        let said = page.text("#rescue-text").await?;
        assert!(
            said.contains("tab of its own") && !said.contains("safe") && !said.contains("kept"),
            "{said}"
        );
        Ok(())
    })
    .await?;
    let site = Site::start().await?;
    site.let_strangers_in();
    lab_at(&site, Setup::default(), async |page| {
        in_a_sandbox(page).await?;
        page.click_css("#said").await?;
        steps_to_the_end(page).await?;
        page.run("dispatchEvent(new CustomEvent('linemaze:update-ready'))").await?;
        page.wait_for_text(".toast", "does not keep your maze").await?;
        page.run("dispatchEvent(new CustomEvent('linemaze:panic', { detail: 'panicked' }))").await?;
        let said = page.text("#rescue-text").await?;
        assert!(
            said.contains("does not keep your maze: download it before") && !said.contains("safe"),
            "{said}"
        );
        page.click_css("#rescue-download").await?;
        page.wait_until("document.getElementById('rescue-status').innerText.includes('Saved as my.maze')")
            .await
    })
    .await
}

#[tokio::test]
async fn where_the_maze_is_kept_the_rescue_screen_says_so() -> Result<()> {
    lab(Setup::default(), async |page| {
        open(page, "Mine").await?;
        keeps(page, "Mine").await?;
        page.run("dispatchEvent(new CustomEvent('linemaze:panic', { detail: 'panicked' }))").await?;
        page.wait_for_text("#rescue-text", "Your maze is safe: it is kept in this browser").await
    })
    .await
}
