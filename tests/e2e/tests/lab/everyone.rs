//! For everybody: every size, keyboard, screen readers, both themes, projector.

use std::collections::BTreeSet;
use std::path::PathBuf;

use anyhow::{Context, Result};
use e2e::{Page, Setup, lab, root};
use serde_json::{Value, json};

use crate::drawing::from_menu;

/// The dialogs that a key or a button of the head opens.
const DIALOGS: [&str; 3] = ["Keys", "Share", "Settings of the run: Book · S → R → L"];

/// What is cut off at a side, or smaller than a finger, or makes the page scroll sideways.
const TROUBLES: &str = "() => {
    const troubles = [];
    const { scrollWidth, clientWidth } = document.documentElement;
    if (scrollWidth > clientWidth) {
        const wide = [...document.querySelectorAll('body *')].filter((element) => element.getBoundingClientRect().right > clientWidth + 0.5);
        const names = wide.map((element) => `${element.tagName}.${element.className?.baseVal ?? element.className}`).slice(0, 12);
        troubles.push(`the page is ${scrollWidth} wide in a window of ${clientWidth}: ${names.join(', ')}`);
    }
    const { bottom } = document.querySelector('.app').getBoundingClientRect();
    const empty = document.documentElement.scrollHeight - scrollY - Math.max(bottom, innerHeight);
    if (empty > 1) troubles.push(`the page goes on for ${empty} below its end`);
    const scrolls = (element) => element && (/auto|scroll/.test(getComputedStyle(element).overflowX)
        && element.scrollWidth > element.clientWidth || scrolls(element.parentElement));
    const controls = 'button, a[href], input, select, textarea, summary, [role=slider], [role=button]';
    // Names in code, in table heads and in sentences are words, not buttons; each has a larger twin.
    const words = '.name, .noderef, .vh, .vh *, p a';
    for (const control of document.querySelectorAll(controls)) {
        if (control.matches(words) || !control.checkVisibility({ visibilityProperty: true })) continue;
        const target = control.matches('[type=checkbox], [type=radio]') ? control.closest('label') : control;
        const { left, right, width, height } = target.getBoundingClientRect();
        const name = `${control.tagName} “${(control.ariaLabel ?? control.innerText ?? '').trim()}” ${control.className}`;
        if (width < 39.5 || height < 39.5) troubles.push(`${name} is ${width.toFixed()}×${height.toFixed()}`);
        if ((left < -0.5 || right > clientWidth + 0.5) && !scrolls(control.parentElement)) troubles.push(`${name} sticks out: ${left} to ${right}`);
    }
    return troubles;
}";

#[tokio::test]
async fn everything_fits_a_laptop() -> Result<()> {
    everything_fits(Setup::default(), "laptop").await
}

#[tokio::test]
async fn everything_fits_a_tablet() -> Result<()> {
    everything_fits(Setup::default().size(1024, 768), "tablet").await
}

#[tokio::test]
async fn everything_fits_a_phone() -> Result<()> {
    everything_fits(Setup::default().touch().size(390, 844), "phone").await
}

/// Goes through everything, and looks at each.
async fn tour(page: &Page, name: &str, look: &mut impl AsyncFnMut(&str) -> Result<()>) -> Result<()> {
    look("the start").await?;
    page.press_times("PageDown", 13).await?;
    page.click_css(".errata-notes > summary").await?;
    look("stop 13").await?;
    page.screenshot(&format!("step-{name}")).await?;
    page.press("End").await?;
    page.click("C array").await?;
    look("the finish").await?;
    for key in ["?", "g", "o"] {
        page.press(key).await?;
        page.wait_for("dialog[open]").await?;
        look(key).await?;
        page.leave_dialog().await?;
    }
    page.click_css("header [aria-label=Share]").await?;
    page.wait_for("dialog .qr").await?;
    look("the share dialog").await?;
    page.leave_dialog().await?;
    for title in
        ["Direction sums, right first", "Full mapping", "Cornell 3, with path planning", "Trémaux’s marks"]
    {
        page.press("o").await?;
        page.choose("#explorer-name", title).await?;
        page.leave_dialog().await?;
        page.wait_until(&format!("document.querySelector('#explorer').ariaLabel.includes('{title}')"))
            .await?;
        page.wait_for("#inspector").await?;
        page.press("End").await?;
        page.wait_for("#result").await?;
        look(title).await?;
    }
    page.press("t").await?;
    page.wait_for("dialog #leads").await?;
    look("the turn-list lab").await?;
    page.leave_dialog().await?;
    page.press("p").await?;
    page.wait_for(".projector").await?;
    look("the projector").await?;
    page.press("1").await?;
    page.wait_for("#drawing").await?;
    look("Draw").await?;
    page.screenshot(&format!("draw-{name}")).await?;
    page.click("Generate").await?;
    page.wait_for("#gen-width").await?;
    look("the generator").await?;
    page.click("Close the generator").await?;
    page.wait_for_no(".generator").await?;
    from_menu(page, "New…").await?;
    page.wait_for("dialog[open] #new-width").await?;
    look("a new maze").await?;
    page.leave_dialog().await?;
    page.click_css("#drawn-as button:nth-child(2)").await?;
    page.wait_for("#drawing svg.walls").await?;
    look("walls").await?;
    page.screenshot(&format!("walls-{name}")).await?;
    page.press("2").await?;
    page.wait_for("svg.maze.walls[data-stop]").await?;
    look("walls, stepped").await?;
    page.press("3").await?;
    page.wait_for(".run[data-nth='2']").await?;
    look("Compare").await?;
    page.screenshot(&format!("compare-{name}")).await?;
    page.press("4").await?;
    page.wait_for("#demo").await?;
    look("Connect").await?;
    page.click("Demo robot").await?;
    page.wait_until("document.querySelectorAll('.log li[data-line]').length > 5").await?;
    look("Connect, with a robot").await?;
    page.screenshot(&format!("connect-{name}")).await
}

