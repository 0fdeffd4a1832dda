//! What a screen reader hears of a run: every step that somebody makes, and while something moves by itself at most one
//! sentence in three seconds, the newest.

use anyhow::{Context, Result};
use e2e::{Page, Setup, lab};

use crate::connect::{demo, explore};

/// Keeps what is said, with its time in seconds, in `heard`.
const LISTEN: &str = "window.heard = [];
    new MutationObserver(() => {
        const text = document.getElementById('heard').innerText.trim();
        if (text && text !== heard.at(-1)?.[1]) heard.push([performance.now() / 1000, text]);
    }).observe(document.getElementById('heard'), { childList: true, characterData: true, subtree: true });";

/// When which sentences were heard.
async fn heard(page: &Page) -> Result<Vec<(f64, String)>> {
    Ok(serde_json::from_value(page.eval("heard").await?)?)
}

fn at_most_one_in_three_seconds(heard: &[(f64, String)]) {
    for two in heard.windows(2) {
        assert!(two[1].0 - two[0].0 > 2.95, "{heard:?}");
    }
}

#[tokio::test]
async fn every_step_that_somebody_makes() -> Result<()> {
    lab(Setup::default(), async |page| {
        assert_eq!(page.attribute("#heard", "role").await?, "status");
        page.run(LISTEN).await?;
        for stop in 1..=5 {
            page.press("ArrowRight").await?;
            page.wait_until(&format!("heard.length === {stop}")).await?;
            let (_, text) = heard(page).await?.pop().context("nothing")?;
            assert_eq!(
                text.split_whitespace().collect::<Vec<_>>(),
                page.text("#said").await?.split_whitespace().collect::<Vec<_>>()
            );
        }
        // Nothing else of the sentence is read aloud, and nothing of a step twice.
        assert_eq!(page.count("#said[role], #said[aria-live], .told[aria-live]").await?, 0);
        let picture = page.attribute("svg.maze[data-stop]", "aria-label").await?;
        assert_eq!(picture, "Maze at stop 5 of 25: the bot is at 6,5; 0 cells are crossed out");
        assert_eq!(page.attribute("[role=slider]", "aria-valuetext").await?, "stop 5: corner");
        page.press("p").await?;
        page.wait_for(".projector").await?;
        page.press("PageDown").await?;
        page.wait_until("heard.length === 6").await
    })
    .await
}

#[tokio::test]
async fn while_it_plays_the_newest_in_three_seconds() -> Result<()> {
    lab(Setup::default(), async |page| {
        page.run(LISTEN).await?;
        page.choose("[aria-label=Speed]", "2×").await?;
        page.press("Space").await?;
        page.wait_until("heard.length >= 3").await?;
        let playing = heard(page).await?;
        at_most_one_in_three_seconds(&playing);
        // More happened than was told.
        page.wait_until("document.querySelector('svg.maze[data-stop]').dataset.stop > 5").await?;
        page.press("Space").await?;
        // What stands there when it stops is told at once.
        page.wait_until("heard.at(-1)[1].replace(/\\s+/g, ' ') === document.getElementById('said').innerText.trim().replace(/\\s+/g, ' ')").await
    })
    .await
}

#[tokio::test]
async fn a_robots_run_in_connect_and_in_step() -> Result<()> {
    lab(Setup::default().at("connect"), async |page| {
        demo(page).await?;
        page.run(LISTEN).await?;
        explore(page).await?;
        page.wait_until("heard.length >= 2").await?;
        let live = heard(page).await?;
        at_most_one_in_three_seconds(&live);
        assert!(live.iter().all(|(_, text)| text.starts_with("stop ")), "{live:?}");
        page.press("2").await?;
        page.wait_for("#said").await?;
        page.run("heard.length = 0").await?;
        page.wait_until("heard.length >= 2").await?;
        let live = heard(page).await?;
        at_most_one_in_three_seconds(&live);
        assert!(live.iter().all(|(_, text)| text.contains("bot")), "{live:?}");
        page.click("Stop the robot").await
    })
    .await
}
