//! How the page looks: at every width and font size, in forced colours, without motion, from afar; and where its
//! messages stand.

use anyhow::Result;
use e2e::{Page, Setup, lab};
use serde_json::json;

const ROOMS: [&str; 5] = ["draw", "step", "compare", "league", "connect"];

/// What sticks out of the window, or is cut: controls anywhere, and the page itself.
const STICKS_OUT: &str = "(() => {
    const width = document.documentElement.clientWidth, out = [];
    if (document.documentElement.scrollWidth > width) out.push(`the page scrolls sideways to ${document.documentElement.scrollWidth}`);
    const scrolled = (element) => {
        for (let at = element.parentElement; at; at = at.parentElement)
            if (/auto|scroll/.test(getComputedStyle(at).overflowX) && at.scrollWidth > at.clientWidth) return true;
    };
    for (const control of document.querySelectorAll('button, a, input, select, summary, h2')) {
        const { left, right, width: wide } = control.getBoundingClientRect();
        if (!control.checkVisibility() || control.matches('.vh, .vh *') || !wide || scrolled(control)) continue;
        if (left < -1 || right > width + 1) out.push(`${control.ariaLabel ?? control.innerText} is at ${left} to ${right}`);
    }
    return out.join('; ');
})()";

async fn resize(page: &Page, width: u32, height: u32) -> Result<()> {
    let metrics = json!({ "width": width, "height": height, "deviceScaleFactor": 1, "mobile": false });
    page.tools("Emulation.setDeviceMetricsOverride", metrics).await?;
    page.wait_until(&format!("innerWidth === {width}")).await
}

/// Sweeps the widths, and says where something sticks out.
async fn sweep(page: &Page, room: &str, widths: impl Iterator<Item = u32>) -> Result<Vec<String>> {
    let mut faults = Vec::new();
    for width in widths {
        resize(page, width, 900).await?;
        let out = page.eval(STICKS_OUT).await?;
        if out != "" {
            faults.push(format!("{room} at {width}: {out}"));
        }
        let head = page.eval("document.querySelector('.head').offsetHeight / parseFloat(getComputedStyle(document.documentElement).fontSize)").await?;
        if head.as_f64().is_none_or(|rem| rem > 4.0) {
            faults.push(format!("{room} at {width}: the head is {head} rem high"));
        }
    }
    Ok(faults)
}

#[tokio::test]
async fn nothing_scrolls_sideways_at_any_width() -> Result<()> {
    let mut faults = Vec::new();
    for room in ROOMS {
        lab(Setup::default().at(room), async |page| {
            page.wait_for("main.main").await?;
            faults.extend(sweep(page, room, (320..=1920).step_by(20)).await?);
            Ok(())
        })
        .await?;
    }
    assert!(faults.is_empty(), "{}", faults.join("\n"));
    Ok(())
}

#[tokio::test]
async fn nothing_sticks_out_at_larger_font_sizes() -> Result<()> {
    let mut faults = Vec::new();
    for font in [20_u32, 24] {
        for room in ROOMS {
            lab(Setup::default().at(room), async |page| {
                let sizes = json!({ "fontSizes": { "standard": font, "fixed": font * 13 / 16 } });
                page.tools("Page.setFontSizes", sizes).await?;
                page.wait_until(&format!(
                    "getComputedStyle(document.documentElement).fontSize === '{font}px'"
                ))
                .await?;
                page.wait_for("main.main").await?;
                faults.extend(sweep(page, room, [768, 1024, 1366, 1440, 1920].into_iter()).await?);
                let tap = "[...document.querySelectorAll('.head .btn')].filter((button) => button.checkVisibility())
                    .every((button) => button.offsetHeight >= 2.5 * parseFloat(getComputedStyle(document.documentElement).fontSize) - 1)";
                page.wait_until(tap).await
            })
            .await?;
        }
    }
    assert!(faults.is_empty(), "{}", faults.join("\n"));
    Ok(())
}