async fn everything_fits(setup: Setup, device: &str) -> Result<()> {
    lab(setup, async |page| {
        let mut found = BTreeSet::new();
        let mut look = async |what: &str| -> Result<()> {
            let troubles = page.call(TROUBLES, &[]).await?;
            found.extend(
                troubles.as_array().into_iter().flatten().map(|trouble| format!("{what}: {trouble}")),
            );
            Ok(())
        };
        tour(page, device, &mut look).await?;
        assert!(found.is_empty(), "{}", found.into_iter().collect::<Vec<_>>().join("\n"));
        Ok(())
    })
    .await
}

/// Findings of axe-core that keep somebody from using the page.
async fn barriers(page: &Page) -> Result<Vec<String>> {
    const RUN: &str = "axe.run(document, { resultTypes: ['violations'] }).then(({ violations }) => violations\
        .filter(({ impact }) => impact === 'serious' || impact === 'critical')\
        .flatMap(({ id, nodes }) => nodes.map((node) => `${id}: ${node.html.slice(0, 160)} ${node.failureSummary}`)))";
    if page.eval("typeof axe").await? == "undefined" {
        page.run(
            &std::fs::read_to_string(axe()).context("reading axe-core; `cargo xtask test e2e` gets it")?,
        )
        .await?;
    }
    let found = page.promised(RUN).await?;
    Ok(found
        .as_array()
        .into_iter()
        .flatten()
        .map(|text| text.as_str().unwrap_or_default().to_owned())
        .collect())
}

fn axe() -> PathBuf {
    std::env::var_os("AXE_CORE")
        .map_or_else(|| root().join("target/tools/node_modules/axe-core/axe.min.js"), PathBuf::from)
}

async fn has_no_barriers(theme: &'static str) -> Result<()> {
    lab(Setup::default().media("prefers-color-scheme", theme), async |page| {
        let mut found = BTreeSet::new();
        let mut look = async |what: &str| -> Result<()> {
            found.extend(barriers(page).await?.into_iter().map(|barrier| format!("{what}: {barrier}")));
            Ok(())
        };
        assert_eq!(page.attribute("html", "data-theme").await?, theme);
        tour(page, theme, &mut look).await?;
        assert!(found.is_empty(), "{}", found.into_iter().collect::<Vec<_>>().join("\n\n"));
        Ok(())
    })
    .await
}

#[tokio::test]
async fn the_light_page_has_no_barriers() -> Result<()> {
    has_no_barriers("light").await
}

#[tokio::test]
async fn the_dark_page_has_no_barriers() -> Result<()> {
    has_no_barriers("dark").await
}

#[tokio::test]
async fn the_theme_is_chosen_and_kept() -> Result<()> {
    lab(Setup::default().media("prefers-color-scheme", "dark"), async |page| {
        let is = async |theme: &str| {
            page.wait_until(&format!("document.documentElement.dataset.theme === '{theme}'")).await
        };
        is("dark").await?;
        page.click("Theme: by system").await?;
        is("light").await?;
        page.reload().await?;
        is("light").await?;
        page.click("Theme: light").await?;
        is("dark").await?;
        page.click("Theme: dark").await?;
        page.tools(
            "Emulation.setEmulatedMedia",
            json!({ "features": [{ "name": "prefers-color-scheme", "value": "light" }] }),
        )
        .await?;
        is("light").await?;
        page.wait_for("[aria-label='Theme: by system']").await
    })
    .await
}

