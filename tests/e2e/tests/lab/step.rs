//! The stepper: figure 3.1 by keyboard and mouse, forwards, backwards, by jumping, line by line, and played.

use anyhow::Result;
use e2e::{Page, Setup, lab};
use serde_json::json;

use crate::figure_3_1::{STOPS, shows_stop, steps_to_the_end};

/// The stops that are events: all but corners.
const EVENTS: [u32; 18] = [1, 2, 4, 6, 8, 10, 11, 12, 13, 14, 16, 18, 19, 20, 21, 22, 24, 25];

#[tokio::test]
async fn figure_3_1_is_stepped_forwards_and_backwards_by_key() -> Result<()> {
    lab(Setup::default(), async |page| {
        steps_to_the_end(page).await?;
        page.press("ArrowRight").await?;
        shows_stop(page, STOPS).await?;
        page.screenshot("step-finish").await?;
        for stop in (0..STOPS).rev() {
            page.press("ArrowLeft").await?;
            shows_stop(page, stop).await?;
        }
        page.press("ArrowLeft").await?;
        shows_stop(page, 0).await
    })
    .await
}

#[tokio::test]
async fn figure_3_1_is_stepped_by_mouse() -> Result<()> {
    lab(Setup::default(), async |page| {
        for stop in 1..=3 {
            page.click("Forward").await?;
            shows_stop(page, stop).await?;
        }
        page.click("To end").await?;
        shows_stop(page, STOPS).await?;
        page.click("Back").await?;
        shows_stop(page, 24).await?;
        page.click("To start").await?;
        shows_stop(page, 0).await?;
        page.click("Next node").await?;
        shows_stop(page, 1).await?;
        page.choose("[aria-label='Kind of event']", "dead end").await?;
        for stop in [8, 20, 20] {
            page.click("Next event").await?;
            shows_stop(page, stop).await?;
        }
        Ok(())
    })
    .await
}

#[tokio::test]
async fn any_stop_is_jumped_to() -> Result<()> {
    lab(Setup::default(), async |page| {
        for stop in [13, 25, 9, 1, 18, 0, 24] {
            page.click_at(on_time_line(page, stop).await?).await?;
            shows_stop(page, stop).await?;
        }
        page.point_at(on_time_line(page, 13).await?).await?;
        assert_eq!(page.text(".tip").await?, "stop 13: RETURN-UNKNOWN · node 1");
        let path =
            [on_time_line(page, 24).await?, on_time_line(page, 20).await?, on_time_line(page, 16).await?];
        page.drag(&path, e2e::Button::Left).await?;
        shows_stop(page, 16).await?;
        page.press("End").await?;
        shows_stop(page, STOPS).await?;
        page.press("Home").await?;
        shows_stop(page, 0).await?;
        for stop in EVENTS {
            page.press("n").await?;
            shows_stop(page, stop).await?;
        }
        for stop in EVENTS.into_iter().rev().skip(1) {
            page.press("Shift+N").await?;
            shows_stop(page, stop).await?;
        }
        page.press("PageDown").await?;
        shows_stop(page, 2).await?;
        page.press("PageUp").await?;
        shows_stop(page, 1).await
    })
    .await
}

/// The place of a stop on the time line.
async fn on_time_line(page: &Page, stop: u32) -> Result<e2e::Place> {
    let rect = page.eval("document.querySelector('.track').getBoundingClientRect().toJSON()").await?;
    let at = |name: &str| rect[name].as_f64().unwrap_or_default();
    let share = f64::from(stop) / f64::from(STOPS);
    Ok((at("left") + at("width") * share, at("top") + at("height") / 2.0))
}

#[tokio::test]
async fn stop_13_runs_line_by_line() -> Result<()> {
    const LINES: [&str; 12] = ["2", "3", "+", "4", "5", "6", "9", "10", "13", "16", "17", "18"];
    lab(Setup::default(), async |page| {
        page.press_times("PageDown", 12).await?;
        shows_stop(page, 12).await?;
        let marked = async |class: &str| page.texts(&format!(".code > .{class} > .ln")).await;
        let forth = (0..LINES.len()).map(|line| ("ArrowDown", line));
        let back = (0..LINES.len() - 1).rev().map(|line| ("ArrowUp", line));
        for (key, line) in forth.chain(back) {
            page.press(key).await?;
            assert_eq!(marked("ran").await?, [LINES[line]]);
            assert_eq!(marked("next").await?, [*LINES.get(line + 1).unwrap_or(&"2")], "after {line}");
            assert_eq!(page.text(".code > .ran > .tag").await?, "ran");
            if line + 1 == LINES.len() {
                shows_stop(page, 13).await?;
            }
        }
        // Before its last line has run, returning is as it was.
        assert_eq!(page.text("[data-var=returning] > span").await?, "false");
        page.press("ArrowUp").await?;
        shows_stop(page, 12).await?;
        page.click("Lines").await?;
        page.press("ArrowRight").await?;
        assert_eq!(marked("ran").await?, ["2"]);
        page.click("Stops").await?;
        page.press("ArrowRight").await?;
        shows_stop(page, 13).await
    })
    .await
}

