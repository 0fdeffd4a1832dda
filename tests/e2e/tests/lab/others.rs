//! Every explorer in the stepper: chosen, stepped, jumped in, and with its own memory on show.

use anyhow::{Context, Result};
use e2e::{Page, Setup, Site, lab, lab_at};

const SAKIB_1: &str = include_str!("../../../../mazes/sakib-1.maze");
const SAKIB_2: &str = include_str!("../../../../mazes/sakib-2.maze");
const PAREX_1: &str = include_str!("../../../../mazes/parex-1.maze");
const CORNELL_3X5: &str = include_str!("../../../../mazes/cornell-3x5.maze");

/// The title of every explorer but the book's, and what its inspector is called.
const OTHERS: [(&str, &str); 13] = [
    ("Left hand on the wall", "Turn letters"),
    ("Right hand on the wall", "Turn letters"),
    ("Direction sums, left first", "Direction sums"),
    ("Direction sums, right first", "Direction sums"),
    ("Full mapping", "Arrays, one column a visit"),
    ("Path mapping, left hand", "Path of squares"),
    ("Path mapping, right hand", "Path of squares"),
    ("Cornell 1, turn by turn", "A byte for every square"),
    ("Cornell 2, unvisited first", "A byte for every square"),
    ("Cornell 3, with path planning", "A byte for every square"),
    ("Trémaux’s marks", "Marks on the ways"),
    ("Depth first", "Stack and used ways"),
    ("Flood fill, goal told", "Numbers of the flood"),
];

async fn choose(page: &Page, title: &str) -> Result<()> {
    page.press("o").await?;
    page.choose("#explorer-name", title).await?;
    page.leave_dialog().await?;
    page.wait_for_text("#explorer", title).await?;
    page.wait_for("#inspector").await
}

async fn at_stop(page: &Page, stop: u32) -> Result<()> {
    page.wait_for(&format!("svg.maze[data-stop='{stop}']")).await
}

/// The cells of a row of the inspector's table.
async fn row(page: &Page, number: usize) -> Result<Vec<String>> {
    page.texts(&format!("#inspector .cols tr:nth-child({number}) > td")).await
}

#[tokio::test]
async fn every_explorer_is_chosen_and_stepped() -> Result<()> {
    lab(Setup::default().stored("maze", SAKIB_1), async |page| {
        for (title, inspector) in OTHERS {
            choose(page, title).await?;
            at_stop(page, 0).await?;
            page.wait_for_text("#inspector-title", inspector).await?;
            page.press_times("ArrowRight", 3).await?;
            at_stop(page, 3).await?;
            assert!(!page.text("#said").await?.is_empty(), "{title} says nothing");
            assert_eq!(page.count(".code > .ran").await?, 1, "{title}");
            page.press("ArrowLeft").await?;
            at_stop(page, 2).await?;
            page.press("ArrowDown").await?;
            assert_eq!(page.count(".code > .next").await?, 1, "{title}");
            page.press("End").await?;
            page.wait_for("#result").await?;
            assert!(page.text("#result").await?.contains("Outcome"), "{title}");
            page.press("Home").await?;
            at_stop(page, 0).await?;
        }
        // The book's room comes back as it was.
        page.press("o").await?;
        page.choose("#explorer-name", "The book’s explorer").await?;
        page.leave_dialog().await?;
        page.wait_for(".nodes-card").await
    })
    .await
}

#[tokio::test]
async fn sakibs_sums_and_columns_are_the_papers() -> Result<()> {
    lab(Setup::default().stored("maze", SAKIB_1), async |page| {
        choose(page, "Direction sums, right first").await?;
        page.press("PageDown").await?;
        assert_eq!(row(page, 2).await?, ["1"]);
        page.press("End").await?;
        page.wait_for_text("#said", "finish").await?;
        assert_eq!(row(page, 2).await?, ["3", "1", "1"]);
        assert_eq!(page.texts("#result .letters b").await?, ["L", "R", "R"]);
        page.click_css(".export > summary").await?;
        page.choose("[aria-label=Form]", "C array").await?;
        page.wait_for_text(".export .snip", "const char turns[] = \"LRR\";").await?;
        page.screenshot("others-sums").await?;
        page.click("Drive the solved run").await?;
        page.wait_for_text("#said", "finish").await?;
        page.click("Back to the exploration").await?;

        page.drop_file("sakib-2.maze", SAKIB_2.as_bytes()).await?;
        choose(page, "Full mapping").await?;
        page.press("End").await?;
        page.wait_for("#search").await?;
        assert_eq!(row(page, 1).await?, ["0", "1", "2", "3", "4", "3", "5", "1", "6", "1", "2", "7"]);
        assert_eq!(row(page, 3).await?, ["0", "1", "1", "1", "1", "2", "1", "3", "1", "4", "2", "1"]);
        page.click("Settle one more").await?;
        page.wait_for_text("#search .frontier", "1").await?;
        page.click("To the end").await?;
        page.wait_for_text("#search", "Route: 0 1 2 7").await?;
        page.screenshot("others-mapping").await
    })
    .await
}

