//! The Draw room: by keyboard, mouse and touch, from an empty sheet to a solved maze.

use anyhow::{Context, Result};
use e2e::{Button, Page, Place, Setup, lab, root};
use line_maze_lab::maze::generate::{Recipe, generate};
use line_maze_lab::maze::{Maze, text};
use serde_json::{Value, json};

use crate::figure_3_1::{shows_stop, steps_to_the_end};

/// Figure 3.1 as strokes of a pen.
const STROKES: [&[(i32, i32)]; 5] = [
    &[(0, 0), (0, 5), (6, 5), (6, 0), (7, 0)],
    &[(0, 1), (6, 1)],
    &[(0, 3), (2, 3), (2, 1)],
    &[(4, 1), (4, 2)],
    &[(3, 5), (3, 4)],
];
const START: (i32, i32) = (0, 0);
const FINISH: (i32, i32) = (3, 4);

fn figure_3_1() -> Result<Maze> {
    Ok(text::parse(&std::fs::read_to_string(root().join("mazes/book-3-1.maze"))?)?)
}

/// The maze as the browser keeps it.
async fn kept(page: &Page) -> Result<String> {
    let kept = page.eval("localStorage.getItem('line-maze-lab/maze')").await?;
    Ok(kept.as_str().context("the browser keeps no maze")?.to_owned())
}

/// Checks that this was drawn, whatever it is called.
async fn keeps(page: &Page, expected: &Maze) -> Result<()> {
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
async fn cells(page: &Page) -> Result<usize> {
    Ok(text::parse(&kept(page).await?)?.cells())
}

async fn has_cells(page: &Page, count: usize) -> Result<()> {
    let size = json!(format!(" {count} cell"));
    page.wait_until(&format!("document.querySelector('.bar .size').textContent.includes({size})")).await?;
    assert_eq!(cells(page).await?, count);
    Ok(())
}

/// Where a lattice point is in the window.
async fn at(page: &Page, (x, y): (i32, i32)) -> Result<Place> {
    between(page, (f64::from(x), f64::from(y))).await
}

async fn between(page: &Page, (x, y): (f64, f64)) -> Result<Place> {
    let find = "(x, y) => {
        const svg = document.querySelector('#drawing svg.maze');
        document.getElementById('drawing').scrollIntoView({ block: 'nearest', behavior: 'instant' });
        const place = new DOMPoint(x * 80, y * -80).matrixTransform(svg.getScreenCTM());
        return [place.x, place.y];
    }";
    let place = page.call(find, &[json!(x), json!(y)]).await?;
    Ok((place[0].as_f64().context("no place")?, place[1].as_f64().context("no place")?))
}

async fn places(page: &Page, points: &[(i32, i32)]) -> Result<Vec<Place>> {
    let mut places = Vec::new();
    for &point in points {
        places.push(at(page, point).await?);
    }
    Ok(places)
}

/// Every lattice point along a stroke: a finger touches them all.
fn along(stroke: &[(i32, i32)]) -> Vec<(i32, i32)> {
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

async fn draw_room(setup: Setup, body: impl AsyncFnOnce(&Page) -> Result<()>) -> Result<()> {
    lab(setup.at("draw"), async |page| {
        page.wait_for("#drawing svg.maze").await?;
        body(page).await
    })
    .await
}

/// Presses Tab until an element has the focus.
async fn tab_to(page: &Page, css: &str) -> Result<()> {
    for _ in 0..60 {
        if page.eval(&format!("document.activeElement.matches({})", json!(css))).await? == true {
            return Ok(());
        }
        page.press("Tab").await?;
    }
    anyhow::bail!("Tab never comes to {css}")
}

/// An empty maze of this size, by keys.
async fn new_by_keys(page: &Page, width: &str, height: &str) -> Result<()> {
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

fn arrow(from: (i32, i32), to: (i32, i32)) -> Option<&'static str> {
    Some(match ((to.0 - from.0).signum(), (to.1 - from.1).signum()) {
        (1, _) => "ArrowRight",
        (-1, _) => "ArrowLeft",
        (_, 1) => "ArrowUp",
        (_, -1) => "ArrowDown",
        _ => return None,
    })
}

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
        page.click("Turn it").await?;
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
async fn a_maze_is_saved_and_opened_again() -> Result<()> {
    // The system's own dialog for files can't be used by a test: the field is put on the page instead.
    let chooser =
        "HTMLInputElement.prototype.click = function () { document.querySelector('main').append(this) };";
    draw_room(Setup::default().script(chooser), async |page| {
        let downloads = page.allow_downloads().await?;
        let path = places(page, &[(0, 3), (0, 3)]).await?;
        page.drag(&path, Button::Left).await?;
        page.press("Control+s").await?;
        let saved = downloads.file("the-run-of-the-book.maze").await?;
        assert_eq!(text::parse(&saved)?, figure_3_1()?);
        for (entry, file) in [
            ("Save .json", "the-run-of-the-book.json"),
            ("Export picture, SVG", "the-run-of-the-book.svg"),
            ("Export picture, PNG", "the-run-of-the-book.png"),
        ] {
            page.click("File ▾").await?;
            page.wait_for("[role=menu]").await?;
            page.click(entry).await?;
            assert!(downloads.bytes(file).await?.len() > 300, "{file}");
        }
        assert!(downloads.bytes("the-run-of-the-book.png").await?.starts_with(b"\x89PNG"));
        assert!(downloads.file("the-run-of-the-book.svg").await?.contains("<svg"));

        for file in ["the-run-of-the-book.maze", "the-run-of-the-book.json"] {
            new_by_keys(page, "3", "3").await?;
            has_cells(page, 0).await?;
            page.press("Control+o").await?;
            page.wait_for("input[type=file]").await?;
            page.choose_file("input[type=file]", &downloads.path(file)).await?;
            page.wait_for_text(".stage .bar", "The run of the book").await?;
            assert_eq!(kept(page).await?, saved, "{file}");
            page.run("document.querySelector('input[type=file]').remove()").await?;
        }
        Ok(())
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
