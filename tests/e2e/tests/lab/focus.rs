//! The keyboard's focus: dialogs begin in their first field and give it back, and no button takes it away with it.

use anyhow::Result;
use e2e::{Page, Setup, lab};
use serde_json::json;

use crate::connect::{demo, state};
use crate::drawing::from_menu;

/// The focus is on what this selects.
async fn at(page: &Page, css: &str) -> Result<()> {
    page.wait_until(&format!("document.activeElement.matches({})", json!(css))).await
}

/// Puts the focus on a control, as somebody does who came there by keys.
async fn come_to(page: &Page, css: &str) -> Result<()> {
    page.wait_for(css).await?;
    page.press("Tab").await?;
    page.call("(css) => document.querySelector(css).focus()", &[json!(css)]).await?;
    at(page, css).await
}

/// A dialog is open with the focus here; what is typed leaves it open, and the room behind it as it was.
async fn begins_at(page: &Page, css: &str) -> Result<()> {
    page.wait_for("dialog[open]").await?;
    at(page, css).await?;
    let room = page.attribute("#main", "class").await?;
    for key in ["1", "3", "p", "g", "n", "?", "v"] {
        page.press(key).await?;
    }
    assert_eq!(page.count("dialog[open]").await?, 1, "{css}");
    assert_eq!(page.attribute("#main", "class").await?, room, "{css}");
    Ok(())
}

#[tokio::test]
async fn a_dialog_begins_in_its_first_field() -> Result<()> {
    lab(Setup::default(), async |page| {
        // What is only read begins in its text, which keys scroll; the cross never has the focus.
        for (key, first) in [("?", ".keycols"), ("g", ".dialog-body"), ("t", "#turns")] {
            page.press(key).await?;
            begins_at(page, first).await?;
            page.press("Space").await?;
            page.leave_dialog().await?;
            page.wait_for_text("#count", "stop 0 /").await?;
        }
        page.press("o").await?;
        begins_at(page, "#explorer-name").await?;
        page.leave_dialog().await?;
        page.click("Share").await?;
        begins_at(page, "#link").await?;
        page.press("Space").await?;
        page.leave_dialog().await?;
        page.press("1").await?;
        page.wait_for("#drawing").await?;
        page.press("Alt+n").await?;
        begins_at(page, "#new-width").await?;
        page.leave_dialog().await?;
        for (entry, first) in [("Paste a maze…", "#paste"), ("Resize…", "#resize-width")] {
            from_menu(page, entry).await?;
            begins_at(page, first).await?;
            page.leave_dialog().await?;
        }
        page.click("Rename, describe").await?;
        begins_at(page, "#about-title").await?;
        page.press("Space").await?;
        page.leave_dialog().await?;
        page.click_css("footer.samples > .btn").await?;
        begins_at(page, ".dialog-body").await?;
        page.press("Space").await?;
        assert_eq!(page.count("dialog[open]").await?, 1);
        page.leave_dialog().await?;
        page.press("3").await?;
        page.wait_for(".run").await?;
        page.click("3 explorers…").await?;
        begins_at(page, "dialog .choices input").await
    })
    .await
}

#[tokio::test]
async fn a_dialog_gives_the_focus_back_however_it_is_left() -> Result<()> {
    lab(Setup::default(), async |page| {
        const SHARE: &str = "header [aria-label=Share]";
        for way in ["Escape", "Close", "the veil"] {
            come_to(page, SHARE).await?;
            page.press("Enter").await?;
            page.wait_for("dialog[open]").await?;
            match way {
                "Escape" => page.press("Escape").await?,
                "Close" => page.click("Close").await?,
                _ => page.click_at((5.0, 400.0)).await?,
            }
            page.wait_for_no("dialog").await?;
            at(page, SHARE).await?;
        }
        // A key opened it, and nothing had the focus: the page's keys go on.
        page.click_css(".stage .canvas").await?;
        page.press("g").await?;
        page.wait_for("dialog[open]").await?;
        page.leave_dialog().await?;
        page.press("ArrowRight").await?;
        page.wait_for_text("#count", "stop 1 /").await?;
        // What a dialog does closes it too.
        page.press("o").await?;
        page.choose("#explorer-name", "Path mapping, right hand").await?;
        page.leave_dialog().await?;
        page.wait_for("#inspector").await?;
        come_to(page, "#explorer").await?;
        page.press("Enter").await?;
        page.click("Open the sample that shows it").await?;
        page.wait_for_no("dialog").await?;
        at(page, "#explorer").await
    })
    .await
}