#[tokio::test]
async fn the_projector_shows_maze_sentence_and_controls() -> Result<()> {
    lab(Setup::default().size(1280, 720), async |page| {
        page.press_times("PageDown", 13).await?;
        page.press("p").await?;
        page.wait_for(".projector").await?;
        for gone in [".top", ".nodes", ".code", ".vars", "[role=slider]", "[aria-label=Speed]"] {
            assert!(!page.sees(gone).await?, "{gone} is on the projector");
        }
        assert!(page.sees(".projector .maze").await? && page.sees(".transport").await?);
        assert!(page.text(".projector .words").await?.contains("RETURN-UNKNOWN"));
        let large =
            "parseFloat(getComputedStyle(document.querySelector('.projector .words p')).fontSize) >= 32";
        assert_eq!(page.eval(large).await?, true);
        page.screenshot("projector").await?;
        page.press("PageDown").await?;
        page.wait_for_text(".projector .words", "RETURN-KNOWN").await?;
        page.press("Escape").await?;
        page.wait_for_no(".projector").await?;
        page.wait_for("svg.maze[data-stop='14']").await?;
        page.click("Projector").await?;
        page.wait_for(".projector").await?;
        page.click("Leave").await?;
        page.wait_for_no(".projector").await
    })
    .await
}

#[tokio::test]
async fn dialogs_take_the_focus_and_give_it_back() -> Result<()> {
    lab(Setup::default(), async |page| {
        for dialog in DIALOGS {
            page.click(dialog).await?;
            page.wait_for("dialog[open]").await?;
            assert_eq!(page.eval("!!document.activeElement.closest('dialog')").await?, true, "{dialog}");
            // The focus goes round inside.
            for _ in 0..12 {
                page.press("Tab").await?;
                let inside =
                    "document.activeElement === document.body || !!document.activeElement.closest('dialog')";
                assert_eq!(page.eval(inside).await?, true, "{dialog}");
            }
            page.leave_dialog().await?;
            let back = page.focused().await?;
            let back = back.split(" (").next().unwrap_or_default().replace('\n', " ");
            assert_eq!(back.split_whitespace().collect::<Vec<_>>().join(" "), dialog);
        }
        page.press("?").await?;
        page.wait_for_text("dialog", "presenter remote").await?;
        page.click("Close").await?;
        page.wait_for_no("dialog").await
    })
    .await
}

#[tokio::test]
async fn tab_reaches_everything_and_shows_where_it_is() -> Result<()> {
    const WHERE: &str = "() => {
        const at = document.activeElement;
        if (!at || at === document.body) return null;
        const { outlineStyle, outlineWidth } = getComputedStyle(at);
        const name = (at.ariaLabel ?? at.innerText).trim().replace(/\\s+/g, ' ');
        return [name, outlineStyle !== 'none' && parseFloat(outlineWidth) >= 2];
    }";
    lab(Setup::default(), async |page| {
        let mut reached = BTreeSet::new();
        for _ in 0..40 {
            page.press("Tab").await?;
            let at = page.call(WHERE, &[]).await?;
            if at == Value::Null {
                break;
            }
            let name = at[0].as_str().unwrap_or_default().to_owned();
            assert_eq!(at[1], true, "the focus can’t be seen on {name}");
            reached.insert(name);
        }
        let wanted = [
            "Skip to the maze",
            "Draw",
            "Step",
            "Settings of the run: Book · S → R → L",
            "Projector (P)",
            "Share",
            "Keys (?)",
            "Theme: by system",
            "Zoom in",
            "Play (Space)",
            "Forward (→)",
            "Stop",
            "Kind of event",
            "Speed",
        ];
        let missed: Vec<_> = wanted.iter().filter(|name| !reached.contains(**name)).collect();
        assert!(missed.is_empty(), "{missed:?} not among {reached:?}");
        Ok(())
    })
    .await
}

#[tokio::test]
async fn a_screen_reader_hears_every_stop() -> Result<()> {
    lab(Setup::default(), async |page| {
        assert_eq!(page.attribute("#said", "role").await?, "status");
        assert_eq!(page.attribute("#said", "aria-live").await?, "polite");
        page.eval(
            "(window.heard = 0, new MutationObserver(() => heard++).observe(document.getElementById('said'), \
             { childList: true, characterData: true, subtree: true }))",
        )
        .await?;
        let mut before = page.text("#said").await?;
        for stop in 1..=5 {
            page.press("ArrowRight").await?;
            page.wait_until(&format!("heard >= {stop}")).await?;
            let now = page.text("#said").await?;
            assert_ne!(now, before);
            before = now;
        }
        let picture = page.attribute("svg.maze[data-stop]", "aria-label").await?;
        assert_eq!(picture, "Maze at stop 5 of 25: the bot is at 6,5, facing south; 0 cells are crossed out");
        assert_eq!(page.attribute("[role=slider]", "aria-valuetext").await?, "stop 5: corner");
        Ok(())
    })
    .await
}
