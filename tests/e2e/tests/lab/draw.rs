//! The Draw room: by keyboard, mouse and touch, from an empty sheet to a solved maze.

use anyhow::{Context, Result};
use e2e::{Button, Setup};
use line_maze_lab::maze::text;

use crate::drawing::{
    FINISH, START, STROKES, along, arrow, at, between, cells, draw_room, figure_3_1, has_cells, keeps, kept,
    new_by_keys, places,
};
use crate::figure_3_1::{shows_stop, steps_to_the_end};

#[tokio::test]
async fn figure_3_1_is_drawn_and_solved_by_keyboard() -> Result<()> {
    draw_room(Setup::default(), async |page| {
        new_by_keys(page, "8", "6").await?;
        let mut here = START;
        let go = async |held: &str, from: (i32, i32), to: (i32, i32)| -> Result<()> {
            for leg in along(&[from, (to.0, from.1), to]).windows(2) {
                if let Some(arrow) = arrow(leg[0], leg[1]) {
                    page.press(&format!("{held}{arrow}")).await?;
                }
            }
            Ok(())
        };
        for stroke in STROKES {
            go("", here, stroke[0]).await?;
            for leg in stroke.windows(2) {
                go("Shift+", leg[0], leg[1]).await?;
            }
            here = stroke[stroke.len() - 1];
        }
        assert_eq!(here, FINISH);
        page.press("f").await?;
        go("", here, START).await?;
        page.press("s").await?;
        keeps(page, &figure_3_1()?).await?;
        assert!(page.text("#draw-status").await?.contains("start, facing north"));
        page.press("2").await?;
        page.wait_for("#said").await?;
        steps_to_the_end(page).await?;
        assert_eq!(page.texts("#result .letters b").await?, ["S", "S", "R"]);
        Ok(())
    })
    .await
}

#[tokio::test]
async fn figure_3_1_is_drawn_and_solved_by_touch() -> Result<()> {
    draw_room(Setup::default().touch().size(390, 844), async |page| {
        page.tap("File ▾").await?;
        page.wait_for("[role=menu]").await?;
        page.tap("New…").await?;
        page.wait_for("dialog[open] #new-width").await?;
        page.fill("#new-width", "8").await?;
        page.fill("#new-height", "6").await?;
        page.tap("Begin").await?;
        page.wait_for_no("dialog").await?;
        for stroke in STROKES {
            let finger = places(page, &along(stroke)).await?;
            page.touch_drag(&[&finger]).await?;
        }
        for (tool, point) in [("Finish", FINISH), ("Start", START)] {
            page.tap(tool).await?;
            page.wait_for(&format!("#drawing[data-tool={}]", tool.to_lowercase())).await?;
            let place = at(page, point).await?;
            page.touch_drag(&[&[place]]).await?;
        }
        keeps(page, &figure_3_1()?).await?;
        page.screenshot("drawn-by-touch").await?;
        page.tap("Step through it →").await?;
        page.wait_for("#said").await?;
        for stop in 1..=25 {
            page.tap("Forward").await?;
            page.wait_for(&format!("svg.maze[data-stop='{stop}']")).await?;
            shows_stop(page, stop).await?;
        }
        assert_eq!(page.texts("#result .letters b").await?, ["S", "S", "R"]);
        Ok(())
    })
    .await
}

#[tokio::test]
async fn two_fingers_zoom_and_draw_nothing() -> Result<()> {
    draw_room(Setup::default().touch().size(390, 844), async |page| {
        let percent = async || -> Result<f64> {
            let text = page.text("button.percent").await?;
            let number = text.split_whitespace().rev().find_map(|word| word.parse().ok());
            number.with_context(|| format!("no number in {text}"))
        };
        let (before, drawn) = (percent().await?, kept(page).await?);
        let middle = between(page, (3.5, 2.5)).await?;
        page.pinch(middle, 60.0, 240.0).await?;
        let after = percent().await?;
        assert!(after > before * 2.0, "{before} % became {after} %");
        let still = between(page, (3.5, 2.5)).await?;
        assert!(
            (still.0 - middle.0).abs() < 3.0 && (still.1 - middle.1).abs() < 3.0,
            "{middle:?} is at {still:?}"
        );
        page.pinch(middle, 240.0, 60.0).await?;
        assert!((percent().await? - before).abs() < before / 5.0);
        assert_eq!(kept(page).await?, drawn);
        Ok(())
    })
    .await
}

