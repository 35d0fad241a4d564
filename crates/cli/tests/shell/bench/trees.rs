//! `forage bench trees`.

use std::{fs, path::Path};

use crate::support::{empty_folder, forage, text};

fn carry_out(folder: &Path, more: &[&str]) -> std::process::Output {
    let small = ["bench", "trees", "--planners", "rrt,rrt-connect,rrt-star", "--runs", "4", "--budget", "2000"];
    forage(&[&small[..], &["--out", folder.to_str().unwrap()], more].concat())
}

/// The rows, by column.
fn rows(folder: &Path) -> Vec<std::collections::BTreeMap<String, String>> {
    csv::Reader::from_path(folder.join("rows.csv")).unwrap().deserialize().map(Result::unwrap).collect()
}

#[test]
fn each_row_is_what_forage_run_gives() {
    let folder = empty_folder("bench-trees");
    let output = carry_out(&folder, &["wcpso-discs"]);
    assert_eq!(output.status.code(), Some(0), "{}", text(&output.stderr));
    let rows = rows(&folder);
    assert_eq!(rows.len(), 3 * 4);
    for row in rows.iter().filter(|row| row["planner"] != "rrt-star") {
        let run = forage(&["run", &row["planner"], "--scene", "wcpso-discs", "--seed", &row["seed"], "--json"]);
        let run: serde_json::Value = serde_json::from_slice(&run.stdout).unwrap();
        assert_eq!(row["solved"], run["feasible"].to_string());
        for name in ["length", "iterations", "evaluations", "clearance", "exact"] {
            assert_eq!(row[name].parse::<f64>().ok(), run[name].as_f64(), "{row:?}");
        }
    }
    // Those that go on have the budget, and end in the iteration that spends it.
    for row in rows.iter().filter(|row| row["planner"] == "rrt-star") {
        assert!((2000..2100).contains(&row["evaluations"].parse().unwrap()), "{row:?}");
        let costs: Vec<f64> = row["improvements"].split(' ').map(|pair| pair.split_once(':').unwrap().1.parse().unwrap()).collect();
        assert!(costs.last().copied() == row["length"].parse().ok(), "{row:?}");
        assert_eq!(costs.len(), row["times"].split(' ').count());
    }
    // What was measured may differ; the rest is kept, and not run again.
    let before = fs::read_to_string(folder.join("rows.csv")).unwrap();
    assert_eq!(carry_out(&folder, &["wcpso-discs"]).status.code(), Some(0));
    assert_eq!(fs::read_to_string(folder.join("rows.csv")).unwrap(), before);
}

#[test]
fn scenes_of_the_user_take_part_and_bad_ones_are_refused() {
    let folder = empty_folder("bench-trees-own");
    let file = folder.join("rooms.json");
    forage(&["generate", "rooms", "--seed", "4", "--out", file.to_str().unwrap()]);
    let output = carry_out(&folder.join("out"), &[file.to_str().unwrap(), "arm-cuboid"]);
    assert_eq!(output.status.code(), Some(0), "{}", text(&output.stderr));
    let mut names: Vec<String> = rows(&folder.join("out")).into_iter().map(|row| row["scene"].clone()).collect();
    names.dedup();
    assert_eq!(names.iter().filter(|name| *name == "arm-cuboid").count(), 3, "{names:?}");
    // Another scene of the same name has rows of its own.
    forage(&["generate", "rooms", "--seed", "5", "--out", file.to_str().unwrap()]);
    let text_of = fs::read_to_string(&file).unwrap();
    let name = rows(&folder.join("out"))[0]["scene"].clone();
    let own: serde_json::Value = serde_json::from_str(&text_of).unwrap();
    fs::write(&file, text_of.replace(own["name"].as_str().unwrap(), &name)).unwrap();
    carry_out(&folder.join("out"), &[file.to_str().unwrap(), "arm-cuboid"]);
    assert_eq!(rows(&folder.join("out")).iter().filter(|row| row["scene"] == name).count(), 2 * 3 * 4);
    let log = fs::read_to_string(folder.join("out/ompl/arm-cuboid.log")).unwrap();
    assert!(log.contains("Experiment arm-cuboid\n") && log.contains("\n3 planners\n") && log.contains("\n4 runs per planner\n"), "{log}");
    for (scenes, named) in [
        (["wcpso-discs", "wcpso-discs"], "a unique name"),
        (["random-52", "random-52"], "a unique name"),
        (["nowhere", "sphere"], "nowhere"),
    ] {
        let output = carry_out(&folder.join("refused"), &scenes);
        assert!(output.status.code() == Some(2) && text(&output.stderr).contains(named), "{}", text(&output.stderr));
    }
    for scenes in [&["sphere"][..], &["sphere", "wcpso-discs"]] {
        let output = carry_out(&folder.join("refused"), scenes);
        let expected = "`scene` is sphere; it must be a scene on which one of the planners runs";
        assert!(text(&output.stderr).contains(expected), "{}", text(&output.stderr));
    }
}
