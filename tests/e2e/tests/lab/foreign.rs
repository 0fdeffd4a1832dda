//! Other people's files: what was made of them is told, and what they lack is offered with one click.

use anyhow::Result;
use e2e::{Page, Setup, root};
use line_maze_lab::geometry::{Heading, Point};
use line_maze_lab::maze::micromouse::Form;
use line_maze_lab::maze::{Kind, Maze, file};

use crate::drawing::{draw_room, from_menu, kept_when};

async fn drop_fixture(page: &Page, name: &str) -> Result<()> {
    let bytes = std::fs::read(root().join("tests/fixtures/foreign").join(name))?;
    page.drop_file(name, &bytes).await?;
    page.wait_for_text(".toast", &format!("Opened {name}.")).await
}

async fn walls(page: &Page) -> Result<Maze> {
    kept_when(page, |maze| maze.kind == Kind::Wall).await
}

#[tokio::test]
async fn how_a_file_was_read_is_told_and_stays() -> Result<()> {
    draw_room(Setup::default(), async |page| {
        drop_fixture(page, "unknown-walls.maze").await?;
        page.wait_for_text(".toast[role=status]", "3 unknown walls were taken as walls.").await?;
        page.screenshot("unknown-walls").await?;
        // It speaks of this maze, and is over with it.
        page.run("document.getElementById('drawing').focus()").await?;
        page.press("t").await?;
        page.wait_for_no(".toast").await?;
        drop_fixture(page, "begins-late.txt").await?;
        page.wait_for_text(".toast", "what stands before it was left out").await?;
        page.wait_for_text(".toast", "the robot faces east, its only way").await?;
        page.click("Undo").await?;
        kept_when(page, |maze| maze.bounds().width() == 3).await?;
        page.paste("  +-+-+\n  |S|G|\n  + + +\n  |   |\n  +-+-+\n").await?;
        page.wait_for_text(".toast", "indented by 2 columns").await?;
        assert_eq!(kept_when(page, |maze| maze.bounds().width() == 2).await?.cells(), 3);
        Ok(())
    })
    .await
}

#[tokio::test]
async fn a_finish_that_no_file_names_is_put_in_the_centre_with_one_click() -> Result<()> {
    draw_room(Setup::default(), async |page| {
        let centre = [15, 16].map(|x| [15, 16].map(|y| Point::new(x, y))).concat();
        drop_fixture(page, "half-size.maz").await?;
        page.wait_for_text(".toast", "The file names no finish.").await?;
        page.screenshot("no-finish-opened").await?;
        page.click("Put it in the centre").await?;
        page.wait_for_text(".toast", "Finish put in the centre.").await?;
        assert_eq!(kept_when(page, |maze| !maze.finish().is_empty()).await?.finish(), centre);
        page.click("Undo").await?;
        kept_when(page, |maze| maze.finish().is_empty()).await?;
        page.wait_for_no(".toast").await?;
        // The checks offer the same, as long as it is missing.
        page.wait_for_text(".checks-card", "No finish").await?;
        page.screenshot("no-finish-checks").await?;
        page.click("Put it in the centre").await?;
        page.wait_for_text(".checks-card", "Finish can be reached").await?;
        assert_eq!(walls(page).await?.finish(), centre);
        Ok(())
    })
    .await
}

#[tokio::test]
async fn a_start_that_the_book_cannot_use_is_cured_with_one_click() -> Result<()> {
    draw_room(Setup::default(), async |page| {
        drop_fixture(page, "start-with-two-ways.txt").await?;
        page.wait_for_text(".toast", "could not know that it is back there").await?;
        page.wait_for_text(".checks-card", "Start has several ways out").await?;
        // The room's other sentence says the same.
        page.wait_for_text(".explorer", "has 2 ways").await?;
        page.screenshot("two-ways").await?;
        page.run("document.querySelector('.toast [aria-label=\"Close the message\"]').click()").await?;
        page.click("Close all but its way north").await?;
        page.wait_for_text(".checks-card", "Start is in a square with one way out").await?;
        assert!(!walls(page).await?.has_line(Point::new(0, 0), Heading::East));
        // Turned off its way, it is turned back.
        page.press("t").await?;
        page.wait_for_text(".checks-card", "Start faces a wall").await?;
        page.wait_for_text(".explorer", "turn it").await?;
        page.click("Turn it north").await?;
        page.wait_for_text(".toast", "Start turned north.").await?;
        page.wait_for_text(".checks-card", "Start is in a square with one way out").await?;
        let start = walls(page).await?.start().map(|start| start.heading);
        assert_eq!(start, Some(Heading::North));
        Ok(())
    })
    .await
}

#[tokio::test]
async fn a_finish_off_the_centre_is_left_out_of_an_export_by_choice() -> Result<()> {
    draw_room(Setup::default(), async |page| {
        let downloads = page.allow_downloads().await?;
        drop_fixture(page, "goals-off-centre.txt").await?;
        let maze = walls(page).await?;
        from_menu(page, "Export micromouse .num").await?;
        page.wait_for_text(".toast[role=alert]", "the finish is not written and means the centre").await?;
        page.wait_for_text(".toast[role=alert]", "The File menu has a choice").await?;
        page.press("Escape").await?;
        from_menu(page, "Leave out a finish off the centre").await?;
        page.wait_for("[role=menuitemcheckbox][aria-checked=true]").await?;
        page.screenshot("leave-out").await?;
        page.click("Export micromouse .num").await?;
        let mut without = maze.clone();
        without.set_finish(Vec::new());
        let name = file::name(&maze, "num");
        assert_eq!(
            downloads.bytes(&name).await?,
            file::write(&without, file::Format::Micromouse(Form::Num))?
        );
        // A drawing can say it: there it stays.
        from_menu(page, "Export micromouse .txt").await?;
        let drawn = downloads.file(&file::name(&maze, "txt")).await?;
        assert_eq!(drawn.matches('G').count(), 4, "{drawn}");
        Ok(())
    })
    .await
}

/// A maze without a finish is not said to have one out of reach.
#[tokio::test]
async fn a_run_without_a_finish_says_that_there_is_none() -> Result<()> {
    draw_room(Setup::default(), async |page| {
        drop_fixture(page, "no-finish.num").await?;
        page.wait_for_text(".explorer", "the maze has no finish").await?;
        page.run("location.hash = 'compare'").await?;
        page.wait_for_text("main", "no finish").await?;
        let seen = page.text("main").await?;
        assert!(!seen.contains("no way there"), "{seen}");
        Ok(())
    })
    .await
}