#[tokio::test]
async fn what_a_dialog_does_gives_the_focus_back_too() -> Result<()> {
    lab(Setup::default().at("draw"), async |page| {
        const RENAME: &str = "[aria-label='Rename, describe']";
        come_to(page, RENAME).await?;
        page.press("Enter").await?;
        at(page, "#about-title").await?;
        page.press("x").await?;
        // Keep.
        page.press("Enter").await?;
        page.wait_for_no("dialog").await?;
        at(page, RENAME).await?;
        // Begin, from the menu, which is gone by then.
        come_to(page, ".menu > button").await?;
        page.press("Enter").await?;
        at(page, ".menu-list button:first-child").await?;
        page.press("Enter").await?;
        at(page, "#new-width").await?;
        come_to(page, "dialog [type=submit]").await?;
        page.press("Space").await?;
        page.wait_for_no("dialog").await?;
        at(page, ".menu > button").await?;
        // A sample, and what its message offers.
        come_to(page, "footer.samples > .btn").await?;
        page.press("Enter").await?;
        come_to(page, ".all-samples li:nth-child(2) button").await?;
        page.press("Enter").await?;
        page.wait_for_no("dialog").await?;
        at(page, "footer.samples > .btn").await?;
        come_to(page, ".toast .btn").await?;
        page.press("Enter").await?;
        page.wait_for_no(".toast").await?;
        at(page, "footer.samples > .btn").await
    })
    .await
}

#[tokio::test]
async fn the_opener_that_is_gone_hands_the_focus_on() -> Result<()> {
    // No start: the bot can't be put down, and the card that says so offers a sample.
    lab(Setup::default().stored("maze", "line-maze: 1\n\n+---F\n"), async |page| {
        come_to(page, ".card .row .btn:nth-child(2)").await?;
        page.press("Enter").await?;
        come_to(page, ".all-samples li:first-child button").await?;
        page.press("Enter").await?;
        page.wait_for("#said").await?;
        page.wait_for_no("dialog").await?;
        page.wait_until("document.activeElement.closest('main')").await
    })
    .await
}

#[tokio::test]
async fn a_button_that_goes_hands_the_focus_to_its_neighbour() -> Result<()> {
    lab(Setup::default().at("connect"), async |page| {
        come_to(page, "#demo").await?;
        page.press("Enter").await?;
        state(page, "ready").await?;
        at(page, "#disconnect").await?;
        page.press("Enter").await?;
        state(page, "not connected").await?;
        page.wait_until(
            "document.activeElement.closest('.link-card') && document.activeElement.tagName === 'BUTTON'",
        )
        .await?;
        demo(page).await?;
        // For a while it can't be pressed: the focus stays in its card, and comes back.
        come_to(page, "#send").await?;
        page.press("Enter").await?;
        page.wait_for_text("#sent", "read back and compared").await?;
        at(page, "#send").await?;
        come_to(page, "#place").await?;
        page.press("Enter").await?;
        page.wait_until("!document.querySelector('#explore').disabled").await?;
        come_to(page, "#explore").await?;
        page.press("Enter").await?;
        state(page, "running").await?;
        at(page, "#stop").await
    })
    .await
}

/// Enter goes down, or up, or is held.
async fn enter(page: &Page, kind: &str, held: bool) -> Result<()> {
    let event = json!({
        "type": kind, "key": "Enter", "code": "Enter", "windowsVirtualKeyCode": 13, "text": "\r", "autoRepeat": held,
    });
    page.tools("Input.dispatchKeyEvent", event).await.map(drop)
}

#[tokio::test]
async fn the_last_undo_hands_the_focus_to_redo_and_a_held_key_does_not_go_on_there() -> Result<()> {
    lab(Setup::default().at("draw"), async |page| {
        const UNDO: &str = "[aria-label^=Undo]";
        const REDO: &str = "[aria-label^=Redo]";
        page.wait_for("#drawing").await?;
        page.click_css("#drawn-as button:nth-child(2)").await?;
        page.wait_for("#drawing svg.walls").await?;
        come_to(page, UNDO).await?;
        // Enter goes down, and down again, as held keys do.
        enter(page, "keyDown", false).await?;
        at(page, REDO).await?;
        enter(page, "keyDown", true).await?;
        enter(page, "keyDown", true).await?;
        enter(page, "keyUp", false).await?;
        page.wait_for_no("#drawing svg.walls").await?;
        at(page, REDO).await?;
        page.press("Enter").await?;
        page.wait_for("#drawing svg.walls").await?;
        at(page, UNDO).await
    })
    .await
}
