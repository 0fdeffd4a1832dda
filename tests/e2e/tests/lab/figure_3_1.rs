//! The book's walk through figure 3.1, and what the page has to show at every stop of it.

use anyhow::{Context, Result};
use e2e::Page;
use serde_json::{Value, json};

/// Stops after the start.
pub(crate) const STOPS: u32 = 25;

/// Kind of stop, node, place, case, way out, `ptr`, `returning`, and cells crossed out when the stop is over.
type Stop = (&'static str, &'static str, (i32, i32), &'static str, &'static str, u32, bool, u32);

/// The start and every stop.
const STOPS_TABLE: [Stop; 26] = [
    ("start", "", (0, 0), "START", "0", 1, false, 0),
    ("node", "1", (0, 1), "NEW NODE", "0", 2, false, 0),
    ("node", "2", (0, 3), "NEW NODE", "0", 3, false, 0),
    ("corner", "", (0, 5), "CORNER", "1", 3, false, 0),
    ("node", "3", (3, 5), "NEW NODE", "1", 4, false, 0),
    ("corner", "", (6, 5), "CORNER", "2", 4, false, 0),
    ("node", "4", (6, 1), "NEW NODE", "2", 5, false, 0),
    ("corner", "", (6, 0), "CORNER", "1", 5, false, 0),
    ("dead end", "", (7, 0), "DEAD END", "3", 5, true, 0),
    ("corner", "", (6, 0), "CORNER", "0", 5, true, 1),
    ("node", "4", (6, 1), "RETURN-KNOWN", "3", 5, false, 2),
    ("node", "5", (4, 1), "NEW NODE", "3", 6, false, 2),
    ("node", "6", (2, 1), "NEW NODE", "3", 7, false, 2),
    ("node", "1", (0, 1), "RETURN-UNKNOWN", "1", 7, true, 2),
    ("node", "6", (2, 1), "RETURN-KNOWN", "0", 7, false, 4),
    ("corner", "", (2, 3), "CORNER", "3", 7, false, 4),
    ("node", "2", (0, 3), "RETURN-UNKNOWN", "1", 7, true, 4),
    ("corner", "", (2, 3), "CORNER", "2", 7, true, 6),
    ("node", "6", (2, 1), "RETURN-KNOWN", "1", 6, true, 8),
    ("node", "5", (4, 1), "RETURN-KNOWN", "0", 6, false, 10),
    ("dead end", "", (4, 2), "DEAD END", "2", 6, true, 10),
    ("node", "5", (4, 1), "RETURN-KNOWN", "1", 5, true, 11),
    ("node", "4", (6, 1), "RETURN-KNOWN", "0", 4, true, 13),
    ("corner", "", (6, 5), "CORNER", "3", 4, true, 17),
    ("node", "3", (3, 5), "RETURN-KNOWN", "2", 4, false, 20),
    ("finish", "", (3, 4), "FINISH", "2", 4, false, 20),
];

/// Every remembered node after each stop: number, then for north, east, south and west how the way is
/// (`.` none, `o` unvisited, `v` visited, `x` crossed out), back path, place.
const NODES: [&str; 26] = [
    "",
    "1 vov. S 0,1",
    "1 vov. S 0,1 | 2 vov. S 0,3",
    "1 vov. S 0,1 | 2 vov. S 0,3",
    "1 vov. S 0,1 | 2 vov. S 0,3 | 3 .vov W 3,5",
    "1 vov. S 0,1 | 2 vov. S 0,3 | 3 .vov W 3,5",
    "1 vov. S 0,1 | 2 vov. S 0,3 | 3 .vov W 3,5 | 4 v.vo N 6,1",
    "1 vov. S 0,1 | 2 vov. S 0,3 | 3 .vov W 3,5 | 4 v.vo N 6,1",
    "1 vov. S 0,1 | 2 vov. S 0,3 | 3 .vov W 3,5 | 4 v.xo N 6,1",
    "1 vov. S 0,1 | 2 vov. S 0,3 | 3 .vov W 3,5 | 4 v.xo N 6,1",
    "1 vov. S 0,1 | 2 vov. S 0,3 | 3 .vov W 3,5 | 4 v.xv N 6,1",
    "1 vov. S 0,1 | 2 vov. S 0,3 | 3 .vov W 3,5 | 4 v.xv N 6,1 | 5 ov.v E 4,1",
    "1 vov. S 0,1 | 2 vov. S 0,3 | 3 .vov W 3,5 | 4 v.xv N 6,1 | 5 ov.v E 4,1 | 6 ov.v E 2,1",
    "1 vxv. S 0,1 | 2 vov. S 0,3 | 3 .vov W 3,5 | 4 v.xv N 6,1 | 5 ov.v E 4,1 | 6 ov.x E 2,1",
    "1 vxv. S 0,1 | 2 vov. S 0,3 | 3 .vov W 3,5 | 4 v.xv N 6,1 | 5 ov.v E 4,1 | 6 vv.x E 2,1",
    "1 vxv. S 0,1 | 2 vov. S 0,3 | 3 .vov W 3,5 | 4 v.xv N 6,1 | 5 ov.v E 4,1 | 6 vv.x E 2,1",
    "1 vxv. S 0,1 | 2 vxv. S 0,3 | 3 .vov W 3,5 | 4 v.xv N 6,1 | 5 ov.v E 4,1 | 6 xv.x E 2,1",
    "1 vxv. S 0,1 | 2 vxv. S 0,3 | 3 .vov W 3,5 | 4 v.xv N 6,1 | 5 ov.v E 4,1 | 6 xv.x E 2,1",
    "1 vxv. S 0,1 | 2 vxv. S 0,3 | 3 .vov W 3,5 | 4 v.xv N 6,1 | 5 ov.x E 4,1",
    "1 vxv. S 0,1 | 2 vxv. S 0,3 | 3 .vov W 3,5 | 4 v.xv N 6,1 | 5 vv.x E 4,1",
    "1 vxv. S 0,1 | 2 vxv. S 0,3 | 3 .vov W 3,5 | 4 v.xv N 6,1 | 5 xv.x E 4,1",
    "1 vxv. S 0,1 | 2 vxv. S 0,3 | 3 .vov W 3,5 | 4 v.xx N 6,1",
    "1 vxv. S 0,1 | 2 vxv. S 0,3 | 3 .xov W 3,5",
    "1 vxv. S 0,1 | 2 vxv. S 0,3 | 3 .xov W 3,5",
    "1 vxv. S 0,1 | 2 vxv. S 0,3 | 3 .xvv W 3,5",
    "1 vxv. S 0,1 | 2 vxv. S 0,3 | 3 .xvv W 3,5",
];