#[tokio::test]
async fn parex_and_cornell_show_path_and_bytes() -> Result<()> {
    lab(Setup::default().stored("maze", PAREX_1), async |page| {
        choose(page, "Path mapping, right hand").await?;
        page.press("End").await?;
        page.wait_for("#result").await?;
        assert_eq!(row(page, 2).await?, ["1", "5", "9", "10", "11", "12", "8", "4"]);
        page.press("o").await?;
        page.choose("#rule", "basic: only where it was two steps ago").await?;
        page.leave_dialog().await?;
        page.press("End").await?;
        page.wait_for("#result").await?;
        assert_eq!(row(page, 2).await?.len(), 14);
        page.screenshot("others-parex").await?;

        page.drop_file("cornell.maze", CORNELL_3X5.as_bytes()).await?;
        choose(page, "Cornell 3, with path planning").await?;
        page.press("End").await?;
        page.wait_for_text("#count", "/ 16").await?;
        // Text of a drawing has no `innerText`.
        let bytes =
            "[...document.querySelectorAll('#inspector .hex')].map((byte) => byte.textContent).join(' ')";
        assert_eq!(page.eval(bytes).await?, "19 1A 1C 13 1A 14 1D 19 16 11 12 1C 13 1A 16");
        page.screenshot("others-cornell").await
    })
    .await
}

#[tokio::test]
async fn reload_and_link_keep_the_explorer() -> Result<()> {
    let site = Site::start().await?;
    lab_at(&site, Setup::default().stored("maze", SAKIB_1), async |page| {
        choose(page, "Direction sums, right first").await?;
        page.reload().await?;
        page.wait_for_text("#explorer", "Direction sums, right first").await?;
        page.press_times("PageDown", 4).await?;
        at_stop(page, 4).await?;
        let said = page.text("#said").await?;
        page.click("Share").await?;
        page.wait_for("dialog #link").await?;
        let link = page.value("#link").await?;
        let hash = link.split_once('#').context("a link without #")?.1.to_owned();
        lab_at(&site, Setup::default().at(hash), async |other| {
            at_stop(other, 4).await?;
            assert_eq!(other.text("#said").await?, said);
            other.wait_for_text("#explorer", "Direction sums, right first").await
        })
        .await
    })
    .await
}

#[tokio::test]
async fn letters_are_reduced_on_paper() -> Result<()> {
    lab(Setup::default(), async |page| {
        page.press("t").await?;
        page.fill("#turns", "SLBLSR").await?;
        page.click("Reduce once").await?;
        page.wait_for_text("#reductions", "SSSR").await?;
        page.fill("#turns", "SSX").await?;
        page.wait_for_text("#turns-hint", "Character 3 is “X”: write L, S or F").await?;
        // As people have them: letters of others, quotes, arrows, a file.
        for (text, letters) in [
            ("{'f', 'u'}", "SB"),
            ("←→↑↓", "LRSB"),
            ("number,letter,turn\n1,S,straight\n2,R,right\n", "SR"),
            ("const char turns[] = \"SSR\"; // LLL", "SSR"),
        ] {
            page.fill("#turns", text).await?;
            page.wait_until(&format!(
                "document.querySelector('#reductions').innerText.trim() === '{letters}'"
            ))
            .await?;
        }
        page.wait_for_text("#leads", "It leads to the finish").await?;
        page.click("Reverse").await?;
        assert_eq!(page.value("#turns").await?, "LSS");
        page.screenshot("others-turns").await
    })
    .await
}
