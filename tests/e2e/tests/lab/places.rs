//! Where one is on the page: the address, the document's title, what is read aloud, and where the keyboard begins.

use anyhow::Result;
use e2e::{Page, Setup, Site, lab, lab_at};
use serde_json::json;

use crate::figure_3_1::shows_stop;

/// All of them say so.
async fn is_at(page: &Page, name: &str, hash: &str) -> Result<()> {
    page.wait_until(&format!("document.title === {}", json!(format!("{name} · Line Maze Lab")))).await?;
    page.wait_until(&format!("location.hash === {}", json!(format!("#{hash}")))).await?;
    page.wait_until(&format!("document.querySelector('#done').innerText === {}", json!(name))).await?;
    page.wait_until("document.activeElement.id === 'main'").await
}

#[tokio::test]
async fn a_change_of_room_is_told_everywhere() -> Result<()> {
    lab(Setup::default(), async |page| {
        page.wait_until("document.title === 'Step · Line Maze Lab'").await?;
        assert_eq!(page.text("#done").await?, "");
        for (key, name, hash) in [
            ("1", "Draw", "draw"),
            ("p", "Projector", "projector"),
            ("p", "Step", "step"),
            ("3", "Compare", "compare"),
            ("4", "Connect", "connect"),
            ("p", "Projector", "projector"),
            ("Escape", "Step", "step"),
        ] {
            page.press(key).await?;
            is_at(page, name, hash).await?;
        }
        page.click("Compare").await?;
        is_at(page, "Compare", "compare").await?;
        page.click("League").await?;
        is_at(page, "League", "league").await?;
        page.press("2").await?;
        is_at(page, "Step", "step").await?;
        // It is the league that was left.
        page.press("3").await?;
        is_at(page, "League", "league").await
    })
    .await
}

#[tokio::test]
async fn back_and_forward_lead_through_rooms_and_projector() -> Result<()> {
    lab(Setup::default(), async |page| {
        for (key, name, hash) in [
            ("1", "Draw", "draw"),
            ("p", "Projector", "projector"),
            ("Escape", "Step", "step"),
            ("4", "Connect", "connect"),
        ] {
            page.press(key).await?;
            is_at(page, name, hash).await?;
        }
        for (name, hash) in [("Step", "step"), ("Projector", "projector"), ("Draw", "draw")] {
            page.back().await?;
            is_at(page, name, hash).await?;
        }
        page.run("history.forward()").await?;
        is_at(page, "Projector", "projector").await?;
        page.wait_for(".projector").await?;
        page.reload().await?;
        page.wait_for(".projector").await?;
        page.run("history.forward()").await?;
        is_at(page, "Step", "step").await
    })
    .await
}

#[tokio::test]
async fn a_link_stays_in_the_address_and_its_rooms_in_the_history() -> Result<()> {
    let link = include_str!("../../../fixtures/share/figure-3-1.txt").trim();
    let site = Site::start().await?;
    lab_at(&site, Setup::default().at(format!("m={link}")), async |page| {
        shows_stop(page, 13).await?;
        page.press("PageDown").await?;
        shows_stop(page, 14).await?;
        let linked = "location.hash.startsWith('#m=')";
        page.press("1").await?;
        page.wait_for("#drawing").await?;
        page.wait_until(linked).await?;
        page.back().await?;
        // What is open is not opened anew.
        shows_stop(page, 14).await?;
        page.run("history.forward()").await?;
        page.wait_for("#drawing").await?;
        page.reload().await?;
        page.wait_for("#drawing").await?;
        page.wait_until("document.title === 'Draw · Line Maze Lab'").await?;
        page.wait_until(linked).await?;
        // Changed, it is one's own.
        page.click_css("#drawn-as button:nth-child(2)").await?;
        page.wait_until("location.hash === '#draw'").await
    })
    .await
}

#[tokio::test]
async fn what_is_taken_back_in_step_is_said() -> Result<()> {
    lab(Setup::default(), async |page| {
        page.press("Control+z").await?;
        page.wait_for_text(".toast", "There is nothing to take back").await?;
        page.press("Control+y").await?;
        page.wait_for_text(".toast", "There is nothing to do again").await?;
        page.paste("line-maze: 1\ntitle: Pasted\n\n+---F\n|    \n^   .\n").await?;
        page.wait_for_text(".stage .bar", "Pasted").await?;
        page.press("Control+z").await?;
        page.wait_for_text(".toast", "Took back: replace the maze.").await?;
        page.wait_for_text(".stage .bar", "The run of the book").await?;
        page.click("Redo").await?;
        page.wait_for_text(".toast", "Did again: replace the maze.").await?;
        page.wait_for_text(".stage .bar", "Pasted").await?;
        page.press("Control+z").await?;
        page.wait_for_text(".stage .bar", "The run of the book").await?;
        // In Draw it can be seen, and is said to those who can't.
        page.press("1").await?;
        page.wait_for("#drawing").await?;
        page.press("Control+Shift+z").await?;
        page.wait_for_text("#done", "Did again: replace the maze.").await?;
        page.wait_for_no(".toast").await
    })
    .await
}

#[tokio::test]
async fn where_no_event_is_left_it_is_said() -> Result<()> {
    lab(Setup::default(), async |page| {
        page.press("Shift+N").await?;
        page.wait_for_text(".toast", "There is no event before this one").await?;
        page.press("Escape").await?;
        page.wait_for_no(".toast").await?;
        page.press("End").await?;
        page.press("n").await?;
        page.wait_for_text(".toast", "There is no event after this one: it is the end").await?;
        page.press("Escape").await?;
        page.wait_for_no(".toast").await?;
        page.press("ArrowLeft").await?;
        page.choose(".event-kind", "dead end").await?;
        page.click("Next event").await?;
        page.wait_for_text(".toast", "There is no other dead end after this stop").await?;
        shows_stop(page, 24).await?;
        // As many as there are, each is still found.
        page.press("Home").await?;
        page.click("Next event").await?;
        shows_stop(page, 8).await?;
        page.press("3").await?;
        page.wait_for(".run").await?;
        page.press("Escape").await?;
        page.wait_for_no(".toast").await?;
        // A corridor: nobody parts.
        page.paste("line-maze: 1\n\n^---+---F\n").await?;
        page.wait_for_text(".toast", "Opened").await?;
        page.press("n").await?;
        page.wait_for_text(".toast", "no parting").await
    })
    .await
}