/// Milliseconds of driving a cell.
const CELL_MS: i32 = 400;

/// What the page shows at a moment, in the same words as [`expected`].
const SHOWN: &str = "() => {
    const text = (css) => document.querySelector(css)?.innerText.trim() ?? null;
    const ways = { 'no path': '.', unvisited: 'o', visited: 'v', 'crossed out': 'x' };
    const way = (span) => ways[span.title.split(': ')[1]];
    const row = (tr) => {
        const [number, state, back, place] = tr.cells;
        const ways = [...state.querySelectorAll('.d')].map(way).join('');
        const cells = place.innerText.split(', ').map((ms) => ms / 400).join();
        return `${number.innerText.match(/\\d+/)[0]} ${ways} ${back.innerText} ${cells}`;
    };
    const rows = [...document.querySelectorAll('.nodes tbody tr[data-node]')];
    const number = (css) => document.querySelector(css)?.dataset.node ?? '';
    const svg = document.querySelector('.canvas > svg.maze');
    const variable = (name) => text(`[data-var=${name}] > span`);
    return {
        stop: svg.dataset.stop,
        count: text('#count b'),
        slider: document.querySelector('[role=slider]').ariaValueNow,
        crossed: svg.dataset.crossed,
        case: text('#said .case'),
        ptr: variable('ptr'),
        returning: variable('returning'),
        bot_dir: variable('bot_dir').split(' ')[0],
        cur: `${variable('cur_x')},${variable('cur_y')}`,
        here: number('.nodes tr.here'),
        disc: number('.maze .node.here'),
        discs: [...document.querySelectorAll('.maze .node')].map((node) => node.dataset.node).sort().join(),
        nodes: rows.map(row).join(' | '),
    };
}";

/// What the page has to show when a stop is over.
fn expected(stop: u32) -> Value {
    let (_, node, (x, y), case, leaves, ptr, returning, crossed) = STOPS_TABLE[stop as usize];
    // A node that was just forgotten has no row and no disc.
    let here = if node.parse().is_ok_and(|node: u32| node < ptr) { node } else { "" };
    let discs = (1..ptr).map(|node| node.to_string()).collect::<Vec<_>>().join(",");
    json!({
        "stop": stop.to_string(),
        "count": stop.to_string(),
        "slider": stop.to_string(),
        "crossed": crossed.to_string(),
        "case": case,
        "ptr": ptr.to_string(),
        "returning": returning.to_string(),
        "bot_dir": leaves,
        "cur": format!("{},{}", x * CELL_MS, y * CELL_MS),
        "here": here,
        "disc": here,
        "discs": discs,
        "nodes": NODES[stop as usize],
    })
}

/// Checks everything that the page shows of a stop.
pub(crate) async fn shows_stop(page: &Page, stop: u32) -> Result<()> {
    let shown = page.call(SHOWN, &[]).await.with_context(|| format!("looking at stop {stop}"))?;
    let expected = expected(stop);
    for (what, value) in expected.as_object().into_iter().flatten() {
        assert_eq!(&shown[what], value, "{what} at stop {stop}");
    }
    Ok(())
}

/// Steps on to the end by key, and checks every stop.
pub(crate) async fn steps_to_the_end(page: &Page) -> Result<()> {
    page.press("Home").await?;
    shows_stop(page, 0).await?;
    for stop in 1..=STOPS {
        page.press("ArrowRight").await?;
        shows_stop(page, stop).await?;
    }
    Ok(())
}
