//! Playing a run of five stops, three lines each, one second apart.

use super::*;

/// Five stops of three lines, one second apart.
struct Five;

impl Timeline for Five {
    fn stops(&self) -> u32 {
        5
    }
    fn lines(&self, _: u32) -> u8 {
        3
    }
    fn drive_ms(&self, _: u32) -> u32 {
        1000
    }
    fn mark(&self, stop: u32) -> Mark {
        [Mark::Plain, Mark::Node, Mark::Plain, Mark::DeadEnd, Mark::Known, Mark::End][stop as usize]
    }
}

fn after(commands: &[Command]) -> Playback {
    let mut playback = Playback::default();
    playback.set_motion(Motion::Reduced);
    for &command in commands {
        playback.apply(command, &Five);
    }
    playback
}

#[test]
fn steps_go_there_and_back_and_stay_inside() {
    use Command::{Back, Forward, ToEnd, ToStart};
    assert_eq!(after(&[Forward, Forward, Back]).moment().stop, 1);
    assert_eq!(after(&[Back]).moment().stop, 0);
    assert_eq!(after(&[ToEnd, Forward]).moment().stop, 5);
    assert_eq!(after(&[ToEnd, Back]).moment().stop, 4);
    assert_eq!(after(&[ToEnd, ToStart]).moment().stop, 0);
}

#[test]
fn lines_are_steps_inside_a_stop() {
    use Command::{BackBy, Forward, ForwardBy};
    let line = ForwardBy(Unit::Line);
    assert_eq!(after(&[line]).moment(), Moment { stop: 1, lines: 1 });
    assert_eq!(after(&[line, line]).moment(), Moment { stop: 1, lines: 2 });
    assert_eq!(after(&[line, line, line, line]).moment(), Moment { stop: 2, lines: 1 });
    assert_eq!(after(&[line, Forward]).moment(), Moment::after(1), "first to the end of the stop");
    assert_eq!(after(&[Forward, BackBy(Unit::Line)]).moment(), Moment { stop: 1, lines: 2 });
    assert_eq!(after(&[line, BackBy(Unit::Line)]).moment(), Moment::after(0));
}

#[test]
fn events_are_found_by_kind() {
    use Command::{NextEvent, PreviousEvent, ToEnd};
    assert_eq!(after(&[NextEvent(None), NextEvent(None)]).moment().stop, 3);
    assert_eq!(after(&[NextEvent(Some(Mark::Known))]).moment().stop, 4);
    assert_eq!(after(&[NextEvent(Some(Mark::Unknown))]).moment().stop, 0, "there is none");
    assert_eq!(after(&[ToEnd, PreviousEvent(Some(Mark::Node))]).moment().stop, 1);
    assert_eq!(after(&[ToEnd, PreviousEvent(None), PreviousEvent(None)]).moment().stop, 3);
}

#[test]
fn playing_drives_rests_and_ends() {
    let mut playback = Playback::default();
    playback.apply(Command::Toggle, &Five);
    playback.tick(0.25, &Five);
    playback.tick(0.25, &Five);
    assert_eq!(playback.moment().stop, 0);
    assert!((playback.along() - 0.5).abs() < 1e-9);
    for _ in 0..3 {
        playback.tick(0.25, &Five);
    }
    assert_eq!((playback.moment().stop, playback.along()), (1, 0.0), "it rests at the stop");
    for _ in 0..100 {
        playback.tick(0.25, &Five);
    }
    assert_eq!(playback.moment().stop, 5);
    assert!(!playback.is_moving());
    playback.apply(Command::Toggle, &Five);
    assert_eq!(playback.moment().stop, 0, "playing on from the end begins anew");
}

#[test]
fn a_high_speed_passes_many_stops_in_a_tick() {
    let mut playback = Playback::default();
    playback.apply(Command::Speed(512.0), &Five);
    playback.apply(Command::Toggle, &Five);
    playback.tick(0.1, &Five);
    assert_eq!(playback.moment().stop, 5);
}

