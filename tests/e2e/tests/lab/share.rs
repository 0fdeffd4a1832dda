//! Links that hold maze, settings and stop.

use anyhow::{Context, Result};
use e2e::{Page, Setup, Site, lab, lab_at};
use line_maze_lab::maze::text;
use serde_json::json;

use crate::figure_3_1::shows_stop;

/// A maze of one's own: a line of two cells.
const OWN: &str = "line-maze: 1\ntitle: My own\n\n+---+---F\n|        \n^   .   .\n";

/// The payload of the link that the share dialog offers.
async fn link(page: &Page) -> Result<String> {
    page.click("Share").await?;
    page.wait_for("dialog #link").await?;
    let link = page.value("#link").await?;
    assert_eq!(page.count("dialog .qr svg[role=img] path").await?, 1);
    page.screenshot("share").await?;
    page.leave_dialog().await?;
    let hash = link.strip_prefix(page.address()).context("the link leads elsewhere")?;
    Ok(hash.strip_prefix('#').context("a link without #")?.to_owned())
}

async fn kept(page: &Page) -> Result<String> {
    Ok(page
        .eval("localStorage.getItem('line-maze-lab/maze') ?? ''")
        .await?
        .as_str()
        .unwrap_or_default()
        .to_owned())
}

#[tokio::test]
async fn a_link_shows_a_stranger_the_same() -> Result<()> {
    let site = Site::start().await?;
    lab_at(&site, Setup::default(), async |page| {
        page.press_times("PageDown", 13).await?;
        let plain = link(page).await?;
        page.press("o").await?;
        page.choose("#order", "right, straight, left").await?;
        page.fill("#epsilon", "150").await?;
        page.fill("#node-max", "40").await?;
        page.leave_dialog().await?;
        page.press_times("PageDown", 5).await?;
        let said = page.text("#said").await?;
        let set = link(page).await?;

        lab_at(&site, Setup::default().at(plain), async |other| {
            shows_stop(other, 13).await?;
            assert!(other.text(".stage .bar").await?.contains("The run of the book"));
            other.press("ArrowLeft").await?;
            shows_stop(other, 12).await
        })
        .await?;
        lab_at(&site, Setup::default().at(set), async |other| {
            assert_eq!(other.text("#said").await?, said);
            other.wait_for_text("#count", "stop 5 / 21").await?;
            other.press("o").await?;
            assert_eq!(other.value("#order").await?, "RSL");
            assert_eq!(other.value("#epsilon").await?, "150");
            assert_eq!(other.value("#node-max").await?, "40");
            Ok(())
        })
        .await
    })
    .await
}

#[tokio::test]
async fn a_link_from_round_2_shows_round_2() -> Result<()> {
    let site = Site::start().await?;
    lab_at(&site, Setup::default(), async |page| {
        for explorer in ["The book’s explorer", "Full mapping"] {
            page.press("o").await?;
            page.choose("#explorer-name", explorer).await?;
            page.leave_dialog().await?;
            if explorer != "The book’s explorer" {
                // Its part of the page comes when it is asked for.
                page.wait_for_text("#now-title", explorer).await?;
            }
            page.press("End").await?;
            page.click("Drive the solved run").await?;
            page.press("Home").await?;
            page.press_times("ArrowRight", 2).await?;
            let said = page.text("#said").await?;
            assert!(page.text("#solved-title").await?.to_lowercase().contains("round 2"));
            let solved = link(page).await?;
            lab_at(&site, Setup::default().at(solved), async |other| {
                other.wait_for("#solved-title").await?;
                other.wait_for_text("#count", "stop 2 /").await?;
                assert_eq!(other.text("#said").await?, said);
                other.click("Back to the exploration").await?;
                other.wait_for_no("#solved-title").await
            })
            .await?;
        }
        Ok(())
    })
    .await
}

#[tokio::test]
async fn a_borrowed_maze_does_not_replace_ones_own() -> Result<()> {
    let site = Site::start().await?;
    lab_at(&site, Setup::default(), async |page| {
        let link = link(page).await?;
        lab_at(&site, Setup::default().stored("maze", OWN).at(link), async |other| {
            assert!(other.text(".stage .bar").await?.contains("The run of the book"));
            assert_eq!(kept(other).await?, OWN);
            other.reload().await?;
            assert!(other.text(".stage .bar").await?.contains("The run of the book"));
            assert_eq!(kept(other).await?, OWN);
            // Undo goes back to one's own.
            other.press("Control+z").await?;
            other.wait_for_text(".stage .bar", "My own").await?;
            // Edited, it is one's own.
            other.press("Control+y").await?;
            other.wait_for_text(".stage .bar", "The run of the book").await?;
            other
                .wait_until("localStorage.getItem('line-maze-lab/maze').includes('The run of the book')")
                .await?;
            assert_eq!(other.eval("location.hash").await?, "#step");
            Ok(())
        })
        .await
    })
    .await
}

#[tokio::test]
async fn a_link_can_be_opened_while_the_page_is_open() -> Result<()> {
    lab(Setup::default(), async |page| {
        page.press_times("PageDown", 4).await?;
        let link = link(page).await?;
        page.press("Home").await?;
        page.eval(&format!("location.hash = {}", json!(link))).await?;
        page.wait_for("svg.maze[data-stop='4']").await?;
        page.press("Home").await?;
        page.paste(&format!("{}#{link}", page.address())).await?;
        page.wait_for("svg.maze[data-stop='4']").await?;
        shows_stop(page, 4).await
    })
    .await
}

#[tokio::test]
async fn a_broken_link_leaves_ones_own_maze_open() -> Result<()> {
    let site = Site::start().await?;
    lab_at(&site, Setup::default(), async |page| {
        let link = link(page).await?;
        let payload = link.strip_prefix("m=").context("no payload")?;
        let other = |letter: char| if letter == 'A' { 'B' } else { 'A' };
        let (start, end) = payload.split_at(payload.len() / 2);
        let altered =
            end.chars().next().map(other).into_iter().chain(end.chars().skip(1)).collect::<String>();
        let cut = format!("breaks off after {} of {} characters", start.len(), payload.len());
        let broken = [
            (start.to_owned(), &*cut),
            (format!("{start}{altered}"), "is damaged"),
            (format!("{payload}AAAA"), "is damaged"),
            ("%3Cscript%3E".to_owned(), "not a link of Line Maze Lab"),
            (String::new(), "breaks off after 0 characters"),
            (format!("_{}", &payload[1..]), "only versions 1 to 3 can be opened"),
            ("A".repeat(9000), "at most 8,000 characters"),
        ];
        for (payload, why) in broken {
            let setup = Setup::default().stored("maze", OWN).at(format!("m={payload}"));
            lab_at(&site, setup, async |other| {
                other.wait_for_text(".note.warn[role=alert]", "This link doesn’t hold a whole maze").await?;
                let note = other.text(".note.warn[role=alert] .small").await?;
                assert!(note.contains(why), "{note} instead of {why}");
                assert!(other.text(".stage .bar").await?.contains("My own"));
                assert_eq!(text::parse(&kept(other).await?)?, text::parse(OWN)?);
                other.screenshot("broken-link").await?;
                other.click("Keep my maze").await?;
                other.wait_for_no(".note.warn[role=alert]").await
            })
            .await?;
        }
        Ok(())
    })
    .await
}
