//! What rows say, and what is said of them.

use std::fs;

use forage::statistics::{Group, compare, friedman};
use forage_study::table::significant;
use serde_json::Value;

use crate::support::root;

use super::support::{SMALL, carry_out, column, folder, forage, refused, rows, text};

#[test]
fn rows_are_in_the_order_of_the_file_with_the_same_bytes_whatever_the_threads() {
    let folder = folder("threads", SMALL);
    carry_out(&folder, &["--jobs", "1"]);
    let out = folder.join("sweep.csv");
    let one = fs::read(&out).unwrap();
    let heading = "scene,planner,seed,p.iterations,w,c1,population,status,limit,iterations,budget,evaluations,cost,length,value,feasible,\
                   clearance,exact,exact_by,gap,within,reached,reached_iteration,settled,turns,deterministic,hash,digest\n";
    assert!(text(&one).starts_with(heading), "{}", text(&one));
    let mut expected = Vec::new();
    for (planner, sets) in [("pso", &["0.8,2,", "0.4,2,"] as &[&str]), ("wcpso", &[",,20"])] {
        for scene in ["sphere", "wcpso-discs"] {
            for set in sets {
                expected.extend((1..=3).map(|seed| format!("{scene},{planner},{seed},20,{set},")));
            }
        }
    }
    let lines: Vec<_> = text(&one).lines().map(str::to_owned).collect::<Vec<_>>().split_off(1);
    assert_eq!(lines.len(), expected.len());
    lines.iter().zip(expected).for_each(|(line, start)| assert!(line.starts_with(&start), "{line} instead of {start}"));
    for jobs in ["3", "2"] {
        carry_out(&folder, &["--jobs", jobs, "--fresh"]);
        assert_eq!(fs::read(&out).unwrap(), one, "{jobs} threads");
    }
}

#[test]
fn a_row_says_what_forage_run_says() {
    let folder = folder("run", SMALL);
    carry_out(&folder, &[]);
    let out = folder.join("sweep.csv");
    for (k, set) in
        [(4, &["--set", "w=0.4", "--set", "c1=2"] as &[&str]), (7, &["--set", "w=0.8", "--set", "c1=2"]), (16, &["--set", "population=20"])]
    {
        let row = &rows(&out)[k];
        let args = [&["run", &row[1], "--scene", &row[0], "--seed", &row[2], "--iterations", "20", "--json"], set].concat();
        let run: Value = serde_json::from_slice(&forage(&args).stdout).unwrap();
        for name in
            ["status", "iterations", "evaluations", "cost", "length", "feasible", "clearance", "exact", "exact_by", "gap", "turns", "hash"]
        {
            let cell = &row[column(&out, name)];
            let agrees = match &run[name] {
                Value::Null => cell.is_empty(),
                Value::String(text) => cell == text,
                Value::Bool(flag) => cell == flag.to_string(),
                number => cell.parse::<f64>().ok() == number.as_f64(),
            };
            assert!(agrees, "row {k}, {name}: {cell} beside {}", run[name]);
        }
    }
}

#[test]
fn json_lines_hold_what_csv_holds() {
    let folder = folder("formats", SMALL);
    let [csv, lines] = ["rows.csv", "rows.jsonl"].map(|name| folder.join(name));
    carry_out(&folder, &["--out", csv.to_str().unwrap()]);
    carry_out(&folder, &["--out", lines.to_str().unwrap()]);
    let headings: Vec<String> = csv::Reader::from_path(&csv).unwrap().headers().unwrap().iter().map(str::to_owned).collect();
    let objects: Vec<serde_json::Map<String, Value>> =
        fs::read_to_string(&lines).unwrap().lines().map(|line| serde_json::from_str(line).unwrap()).collect();
    let rows = rows(&csv);
    assert_eq!(objects.len(), rows.len());
    for (object, row) in objects.iter().zip(&rows) {
        assert_eq!(object.len(), headings.len());
        // Each digest is of its own line.
        for (name, cell) in headings.iter().zip(row).filter(|(name, _)| *name != "digest") {
            match &object[name] {
                Value::Null => assert_eq!(cell, "", "{name}"),
                Value::String(text) => assert_eq!(cell, text, "{name}"),
                Value::Bool(flag) => assert_eq!(cell, flag.to_string(), "{name}"),
                number => assert_eq!(cell.parse::<f64>().unwrap().to_bits(), number.as_f64().unwrap().to_bits(), "{name}"),
            }
        }
    }
}

