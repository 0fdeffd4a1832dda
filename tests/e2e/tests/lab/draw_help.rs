//! What helps with drawing: dialogs, generator, samples, checks.

use anyhow::Result;
use e2e::{Button, Setup};
use line_maze_lab::maze::Kind;
use line_maze_lab::maze::generate::{Recipe, generate};
use serde_json::Value;

use crate::drawing::{
    FINISH, at, between, draw_room, figure_3_1, from_menu, has_cells, keeps, kept_when, tab_to,
};

#[tokio::test]
async fn a_seed_makes_the_same_maze_here_and_there() -> Result<()> {
    draw_room(Setup::default(), async |page| {
        page.click("Generate").await?;
        page.wait_for("#gen-width").await?;
        for (field, value) in [("#gen-width", "9"), ("#gen-height", "7"), ("#gen-seed", "4711")] {
            page.fill(field, value).await?;
        }
        page.screenshot("generator").await?;
        page.click("Use this").await?;
        page.wait_for_no(".generator").await?;
        let native = generate(&Recipe { width: 9, height: 7, seed: 4711, ..Recipe::default() })?;
        keeps(page, &native).await?;
        page.press("2").await?;
        page.press("End").await?;
        page.wait_for_text("#said", "FINISH").await?;
        page.click("Drive the solved run").await?;
        page.choose("[aria-label=Speed]", "512×").await?;
        page.wait_for_text("#said", "FINISH").await
    })
    .await
}

#[tokio::test]
async fn every_sample_opens_and_runs() -> Result<()> {
    draw_room(Setup::default(), async |page| {
        let samples = page.count(".shelf button").await?;
        assert!(samples >= 10);
        for sample in 1..=samples {
            let button = format!(".shelf li:nth-child({sample}) button");
            let title = page.attribute(&button, "title").await?;
            page.click_css(&button).await?;
            page.wait_for_text(".stage .bar b", &title).await?;
            page.press("2").await?;
            page.press("End").await?;
            page.wait_for("#said .case, .side .card").await?;
            page.press("1").await?;
            page.wait_for("#drawing").await?;
        }
        page.click(&format!("All {samples}")).await?;
        page.wait_for("dialog .all-samples").await?;
        page.screenshot("samples").await?;
        page.click_css("dialog .all-samples li:nth-child(1) button").await?;
        page.wait_for_no("dialog").await
    })
    .await
}

#[tokio::test]
async fn checks_point_to_the_place() -> Result<()> {
    draw_room(Setup::default(), async |page| {
        page.wait_for_text(".checks-card", "in order").await?;
        // Without its last cell the finish is beside the line.
        let last = between(page, (3.0, 4.5)).await?;
        page.drag(&[last], Button::Right).await?;
        page.wait_for_text(".checks-card", "Finish is not on a line").await?;
        page.screenshot("checks").await?;
        page.click("Show it").await?;
        page.wait_for("#drawing .shown").await?;
        let shown = page
            .eval("document.querySelector('#drawing .shown rect').getBoundingClientRect().toJSON()")
            .await?;
        let (x, y) = at(page, FINISH).await?;
        let inside = |low: &Value, at: f64, high: &Value| low.as_f64() < Some(at) && Some(at) < high.as_f64();
        assert!(
            inside(&shown["left"], x, &shown["right"]) && inside(&shown["top"], y, &shown["bottom"]),
            "{shown}"
        );
        page.click("Show it").await?;
        page.wait_for_no("#drawing .shown").await?;
        page.press("Control+z").await?;
        page.wait_for_text(".checks-card", "in order").await
    })
    .await
}

#[tokio::test]
async fn a_maze_of_walls_is_generated() -> Result<()> {
    draw_room(Setup::default(), async |page| {
        page.click("Generate").await?;
        page.wait_for("#gen-width").await?;
        for (field, value) in [("#gen-width", "8"), ("#gen-height", "8"), ("#gen-seed", "12")] {
            page.fill(field, value).await?;
        }
        page.click_css("#gen-kind button:nth-child(2)").await?;
        page.wait_for("#gen-kind button:nth-child(2)[aria-pressed=true]").await?;
        page.screenshot("generator-walls").await?;
        page.click("Use this").await?;
        page.wait_for("#drawing svg.walls").await?;
        let native =
            generate(&Recipe { width: 8, height: 8, seed: 12, kind: Kind::Wall, ..Recipe::default() })?;
        assert_eq!(kept_when(page, |maze| maze.kind == Kind::Wall).await?, native);
        Ok(())
    })
    .await
}

