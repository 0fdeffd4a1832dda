//! What the room *Connect* says of a connection that is over, of a list that is another by now, of a run that a
//! recording does not finish; settings as they are typed; and the robot's stop in the other rooms.

use anyhow::Result;
use e2e::{Page, Setup, lab};
use serde_json::json;

use crate::connect::{demo, explore, state};

/// Another maze than figure 3.1, with another turn list.
const OTHER: &str = include_str!("../../../../mazes/book-2-4.maze");

async fn send(page: &Page) -> Result<()> {
    page.click("Send").await?;
    page.wait_for_text("#sent", "read back and compared").await?;
    assert_eq!(page.count(".progress .done").await?, 4);
    Ok(())
}

/// It drives, and some stops are told.
async fn drive(page: &Page) -> Result<()> {
    explore(page).await?;
    page.wait_until("/[2-9] stops, driving/.test(document.querySelector('.note.guest')?.innerText)").await
}

#[tokio::test]
async fn after_disconnecting_nothing_stands_as_if_it_were_now() -> Result<()> {
    lab(Setup::default().at("connect"), async |page| {
        demo(page).await?;
        page.wait_for("#recording").await?;
        send(page).await?;
        page.wait_for_no("#plot-waiting").await?;
        page.click("Disconnect").await?;
        state(page, "not connected").await?;
        page.wait_for_no("#recording").await?;
        page.wait_for_text("#recorded", "lines recorded").await?;
        page.wait_for_text("#list-robot", "not read yet").await?;
        assert_eq!((page.text("#sent").await?.as_str(), page.count(".progress").await?), ("", 0));
        page.wait_for_no("#news").await?;
        // What the sensors saw last stays, as what it is, with no number beside it.
        page.wait_for_text("#plot-waiting", "this is from before").await?;
        page.wait_for(".strips.over .area").await?;
        let numbers = page.texts(".strips > div:not(.axis) b").await?;
        assert!(numbers.len() == 7 && numbers.iter().all(|number| number == "–"), "{numbers:?}");
        assert_eq!(page.value("#tune-kp").await?, "");
        page.screenshot("connect-over").await?;
        // The next connection begins anew.
        demo(page).await?;
        page.wait_for("#recording").await?;
        page.wait_for_no(".strips.over").await?;
        page.wait_for_no("#plot-waiting").await
    })
    .await
}

#[tokio::test]
async fn a_run_that_is_left_is_told_as_the_last_one() -> Result<()> {
    lab(Setup::default().at("connect"), async |page| {
        demo(page).await?;
        drive(page).await?;
        page.wait_for_text(".live .bar", "Live").await?;
        page.click("Disconnect").await?;
        page.wait_for_text(".note.guest", "last run: ").await?;
        page.wait_for_text(".note.guest", "then it was disconnected").await?;
        page.wait_for_text(".live .bar", "Last run").await
    })
    .await
}

#[tokio::test]
async fn beside_another_maze_the_list_that_was_sent_is_past() -> Result<()> {
    lab(Setup::default().at("connect"), async |page| {
        demo(page).await?;
        send(page).await?;
        page.paste(OTHER).await?;
        page.wait_for_text(".toast", "opened the pasted maze").await?;
        page.run("location.hash = '#connect'").await?;
        page.wait_for_text("#same", "not the same").await?;
        page.wait_for_text("#sent", "sent before, not the one of this maze").await?;
        assert_eq!(page.count(".progress").await?, 0);
        send(page).await?;
        page.wait_for_text("#same", "same on both").await
    })
    .await
}

#[tokio::test]
async fn a_recording_that_was_saved_in_a_run_ends_there() -> Result<()> {
    lab(Setup::default().at("connect"), async |page| {
        let downloads = page.allow_downloads().await?;
        demo(page).await?;
        drive(page).await?;
        page.click("Save").await?;
        let session = downloads.file("robot-session.txt").await?;
        page.reload().await?;
        page.wait_for("#session-file").await?;
        let path = std::env::temp_dir().join(format!("line-maze-part-{}.txt", std::process::id()));
        std::fs::write(&path, session)?;
        page.choose_file("#session-file", &path).await?;
        page.wait_for_text(".note.guest", "stops, the recording ends here").await?;
        std::fs::remove_file(path)?;
        Ok(())
    })
    .await
}