/// Names with commas, quotes and letters of all sorts.
#[test]
fn a_row_is_found_again_whatever_its_scene_is_called() {
    let sweep = "scenes = ['odd.json']\nseeds = [9007199254740991, 0]\n[[planner]]\nname = 'pso'\n\
                 params = { iterations = [2, 3], w = 1e-7 }\n";
    let folder = folder("quoted", sweep);
    let odd = "a, \"b\" – ä";
    let mut scene: Value = serde_json::from_str(&fs::read_to_string(root().join("scenes/matyas.json")).unwrap()).unwrap();
    scene["name"] = odd.into();
    fs::write(folder.join("odd.json"), scene.to_string()).unwrap();
    for name in ["rows.csv", "rows.ndjson"] {
        let out = folder.join(name);
        let args = ["--out", out.to_str().unwrap()];
        carry_out(&folder, &args);
        let whole = fs::read_to_string(&out).unwrap();
        let end = whole.trim_end().rfind('\n').unwrap();
        fs::write(&out, &whole[..end + 20]).unwrap();
        carry_out(&folder, &args);
        assert_eq!(fs::read_to_string(&out).unwrap(), whole);
    }
    let out = folder.join("rows.csv");
    let row = &rows(&out)[3];
    assert_eq!((&row[0], &row[2], &row[column(&out, "p.iterations")], &row[column(&out, "w")]), (odd, "0", "3", "1e-7"));
    scene["name"] = "two\nlines".into();
    fs::write(folder.join("odd.json"), scene.to_string()).unwrap();
    assert!(refused(&folder, &[]).contains("`scenes[0].name` is \"two\\nlines\"; it must be a name in one line"));
}

#[test]
fn scenes_are_looked_for_beside_the_file_and_may_be_maps_and_links() {
    let sweep = "scenes = ['mine/one.map', 'mine/two.json', '#v=1&planner=a-star&scene=corridor', 'crossing']\nseeds = [1]\n\
                 out = 'rows.jsonl'\n[[planner]]\nname = 'a-star'\n";
    let folder = folder("scenes", sweep);
    fs::create_dir_all(folder.join("mine")).unwrap();
    fs::copy(root().join("scenes/qpso-10m.json"), folder.join("mine/two.json")).unwrap();
    let message = refused(&folder, &[]);
    assert!(message.contains("scenes[0]: ") && message.contains("`mine/one.map`: no such file"), "{message}");
    let map = folder.join("mine/one.map");
    assert!(forage(&["convert", "wolf-ant-20", map.to_str().unwrap()]).status.success());
    carry_out(&folder, &[]);
    let lines = fs::read_to_string(folder.join("rows.jsonl")).unwrap();
    let names: Vec<Value> = lines.lines().map(|line| serde_json::from_str::<Value>(line).unwrap()["scene"].take()).collect();
    assert_eq!(names[1..], ["qpso-10m", "corridor", "crossing"]);
    assert_eq!(names.len(), 4);
}

