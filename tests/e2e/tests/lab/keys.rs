//! The page's keys: a presenter's remote steps whatever was clicked before, and keys of one letter can be switched off.

use anyhow::Result;
use e2e::{Page, Setup, lab};

use crate::figure_3_1::shows_stop;

/// The keys of presenters' remotes step on and back.
async fn steps(page: &Page) -> Result<()> {
    page.press("Home").await?;
    for (key, stop) in [("PageDown", 1), ("ArrowRight", 2), ("PageDown", 3), ("PageUp", 2), ("ArrowLeft", 1)]
    {
        page.press(key).await?;
        shows_stop(page, stop).await?;
    }
    Ok(())
}

#[tokio::test]
async fn a_presenters_remote_steps_whatever_was_clicked_before() -> Result<()> {
    lab(Setup::default(), async |page| {
        const PLAYS: &str = "document.querySelector('.play').ariaLabel.startsWith('Pause')";
        for clicked in [
            "[aria-label^='Next event']",
            "[aria-pressed=true]",
            "[aria-label^='To start']",
            ".bar .btn",
            ".code",
            ".nodes-scroll",
            ".time",
            "#explorer",
        ] {
            page.click_css(clicked).await?;
            if page.count("dialog").await? > 0 {
                page.leave_dialog().await?;
            }
            steps(page).await?;
            page.press("Space").await?;
            page.wait_until(PLAYS).await?;
            page.press("Space").await?;
            page.wait_until(&format!("!({PLAYS})")).await?;
            assert_eq!(page.count("dialog").await?, 0, "{clicked}");
        }
        // A list that was clicked, and closed again.
        let kind = page.middle(".event-kind").await?;
        page.click_at(kind).await?;
        page.press("Escape").await?;
        page.wait_until("document.activeElement.matches('.event-kind:not(:open)')").await?;
        page.press("PageDown").await?;
        page.press("PageDown").await?;
        page.press("ArrowRight").await?;
        assert_eq!(page.value(".event-kind").await?, "0");
        page.press("Home").await?;
        shows_stop(page, 0).await?;
        steps(page).await
    })
    .await
}

#[tokio::test]
async fn who_comes_by_keys_presses_the_button_and_chooses_from_the_list() -> Result<()> {
    lab(Setup::default(), async |page| {
        page.press("Tab").await?;
        page.run("document.querySelector('[aria-label^=Forward]').focus()").await?;
        page.press("Space").await?;
        shows_stop(page, 1).await?;
        page.press("Enter").await?;
        shows_stop(page, 2).await?;
        page.press("ArrowRight").await?;
        shows_stop(page, 3).await?;
        page.run("document.querySelector('.event-kind').focus()").await?;
        page.press("ArrowDown").await?;
        assert_eq!(page.value(".event-kind").await?, "1");
        page.run("document.querySelector('.event-kind').focus()").await?;
        page.press("PageDown").await?;
        shows_stop(page, 4).await?;
        assert_eq!(page.value(".event-kind").await?, "1");
        // What scrolls is scrolled by its arrows, and still stepped through.
        page.run("document.querySelector('.code').focus()").await?;
        page.press("PageDown").await?;
        shows_stop(page, 5).await?;
        page.press("ArrowDown").await?;
        page.press("ArrowRight").await?;
        shows_stop(page, 6).await
    })
    .await
}

#[tokio::test]
async fn a_field_keeps_its_keys() -> Result<()> {
    lab(Setup::default().at("draw"), async |page| {
        page.wait_for("#drawing").await?;
        page.click("Generate").await?;
        page.wait_for("#gen-width").await?;
        // A slider has its arrows, and what is open around it all letters.
        page.run("document.querySelector('.generator input[type=range]').focus()").await?;
        let before = page.value(".generator input[type=range]").await?;
        page.press("ArrowRight").await?;
        assert_ne!(page.value(".generator input[type=range]").await?, before);
        for key in ["1", "3", "p", "g", "e"] {
            page.press(key).await?;
        }
        assert_eq!(page.count("dialog").await?, 0);
        page.wait_for("main.draw .generator").await?;
        page.press("Escape").await?;
        page.wait_for_no(".generator").await
    })
    .await
}

#[tokio::test]
async fn keys_of_one_letter_can_be_switched_off_and_stay_so() -> Result<()> {
    lab(Setup::default(), async |page| {
        page.press("?").await?;
        page.wait_for("#letters").await?;
        page.click_css("#letters").await?;
        page.wait_for_text("#letters-told", "off, on this device").await?;
        page.wait_for_text(".keycols", "glossary (off)").await?;
        let marked = page.texts(".keycols dd.off").await?;
        assert_eq!(marked.len(), 8, "{marked:?}");
        page.leave_dialog().await?;
        page.reload().await?;
        for key in ["g", "p", "1", "?", "o", "t", "n", "v", "Shift+N"] {
            page.press(key).await?;
        }
        page.press("PageDown").await?;
        shows_stop(page, 1).await?;
        assert_eq!((page.count("dialog").await?, page.count(".projector").await?), (0, 0));
        page.wait_until("document.querySelector('.bar .btn').ariaPressed === 'false'").await?;
        // In Draw they count while the drawing has the focus.
        page.click("Draw").await?;
        page.wait_for("#drawing").await?;
        page.press("e").await?;
        page.press("0").await?;
        page.wait_for(".tool[title^=Line][aria-pressed=true]").await?;
        page.run("document.querySelector('.desk .canvas').focus()").await?;
        page.press("e").await?;
        page.wait_for(".tool[title^=Erase][aria-pressed=true]").await?;
        page.click("Keys").await?;
        page.wait_for("#letters").await?;
        page.click_css("#letters").await?;
        page.leave_dialog().await?;
        page.press("2").await?;
        page.wait_for("#said").await?;
        page.press("g").await?;
        page.wait_for("dialog[open]").await
    })
    .await
}
