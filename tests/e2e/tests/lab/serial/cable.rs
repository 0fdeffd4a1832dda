//! The cable pulled and plugged in again.

use anyhow::Result;
use e2e::Page;

use super::{connect, explore, state, states, with};

/// Everything that a new connection asks has been answered.
async fn all_read(page: &Page) -> Result<()> {
    page.wait_until("document.querySelector('#tune-line4')?.value === '400'").await
}

#[tokio::test]
async fn a_cable_pulled_in_a_run_is_seen_and_the_robot_found_again() -> Result<()> {
    with(&[], async |page, bench| {
        connect(page).await?;
        state(page, "ready").await?;
        explore(page).await?;
        page.wait_until("/[2-9] stops, driving/.test(document.querySelector('.note.guest')?.innerText)")
            .await?;
        bench.unplug()?;
        page.wait_for_text(".note.guest", "connection lost").await?;
        page.wait_for_text("#cure", "plug the cable in again").await?;
        bench.plug(&[])?;
        state(page, "ready").await?;
        page.wait_for_text("#news", "put it back at the start").await?;
        page.wait_for_text(".note.guest", "connection lost").await?;
        let states = states(page).await?;
        assert!(states.contains("running, lost"), "{states}");
        // What was monitored is kept, and it drives again once it is put back.
        page.fill("#filter", "run explore").await?;
        page.wait_until("document.querySelectorAll('.log li[data-line]').length === 1").await?;
        explore(page).await
    })
    .await
}

/// The robot's answer to a line of the upload does not come, then the cable is pulled.
async fn pulled_after(line: &str, says: &str) -> Result<()> {
    with(&["cut", line], async |page, bench| {
        connect(page).await?;
        state(page, "ready").await?;
        all_read(page).await?;
        page.click("Send").await?;
        page.fill("#filter", line).await?;
        page.wait_for_text(".log", line).await?;
        bench.unplug()?;
        page.wait_for_text("#cure", "plug the cable in again").await?;
        page.wait_for_text("#sent", says).await?;
        // This one has never kept a list.
        bench.plug(&[])?;
        state(page, "ready").await?;
        page.wait_for_text("#list-robot", "none").await?;
        page.wait_for_text("#sent", "old list").await
    })
    .await
}

#[tokio::test]
async fn a_cable_pulled_in_an_upload_leaves_the_old_list() -> Result<()> {
    pulled_after("turns data", "still holds its old list").await
}

#[tokio::test]
async fn a_cable_pulled_at_the_end_of_an_upload_leaves_it_to_the_robot_which_list_it_holds() -> Result<()> {
    pulled_after("turns commit", "reading the robot’s list will tell").await
}
