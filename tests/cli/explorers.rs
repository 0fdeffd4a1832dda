//! `--explorer NAME`: what each reports and traces.

use serde_json::{Value, json};

use super::{FIGURE, linemaze};

/// The report of an explorer, with the exit status.
fn report_of(maze: &str, explorer: &str, args: &[&str]) -> (i32, Value) {
    let said = linemaze(&[&["run", maze, "--json", "--explorer", explorer], args].concat());
    assert_eq!(said.err, "");
    (said.status, serde_json::from_str(&said.out).unwrap())
}

#[test]
fn every_explorer_runs_by_name() {
    let names = [
        "book",
        "left-hand",
        "right-hand",
        "direction-sum-left",
        "direction-sum-right",
        "mapping",
        "parex-left",
        "parex-right",
        "cornell-1",
        "cornell-2",
        "cornell-3",
        "tremaux",
        "depth-first",
        "flood-fill",
    ];
    for name in names {
        let (status, report) = report_of("mazes/tree.maze", name, &[]);
        assert_eq!(report["explorer"], name);
        let good = ["finish", "mapped"].contains(&report["outcome"].as_str().unwrap());
        assert_eq!(status, i32::from(!good), "{name}");
        let keys = |key: &str| report.get(key).is_some();
        let squares = ["parex", "cornell", "flood"].iter().any(|kind| name.starts_with(kind));
        assert_eq!(keys("squares"), squares, "{name}");
        assert_eq!(keys("bytes"), name.starts_with("cornell"), "{name}");
        assert_eq!(keys("path"), name.starts_with("parex"), "{name}");
        assert_eq!((keys("points"), keys("adjacency")), (name == "mapping", name == "mapping"), "{name}");
    }
    let said = linemaze(&["run", FIGURE, "--explorer", "magic"]);
    assert_eq!(said.status, 2);
    assert!(said.err.contains("cornell-3") && said.err.contains("flood-fill"), "{}", said.err);
}

#[test]
fn mapping_reports_the_graph() {
    let (status, report) = report_of("mazes/sakib-2.maze", "mapping", &["--search", "astar"]);
    assert_eq!((status, &report["outcome"]), (0, &json!("mapped")));
    assert_eq!(report["distance_mm"], 820.0);
    assert_eq!((&report["route_cells"], &report["memory_bytes"]), (&json!(32), &json!(120)));
    let points = json!([
        [0, 0],
        [0, 10],
        [14, 10],
        [14, 13],
        [14, 16],
        [14, 13],
        [0, 13],
        [0, 10],
        [-5, 10],
        [0, 10],
        [14, 10],
        [14, 2],
    ]);
    assert_eq!(report["points"], points);
    assert_eq!(report["adjacency"]["0,10"], json!([[0, 0], [14, 10], [0, 13], [-5, 10]]));
    assert_eq!(report["adjacency"].as_object().unwrap().len(), 8);
}

#[test]
fn square_explorers_report_squares_as_their_sources_number_them() {
    let (status, report) = report_of("mazes/parex-1.maze", "parex-right", &[]);
    assert_eq!(status, 0);
    assert_eq!(report["squares"], json!([1, 5, 6, 2, 3, 7, 6, 5, 9, 10, 11, 12, 8, 4]));
    assert_eq!(report["path"], json!([1, 5, 9, 10, 11, 12, 8, 4]));
    let (_, basic) = report_of("mazes/parex-1.maze", "parex-right", &["--rule", "basic"]);
    assert_eq!(basic["path"], basic["squares"]);
    let (status, full) = report_of("mazes/parex-1.maze", "parex-right", &["--path-max", "5"]);
    assert_eq!((status, &full["outcome"]), (1, &json!("table-full")));
    assert_eq!(full["reason"], "path full (5 squares)");

    let (status, report) = report_of("mazes/cornell-3x5.maze", "cornell-3", &[]);
    assert_eq!((status, &report["outcome"], &report["stops"]), (0, &json!("mapped"), &json!(16)));
    assert_eq!(report["squares"][1], json!([0, 1]));
    assert_eq!(report["bytes"][0], json!([0x19, 0x1A, 0x1C]));
    let (status, report) = report_of("mazes/cornell-3x5.maze", "cornell-1", &[]);
    assert_eq!((status, &report["outcome"]), (1, &json!("circling")));
    assert!(report["reason"].as_str().unwrap().contains("stop 7 is stop 1 again"));
}

#[test]
fn other_explorers_trace_from_stop_0() {
    let said = linemaze(&["trace", "mazes/sakib-1.maze", "--explorer", "direction-sum-right", "--json"]);
    assert_eq!(said.status, 0);
    let stops: Vec<Value> = said.out.lines().map(|line| serde_json::from_str(line).unwrap()).collect();
    assert_eq!(stops.len(), 7);
    let expected = json!({
        "stop": 0, "at": [0, 0], "seen": "start", "case": "start", "node": null, "leaves": 0, "ptr": null,
        "returning": null, "cur_x": 0, "cur_y": 0, "crossed_cells": null,
    });
    assert_eq!(stops[0], expected);
    let told = |key: &str| stops.iter().map(|stop| stop[key].clone()).collect::<Vec<_>>();
    assert_eq!(told("seen"), ["start", "node", "dead-end", "node", "node", "node", "finish"]);
    assert_eq!(told("leaves")[1..], [json!(1), json!(3), json!(3), json!(0), json!(1), Value::Null]);
    let people = linemaze(&["trace", "mazes/hand-circles.maze", "--explorer", "left-hand"]);
    assert_eq!(people.status, 1);
    assert!(people.out.ends_with("nothing in memory could make it decide otherwise\n"), "{}", people.out);
}
