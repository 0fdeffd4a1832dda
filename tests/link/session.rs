//! Recorded sessions, and drawing what a robot has seen where no maze is known.

use line_maze_lab::event::{Cut, Outcome};
use line_maze_lab::geometry::{Heading, Point};
use line_maze_lab::ink::Ink;
use line_maze_lab::link::floor;
use line_maze_lab::link::live::LiveRun;
use line_maze_lab::link::page::{Command, State};
use line_maze_lab::link::session::{Problem, Session};
use line_maze_lab::link::words::Source;
use line_maze_lab::maze::Scale;
use line_maze_lab::settings::Pace;

use crate::bench::{Bench, mind};
use crate::support::{figure_2_4, figure_3_1};

fn explored() -> Bench {
    let mut bench = Bench::ready();
    bench.explore();
    bench.until(State::Ready);
    bench
}

#[test]
fn a_session_is_saved_opened_and_stepped_without_the_robot() {
    let mut bench = explored();
    bench.explore();
    bench.wait(4_000);
    bench.command(Command::Stop);
    bench.wait(500);
    let text = bench.link.session().save();
    let session = Session::parse(&text).unwrap();
    assert_eq!(session.save(), text);
    let runs = session.runs(mind(), Pace::default());
    assert_eq!(runs.len(), 2);
    assert_eq!(runs[0].end(), Some(Outcome::Finish));
    assert_eq!(runs[0].trace().stops(), 25);
    assert_eq!(runs[0].difference(), None);
    assert_eq!(runs[1].end(), bench.link.live().unwrap().end());
}

#[test]
fn a_session_that_is_saved_in_a_run_ends_there() {
    let mut bench = Bench::ready();
    bench.explore();
    bench.wait(4_000);
    let runs = |text: &str| Session::parse(text).unwrap().runs(mind(), Pace::default());
    let saved = runs(&bench.link.session().save());
    assert_eq!((saved.len(), saved[0].end()), (1, None));
    let told = saved[0].told(Source::Recording("here.txt"));
    assert_eq!(
        told,
        format!("From the recording here.txt: {} stops, the recording ends here", saved[0].stops())
    );
    // A connection that was lost in the middle of it stays one that was lost.
    bench.unplug();
    bench.plugged = true;
    bench.until(State::Ready);
    bench.explore();
    bench.wait(4_000);
    let saved = runs(&bench.link.session().save());
    let ends: Vec<_> = saved.iter().map(LiveRun::end).collect();
    assert_eq!(ends, [Some(Outcome::Cut(Cut::ConnectionLost)), None]);
}

#[test]
fn a_run_whose_end_was_not_heard_does_not_end_the_recording() {
    let text = explored().link.session().save();
    let heard = |line: &&str| !line.contains(" < end ") && !line.contains(" < ready ");
    let lines: Vec<&str> = text.lines().filter(heard).collect();
    let twice = [&lines[..], &lines[1..]].concat();
    let runs = Session::parse(&twice.join("\n")).unwrap().runs(mind(), Pace::default());
    let ends: Vec<_> = runs.iter().map(LiveRun::end).collect();
    assert_eq!(ends, [Some(Outcome::Cut(Cut::Gap)), None]);
}

#[test]
fn a_broken_session_names_the_line() {
    let text = explored().link.session().save();
    let error = |text: &str| Session::parse(text).unwrap_err();
    assert_eq!((error("").line, error("").problem), (1, Problem::Header));
    let broken = text.replacen(" < ready", " < reedy", 1);
    assert_eq!(error(&broken).problem, Problem::Sum);
    let line = error(&broken).line;
    assert!(broken.lines().nth(line - 1).unwrap().contains("reedy"));
    let formless = format!("{text}what is this\n");
    assert_eq!((error(&formless).line, error(&formless).problem), (text.lines().count() + 1, Problem::Form));
    assert!(error(&formless).to_string().starts_with(&format!("line {}: ", text.lines().count() + 1)));
    assert!(Session::parse(&format!("{text}\n# a remark\n\r\n")).is_ok());
}

#[test]
fn what_the_robot_saw_is_drawn_without_a_maze() {
    let bench = explored();
    let trace = bench.link.live().unwrap().trace();
    assert_eq!(floor::guess_cell_ms(&trace), Some(400));
    let seen = floor::seen_maze(&trace, 400, Scale::default()).unwrap();
    assert_eq!(seen.finish(), [Point::new(3, 4)]);
    // Everything of the figure but what was never seen: it drove 29 cells and looked into the others.
    let figure = figure_3_1();
    assert!(seen.lines().all(|(at, heading)| figure.has_line(at, heading)));
    assert!(seen.has_line(Point::new(3, 5), Heading::South));
    let ink = Ink::of(&seen, &trace, 400);
    assert_eq!(ink.crossed_cells(25), 20);
    assert_eq!(floor::first_misfit(&figure, &trace, 400), None);
    assert_eq!(floor::first_misfit(&figure_2_4(), &trace, 400), Some(1));
    // The page's maze is the ground, also where the page takes the robot for slower; another maze is not.
    for page_ms in [400, 650] {
        assert_eq!(floor::ground(&figure, &trace, page_ms), Some(floor::Ground { seen: None, cell_ms: 400 }));
    }
    let ground = floor::ground(&figure_2_4(), &trace, 400).unwrap();
    assert_eq!(ground.seen, floor::seen_maze(&trace, 400, figure.scale));
}
