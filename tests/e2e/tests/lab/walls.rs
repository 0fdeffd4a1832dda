//! Mazes of walls: built and opened by mouse, touch and keyboard, checked, and stepped through.

use anyhow::Result;
use e2e::{Button, Page, Setup};
use line_maze_lab::geometry::{Heading, Point};
use line_maze_lab::maze::Kind;

use crate::drawing::{at, between, cells, draw_room, has_cells, kept_when, new_walls};

/// Where a post is in the window: the south-west corner of the square with its name.
async fn post(page: &Page, (x, y): (i32, i32)) -> Result<e2e::Place> {
    between(page, (f64::from(x) - 0.5, f64::from(y) - 0.5)).await
}

async fn posts(page: &Page, points: &[(i32, i32)]) -> Result<Vec<e2e::Place>> {
    let mut places = Vec::new();
    for &point in points {
        places.push(post(page, point).await?);
    }
    Ok(places)
}

async fn opened(page: &Page, square: (i32, i32), side: Heading) -> Result<bool> {
    let maze = kept_when(page, |_| true).await?;
    Ok(maze.has_line(Point::new(square.0, square.1), side))
}

#[tokio::test]
async fn walls_are_built_and_opened_by_mouse() -> Result<()> {
    draw_room(Setup::default(), async |page| {
        new_walls(page, "6", "4").await?;
        has_cells(page, 38).await?;
        page.drag(&posts(page, &[(1, 0), (1, 3), (3, 3)]).await?, Button::Left).await?;
        has_cells(page, 33).await?;
        assert!(!opened(page, (0, 0), Heading::East).await? && !opened(page, (2, 2), Heading::North).await?);
        assert!(page.attribute("[aria-label^='Undo:']", "aria-label").await?.contains("build 5 walls"));
        page.screenshot("walls").await?;
        // The right button opens what it passes.
        let path = [between(page, (0.5, 0.1)).await?, between(page, (0.5, 0.9)).await?];
        page.drag(&path, Button::Right).await?;
        has_cells(page, 35).await?;
        assert!(page.attribute("[aria-label^='Undo:']", "aria-label").await?.contains("open 2 walls"));
        // A press on a side toggles it.
        let side = between(page, (3.5, 1.0)).await?;
        page.click_at(side).await?;
        has_cells(page, 34).await?;
        page.click_at(side).await?;
        has_cells(page, 35).await?;
        // The outer wall stays.
        page.click("Open").await?;
        let path = [between(page, (0.0, -0.5)).await?, between(page, (3.0, -0.5)).await?];
        page.drag(&path, Button::Left).await?;
        has_cells(page, 35).await?;
        page.press_times("Control+z", 2).await?;
        page.press("Control+z").await?;
        has_cells(page, 33).await?;
        page.press("Control+Shift+z").await?;
        has_cells(page, 35).await?;
        // Start and finish go into any square.
        page.click("Start").await?;
        page.click_at(at(page, (2, 1)).await?).await?;
        page.press("t").await?;
        page.click("Finish").await?;
        page.click_at(at(page, (5, 3)).await?).await?;
        let maze = kept_when(page, |maze| !maze.finish().is_empty()).await?;
        assert_eq!(maze.finish(), [Point::new(5, 3)]);
        let start = maze.start().map(|start| (start.at, start.heading));
        assert_eq!(start, Some((Point::new(2, 1), Heading::East)));
        page.wait_for_text(".checks-card", "Start has several ways out").await
    })
    .await
}

#[tokio::test]
async fn walls_are_built_and_opened_by_touch() -> Result<()> {
    draw_room(Setup::default().touch().size(390, 844), async |page| {
        new_walls(page, "5", "5").await?;
        has_cells(page, 40).await?;
        let finger = posts(page, &[(2, 0), (2, 1), (2, 2), (2, 3)]).await?;
        page.touch_drag(&[&finger]).await?;
        has_cells(page, 37).await?;
        page.screenshot("walls-by-touch").await?;
        page.tap("Open").await?;
        page.wait_for("#drawing[data-tool=erase]").await?;
        let finger = [between(page, (1.5, 0.1)).await?, between(page, (1.5, 0.5)).await?];
        let finger = [finger[0], finger[1], between(page, (1.5, 1.0)).await?];
        page.touch_drag(&[&finger]).await?;
        has_cells(page, 39).await
    })
    .await
}

#[tokio::test]
async fn walls_are_built_and_opened_by_keyboard_and_the_maze_is_solved() -> Result<()> {
    draw_room(Setup::default(), async |page| {
        // All squares closed: the way is opened square by square.
        page.paste("line-maze: 1\ntitle: Closed\nkind: wall\nbounds: 0,0 3,2\nstart: 0,0 N\n\nlines:\n")
            .await?;
        page.wait_for("#drawing svg.walls").await?;
        page.wait_for_text(".checks-card", "No openings yet").await?;
        page.run("document.getElementById('drawing').focus()").await?;
        page.press("ArrowUp").await?;
        page.press_times("Alt+ArrowUp", 2).await?;
        page.press_times("Alt+ArrowRight", 3).await?;
        page.press("Alt+ArrowDown").await?;
        page.press("f").await?;
        has_cells(page, 6).await?;
        assert!(page.text("#draw-status").await?.contains("open to the north; finish"));
        // Shift builds on this side, and the cursor stays.
        page.press("Shift+ArrowUp").await?;
        has_cells(page, 5).await?;
        page.wait_for_text("#draw-status", "walls all round").await?;
        page.wait_for_text(".checks-card", "Finish is walled in").await?;
        page.press("Control+z").await?;
        has_cells(page, 6).await?;
        page.wait_for_text(".checks-card", "in order").await?;
        page.press("2").await?;
        page.wait_for("svg.maze.walls").await?;
        page.press("End").await?;
        page.wait_for_text("#said", "FINISH").await?;
        page.press("v").await?;
        page.screenshot("walls-robots-eye").await?;
        let solid = page.attribute("svg.maze .solid", "d").await?;
        assert!(!solid.is_empty(), "what was not seen is solid");
        page.press("p").await?;
        page.wait_for(".projector svg.walls").await
    })
    .await
}

#[tokio::test]
async fn a_line_maze_becomes_walls_and_lines_again() -> Result<()> {
    draw_room(Setup::default(), async |page| {
        page.click("Walls").await?;
        page.wait_for("#drawing svg.walls").await?;
        let maze = kept_when(page, |maze| maze.kind == Kind::Wall).await?;
        assert_eq!((maze.cells(), cells(page).await?), (29, 29));
        page.screenshot("figure-3-1-as-walls").await?;
        page.click("Lines").await?;
        page.wait_for("#drawing svg:not(.walls)").await
    })
    .await
}
