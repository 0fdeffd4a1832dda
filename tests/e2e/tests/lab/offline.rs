//! What is fetched when: little at first, all of it for later, a new version when a person wants it.

use anyhow::Result;
use e2e::{Page, Setup, Site, lab, lab_at};

use crate::figure_3_1::steps_to_the_end;

#[tokio::test]
async fn after_one_visit_no_network_is_needed() -> Result<()> {
    let site = Site::start().await?;
    lab_at(&site, Setup::default(), async |page| {
        page.wait_until("document.documentElement.dataset.offline === 'ready'").await?;
        site.stop().await?;
        page.reload().await?;
        steps_to_the_end(page).await?;
        page.press("1").await?;
        page.wait_for("#drawing").await?;
        page.reload().await?;
        page.wait_for("#drawing").await?;
        page.press("g").await?;
        page.wait_for("dialog #name-ptr").await
    })
    .await
}

#[tokio::test]
async fn a_first_visit_fetches_only_what_it_shows() -> Result<()> {
    lab(Setup::default(), async |page| {
        let fetched = "performance.getEntriesByType('resource').map(entry => entry.name).filter(name => name.endsWith('.wasm'))";
        let parts = page.eval(&format!("{fetched}.join(' ')")).await?;
        let parts = parts.as_str().unwrap_or_default();
        assert!(parts.ends_with("_bg.wasm") && !parts.contains(' '), "{parts}");
        page.press("1").await?;
        page.wait_for("#drawing").await?;
        page.wait_until(&format!("{fetched}.some(name => name.includes('draw'))")).await
    })
    .await
}

/// Comes when one version is left.
const ONE_KEPT: &str = "(async () => {
    while ((await caches.keys()).length > 1) await new Promise((done) => setTimeout(done, 20));
})()";

/// The versions that the browser keeps.
async fn kept(page: &Page) -> Result<Vec<String>> {
    Ok(serde_json::from_value(page.promised("caches.keys()").await?)?)
}

#[tokio::test]
async fn a_new_version_waits_until_a_person_wants_it() -> Result<()> {
    let site = Site::start().await?;
    lab_at(&site, Setup::default(), async |page| {
        page.wait_until("document.documentElement.dataset.offline === 'ready'").await?;
        page.press_times("PageDown", 3).await?;
        site.change("sw.js", "const VERSION = \"", "const VERSION = \"next ");
        page.reload().await?;
        page.wait_for_text(".toast", "A new version is here").await?;
        page.screenshot("new-version").await?;
        assert_eq!(kept(page).await?.len(), 2, "both versions are kept until then");
        page.click("Use it").await?;
        // The old version's copy goes, and the page is the new one's.
        page.promised(ONE_KEPT).await?;
        assert!(kept(page).await?[0].contains("next"));
        page.wait_until("!document.querySelector('.toast')").await?;
        steps_to_the_end(page).await
    })
    .await
}

/// Holds back the part of the page with the errata until `window.release()`.
const HELD: &str = "
    const fetched = window.fetch.bind(window);
    const released = new Promise((resolve) => { window.release = resolve; });
    window.fetch = async (...asked) => {
        if (String(asked[0]?.url ?? asked[0]).includes('errata')) { window.held = true; await released; }
        return fetched(...asked);
    };";

#[tokio::test]
async fn a_part_that_comes_when_its_place_is_gone_is_not_shown() -> Result<()> {
    lab(Setup::default().script(HELD), async |page| {
        page.press_times("PageDown", 13).await?;
        page.wait_until("window.held").await?;
        page.press("p").await?;
        page.wait_for(".projector").await?;
        page.run("window.release()").await?;
        page.wait_until(
            "performance.getEntriesByType('resource').some(entry => /errata.*wasm/.test(entry.name))",
        )
        .await?;
        page.press("p").await?;
        page.wait_for(".errata-notes > summary").await?;
        page.press("ArrowRight").await?;
        page.wait_for_text("#count", "stop 14 /").await
    })
    .await
}