#[tokio::test]
async fn every_tool_is_reachable_on_a_phone() -> Result<()> {
    lab(Setup::default().size(390, 844), async |page| {
        page.click("More").await?;
        for tool in ["Projector", "Share", "Keys", "Theme: by system"] {
            page.wait_until(&format!(
                "[...document.querySelectorAll('.tools-more button')].some((button) => button.checkVisibility() && button.ariaLabel.startsWith('{tool}'))"
            ))
            .await?;
        }
        page.press("Escape").await?;
        page.wait_until("!document.querySelector('#tools').checkVisibility()").await?;
        assert_eq!(page.focused().await?, "More");
        page.click("Room: Step").await?;
        page.click("Compare").await?;
        page.wait_for("main.compare").await?;
        page.wait_until("!document.querySelector('#rooms').checkVisibility()").await
    })
    .await
}

#[tokio::test]
async fn a_message_covers_nothing_and_ends_with_what_it_speaks_of() -> Result<()> {
    const MAZE: &str = "line-maze: 1\n\n+---+---F\n|        \n^   .   .\n";
    const COVERED: &str = "(() => {
        const toast = document.querySelector('.toast').getBoundingClientRect();
        return [...document.querySelectorAll('.canvas, .zoom, .floor, footer, .transport')].filter((element) => {
            const box = element.getBoundingClientRect();
            return box.left < toast.right && box.right > toast.left && box.top < toast.bottom && box.bottom > toast.top;
        }).map((element) => element.className).join(' ');
    })()";
    for (width, height) in [(1440, 900), (1366, 768), (1024, 768), (820, 1180), (390, 844), (844, 390)] {
        for room in ["draw", "step", "compare", "connect"] {
            lab(Setup::default().size(width, height).at(room), async |page| {
                page.wait_for("main.main").await?;
                page.paste("no maze at all").await?;
                page.wait_for(".toast[role=alert]").await?;
                assert_eq!(page.eval(COVERED).await?, "", "{room} at {width}");
                // What could not be read is over once something could.
                page.paste(MAZE).await?;
                page.wait_for(".toast[role=status]").await?;
                assert_eq!(page.eval(COVERED).await?, "", "{room} at {width}");
                page.press("Control+Z").await?;
                page.wait_until("!document.querySelector('.toast')?.innerText.includes('Opened')").await
            })
            .await?;
        }
    }
    lab(Setup::default(), async |page| {
        page.paste("no maze at all").await?;
        page.wait_for(".toast[role=alert]").await?;
        page.press("1").await?;
        page.wait_for_no(".toast").await
    })
    .await
}

#[tokio::test]
async fn less_motion_counts_when_it_is_asked_for_meanwhile() -> Result<()> {
    let wants = |value: &str| json!({ "features": [{ "name": "prefers-reduced-motion", "value": value }] });
    lab(Setup::default().with_motion(), async |page| {
        let bot = "document.querySelector('.bot').getAttribute('transform')";
        page.run("window.seen = new Set(); new MutationObserver(() => window.seen.add(document.querySelector('.bot').getAttribute('transform'))).observe(document.querySelector('.bot'), { attributes: true })").await?;
        page.press("PageDown").await?;
        page.wait_until(&format!("window.seen.size > 2 && {bot}")).await?;
        page.wait_for_text("#count", "stop 1 /").await?;
        page.tools("Emulation.setEmulatedMedia", wants("reduce")).await?;
        page.wait_until("matchMedia('(prefers-reduced-motion: reduce)').matches").await?;
        page.run("window.seen.clear()").await?;
        page.press("PageDown").await?;
        page.wait_for_text("#count", "stop 2 /").await?;
        page.wait_until("window.seen.size > 0").await?;
        assert!(page.eval("window.seen.size").await?.as_u64().is_some_and(|seen| seen <= 2), "it was seen to drive");
        page.tools("Emulation.setEmulatedMedia", wants("no-preference")).await?;
        page.wait_until("!matchMedia('(prefers-reduced-motion: reduce)').matches").await?;
        page.run("window.seen.clear()").await?;
        page.press("PageDown").await?;
        page.wait_until("window.seen.size > 2").await
    })
    .await
}

