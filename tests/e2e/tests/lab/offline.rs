//! Without a network, after one visit.

use anyhow::Result;
use e2e::{Setup, Site, lab_at};

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