#[tokio::test]
async fn space_plays_and_pauses() -> Result<()> {
    lab(Setup::default(), async |page| {
        page.press("Space").await?;
        page.wait_for("[aria-label='Pause (Space)']").await?;
        page.wait_until("document.querySelector('svg.maze[data-stop]').dataset.stop >= 2").await?;
        page.press("Space").await?;
        page.wait_for("[aria-label='Play (Space)']").await?;
        page.choose("[aria-label=Speed]", "512×").await?;
        page.click_css("#said").await?;
        page.press("Space").await?;
        page.wait_for("svg.maze[data-stop='25']").await?;
        page.wait_for("[aria-label='Play (Space)']").await?;
        shows_stop(page, STOPS).await
    })
    .await
}

#[tokio::test]
async fn the_bot_is_seen_to_drive() -> Result<()> {
    lab(Setup::default().with_motion(), async |page| {
        page.eval(
            "(window.poses = new Set(), new MutationObserver(() => poses.add(document.querySelector('.bot')\
             .getAttribute('transform'))).observe(document.querySelector('.bot'), { attributes: true }))",
        )
        .await?;
        page.press("ArrowRight").await?;
        page.wait_for("svg.maze[data-stop='1']").await?;
        page.wait_until("poses.size > 3").await?;
        shows_stop(page, 1).await?;
        // A hasty hand loses no step.
        page.press_times("ArrowRight", 4).await?;
        page.wait_for("svg.maze[data-stop='5']").await?;
        shows_stop(page, 5).await?;
        page.press("ArrowLeft").await?;
        page.wait_for("svg.maze[data-stop='4']").await?;
        page.press("Space").await?;
        page.wait_for("svg.maze[data-stop='6']").await?;
        page.press("Home").await?;
        page.wait_for("svg.maze[data-stop='0']").await
    })
    .await
}

#[tokio::test]
async fn the_result_is_told_and_driven() -> Result<()> {
    lab(Setup::default(), async |page| {
        page.press("End").await?;
        assert_eq!(page.texts("#result .letters b").await?, ["S", "S", "R"]);
        let facts = page.text("#result .facts").await?.split_whitespace().collect::<Vec<_>>().join(" ");
        assert_eq!(
            facts,
            "Route 9cells Shortest 9cells Ratio 1.00as good as any Exploration 49cells Stops 25"
        );
        page.click("C array").await?;
        assert_eq!(page.text(".snip").await?, "const char turns[] = \"SSR\"; // The run of the book");
        page.tools(
            "Browser.grantPermissions",
            json!({ "permissions": ["clipboardReadWrite", "clipboardSanitizedWrite"] }),
        )
        .await?;
        page.click("Copy the array").await?;
        page.wait_for(".toast").await?;
        assert!(page.text(".toast").await?.contains("Copied."), "{}", page.text(".toast").await?);
        assert!(page.promised("navigator.clipboard.readText()").await?.to_string().contains("SSR"));
        page.click("Drive the solved run").await?;
        page.wait_for_text("#said", "TURN LIST").await?;
        page.choose("[aria-label=Speed]", "32×").await?;
        page.wait_for_text("#said", "FINISH").await?;
        assert_eq!(page.text("#said p").await?, "There: 9 cells, and no U-turn.");
        let bot = page.attribute(".bot", "transform").await?;
        assert!(bot.starts_with("translate(240 -320)"), "{bot}");
        page.screenshot("solved-run").await?;
        page.click("Back to the exploration").await?;
        shows_stop(page, STOPS).await
    })
    .await
}

#[tokio::test]
async fn the_robot_sees_only_where_it_was() -> Result<()> {
    const EXTENT: &str = "(({ x, y, width, height }) => [x, y, width, height].map(Math.round))\
                          (document.querySelector('svg.maze[data-stop] > .tape').getBBox())";
    lab(Setup::default(), async |page| {
        assert_eq!(page.eval(EXTENT).await?, json!([0, -400, 560, 400]));
        page.press("ArrowRight").await?;
        page.press("v").await?;
        // One cell driven, and at its end a stub ahead and one to the right.
        assert_eq!(page.eval(EXTENT).await?, json!([0, -112, 32, 112]));
        assert_eq!(page.count(".maze[data-stop] .finish").await?, 0);
        page.press_times("PageDown", 12).await?;
        page.screenshot("robots-eye").await?;
        page.press("End").await?;
        assert_eq!(page.count(".maze[data-stop] .finish").await?, 1);
        page.press("v").await?;
        shows_stop(page, STOPS).await
    })
    .await
}

