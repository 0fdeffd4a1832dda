//! The book's walks, told stop by stop and line by line.

use expect_test::expect;
use line_maze_lab::explorer::book::narrate::{Span, Tone, narrate};
use line_maze_lab::geometry::Heading;
use line_maze_lab::trace::{Moment, Trace};

use crate::support::{figure_2_4, figure_3_1};
use crate::{told, walk};

/// One line a stop, and the projector's below it.
fn story(trace: &Trace) -> String {
    let line = |stop| {
        let told = told(trace, stop);
        format!("{stop} {}: {}\n   {}\n", told.case, told.text(), told.short_text())
    };
    (0..=trace.stops()).map(line).collect()
}

#[test]
fn figure_3_1_stop_by_stop() {
    expect![[r#"
        0 START: The bot stands at the start and faces its north (0). The node table is empty, so ptr is 1. It will follow the line to its first stop: a node, a corner, a dead end or the finish.
           At the start, facing north (0). The node table is empty.
        1 NEW NODE: This place matches no remembered node, so it becomes node 1, with its back path to the south (2). The bot drives straight on, to the north (0): of the unvisited paths, the first in its preference order.
           A new place becomes node 1: the bot drives straight on, to the north (0).
        2 NEW NODE: This place matches no remembered node, so it becomes node 2, with its back path to the south (2). The bot drives straight on, to the north (0): of the unvisited paths, the first in its preference order.
           A new place becomes node 2: the bot drives straight on, to the north (0).
        3 CORNER: There is only one way on, so there is nothing to decide: the bot turns right, to the east (1).
           Only one way on: the bot turns right, to the east (1).
        4 NEW NODE: This place matches no remembered node, so it becomes node 3, with its back path to the west (3). The bot drives straight on, to the east (1): of the unvisited paths, the first in its preference order.
           A new place becomes node 3: the bot drives straight on, to the east (1).
        5 CORNER: There is only one way on, so there is nothing to decide: the bot turns right, to the south (2).
           Only one way on: the bot turns right, to the south (2).
        6 NEW NODE: This place matches no remembered node, so it becomes node 4, with its back path to the north (0). The bot drives straight on, to the south (2): of the unvisited paths, the first in its preference order.
           A new place becomes node 4: the bot drives straight on, to the south (2).
        7 CORNER: There is only one way on, so there is nothing to decide: the bot turns left, to the east (1).
           Only one way on: the bot turns left, to the east (1).
        8 DEAD END: The line ends here, so the bot turns round, to the west (3). This way does not lead to the finish: returning is true, and what it drives now is crossed out.
           The line ends: the bot turns round, returning.
        9 CORNER: There is only one way on, so there is nothing to decide: the bot turns right, to the north (0). It is still returning and crosses this line out.
           Only one way on: the bot turns right, to the north (0).
        10 RETURN-KNOWN: The bot is back at node 4, returning: the path to the south (2) is given up. The bot turns left, to the west (3): its only unvisited path, so returning is false again.
           Back at node 4: the bot turns left, to the west (3), an unvisited path.
        11 NEW NODE: This place matches no remembered node, so it becomes node 5, with its back path to the east (1). The bot drives straight on, to the west (3): of the unvisited paths, the first in its preference order.
           A new place becomes node 5: the bot drives straight on, to the west (3).
        12 NEW NODE: This place matches no remembered node, so it becomes node 6, with its back path to the east (1). The bot drives straight on, to the west (3): of the unvisited paths, the first in its preference order.
           A new place becomes node 6: the bot drives straight on, to the west (3).
        13 RETURN-UNKNOWN: The bot met node 1 again by a path it had never taken. Among nodes 1 to 6, paths are still unvisited (2 east, 3 south, 5 north, 6 north), so it turns round, to the east (1), and crosses this path out.
           At node 1 again, by a new path. Other paths are still unvisited, so the bot turns round.
        14 RETURN-KNOWN: The bot is back at node 6, returning: the path to the west (3) is given up. The bot turns left, to the north (0): its only unvisited path, so returning is false again.
           Back at node 6: the bot turns left, to the north (0), an unvisited path.
        15 CORNER: There is only one way on, so there is nothing to decide: the bot turns left, to the west (3).
           Only one way on: the bot turns left, to the west (3).
        16 RETURN-UNKNOWN: The bot met node 2 again by a path it had never taken. Among nodes 2 to 6, paths are still unvisited (3 south, 5 north), so it turns round, to the east (1), and crosses this path out.
           At node 2 again, by a new path. Other paths are still unvisited, so the bot turns round.
        17 CORNER: There is only one way on, so there is nothing to decide: the bot turns right, to the south (2). It is still returning and crosses this line out.
           Only one way on: the bot turns right, to the south (2).
        18 RETURN-KNOWN: The bot is back at node 6, returning, and all its paths are visited. It turns left, to the east (1), which is the back path, and forgets node 6: ptr is 6.
           Nothing left at node 6: the bot takes the back path, east (1).
        19 RETURN-KNOWN: The bot is back at node 5, returning: the path to the west (3) is given up. The bot turns left, to the north (0): its only unvisited path, so returning is false again.
           Back at node 5: the bot turns left, to the north (0), an unvisited path.
        20 DEAD END: The line ends here, so the bot turns round, to the south (2). This way does not lead to the finish: returning is true, and what it drives now is crossed out.
           The line ends: the bot turns round, returning.
        21 RETURN-KNOWN: The bot is back at node 5, returning, and all its paths are visited. It turns left, to the east (1), which is the back path, and forgets node 5: ptr is 5.
           Nothing left at node 5: the bot takes the back path, east (1).
        22 RETURN-KNOWN: The bot is back at node 4, returning, and all its paths are visited. It turns left, to the north (0), which is the back path, and forgets node 4: ptr is 4.
           Nothing left at node 4: the bot takes the back path, north (0).
        23 CORNER: There is only one way on, so there is nothing to decide: the bot turns left, to the west (3). It is still returning and crosses this line out.
           Only one way on: the bot turns left, to the west (3).
        24 RETURN-KNOWN: The bot is back at node 3, returning: the path to the east (1) is given up. The bot turns left, to the south (2): its only unvisited path, so returning is false again.
           Back at node 3: the bot turns left, to the south (2), an unvisited path.
        25 FINISH: The bot stands on the finish and stops. What it remembers is the way here: nodes 1 to 3, so ptr is 4. Round 2 leaves each by the way last chosen.
           Finish reached. The way here: nodes 1 to 3.
    "#]].assert_eq(&story(&walk(&figure_3_1())));
}

#[test]
fn figure_2_4_stop_by_stop() {
    expect![[r#"
        0 START: The bot stands at the start and faces its north (0). The node table is empty, so ptr is 1. It will follow the line to its first stop: a node, a corner, a dead end or the finish.
           At the start, facing north (0). The node table is empty.
        1 NEW NODE: This place matches no remembered node, so it becomes node 1, with its back path to the south (2). The bot turns right, to the east (1): of the unvisited paths, the first in its preference order.
           A new place becomes node 1: the bot turns right, to the east (1).
        2 NEW NODE: This place matches no remembered node, so it becomes node 2, with its back path to the west (3). The bot drives straight on, to the east (1): of the unvisited paths, the first in its preference order.
           A new place becomes node 2: the bot drives straight on, to the east (1).
        3 CORNER: There is only one way on, so there is nothing to decide: the bot turns right, to the south (2).
           Only one way on: the bot turns right, to the south (2).
        4 CORNER: There is only one way on, so there is nothing to decide: the bot turns right, to the west (3).
           Only one way on: the bot turns right, to the west (3).
        5 CORNER: There is only one way on, so there is nothing to decide: the bot turns right, to the north (0).
           Only one way on: the bot turns right, to the north (0).
        6 RETURN-UNKNOWN: The bot met node 2 again by a path it had never taken. No path of node 2 is unvisited, so this loop is forgotten. It turns left, to the west (3): the back path, so returning is true.
           At node 2 again, by a new path. Nothing is left in this loop: the bot takes the back path, west (3).
        7 RETURN-KNOWN: The bot is back at node 1, returning: the path to the east (1) is given up. The bot drives straight on, to the west (3): its only unvisited path, so returning is false again.
           Back at node 1: the bot drives straight on, to the west (3), an unvisited path.
        8 FINISH: The bot stands on the finish and stops. What it remembers is the way here: node 1, so ptr is 2. Round 2 leaves it by the way last chosen.
           Finish reached. The way here: node 1.
    "#]].assert_eq(&story(&walk(&figure_2_4())));
}

#[test]
fn every_stop_names_its_node_its_way_out_and_its_case() {
    for maze in [figure_3_1(), figure_2_4()] {
        let trace = walk(&maze);
        for stop in 1..=trace.stops() {
            let (told, step) = (told(&trace, stop), trace.step(stop).unwrap());
            let text = told.text();
            assert!(told.case.chars().all(|c| c.is_ascii_uppercase() || " -".contains(c)), "{}", told.case);
            if step.node() > 0 {
                assert!(told.said.contains(&Span::Node(step.node())), "{stop}: {text}");
                assert!(told.short.contains(&Span::Node(step.node())), "{stop}: {}", told.short_text());
            }
            if step.turn().is_some() {
                let to = step.departure();
                assert!(text.contains(&format!("to the {} ({})", to.word(), to.index())), "{stop}: {text}");
            }
            assert!(told.section.starts_with("Book §"));
        }
        assert_eq!(told(&trace, trace.stops()).tone, Tone::Go);
    }
}

#[test]
fn stop_13_lists_what_is_unvisited_and_turns_round() {
    let told = told(&walk(&figure_3_1()), 13);
    assert_eq!(told.case, "RETURN-UNKNOWN");
    assert!(told.text().contains("Among nodes 1 to 6, paths are still unvisited"));
    assert!(told.said.contains(&Span::Strong("turns round".into())));
    let way =
        |span: &Span| if let Span::Way { node, heading } = *span { Some((node, heading)) } else { None };
    let ways: Vec<_> = told.said.iter().filter_map(way).collect();
    use Heading::{East as E, North as N, South as S};
    assert_eq!(ways, [(2, E), (3, S), (5, N), (6, N)]);
    assert!(!told.text().contains("and more"));
}

#[test]
fn every_line_of_figure_3_1_has_a_sentence() {
    let trace = walk(&figure_3_1());
    let mut lines = std::collections::BTreeMap::new();
    for stop in 1..=trace.stops() {
        for line in 1..trace.lines(stop) {
            let frame = trace.frame(Moment { stop, lines: line });
            let told = narrate(&trace, &frame);
            assert!(told.text().ends_with('.'), "{stop}.{line}: {}", told.text());
            assert!(told.case.ends_with("()"));
            lines.insert(frame.ran.unwrap(), told.text());
        }
    }
    let lines: String =
        lines.iter().map(|(line, text)| format!("{:2} {text}\n", line.listed().label)).collect();
    expect![[r#"
        2  The bot drove 400 ms to the south (2), so get_coords() sets cur_y to 1600. get_paths() sees no way on.
        3  Not the finish.
        +  A node is remembered, or this place does not match the start, so the search goes on.
        4  There is a way on, so this is no dead end.
        5  More than one way leads on, so this is no corner.
        6  3 ways meet here, so this is a node, and node() decides.
        9  match_cur_node() finds node 3 nearer than epsilon, so m is 3.
        10 m is 3, so the bot knows this node already.
        11 record_node() writes node 6 into the table: back path east (1), which counts as visited. ptr becomes 7.
        12 Now choose_path() looks for the way out of node 6.
        13 returning is true, so this is the RETURN-KNOWN case.
        14 ptr is 4 already: node 3 is the newest, and nothing is forgotten.
        15 choose_path() looks for an unvisited path of node 3; if there is none, the bot takes its back path.
        16 The bot is not returning, so the path that led it to node 2 counts as new.
        17 The bot came along the path to the east (1) of node 2, so that path is visited now.
        24 To the left is the first of the preference order that exists and is unvisited, so d is south (2).
        25 There is none, so choose_path() returns false.
        29 The bot turns left for the back path of node 4, north (0), and returning is true.
    "#]].assert_eq(&lines);
}

#[test]
fn figure_2_4_s_loop_line_by_line() {
    let trace = walk(&figure_2_4());
    let line = |lines| {
        let frame = trace.frame(Moment { stop: 6, lines });
        format!("{:2} {}\n", frame.ran.unwrap().listed().label, narrate(&trace, &frame).text())
    };
    let lines: String = (1..trace.lines(6)).map(line).collect();
    expect![[r#"
        2  The bot drove 800 ms to the north (0), so get_coords() sets cur_y to 800. get_paths() sees ways to the left and to the right.
        3  Not the finish.
        +  A node is remembered, or this place does not match the start, so the search goes on.
        4  There is a way on, so this is no dead end.
        5  More than one way leads on, so this is no corner.
        6  3 ways meet here, so this is a node, and node() decides.
        9  match_cur_node() finds node 2 nearer than epsilon, so m is 2.
        10 m is 2, so the bot knows this node already.
        13 returning is false, so this is the RETURN-UNKNOWN case.
        16 The bot is not returning, so the path that led it to node 2 counts as new.
        17 The bot came along the path to the south (2) of node 2, so that path is visited now.
        18 No path of node 2 is unvisited, so there is nothing to turn round for.
        19 The loop that was just closed can be forgotten.
        20 ptr is 3 already: node 2 is the newest, and nothing is forgotten.
        21 The check covered node 2 too, so choose_path() finds nothing here, and the bot takes the back path.
        24 Every path of node 2 is visited: there is none to choose.
        25 There is none, so choose_path() returns false.
        29 The bot turns left for the back path of node 2, west (3), and returning is true.
    "#]].assert_eq(&lines);
}