#[tokio::test]
async fn figure_3_1_is_drawn_by_mouse_and_erased_by_the_right_button() -> Result<()> {
    draw_room(Setup::default(), async |page| {
        new_by_keys(page, "8", "6").await?;
        for stroke in STROKES {
            page.drag(&places(page, stroke).await?, Button::Left).await?;
        }
        for (key, point) in [("f", FINISH), ("s", START)] {
            page.press(key).await?;
            let place = at(page, point).await?;
            page.click_at(place).await?;
        }
        keeps(page, &figure_3_1()?).await?;
        has_cells(page, 29).await?;
        let path = [between(page, (0.3, 3.0)).await?, between(page, (1.7, 3.0)).await?];
        page.drag(&path, Button::Right).await?;
        has_cells(page, 27).await?;
        page.click("Erase").await?;
        let path = [between(page, (2.0, 2.8)).await?, between(page, (2.0, 1.4)).await?];
        page.drag(&path, Button::Left).await?;
        has_cells(page, 25).await?;
        page.click_css("[aria-label^='Undo:']").await?;
        has_cells(page, 27).await?;
        page.press("Control+z").await?;
        keeps(page, &figure_3_1()?).await?;
        page.screenshot("draw").await
    })
    .await
}

#[tokio::test]
async fn sixty_edits_are_undone_and_done_again() -> Result<()> {
    draw_room(Setup::default(), async |page| {
        new_by_keys(page, "16", "10").await?;
        for row in 0..4 {
            page.press_times(if row % 2 == 0 { "Shift+ArrowRight" } else { "Shift+ArrowLeft" }, 15).await?;
            page.press("ArrowUp").await?;
        }
        has_cells(page, 60).await?;
        let full = kept(page).await?;
        for left in [40, 7, 0] {
            page.press_times("Control+z", cells(page).await? - left).await?;
            has_cells(page, left).await?;
        }
        // One more, and the maze from before is back.
        page.press("Control+z").await?;
        page.wait_for_text(".stage .bar", "The run of the book").await?;
        page.press_times("Control+y", 21).await?;
        has_cells(page, 20).await?;
        page.press_times("Control+Shift+z", 40).await?;
        has_cells(page, 60).await?;
        assert_eq!(kept(page).await?, full);
        // A new edit forgets what was undone.
        page.press_times("Control+z", 2).await?;
        page.press("Shift+ArrowUp").await?;
        has_cells(page, 59).await?;
        page.press("Control+y").await?;
        has_cells(page, 59).await
    })
    .await
}

#[tokio::test]
async fn start_and_finish_are_dragged_and_turned() -> Result<()> {
    draw_room(Setup::default(), async |page| {
        let start = async || -> Result<String> {
            let start = text::parse(&kept(page).await?)?.start().context("no start")?;
            Ok(format!("{} {}", start.at, start.heading.word()))
        };
        page.click("Start").await?;
        let path = places(page, &[(0, 0), (3, 2), (7, 0)]).await?;
        page.drag(&path, Button::Left).await?;
        page.wait_for_text("#draw-status", "Start").await?;
        assert_eq!(start().await?, "7,0 west");
        page.press("t").await?;
        page.wait_for_text(".checks", "Turn it").await?;
        assert_eq!(start().await?, "7,0 north");
        page.click("Turn it west").await?;
        assert_eq!(start().await?, "7,0 west");
        // By its handle, with any tool.
        page.click("Line").await?;
        let rect =
            page.eval("document.querySelector('.start .handle').getBoundingClientRect().toJSON()").await?;
        let of = |name: &str| rect[name].as_f64().unwrap_or_default();
        let handle = (of("x") + of("width") / 2.0, of("y") + of("height") / 2.0);
        let above = at(page, (7, 2)).await?;
        page.drag(&[handle, above], Button::Left).await?;
        assert_eq!(start().await?, "7,0 north");
        has_cells(page, 29).await?;

        page.click("Finish").await?;
        let path = places(page, &[(3, 4), (4, 2)]).await?;
        page.drag(&path, Button::Left).await?;
        let finish = text::parse(&kept(page).await?)?.finish().to_vec();
        assert_eq!(format!("{finish:?}").matches("Point").count(), 1);
        assert_eq!((finish[0].x, finish[0].y), (4, 2));
        page.press_times("Control+z", 5).await?;
        keeps(page, &figure_3_1()?).await
    })
    .await
}

#[tokio::test]
async fn a_drawing_survives_a_reload() -> Result<()> {
    draw_room(Setup::default(), async |page| {
        new_by_keys(page, "5", "4").await?;
        page.press_times("Shift+ArrowRight", 3).await?;
        page.press("f").await?;
        has_cells(page, 3).await?;
        let before = kept(page).await?;
        page.reload().await?;
        page.wait_for("#drawing").await?;
        has_cells(page, 3).await?;
        assert_eq!(kept(page).await?, before);
        // Nothing to run yet, and the way to a cure.
        page.press("2").await?;
        page.wait_for_text(".side", "The bot can’t start").await?;
        page.click("Draw it right").await?;
        page.wait_for("#drawing").await
    })
    .await
}