#[tokio::test]
async fn forced_colours_leave_a_shape_to_everything_that_means_something() -> Result<()> {
    lab(Setup::default().media("forced-colors", "active"), async |page| {
        page.press_times("PageDown", 13).await?;
        page.wait_for_text("#count", "stop 13 /").await?;
        let style = async |css: &str, of: &str| {
            page.call(
                "(css, of) => getComputedStyle(document.querySelector(css))[of]",
                &[json!(css), json!(of)],
            )
            .await
        };
        let differ = async |one: &str, other: &str, of: &str| -> Result<()> {
            assert_ne!(
                style(one, of).await?,
                style(other, of).await?,
                "{one} and {other} have the same {of}"
            );
            Ok(())
        };
        differ(".top nav a[aria-current]", ".top nav a:not([aria-current])", "backgroundColor").await?;
        differ(".seg [aria-pressed=true]", ".seg [aria-pressed=false]", "backgroundColor").await?;
        differ(".var.changed", ".var:not(.changed)", "borderTopStyle").await?;
        differ(".d.seen", ".d.on", "backgroundColor").await?;
        differ(".d.x", ".d.on", "borderTopStyle").await?;
        differ(".nodes tr.here td", ".nodes tr:not(.here) td", "borderTopWidth").await?;
        differ(".code .ran", ".code li:not(.ran, .next)", "borderLeftWidth").await?;
        differ(".code .next", ".code li:not(.ran, .next)", "borderLeftStyle").await?;
        differ(".canvas .tape", ".canvas .remembered", "stroke").await?;
        differ(".canvas .cross-mark", ".canvas .cross-halo", "stroke").await?;
        differ(".canvas .bot-body", ".canvas .tape", "fill").await?;
        page.screenshot("forced-colours-step").await
    })
    .await
}

#[tokio::test]
async fn six_mazes_are_whole_between_head_and_transport() -> Result<()> {
    for (width, height) in [(1440, 900), (1366, 768)] {
        lab(Setup::default().size(width, height).at("compare"), async |page| {
            page.wait_for("main.compare").await?;
            for (count, name) in [(4, "tremaux"), (5, "right-hand"), (6, "flood-fill")] {
                page.click(&format!("{} explorers…", count - 1)).await?;
                page.click_css(&format!("dialog input[value={name}]")).await?;
                page.leave_dialog().await?;
                page.wait_until(&format!("document.querySelectorAll('.run').length === {count}")).await?;
                page.run("scrollTo(0, 0)").await?;
                let whole = "(() => {
                    const foot = document.querySelector('footer').getBoundingClientRect().top;
                    const inside = (inner, outer) => inner.top >= outer.top && inner.bottom <= outer.bottom + 1 && inner.left >= outer.left && inner.right <= outer.right + 1;
                    return [...document.querySelectorAll('.run')].every((run) => {
                        const card = run.getBoundingClientRect();
                        const parts = ['.floor', '.say', '.btn'].map((css) => run.querySelector(css));
                        return card.bottom <= foot && run.querySelector('.floor').offsetHeight >= 120
                            && parts.every((part) => inside(part.getBoundingClientRect(), card))
                            && run.querySelector('.say').scrollHeight <= run.querySelector('.say').clientHeight;
                    });
                })()";
                page.wait_until(whole).await?;
            }
            page.screenshot(&format!("compare-six-{width}")).await
        })
        .await?;
    }
    Ok(())
}

