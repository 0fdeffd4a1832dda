//! The Compare room: runs abreast, where they part, the table, random orders, and the league.

use anyhow::Result;
use e2e::{Page, Setup, lab};
use serde_json::json;

async fn compare_room(hash: &str, body: impl AsyncFnOnce(&Page) -> Result<()>) -> Result<()> {
    lab(Setup::default().at(hash), async |page| {
        page.wait_for("main.compare").await?;
        body(page).await
    })
    .await
}

/// The stops at which the runs stand.
async fn stops(page: &Page) -> Result<Vec<String>> {
    let mut stops = Vec::new();
    for nth in 0..page.count(".run").await? {
        stops.push(page.attribute(&format!(".run[data-nth='{nth}']"), "data-stop").await?);
    }
    Ok(stops)
}

#[tokio::test]
async fn three_run_abreast_and_one_is_opened() -> Result<()> {
    compare_room("compare", async |page| {
        page.wait_until("document.querySelectorAll('.run').length === 3").await?;
        assert_eq!(stops(page).await?, ["0", "0", "0"]);
        assert!(page.text(".parting").await?.contains("First parting"));
        page.press("ArrowRight").await?;
        page.wait_for_text("#abreast", "1.0 of").await?;
        page.press("End").await?;
        page.wait_until("document.querySelector('.run[data-nth=\"0\"]').dataset.stop === '25'").await?;
        page.press("Home").await?;
        page.wait_for_text("#abreast", "0.0 of").await?;
        page.click("Go there").await?;
        page.wait_until("!document.querySelector('#abreast').textContent.startsWith('0.0 of')").await?;
        // Half of the way by the scrubber.
        let place = page.middle(".lanes").await?;
        page.click_at(place).await?;
        page.wait_until("document.querySelector('.run[data-nth=\"0\"]').dataset.stop > 3").await?;
        let stop = stops(page).await?[0].clone();
        page.click("Open A in Step, at this moment").await?;
        page.wait_for_text("#count", &format!("stop {stop} /")).await
    })
    .await
}

#[tokio::test]
async fn a_maze_of_walls_is_compared_as_walls() -> Result<()> {
    lab(Setup::default().at("draw"), async |page| {
        page.wait_for("#drawing").await?;
        page.click_css("#drawn-as button:nth-child(2)").await?;
        page.wait_for("#drawing svg.walls").await?;
        page.press("3").await?;
        page.wait_until("document.querySelectorAll('.run svg.maze.walls').length === 3").await?;
        page.press("End").await?;
        page.wait_until("document.querySelector('.run[data-nth=\"0\"]').dataset.stop === '25'").await?;
        page.screenshot("compare-walls").await
    })
    .await
}

#[tokio::test]
async fn the_table_sorts_and_the_line_up_changes() -> Result<()> {
    compare_room("compare", async |page| {
        let first = "document.querySelector('.results tbody .open').innerText";
        page.click_css(".results thead th:nth-child(1) button").await?;
        page.wait_until(&format!("{first}.startsWith('A')")).await?;
        page.click_css(".results thead th:nth-child(1) button").await?;
        page.wait_until(&format!("{first}.startsWith('C')")).await?;
        assert_eq!(page.attribute(".results thead th:nth-child(1)", "aria-sort").await?, "descending");
        page.click("3 explorers…").await?;
        page.wait_for("dialog[open]").await?;
        page.click_css("dialog input[value=tremaux]").await?;
        page.leave_dialog().await?;
        page.wait_until("document.querySelectorAll('.run').length === 4").await?;
        page.press("n").await?;
        page.wait_until("!document.querySelector('#abreast').textContent.startsWith('0.0 of')").await
    })
    .await
}

#[tokio::test]
async fn random_orders_show_their_spread() -> Result<()> {
    compare_room("compare", async |page| {
        page.wait_for(".orders .plot .bar.best").await?;
        assert!(page.text(".orders figcaption").await?.contains("of 1000 random orders find the shortest"));
        page.click_css(".orders figure .btn").await?;
        page.wait_for_text("#count", "stop 0 /").await?;
        assert!(page.attribute(".tools-right .btn", "aria-label").await?.contains("random"));
        Ok(())
    })
    .await
}