#[tokio::test]
async fn a_maze_is_resized_by_mouse_and_by_keyboard() -> Result<()> {
    draw_room(Setup::default(), async |page| {
        from_menu(page, "Resize…").await?;
        page.wait_for("dialog[open] #resize-width").await?;
        page.fill("#resize-width", "6").await?;
        page.wait_for_text("dialog form > p[role=status]", "8 × 6 points become 6 × 6").await?;
        page.wait_for_text("dialog form > p[role=status]", "cuts off").await?;
        page.screenshot("resize").await?;
        page.click("Resize").await?;
        page.wait_for_no("dialog").await?;
        page.wait_for_text(".bar .size", "6 × 6 points").await?;
        page.click_css(".toast .btn:not(.icon)").await?;
        keeps(page, &figure_3_1()?).await?;
        // By keys: a column more in the west.
        page.press("Tab").await?;
        tab_to(page, ".menu > button").await?;
        page.press("Enter").await?;
        page.wait_for("[role=menu]").await?;
        page.press("End").await?;
        page.press("Enter").await?;
        page.wait_for("dialog[open] #grow-west").await?;
        tab_to(page, "#grow-west").await?;
        page.press("Control+a").await?;
        page.press("2").await?;
        page.press("Enter").await?;
        page.wait_for_no("dialog").await?;
        page.wait_for_text(".bar .size", "10 × 6 points").await?;
        let maze = kept_when(page, |maze| maze.bounds().width() == 10).await?;
        assert_eq!((maze.bounds().sw().x, maze.cells()), (-2, 29));
        // A size that cannot be says what can.
        from_menu(page, "Resize…").await?;
        page.wait_for("dialog[open] #resize-width").await?;
        page.fill("#resize-width", "1").await?;
        page.wait_for_text("dialog", "2 to 1000").await?;
        page.leave_dialog().await
    })
    .await
}

#[tokio::test]
async fn a_maze_is_given_title_source_and_note() -> Result<()> {
    draw_room(Setup::default(), async |page| {
        page.click("Rename, describe").await?;
        page.wait_for("dialog[open] #about-title").await?;
        page.fill("#about-title", "My maze").await?;
        page.fill("#about-source", "A rainy day").await?;
        page.fill("#about-note", "It has a loop.").await?;
        page.screenshot("about").await?;
        page.click("Keep").await?;
        page.wait_for_no("dialog").await?;
        page.wait_for_text(".stage .bar b", "My maze").await?;
        let maze = kept_when(page, |maze| maze.about.title == "My maze").await?;
        assert_eq!((&*maze.about.source, &*maze.about.note), ("A rainy day", "It has a loop."));
        // By keys, and nothing is kept after Esc.
        page.press("Tab").await?;
        tab_to(page, ".bar .title button").await?;
        page.press("Enter").await?;
        page.wait_for("dialog[open] #about-title").await?;
        tab_to(page, "#about-title").await?;
        page.press("Control+a").await?;
        for key in ["O", "n", "e"] {
            page.press(key).await?;
        }
        page.leave_dialog().await?;
        page.wait_for_text(".stage .bar b", "My maze").await?;
        page.press("Enter").await?;
        page.wait_for("dialog[open] #about-title").await?;
        tab_to(page, "#about-title").await?;
        page.press("Control+a").await?;
        for key in ["T", "w", "o"] {
            page.press(key).await?;
        }
        page.press("Enter").await?;
        page.wait_for_no("dialog").await?;
        page.wait_for_text(".stage .bar b", "Two").await?;
        page.press_times("Control+z", 2).await?;
        page.wait_for_text(".stage .bar b", "The run of the book").await
    })
    .await
}

#[tokio::test]
async fn a_maze_is_pasted_by_hand() -> Result<()> {
    draw_room(Setup::default(), async |page| {
        from_menu(page, "Paste a maze…").await?;
        page.wait_for("dialog[open] #paste").await?;
        page.fill("#paste", "line-maze: 1\n\n+--").await?;
        page.click("Open").await?;
        page.wait_for_text("#paste-wrong", "Line 3").await?;
        page.wait_for("#paste[aria-invalid=true]").await?;
        page.screenshot("paste").await?;
        page.fill("#paste", "line-maze: 1\ntitle: Pasted\n\n>---F\n").await?;
        page.click("Open").await?;
        page.wait_for_no("dialog").await?;
        page.wait_for_text(".stage .bar b", "Pasted").await?;
        // By keys, and walls this time.
        page.press("Tab").await?;
        tab_to(page, ".menu > button").await?;
        page.press("Enter").await?;
        page.wait_for("[role=menu]").await?;
        page.press_times("ArrowDown", 2).await?;
        page.press("Enter").await?;
        page.wait_for("dialog[open] #paste").await?;
        tab_to(page, "#paste").await?;
        page.fill("#paste", "o---o---o\n| S   G |\no---o---o\n").await?;
        tab_to(page, "dialog button[type=submit]").await?;
        page.press("Enter").await?;
        page.wait_for_no("dialog").await?;
        page.wait_for("#drawing svg.walls").await?;
        has_cells(page, 1).await
    })
    .await
}

#[tokio::test]
async fn a_size_that_cannot_be_opens_nothing() -> Result<()> {
    draw_room(Setup::default(), async |page| {
        let before = figure_3_1()?;
        for side in ["1", "5000", "3.7", "-4", ""] {
            page.press("Alt+n").await?;
            page.wait_for("#new-width").await?;
            page.fill("#new-width", side).await?;
            page.click("Begin").await?;
            page.wait_for_text("#new-width-hint", "from 2 to 1000").await?;
            assert_eq!(page.attribute("#new-width", "aria-invalid").await?, "true");
            page.wait_until("document.activeElement?.id === 'new-width'").await?;
            keeps(page, &before).await?;
            page.leave_dialog().await?;
        }
        Ok(())
    })
    .await
}

#[tokio::test]
async fn the_undo_of_a_message_goes_with_the_next_change() -> Result<()> {
    draw_room(Setup::default(), async |page| {
        page.click_css(".shelf li:nth-child(6) button").await?;
        page.wait_for_text(".toast", "is open").await?;
        page.click("Walls").await?;
        page.wait_for_no(".toast").await?;
        page.press_times("Control+z", 2).await?;
        keeps(page, &figure_3_1()?).await
    })
    .await
}
