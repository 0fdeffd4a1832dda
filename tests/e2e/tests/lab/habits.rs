//! What people do without thinking of it: go back, press Esc, scroll, give a maze a long name.

use anyhow::Result;
use e2e::{Setup, lab};

#[tokio::test]
async fn back_leads_to_the_room_before() -> Result<()> {
    lab(Setup::default(), async |page| {
        for (key, room) in [("1", "Draw"), ("3", "Compare"), ("4", "Connect")] {
            page.press(key).await?;
            page.wait_for_text("[aria-current=page]", room).await?;
        }
        for room in ["Compare", "Draw", "Step"] {
            page.back().await?;
            page.wait_for_text("[aria-current=page]", room).await?;
        }
        Ok(())
    })
    .await
}

#[tokio::test]
async fn what_was_typed_counts_when_escape_leaves_the_settings() -> Result<()> {
    lab(Setup::default(), async |page| {
        page.press("o").await?;
        page.fill("#node-max", "2").await?;
        page.leave_dialog().await?;
        page.press("End").await?;
        page.wait_for_text("#said", "table").await?;
        page.press("o").await?;
        assert_eq!(page.value("#node-max").await?, "2");
        Ok(())
    })
    .await
}

#[tokio::test]
async fn the_line_that_ran_is_in_sight_on_a_phone() -> Result<()> {
    lab(Setup::default().touch().size(390, 844), async |page| {
        page.press_times("PageDown", 13).await?;
        page.wait_until(
            "(() => {
                const box = (css) => document.querySelector(css).getBoundingClientRect();
                const [list, ran] = [box('.code'), box('.code .ran')];
                return list.height < 400 && ran.top >= list.top && ran.bottom <= list.bottom;
            })()",
        )
        .await
    })
    .await
}

#[tokio::test]
async fn a_long_title_leaves_the_maze_its_place() -> Result<()> {
    for setup in [Setup::default(), Setup::default().touch().size(390, 844)] {
        lab(setup, async |page| {
            let title = "A".repeat(480);
            page.paste(&format!("line-maze: 1\ntitle: {title}\n\n+---+---F\n|        \n^   .   .\n")).await?;
            page.wait_for_text(".stage .bar b", "AAAA").await?;
            let inside = "(() => {
                const box = (css) => document.querySelector(css).getBoundingClientRect();
                const [stage, eye, zoom] = [box('.stage'), box('.bar .btn'), box('.zoom')];
                return eye.right <= stage.right && zoom.right <= stage.right && box('.canvas').height > 200;
            })()";
            page.wait_until(inside).await
        })
        .await?;
    }
    Ok(())
}