#[tokio::test]
async fn a_small_league_runs_is_cancelled_sorted_and_saved() -> Result<()> {
    compare_room("league", async |page| {
        page.fill("#league-count", "2000").await?;
        page.click_css("#league-run").await?;
        page.wait_for("#league-stop").await?;
        page.wait_for_text("#league-status", "of 2019 mazes").await?;
        page.wait_until("document.querySelector('#league-status').innerText.match(/^[1-9]/)").await?;
        page.click_css("#league-stop").await?;
        page.wait_for_text("#league-status", "Cancelled after").await?;
        page.wait_for(".standings tbody tr").await?;
        page.fill("#league-count", "3").await?;
        page.click_css("#league-run").await?;
        page.wait_for_text("#league-status", "All 22 mazes are run").await?;
        page.wait_for_text("#runs-title", "108 runs, and 2 that could not start").await?;
        // Shares say of how many, and who could not start is named.
        let book = page.text(".standings tbody tr:first-child").await?;
        assert!(book.contains("of 22") && book.contains(" of 19"), "{book}");
        page.click_css(".absences summary").await?;
        page.wait_for_text(".absences", "2 runs could not start").await?;
        assert!(page.text(".absences").await?.contains("The book’s explorer. The start 0,4 has 2 ways"));
        assert!(!page.text(".standings").await?.contains("left-hand"));
        page.click_css(".runs thead th:nth-child(7) button").await?;
        page.wait_until("document.querySelector('.runs tbody td:nth-child(7)').innerText === '1.00'").await?;
        let downloads = page.allow_downloads().await?;
        page.click("Save all runs as CSV").await?;
        assert_eq!(downloads.file("league.csv").await?.lines().count(), 111);
        page.choose("#runs-of", "The book’s explorer").await?;
        page.wait_for_text("#runs-title", "20 runs, and 2 that").await?;
        // Anywhere in a row.
        page.click_css(".runs tbody tr td:nth-child(2)").await?;
        page.wait_for_text("#count", "stop 0 /").await?;
        page.back().await?;
        page.click_css(".runs tbody .open").await?;
        page.wait_for_text("#count", "stop 0 /").await
    })
    .await
}

#[tokio::test]
async fn dropped_files_are_a_league_and_bad_ones_are_told() -> Result<()> {
    compare_room("compare", async |page| {
        let good = "line-maze: 1\ntitle: My own\n\n+---+---F\n|        \n^   .   .\n";
        let drop = "(good) => {
            const dataTransfer = new DataTransfer();
            for (const [name, text] of [['a.maze', good], ['b.maze', good], ['bad.maze', 'no maze']])
                dataTransfer.items.add(new File([text], name));
            const event = new DragEvent('drop', { dataTransfer, bubbles: true, cancelable: true });
            document.querySelector('main').dispatchEvent(event);
        }";
        page.call(drop, &[json!(good)]).await?;
        page.wait_for_text("#league-status", "All 2 mazes are run").await?;
        page.wait_for_text("#runs-title", "10 runs").await?;
        page.wait_for_text(".league-form", "3 files.").await?;
        page.wait_for_text("#league-run", "Run over 2 mazes").await?;
        page.wait_for_text(".refused", "bad.maze").await?;
        assert!(page.text(".refused").await?.contains("Line 1"));
        Ok(())
    })
    .await
}

#[tokio::test]
async fn a_dropped_folder_is_a_league_with_all_below_it() -> Result<()> {
    let folder = std::env::temp_dir().join(format!("line-maze-folder-{}", std::process::id()));
    std::fs::create_dir_all(folder.join("room/of/mazes"))?;
    for name in ["a.maze", "room/b.maze", "room/of/mazes/c.maze", ".hidden"] {
        std::fs::copy(e2e::root().join("mazes/tree.maze"), folder.join(name))?;
    }
    std::fs::write(folder.join("room/notes.txt"), "no maze")?;
    let dropped = compare_room("compare", async |page| {
        page.drop_paths(&[&folder]).await?;
        page.wait_for_text("#league-status", "All 3 mazes are run").await?;
        page.wait_for_text("#runs-title", "15 runs").await?;
        page.wait_for_text(".refused", "notes.txt").await
    })
    .await;
    std::fs::remove_dir_all(folder)?;
    dropped
}

#[tokio::test]
async fn a_maze_without_a_start_is_compared_with_nothing() -> Result<()> {
    compare_room("compare", async |page| {
        page.paste("line-maze: 1\n\n+---+---F\n").await?;
        page.wait_for_text(".parting", "Two have to drive").await?;
        page.wait_for_text(".orders", "The maze has no start").await?;
        page.wait_for_text(".results .bests", "The maze has no start").await?;
        assert_eq!(page.count(".orders button").await?, 0);
        Ok(())
    })
    .await
}