#[test]
fn a_step_is_seen_and_can_be_hurried() {
    let mut playback = Playback::default();
    playback.apply(Command::Forward, &Five);
    playback.tick(STEP_S / 2.0, &Five);
    assert_eq!(playback.moment().stop, 0);
    playback.apply(Command::Forward, &Five);
    assert_eq!(playback.moment().stop, 1, "the first step is over at once");
    playback.tick(STEP_S * 0.8, &Five);
    playback.apply(Command::Back, &Five);
    assert_eq!(playback.moment().stop, 1);
    playback.tick(0.25, &Five);
    assert_eq!((playback.moment().stop, playback.along()), (1, 0.0));
    playback.apply(Command::Back, &Five);
    assert_eq!((playback.moment().stop, playback.along()), (0, 1.0), "the words are there first");
    playback.tick(0.25, &Five);
    playback.tick(0.25, &Five);
    assert!(!playback.is_moving());
}

#[test]
fn a_drive_knows_how_much_of_its_stop_is_told_at_its_end() {
    use Command::{BackBy, Forward, ForwardBy, Pause, StepBy, Toggle};
    let begun = |commands: &[Command]| {
        let mut playback = Playback::default();
        for &command in commands {
            playback.apply(command, &Five);
        }
        playback.tick(STEP_S / 2.0, &Five);
        assert!(playback.along() > 0.0);
        playback.bound()
    };
    let (whole, line) = (Moment::after(1), Moment { stop: 1, lines: 1 });
    assert_eq!(begun(&[Forward]), whole);
    assert_eq!(begun(&[ForwardBy(Unit::Line)]), line);
    assert_eq!(begun(&[Toggle]), whole);
    assert_eq!(begun(&[StepBy(Unit::Line), Toggle]), line);
    // Backwards it leaves as it stood.
    assert_eq!(begun(&[Command::Seek(line), BackBy(Unit::Line)]), line);
    assert_eq!(begun(&[Command::Seek(whole), BackBy(Unit::Stop)]), whole);
    let mut paused = Playback::default();
    paused.apply(Toggle, &Five);
    paused.tick(0.2, &Five);
    paused.apply(Pause, &Five);
    assert_eq!(paused.bound(), whole);
}

#[test]
fn who_plays_on_from_the_middle_of_a_stop_has_done_its_lines() {
    let mut playback = Playback::default();
    playback.apply(Command::Seek(Moment { stop: 1, lines: 2 }), &Five);
    playback.apply(Command::Toggle, &Five);
    playback.tick(0.1, &Five);
    assert!(playback.along() > 0.0);
    assert_eq!(playback.moment(), Moment::after(1), "no drive begins in the middle of a stop");
}

#[test]
fn without_motion_a_drive_that_goes_on_is_over() {
    let begun = |command: Command| {
        let mut playback = Playback::default();
        playback.apply(command, &Five);
        playback.tick(0.1, &Five);
        assert!(playback.along() > 0.0, "it drives");
        playback
    };
    let mut step = begun(Command::Forward);
    step.set_motion(Motion::Reduced);
    assert_eq!((step.moment(), step.along(), step.is_moving()), (Moment::after(1), 0.0, false));

    let mut home = begun(Command::Forward);
    home.apply(Command::Back, &Five);
    home.set_motion(Motion::Reduced);
    assert_eq!((home.moment(), home.along(), home.is_moving()), (Moment::default(), 0.0, false));

    let mut paused = begun(Command::Toggle);
    paused.apply(Command::Pause, &Five);
    paused.set_motion(Motion::Reduced);
    assert_eq!((paused.moment(), paused.along()), (Moment::default(), 0.0));

    // It plays on from stop to stop, and drives again when motion is back.
    let mut playing = begun(Command::Toggle);
    playing.set_motion(Motion::Reduced);
    playing.tick(0.25, &Five);
    assert_eq!((playing.moment().stop, playing.along(), playing.is_playing()), (1, 0.0, true));
    playing.set_motion(Motion::Smooth);
    for _ in 0..5 {
        playing.tick(0.25, &Five);
    }
    assert!(playing.along() > 0.0, "it is seen again");
}
