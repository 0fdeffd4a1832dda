//! Drawing by hand: what the tests of the Draw room share.

use anyhow::{Context, Result};
use e2e::{Page, Place, Setup, lab, root};
use line_maze_lab::maze::{Kind, Maze, text};
use serde_json::json;

/// Figure 3.1 as strokes of a pen.
pub(crate) const STROKES: [&[(i32, i32)]; 5] = [
    &[(0, 0), (0, 5), (6, 5), (6, 0), (7, 0)],
    &[(0, 1), (6, 1)],
    &[(0, 3), (2, 3), (2, 1)],
    &[(4, 1), (4, 2)],
    &[(3, 5), (3, 4)],
];
pub(crate) const START: (i32, i32) = (0, 0);
pub(crate) const FINISH: (i32, i32) = (3, 4);

pub(crate) fn figure_3_1() -> Result<Maze> {
    Ok(text::parse(&std::fs::read_to_string(root().join("mazes/book-3-1.maze"))?)?)
}

/// The maze as the browser keeps it.
pub(crate) async fn kept(page: &Page) -> Result<String> {
    let kept = page.eval("localStorage.getItem('line-maze-lab/maze')").await?;
    Ok(kept.as_str().context("the browser keeps no maze")?.to_owned())
}

/// Checks that this was drawn, whatever it is called.
pub(crate) async fn keeps(page: &Page, expected: &Maze) -> Result<()> {
    has_cells(page, expected.cells()).await?;
    let kept = text::parse(&kept(page).await?)?;
    assert_eq!(
        (kept.bounds(), kept.start(), kept.finish()),
        (expected.bounds(), expected.start(), expected.finish())
    );
    assert!(kept.lines().eq(expected.lines()), "{}", text::write(&kept));
    Ok(())
}

/// Cells of line in the drawing.
pub(crate) async fn cells(page: &Page) -> Result<usize> {
    Ok(text::parse(&kept(page).await?)?.cells())
}

pub(crate) async fn has_cells(page: &Page, count: usize) -> Result<()> {
    let word = if text::parse(&kept(page).await?)?.kind == Kind::Wall { "opening" } else { "cell" };
    let size = json!(format!(" {count} {word}"));
    page.wait_until(&format!("document.querySelector('.bar .size').textContent.includes({size})")).await?;
    assert_eq!(cells(page).await?, count);
    Ok(())
}

/// Where a lattice point is in the window.
pub(crate) async fn at(page: &Page, (x, y): (i32, i32)) -> Result<Place> {
    between(page, (f64::from(x), f64::from(y))).await
}

pub(crate) async fn between(page: &Page, (x, y): (f64, f64)) -> Result<Place> {
    let find = "(x, y) => {
        const svg = document.querySelector('#drawing svg.maze');
        document.getElementById('drawing').scrollIntoView({ block: 'nearest', behavior: 'instant' });
        const place = new DOMPoint(x * 80, y * -80).matrixTransform(svg.getScreenCTM());
        return [place.x, place.y];
    }";
    let place = page.call(find, &[json!(x), json!(y)]).await?;
    Ok((place[0].as_f64().context("no place")?, place[1].as_f64().context("no place")?))
}

pub(crate) async fn places(page: &Page, points: &[(i32, i32)]) -> Result<Vec<Place>> {
    let mut places = Vec::new();
    for &point in points {
        places.push(at(page, point).await?);
    }
    Ok(places)
}

/// Every lattice point along a stroke: a finger touches them all.
pub(crate) fn along(stroke: &[(i32, i32)]) -> Vec<(i32, i32)> {
    let mut points = vec![stroke[0]];
    for leg in stroke.windows(2) {
        let ((mut x, mut y), to) = (leg[0], leg[1]);
        while (x, y) != to {
            (x, y) = (x + (to.0 - x).signum(), y + (to.1 - y).signum());
            points.push((x, y));
        }
    }
    points
}

pub(crate) async fn draw_room(setup: Setup, body: impl AsyncFnOnce(&Page) -> Result<()>) -> Result<()> {
    lab(setup.at("draw"), async |page| {
        page.wait_for("#drawing svg.maze").await?;
        body(page).await
    })
    .await
}

/// Presses Tab until an element has the focus.
pub(crate) async fn tab_to(page: &Page, css: &str) -> Result<()> {
    for _ in 0..60 {
        if page.eval(&format!("document.activeElement.matches({})", json!(css))).await? == true {
            return Ok(());
        }
        page.press("Tab").await?;
    }
    anyhow::bail!("Tab never comes to {css}")
}

/// An empty maze of this size, by keys.
pub(crate) async fn new_by_keys(page: &Page, width: &str, height: &str) -> Result<()> {
    page.press("Alt+n").await?;
    page.wait_for("dialog[open] #new-width").await?;
    for (field, value) in [("#new-width", width), ("#new-height", height)] {
        tab_to(page, field).await?;
        page.press("Control+a").await?;
        for digit in value.chars() {
            page.press(&digit.to_string()).await?;
        }
    }
    page.press("Enter").await?;
    page.wait_for_no("dialog").await?;
    tab_to(page, "#drawing").await
}

pub(crate) fn arrow(from: (i32, i32), to: (i32, i32)) -> Option<&'static str> {
    Some(match ((to.0 - from.0).signum(), (to.1 - from.1).signum()) {
        (1, _) => "ArrowRight",
        (-1, _) => "ArrowLeft",
        (_, 1) => "ArrowUp",
        (_, -1) => "ArrowDown",
        _ => return None,
    })
}

/// Opens the file menu and chooses an entry.
pub(crate) async fn from_menu(page: &Page, entry: &str) -> Result<()> {
    page.click("File ▾").await?;
    page.wait_for("[role=menu]").await?;
    page.click(entry).await
}

/// An empty maze of this size, of walls.
pub(crate) async fn new_walls(page: &Page, width: &str, height: &str) -> Result<()> {
    page.press("Alt+n").await?;
    page.wait_for("dialog[open] #new-width").await?;
    page.fill("#new-width", width).await?;
    page.fill("#new-height", height).await?;
    page.click("Walls").await?;
    page.wait_for("#new-kind button:nth-child(2)[aria-pressed=true]").await?;
    page.click("Begin").await?;
    page.wait_for_no("dialog").await?;
    page.wait_for("#drawing svg.walls").await
}

/// The maze that is kept, when something about it holds.
pub(crate) async fn kept_when(page: &Page, holds: impl Fn(&Maze) -> bool) -> Result<Maze> {
    for _ in 0..300 {
        let maze = text::parse(&kept(page).await?)?;
        if holds(&maze) {
            return Ok(maze);
        }
        page.promised("new Promise((done) => setTimeout(done, 15))").await?;
    }
    anyhow::bail!("the maze never came to be so: {}", kept(page).await?)
}
