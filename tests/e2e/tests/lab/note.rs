//! What a maze teaches: shown in Step and on the projector, folded as one likes, and passed on with a link.

use anyhow::{Context, Result};
use e2e::{Page, Setup, Site, lab, lab_at};

const OPEN: &str = "document.querySelector('.maze-note').open";

fn maze(note: &str) -> String {
    format!("line-maze: 1\ntitle: A hook\nnote: {note}\n\n+---F\n|    \n^   .\n")
}

#[tokio::test]
async fn a_note_is_shown_and_stays_folded_as_it_was() -> Result<()> {
    lab(Setup::default(), async |page| {
        // There is room for it.
        page.wait_until(OPEN).await?;
        assert!(
            page.text(".maze-note p").await?.starts_with("The book walks through this maze stop by stop")
        );
        page.run("document.querySelector('.maze-note summary').focus()").await?;
        page.press("Enter").await?;
        page.wait_until(&format!("!{OPEN}")).await?;
        // Folded it still says how it begins.
        assert!(page.text(".maze-note .begins").await?.starts_with("The book walks"));
        page.press("p").await?;
        page.wait_for(".projector .maze-note").await?;
        page.wait_until(&format!("!{OPEN}")).await?;
        page.reload().await?;
        page.wait_for(".maze-note").await?;
        page.wait_until(&format!("!{OPEN}")).await?;
        page.click_css(".maze-note summary").await?;
        page.wait_until(OPEN).await?;
        page.press("p").await?;
        page.wait_for_no(".projector").await?;
        page.wait_until(OPEN).await?;
        // Another explorer's room has it too; a maze without a note has none.
        page.press("o").await?;
        page.choose("#explorer-name", "Full mapping").await?;
        page.leave_dialog().await?;
        page.wait_for("#inspector").await?;
        page.wait_for(".maze-note").await?;
        page.paste("line-maze: 1\n\n+---F\n|    \n^   .\n").await?;
        page.wait_for_no(".maze-note").await
    })
    .await
}

#[tokio::test]
async fn a_small_window_has_it_folded_at_first() -> Result<()> {
    lab(Setup::default().size(1366, 768), async |page| {
        page.wait_for(".maze-note").await?;
        assert_eq!(page.eval(OPEN).await?, false);
        page.screenshot("note-folded").await
    })
    .await
}

/// The link that the dialog offers.
async fn link(page: &Page) -> Result<String> {
    page.click("Share").await?;
    page.wait_for("dialog #link").await?;
    let link = page.value("#link").await?;
    Ok(link.split_once('#').context("a link without #")?.1.to_owned())
}

#[tokio::test]
async fn a_note_travels_with_the_link_unless_that_would_be_too_long() -> Result<()> {
    let site = Site::start().await?;
    lab_at(&site, Setup::default(), async |page| {
        page.paste(&maze("It turns right once: no node, no letter.")).await?;
        page.wait_for_text(".maze-note", "no node, no letter").await?;
        let with_note = link(page).await?;
        assert_eq!(page.count("dialog .qr").await?, 1);
        assert_eq!(page.count("#without-note").await?, 0);
        page.leave_dialog().await?;
        lab_at(&site, Setup::default().at(with_note), async |other| {
            other.wait_for_text(".maze-note", "no node, no letter").await
        })
        .await?;
        // Longer than a link may be: everything else travels, and that is said.
        page.paste(&maze(&"long ".repeat(1_300))).await?;
        page.wait_for_text(".maze-note", "long long").await?;
        let without = link(page).await?;
        page.wait_for_text("#without-note", "All but its note").await?;
        assert_eq!(page.count("dialog .qr").await?, 1);
        page.leave_dialog().await?;
        lab_at(&site, Setup::default().at(without), async |other| {
            other.wait_for_text(".stage .bar", "A hook").await?;
            other.wait_for_no(".maze-note").await
        })
        .await
    })
    .await
}