#[test]
fn deterministic_planners_are_not_tested_and_each_optimum_is_named() {
    let sweep = "scenes = ['wolf-ant-20']\nseeds = { from = 1, count = 3 }\n[[planner]]\nname = 'a-star'\n[[planner]]\n\
                 name = 'theta-star'\n[[planner]]\nname = 'aco'\nparams = { iterations = [5, 6] }\n";
    let folder = folder("lots", sweep);
    let stderr = carry_out(&folder, &[]);
    for part in [
        "wolf-ant-20: no tests and intervals for what is deterministic: a-star, theta-star",
        "corrected for 1 tests",
        "see the last column",
        "any angle",
        "cells",
    ] {
        assert!(stderr.contains(part), "{part}: {stderr}");
    }
    let printed: Value = serde_json::from_str(&carry_out(&folder, &["--json"])).unwrap();
    let pairs = printed["scenes"][0]["pairs"].as_array().unwrap();
    assert_eq!((pairs.len(), &pairs[0]["first"], &pairs[0]["second"]), (1, &2.into(), &3.into()));
    assert_eq!(printed["ranked"], serde_json::json!([2, 3]));
    let groups = &printed["scenes"][0]["groups"];
    assert_eq!([0, 1, 2, 3].map(|k| groups[k]["draws_lots"].as_bool().unwrap()), [false, false, true, true]);
    assert_eq!((&groups[0]["exact_by"], &groups[1]["exact_by"]), (&"cells".into(), &"any-angle".into()));
}

#[test]
fn statistics_are_those_of_the_rows() {
    let folder = folder("statistics", SMALL);
    let report = folder.join("report.md");
    let printed: Value = serde_json::from_str(&carry_out(&folder, &["--json", "--report", report.to_str().unwrap()])).unwrap();
    let out = folder.join("sweep.csv");
    let [value, reached] = ["value", "reached"].map(|name| column(&out, name));
    let rows = rows(&out);
    let names = ["pso w=0.8 c1=2", "pso w=0.4 c1=2", "wcpso population=20"];
    // Groups of three rows; pso's two on each scene, then wcpso's.
    let places = [[0, 1, 4], [2, 3, 5]];
    let mut blocks = vec![vec![f64::MAX; 3]; 6];
    for (s, scene) in ["sphere", "wcpso-discs"].into_iter().enumerate() {
        let groups: Vec<Group> = (0..3)
            .map(|g| Group::new(names[g], rows[3 * places[s][g]..][..3].iter().map(|row| row[value].parse().ok()).collect()))
            .collect();
        for (g, group) in groups.iter().enumerate() {
            group.values.iter().enumerate().for_each(|(k, value)| blocks[3 * s + k][g] = value.unwrap_or(f64::MAX));
            let near = rows[3 * places[s][g]..][..3].iter().filter(|row| !row[reached].is_empty()).count();
            assert_eq!(printed["scenes"][s]["groups"][g]["reached"].as_f64(), Some(near as f64 / 3.0));
        }
        let expected = serde_json::to_value(compare(&groups)).unwrap();
        assert_eq!(printed["scenes"][s]["scene"], scene);
        assert_eq!(printed["scenes"][s]["pairs"], expected["pairs"]);
        for (g, group) in expected["groups"].as_array().unwrap().iter().enumerate() {
            for (key, number) in group.as_object().unwrap() {
                assert_eq!(&printed["scenes"][s]["groups"][g][key], number, "{scene}, {}, {key}", names[g]);
            }
        }
    }
    assert_eq!(printed["friedman"], serde_json::to_value(friedman(&blocks)).unwrap());
    assert_eq!((&printed["runs"], &printed["scenes"][0]["groups"][1]["parameters"]["w"]), (&18.into(), &0.4.into()));

    let markdown = fs::read_to_string(&report).unwrap();
    for name in ["reached", "profile", "ranks"] {
        let picture = fs::read_to_string(folder.join(format!("report.{name}.svg"))).unwrap();
        assert!(names.iter().all(|planner| picture.contains(planner)), "{name}");
        assert!(markdown.contains(&format!("](<report.{name}.svg>)")), "{name}");
    }

    let stderr = carry_out(&folder, &[]);
    let mean = printed["scenes"][1]["groups"][2]["summary"]["mean"].as_f64().unwrap();
    for part in [
        "pso w=0.8 c1=2",
        "within 0.01 of the exact optimum",
        "within 1 % of the exact optimum\n",
        "corrected for 3 tests (Holm)",
        "95 % confidence",
        "Mean ranks over 6 blocks",
        &significant(mean, 4),
    ] {
        assert!(stderr.contains(part), "{part}: {stderr}");
    }
    assert!(fs::read_to_string(report).unwrap().contains("| wcpso population=20 |"));
}