#[tokio::test]
async fn a_wrong_setting_is_marked_while_it_is_typed() -> Result<()> {
    lab(Setup::default().at("connect"), async |page| {
        demo(page).await?;
        for (text, wrong) in [("abc", true), ("-1", true), ("99999", true), ("0.75", false)] {
            page.fill("#tune-kp", text).await?;
            assert_eq!(page.attribute("#tune-kp", "aria-invalid").await?, wrong.to_string(), "{text}");
            if wrong {
                let says = format!("#{}", page.attribute("#tune-kp", "aria-describedby").await?);
                assert_eq!(page.text(&says).await?, "kp: a number from 0 to 1000", "{text}");
            }
        }
        page.wait_for_no(".settings .wrong").await?;
        // Nothing is sent while something is wrong, and the first wrong field gets the focus, folded or not.
        let focused = "document.activeElement.id";
        page.click("Sensor thresholds").await?;
        page.fill("#tune-line2", "2000").await?;
        page.click("Sensor thresholds").await?;
        page.click("Send settings").await?;
        assert_eq!(page.eval(focused).await?, json!("tune-line2"));
        page.fill("#tune-speed", "-1").await?;
        page.click("Send settings").await?;
        assert_eq!(page.eval(focused).await?, json!("tune-speed"));
        page.wait_for_text(".sett h2", "3 not sent").await?;
        page.screenshot("connect-wrong-settings").await?;
        page.fill("#filter", "set ").await?;
        page.wait_until("document.querySelectorAll('.log li[data-line]').length === 0").await?;
        page.fill("#tune-speed", "300").await?;
        page.fill("#tune-line2", "500").await?;
        page.click("Send settings").await?;
        page.wait_until("document.querySelectorAll('.log li[data-line]').length === 3").await?;
        page.wait_for_text("#news", "line2 = 500: done").await
    })
    .await
}

#[tokio::test]
async fn a_robot_that_drives_is_stopped_from_any_room_that_shows_its_run() -> Result<()> {
    lab(Setup::default().at("connect"), async |page| {
        const STOP: &str = ".halt-bar #stop-robot";
        demo(page).await?;
        page.press("2").await?;
        page.wait_for(".transport .play").await?;
        assert_eq!(page.count(STOP).await?, 0);
        page.press("4").await?;
        drive(page).await?;
        // First in the order of Tab, and in every room.
        page.wait_for(STOP).await?;
        let first = "[...document.querySelectorAll('button, a[href], input, select, [tabindex]')]
            .find((element) => element.tabIndex >= 0 && element.checkVisibility()).id";
        assert_eq!(page.eval(first).await?, json!("stop-robot"));
        page.press("2").await?;
        page.wait_for(STOP).await?;
        let height =
            page.eval("document.querySelector('#stop-robot').getBoundingClientRect().height").await?;
        assert!(height.as_f64() >= Some(40.0), "{height}");
        page.screenshot("step-stop").await?;
        page.press("p").await?;
        page.wait_for(".projector").await?;
        page.wait_for(STOP).await?;
        page.screenshot("projector-stop").await?;
        page.press("p").await?;
        page.wait_for_no(".projector").await?;
        page.click_css("#stop-robot").await?;
        page.wait_for_text(".note.guest", "stopped by hand").await?;
        page.wait_for_no(STOP).await?;
        // By keys, on the projector; the focus goes back into the room.
        page.press("4").await?;
        drive(page).await?;
        page.press("p").await?;
        page.wait_for(STOP).await?;
        page.wait_for(".projector").await?;
        page.run("document.querySelector('#stop-robot').focus()").await?;
        page.press("Enter").await?;
        page.wait_for_no(STOP).await?;
        page.wait_until("document.activeElement.closest('main, footer')").await?;
        page.press("4").await?;
        state(page, "ready").await
    })
    .await
}