/// A maze of this many points a side: one long line up and down.
fn serpentine(side: usize) -> String {
    let mut text = String::from("line-maze: 1\n\n");
    for row in (0..side).rev() {
        let mark = |column: usize| match (row, column) {
            (0, 0) => '^',
            _ if row + 1 == side && column + 1 == side => 'F',
            _ => '+',
        };
        for column in 0..side {
            text.push(mark(column));
            let joined = if column % 2 == 0 { row + 1 == side } else { row == 0 };
            text.push_str(if column + 1 == side {
                ""
            } else if joined {
                "---"
            } else {
                "   "
            });
        }
        text.push('\n');
        if row > 0 {
            text.push_str(&vec!["|"; side].join("   "));
            text.push('\n');
        }
    }
    text
}

#[tokio::test]
async fn a_trail_is_seen_in_the_largest_maze() -> Result<()> {
    lab(Setup::default(), async |page| {
        page.paste(&serpentine(200)).await?;
        page.wait_for(".canvas.far").await?;
        let wide = |css: &str| {
            format!(
                "(() => {{
                    const path = document.querySelector('{css}');
                    return path && parseFloat(getComputedStyle(path).strokeWidth) * path.getScreenCTM().a;
                }})()"
            )
        };
        page.press("End").await?;
        page.wait_until(&format!("{} >= 1.5", wide(".canvas .remembered"))).await?;
        page.wait_until(&format!("{} > {}", wide(".canvas .remembered"), wide(".canvas .tape"))).await?;
        page.press("3").await?;
        page.wait_for(".floor.far").await?;
        page.press("End").await?;
        page.wait_until(&format!("{} >= .9", wide(".floor .remembered"))).await
    })
    .await
}

#[tokio::test]
async fn paper_is_light_and_shows_all_of_it_and_no_buttons() -> Result<()> {
    for room in ["step", "draw", "compare"] {
        lab(Setup::default().media("prefers-color-scheme", "dark").at(room), async |page| {
            page.wait_for("main.main").await?;
            page.wait_until("document.documentElement.dataset.theme === 'dark'").await?;
            if room == "step" {
                page.press_times("PageDown", 13).await?;
                page.wait_for_text("#count", "stop 13 /").await?;
            }
            let paper = json!({ "media": "print", "features": [{ "name": "prefers-color-scheme", "value": "dark" }] });
            page.tools("Emulation.setEmulatedMedia", paper).await?;
            // A sheet of A4 without its margins.
            resize(page, 703, 1031).await?;
            page.wait_until("getComputedStyle(document.body).backgroundColor === 'rgb(255, 255, 255)'").await?;
            let seen = "[...document.querySelectorAll('header, footer, .zoom, .tools, main .btn, main .seg')]
                .filter((element) => element.checkVisibility()).map((element) => element.outerHTML.slice(0, 80)).join(' ')";
            assert_eq!(page.eval(seen).await?, "", "{room} prints what can only be pressed");
            let cut = "[...document.querySelectorAll('main, main .card, main .stage, main .scroll, main .code')]
                .filter((box) => box.checkVisibility() && (box.scrollHeight > box.clientHeight + 1 || box.scrollWidth > box.clientWidth + 1)
                    && getComputedStyle(box).overflow !== 'visible')
                .map((box) => box.className).join(' ')";
            assert_eq!(page.eval(cut).await?, "", "{room} is cut");
            page.wait_until("document.documentElement.scrollWidth <= 703").await?;
            page.screenshot(&format!("paper-{room}")).await
        })
        .await?;
    }
    Ok(())
}

#[tokio::test]
async fn a_long_table_is_whole_on_paper() -> Result<()> {
    lab(Setup::default(), async |page| {
        page.paste(include_str!("../../../../mazes/sixty-one-nodes.maze")).await?;
        page.press("End").await?;
        page.wait_for(".nodes tr[data-node]").await?;
        page.tools("Emulation.setEmulatedMedia", json!({ "media": "print" })).await?;
        page.wait_until("!document.querySelector('.nodes .gap') && document.querySelectorAll('.nodes tr[data-node]').length > 1").await
    })
    .await
}
