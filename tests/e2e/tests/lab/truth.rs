//! What is shown is so: the bot faces as it is told, an empty table says why, each explorer has its own glossary, the
//! lab's reading is marked, and settings off their defaults are named.

use anyhow::Result;
use e2e::{Page, Setup, lab};

const NOWHERE: &str = include_str!("../../../../mazes/no-finish-reachable.maze");

/// Degrees that the bot is turned.
async fn degrees(page: &Page, bot: &str) -> Result<i64> {
    let read = format!(
        "Number(/rotate\\(([-\\d.]+)/.exec(document.querySelector('{bot}').getAttribute('transform'))[1])"
    );
    Ok(page.eval(&read).await?.as_f64().unwrap_or(f64::NAN).round() as i64)
}

async fn choose(page: &Page, title: &str) -> Result<()> {
    page.press("o").await?;
    page.choose("#explorer-name", title).await?;
    page.leave_dialog().await?;
    page.wait_for_text("#explorer", title).await?;
    page.wait_for("#inspector").await
}

#[tokio::test]
async fn the_bot_faces_where_the_sentence_turns_it() -> Result<()> {
    lab(Setup::default(), async |page| {
        // The spec's column “leaves” of figure 3.1, times 90°.
        for (stop, leaves) in (1..).zip([0, 0, 90, 90, 180, 180, 90, 270, 0, 270, 270, 270, 90]) {
            page.press("ArrowRight").await?;
            page.wait_for(&format!("svg.maze[data-stop='{stop}']")).await?;
            assert_eq!(degrees(page, "svg.maze .bot").await?, leaves, "stop {stop}");
        }
        assert!(page.attribute("svg.maze[role=img]", "aria-label").await?.contains("facing east"));
        // The ways that the sentence lists, also for the robot's eye.
        assert!(page.attribute(".maze .open-way", "d").await?.matches('M').count() == 8);
        page.press("v").await?;
        assert!(page.attribute(".maze .open-way", "d").await?.matches('M').count() == 8);
        page.screenshot("listed-ways").await?;
        page.press("v").await?;
        page.press("ArrowRight").await?;
        page.wait_for("svg.maze[data-stop='14']").await?;
        assert_eq!(page.attribute(".maze .open-way", "d").await?, "");
        // Line by line it faces as it came until the line that turns it: at stop 15 from north to west.
        page.press("ArrowDown").await?;
        page.wait_for("svg.maze[data-stop='15']").await?;
        assert_eq!(degrees(page, "svg.maze .bot").await?, 0);
        page.press_times("ArrowDown", 4).await?;
        assert_eq!(degrees(page, "svg.maze .bot").await?, 270);
        // The same on the projector, and for another explorer.
        page.press("Home").await?;
        page.press_times("ArrowRight", 5).await?;
        page.press("p").await?;
        page.wait_for("main.projector").await?;
        assert_eq!(degrees(page, "main.projector .bot").await?, 180);
        page.press("p").await?;
        choose(page, "Right hand on the wall").await?;
        page.press("ArrowRight").await?;
        page.wait_for("svg.maze[data-stop='1']").await?;
        assert_eq!(degrees(page, "svg.maze .bot").await?, 90);
        Ok(())
    })
    .await
}

#[tokio::test]
async fn an_empty_table_says_why_it_is_empty() -> Result<()> {
    lab(Setup::default().stored("maze", NOWHERE), async |page| {
        page.wait_for_text(".nodes-card", "No node yet").await?;
        page.press("End").await?;
        page.wait_for_text(".nodes-card", "No node left").await?;
        assert!(page.text(".nodes-card").await?.contains("forgotten every node"));
        assert_eq!(page.count(".nodes-card .blank .btn").await?, 0, "no node follows");
        page.screenshot("no-node-left").await
    })
    .await
}

#[tokio::test]
async fn m_d_and_arrival_are_variables_while_their_functions_run() -> Result<()> {
    lab(Setup::default(), async |page| {
        page.press_times("ArrowRight", 9).await?;
        page.wait_for("svg.maze[data-stop='9']").await?;
        assert_eq!(page.count("[data-var=m]").await?, 0);
        page.press_times("ArrowDown", 7).await?;
        // Line 9 of stop 10 has found node 4.
        page.wait_for_text("[data-var=m]", "4").await?;
        assert!(page.text("[data-var=arrival]").await?.contains("2 S"));
        assert_eq!(page.count("[data-var=d]").await?, 0);
        page.press_times("ArrowDown", 5).await?;
        page.wait_for_text("[data-var=d]", "3 W").await?;
        page.click_css("[data-var=d]").await?;
        page.wait_for("dialog #name-d.lit").await
    })
    .await
}

#[tokio::test]
async fn every_explorer_has_its_own_glossary_and_marks() -> Result<()> {
    lab(Setup::default(), async |page| {
        page.press("g").await?;
        page.wait_for("dialog #name-RETURN-UNKNOWN").await?;
        assert!(page.text("dialog").await?.contains("given up"), "the dotted trail");
        page.leave_dialog().await?;
        assert!(page.text(".legend").await?.contains("given up"));
        assert_eq!(page.count(".code .ours").await?, 5);
        choose(page, "Path mapping, right hand").await?;
        assert_eq!(page.count(".code .ours").await?, 3);
        page.press("g").await?;
        page.wait_for("dialog #name-CSIP").await?;
        assert_eq!(page.count("dialog #name-ptr").await?, 0);
        page.leave_dialog().await?;
        // Names in the memory and in the listing lead there.
        page.click_css("#inspector [data-name=CSIP]").await?;
        page.wait_for("dialog #name-CSIP.lit").await?;
        page.leave_dialog().await?;
        page.click_css(".code .name").await?;
        page.wait_for("dialog .lit").await?;
        page.leave_dialog().await?;
        choose(page, "Cornell 3, with path planning").await?;
        page.click("lab’s reading").await?;
        page.wait_for_text("dialog", "The third is described elsewhere").await?;
        page.screenshot("labs-reading").await
    })
    .await
}

#[tokio::test]
async fn what_is_off_its_default_is_named_in_the_header() -> Result<()> {
    lab(Setup::default(), async |page| {
        assert!(!page.text("#explorer").await?.contains("epsilon"));
        page.press("o").await?;
        page.fill("#epsilon", "1000").await?;
        page.press("Tab").await?;
        page.leave_dialog().await?;
        page.wait_for_text("#explorer", "epsilon 1000").await?;
        page.press("o").await?;
        page.fill("#node-max", "61").await?;
        page.press("Tab").await?;
        page.leave_dialog().await?;
        page.wait_for_text("#explorer", "epsilon 1000 +1").await?;
        let name = page.attribute("#explorer", "aria-label").await?;
        assert!(name.ends_with("· epsilon 1000 · NODE_MAX 61"), "{name}");
        // The left hand knows neither.
        choose(page, "Left hand on the wall").await?;
        assert!(!page.text("#explorer").await?.contains("epsilon"));
        page.screenshot("header-off").await
    })
    .await
}