#[tokio::test]
async fn settings_change_the_run() -> Result<()> {
    lab(Setup::default(), async |page| {
        page.press("o").await?;
        page.choose("#order", "right, straight, left").await?;
        page.wait_for_text("#count", "/ 21").await?;
        page.leave_dialog().await?;
        assert!(page.text(".top").await?.contains("R → S → L"));
        page.press("End").await?;
        assert_eq!(page.texts("#result .letters b").await?, ["R", "S", "S", "L", "L"]);
        assert!(page.text("#result .facts").await?.contains("1.67"));

        page.click("Settings of the run: Book · R → S → L").await?;
        page.choose("#order", "random at every choice").await?;
        page.fill("#seed", "7").await?;
        page.wait_for_text(".top", "random 7").await?;
        page.fill("#seed", "seven").await?;
        page.wait_for_text("#seed-hint", "A whole number").await?;
        assert!(page.text(".top").await?.contains("random 7"));
        page.click("As in the book").await?;
        page.wait_for_text(".top", "S → R → L").await?;
        page.leave_dialog().await?;
        steps_to_the_end(page).await
    })
    .await
}

#[tokio::test]
async fn a_bot_that_fails_says_how() -> Result<()> {
    lab(Setup::default(), async |page| {
        page.press("o").await?;
        page.fill("#epsilon", "1000").await?;
        page.wait_for_text("#count", "/ 4").await?;
        page.leave_dialog().await?;
        page.press("End").await?;
        assert_eq!(page.text("#said .case").await?, "LOST");
        let said = page.text("#said p").await?;
        assert!(said.contains("node 1") && said.contains("south (2)") && said.contains("no line"), "{said}");
        assert!(!page.sees("#result").await?);
        page.screenshot("lost").await?;

        page.press("o").await?;
        page.fill("#epsilon", "").await?;
        page.fill("#node-max", "3").await?;
        page.wait_for_text("#count", "/ 6").await?;
        for wrong in ["0", "1048576", "3.5", "many"] {
            page.fill("#node-max", wrong).await?;
            page.wait_for_text("#node-max-hint", "A whole number from 1 to 1,048,575").await?;
            assert_eq!(page.attribute("#node-max", "aria-invalid").await?, "true");
            assert!(page.text("#count").await?.contains("/ 6"), "{wrong} changed the run");
        }
        page.leave_dialog().await?;
        page.press("End").await?;
        assert_eq!(page.text("#said .case").await?, "TABLE FULL");
        let said = page.text("#said p").await?;
        assert!(said.contains("all 3 places") && said.contains("NODE_MAX"), "{said}");
        Ok(())
    })
    .await
}

#[tokio::test]
async fn names_lead_to_the_glossary() -> Result<()> {
    lab(Setup::default(), async |page| {
        let lit = async |name: &str| -> Result<()> {
            page.wait_for(&format!("#name-{name}.lit")).await?;
            let inside = format!(
                "(({{ top, bottom }}) => top >= 0 && bottom <= innerHeight)(document.getElementById('name-{name}').getBoundingClientRect())"
            );
            page.wait_until(&inside).await?;
            page.leave_dialog().await
        };
        page.press("PageDown").await?;
        page.click_css("[data-var=returning]").await?;
        lit("returning").await?;
        page.click("back_path").await?;
        lit("back_path").await?;
        page.eval("document.querySelector('[data-var=cur_y]').focus()").await?;
        page.press("Enter").await?;
        lit("cur_y").await?;
        page.press("g").await?;
        page.wait_for("dialog #name-vpaths").await?;
        assert_eq!(page.count("dialog .lit").await?, 0);
        page.screenshot("glossary").await
    })
    .await
}

#[tokio::test]
async fn slips_of_the_book_are_noted_where_they_are() -> Result<()> {
    lab(Setup::default(), async |page| {
        assert_eq!(page.count(".errata-notes").await?, 0);
        page.press("PageDown").await?;
        assert!(page.text(".errata-notes > summary").await?.contains("The wrong node"));
        page.click_css(".errata-notes > summary").await?;
        let note = page.text(".errata-notes .note").await?;
        assert!(
            note.contains("§3.1, node 1") && note.contains("printed") && note.contains("meant"),
            "{note}"
        );
        page.press("PageDown").await?;
        page.press("PageDown").await?;
        assert_eq!(page.count(".errata-notes").await?, 0);
        page.press("PageUp").await?;
        page.press("PageUp").await?;
        page.click("All errata").await?;
        page.wait_for("dialog[open] .note").await?;
        assert!(page.count("dialog .note").await? > 10);
        Ok(())
    })
    .await
}

#[tokio::test]
async fn rows_and_nodes_light_each_other() -> Result<()> {
    lab(Setup::default(), async |page| {
        page.press_times("PageDown", 12).await?;
        let row = page.middle(".nodes tr[data-node='3']").await?;
        page.point_at(row).await?;
        page.wait_for(".maze .ring.lit[data-node='3']").await?;
        let node = page.middle(".maze .node[data-node='2']").await?;
        page.point_at(node).await?;
        page.wait_for(".nodes tr.lit[data-node='2']").await?;
        assert_eq!(page.count(".lit").await?, 2);
        Ok(())
    })
    .await
}
